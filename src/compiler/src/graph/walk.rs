//! Longitudinal edges: which node is entered from which, in driving direction (OpenDRIVE 1.8.1, 10.3, 11.5, 12).
//!
//! A node leaves its section at the end towards which it travels. Inside a road its lane's written links lead into the
//! adjacent section; at a road's end through the road's link; at a junction through the connections whose incoming road
//! this is. Links are followed as written, never derived from geometry.

use super::Source;
use super::attach::Attachments;
use super::findings::{Problem, Problems};
use super::incoming::{Incoming, IncomingConnection};
use super::nodes::{first_node, pieces};
use crate::draft::{Draft, Links};
use mapd_archive::{
    ConnectionRow, ContactPoint, EdgeKind, LaneRow, LinkKind, RoadRow, lane_flags, node_flags,
};
use mapd_rules::network::Contact;
use mapd_xodr::{JunctionType, Span};
use rayon::prelude::*;

/// Nodes that one task leaves.
const NODES_PER_TASK: usize = 1024;

/// An edge with the place in the file that says so.
#[derive(Clone, Copy)]
pub(crate) struct Edge {
    pub(crate) from: u32,
    pub(crate) to: u32,
    pub(crate) kind: EdgeKind,
    pub(crate) span: Span,
}

/// A lane's place at which an edge ends: its section and the direction in which it is entered.
#[derive(Clone, Copy)]
struct Entry {
    section: u32,
    forward: bool,
}

/// All edges, by the node that is left, and what is wrong with the links.
pub(crate) fn edges(
    source: Source<'_>,
    attachments: &Attachments,
    problems: &mut Problems,
) -> Vec<Edge> {
    let Source { draft, links } = source;
    let incoming = Incoming::new(source);
    let nodes: Vec<u32> = (0..draft.rows.lane_nodes.len() as u32).collect();
    let walked = nodes.par_chunks(NODES_PER_TASK).map(|nodes| {
        let mut problems = Problems::default();
        let (incoming, edges) = (&incoming, Vec::with_capacity(nodes.len()));
        let mut walk = Walk { draft, links, incoming, attachments, edges, problems: &mut problems };
        nodes.iter().for_each(|node| walk.leave(*node));
        (walk.edges, problems)
    });
    let walked: Vec<_> = walked.collect();
    let mut edges = Vec::with_capacity(walked.iter().map(|(edges, _)| edges.len()).sum());
    for (of_task, own) in walked {
        edges.extend(of_task);
        problems.append(own);
    }
    edges
}

struct Walk<'a> {
    draft: &'a Draft,
    links: &'a Links<'a>,
    incoming: &'a Incoming,
    attachments: &'a Attachments,
    edges: Vec<Edge>,
    problems: &'a mut Problems,
}

impl Walk<'_> {
    /// Adds the edges that leave a node.
    fn leave(&mut self, node: u32) {
        let rows = &self.draft.rows;
        let Some(own) = rows.lane_nodes.get(node as usize) else { return };
        let Some(row) = rows.lanes.get(own.lane as usize) else { return };
        let forward = own.flags & node_flags::FORWARD != 0;
        self.edges.extend(self.attachments.leaving(node));
        if (node - row.nodes().first) % pieces(row) + 1 < pieces(row) {
            let span = Span::default();
            self.edges.push(Edge { from: node, to: node + 1, kind: EdgeKind::Within, span });
            return;
        }
        let Some(section) = rows.sections.get(row.section as usize) else { return };
        let Some(road) = rows.roads.get(section.road as usize) else { return };
        let at = row.section - road.sections.first;
        let inside = if forward { at + 1 < road.sections.count } else { at > 0 };
        if inside {
            let next = if forward { row.section + 1 } else { row.section - 1 };
            self.written(
                node,
                own.lane,
                forward,
                EdgeKind::Section,
                Entry { section: next, forward },
            );
            return;
        }
        let (kind, target, contact) = if forward {
            (road.successor_kind, road.successor, road.successor_contact)
        } else {
            (road.predecessor_kind, road.predecessor, road.predecessor_contact)
        };
        match LinkKind::from_code(kind) {
            // A link into the middle of a road is an attachment.
            LinkKind::Road if self.names_a_place(section.road, forward) => {}
            LinkKind::Road => {
                if let Some(entry) = self.touching(target, contact) {
                    self.written(node, own.lane, forward, EdgeKind::Road, entry);
                }
            }
            LinkKind::Junction if !self.is_direct(target) => {
                self.through_junction(node, row, section.road, target, forward);
            }
            _ => {}
        }
    }

    /// Whether a road's link at one end names a place inside another road.
    fn names_a_place(&self, road: u32, forward: bool) -> bool {
        self.links.road_link(road, ahead(forward)).is_some_and(|link| link.s.is_some())
    }

    /// Whether a junction is a direct one: its edges stand among the attachments.
    fn is_direct(&self, junction: u32) -> bool {
        self.links.junction(junction).is_some_and(|one| one.kind == JunctionType::Direct)
    }

    /// Follows the lane's links as written: its successors (`forward`) or predecessors.
    fn written(&mut self, node: u32, lane: u32, forward: bool, kind: EdgeKind, entry: Entry) {
        for link in self.links.of_lane(&self.draft.rows, lane, ahead(forward)) {
            self.enter(node, kind, link.span, entry, link.id);
        }
    }

    /// The section of a road at one of its ends and whether lanes entered there travel towards +s.
    fn touching(&self, road: u32, contact: u8) -> Option<Entry> {
        let end = match ContactPoint::from_code(contact) {
            ContactPoint::Start => Contact::Start,
            ContactPoint::End => Contact::End,
            _ => return None,
        };
        let section = section_at(self.draft, road, end)?;
        Some(Entry { section, forward: end == Contact::Start })
    }

    /// Through every connection of the junction that starts at this end of the road.
    fn through_junction(
        &mut self,
        node: u32,
        row: &LaneRow,
        number: u32,
        junction: u32,
        forward: bool,
    ) {
        let draft = self.draft;
        let rows = &draft.rows;
        let Some(road) = rows.roads.get(number as usize) else { return };
        let incoming = self.incoming;
        let entry = |walk: &Self, one: &IncomingConnection| {
            let connection = rows.connections.get(one.connection as usize)?;
            let is_ahead = one.junction == junction
                && (!both_ends(road, junction) || walk.starts_here(connection, number, forward));
            walk.touching(connection.connecting_road, connection.contact).filter(|_| is_ahead)
        };
        // OpenDRIVE 1.4: without lane links, lanes keep their numbers, as far as both roads have them.
        for one in incoming.bare(number) {
            if let Some(entry) = entry(self, one)
                && let Some(written) = self.links.connection(one.connection)
                && self.find(entry, row.number).is_some_and(|lane| self.travels(lane, entry))
            {
                self.enter(node, EdgeKind::Implied, written.span, entry, row.number);
            }
        }
        for (one, link) in incoming.links(number, row.number) {
            if let Some(entry) = entry(self, one) {
                self.enter(node, EdgeKind::Connection, link.span, entry, link.to);
            }
        }
    }

    /// Whether a connection's road is linked to this end of the incoming road; asked where both ends of the road lie at
    /// one junction.
    fn starts_here(&self, connection: &ConnectionRow, road: u32, forward: bool) -> bool {
        let Some(connecting) = self.draft.rows.roads.get(connection.connecting_road as usize)
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

    /// The lane with a number in the section that is entered.
    fn find(&self, entry: Entry, number: i32) -> Option<u32> {
        lane_of(self.draft, entry.section, number)
    }

    fn travels(&self, lane: u32, entry: Entry) -> bool {
        self.draft.rows.lanes.get(lane as usize).is_some_and(|row| {
            row.flags & lane_flags::TWO_WAY != 0
                || (row.flags & lane_flags::FORWARD != 0) == entry.forward
        })
    }

    /// Adds an edge to a lane of a section if that lane travels the way it is entered.
    fn enter(&mut self, from: u32, kind: EdgeKind, span: Span, entry: Entry, number: i32) {
        let rows = &self.draft.rows;
        let Some(lane) = self.find(entry, number) else {
            if !self.only_walked(from) {
                let section = entry.section;
                let is_lane_link = kind == EdgeKind::Connection;
                let missing = Problem::MissingLane { from, section, number, span, is_lane_link };
                self.problems.add(missing);
            }
            return;
        };
        let target = rows.lanes.get(lane as usize).and_then(|row| first_node(row, entry.forward));
        match target {
            Some(to) => self.edges.push(Edge { from, to, kind, span }),
            None if self.only_walked(from) => {}
            None => self.problems.add(Problem::Direction { from, lane, span }),
        }
    }

    /// Whether a node goes against the traffic rule because who walks may: the file promises nothing about that way.
    fn only_walked(&self, node: u32) -> bool {
        let rows = &self.draft.rows;
        let node = rows.lane_nodes.get(node as usize);
        node.and_then(|node| Some((node, rows.lanes.get(node.lane as usize)?))).is_some_and(
            |(node, lane)| {
                let forward = node.flags & node_flags::FORWARD != 0;
                lane.flags & lane_flags::BOTH == 0
                    && (lane.flags & lane_flags::FORWARD != 0) != forward
            },
        )
    }
}

/// The section at an end of a road.
pub(crate) fn section_at(draft: &Draft, road: u32, end: Contact) -> Option<u32> {
    let sections = draft.rows.roads.get(road as usize)?.sections;
    let last = sections.count.checked_sub(1)?;
    Some(sections.first + if end == Contact::Start { 0 } else { last })
}

/// The lane with a number in a section; none for lane 0.
pub(crate) fn lane_of(draft: &Draft, section: u32, number: i32) -> Option<u32> {
    let rows = &draft.rows;
    let section = rows.sections.get(section as usize)?;
    let lanes = section.lanes.of(&rows.lanes);
    let at = lanes.binary_search_by(|lane| number.cmp(&lane.number)).ok()?;
    (number != 0).then_some(section.lanes.first + at as u32)
}

/// The end towards which one travels.
fn ahead(forward: bool) -> Contact {
    if forward { Contact::End } else { Contact::Start }
}

/// Whether both ends of a road lie at this junction.
fn both_ends(road: &RoadRow, junction: u32) -> bool {
    let at = |kind: u8, target: u32| {
        LinkKind::from_code(kind) == LinkKind::Junction && target == junction
    };
    at(road.predecessor_kind, road.predecessor) && at(road.successor_kind, road.successor)
}
