//! Tells of blocks of lanes which sections and roads their rows lead to.

use mapd_archive::packed_index::LANES_PER_BLOCK;
use mapd_archive::{LaneBlockRow, LaneRow, Rows};

/// Fills `lane_blocks`.
pub(crate) fn build(rows: &mut Rows) {
    let road = |lane: &LaneRow| rows.sections.get(lane.section as usize).map_or(0, |row| row.road);
    let block = |lanes: &[LaneRow]| {
        let first = lanes.first();
        let mut block = LaneBlockRow {
            section_starts: 0,
            road_starts: 0,
            section: first.map_or(0, |lane| lane.section),
            road: first.map_or(0, road),
        };
        for (i, (before, lane)) in lanes.iter().zip(lanes.iter().skip(1)).enumerate() {
            block.section_starts |= u64::from(lane.section != before.section) << (i + 1);
            block.road_starts |= u64::from(road(lane) != road(before)) << (i + 1);
        }
        block
    };
    rows.lane_blocks =
        rows.lanes.chunks(LANES_PER_BLOCK as usize).map(block).collect::<Vec<_>>().into();
}
