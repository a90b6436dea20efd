//! Records along s ascend.

use crate::example::Example;
use crate::order::sorted_line;
use crate::place::number;
use crate::rule::Check::{self, Order, Records};
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_xodr::{Attribute, Coefficients, LaneSection, Road, RoadMark, Severity, Span};

/// A fall that comes from rounding in the file, where order decides what a part is.
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

/// A rule on records that are sorted where they break it.
const fn rule(
    id: &'static str,
    meaning: &'static str,
    check: Check,
    examples: [Example; 2],
) -> Rule {
    Rule::warning(id, meaning, check, examples)
}

pub(super) static RULES: &[Rule] = &[
    Rule::error(
        "asam.net:xodr:1.4.0:road.geometry.elem_asc_order",
        [
            "Geometries are in the order of s.",
            "unless they are one line when sorted (warning), it is unclear which one each continues",
        ],
        Order(geometries),
        [
            Example::PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry>
<geometry s="50" x="50" y="0" hdg="0" length="50"><arc curvature="0.01"/></geometry>"#,
            ),
            Example::PlanView(
                r#"<geometry s="50" x="60" y="0" hdg="0" length="50"><arc curvature="0.01"/></geometry>
<geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry>"#,
            ),
        ],
    )
    .within(&[ROUNDING]),
    rule(
        "asam.net:xodr:1.4.0:road.elevation.elem_asc_order",
        "Elevations are in the order of s.",
        Records(elevations),
        records!(
            "<elevationProfile>",
            "elevation",
            r#"a="1" b="0" c="0" d="0"/>"#,
            "</elevationProfile>"
        ),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.superelevation.elem_asc_order",
        "Superelevations are in the order of s.",
        Records(superelevations),
        records!(
            "<lateralProfile>",
            "superelevation",
            r#"a="0.05" b="0" c="0" d="0"/>"#,
            "</lateralProfile>"
        ),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.type.elem_asc_order",
        "Types of a road are in the order of s.",
        Records(types),
        records!("", "type", r#"type="town"/>"#, ""),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lanes.lane_offset.elem_asc_order",
        "Lane offsets are in the order of s.",
        Records(lane_offsets),
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
        "Shapes are in the order of s; those with the same s are in the order of t.",
        Records(shapes),
        [
            Example::Road(
                r#"<lateralProfile><shape s="0" t="-5" a="0" b="0.01" c="0" d="0"/><shape s="0" t="0" a="0" b="0.02" c="0" d="0"/></lateralProfile>"#,
            ),
            Example::Road(
                r#"<lateralProfile><shape s="0" t="0" a="0" b="0.02" c="0" d="0"/><shape s="0" t="-5" a="0" b="0.01" c="0" d="0"/></lateralProfile>"#,
            ),
        ],
    ),
    Rule::error(
        "asam.net:xodr:1.4.0:road.lane_section.elem_asc_order",
        [
            "Lane sections are in the order of s.",
            "lane keys and links between sections depend on the order of sections",
        ],
        Order(sections),
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
    )
    .within(&[ROUNDING]),
    rule(
        "asam.net:xodr:1.4.0:road.lane.width.elem_asc_order",
        "Widths of a lane are in the order of sOffset.",
        Records(widths),
        lane_records!("width", r#"a="3" b="0" c="0" d="0"/>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.border.elem_asc_order",
        "Borders of a lane are in the order of sOffset.",
        Records(borders),
        lane_records!("border", r#"a="-3" b="0" c="0" d="0"/>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.height.elem_asc_order",
        "Heights of a lane are in the order of sOffset.",
        Records(heights),
        lane_records!("height", r#"inner="0" outer="0.1"/>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.material.elem_asc_order",
        "Materials of a lane are in the order of sOffset.",
        Records(materials),
        lane_records!("material", r#"friction="0.8"/>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.speed.elem_asc_order",
        "Speed limits of a lane are in the order of sOffset.",
        Records(speeds),
        lane_records!("speed", r#"max="50" unit="km/h"/>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.access.elem_asc_order",
        "Access restrictions of a lane are in the order of sOffset.",
        Records(accesses),
        lane_records!("access", r#"rule="deny"><restriction type="bus"/></access>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.rule.elem_asc_order",
        "Traffic rules of a lane are in the order of sOffset.",
        Records(rules),
        lane_records!("rule", r#"value="no stopping at any time"/>"#),
    ),
    rule(
        "asam.net:xodr:1.4.0:road.lane.road_mark.elem_asc_order",
        "Road marks of a lane are in the order of sOffset.",
        Records(road_marks),
        lane_records!("roadMark", r#"type="solid" color="white"/>"#),
    ),
    rule(
        "mapd:xodr:1.4.0:record.elem_asc_order",
        "Crossfalls, coefficients of a cross-section surface, visibilities of a lane and the sway of a road mark are in the order of s.",
        Records(others),
        [
            Example::Lane(
                r#"<roadMark sOffset="0" type="solid" color="white"><sway ds="0" a="0" b="0" c="0" d="0"/><sway ds="9" a="0.1" b="0" c="0" d="0"/></roadMark>"#,
            ),
            Example::Lane(
                r#"<roadMark sOffset="0" type="solid" color="white"><sway ds="9" a="0.1" b="0" c="0" d="0"/><sway ds="0" a="0" b="0" c="0" d="0"/></roadMark>"#,
            ),
        ],
    ),
];

/// Where a record begins, if it says so, and its tag.
type At = (Option<f64>, Span);

/// Shows each record that begins before the one in front of it: how far, where that one begins, and itself.
fn falls(records: impl Iterator<Item = At>, mut show: impl FnMut(f64, f64, (f64, Span))) {
    let mut before = f64::NEG_INFINITY;
    for (s, span) in records {
        // What is missing is told of as such.
        let Some(s) = s else { continue };
        if s < before {
            show(before - s, before, (s, span));
        }
        before = s.max(before);
    }
}

/// Whether a fall from `before` on is no more than rounding, in the file or of the difference itself.
fn is_rounding(fall: f64, before: f64) -> bool {
    fall <= ROUNDING.value + 2.0 * f64::EPSILON * before.abs()
}

/// Each of what is built in file order begins at or behind the one before it.
fn ascend(part: &str, records: impl Iterator<Item = At>, sink: &mut Sink<'_>) {
    falls(records, |fall, before, (s, span)| {
        let severity = if is_rounding(fall, before) { Severity::Warning } else { Severity::Error };
        let expected = format_args!("s of at least {before}, that of the one before");
        sink.add_milder(severity, part, span, expected, s);
    });
}

/// Each record begins at or behind the one before it; where not, they are sorted.
fn sorted(part: impl Fn() -> String, records: impl Iterator<Item = At>, sink: &mut Sink<'_>) {
    falls(records, |_, before, (s, span)| {
        let expected = format_args!("s of at least {before}, that of the one before");
        sink.add_within(&part(), span, expected, format_args!("{s}; sorted"));
    });
}

fn at(s: &Option<Attribute<f64>>, span: Span) -> At {
    (s.map(|s| s.value), span)
}

fn geometries(road: &Road, sink: &mut Sink<'_>) {
    let Some(plan_view) = &road.plan_view else { return };
    let all = || plan_view.geometry.iter().map(|g| at(&g.s, g.span));
    let path = "planView/geometry";
    match sorted_line(plan_view) {
        Some(_) => sink.as_mended(|sink| sorted(|| path.to_owned(), all(), sink)),
        None => ascend(path, all(), sink),
    }
}

fn sections(road: &Road, sink: &mut Sink<'_>) {
    for lanes in &road.lanes {
        ascend("lanes/laneSection", lanes.lane_section.iter().map(|e| at(&e.s, e.span)), sink);
    }
}

fn elevations(road: &Road, sink: &mut Sink<'_>) {
    let all = road.elevation_profile.iter().flat_map(|profile| &profile.elevation);
    sorted(|| "elevationProfile/elevation".to_owned(), all.map(|e| at(&e.s, e.span)), sink);
}

fn superelevations(road: &Road, sink: &mut Sink<'_>) {
    let all = road.lateral_profile.iter().flat_map(|profile| &profile.superelevation);
    sorted(|| "lateralProfile/superelevation".to_owned(), all.map(|e| at(&e.s, e.span)), sink);
}

fn types(road: &Road, sink: &mut Sink<'_>) {
    sorted(|| "type".to_owned(), road.r#type.iter().map(|e| at(&e.s, e.span)), sink);
}

fn lane_offsets(road: &Road, sink: &mut Sink<'_>) {
    for lanes in &road.lanes {
        let all = lanes.lane_offset.iter().map(|e| at(&e.s, e.span));
        sorted(|| "lanes/laneOffset".to_owned(), all, sink);
    }
}

fn shapes(road: &Road, sink: &mut Sink<'_>) {
    let Some(profile) = &road.lateral_profile else { return };
    let part = "lateralProfile/shape";
    sorted(|| part.to_owned(), profile.shape.iter().map(|e| at(&e.s, e.span)), sink);
    for pair in profile.shape.windows(2).filter(|pair| number(&pair[0].s) == number(&pair[1].s)) {
        let (before, t) = (number(&pair[0].t), number(&pair[1].t));
        if t < before {
            let expected = format_args!("t of at least {before}, that of the one before");
            sink.add_within(part, pair[1].span, expected, format_args!("{t}; sorted"));
        }
    }
}

/// Path of a lane's records from its road.
fn lane_path(
    section: &LaneSection,
    side: &str,
    id: Option<Attribute<i32>>,
    record: &str,
) -> String {
    let (s, id) = (number(&section.s), id.map_or(0, |id| id.value));
    format!("lanes/laneSection[@s={s}]/{side}/lane[@id={id}]/{record}")
}

/// Shows one list of records of each lane, center lanes among them.
macro_rules! each_lane {
    ($road:expr, $field:ident, $record:literal, $show:expr) => {
        for section in $road.lanes.iter().flat_map(|lanes| &lanes.lane_section) {
            for (side, lanes) in [("left", &section.left), ("right", &section.right)] {
                for lane in lanes.iter().flat_map(|side| &side.lane) {
                    $show(&|| lane_path(section, side, lane.id, $record), &lane.$field[..]);
                }
            }
            for lane in section.center.iter().flat_map(|center| &center.lane) {
                $show(&|| lane_path(section, "center", lane.id, $record), &lane.$field[..]);
            }
        }
    };
}

/// A function that looks at one list of the records of all lanes.
macro_rules! of_lanes {
    ($($function:ident: $field:ident of $type:ident, $record:literal;)*) => {$(
        fn $function(road: &Road, sink: &mut Sink<'_>) {
            let mut show = |path: &dyn Fn() -> String, records: &[mapd_xodr::$type]| {
                sorted(path, records.iter().map(|e| at(&e.s_offset, e.span)), sink);
            };
            each_lane!(road, $field, $record, show);
        }
    )*};
}

of_lanes! {
    widths: width of LaneWidth, "width";
    borders: border of LaneBorder, "border";
    heights: height of LaneHeight, "height";
    materials: material of LaneMaterial, "material";
    speeds: speed of LaneSpeed, "speed";
    accesses: access of LaneAccess, "access";
    rules: rule of LaneRule, "rule";
    road_marks: road_mark of RoadMark, "roadMark";
}

/// Records that ASAM has no rule for.
fn others(road: &Road, sink: &mut Sink<'_>) {
    if let Some(profile) = &road.lateral_profile {
        let all = profile.crossfall.iter().map(|e| at(&e.s, e.span));
        sorted(|| "lateralProfile/crossfall".to_owned(), all, sink);
        let surface = profile.cross_section_surface.as_deref();
        let path = || "lateralProfile/crossSectionSurface".to_owned();
        let mut over_s = |records: Option<&[Coefficients]>| {
            let records = records.into_iter().flatten();
            sorted(path, records.map(|e| at(&e.s, e.span)), sink);
        };
        let offset = surface.and_then(|surface| surface.t_offset.as_deref());
        over_s(offset.map(|of| &of.coefficients[..]));
        let strips = surface.and_then(|surface| surface.surface_strips.as_deref());
        for strip in strips.iter().flat_map(|strips| &strips.strip) {
            over_s(strip.width.as_deref().map(|of| &of.coefficients[..]));
            over_s(strip.constant.as_deref().map(|of| &of.coefficients[..]));
            over_s(strip.linear.as_deref().map(|of| &of.coefficients[..]));
            over_s(strip.quadratic.as_deref().map(|of| &of.coefficients[..]));
            over_s(strip.cubic.as_deref().map(|of| &of.coefficients[..]));
        }
    }
    let mut sways = |path: &dyn Fn() -> String, marks: &[RoadMark]| {
        for mark in marks {
            sorted(path, mark.sway.iter().map(|e| at(&e.ds, e.span)), sink);
        }
    };
    each_lane!(road, road_mark, "roadMark/sway", sways);
    for section in road.lanes.iter().flat_map(|lanes| &lanes.lane_section) {
        for (side, lanes) in [("left", &section.left), ("right", &section.right)] {
            for lane in lanes.iter().flat_map(|side| &side.lane) {
                let path = || lane_path(section, side, lane.id, "visibility");
                sorted(path, lane.visibility.iter().map(|e| at(&e.s_offset, e.span)), sink);
            }
        }
    }
}
