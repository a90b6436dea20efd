//! Virtual connections (OpenDRIVE 1.5 to 1.7, deprecated since 1.8): ways between places inside roads without a connecting
//! road.
//!
//! The connection's predecessor is left and its successor entered; `elementDir` says in which direction of s one travels on
//! each, and its lane links which lanes. A way that ends where the other begins needs no cut in the file: nodes end there.

use super::Source;
use super::attach::{DirectedPosition, Missing, node_at};
use super::cuts::Cuts;
use super::findings::{Problem, Problems};
use super::walk::Edge;
use super::zones::road_of;
use crate::draft::Draft;
use mapd_archive::EdgeKind;
use mapd_xodr::{
    Connection, ConnectionEnd, ConnectionType, ElementDir, Span, Text as _, Value as _,
};

/// Path of the ends of virtual connections.
const ENDS: &str = "OpenDRIVE/junction/connection";
/// A place this far `[m]` behind a road's end still lies on it: files round lengths to centimetres.
const BEYOND: f64 = 0.01;

/// Places inside roads that virtual connections name: (road row, s).
pub(crate) fn places(source: Source<'_>) -> impl Iterator<Item = (u32, f64)> {
    let ends = connections(source).flat_map(|connection| ends(connection).into_iter().flatten());
    ends.filter_map(move |end| place(source.draft, end).ok()).map(|place| (place.road, place.s))
}

/// Edges of all virtual connections.
pub(crate) fn edges(
    source: Source<'_>,
    cuts: &Cuts,
    problems: &mut Problems,
    edges: &mut Vec<Edge>,
) {
    let draft = source.draft;
    for connection in connections(source) {
        let [from, to] = ends(connection).map(|end| match end {
            Some(end) => place(draft, end).map_err(|message| (message, end.span)),
            None => Err(("expected a predecessor and a successor".to_owned(), connection.span)),
        });
        let (from, to) = match (from, to) {
            (Ok(from), Ok(to)) => (from, to),
            (from, to) => {
                // An absent end is said once.
                let mut wrong: Vec<(String, Span)> =
                    [from.err(), to.err()].into_iter().flatten().collect();
                wrong.dedup();
                for (message, span) in wrong {
                    let message = format!("{message}; not linked");
                    problems.add(Problem::NoPlace { path: ENDS, message, span });
                }
                continue;
            }
        };
        for link in &connection.lane_link {
            let (Some(left), Some(entered)) = (link.from.value(), link.to.value()) else {
                continue;
            };
            let span = link.span;
            let mut node = |place, number, entering, from: u32| {
                let found = node_at(draft, cuts, place, number, entering);
                found.map_err(|missing: Missing| {
                    problems.add(missing.problem(from, number, span, true))
                })
            };
            let Ok(from) = node(from, left, false, u32::MAX) else { continue };
            let Ok(to) = node(to, entered, true, from) else { continue };
            edges.push(Edge { from, to, kind: EdgeKind::Virtual, span });
        }
    }
}

/// All virtual connections.
fn connections(source: Source<'_>) -> impl Iterator<Item = &Connection> {
    let all = source.links.elements().flat_map(|junction| &junction.connection);
    all.filter(|connection| {
        connection.r#type.value() == Some(ConnectionType::Virtual)
            && (connection.connecting_road.is_none()
                || ends(connection).iter().any(Option::is_some))
    })
}

/// Predecessor and successor.
fn ends(connection: &Connection) -> [Option<&ConnectionEnd>; 2] {
    [connection.predecessor.as_deref(), connection.successor.as_deref()]
}

/// The place that an end names, or what is wrong with it.
fn place(draft: &Draft, end: &ConnectionEnd) -> Result<DirectedPosition, String> {
    let id = end.element_id.text();
    let road = road_of(draft, id);
    let road = road.ok_or_else(|| {
        format!("expected a road of the map, found {id:?}, which it does not have")
    })?;
    let length = draft.rows.roads.get(road as usize).map_or(0.0, |row| row.length);
    let s = end.element_s.value().ok_or("expected @elementS, found none")?;
    if !(0.0..=length + BEYOND).contains(&s) {
        return Err(format!("expected a place within 0 to {length} m of road {id:?}, found {s} m"));
    }
    let forward = end.element_dir.value() != Some(ElementDir::Minus);
    Ok(DirectedPosition { road, s: s.min(length), forward })
}
