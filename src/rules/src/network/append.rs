//! Puts what was kept of the next elements behind what was kept of those before.

use super::Network;
use std::ops::Range;

/// Moves a range by so many places.
fn shift(range: &mut Range<usize>, by: usize) {
    *range = range.start + by..range.end + by;
}

impl Network {
    /// Takes what was kept of the elements that come next. Neither part is finished.
    pub(crate) fn append(&mut self, next: Self) {
        let [roads, sections, lanes, lane_links, stations] = [
            self.roads.len(),
            self.sections.len(),
            self.lanes.len(),
            self.lane_links.len(),
            self.stations.len(),
        ];
        if next.header.is_some() {
            self.header = next.header;
            self.has_offset = next.has_offset;
        }
        self.roads.extend(next.roads.into_iter().map(|mut road| {
            road.rank += roads;
            shift(&mut road.sections, sections);
            shift(&mut road.stations, stations);
            road
        }));
        self.sections.extend(next.sections.into_iter().map(|mut section| {
            shift(&mut section.lanes, lanes);
            section
        }));
        self.lanes.extend(next.lanes.into_iter().map(|mut lane| {
            lane.links.iter_mut().for_each(|links| shift(links, lane_links));
            lane
        }));
        self.parts.extend(next.parts.into_iter().map(|mut part| {
            part.road = part.road.map(|rank| rank + roads);
            part
        }));
        self.lane_links.extend(next.lane_links);
        self.stations.extend(next.stations);
        self.junctions.extend(next.junctions);
        self.references.extend(next.references);
    }
}
