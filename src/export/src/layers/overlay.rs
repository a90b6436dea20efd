//! What is laid over a live map now.

use super::{Column, Kind, Shape, Sink, named};
use crate::Result;
use crate::overlay::area;
use mapd_client::view::View;

pub(super) const COLUMNS: &[Column] = &[
    ("key", Kind::Text),
    ("road", Kind::Text),
    ("section", Kind::Whole),
    ("lane", Kind::Whole),
    ("s_from_m", Kind::Number),
    ("s_to_m", Kind::Number),
    ("entry", Kind::Text),
    ("kind", Kind::Text),
    ("limit_m_s", Kind::Number),
    ("source", Kind::Text),
    ("text", Kind::Text),
    ("confidence", Kind::Number),
];

/// One polygon for each stretch of a lane and each entry that holds on it.
pub(super) fn stretches(view: View<'_>, sink: &mut Sink<'_>) -> Result<()> {
    for one in view.restrictions() {
        let lane = view.map().lane(one.lane)?;
        let [key, road, section, number] = named(&lane);
        let values = [
            key,
            road,
            section,
            number,
            one.s_from.into(),
            one.s_to.into(),
            one.entry.id().into(),
            one.entry.kind().name().into(),
            one.entry.value().into(),
            one.entry.source().into(),
            one.entry.text().into(),
            one.entry.confidence().into(),
        ];
        sink(area(view.map(), &one).map_or(Shape::Nowhere, Shape::polygon), &values)?;
    }
    Ok(())
}
