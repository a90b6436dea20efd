//! The center lane is a line: it has no width and nothing that needs one.

use crate::example::Example::{self, Section};
use crate::rule::Check::{self, CenterLane};
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr as xodr;

const SOUND: Example = Section(r#"<center><lane id="0" type="none"/></center>"#);

const fn rule(id: &'static str, meaning: &'static str, check: Check, invalid: Example) -> Rule {
    Rule::warning(id, meaning, check, [SOUND, invalid])
}

pub(super) static RULES: &[Rule] = &[
    rule(
        "asam.net:xodr:1.4.0:road.lane.center_lane_no_width",
        "The center lane has no width.",
        CenterLane(width),
        Section(
            r#"<center><lane id="0" type="none"><width sOffset="0" a="1" b="0" c="0" d="0"/></lane></center>"#,
        ),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.access.center_lane_no_acc_rule",
        "The center lane has no access restriction.",
        CenterLane(access),
        Section(
            r#"<center><lane id="0" type="none"><access sOffset="0" rule="deny"><restriction type="bus"/></access></lane></center>"#,
        ),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.height.center_lane_no_height",
        "The center lane has no height.",
        CenterLane(height),
        Section(
            r#"<center><lane id="0" type="none"><height sOffset="0" inner="0" outer="0.1"/></lane></center>"#,
        ),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.material.center_lane_no_material",
        "The center lane has no material.",
        CenterLane(material),
        Section(
            r#"<center><lane id="0" type="none"><material sOffset="0" friction="0.8"/></lane></center>"#,
        ),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.speed.center_lane_no_spd_lmt",
        "The center lane has no speed limit.",
        CenterLane(speed),
        Section(
            r#"<center><lane id="0" type="none"><speed sOffset="0" max="50" unit="km/h"/></lane></center>"#,
        ),
    ),
];

/// A function that looks whether a list is empty.
macro_rules! without {
    ($($function:ident: $field:ident;)*) => {$(
        fn $function(lane: &xodr::CenterLane, sink: &mut Sink<'_>) {
            if let Some(first) = lane.$field.first() {
                let name = stringify!($field);
                sink.add_within(name, first.span, format_args!("no {name} of the center lane"), "one");
            }
        }
    )*};
}

without! {
    width: width;
    access: access;
    height: height;
    material: material;
    speed: speed;
}
