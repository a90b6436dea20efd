//! The draft becomes tables, geometry relative to the local origin.

use super::{joints, origin};
use crate::draft::Draft;
use crate::options::CompileOptions;
use mapd_archive::Rows;

/// The tables so far, geometry moved to the local origin.
pub(crate) fn tables(draft: Draft, options: &CompileOptions) -> Rows {
    let mut rows = draft.rows;
    let (x, y) = origin::choose(&rows.geometries);
    for g in rows.geometries.iter_mut() {
        g.x -= x;
        g.y -= y;
    }
    for grid in rows.elevation_grids.iter_mut() {
        grid.x -= x;
        grid.y -= y;
    }
    let mut map = draft.map.unwrap_or_else(bytemuck::Zeroable::zeroed);
    (map.origin_x, map.origin_y) = (x, y);
    map.index_tolerance = options.index_tolerance;
    map.bound_tolerance = options.bound_tolerance;
    map.road_length = rows.roads.iter().map(|road| road.length).sum();
    rows.map.push(map);
    let strings = draft.strings.into_tables();
    rows.string_bytes = strings.bytes.into();
    rows.string_offsets = strings.offsets.into();
    joints::transitions(&mut rows, &draft.joints);
    rows
}
