//! Markings of objects.

use super::outlines::all;
use crate::example::Example::Objects as In;
use crate::place::{ObjectIn, value};
use crate::rule::Check::Object;
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr::{self as xodr, Marking, Outline};
use std::collections::BTreeSet;

/// A parking space of 4 by 4 m with an outline of three corners, where it has one, and a marking.
macro_rules! marked {
    (outline $references:literal) => {
        In(concat!(
            r#"<object id="1" type="parkingSpace" s="50" t="0" zOffset="0" orientation="none" length="4" width="4" height="1"><outlines><outline id="0"><cornerLocal id="0" u="-2" v="-2" z="0" height="1"/><cornerLocal id="1" u="2" v="-2" z="0" height="1"/><cornerLocal id="2" u="2" v="2" z="0" height="1"/></outline></outlines>
<markings><marking color="white" spaceLength="0" lineLength="1" startOffset="0" stopOffset="0">"#,
            $references, "</marking></markings></object>"
        ))
    };
    (within $references:literal) => {
        In(concat!(
            r#"<object id="1" type="parkingSpace" s="50" t="0" zOffset="0" orientation="none" length="4" width="4" height="1"><outlines><outline id="0"><cornerLocal id="0" u="-2" v="-2" z="0" height="1"/><cornerLocal id="1" u="2" v="-2" z="0" height="1"/><cornerLocal id="2" u="2" v="2" z="0" height="1"/>
<markings><marking color="white" spaceLength="0" lineLength="1" startOffset="0" stopOffset="0">"#,
            $references, "</marking></markings></outline></outlines></object>"
        ))
    };
    (box $side:literal, $references:literal) => {
        In(concat!(
            r#"<object id="1" type="parkingSpace" s="50" t="0" zOffset="0" orientation="none" length="4" width="4" height="1"><markings><marking "#,
            $side, r#" color="white" spaceLength="0" lineLength="1" startOffset="0" stopOffset="0">"#,
            $references, "</marking></markings></object>"
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.marking.no_cornerreference_if_no_outline",
        "A marking refers to corners only if the object has an outline.",
        Object(corners_need_outline),
        [
            marked!(box r#"side="left""#, ""),
            marked!(box r#"side="left""#, r#"<cornerReference id="0"/><cornerReference id="1"/>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.marking.no_outline_side_attr",
        "A marking of an object without outline names a side.",
        Object(side),
        [marked!(box r#"side="left""#, ""), marked!(box "", "")],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.marking.outline_corner_reference_count",
        "A marking along an outline refers to at least two corners.",
        Object(corner_count),
        [
            marked!(outline r#"<cornerReference id="0"/><cornerReference id="1"/>"#),
            marked!(outline r#"<cornerReference id="0"/>"#),
        ],
    )
    .also(&["asam.net:xodr:1.8.2:road.object.object_marking.outline_corner_reference_count"]),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.object.marking.complete_or_partial_on_outline",
        "The corners that a marking refers to are corners of one outline.",
        Object(on_one_outline),
        [
            marked!(within r#"<cornerReference id="0"/><cornerReference id="1"/>"#),
            marked!(within r#"<cornerReference id="0"/><cornerReference id="7"/>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.object.marking.markings_with_outline",
        "Where an object has outlines, its markings stand in them.",
        Object(in_outline),
        [
            marked!(within r#"<cornerReference id="0"/><cornerReference id="1"/>"#),
            marked!(outline r#"<cornerReference id="0"/><cornerReference id="1"/>"#),
        ],
    )
    .since(9),
    Rule::warning(
        "asam.net:xodr:1.8.2:road.object.object_marking.keep_id_ordered",
        "A marking refers to corners in the order of the outline.",
        Object(in_order),
        [
            marked!(outline r#"<cornerReference id="0"/><cornerReference id="1"/><cornerReference id="2"/>"#),
            marked!(outline r#"<cornerReference id="0"/><cornerReference id="2"/><cornerReference id="1"/>"#),
        ],
    ),
    Rule::info(
        "asam.net:xodr:1.8.2:road.object.object_marking.enclosed_outline_marking",
        "A marking all around an outline ends at the corner where it begins.",
        Object(enclosed),
        [
            marked!(outline r#"<cornerReference id="0"/><cornerReference id="1"/><cornerReference id="2"/><cornerReference id="0"/>"#),
            marked!(outline r#"<cornerReference id="0"/><cornerReference id="1"/><cornerReference id="2"/>"#),
        ],
    ),
];

const PART: &str = "markings/marking";

/// Markings that stand in the object itself.
fn own(object: &xodr::Object) -> impl Iterator<Item = &Marking> {
    object.markings.iter().flat_map(|markings| &markings.marking)
}

/// Markings of the object and of its outlines, the latter with their outline.
fn every(object: &xodr::Object) -> impl Iterator<Item = (Option<&Outline>, &Marking)> {
    let within = all(object).flat_map(|outline| {
        let markings = outline.markings.iter().flat_map(|markings| &markings.marking);
        markings.map(move |marking| (Some(outline), marking))
    });
    own(object).map(|marking| (None, marking)).chain(within)
}

fn references(marking: &Marking) -> Vec<u32> {
    marking.corner_reference.iter().filter_map(|corner| value(&corner.id)).collect()
}

/// Ids of an outline's corners in their order.
fn corners(outline: &Outline) -> Vec<u32> {
    let local = outline.corner_local.iter().filter_map(|corner| value(&corner.id));
    let road = outline.corner_road.iter().filter_map(|corner| value(&corner.id));
    let curves = outline.curve_local.iter().filter_map(|curve| value(&curve.id));
    local.chain(road).chain(curves).collect()
}

fn corners_need_outline(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    if all(of.object).next().is_some() {
        return;
    }
    for marking in own(of.object).filter(|marking| !marking.corner_reference.is_empty()) {
        sink.add_within(PART, marking.span, "no corners of an object without outline", "some");
    }
}

fn side(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    if all(of.object).next().is_some() {
        return;
    }
    for marking in own(of.object).filter(|marking| marking.side.is_none()) {
        sink.add_within(PART, marking.span, "the side of an object without outline", "none");
    }
}

fn corner_count(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let has_outline = all(of.object).next().is_some();
    for (outline, marking) in every(of.object).filter(|_| has_outline) {
        let count = marking.corner_reference.len();
        // Since 1.9, a marking within an outline and without corners goes all around; one of a side needs none.
        let is_complete = count == 0 && (outline.is_some() || marking.side.is_some());
        if count < 2 && !is_complete {
            sink.add_within(PART, marking.span, "at least two corners", count);
        }
    }
}

fn on_one_outline(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    for (outline, marking) in every(of.object) {
        let named = references(marking);
        let fits = |outline: &Outline| {
            let corners: BTreeSet<u32> = corners(outline).into_iter().collect();
            named.iter().all(|id| corners.contains(id))
        };
        let has_outline = all(of.object).next().is_some();
        let is_on_one = match outline {
            Some(outline) => fits(outline),
            None => !has_outline || all(of.object).any(fits),
        };
        if !is_on_one && !named.is_empty() {
            sink.add_within(
                PART,
                marking.span,
                "corners of one outline",
                format_args!("{named:?}"),
            );
        }
    }
}

fn in_outline(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    if all(of.object).next().is_none() {
        return;
    }
    if let Some(marking) = own(of.object).next() {
        sink.add_within(PART, marking.span, "markings within the outline", "one beside it");
    }
}

/// The outline that a marking runs along.
fn outline_of<'a>(
    object: &'a xodr::Object,
    outline: Option<&'a Outline>,
    named: &[u32],
) -> Option<&'a Outline> {
    outline.or_else(|| {
        all(object).find(|outline| {
            let corners = corners(outline);
            named.iter().all(|id| corners.contains(id))
        })
    })
}

fn in_order(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    for (outline, marking) in every(of.object) {
        let named = references(marking);
        let Some(outline) = outline_of(of.object, outline, &named) else { continue };
        let corners = corners(outline);
        let ranks: Vec<usize> =
            named.iter().filter_map(|id| corners.iter().position(|corner| corner == id)).collect();
        // Going around, ranks fall once.
        let falls = ranks.windows(2).filter(|pair| pair[1] < pair[0]).count();
        if falls > 1 || (falls == 1 && ranks.last() > ranks.first()) {
            sink.add_within(
                PART,
                marking.span,
                "corners in the order of the outline",
                format_args!("{named:?}"),
            );
        }
    }
}

fn enclosed(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    for (outline, marking) in every(of.object) {
        let named = references(marking);
        let Some(outline) = outline_of(of.object, outline, &named) else { continue };
        let corners = corners(outline);
        let is_closed = value(&outline.closed) != Some(false);
        if is_closed && corners.len() > 2 && named == corners {
            sink.add_within(
                PART,
                marking.span,
                "the first corner again at the end",
                "all corners but that",
            );
        }
    }
}
