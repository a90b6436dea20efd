//! Builds the packed spatial index over the places of objects.

use super::packed::{Entry, Packed, pack};
use crate::sample::view;
use mapd_archive::Rows;
use mapd_query::Map;
use mapd_query::objects::ObjectPlacement;

/// Added to every box `[m]`: corners lie in single precision.
const MARGIN: f64 = 1e-3;

/// Fills `object_index_levels`, `object_index_nodes` and `object_index_items`.
pub(crate) fn build(rows: &mut Rows) {
    let entries: Vec<Entry> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let origin = map.local_origin();
        let entry = |place: ObjectPlacement<'_>| {
            let bounds = place.bounds();
            Entry {
                low: bounds.low - origin - MARGIN,
                high: bounds.high - origin + MARGIN,
                item: place.item(),
            }
        };
        map.objects().flat_map(|object| object.placements()).map(entry).collect()
    };
    let Packed { levels, nodes, items } = pack(entries);
    rows.object_index_levels = levels.into();
    rows.object_index_nodes = nodes.into();
    rows.object_index_items = items.into();
}
