//! Results that are plain data have the layout of C: the compiler's own check of what may be handed to C, type by type.
#![deny(improper_ctypes_definitions)]

use mapd_client::document::{HeaderOffset, Revision, SourcePosition};
use mapd_client::junctions::{ConnectedLanes, GridHeight};
use mapd_client::localisation::{LaneMatch, Sensor, TracePosition, VehicleOutline};
use mapd_client::objects::SkeletonVertex;
use mapd_client::path::{
    ConflictLane, EdgeMark, PathConflict, PathJoint, PathLane, PathPoint, PathPosition, PathTime,
    YieldsBy,
};
use mapd_client::roads::{
    BoundarySegment, LaneHeight, LaneRange, LaneSpeed, LinePoint, RoadMarkSegment, Waypoint,
};
use mapd_client::route::{
    AlternativeOptions, LaneChangeAhead, NextJunction, PositionOnLane, ReachLink, Route, RouteStep,
    ShortestLength, ShortestTime,
};
use mapd_client::signals::{LightStates, NearSignal};
use mapd_client::{Bounds, LaneEdges, LanePosition, Nearest, Pose, Region, SRange, Track};
use mapd_tests::workspace;
use std::collections::BTreeSet;

/// Hands each type to a function of C, which the compiler refuses for a type whose layout is Rust's own; and lists their names.
macro_rules! plain {
    ($($name:ident)*) => {
        $(const _: () = {
            extern "C" fn _handed_on(_: $name) {}
        };)*
        const PLAIN: &[&str] = &[$(stringify!($name)),*];
    };
}

plain! {
    AlternativeOptions BoundarySegment Bounds ConflictLane ConnectedLanes EdgeMark GridHeight HeaderOffset LaneChangeAhead LaneEdges LaneHeight LaneMatch
    LanePosition LaneRange LaneSpeed LightStates LinePoint Nearest NearSignal NextJunction PathConflict PathJoint PathLane PathPoint
    PathPosition PathTime Pose PositionOnLane ReachLink Region Revision RoadMarkSegment Route RouteStep Sensor ShortestLength ShortestTime
    SkeletonVertex SourcePosition SRange TracePosition Track VehicleOutline Waypoint YieldsBy
}

/// Structs whose public fields are plain, and why their layout is Rust's own.
const OTHERS: &[(&str, &str)] = &[
    ("ConflictApproach", "it has numbers of rows, which are no part of the answer"),
    ("PathSegment", "it has numbers of rows, which are no part of the answer"),
    ("Reached", "it has the number of a row, which is no part of the answer"),
    ("SignalAhead", "it has the number of a row, which is no part of the answer"),
];

/// The list of the crate's public items.
fn list() -> String {
    std::fs::read_to_string(workspace().join("docs/api/mapd-query.txt")).expect("the list")
}

/// The last name in a path, without what follows it.
fn last(path: &str) -> &str {
    let end = path.find(|c: char| !c.is_alphanumeric() && c != '_' && c != ':');
    path.get(..end.unwrap_or(path.len())).and_then(|path| path.rsplit("::").next()).unwrap_or("")
}

/// Whether a field of this type is plain: numbers, vectors, ids, words, and what is known to be plain.
fn is_plain(of: &str, known: &BTreeSet<&str>) -> bool {
    if let Some(many) = of.strip_prefix('[') {
        return many.split_once(';').is_some_and(|(one, _)| is_plain(one, known));
    }
    let numbers = ["bool", "f32", "f64", "i32", "u16", "u32", "u64", "u8", "usize"];
    let vectors = ["DVec2", "DVec3"];
    let has_arguments = of.contains('<') || of.contains('&');
    !has_arguments
        && (numbers.contains(&of)
            || vectors.contains(&last(of))
            || last(of).ends_with("Id") && last(of) != "PlacementId"
            || known.contains(last(of)))
}

#[test]
fn all_plain_results_have_the_layout_of_c() {
    let list = list();
    let words = std::fs::read_to_string(workspace().join("docs/api/mapd-archive.txt"));
    let words = words.expect("the list");
    let enums = list.lines().chain(words.lines());
    let enums = enums
        .filter(|line| line.contains("#[repr(u"))
        .filter_map(|line| line.split_once("pub enum ").map(|(_, path)| last(path)));
    let known: BTreeSet<&str> = enums.chain(PLAIN.iter().copied()).collect();
    let mut wrong = Vec::new();
    for line in list.lines().filter(|line| {
        line.contains("pub struct ") && !line.contains('(')
            || line.contains("#[repr(C)] pub struct ")
    }) {
        let Some((attributes, path)) = line.split_once("pub struct ") else { continue };
        let name = last(path);
        let own = format!("pub {path}::");
        let fields: Vec<&str> = list
            .lines()
            .filter_map(|line| line.strip_prefix(&own)?.split_once(": "))
            .map(|(_, of)| of)
            .collect();
        let is_plain = !fields.is_empty() && fields.iter().all(|of| is_plain(of, &known));
        let is_other = OTHERS.iter().any(|(other, _)| *other == name);
        let has_layout = attributes.contains("repr(C)");
        let is_id = name.ends_with("Id") && fields.is_empty();
        if !is_id && (is_plain && !is_other || PLAIN.contains(&name)) != has_layout {
            wrong.push(format!("{line}: {fields:?}"));
        }
        if has_layout && !is_id && !PLAIN.contains(&name) {
            wrong.push(format!("{name} is not handed to C above"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
