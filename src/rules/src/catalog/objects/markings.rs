//! Markings of objects.

use super::outlines::all;
use crate::example::Example::Objects as In;
use crate::place::{ObjectIn, value};
use crate::rule::Check::Object;
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr::{self as xodr, Marking, Outline};
use std::collections::HashMap;

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

/// Markings of the object and of its outlines, the latter with the outline's number.
fn every(object: &xodr::Object) -> impl Iterator<Item = (Option<usize>, &Marking)> {
    let within = all(object).enumerate().flat_map(|(number, outline)| {
        let markings = outline.markings.iter().flat_map(|markings| &markings.marking);
        markings.map(move |marking| (Some(number), marking))
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

/// The corners of an object's outlines, by their ids: each of its markings asks for some.
struct Corners<'a> {
    outlines: Vec<&'a Outline>,
    /// Ids of each outline's corners in their order.
    ids: Vec<Vec<u32>>,
    /// By id: outlines that have it, ascending, with the first corner of each that does.
    places: HashMap<u32, Vec<(usize, usize)>>,
}

impl<'a> Corners<'a> {
    /// None where the object has no marking.
    fn of(object: &'a xodr::Object) -> Option<Self> {
        every(object).next()?;
        let outlines: Vec<&Outline> = all(object).collect();
        let ids: Vec<Vec<u32>> = outlines.iter().map(|outline| corners(outline)).collect();
        let mut places: HashMap<u32, Vec<(usize, usize)>> = HashMap::new();
        for (number, ids) in ids.iter().enumerate() {
            for (rank, id) in ids.iter().enumerate() {
                let of_id = places.entry(*id).or_default();
                if of_id.last().is_none_or(|(last, _)| *last < number) {
                    of_id.push((number, rank));
                }
            }
        }
        Some(Self { outlines, ids, places })
    }

    fn of_id(&self, id: u32) -> &[(usize, usize)] {
        self.places.get(&id).map_or(&[], Vec::as_slice)
    }

    /// Place of a corner in an outline.
    fn rank(&self, outline: usize, id: u32) -> Option<usize> {
        let of_id = self.of_id(id);
        let at = of_id.binary_search_by_key(&outline, |(outline, _)| *outline).ok()?;
        of_id.get(at).map(|(_, rank)| *rank)
    }

    fn has_all(&self, outline: usize, named: &[u32]) -> bool {
        named.iter().all(|id| self.rank(outline, *id).is_some())
    }

    /// The first outline that has all of some corners.
    fn find(&self, named: &[u32]) -> Option<usize> {
        let Some(rarest) = named.iter().min_by_key(|id| self.of_id(**id).len()) else {
            return (!self.outlines.is_empty()).then_some(0);
        };
        let mut having = self.of_id(*rarest).iter().map(|(outline, _)| *outline);
        having.find(|outline| self.has_all(*outline, named))
    }
}

fn on_one_outline(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let Some(corners) = Corners::of(of.object) else { return };
    for (within, marking) in every(of.object) {
        let named = references(marking);
        let outline = within.or_else(|| corners.find(&named));
        let is_on_one = match outline {
            Some(outline) => corners.has_all(outline, &named),
            None => corners.outlines.is_empty(),
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

fn in_order(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let Some(corners) = Corners::of(of.object) else { return };
    for (within, marking) in every(of.object) {
        let named = references(marking);
        let Some(outline) = within.or_else(|| corners.find(&named)) else { continue };
        let ranks: Vec<usize> = named.iter().filter_map(|id| corners.rank(outline, *id)).collect();
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
    let Some(corners) = Corners::of(of.object) else { return };
    for (within, marking) in every(of.object) {
        let named = references(marking);
        let Some(outline) = within.or_else(|| corners.find(&named)) else { continue };
        let is_closed =
            corners.outlines.get(outline).is_some_and(|of| value(&of.closed) != Some(false));
        let is_named = |ids: &Vec<u32>| ids.len() > 2 && named == *ids;
        if is_closed && corners.ids.get(outline).is_some_and(is_named) {
            sink.add_within(
                PART,
                marking.span,
                "the first corner again at the end",
                "all corners but that",
            );
        }
    }
}
