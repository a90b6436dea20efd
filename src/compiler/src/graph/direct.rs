//! Edges of direct junctions, whose roads lead into each other without one between (OpenDRIVE 1.8.1, 12.4.2, 12.6).
//!
//! A connection joins lanes of two roads, whichever way their traffic goes: `incomingRoad` is the road on one side of the
//! junction. So a link leads from either road into the other, as the two lanes travel.

use super::Source;
use super::findings::{Problem, Problems};
use super::nodes::{first_node, pieces};
use super::walk::{Edge, lane_of, section_at};
use mapd_archive::EdgeKind;
use mapd_rules::network::Contact;
use mapd_xodr::{JunctionType, Span};

/// An end of a road that lies at a junction.
#[derive(Clone, Copy)]
struct Side {
    section: u32,
    end: Contact,
}

/// A lane at a junction: the nodes that lead into it and out of it.
struct Nodes {
    lane: u32,
    into: Option<u32>,
    out_of: Option<u32>,
}

/// Appends the edges of all direct junctions.
pub(crate) fn edges(source: Source<'_>, problems: &mut Problems, edges: &mut Vec<Edge>) {
    let Source { draft, links } = source;
    let rows = &draft.rows;
    for (number, row) in rows.junctions.iter().enumerate() {
        let junction = links.junction(number as u32);
        let Some(junction) = junction.filter(|one| one.kind == JunctionType::Direct) else {
            continue;
        };
        for number in row.connections.first..row.connections.end() as u32 {
            let Some(connection) = rows.connections.get(number as usize) else { continue };
            let Some(written) = links.connection(number) else { continue };
            let [from, to] = links.network.connected_ends(junction, written);
            let side = |road: u32, end: Contact| {
                Some(Side { section: section_at(draft, road, end)?, end })
            };
            let from = from.and_then(|at| side(connection.incoming_road, at.end));
            let to = to.and_then(|at| side(connection.connecting_road, at.end));
            let (Some(from), Some(to)) = (from, to) else { continue };
            let joint = Joint { source, from, to };
            let mut linked = links.connected(written).peekable();
            if linked.peek().is_none() {
                // Without lane links, lanes keep their numbers, as far as both roads have them.
                let lanes = rows.sections.get(from.section as usize);
                let lanes = lanes.map(|section| section.lanes.of(&rows.lanes)).unwrap_or_default();
                for lane in lanes {
                    let ends = [joint.nodes(from, lane.number), joint.nodes(to, lane.number)];
                    if let [Some(a), Some(b)] = ends {
                        add(&a, &b, EdgeKind::Implied, written.span, edges);
                    }
                }
            }
            for link in linked.filter(|link| link.from != 0) {
                joint.follow([link.from, link.to], link.span, problems, edges);
            }
        }
    }
}

/// Two ends of roads that a connection joins.
struct Joint<'a> {
    source: Source<'a>,
    from: Side,
    to: Side,
}

impl Joint<'_> {
    /// Adds the edges of a link.
    fn follow(
        &self,
        numbers: [i32; 2],
        span: Span,
        problems: &mut Problems,
        edges: &mut Vec<Edge>,
    ) {
        let ends = [self.from, self.to];
        let found = [0, 1].map(|at| self.nodes(ends[at], numbers[at]));
        let [Some(a), Some(b)] = found else {
            let at = usize::from(found[0].is_some());
            let (from, section, number) = (u32::MAX, ends[at].section, numbers[at]);
            problems.add(Problem::MissingLane { from, section, number, span, is_lane_link: true });
            return;
        };
        if !add(&a, &b, EdgeKind::Connection, span, edges) {
            // Both lead into the junction, or both out of it.
            let (from, lane) = a.into.map_or((u32::MAX, a.lane), |node| (node, b.lane));
            problems.add(Problem::Direction { from, lane, span });
        }
    }

    /// The lane of a number at an end of a road.
    fn nodes(&self, at: Side, number: i32) -> Option<Nodes> {
        let draft = self.source.draft;
        let lane = lane_of(draft, at.section, number)?;
        let row = draft.rows.lanes.get(lane as usize)?;
        let is_end = at.end == Contact::End;
        let into = first_node(row, is_end).map(|first| first + pieces(row) - 1);
        Some(Nodes { lane, into, out_of: first_node(row, !is_end) })
    }
}

/// Adds the edges between two lanes, as they travel; says whether there is one.
fn add(a: &Nodes, b: &Nodes, kind: EdgeKind, span: Span, edges: &mut Vec<Edge>) -> bool {
    let before = edges.len();
    for (from, to) in [(a.into, b.out_of), (b.into, a.out_of)] {
        if let (Some(from), Some(to)) = (from, to) {
            edges.push(Edge { from, to, kind, span });
        }
    }
    edges.len() > before
}
