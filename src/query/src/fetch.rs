//! What deciding several candidates will read, read ahead of it.
//!
//! A lane's row names its section, that its road, that its records: in a map that no cache holds each step waits for memory.
//! Taken step by step for all candidates at once, the waits of a step pass side by side.

use crate::index::LaneSegment;
use mapd_archive::{Range, Tables};
use std::hint::black_box;

/// Candidates that are read ahead together.
pub(crate) const TOGETHER: usize = 8;

/// Reads ahead what it takes to decide whether lanes hold a point; lanes that the map does not have count for nothing.
#[inline]
pub(crate) fn fetch(tables: &Tables<'_>, places: &[LaneSegment]) {
    let mut lanes = [None; TOGETHER];
    for (lane, place) in lanes.iter_mut().zip(places) {
        *lane = tables.lanes.get(place.lane as usize);
    }
    let mut sections = [None; TOGETHER];
    for (section, lane) in sections.iter_mut().zip(lanes).take(places.len()) {
        *section = lane.and_then(|lane| tables.sections.get(lane.section() as usize));
    }
    let mut roads = [None; TOGETHER];
    for (road, section) in roads.iter_mut().zip(sections).take(places.len()) {
        *road = section.and_then(|section| tables.roads.get(section.road() as usize));
    }
    let middle = |range: Range| (range.first.wrapping_add(range.count / 2)) as usize;
    let mut geometries = [None; TOGETHER];
    for (i, place) in places.iter().enumerate().take(TOGETHER) {
        let (Some(road), Some(section), Some(lane)) = (roads[i], sections[i], lanes[i]) else {
            continue;
        };
        geometries[i] = tables.geometries.get(middle(road.geometries()));
        let record = |row: usize| tables.cubics.get(row).map(|record| record.s());
        let segment = usize::from(place.segment);
        black_box((
            tables.points.get(lane.first_byte() as usize + segment),
            tables.point_stations.get(section.first_station() as usize + segment),
            record(lane.first_width() as usize),
            [road.lane_offsets(), road.superelevations(), road.elevations()]
                .map(|range| record(middle(range))),
        ));
    }
    for geometry in geometries.iter().take(places.len()).flatten() {
        black_box(tables.coefficients.get(geometry.coefficients().first as usize));
    }
}
