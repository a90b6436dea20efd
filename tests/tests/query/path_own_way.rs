//! What of the lanes that meet a path is its own way, and what others drive on.

use crate::path_meets::lane_by;
use mapd_client::Map;
use mapd_client::route::{Enter, RouteScratch, RouteStep};
use mapd_client::vocabulary::VehicleClass;
use mapd_query::path::{ConflictLane, PathBuffer, PathOptions};
use mapd_query::route::{PositionOnLane, ShortestLength};
use mapd_tests::carried;
use mapd_tests::graph_maps::all;
use mapd_tests::maps::{open, open_text};

const CAR: VehicleClass = VehicleClass::PassengerCar;

fn route(map: Map<'_>, ends: [(&str, f64); 2]) -> Vec<RouteStep> {
    let [from, to] = ends.map(|(key, s)| PositionOnLane { lane: lane_by(map, key).lane_id(), s });
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let cost = ShortestLength::default();
    let found = map.route(from, to, CAR, &cost, &mut scratch, &mut steps);
    found.expect("an answer").expect("a route");
    steps
}

fn conflicts(map: Map<'_>, steps: &[RouteStep]) -> Vec<ConflictLane> {
    let (mut buffer, mut together, mut found) = (PathBuffer::default(), Vec::new(), Vec::new());
    let path = map.path(steps, &PathOptions::default(), &mut buffer).expect("a path");
    path.conflicts(&mut together, &mut found);
    found
}

/// Keys of the lanes that meet a route, in order.
fn meets(map: Map<'_>, ends: [(&str, f64); 2]) -> Vec<String> {
    let key = |one: &ConflictLane| map.lane(one.other).expect("a lane").key().to_string();
    let mut keys: Vec<String> = conflicts(map, &route(map, ends)).iter().map(key).collect();
    keys.sort();
    keys
}

fn are_same(one: &[ConflictLane], two: &[ConflictLane]) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() < 1e-6;
    let same = |(a, b): (&ConflictLane, &ConflictLane)| {
        (a.other, a.kind, a.yields) == (b.other, b.kind, b.yields)
            && near(a.along[0], b.along[0])
            && near(a.along[1], b.along[1])
            && near(a.wait, b.wait)
    };
    one.len() == two.len() && one.iter().zip(two).all(same)
}

/// A route over a crossing and back over it: what meets it the first time does not depend on where it goes afterwards.
#[test]
fn a_lane_that_is_driven_at_another_time_is_met() {
    let snapshot = open(&carried("town.xodr"));
    let map = snapshot.map();
    let once = route(map, [("8:0:1", 38.0), ("6:0:1", 38.0)]);
    let back = route(map, [("8:0:1", 38.0), ("8:0:-1", 38.0)]);
    assert!(once.len() < back.len() && once[..2] == back[..2], "{once:?}, {back:?}");
    let (mut first, mut all) = (conflicts(map, &once), conflicts(map, &back));
    let driven = |one: &&ConflictLane| back.iter().any(|step| step.lane == one.other);
    assert!(first.iter().filter(driven).count() > 0, "none of the way back: {first:?}");
    // Behind this S lies the crossing.
    let is_there = |one: &ConflictLane| one.along[1] < 80.0;
    first.retain(is_there);
    all.retain(is_there);
    assert!(are_same(&first, &all), "{first:?}, {all:?}");
}

/// A place on the way cuts a step, and no conflict.
#[test]
fn steps_on_one_lane_are_one() {
    let snapshot = open(&carried("town.xodr"));
    let map = snapshot.map();
    let mut seen = 0;
    for ends in [[("4:0:-1", 38.0), ("9:0:-1", 38.0)], [("8:0:1", 38.0), ("8:0:-1", 38.0)]] {
        let steps = route(map, ends);
        let halves = |step: &RouteStep| {
            let middle = 0.5 * (step.s_from + step.s_to);
            let first = RouteStep { s_to: middle, ..*step };
            let enter = Enter::Ahead;
            [first, RouteStep { enter, s_from: middle, s_latest: middle, ..*step }]
        };
        let cut: Vec<RouteStep> = steps.iter().flat_map(halves).collect();
        let (whole, found) = (conflicts(map, &steps), conflicts(map, &cut));
        assert!(are_same(&whole, &found), "{whole:?}, {found:?}");
        seen += whole.len();
    }
    assert!(seen > 0, "no conflict");
}

/// Who joins the main road of a virtual junction meets those who are on it; who leaves it, nobody.
#[test]
fn who_joins_a_main_road_meets_its_traffic() {
    let map = all().into_iter().find(|one| one.name == "virtual junction with a side road");
    let snapshot = open_text(&map.expect("the map").text);
    let map = snapshot.map();
    let joins = meets(map, [("2:0:1", 20.0), ("1:0:-1", 100.0)]);
    assert_eq!(joins, ["1:0:-1"]);
    let leaves = meets(map, [("1:0:-1", 10.0), ("2:0:-1", 20.0)]);
    assert!(leaves.is_empty(), "{leaves:?}");
    let goes_on = meets(map, [("1:0:-1", 10.0), ("1:0:-1", 100.0)]);
    assert!(goes_on.contains(&"6:0:-1".to_owned()), "{goes_on:?}");
}
