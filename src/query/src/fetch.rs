//! What deciding several candidates will read, read ahead of it.
//!
//! A lane's row names its section, that its road, that its records: in a map that no cache holds each step waits for memory.
//! Taken step by step for all candidates at once, the waits of a step pass side by side.

use mapd_archive::{Range, Tables};
use std::hint::black_box;

/// Candidates that are read ahead together.
pub(crate) const TOGETHER: usize = 8;

/// Reads ahead what it takes to decide whether lanes hold a point; lanes that the map does not have count for nothing.
#[inline]
pub(crate) fn fetch(tables: &Tables<'_>, places: &[(u32, u16)]) {
    let mut lanes = [None; TOGETHER];
    for (lane, (row, _)) in lanes.iter_mut().zip(places) {
        *lane = tables.lanes.get(*row as usize);
    }
    let mut sections = [None; TOGETHER];
    for (section, lane) in sections.iter_mut().zip(lanes).take(places.len()) {
        *section = lane.and_then(|lane| tables.sections.get(lane.section() as usize));
    }
    let mut roads = [None; TOGETHER];
    for (road, section) in roads.iter_mut().zip(sections).take(places.len()) {
        *road = section.and_then(|section| tables.roads.get(section.road() as usize));
    }
    for ((road, lane), (_, segment)) in roads.iter().zip(lanes).zip(places) {
        let (Some(road), Some(lane)) = (road, lane) else { continue };
        let middle = |range: Range| (range.first.wrapping_add(range.count / 2)) as usize;
        let record = |range: Range| tables.cubics.get(middle(range)).map(|record| record.s());
        black_box((
            tables.points.get(lane.first_byte() as usize + usize::from(*segment)),
            tables.cubics.get(lane.first_width() as usize).map(|record| record.s()),
            tables.geometries.get(middle(road.geometries())).map(|geometry| geometry.s()),
            [road.lane_offsets(), road.superelevations(), road.elevations()].map(record),
        ));
    }
}
