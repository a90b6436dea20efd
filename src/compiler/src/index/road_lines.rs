//! Tells where each road's geometries lie, apart from the roads' rows.

use mapd_archive::{RoadLineRow, RoadRow, Rows};

/// Fills `road_lines`.
pub(crate) fn build(rows: &mut Rows) {
    let line = |road: &RoadRow| RoadLineRow { geometries: road.geometries };
    rows.road_lines = rows.roads.iter().map(line).collect::<Vec<_>>().into();
}
