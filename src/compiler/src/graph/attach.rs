//! Edges at places inside a road, where roads of virtual junctions attach (OpenDRIVE 1.8.1, 12.7), and all others that follow
//! from a junction rather than from the road that is left.
//!
//! The main road is not cut in the file. A connecting road names it with `elementS` and `elementDir`; `+` says that +s of
//! both roads run on into each other.

use super::cuts::{Cuts, SHORTEST_PIECE};
use super::findings::{Problem, Problems};
use super::nodes::{first_node, pieces};
use super::walk::{Edge, lane_of};
use super::{Source, cross_paths, direct, virtual_connections};
use crate::draft::Draft;
use mapd_archive::{ContactPoint, EdgeKind, LinkKind, node_flags};
use mapd_rules::network::Contact;
use mapd_xodr::{ElementDir, Span};

/// Edges over places inside a road and at direct junctions, by the node that is left.
#[derive(Default)]
pub(crate) struct Attachments {
    edges: Vec<Edge>,
}

/// A place inside a road, travelled through in one direction.
#[derive(Clone, Copy)]
pub(crate) struct DirectedPosition {
    pub(crate) road: u32,
    pub(crate) s: f64,
    pub(crate) forward: bool,
}

impl Attachments {
    pub(crate) fn new(source: Source<'_>, cuts: &Cuts, problems: &mut Problems) -> Self {
        let draft = source.draft;
        let mut edges = Vec::new();
        for road in 0..draft.rows.roads.len() as u32 {
            for end in Contact::BOTH {
                out_of_road(source, cuts, road, end, problems, &mut edges);
            }
        }
        for row in draft.rows.junctions.iter() {
            for connection in row.connections.first..row.connections.end() as u32 {
                into_road(source, cuts, connection, problems, &mut edges);
            }
        }
        cross_paths::edges(source, cuts, problems, &mut edges);
        virtual_connections::edges(source, cuts, problems, &mut edges);
        direct::edges(source, problems, &mut edges);
        edges.sort_by_key(|edge| edge.from);
        Self { edges }
    }

    /// Edges that leave a node over a place inside a road or at a direct junction.
    pub(crate) fn leaving(&self, node: u32) -> impl Iterator<Item = Edge> + '_ {
        let from = self.edges.partition_point(|edge| edge.from < node);
        let rest = self.edges.get(from..).unwrap_or(&[]).iter();
        rest.take_while(move |edge| edge.from == node).copied()
    }
}

fn at_place(from: u32, to: u32, span: Span) -> Edge {
    Edge { from, to, kind: EdgeKind::Virtual, span }
}

/// A road's link at one end, if it names a place inside another road.
fn link_inside(source: Source<'_>, road: u32, end: Contact) -> Option<DirectedPosition> {
    let row = source.draft.rows.roads.get(road as usize)?;
    let link = source.links.road_link(road, end)?;
    let (kind, target) = match end {
        Contact::Start => (row.predecessor_kind, row.predecessor),
        Contact::End => (row.successor_kind, row.successor),
    };
    let s = link.s.filter(|_| LinkKind::from_code(kind) == LinkKind::Road)?;
    let aligned = link.dir != Some(ElementDir::Minus);
    Some(DirectedPosition { road: target, s, forward: aligned })
}

/// Edges that leave a road over a link into the middle of another.
fn out_of_road(
    source: Source<'_>,
    cuts: &Cuts,
    road: u32,
    end: Contact,
    problems: &mut Problems,
    edges: &mut Vec<Edge>,
) {
    let Some(mut place) = link_inside(source, road, end) else { return };
    let (draft, successor) = (source.draft, end == Contact::End);
    // Who leaves over the predecessor travels against +s of both.
    place.forward = place.forward == successor;
    let rows = &draft.rows;
    let Some(row) = rows.roads.get(road as usize) else { return };
    let at_end =
        if successor { row.sections.end().saturating_sub(1) } else { row.sections.first.into() };
    let Some(section) = rows.sections.get(at_end as usize) else { return };
    for lane in section.lanes.first..section.lanes.end() as u32 {
        let Some(leaving) = rows.lanes.get(lane as usize) else { continue };
        let Some(first) = first_node(leaving, successor) else { continue };
        let from = first + pieces(leaving) - 1;
        for link in source.links.of_lane(rows, lane, end) {
            match node_at(draft, cuts, place, link.id, true) {
                Ok(to) => edges.push(at_place(from, to, link.span)),
                Err(missing) => {
                    problems.add(missing.problem(from, link.id, link.span, false));
                }
            }
        }
    }
}

/// Edges from the middle of an incoming road into a connecting road.
fn into_road(
    source: Source<'_>,
    cuts: &Cuts,
    connection: u32,
    problems: &mut Problems,
    edges: &mut Vec<Edge>,
) {
    let Source { draft, links } = source;
    let rows = &draft.rows;
    let Some(row) = rows.connections.get(connection as usize) else { return };
    let start = match ContactPoint::from_code(row.contact) {
        ContactPoint::Start => true,
        ContactPoint::End => false,
        _ => return,
    };
    let joined = if start { Contact::Start } else { Contact::End };
    let Some(mut place) = link_inside(source, row.connecting_road, joined) else { return };
    if place.road != row.incoming_road {
        return;
    }
    place.forward = place.forward == start;
    let Some(road) = rows.roads.get(row.connecting_road as usize) else { return };
    let section = if start { road.sections.first } else { road.sections.end() as u32 - 1 };
    let Some(written) = links.connection(connection) else { return };
    for link in links.connected(written) {
        let (number, entered, span) = (link.from, link.to, link.span);
        let from = match node_at(draft, cuts, place, number, false) {
            Ok(from) => from,
            // Lanes of the main road that travel the other way have nothing to do with this place.
            Err(Missing::Direction(_)) => continue,
            Err(missing) => {
                problems.add(missing.problem(u32::MAX, number, span, true));
                continue;
            }
        };
        let lane = lane_of(draft, section, entered);
        let Some(lane) = lane else {
            let (number, is_lane_link) = (entered, true);
            problems.add(Problem::MissingLane { from, section, number, span, is_lane_link });
            continue;
        };
        match rows.lanes.get(lane as usize).and_then(|row| first_node(row, start)) {
            Some(to) => edges.push(at_place(from, to, span)),
            None => problems.add(Problem::Direction { from, lane, span }),
        }
    }
}

/// Why there is no node at a place.
pub(crate) enum Missing {
    /// No section has a lane of that number there.
    Lane(u32),
    /// The lane travels the other way.
    Direction(u32),
    /// The road has no stretch before or behind the place.
    Stretch,
}

impl Missing {
    /// The problem of a link that names the lane: a connection's `laneLink`, or a lane's own link.
    pub(crate) fn problem(self, from: u32, number: i32, span: Span, is_lane_link: bool) -> Problem {
        match self {
            Self::Lane(section) => {
                Problem::MissingLane { from, section, number, span, is_lane_link }
            }
            Self::Direction(lane) => Problem::Direction { from, lane, span },
            Self::Stretch => Problem::NoPlace {
                path: "OpenDRIVE/junction/connection/laneLink",
                message:
                    "expected a place with more of the road ahead, found the road's end; not linked"
                        .to_owned(),
                span,
            },
        }
    }
}

/// The node of a lane that begins (`entering`) or ends at a place, in its direction of travel.
pub(crate) fn node_at(
    draft: &Draft,
    cuts: &Cuts,
    place: DirectedPosition,
    number: i32,
    entering: bool,
) -> Result<u32, Missing> {
    let rows = &draft.rows;
    let range = rows.roads.get(place.road as usize).map(|road| road.sections).unwrap_or_default();
    let sections = range.of(&rows.sections);
    // The piece lies beyond the place towards +s just if one enters towards +s or leaves towards −s.
    let beyond = place.forward == entering;
    let end = sections.last().map_or(0.0, |section| section.s_end);
    if if beyond { place.s > end - SHORTEST_PIECE } else { place.s < SHORTEST_PIECE } {
        return Err(Missing::Stretch);
    }
    // Nearer to a section's end than a cut may be, that end is the place.
    let after = sections.partition_point(|section| {
        if beyond {
            section.s_start <= place.s + SHORTEST_PIECE
        } else {
            section.s_start <= place.s - SHORTEST_PIECE
        }
    });
    let at = range.first + after.saturating_sub(1) as u32;
    let lane = lane_of(draft, at, number).ok_or(Missing::Lane(at))?;
    let row = rows.lanes.get(lane as usize).ok_or(Missing::Lane(at))?;
    let first = first_node(row, place.forward).ok_or(Missing::Direction(lane))?;
    let offset = rows.sections.get(at as usize).map_or(0.0, |section| place.s - section.s_start);
    let offsets = cuts.of(at);
    // The cut nearest to the place; too near to an end there is none, and the whole of the next piece stands in.
    let before = offsets.partition_point(|cut| f64::from(*cut) < offset - SHORTEST_PIECE);
    let through = offsets.partition_point(|cut| f64::from(*cut) <= offset + SHORTEST_PIECE);
    let piece = if beyond { through } else { before };
    let in_order = if place.forward { piece } else { offsets.len() - piece };
    let node = first + in_order as u32;
    debug_assert!(rows.lane_nodes.get(node as usize).is_some_and(|n| {
        n.lane == lane && (n.flags & node_flags::FORWARD != 0) == place.forward
    }));
    Ok(node)
}
