//! Records along s ascend.

use crate::example::Example;
use crate::place::{LaneIn, RoadIn, number};
use crate::rule::Check::{self, Lane, Road};
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_xodr::{Attribute, Severity, Span};

/// A fall that comes from rounding in the file.
const ROUNDING: Tolerance =
    Tolerance { name: "fall that counts as rounding", value: 1e-6, unit: "m" };

/// The example of a road with two records of an element.
macro_rules! records {
    ($before:literal, $element:literal, $rest:literal, $after:literal) => {
        [
            Example::Road(concat!(
                $before,
                "<",
                $element,
                r#" s="0" "#,
                $rest,
                "<",
                $element,
                r#" s="50" "#,
                $rest,
                $after
            )),
            Example::Road(concat!(
                $before,
                "<",
                $element,
                r#" s="50" "#,
                $rest,
                "<",
                $element,
                r#" s="0" "#,
                $rest,
                $after
            )),
        ]
    };
}

/// The example of a lane with two records of an element.
macro_rules! lane_records {
    ($element:literal, $rest:literal) => {
        [
            Example::Lane(concat!(
                "<",
                $element,
                r#" sOffset="0" "#,
                $rest,
                "<",
                $element,
                r#" sOffset="50" "#,
                $rest
            )),
            Example::Lane(concat!(
                "<",
                $element,
                r#" sOffset="50" "#,
                $rest,
                "<",
                $element,
                r#" sOffset="0" "#,
                $rest
            )),
        ]
    };
}

const fn rule(
    id: &'static str,
    meaning: &'static str,
    check: Check,
    examples: [Example; 2],
) -> Rule {
    Rule::error(id, meaning, check, examples).within(&[ROUNDING])
}

pub(super) static RULES: &[Rule] = &[
    rule(
        "asam.net:xodr:1.4.0:road.geometry.elem_asc_order",
        "Geometries stand in the order of s.",
        Road(geometries),
        [
            Example::PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry>
<geometry s="50" x="50" y="0" hdg="0" length="50"><arc curvature="0.01"/></geometry>"#,
            ),
            Example::PlanView(
                r#"<geometry s="50" x="50" y="0" hdg="0" length="50"><arc curvature="0.01"/></geometry>
<geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry>"#,
            ),
        ],
    ),
    rule(
        "asam.net:xodr:1.4.0:road.elevation.elem_asc_order",
        "Elevations stand in the order of s.",
        Road(elevations),
        records!(
            "<elevationProfile>",
            "elevation",
            r#"a="1" b="0.01" c="0" d="0"/>"#,
            "</elevationProfile>"
        ),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.superelevation.elem_asc_order",
        "Superelevations stand in the order of s.",
        Road(superelevations),
        records!(
            "<lateralProfile>",
            "superelevation",
            r#"a="0" b="0.001" c="0" d="0"/>"#,
            "</lateralProfile>"
        ),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.type.elem_asc_order",
        "Types of a road stand in the order of s.",
        Road(types),
        records!("", "type", r#"type="town"/>"#, ""),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lanes.lane_offset.elem_asc_order",
        "Lane offsets stand in the order of s.",
        Road(lane_offsets),
        [
            Example::Lanes(
                r#"<laneOffset s="0" a="0" b="0.01" c="0" d="0"/><laneOffset s="50" a="0.5" b="0" c="0" d="0"/>
<laneSection s="0"><center><lane id="0" type="none"/></center></laneSection>"#,
            ),
            Example::Lanes(
                r#"<laneOffset s="50" a="0.5" b="0" c="0" d="0"/><laneOffset s="0" a="0" b="0.01" c="0" d="0"/>
<laneSection s="0"><center><lane id="0" type="none"/></center></laneSection>"#,
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.shape.elem_asc_order",
        "Shapes stand in the order of s, and where s is the same in the order of t.",
        Road(shapes),
        [
            Example::Road(
                r#"<lateralProfile><shape s="0" t="-5" a="0" b="0.01" c="0" d="0"/><shape s="0" t="0" a="0" b="0.02" c="0" d="0"/></lateralProfile>"#,
            ),
            Example::Road(
                r#"<lateralProfile><shape s="0" t="0" a="0" b="0.02" c="0" d="0"/><shape s="0" t="-5" a="0" b="0.01" c="0" d="0"/></lateralProfile>"#,
            ),
        ],
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane_section.elem_asc_order",
        "Lane sections stand in the order of s.",
        Road(sections),
        [
            Example::Lanes(
                r#"<laneSection s="0"><center><lane id="0" type="none"/></center></laneSection>
<laneSection s="50"><center><lane id="0" type="none"/></center></laneSection>"#,
            ),
            Example::Lanes(
                r#"<laneSection s="50"><center><lane id="0" type="none"/></center></laneSection>
<laneSection s="0"><center><lane id="0" type="none"/></center></laneSection>"#,
            ),
        ],
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.width.elem_asc_order",
        "Widths of a lane stand in the order of sOffset.",
        Lane(widths),
        lane_records!("width", r#"a="3" b="0" c="0" d="0"/>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.border.elem_asc_order",
        "Borders of a lane stand in the order of sOffset.",
        Lane(borders),
        lane_records!("border", r#"a="-3" b="0" c="0" d="0"/>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.height.elem_asc_order",
        "Heights of a lane stand in the order of sOffset.",
        Lane(heights),
        lane_records!("height", r#"inner="0" outer="0.1"/>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.material.elem_asc_order",
        "Materials of a lane stand in the order of sOffset.",
        Lane(materials),
        lane_records!("material", r#"friction="0.8"/>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.speed.elem_asc_order",
        "Speed limits of a lane stand in the order of sOffset.",
        Lane(speeds),
        lane_records!("speed", r#"max="50" unit="km/h"/>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.access.elem_asc_order",
        "Access restrictions of a lane stand in the order of sOffset.",
        Lane(accesses),
        lane_records!("access", r#"rule="deny"><restriction type="bus"/></access>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.rule.elem_asc_order",
        "Traffic rules of a lane stand in the order of sOffset.",
        Lane(rules),
        lane_records!("rule", r#"value="no stopping at any time"/>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.road_mark.elem_asc_order",
        "Road marks of a lane stand in the order of sOffset.",
        Lane(road_marks),
        lane_records!("roadMark", r#"type="solid" color="white"/>"#),
    ),
];

/// Each record begins at or behind the one before it.
fn ascend<'a>(
    part: &str,
    records: impl Iterator<Item = (&'a Option<Attribute<f64>>, Span)>,
    sink: &mut Sink<'_>,
) {
    let mut before = f64::NEG_INFINITY;
    for (s, span) in records {
        let s = number(s);
        if s < before {
            let severity =
                if before - s <= ROUNDING.value { Severity::Warning } else { Severity::Error };
            sink.add_milder(
                severity,
                part,
                span,
                format_args!("s of at least {before}, that of the one before"),
                s,
            );
        }
        before = s.max(before);
    }
}

fn geometries(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let all = of.road.plan_view.iter().flat_map(|plan_view| &plan_view.geometry);
    ascend("planView/geometry", all.map(|g| (&g.s, g.span)), sink);
}

fn elevations(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let all = of.road.elevation_profile.iter().flat_map(|profile| &profile.elevation);
    ascend("elevationProfile/elevation", all.map(|e| (&e.s, e.span)), sink);
}

fn superelevations(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let all = of.road.lateral_profile.iter().flat_map(|profile| &profile.superelevation);
    ascend("lateralProfile/superelevation", all.map(|e| (&e.s, e.span)), sink);
}

fn types(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    ascend("type", of.road.r#type.iter().map(|e| (&e.s, e.span)), sink);
}

fn lane_offsets(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for lanes in &of.road.lanes {
        ascend("lanes/laneOffset", lanes.lane_offset.iter().map(|e| (&e.s, e.span)), sink);
    }
}

fn sections(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for lanes in &of.road.lanes {
        ascend("lanes/laneSection", lanes.lane_section.iter().map(|e| (&e.s, e.span)), sink);
    }
}

fn shapes(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let Some(profile) = &of.road.lateral_profile else { return };
    let part = "lateralProfile/shape";
    ascend(part, profile.shape.iter().map(|e| (&e.s, e.span)), sink);
    for pair in profile.shape.windows(2).filter(|pair| number(&pair[0].s) == number(&pair[1].s)) {
        let (before, t) = (number(&pair[0].t), number(&pair[1].t));
        if t < before {
            sink.add_within(
                part,
                pair[1].span,
                format_args!("t of at least {before}, that of the one before"),
                t,
            );
        }
    }
}

/// A function that looks at one list of a lane's records.
macro_rules! of_lane {
    ($($function:ident: $field:ident, $part:literal;)*) => {$(
        fn $function(of: &LaneIn<'_>, sink: &mut Sink<'_>) {
            ascend($part, of.lane.$field.iter().map(|e| (&e.s_offset, e.span)), sink);
        }
    )*};
}

of_lane! {
    widths: width, "width";
    borders: border, "border";
    heights: height, "height";
    materials: material, "material";
    speeds: speed, "speed";
    accesses: access, "access";
    rules: rule, "rule";
    road_marks: road_mark, "roadMark";
}
