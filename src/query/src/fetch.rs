//! What deciding several candidates will read, read ahead of it.
//!
//! A lane's row names its section, that its road, that its records: in a map that no cache holds each step waits for memory.
//! What is known without the step before, and what several candidates need, is waited for side by side.

use crate::held::HeldBy;
use mapd_archive::packed_index::LANES_PER_BLOCK;
use mapd_archive::{ArchivedCubicRow, ArchivedGeometryRow, Range, Tables};
use std::hint::black_box;

/// Reads ahead the rows of a lane that may hold a point, its section and its road; what the map does not have counts for nothing.
///
/// The block of the lane tells the latter two without its row, so that all three are waited for side by side. An archive of an earlier
/// release has no blocks: its rows are waited for one after the other.
#[inline(always)]
pub(crate) fn rows(tables: &Tables<'_>, lane: u32) {
    let Some(block) = tables.lane_blocks.get((lane / LANES_PER_BLOCK) as usize) else { return };
    let up_to = (2u64 << (lane % LANES_PER_BLOCK)).wrapping_sub(1);
    let after = |starts: u64| (starts & up_to).count_ones();
    let section = block.section().wrapping_add(after(block.section_starts()));
    let road = block.road().wrapping_add(after(block.road_starts()));
    // The first and the last that is read of each row: they lie across the ends of cache lines.
    black_box((
        tables.lanes.get(lane as usize).map(|row| (row.section(), row.flags())),
        tables.sections.get(section as usize).map(|row| (row.s_start(), row.z_step())),
        tables.roads.get(road as usize).map(|row| (row.length(), row.lane_offsets().count)),
    ));
}

/// Reads ahead what the rows of several candidates name. How much that is, is known only when the rows have come: call `rows` of all candidates
/// first.
#[inline]
pub(crate) fn records(tables: &Tables<'_>, candidates: &[HeldBy]) {
    // Where a search among rows begins; `begun` waits for the others of few rows side by side.
    let middle = |range: Range| range.first.wrapping_add(range.count / 2) as usize;
    for HeldBy { stretch: place, .. } in candidates {
        let Some(lane) = tables.lanes.get(place.lane as usize) else { continue };
        let Some(section) = tables.sections.get(lane.section() as usize) else { continue };
        let Some(road) = tables.roads.get(section.road() as usize) else { continue };
        let segment = usize::from(place.segment);
        let point = segment * usize::from(section.point_bytes());
        let record = |row: usize| tables.cubics.get(row).map(ArchivedCubicRow::s);
        black_box((
            tables.geometries.get(middle(road.geometries())).map(ArchivedGeometryRow::s),
            tables.points.get(lane.first_byte() as usize + point),
            record(lane.first_width() as usize),
            record(middle(road.lane_offsets())),
            record(middle(road.superelevations())),
            record(middle(road.elevations())),
        ));
    }
}
