//! What a query of lanes will read, brought into the processor's caches ahead of it.
//!
//! A lane's row names its section, that its road, that its records: in a map that no cache holds each step waits for memory.
//! What is known without the step before, and what several candidates need, is waited for side by side.

use crate::begun::TOGETHER;
use crate::index::LaneSegment;
use crate::lane::Lane;
use mapd_archive::packed_index::LANES_PER_BLOCK;
use mapd_archive::{Range, Tables, prefetch};

/// Points of a lane's centre line that are its section's ends: nothing else is read of them.
const ENDS: u16 = 2;

/// Brings the rows of a lane that may hold a point, its section and its road; what the map does not have counts for nothing.
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
    tables.lanes.get(lane as usize).into_iter().for_each(prefetch);
    tables.sections.get(section as usize).into_iter().for_each(prefetch);
    tables.roads.get(road as usize).into_iter().for_each(prefetch);
}

/// Brings what the rows of a stretch's lane name. How much that is, is known only when the rows have come: call `rows` for all candidates
/// first.
#[inline(always)]
pub(crate) fn records(tables: &Tables<'_>, stretch: LaneSegment) {
    let Some(lane) = tables.lanes.get(stretch.lane as usize) else { return };
    let Some(section) = tables.sections.get(lane.section() as usize) else { return };
    let Some(road) = tables.roads.get(section.road() as usize) else { return };
    searched(tables.geometries, road.geometries());
    searched(tables.cubics, lane.widths());
    searched(tables.cubics, road.lane_offsets());
    searched(tables.cubics, road.superelevations());
    searched(tables.cubics, road.elevations());
    if lane.center_count() != ENDS {
        let point = usize::from(stretch.segment) * usize::from(section.point_bytes());
        tables.points.get(lane.first_byte() as usize + point).into_iter().for_each(prefetch);
    }
}

/// Brings the rows of a lane that is known and, of each kind of records that they name, where it begins. A query of one lane decides
/// nothing between lanes: it would wait for each of them where it reads it first.
#[inline(always)]
pub(crate) fn known(lane: &Lane<'_>) {
    let (row, section) = (lane.row, lane.section.row);
    let (road, tables) = (lane.road.row, lane.map.tables());
    prefetch(row);
    prefetch(section);
    prefetch(road);
    first(tables.geometries, road.geometries());
    first(tables.cubics, row.widths());
    first(tables.cubics, road.lane_offsets());
}

/// Brings the heights along a lane's road, which only some queries read.
#[inline(always)]
pub(crate) fn heights(lane: &Lane<'_>) {
    searched(lane.map.tables().cubics, lane.road.row.elevations());
}

/// Brings the first of some rows.
#[inline(always)]
fn first<T>(table: &[T], rows: Range) {
    table.get(rows.first as usize).into_iter().for_each(prefetch);
}

/// Brings what a search among rows reads: all of few rows, which [`begun`](crate::begun::begun) compares side by side, of more the one where it begins.
#[inline(always)]
fn searched<T>(table: &[T], rows: Range) {
    if rows.count as usize <= TOGETHER {
        prefetch(rows.of(table));
    } else {
        let middle = rows.first.wrapping_add(rows.count / 2);
        table.get(middle as usize).into_iter().for_each(prefetch);
    }
}
