//! Corners and curves of outlines.

use super::outlines::all;
use crate::example::Example::Objects as In;
use crate::line::{LocalCurve, local_curve};
use crate::place::{ObjectIn, value};
use crate::rule::Check::Object;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_geometry::{Curve, compile};
use mapd_xodr::{Outline, Span};

/// Gaps between curves that come from rounding in the file.
const GAP: Tolerance = Tolerance { name: "gap", value: 0.01, unit: "m" };
/// Difference of a curve's true length and the written one.
const LENGTH: Tolerance = Tolerance { name: "difference of lengths", value: 1e-3, unit: "m" };

/// An object of 4 by 4 m with one outline.
macro_rules! outline {
    ($corners:literal) => {
        outline!($corners, "")
    };
    ($corners:literal, $borders:literal) => {
        In(concat!(
            r#"<object id="1" type="trafficIsland" s="50" t="0" zOffset="0" orientation="none" length="4" width="4" height="1"><outlines><outline id="0">"#,
            $corners, "</outline></outlines>", $borders, "</object>"
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::info(
        "asam.net:xodr:1.9.0:road.corner_local.first_id_zero",
        "The ids of local corners begin with 0.",
        Object(local_first),
        [
            outline!(r#"<cornerLocal id="0" u="-2" v="-2" z="0" height="1"/><cornerLocal id="1" u="2" v="-2" z="0" height="1"/>"#),
            outline!(r#"<cornerLocal id="1" u="-2" v="-2" z="0" height="1"/><cornerLocal id="2" u="2" v="-2" z="0" height="1"/>"#),
        ],
    )
    .advisory(),
    Rule::info(
        "asam.net:xodr:1.9.0:road.corner_local.sequential_id_values",
        "The ids of local corners count up by one.",
        Object(local_sequence),
        [
            outline!(r#"<cornerLocal id="0" u="-2" v="-2" z="0" height="1"/><cornerLocal id="1" u="2" v="-2" z="0" height="1"/>"#),
            outline!(r#"<cornerLocal id="0" u="-2" v="-2" z="0" height="1"/><cornerLocal id="5" u="2" v="-2" z="0" height="1"/>"#),
        ],
    )
    .advisory(),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.corner_local.mandatory_id_with_markings",
        "Local corners have ids where the outline has markings.",
        Object(local_with_markings),
        [
            outline!(r#"<cornerLocal id="0" u="-2" v="-2" z="0" height="1"/><cornerLocal id="1" u="2" v="-2" z="0" height="1"/><markings><marking color="white" spaceLength="0" lineLength="1" startOffset="0" stopOffset="0"/></markings>"#),
            outline!(r#"<cornerLocal u="-2" v="-2" z="0" height="1"/><cornerLocal u="2" v="-2" z="0" height="1"/><markings><marking color="white" spaceLength="0" lineLength="1" startOffset="0" stopOffset="0"/></markings>"#),
        ],
    )
    .since(9),
    Rule::info(
        "asam.net:xodr:1.9.0:road.corner_road.first_id_zero",
        "The ids of corners along the road begin with 0.",
        Object(road_first),
        [
            outline!(r#"<cornerRoad id="0" s="49" t="-2" dz="0" height="1"/><cornerRoad id="1" s="51" t="-2" dz="0" height="1"/>"#),
            outline!(r#"<cornerRoad id="1" s="49" t="-2" dz="0" height="1"/><cornerRoad id="2" s="51" t="-2" dz="0" height="1"/>"#),
        ],
    )
    .advisory(),
    Rule::info(
        "asam.net:xodr:1.9.0:road.corner_road.sequential_id_values",
        "The ids of corners along the road count up by one.",
        Object(road_sequence),
        [
            outline!(r#"<cornerRoad id="0" s="49" t="-2" dz="0" height="1"/><cornerRoad id="1" s="51" t="-2" dz="0" height="1"/>"#),
            outline!(r#"<cornerRoad id="0" s="49" t="-2" dz="0" height="1"/><cornerRoad id="5" s="51" t="-2" dz="0" height="1"/>"#),
        ],
    )
    .advisory(),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.corner_road.mandatory_id_with_markings",
        "Corners along the road have ids where the outline has markings.",
        Object(road_with_markings),
        [
            outline!(r#"<cornerRoad id="0" s="49" t="-2" dz="0" height="1"/><cornerRoad id="1" s="51" t="-2" dz="0" height="1"/><markings><marking color="white" spaceLength="0" lineLength="1" startOffset="0" stopOffset="0"/></markings>"#),
            outline!(r#"<cornerRoad s="49" t="-2" dz="0" height="1"/><cornerRoad s="51" t="-2" dz="0" height="1"/><markings><marking color="white" spaceLength="0" lineLength="1" startOffset="0" stopOffset="0"/></markings>"#),
        ],
    )
    .since(9),
    Rule::warning(
        "asam.net:xodr:1.x.0:road.corner_local.no_mixing_road_local",
        "All corners of an outline are of one kind.",
        Object(one_kind),
        [
            outline!(r#"<cornerLocal id="0" u="-2" v="-2" z="0" height="1"/><cornerLocal id="1" u="2" v="-2" z="0" height="1"/>"#),
            outline!(r#"<cornerLocal id="0" u="-2" v="-2" z="0" height="1"/><cornerLocal id="1" u="2" v="-2" z="0" height="1"/><cornerRoad id="2" s="49" t="-2" dz="0" height="1"/><cornerRoad id="3" s="51" t="-2" dz="0" height="1"/>"#),
        ],
    )
    .also(&["asam.net:xodr:1.9.0:road.corner_road.corner_road_local_exclusivity"]),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.curve_local.continuous_curve_local",
        "Each curve of an outline begins at the end of the one before it.",
        Object(continuous),
        [
            outline!(r#"<curveLocal id="0" u="-2" v="-2" z="0" height="1" length="4" hdg="0"><line/></curveLocal><curveLocal id="1" u="2" v="-2" z="0" height="1" length="4" hdg="1.5707963"><line/></curveLocal>"#),
            outline!(r#"<curveLocal id="0" u="-2" v="-2" z="0" height="1" length="4" hdg="0"><line/></curveLocal><curveLocal id="1" u="1" v="-2" z="0" height="1" length="4" hdg="1.5707963"><line/></curveLocal>"#),
        ],
    )
    .within(&[GAP]),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.curve_local.length_match",
        "A curve of an outline has its stated length.",
        Object(length_match),
        [
            outline!(r#"<curveLocal id="0" u="-2" v="-2" z="0" height="1" length="4" hdg="0"><paramPoly3 aU="0" bU="4" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="normalized"/></curveLocal>"#),
            outline!(r#"<curveLocal id="0" u="-2" v="-2" z="0" height="1" length="4" hdg="0"><paramPoly3 aU="0" bU="3" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="normalized"/></curveLocal>"#),
        ],
    )
    .within(&[LENGTH]),
];

type Corners = Vec<(Option<u32>, Span)>;

fn local(outline: &Outline) -> Corners {
    outline.corner_local.iter().map(|corner| (value(&corner.id), corner.span)).collect()
}

fn along_road(outline: &Outline) -> Corners {
    outline.corner_road.iter().map(|corner| (value(&corner.id), corner.span)).collect()
}

fn first_zero(of: &ObjectIn<'_>, corners: fn(&Outline) -> Corners, sink: &mut Sink<'_>) {
    for outline in all(of.object) {
        if let Some(&(Some(id), span)) = corners(outline).first()
            && id != 0
        {
            sink.add_within("outlines/outline", span, "a first corner with the id 0", id);
        }
    }
}

fn sequence(of: &ObjectIn<'_>, corners: fn(&Outline) -> Corners, sink: &mut Sink<'_>) {
    for outline in all(of.object) {
        for pair in corners(outline).windows(2) {
            if let ((Some(before), _), (Some(id), span)) = (pair[0], pair[1])
                && Some(id) != before.checked_add(1)
            {
                let expected = format_args!("an id one above {before}");
                sink.add_within("outlines/outline", span, expected, id);
                break;
            }
        }
    }
}

fn with_markings(of: &ObjectIn<'_>, corners: fn(&Outline) -> Corners, sink: &mut Sink<'_>) {
    for outline in all(of.object).filter(|outline| outline.markings.is_some()) {
        if let Some((_, span)) = corners(outline).into_iter().find(|(id, _)| id.is_none()) {
            sink.add_within("outlines/outline", span, "ids of corners beside markings", "none");
        }
    }
}

fn local_first(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    first_zero(of, local, sink);
}

fn local_sequence(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    sequence(of, local, sink);
}

fn local_with_markings(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    with_markings(of, local, sink);
}

fn road_first(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    first_zero(of, along_road, sink);
}

fn road_sequence(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    sequence(of, along_road, sink);
}

fn road_with_markings(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    with_markings(of, along_road, sink);
}

fn one_kind(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    for outline in all(of.object) {
        let kinds = [
            !outline.corner_road.is_empty(),
            !outline.corner_local.is_empty(),
            !outline.curve_local.is_empty(),
        ];
        let count = kinds.into_iter().filter(|kind| *kind).count();
        if count > 1 {
            sink.add_within("outlines/outline", outline.span, "corners of one kind", count);
        }
    }
}

/// The curves of an outline that the map is built of, with their tags.
fn curves(outline: &Outline) -> Vec<Option<(LocalCurve, Span)>> {
    let written = outline.curve_local.iter();
    written.map(|curve| Some((local_curve(curve)?, curve.span))).collect()
}

fn continuous(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    for outline in all(of.object) {
        for pair in curves(outline).windows(2) {
            let [Some((curve, _)), Some((next, span))] = pair else { continue };
            let LocalCurve { start, length, ref primitive } = *curve;
            let Ok(compiled) = compile(primitive, length) else { continue };
            let Some(shape) = Curve::new(compiled.kind, start, length, &compiled.coefficients)
            else {
                continue;
            };
            let end = shape.evaluate(length);
            let gap = mapd_geometry::hypot(next.start.x - end.x, next.start.y - end.y);
            if gap > GAP.value {
                let found = format_args!("one {gap:.3} m away");
                sink.add_within(
                    "outlines/outline/curveLocal",
                    *span,
                    "a start where the curve before ends",
                    found,
                );
            }
        }
    }
}

fn length_match(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    for (curve, span) in all(of.object).flat_map(curves).flatten() {
        let Ok(compiled) = compile(&curve.primitive, curve.length) else { continue };
        let longer = compiled.length_mismatch;
        if longer.abs() > LENGTH.value {
            let expected = format_args!("a curve of the length {} m", curve.length);
            let found = format_args!("one that is {longer:.4} m longer");
            sink.add_within("outlines/outline/curveLocal", span, expected, found);
        }
    }
}
