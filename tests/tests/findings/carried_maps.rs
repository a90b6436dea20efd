//! The carried maps that generators write are what those write. The quarter shows what a map can have, and no profile finds anything in it.

use mapd_client::route::{PositionOnLane, RouteScratch, ShortestLength};
use mapd_client::vocabulary::{Class, VehicleClass};
use mapd_compiler::{ReadOptions, check_from};
use mapd_rules::{Profile, Settings};
use mapd_tests::{carried, maps, quarter, town};
use std::collections::BTreeSet;

/// The quarter's largest size [bytes].
const LARGEST: usize = 400_000;

#[test]
fn generated_maps_are_what_their_generators_write() {
    for (name, text) in [("town", town::town(3, 3)), ("quarter", quarter::quarter())] {
        let found = std::fs::read_to_string(carried(&format!("{name}.xodr"))).expect("readable");
        assert!(
            found == text,
            "run `cargo run -p mapd-tests --bin make_map {name} > examples/maps/{name}.xodr`"
        );
    }
}

#[test]
fn no_profile_finds_anything_in_the_quarter() {
    let text = quarter::quarter();
    assert!(text.len() <= LARGEST, "{}", text.len());
    for profile in [Profile::Default, Profile::Strict, Profile::Asam] {
        let reading = ReadOptions {
            rules: Settings { profile, ..Settings::default() },
            ..ReadOptions::default()
        };
        let checked = check_from(|| Ok(text.as_bytes()), &reading, &mut |_| {}).expect("reads");
        assert!(checked.diagnostics.is_empty(), "{profile:?}: {:?}", checked.diagnostics);
    }
}

#[test]
fn the_quarter_has_what_a_map_can_have() {
    let snapshot = maps::open(&carried("quarter.xodr"));
    let map = snapshot.map();
    let signals: BTreeSet<_> = map.signals().map(|signal| signal.class()).collect();
    for class in [
        Class::TrafficLight,
        Class::SpeedLimit,
        Class::Yield,
        Class::OneWay,
        Class::NoEntry,
        Class::Roundabout,
        Class::BusStop,
        Class::Motorway,
    ] {
        assert!(signals.contains(&class), "{class:?}");
    }
    let objects: BTreeSet<_> = map.objects().map(|object| object.class()).collect();
    for class in
        [Class::Crosswalk, Class::StopLine, Class::Arrow, Class::ParkingSpace, Class::Building]
    {
        assert!(objects.contains(&class), "{class:?}");
    }
    assert_eq!(map.structures().count(), 2, "bridges");
    assert_eq!(map.junction_groups().count(), 1, "a roundabout");
    assert!(map.projector().is_ok(), "a georeference");
}

#[test]
fn every_entry_of_the_quarter_leads_to_every_exit() {
    let snapshot = maps::open(&carried("quarter.xodr"));
    let map = snapshot.map();
    let place = |road: &str, s: f64, lane: i32| {
        let road = map.road_by_id(road).expect("the road is there");
        let lane =
            road.section_at(s).and_then(|section| section.lane(lane)).expect("the lane is there");
        PositionOnLane { lane: lane.lane_id(), s }
    };
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    // From the west, from the lake and from both ends of the motorway.
    let entries =
        [place("1", 1.0, -1), place("5", 100.0, 1), place("20", 1.0, -2), place("23", 1.0, -2)];
    let exits = [place("1", 1.0, 1), place("5", 100.0, -1), place("25", 200.0, -2)];
    let mut none = Vec::new();
    for from in entries {
        for to in exits {
            let found = map.route(
                from,
                to,
                VehicleClass::PassengerCar,
                &ShortestLength::default(),
                &mut scratch,
                &mut steps,
            );
            if found.expect("the places are of the map").is_none() {
                none.push((from, to));
            }
        }
    }
    assert!(none.is_empty(), "{none:?}");
}
