//! Access restrictions and levels.

use crate::example::Example::{Lane as OfLane, Section as In};
use crate::place::{LaneIn, SectionIn, Side, number, value};
use crate::rule::Check::{Lane, Section};
use crate::rule::Rule;
use crate::sink::Sink;

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:road.lane.access.no_mix_of_deny_or_allow",
        "Access restrictions of one place either all allow or all deny.",
        Lane(no_mix),
        [
            OfLane(
                r#"<access sOffset="0" rule="deny"><restriction type="bus"/></access><access sOffset="0" rule="deny"><restriction type="taxi"/></access>"#,
            ),
            OfLane(
                r#"<access sOffset="0" rule="deny"><restriction type="bus"/></access><access sOffset="0" rule="allow"><restriction type="taxi"/></access>"#,
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.lane.level_true_one_side",
        "Once a lane is kept level, so are all lanes farther out on that side.",
        Section(level),
        [
            In(r#"<center><lane id="0" type="none"/></center><right>
<lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>
<lane id="-2" type="sidewalk" level="true"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#),
            In(r#"<center><lane id="0" type="none"/></center><right>
<lane id="-1" type="sidewalk" level="true"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>
<lane id="-2" type="driving" level="false"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#),
        ],
    ),
];

fn no_mix(of: &LaneIn<'_>, sink: &mut Sink<'_>) {
    for pair in of.lane.access.windows(2) {
        let (a, b) = (value(&pair[0].rule), value(&pair[1].rule));
        if number(&pair[0].s_offset) == number(&pair[1].s_offset)
            && a.is_some()
            && b.is_some()
            && a != b
        {
            sink.add_within("access", pair[1].span, "either allow or deny at one place", "both");
        }
    }
}

fn level(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    for side in [Side::Left, Side::Right] {
        let mut is_level = false;
        for lane in of.outwards(side) {
            let own = value(&lane.level) == Some(true);
            if is_level && !own {
                let id = lane.id.map_or(0, |id| id.value);
                let found = format_args!("lane {id} without it");
                sink.add_within("lane", lane.span, "level lanes outside of a level lane", found);
            }
            is_level |= own;
        }
    }
}
