//! The same answers from every build and on every machine, bit by bit: what is asked of the carried maps, hashed by kind.
//!
//! These hashes change when what is asked or a query changes; then this is where the change is owned up to. A build that
//! answers otherwise than another of the same code is a defect: floating-point functions come from `libm`. It stands here so that the
//! build of the benchmarks, which is optimised, is asked too.

use glam::DVec2;
use mapd_archive::{encode, verify};
use mapd_compiler::{CompileOptions, compile};
use mapd_query::Bounds;
use mapd_query::route::{PositionOnLane, RouteScratch, ShortestTime};
use mapd_query::vocabulary::{ClassSet, VehicleClass};
use mapd_query::{LaneTypes, Map, NearestOptions, Region, Track};
use mapd_tests::ends;
use std::fmt::Write as _;

/// Map, kind, and the first bytes of the BLAKE3 of its answers.
const GOLDEN: &[(&str, [&str; KINDS.len()])] = &[
    (
        "one_road.xodr",
        [
            "438ae64916302913",
            "b4cde566b29d2246",
            "d296597475f40b70",
            "aa5b17d66c34625b",
            "af1349b9f5f9a1a6",
            "4d56ea031cd7a25d",
        ],
    ),
    (
        "town.xodr",
        [
            "214a781b49bdcbf8",
            "ea45a951299e9bc2",
            "edcb7b065e8583e9",
            "609bc47775016277",
            "af1349b9f5f9a1a6",
            "f3a308bebbc1575c",
        ],
    ),
    (
        "surfaces.xodr",
        [
            "2dc1f054347cda5c",
            "93bd04da74df0c3e",
            "6bff64d18e36a482",
            "69ee5a1897b71992",
            "af1349b9f5f9a1a6",
            "a5f54efeafebef32",
        ],
    ),
    (
        "marks.xodr",
        [
            "5dfc80bc69c42a68",
            "8aae19178facaf15",
            "ee7ebc9d5f479959",
            "1611a4174ad06395",
            "af1349b9f5f9a1a6",
            "912e7aa43a4e9eb9",
        ],
    ),
    (
        "objects.xodr",
        [
            "61041615f94eeb68",
            "b96c7f73591905e1",
            "fb8d9197c3cb5fbf",
            "8ab011414d459c6a",
            "5da30f47a88e9cd8",
            "912e7aa43a4e9eb9",
        ],
    ),
];

/// A kind of question, and what asks it of a map.
type Kind = (&'static str, fn(Map<'_>) -> String);

/// What is asked.
const KINDS: [Kind; 6] = [
    ("nearest", nearest),
    ("roads", roads),
    ("lanes", lanes),
    ("bounds", bounds),
    ("objects", objects),
    ("routes", routes),
];

/// Places of a grid over the map along each axis.
const GRID: u32 = 24;

fn places(map: Map<'_>) -> impl Iterator<Item = DVec2> {
    let Bounds { low, high } = map.bounds();
    let (low, size) = (low.truncate() - 5.0, (high - low).truncate() + 10.0);
    let share = |i: u32| f64::from(i) / f64::from(GRID);
    (0..=GRID)
        .flat_map(move |i| (0..=GRID).map(move |j| low + DVec2::new(share(i), share(j)) * size))
}

/// Stations of a stretch, its ends among them.
fn stations((from, to): (f64, f64)) -> impl Iterator<Item = f64> {
    (0..=7).map(move |i| from + (to - from) * (f64::from(i) / 7.0))
}

fn nearest(map: Map<'_>) -> String {
    let options = NearestOptions { radius: 50.0, ..NearestOptions::default() };
    let mut out = String::new();
    for place in places(map) {
        let found = map.nearest_lane(place, &options).expect("an answer");
        let said = found.map(|found| {
            let lane = map.lane(found.lane).expect("a lane");
            (lane.key().to_string(), found.position, lane.position_of(place))
        });
        let _ = writeln!(out, "{said:?}");
    }
    out
}

fn roads(map: Map<'_>) -> String {
    let mut out = String::new();
    for road in map.roads() {
        for s in stations((0.0, road.length())) {
            for t in [-7.3, -1.7, 0.0, 2.9] {
                let surface = road.surface_at(s, t).map(|at| (at.position, at.normal));
                let _ = writeln!(out, "{:?} {surface:?}", road.to_inertial(Track { s, t, h: 0.3 }));
            }
        }
        for place in places(map).step_by(37) {
            let _ = writeln!(out, "{:?}", road.to_track(place));
        }
    }
    for junction in map.junctions() {
        for place in places(map).step_by(11) {
            let _ = writeln!(
                out,
                "{:?}",
                junction.grid_height_at(place).map(|at| (at.height, at.slope))
            );
        }
    }
    out
}

fn lanes(map: Map<'_>) -> String {
    let mut out = String::new();
    for section in map.roads().flat_map(|road| road.sections()) {
        for lane in section.lanes().filter(|lane| lane.number() != 0) {
            for s in stations((section.s_start(), section.s_end())) {
                let (pose, waypoint) = (lane.pose_at(s, 0.4), lane.waypoint_at(s));
                let length = lane.length_between(section.s_start(), s);
                let heights = lane.height_at(s);
                let _ = writeln!(
                    out,
                    "{pose:?} {waypoint:?} {length:?} {heights:?} {:?}",
                    lane.edges_at(s)
                );
            }
            for mark in lane.road_marks() {
                let _ = writeln!(out, "{:?} {:?}", mark.s(), mark.t_at(mark.s()));
            }
            for conflict in lane.conflicts() {
                let _ = writeln!(
                    out,
                    "{:?} {:?}",
                    ends(conflict.s_range()),
                    ends(conflict.other_range())
                );
            }
        }
    }
    out
}

fn bounds(map: Map<'_>) -> String {
    let mut out = format!("{:?}", (map.bounds().low, map.bounds().high));
    for lane in map.lanes() {
        for bound in [lane.left_bound(), lane.right_bound()] {
            bound.positions().for_each(|position| {
                let _ = write!(out, "{position:?}");
            });
        }
    }
    let region = Region::around(places(map).nth(100).expect("a place"), 40.0);
    let (mut lanes, mut segments) = (Vec::new(), Vec::new());
    map.boundary_segments(region, LaneTypes::ALL, &mut lanes, &mut segments).expect("an answer");
    for segment in segments {
        let _ = write!(out, "{:?} {:?}", segment.s, segment.ends);
    }
    out
}

fn objects(map: Map<'_>) -> String {
    let (mut out, mut near, mut landmarks) = (String::new(), Vec::new(), Vec::new());
    let mut corners = Vec::new();
    for place in places(map).step_by(5) {
        map.objects_near(place, 60.0, &mut near).expect("an answer");
        for found in &near {
            let placement = map.placement(found.place).expect("a place");
            placement.footprint(&mut corners);
            let _ =
                writeln!(out, "{:?} {:?} {corners:?}", found.distance, placement.distance(place));
        }
        map.landmarks_near(place, 60.0, ClassSet::ALL, &mut landmarks).expect("an answer");
        for landmark in &landmarks {
            let _ = writeln!(out, "{:?} {:?}", landmark.position, landmark.heading);
        }
    }
    out
}

fn routes(map: Map<'_>) -> String {
    let (mut out, mut steps) = (String::new(), Vec::new());
    let mut scratch = RouteScratch::default();
    let lanes: Vec<_> = map.lanes().filter(|lane| lane.number() != 0).collect();
    for (i, from) in lanes.iter().enumerate().step_by(5) {
        let to = &lanes[(i * 7 + 3) % lanes.len()];
        let [from, to] = [from, to].map(|lane| PositionOnLane { lane: lane.lane_id(), s: 1.0 });
        let (car, cost) = (VehicleClass::PassengerCar, ShortestTime::default());
        let route = map.route(from, to, car, &cost, &mut scratch, &mut steps).expect("an answer");
        let ends = steps.iter().map(|step| (step.s_from, step.s_to)).collect::<Vec<_>>();
        let _ =
            writeln!(out, "{:?} {ends:?}", route.map(|route| (route.length, route.travel_time)));
    }
    out
}

fn answers(name: &str) -> [String; KINDS.len()] {
    let file = std::fs::File::open(mapd_tests::carried(name)).expect("the map can be read");
    let compiled = compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
    let bytes = encode(&compiled.rows.expect("accepted"), &compiled.provenance).expect("encodes");
    let archive = verify(&bytes).expect("sound");
    KINDS.map(|(kind, ask)| {
        let said = ask(Map::new(&archive, 0));
        assert!(!said.contains("NaN"), "{name}, {kind}");
        assert!(!said.is_empty() || (kind, name) != ("objects", "objects.xodr"), "{name}, {kind}");
        blake3::hash(said.as_bytes()).to_hex()[..16].to_owned()
    })
}

#[test]
fn golden_answers() {
    let maps = ["one_road.xodr", "town.xodr", "surfaces.xodr", "marks.xodr", "objects.xodr"];
    let found = maps.map(|name| (name, answers(name)));
    let found = found.iter().map(|(name, hashes)| (*name, hashes.each_ref().map(String::as_str)));
    assert_eq!(found.collect::<Vec<_>>(), GOLDEN, "other answers than before");
}
