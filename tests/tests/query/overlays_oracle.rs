//! A view over a plain map answers as a map with the same written into its OpenDRIVE.

use crate::overlays_same_ways::{BEYOND_THE_LANE, Measure, are_same, compare_path};
use mapd_archive::open_overlay;
use mapd_client::Snapshot;
use mapd_query::route::{
    PositionOnLane, RouteCost, RouteScratch, RouteStep, ShortestLength, ShortestTime,
};
use mapd_query::view::View;
use mapd_query::vocabulary::VehicleClass;
use mapd_query::{Lane, Map};
use mapd_tests::maps::{Random, open};
use mapd_tests::overlays::{Stretch, over, places as places_of, write_at};
use mapd_tests::town::town;
use mapd_tests::{say, shared};
use std::time::UNIX_EPOCH;

const CAR: VehicleClass = VehicleClass::PassengerCar;

/// Stretches that are restricted on each map.
const STRETCHES: usize = 170;
/// Closures that are compared on a map, at least; with those of the small one a thousand over all maps.
const LEAST_CLOSURES: usize = 180;
/// The same of a map of few lanes.
const LEAST_CLOSURES_SMALL: usize = 100;
/// Pairs of places on each map.
const PAIRS: usize = 400;
/// Costs may differ by what single precision leaves of lengths and times of pieces, in proportion.
const ROUNDING: f64 = 2e-5;

fn stretches(map: Map<'_>, speeds: [f64; 2], random: &mut Random) -> Vec<Stretch> {
    let driven = |lane: &Lane<'_>| {
        let section = lane.section();
        lane.nodes().any(|node| node.allows(CAR)) && section.s_end() - section.s_start() > 3.0
    };
    let lanes: Vec<Lane<'_>> = map.lanes().filter(driven).collect();
    let mut found: Vec<Stretch> = Vec::new();
    for _ in 0..10 * STRETCHES {
        let lane = &lanes[(random.unit() * lanes.len() as f64) as usize];
        let (section, road) = (lane.section(), lane.road());
        let (start, end) = (section.s_start(), section.s_end());
        let from = random.between(start, end - 1.0);
        let to = if random.unit() < 0.3 { end } else { random.between(from + 0.5, end) };
        let from = if random.unit() < 0.3 { start } else { from };
        let key = lane.key();
        let known = |other: &Stretch| {
            (other.road.as_str(), other.section, other.lane)
                == (road.id(), key.section as usize, key.lane)
        };
        // A record in the text would hold on in pieces beside sections of one side.
        if found.iter().any(known) || lane.continues() || found.len() >= STRETCHES {
            continue;
        }
        let speed = (random.unit() < 0.4).then(|| random.between(speeds[0], speeds[1]));
        // A record of speed does not cut a compiled lane: its first and last piece cost in proportion to their lengths.
        let (from, to) = if speed.is_some() { (start, end) } else { (from, to) };
        found.push(Stretch {
            road: road.id().to_owned(),
            section: key.section as usize,
            lane: key.lane,
            s: [from, to],
            start,
            speed,
        });
    }
    found
}

/// A map that is written out, with parts in quarantine if need be.
fn open_text(text: &str) -> Snapshot {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("map.xodr");
    std::fs::write(&path, text).expect("written");
    open(&path)
}

/// The same lane in a map with other content.
fn there<'a>(map: Map<'a>, lane: &Lane<'_>) -> Lane<'a> {
    map.lane_by_key(&lane.key()).expect("the same lanes")
}

/// Compares a map with random stretches written into it; speeds from one limit to another `[m/s]`. How many of them are closed.
fn check(name: &str, (text, plain): (&str, &Snapshot), (speeds, seed): ([f64; 2], u64)) -> usize {
    let map = plain.map();
    let mut random = Random(seed);
    let stretches = stretches(map, speeds, &mut random);
    let places = places_of(&stretches, text);
    let (kept, records): (Vec<Stretch>, Vec<(usize, String)>) = stretches
        .into_iter()
        .zip(places)
        .filter_map(|(stretch, at)| {
            let records = stretch.records();
            Some((stretch, (at?, records)))
        })
        .unzip();
    let written = write_at(text, records);
    let entries: Vec<String> = kept.iter().enumerate().map(|(i, s)| s.entry(i)).collect();
    let document = format!(r#"{{"entries":[{}]}}"#, entries.join(","));
    let (bytes, resolved) = over(map, &document, true);
    assert_eq!(resolved.unplaced, [], "{name}");
    let overlay = open_overlay(&bytes).expect("opens");
    let view = View::new(map, Some(&overlay), UNIX_EPOCH).expect("its own");
    let compiled = open_text(&written);
    let closed = kept.iter().filter(|stretch| stretch.speed.is_none()).count();
    say(&format!("{name}: {} stretches, {closed} of them closed", kept.len()));
    assert!(kept.len() > 10, "{name}: nothing to compare");
    compare(name, view, &compiled, &kept, &mut random);
    closed
}

/// Compares a view with a map of the same content as text.
fn compare(name: &str, view: View<'_>, compiled: &Snapshot, kept: &[Stretch], random: &mut Random) {
    places(view, compiled, kept, random);
    let (length, time) = (ShortestLength::default(), ShortestTime::default());
    let by_length = Measure { by_time: false, lane_change: length.lane_change };
    let by_time = Measure { by_time: true, lane_change: time.lane_change };
    let [found, same] = [
        routes(view, compiled, (&length, by_length), kept, random),
        routes(view, compiled, (&time, by_time), kept, random),
    ]
    .iter()
    .fold([0, 0], |[found, same], own| [found + own[0], same + own[1]]);
    say(&format!(
        "{name}: {found} pairs have a way, {} of them another that costs the same",
        found - same
    ));
    assert!(found > PAIRS / 80, "{name}: {found} pairs have a way");
}

/// Compares a map in which random stretches are closed for these vehicles, and opened for cars by an overlay, with one in which cars may use them.
fn check_opened(name: &str, (text, plain): (&str, &Snapshot), closed_for: &[&str]) {
    let mut random = Random(7);
    let stretches = stretches(plain.map(), SLOWER.0, &mut random);
    let places = places_of(&stretches, text);
    let (mut closed, mut open, mut kept) = (Vec::new(), Vec::new(), Vec::new());
    for (stretch, at) in stretches.into_iter().zip(places) {
        let stretch = Stretch { speed: None, ..stretch };
        let road = plain.map().road_by_id(&stretch.road).expect("the road");
        let section = road.section(stretch.section as u32).expect("the section");
        let lane = section.lane(stretch.lane).expect("the lane");
        // What the file itself closes would be opened, too.
        let Some(at) = at.filter(|_| lane.nodes().all(|node| node.allows(CAR))) else { continue };
        // What is open for cars is cut where what is closed is.
        closed.push((at, stretch.denials(closed_for)));
        open.push((at, stretch.denials(&["truck"])));
        kept.push(stretch);
    }
    let [closed, open] = [closed, open].map(|records| write_at(text, records));
    let plain = open_text(&closed);
    let map = plain.map();
    let entries: Vec<String> = kept.iter().enumerate().map(|(i, s)| s.opening(i)).collect();
    let document = format!(r#"{{"entries":[{}]}}"#, entries.join(","));
    let (bytes, resolved) = over(map, &document, true);
    assert_eq!(resolved.unplaced, [], "{name}");
    let overlay = open_overlay(&bytes).expect("opens");
    let view = View::new(map, Some(&overlay), UNIX_EPOCH).expect("its own");
    say(&format!("{name}: {} stretches opened", kept.len()));
    assert!(kept.len() > 10, "{name}: nothing to compare");
    for stretch in &kept {
        let road = map.road_by_id(&stretch.road).expect("the road");
        let section = road.section(stretch.section as u32).expect("the section");
        let lane = section.lane(stretch.lane).expect("the lane");
        let middle = 0.5 * (stretch.s[0] + stretch.s[1]);
        assert!(!lane.allows_at(middle, CAR), "{name}: {stretch:?}");
        let today = view.allows(lane.lane_id(), middle, CAR).expect("an answer");
        assert!(today.is_allowed && today.restriction.is_some(), "{name}: {stretch:?} {today:?}");
    }
    compare(name, view, &open_text(&open), &kept, &mut random);
}

/// Classes for which landmarks are made: without them a lane has no bounds.
fn motor() -> Vec<&'static str> {
    let classes = VehicleClass::ALL.iter();
    let motor = classes.filter(|class| class.bit() & VehicleClass::MOTOR != 0);
    motor.map(|class| class.name()).collect()
}

/// Permissions and limits, at places of restricted lanes that are not at a cut.
fn places(view: View<'_>, compiled: &Snapshot, kept: &[Stretch], random: &mut Random) {
    let other = compiled.map();
    for stretch in kept {
        let road = view.map().road_by_id(&stretch.road).expect("the road");
        let section = road.section(stretch.section as u32).expect("the section");
        let lane = section.lane(stretch.lane).expect("the lane");
        for _ in 0..10 {
            let s = random.between(section.s_start(), section.s_end());
            let near = |end: f64| (s - end).abs() < 0.11;
            if stretch.s.iter().any(|end| near(*end))
                || near(section.s_start())
                || near(section.s_end())
            {
                continue;
            }
            let today = view.allows(lane.lane_id(), s, CAR).expect("an answer");
            let expected = there(other, &lane).allows_at(s, CAR);
            assert_eq!(today.is_allowed, expected, "{stretch:?} at {s}: {today:?}");
            let today = view.speed_rule_at(lane.lane_id(), s, CAR).expect("an answer");
            let expected = there(other, &lane).speed_rule_at(s);
            if !BEYOND_THE_LANE.contains(&expected.origin) {
                assert_eq!(today.max, expected.max, "{stretch:?} at {s}: {today:?} {expected:?}");
            }
        }
    }
}

/// Compares routes between random places and places beside restricted stretches, and what is said along those of either map without the other's entries; how many pairs
/// have a way, and how many the same one on both.
fn routes(
    view: View<'_>,
    compiled: &Snapshot,
    (cost, measure): (&impl RouteCost, Measure),
    kept: &[Stretch],
    random: &mut Random,
) -> [usize; 2] {
    let (map, other) = (view.map(), compiled.map());
    let lanes: Vec<Lane<'_>> =
        map.lanes().filter(|lane| lane.nodes().any(|node| node.allows(CAR))).collect();
    let place = |random: &mut Random| {
        if random.unit() < 0.4 {
            let stretch = &kept[(random.unit() * kept.len() as f64) as usize];
            let road = map.road_by_id(&stretch.road).expect("the road");
            let section = road.section(stretch.section as u32).expect("the section");
            let lane = section.lane(stretch.lane).expect("the lane");
            return (lane, random.between(section.s_start(), section.s_end()));
        }
        let lane = lanes[(random.unit() * lanes.len() as f64) as usize];
        (lane, random.between(lane.section().s_start(), lane.section().s_end()))
    };
    let mut scratch = RouteScratch::default();
    let (mut steps, mut expected_steps, mut found, mut same) = (Vec::new(), Vec::new(), 0, 0);
    for _ in 0..PAIRS {
        let ((a, s_a), (b, s_b)) = (place(random), place(random));
        let at = |lane: &Lane<'_>, s| PositionOnLane { lane: lane.lane_id(), s };
        let route = view
            .route(at(&a, s_a), at(&b, s_b), CAR, cost, &mut scratch, &mut steps)
            .expect("an answer");
        let (a2, b2) = (there(other, &a), there(other, &b));
        let expected = other
            .route(at(&a2, s_a), at(&b2, s_b), CAR, cost, &mut scratch, &mut expected_steps)
            .expect("an answer");
        let what = format!("{} {s_a} to {} {s_b}", a.key(), b.key());
        match (route, expected) {
            (Some(route), Some(expected)) => {
                let off = (route.cost - expected.cost).abs();
                assert!(
                    off <= ROUNDING * (1.0 + expected.cost),
                    "{what}: {route:?} {expected:?}\n{:?}\n{:?}",
                    named(map, &steps),
                    named(other, &expected_steps)
                );
                let there = (other, &expected_steps[..]);
                if are_same((view, &steps), there, (measure, kept), &what) {
                    compare_path((view, &steps), (other, Some(&expected_steps)), kept);
                    same += 1;
                }
                found += 1;
            }
            (None, None) => {}
            (route, expected) => panic!(
                "{what}: {route:?}, expected {expected:?}\n{:?}\n{kept:?}",
                named(map, &steps)
            ),
        }
        // The way as if nothing were said leads through what is closed.
        let plain = map.route(at(&a, s_a), at(&b, s_b), CAR, cost, &mut scratch, &mut steps);
        if plain.expect("an answer").is_some() {
            compare_path((view, &steps), (other, None), kept);
        }
    }
    [found, same]
}

/// Closed, and slower than any road; and where.
const SLOWER: ([f64; 2], u64) = ([1.0, 4.0], 5);
/// Closed, and slower or faster; elsewhere.
const FASTER: ([f64; 2], u64) = ([4.0, 40.0], 6);

/// Steps by the names of their lanes.
fn named(map: Map<'_>, steps: &[RouteStep]) -> Vec<String> {
    let name = |step: &RouteStep| {
        let key = map.lane(step.lane).expect("a lane").key();
        format!("{key} {:?} {:.3} {:.3}", step.enter, step.s_from, step.s_to)
    };
    steps.iter().map(name).collect()
}

/// Compares a map with closures, slower and faster stretches, and openings.
fn check_all(name: &str, text: &str, least_closures: usize) {
    let plain = open_text(text);
    let map = (text, &plain);
    check_opened(name, map, &["passengerCar"]);
    check_opened(name, map, &motor());
    let closures = check(name, map, SLOWER) + check(name, map, FASTER);
    assert!(closures >= least_closures, "{name}: {closures} closures");
}

/// The same of a map of the shared corpus.
fn check_shared(name: &str, least_closures: usize) {
    let Some(folder) = shared("maps") else {
        return say("SKIPPED: no shared corpus beside the workspace");
    };
    let text = std::fs::read_to_string(folder.join(name)).expect("a map");
    check_all(name, &text, least_closures);
}

#[test]
fn a_generated_town() {
    check_all("town", &town(7, 6), LEAST_CLOSURES);
}

#[test]
fn a_town_of_many_lanes() {
    check_shared("carla/Town05.xodr", LEAST_CLOSURES);
}

#[test]
fn a_town_with_a_roundabout() {
    check_shared("carla/Town03.xodr", LEAST_CLOSURES);
}

#[test]
fn a_town_center() {
    check_shared("Scenic/Town10HD.xodr", LEAST_CLOSURES);
}

#[test]
fn a_motorway() {
    check_shared("SMARTS/od_newmarket_map.xodr", LEAST_CLOSURES);
}

#[test]
fn crossings_of_many_arms() {
    check_shared("esmini/multi_intersections.xodr", LEAST_CLOSURES_SMALL);
}
