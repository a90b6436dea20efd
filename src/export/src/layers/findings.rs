//! Parts of the document that are not in the map as written.

use super::{Column, Kind, Shape, Sink};
use crate::Result;
use mapd_client::Map;
use mapd_client::Region;
use mapd_client::document::SourcePosition;
use mapd_client::glam::DVec3;

pub(super) const COLUMNS: &[Column] = &[
    ("part", Kind::Text),
    ("id", Kind::Text),
    ("owner", Kind::Text),
    ("owner_part", Kind::Text),
    ("rule", Kind::Text),
    ("message", Kind::Text),
    ("file", Kind::Text),
    ("line", Kind::Whole),
    ("column", Kind::Whole),
    ("is_reference_line", Kind::Flag),
];

/// A box around each part, at the map's lowest height; nowhere where its place is not known.
pub(super) fn findings(map: Map<'_>, sink: &mut Sink<'_>) -> Result<()> {
    let lowest = map.bounds().low;
    for part in map.quarantined() {
        let SourcePosition { line, column } = part.source_position();
        let values = [
            part.kind().name().into(),
            part.id().into(),
            part.owner().into(),
            part.owner_kind().name().into(),
            part.rule().into(),
            part.message().into(),
            part.source_file().into(),
            line.into(),
            column.into(),
            part.is_reference_line().into(),
        ];
        let shape = part.extent().map_or(Shape::Nowhere, |Region { low, high }| {
            let corners = [(low.x, low.y), (high.x, low.y), (high.x, high.y), (low.x, high.y)];
            Shape::Polygon(corners.map(|(x, y)| DVec3::new(x, y, lowest.z)).to_vec())
        });
        sink(shape, &values)?;
    }
    Ok(())
}
