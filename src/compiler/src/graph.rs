//! Lane links: which lane is entered from which, in driving direction (OpenDRIVE 1.8.1, 10.3, 11.5, 12.4).
//!
//! A lane leaves its section at the end towards which it travels. Inside a road its written links lead into the adjacent
//! section; at a road's end through the road's link; at a junction through the connections whose incoming road this is.
//! Links are followed as written, never derived from geometry.

use crate::finding;
use crate::lower::{Lowering, between};
use mapd_archive::{ConnectionRow, ContactPoint, LaneRow, LinkKind, Range, RoadRow, lane_flags};
use mapd_xodr::{Finding, Severity};

/// Direction mismatches that are named one by one; more are counted.
const NAMED: usize = 100;

/// Fills `lane_links` and each lane's `successors` and `predecessors`.
pub(crate) fn build(lowering: &mut Lowering, findings: &mut Vec<Finding>) {
    let incoming = Incoming::new(lowering);
    let mut walk =
        Walk { lowering, incoming: &incoming, edges: Vec::new(), mismatches: Vec::new() };
    for lane in 0..lowering.rows.lanes.len() {
        walk.leave(lane as u32);
    }
    let (mut edges, mismatches) = (walk.edges, walk.mismatches);
    report(lowering, &mismatches, findings);
    // Duplicates arise where a file states a link twice; order is by lane, then as written.
    edges.dedup();
    let lanes = lowering.rows.lanes.len();
    let mut links: Vec<u32> = Vec::with_capacity(edges.len() * 2);
    for (lane, range) in rows_of(&edges, lanes).into_iter().enumerate() {
        lowering.rows.lanes[lane].successors = range;
    }
    links.extend(edges.iter().map(|(_, to)| *to));
    let offset = links.len() as u32;
    let mut backward: Vec<(u32, u32)> = edges.iter().map(|(from, to)| (*to, *from)).collect();
    backward.sort_unstable();
    backward.dedup();
    for (lane, range) in rows_of(&backward, lanes).into_iter().enumerate() {
        lowering.rows.lanes[lane].predecessors = Range { first: range.first + offset, ..range };
    }
    links.extend(backward.iter().map(|(_, to)| *to));
    lowering.rows.lane_links = links.into();
}

/// Ranges of edges that are sorted by their first lane.
fn rows_of(edges: &[(u32, u32)], lanes: usize) -> Vec<Range> {
    let mut ranges = Vec::with_capacity(lanes);
    let mut at = 0;
    for lane in 0..lanes as u32 {
        let before = at;
        while edges.get(at).is_some_and(|(from, _)| *from == lane) {
            at += 1;
        }
        ranges.push(between(before, at));
    }
    ranges
}

/// Connections by incoming road, with their junction.
struct Incoming {
    /// Per road a range of `connections`.
    ranges: Vec<Range>,
    /// (junction, connection) rows.
    connections: Vec<(u32, u32)>,
}

impl Incoming {
    fn new(lowering: &Lowering) -> Self {
        let mut all: Vec<(u32, (u32, u32))> = Vec::new();
        for (junction, row) in lowering.rows.junctions.iter().enumerate() {
            let range = row.connections;
            for (i, connection) in range.of(&lowering.rows.connections).iter().enumerate() {
                if (connection.incoming_road as usize) < lowering.rows.roads.len() {
                    all.push((connection.incoming_road, (junction as u32, range.first + i as u32)));
                }
            }
        }
        all.sort_by_key(|(road, _)| *road);
        let keys: Vec<(u32, u32)> = all.iter().map(|(road, _)| (*road, 0)).collect();
        Self {
            ranges: rows_of(&keys, lowering.rows.roads.len()),
            connections: all.into_iter().map(|(_, connection)| connection).collect(),
        }
    }
}

/// A lane and one it is linked to, which travels the other way.
struct Mismatch {
    from: u32,
    to: u32,
}

struct Walk<'a> {
    lowering: &'a Lowering,
    incoming: &'a Incoming,
    edges: Vec<(u32, u32)>,
    mismatches: Vec<Mismatch>,
}

impl Walk<'_> {
    /// Adds the edges that leave a lane.
    fn leave(&mut self, lane: u32) {
        let rows = &self.lowering.rows;
        let Some(row) = rows.lanes.get(lane as usize) else { return };
        if row.number == 0 {
            return;
        }
        let forward = row.flags & lane_flags::FORWARD != 0;
        let Some(section) = rows.sections.get(row.section as usize) else { return };
        let Some(road) = rows.roads.get(section.road as usize) else { return };
        let at = row.section - road.sections.first;
        let inside = if forward { at + 1 < road.sections.count } else { at > 0 };
        if inside {
            let next = if forward { row.section + 1 } else { row.section - 1 };
            for number in self.written(lane, forward) {
                self.enter(lane, next, number, forward);
            }
            return;
        }
        let (kind, target, contact) = if forward {
            (road.successor_kind, road.successor, road.successor_contact)
        } else {
            (road.predecessor_kind, road.predecessor, road.predecessor_contact)
        };
        match LinkKind::from_code(kind) {
            LinkKind::Road => {
                if let Some((next, entry)) = self.touching(target, contact) {
                    for number in self.written(lane, forward) {
                        self.enter(lane, next, number, entry);
                    }
                }
            }
            LinkKind::Junction => {
                self.through_junction(lane, row, section.road, road, target, forward)
            }
            _ => {}
        }
    }

    /// Lane numbers written as successors (`forward`) or predecessors.
    fn written(&self, lane: u32, forward: bool) -> Vec<i32> {
        let ranges = self.lowering.links.lanes.get(lane as usize).copied().unwrap_or_default();
        ranges[usize::from(forward)].of(&self.lowering.links.lane_numbers).to_vec()
    }

    /// The section of a road at one of its ends and whether lanes entered there travel towards +s.
    fn touching(&self, road: u32, contact: u8) -> Option<(u32, bool)> {
        let sections = self.lowering.rows.roads.get(road as usize)?.sections;
        let last = sections.count.checked_sub(1)?;
        match ContactPoint::from_code(contact) {
            ContactPoint::Start => Some((sections.first, true)),
            ContactPoint::End => Some((sections.first + last, false)),
            _ => None,
        }
    }

    /// Through every connection of the junction that starts at this end of the road.
    fn through_junction(
        &mut self,
        lane: u32,
        row: &LaneRow,
        road_number: u32,
        road: &RoadRow,
        junction: u32,
        forward: bool,
    ) {
        let rows = &self.lowering.rows;
        let connections =
            self.incoming.ranges.get(road_number as usize).copied().unwrap_or_default();
        for (of, number) in connections.of(&self.incoming.connections) {
            let Some(connection) =
                rows.connections.get(*number as usize).filter(|_| *of == junction)
            else {
                continue;
            };
            if both_ends(road, junction) && !self.starts_here(connection, road_number, forward) {
                continue;
            }
            let Some((next, entry)) = self.touching(connection.connecting_road, connection.contact)
            else {
                continue;
            };
            let links = connection.lane_links.of(&rows.connection_lane_links);
            if links.is_empty() {
                // OpenDRIVE 1.4: without lane links, lanes keep their numbers.
                self.enter(lane, next, row.number, entry);
            }
            for link in links.iter().filter(|link| link.from == row.number) {
                self.enter(lane, next, link.to, entry);
            }
        }
    }

    /// Whether a connection's road is linked to this end of the incoming road; asked where both ends of the road lie at
    /// one junction.
    fn starts_here(&self, connection: &ConnectionRow, road: u32, forward: bool) -> bool {
        let Some(connecting) = self.lowering.rows.roads.get(connection.connecting_road as usize)
        else {
            return false;
        };
        let (kind, target, contact) = match ContactPoint::from_code(connection.contact) {
            ContactPoint::End => {
                (connecting.successor_kind, connecting.successor, connecting.successor_contact)
            }
            _ => (
                connecting.predecessor_kind,
                connecting.predecessor,
                connecting.predecessor_contact,
            ),
        };
        let here = if forward { ContactPoint::End } else { ContactPoint::Start };
        LinkKind::from_code(kind) == LinkKind::Road && target == road && contact == here.code()
    }

    /// Adds an edge to a lane of a section if that lane travels the way it is entered.
    fn enter(&mut self, from: u32, section: u32, number: i32, forward: bool) {
        let rows = &self.lowering.rows;
        let Some(section) = rows.sections.get(section as usize) else { return };
        let lanes = section.lanes.of(&rows.lanes);
        let Ok(at) = lanes.binary_search_by(|lane| number.cmp(&lane.number)) else { return };
        let target = section.lanes.first + at as u32;
        let Some(lane) = lanes.get(at).filter(|lane| lane.number != 0) else { return };
        let both = lane.flags & lane_flags::BOTH != 0;
        if both || (lane.flags & lane_flags::FORWARD != 0) == forward {
            self.edges.push((from, target));
        } else {
            self.mismatches.push(Mismatch { from, to: target });
        }
    }
}

/// Whether both ends of a road lie at this junction.
fn both_ends(road: &RoadRow, junction: u32) -> bool {
    let at = |kind: u8, target: u32| {
        LinkKind::from_code(kind) == LinkKind::Junction && target == junction
    };
    at(road.predecessor_kind, road.predecessor) && at(road.successor_kind, road.successor)
}

fn report(lowering: &Lowering, mismatches: &[Mismatch], findings: &mut Vec<Finding>) {
    let place = |lane: u32| {
        let row = lowering.rows.lanes.get(lane as usize)?;
        let section = lowering.rows.sections.get(row.section as usize)?;
        let road = lowering.rows.roads.get(section.road as usize)?;
        let id = String::from_utf8_lossy(lowering.strings.bytes_of(road.id)).into_owned();
        Some((section.road, format!("{id}:{}:{}", section.number, row.number)))
    };
    for mismatch in mismatches.iter().take(NAMED) {
        let (Some((road, from)), Some((_, to))) = (place(mismatch.from), place(mismatch.to)) else {
            continue;
        };
        let span = lowering.links.road_spans.get(road as usize).copied().unwrap_or_default();
        let message = format!(
            "lane {from} leads into lane {to}, which travels the other way; no edge is made"
        );
        let path = "OpenDRIVE/road/lanes/laneSection/lane/link".to_owned();
        findings.push(finding("mapd:graph.direction", Severity::Warning, span, path, message, ""));
    }
    if mismatches.len() > NAMED {
        let message = format!(
            "{} more links lead into lanes that travel the other way",
            mismatches.len() - NAMED
        );
        let path = "OpenDRIVE/road/lanes/laneSection/lane/link".to_owned();
        findings.push(finding(
            "mapd:graph.direction",
            Severity::Warning,
            Default::default(),
            path,
            message,
            "",
        ));
    }
}
