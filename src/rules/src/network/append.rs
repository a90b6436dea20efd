//! Puts what was kept of the next elements behind what was kept of those before.

use super::Network;
use super::facts::{LinkTarget, RoadApart, RoadFacts};
use super::junctions::Before;
use super::names::Name;
use super::references::renamed;
use std::ops::Range;

/// Moves a range by so many places.
pub(super) fn shift(range: &mut Range<u32>, by: u32) {
    *range = range.start.saturating_add(by)..range.end.saturating_add(by);
}

/// Moves the ids that a road has and names to their numbers in the whole.
fn rename(road: &mut RoadFacts, names: &[Name]) {
    road.id = renamed(road.id, names);
    road.junction = road.junction.map(|junction| renamed(junction, names));
    for link in road.links.iter_mut().flatten() {
        link.target = match link.target {
            LinkTarget::Road(id) => LinkTarget::Road(renamed(id, names)),
            LinkTarget::Junction(id) => LinkTarget::Junction(renamed(id, names)),
        };
    }
}

impl Network {
    /// Takes what was kept of the elements that come next. Neither part is finished.
    pub fn append(&mut self, next: Self) {
        let [roads, sections, lanes, lane_links, lines, profiles, connected] = [
            self.roads.len(),
            self.sections.len(),
            self.lanes.len(),
            self.lane_links.len(),
            self.lines.len(),
            self.profiles.len(),
            self.connected_lanes.len(),
        ]
        .map(|count| count as u32);
        if next.header.is_some() {
            self.header = next.header;
            self.has_offset = next.has_offset;
        }
        let names = self.names.append(&next.names);
        self.roads.extend(next.roads.into_iter().map(|mut road| {
            road.rank += roads;
            shift(&mut road.sections, sections);
            shift(&mut road.stations, lines);
            shift(&mut road.profiles, profiles);
            rename(&mut road, &names);
            road
        }));
        self.roads_apart.extend(next.roads_apart.into_iter().map(|road| RoadApart {
            id: renamed(road.id, &names),
            junction: road.junction.map(|junction| renamed(junction, &names)),
            ..road
        }));
        self.sections.extend(next.sections.into_iter().map(|mut section| {
            shift(&mut section.lanes, lanes);
            section
        }));
        self.lanes.extend(next.lanes.into_iter().map(|mut lane| {
            lane.links = lane.links.map(|link| link.saturating_add(lane_links));
            lane
        }));
        let parts = next.parts.into_iter();
        self.parts.extend(parts.map(|part| part.moved(roads, renamed(part.id, &names))));
        self.lane_links.extend(next.lane_links);
        self.lines.extend(next.lines);
        self.profiles.extend(next.profiles);
        let before = Before {
            connections: self.connections.len() as u32,
            controllers: self.controllers.len() as u32,
            priorities: self.priorities.len() as u32,
        };
        let junctions = next.junctions.into_iter();
        self.junctions.extend(junctions.map(|junction| junction.moved(before, &names)));
        let controllers = next.controllers.into_iter();
        self.controllers.extend(controllers.map(|controller| controller.renamed(&names)));
        let priorities = next.priorities.into_iter();
        self.priorities.extend(priorities.map(|priority| priority.renamed(&names)));
        let next_connections = next.connections.into_iter();
        self.connections.extend(next_connections.map(|c| c.moved(connected, &names)));
        self.connected_lanes.extend(next.connected_lanes);
        let references = next.references.into_iter();
        self.references.extend(references.map(|reference| reference.renamed(&names)));
    }
}
