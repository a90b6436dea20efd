//! Builds the packed spatial index over the places where signals stand.

use super::packed::{Entry, Packed, pack};
use glam::DVec2;
use mapd_archive::Rows;

/// Fills `signal_index_levels`, `signal_index_nodes` and `signal_index_items`.
pub(crate) fn build(rows: &mut Rows) {
    let origin = rows.map.first().map_or(DVec2::ZERO, |map| DVec2::new(map.origin_x, map.origin_y));
    let signals = rows.signals.iter().enumerate().map(|(row, signal)| {
        let at = DVec2::new(signal.x, signal.y) - origin;
        Entry { low: at, high: at, item: row as u32 }
    });
    let Packed { levels, nodes, items } = pack(signals.collect());
    rows.signal_index_levels = levels.into();
    rows.signal_index_nodes = nodes.into();
    rows.signal_index_items = items.into();
}
