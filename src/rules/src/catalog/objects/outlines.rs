//! Outlines of objects.

use crate::example::Example::Objects as In;
use crate::place::{ObjectIn, number, value};
use crate::rule::Check::Object;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_xodr::{self as xodr, Outline};
use std::collections::BTreeSet;

/// How far outlines may reach beyond the box.
const BEYOND: Tolerance = Tolerance { name: "reach beyond the box", value: 0.01, unit: "m" };
/// Points of outlines that are nearer than this are meant to be one.
const TOUCH: Tolerance =
    Tolerance { name: "distance of points that touch", value: 0.01, unit: "m" };
/// Pairs of points of one object's outlines that are compared at most.
const PAIRS: usize = 1_000_000;

/// An object of 4 by 4 m with outlines.
macro_rules! outlines {
    ($outlines:literal) => {
        In(concat!(
            r#"<object id="1" type="trafficIsland" s="50" t="0" zOffset="0" orientation="none" length="4" width="4" height="1">"#,
            $outlines, "</object>"
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.9.0:road.object.borders.different_outlineids",
        "The outlines of an object have different ids.",
        Object(ids),
        [
            outlines!(r#"<outlines><outline id="0" outer="true"><cornerLocal u="-2" v="-2" z="0" height="1"/><cornerLocal u="2" v="-2" z="0" height="1"/></outline><outline id="1" outer="false"><cornerLocal u="-1" v="-1" z="0" height="1"/><cornerLocal u="1" v="-1" z="0" height="1"/></outline></outlines>"#),
            outlines!(r#"<outlines><outline id="0" outer="true"><cornerLocal u="-2" v="-2" z="0" height="1"/><cornerLocal u="2" v="-2" z="0" height="1"/></outline><outline id="0" outer="false"><cornerLocal u="-1" v="-1" z="0" height="1"/><cornerLocal u="1" v="-1" z="0" height="1"/></outline></outlines>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.object.outline.exactly_one_outer",
        "One of an object's outlines is the outer one.",
        Object(one_outer),
        [
            outlines!(r#"<outlines><outline id="0" outer="true"><cornerLocal u="-2" v="-2" z="0" height="1"/><cornerLocal u="2" v="-2" z="0" height="1"/></outline></outlines>"#),
            outlines!(r#"<outlines><outline id="0" outer="false"><cornerLocal u="-2" v="-2" z="0" height="1"/><cornerLocal u="2" v="-2" z="0" height="1"/></outline></outlines>"#),
        ],
    )
    .since(9),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.outline.outline_followed_by_corner",
        "An outline has at least two corners, or a curve.",
        Object(has_corners),
        [
            outlines!(r#"<outlines><outline id="0"><cornerLocal u="-2" v="-2" z="0" height="1"/><cornerLocal u="2" v="-2" z="0" height="1"/></outline></outlines>"#),
            outlines!(r#"<outlines><outline id="0"><cornerLocal u="-2" v="-2" z="0" height="1"/></outline></outlines>"#),
        ],
    )
    .also(&[
        "asam.net:xodr:1.7.0:road.corner_local.element_min_amount",
        "asam.net:xodr:1.7.0:road.corner_road.element_min_amount",
        "asam.net:xodr:1.9.0:road.curve_local.element_min_amount",
    ]),
    Rule::info(
        "asam.net:xodr:1.7.0:road.object.outline.points_inside_box",
        "The corners of an outline are inside the object's box.",
        Object(inside_box),
        [
            outlines!(r#"<outlines><outline id="0"><cornerLocal u="-2" v="-2" z="0" height="1"/><cornerLocal u="2" v="-2" z="0" height="1"/></outline></outlines>"#),
            outlines!(r#"<outlines><outline id="0"><cornerLocal u="-3" v="-2" z="0" height="1"/><cornerLocal u="2" v="-2" z="0" height="1"/></outline></outlines>"#),
        ],
    )
    .within(&[BEYOND]),
    Rule::info(
        "asam.net:xodr:1.9.0:road.object.outline.inner_outline_touches_outer",
        "Outlines that touch share exactly the same point.",
        Object(touching),
        [
            outlines!(r#"<outlines><outline id="0" outer="true"><cornerLocal u="-2" v="-2" z="0" height="1"/><cornerLocal u="2" v="-2" z="0" height="1"/></outline><outline id="1" outer="false"><cornerLocal u="-2" v="-2" z="0" height="1"/><cornerLocal u="1" v="-1" z="0" height="1"/></outline></outlines>"#),
            outlines!(r#"<outlines><outline id="0" outer="true"><cornerLocal u="-2" v="-2" z="0" height="1"/><cornerLocal u="2" v="-2" z="0" height="1"/></outline><outline id="1" outer="false"><cornerLocal u="-1.999" v="-2" z="0" height="1"/><cornerLocal u="1" v="-1" z="0" height="1"/></outline></outlines>"#),
        ],
    )
    .within(&[TOUCH]),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.borders.useCompleteOutline_true",
        "A border that uses the complete outline has no references to corners.",
        Object(complete),
        [
            outlines!(r#"<outlines><outline id="0"><cornerLocal id="0" u="-2" v="-2" z="0" height="1"/><cornerLocal id="1" u="2" v="-2" z="0" height="1"/></outline></outlines><borders><border outlineId="0" width="0.1" type="concrete" useCompleteOutline="true"/></borders>"#),
            outlines!(r#"<outlines><outline id="0"><cornerLocal id="0" u="-2" v="-2" z="0" height="1"/><cornerLocal id="1" u="2" v="-2" z="0" height="1"/></outline></outlines><borders><border outlineId="0" width="0.1" type="concrete" useCompleteOutline="true"><cornerReference id="0"/><cornerReference id="1"/></border></borders>"#),
        ],
    ),
    Rule::warning(
        "mapd:xodr:1.5.0:ref.border_outline",
        "A border refers to one of the object's outlines.",
        Object(border_outline),
        [
            outlines!(r#"<outlines><outline id="0"><cornerLocal id="0" u="-2" v="-2" z="0" height="1"/><cornerLocal id="1" u="2" v="-2" z="0" height="1"/></outline></outlines><borders><border outlineId="0" width="0.1" type="concrete" useCompleteOutline="true"/></borders>"#),
            outlines!(r#"<outlines><outline id="0"><cornerLocal id="0" u="-2" v="-2" z="0" height="1"/><cornerLocal id="1" u="2" v="-2" z="0" height="1"/></outline></outlines><borders><border outlineId="7" width="0.1" type="concrete" useCompleteOutline="true"/></borders>"#),
        ],
    ),
];

/// Outlines of an object, in a list or (until 1.4) directly in it.
pub(super) fn all(object: &xodr::Object) -> impl Iterator<Item = &Outline> {
    let listed = object.outlines.iter().flat_map(|outlines| &outlines.outline);
    listed.chain(object.outline.as_deref())
}

fn ids(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let mut ids = BTreeSet::new();
    for outline in all(of.object) {
        if let Some(id) = value(&outline.id).filter(|id| !ids.insert(*id)) {
            sink.add_within(
                "outlines/outline",
                outline.span,
                "an id that no other outline has",
                id,
            );
        }
    }
}

fn one_outer(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let Some(outlines) = &of.object.outlines else { return };
    let outer = outlines.outline.iter().filter(|outline| value(&outline.outer) != Some(false));
    let outer = outer.count();
    if outer != 1 && !outlines.outline.is_empty() {
        sink.add_within("outlines", outlines.span, "one outer outline", outer);
    }
}

fn has_corners(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    for outline in all(of.object) {
        let corners = outline.corner_local.len() + outline.corner_road.len();
        if corners < 2 && outline.curve_local.is_empty() {
            let expected = "at least two corners or a curve";
            sink.add_within(
                "outlines/outline",
                outline.span,
                expected,
                format_args!("{corners} corners"),
            );
        }
    }
}

fn inside_box(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let object = of.object;
    let (length, width) = (number(&object.length), number(&object.width));
    if length <= 0.0 || width <= 0.0 {
        return;
    }
    for outline in all(object) {
        for corner in &outline.corner_local {
            let (u, v) = (number(&corner.u), number(&corner.v));
            if u.abs() > length / 2.0 + BEYOND.value || v.abs() > width / 2.0 + BEYOND.value {
                let expected = format_args!("corners within {length} by {width} m");
                sink.add_within(
                    "outlines/outline/cornerLocal",
                    corner.span,
                    expected,
                    format_args!("one at ({u}, {v})"),
                );
                return;
            }
        }
    }
}

fn touching(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let outlines: Vec<&Outline> = all(of.object).collect();
    let mut pairs = 0;
    for (rank, outline) in outlines.iter().enumerate() {
        for corner in &outline.corner_local {
            for other in outlines[..rank].iter().flat_map(|outline| &outline.corner_local) {
                pairs += 1;
                if pairs > PAIRS {
                    return;
                }
                let place = |c: &xodr::CornerLocal| [number(&c.u), number(&c.v), number(&c.z)];
                let (a, b) = (place(corner), place(other));
                let apart = mapd_geometry::hypot(
                    mapd_geometry::hypot(a[0] - b[0], a[1] - b[1]),
                    a[2] - b[2],
                );
                if apart > 0.0 && apart < TOUCH.value {
                    let found = format_args!("one {apart:.6} m beside it");
                    sink.add_within(
                        "outlines/outline/cornerLocal",
                        corner.span,
                        "the very point of the other outline",
                        found,
                    );
                }
            }
        }
    }
}

fn complete(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    for border in of.object.borders.iter().flat_map(|borders| &borders.border) {
        if value(&border.use_complete_outline) == Some(true)
            && let Some(corner) = border.corner_reference.first()
        {
            sink.add_within(
                "borders/border",
                corner.span,
                "no corners beside the complete outline",
                "one",
            );
        }
    }
}

fn border_outline(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let ids: BTreeSet<u32> = all(of.object).filter_map(|outline| value(&outline.id)).collect();
    for border in of.object.borders.iter().flat_map(|borders| &borders.border) {
        if let Some(id) = value(&border.outline_id).filter(|id| !ids.contains(id)) {
            sink.add_within(
                "borders/border",
                border.span,
                "the id of one of the object's outlines",
                id,
            );
        }
    }
}
