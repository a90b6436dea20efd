//! Facts of a map that every later build must tell again, beside its [`answers`](super::answers): borders, heights, speeds, conflicts, signals with their
//! lanes and movements, objects with their outlines, road marks, and whatever else lies in a table.
//!
//! Facts only: what the rules of a country make of them may become better, and has tests of its own.

mod document;
mod graph;
mod lanes;
mod line;
mod near;
mod objects;
mod roads;
mod signals;

pub(super) use line::{Fine, Lines};
use mapd_client::Map;
use mapd_query::document::SourcePosition;
use mapd_query::rules::LaneLine;
use mapd_query::{Lane, LaneId, Road};

/// What a map says of everything in it, a line for each part, as text: the same for ever.
pub fn facts(map: Map<'_>) -> String {
    let mut lines = Lines::default();
    document::facts(map, &mut lines);
    roads::facts(map, &mut lines);
    lanes::facts(map, &mut lines);
    graph::facts(map, &mut lines);
    signals::facts(map, &mut lines);
    objects::facts(map, &mut lines);
    near::facts(map, &mut lines);
    lines.into_text()
}

/// Shares of a stretch at which it is asked about.
const SHARES: [f64; 3] = [0.0, 0.4, 1.0];

/// Places between two ends, both included.
fn stations(from: f64, to: f64) -> impl Iterator<Item = f64> {
    SHARES.into_iter().map(move |share| from + share * (to - from))
}

/// Every lane: lane 0 of each section and temporary ones, too.
fn all_lanes(map: Map<'_>) -> impl Iterator<Item = Lane<'_>> {
    let sections = map.roads().flat_map(|road| road.sections().chain(road.temporary_sections()));
    sections.flat_map(|section| section.lanes())
}

/// The key of a lane by its id; empty if the map does not have it.
fn key(map: Map<'_>, id: LaneId) -> String {
    map.lane(id).map(|lane| lane.key().to_string()).unwrap_or_default()
}

/// Keys of lanes, in their order.
fn keys<'a>(lanes: impl Iterator<Item = Lane<'a>>) -> Vec<String> {
    lanes.map(|lane| lane.key().to_string()).collect()
}

fn road_id(road: Option<Road<'_>>) -> Option<&str> {
    road.map(|road| road.id())
}

/// A line on a lane: `kind@lane s`.
fn lane_line(map: Map<'_>, line: LaneLine) -> String {
    format!("{}@{} {:.3}", line.class.name(), key(map, line.lane), line.s)
}

fn at(place: SourcePosition) -> String {
    format!("{}:{}", place.line, place.column)
}
