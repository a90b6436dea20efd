//! A path on another version of its map.

use crate::path_meets::lane_by;
use crate::paths::{each_path, each_path_of};
use mapd_client::Map;
use mapd_client::route::{Enter, RouteScratch, RouteStep, ShortestLength, WithFactors};
use mapd_client::vocabulary::VehicleClass;
use mapd_query::path::{Path, PathBuffer, PathChange, PathChangeKind, PathOptions, steps_of_lanes};
use mapd_tests::graph_maps::{Line, document, lane, link, road, section};
use mapd_tests::maps::open_text;
use mapd_tests::{carried, say, shared};
use std::cell::Cell;

const CAR: VehicleClass = VehicleClass::PassengerCar;
/// Lengths and places may differ by this `[m]`.
const ROUNDING: f64 = 1e-6;

/// Whether a path's lanes are open: a start may lie on one that is closed to the vehicle.
fn is_open(map: Map<'_>, path: &Path<'_, '_>) -> bool {
    path.lanes().all(|own| {
        let lane = map.lane(own.lane).expect("a lane");
        own.s.iter().all(|s| lane.node_at(*s, own.forward).is_some_and(|n| n.allows(CAR)))
    })
}

/// A path on another map has its own steps, to the bit, and the route says what they are.
fn keeps_its_steps(path: &Path<'_, '_>, own: &[RouteStep], [old, new]: [Map<'_>; 2], name: &str) {
    let (mut scratch, mut steps, mut changes) = (RouteScratch::default(), Vec::new(), Vec::new());
    let cost = ShortestLength::default();
    let found = path.rebase(new, CAR, &cost, &mut scratch, &mut steps, &mut changes);
    let route = found.expect("an answer").unwrap_or_else(|| panic!("{name}: no way"));
    assert_eq!(changes, [], "{name}");
    let by_key = |map: Map<'_>, steps: &[RouteStep]| -> Vec<(String, RouteStep)> {
        let none = own[0].lane;
        let key = |step: &RouteStep| map.lane(step.lane).expect("a lane").key().to_string();
        steps.iter().map(|step| (key(step), RouteStep { lane: none, ..*step })).collect()
    };
    assert_eq!(by_key(new, &steps), by_key(old, own), "{name}");
    let changes = own.iter().filter(|step| matches!(step.enter, Enter::Left | Enter::Right));
    assert_eq!(route.lane_changes as usize, changes.count(), "{name}");
    let off = (route.length - path.length()).abs();
    assert!(off < 1e-3 * (1.0 + route.length), "{name}: {off} of {route:?}");
    let off = route.cost - (route.length + cost.lane_change * f64::from(route.lane_changes));
    assert!(off.abs() < 1e-3 * (1.0 + route.length), "{name}: {off} of {route:?}");
}

/// On the map that it is of, nothing of a path changes: not where it changes lanes, either, and for how long it may.
#[test]
fn a_path_on_its_own_map_is_the_same() {
    let kept = Cell::new(0);
    each_path(|map, path, own, name, _| {
        if is_open(map, path) {
            keeps_its_steps(path, own, [map, map], name);
            kept.set(kept.get() + 1);
        }
    });
    say(&format!("{} paths", kept.get()));
    assert!(kept.get() > 10);
}

/// Nor on the next version of its map, which has one road more, so that all lanes have other rows.
#[test]
fn a_path_is_the_same_where_the_map_changes_elsewhere() {
    let more = |file: &std::path::Path| {
        let text = std::fs::read_to_string(file).expect("a file");
        let lanes = section(0.0, "", &lane(-1, ""));
        let road =
            road("a new one", "junction=\"-1\"", Line(-9e3, 0.0, 0.0, 50.0, 0.0), "", &lanes);
        open_text(&text.replacen("<road ", &format!("{road}<road "), 1))
    };
    let mut files = vec![carried("town.xodr")];
    files.extend(shared("maps").map(|maps| maps.join("carla/Town05.xodr")));
    for file in files {
        let new = more(&file);
        each_path_of(vec![file], 40, &PathOptions::default(), |map, path, own, name, _| {
            if is_open(map, path) {
                keeps_its_steps(path, own, [map, new.map()], name);
            }
        });
    }
}

/// A road of another id in the old one's place, one that has moved, and none at all.
#[test]
fn a_path_is_found_again_by_key_then_by_place() {
    let text = |id: &str, y: f64| {
        let line = Line(0.0, y, 0.0, 100.0, 0.0);
        document(&road(id, "junction=\"-1\"", line, "", &section(0.0, "", &lane(-1, ""))))
    };
    let (old, mut steps, mut buffer) =
        (open_text(&text("1", 0.0)), Vec::new(), PathBuffer::default());
    let lane = lane_by(old.map(), "1:0:-1").lane_id();
    steps_of_lanes(old.map(), &[lane], [10.0, 90.0], &mut steps).expect("steps");
    let path = old.map().path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    let check = |text: &str, expected: Option<PathChangeKind>, length: Option<f64>| {
        let new = open_text(text);
        let (mut scratch, mut steps, mut changes) =
            (RouteScratch::default(), Vec::new(), Vec::new());
        let cost = ShortestLength::default();
        let found = path.rebase(new.map(), CAR, &cost, &mut scratch, &mut steps, &mut changes);
        assert_eq!(found.expect("an answer").map(|route| route.length), length);
        let kinds: Vec<PathChange> = changes;
        let expected = expected.map(|kind| PathChange { along: [0.0, 80.0], kind });
        assert_eq!(kinds, expected.into_iter().collect::<Vec<_>>());
        assert_eq!(steps.len(), usize::from(length.is_some()), "{steps:?}");
    };
    check(&text("1", 0.0), None, Some(80.0));
    check(&text("1", 0.5), Some(PathChangeKind::Moved(0.5)), Some(80.0));
    check(&text("7", 0.0), Some(PathChangeKind::Replaced(0.0)), Some(80.0));
    check(&text("1", 40.0), Some(PathChangeKind::Gone), None);
    // A cost that closes the lane closes it for the path, too.
    let closed = WithFactors { base: ShortestLength::default(), factors: &[f64::INFINITY; 4] };
    let (mut scratch, mut steps, mut changes) = (RouteScratch::default(), Vec::new(), Vec::new());
    let found = path.rebase(old.map(), CAR, &closed, &mut scratch, &mut steps, &mut changes);
    assert_eq!((found.expect("an answer"), steps), (None, Vec::new()));
}

/// Three roads one after the other: what has become of each is told on its own stretch.
#[test]
fn a_path_over_three_roads_is_found_again_road_by_road() {
    // Ids, how far the middle one lies aside, and whether it is there.
    let text = |ids: [&str; 3], aside: f64, middle: bool| {
        let one = |i: usize, y: f64, links: &str, lanes: &str| {
            let line = Line(100.0 * i as f64, y, 0.0, 100.0, 0.0);
            road(ids[i], "junction=\"-1\"", line, links, &section(0.0, "", &lane(-1, lanes)))
        };
        let to = |i: usize| link(&format!("s road {} start", ids[i]));
        let from = |i: usize| link(&format!("p road {} end", ids[i]));
        let first = one(
            0,
            0.0,
            &if middle { to(1) } else { String::new() },
            if middle { "s-1" } else { "" },
        );
        let second = one(1, aside, &(from(0) + &to(2)), "p-1 s-1");
        let last = one(
            2,
            0.0,
            &if middle { from(1) } else { String::new() },
            if middle { "p-1" } else { "" },
        );
        document(&(first + &if middle { second } else { String::new() } + &last))
    };
    let old = open_text(&text(["1", "2", "3"], 0.0, true));
    let ids = ["1:0:-1", "2:0:-1", "3:0:-1"].map(|key| lane_by(old.map(), key).lane_id());
    let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
    steps_of_lanes(old.map(), &ids, [10.0, 90.0], &mut steps).expect("steps");
    let path = old.map().path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    let stretches = [[0.0, 90.0], [90.0, 190.0], [190.0, 280.0]];
    let check = |text: &str, expected: [Option<PathChangeKind>; 3], length: Option<f64>| {
        let new = open_text(text);
        let (mut scratch, mut steps, mut changes) =
            (RouteScratch::default(), Vec::new(), Vec::new());
        let cost = ShortestLength::default();
        let found = path.rebase(new.map(), CAR, &cost, &mut scratch, &mut steps, &mut changes);
        let route = found.expect("an answer");
        let off = route.map(|route| route.length).zip(length).map(|(a, b)| (a - b).abs());
        assert_eq!(route.is_some(), length.is_some(), "{changes:?}");
        assert!(off.is_none_or(|off| off < ROUNDING), "{route:?}");
        let told = stretches.into_iter().zip(expected);
        let told = told.filter_map(|(along, kind)| Some(PathChange { along, kind: kind? }));
        assert_eq!(changes, told.collect::<Vec<_>>());
        if length.is_some() {
            assert_eq!(steps.len(), 3, "{steps:?}");
            let mut buffer = PathBuffer::default();
            let again =
                new.map().path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
            assert!((again.length() - path.length()).abs() < ROUNDING);
        }
    };
    let (moved, replaced, gone) =
        (PathChangeKind::Moved(0.5), PathChangeKind::Replaced(0.0), PathChangeKind::Gone);
    check(&text(["1", "2", "3"], 0.0, true), [None; 3], Some(280.0));
    check(&text(["1", "2", "3"], 0.5, true), [None, Some(moved), None], Some(280.0));
    check(&text(["1", "2", "9"], 0.0, true), [None, None, Some(replaced)], Some(280.0));
    check(&text(["1", "8", "9"], 0.0, true), [None, Some(replaced), Some(replaced)], Some(280.0));
    check(&text(["1", "2", "3"], 0.0, false), [None, Some(gone), None], None);
}
