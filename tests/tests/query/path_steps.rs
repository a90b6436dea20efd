//! Paths over lists of lanes that somebody has made, how long they take, and the facts of roads along them.

use mapd_client::route::{PositionOnLane, RouteScratch, RouteStep, ShortestTime};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{LaneId, Map, QueryError};
use mapd_query::path::{
    PathBuffer, PathError, PathFactKind, PathOptions, PathTime, steps_of_lanes,
};
use mapd_tests::graph_maps::{Line, all, document, lane, link, road, section, wide};
use mapd_tests::maps::open_text;

/// Speed of a kilometre per hour `[m/s]`.
const KMH: f64 = 1.0 / 3.6;

fn ids(map: Map<'_>, keys: &[&str]) -> Vec<LaneId> {
    let id = |key: &&str| map.lane_by_key(&key.parse().expect("a key")).expect("a lane").lane_id();
    keys.iter().map(id).collect()
}

/// Lanes for both directions are driven the way that links ask for; alone, from s to s.
#[test]
fn lanes_for_both_directions_are_driven_either_way() {
    let both = all().into_iter().find(|one| one.name == "lanes in both directions");
    let snapshot = open_text(&both.expect("the map").text);
    let map = snapshot.map();
    let mut buffer = PathBuffer::default();
    let mut check = |keys: &[&str], ends: [f64; 2], expected: Result<&[bool], PathError>| {
        let mut steps: Vec<RouteStep> = Vec::new();
        let done = steps_of_lanes(map, &ids(map, keys), ends, &mut steps);
        let ways: Vec<bool> = steps.iter().map(|step| step.forward).collect();
        assert_eq!(done.map(|()| &ways[..]), expected, "{keys:?}, {ends:?}");
        if expected.is_ok() {
            let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
            let places = path.at(0.0).and_then(|from| Ok([from, path.at(path.length())?]));
            let [from, to] = places.expect("places").map(|place| place.position.x);
            assert!((path.length() - (to - from).abs()).abs() < 1e-6, "{keys:?}");
            assert_eq!(ways[0], to > from, "{keys:?}");
        }
    };
    check(&["1:0:-1", "2:0:-1"], [10.0, 40.0], Ok(&[true, true]));
    check(&["2:0:-1", "1:0:-1"], [40.0, 10.0], Ok(&[false, false]));
    check(&["3:0:-1", "2:0:-1", "1:0:-1"], [40.0, 10.0], Ok(&[false, false, false]));
    check(&["1:0:-1"], [10.0, 40.0], Ok(&[true]));
    check(&["1:0:-1"], [40.0, 10.0], Ok(&[false]));
    // The farthest way is told of: back from road 2 to road 1, and not on to road 3.
    check(&["1:0:-1", "3:0:-1"], [10.0, 40.0], Err(PathError::NotLinked { step: 1 }));
    check(&["2:0:-1", "1:0:-1", "3:0:-1"], [40.0, 10.0], Err(PathError::NotLinked { step: 2 }));
    let mut steps = Vec::new();
    assert_eq!(steps_of_lanes(map, &[], [0.0, 1.0], &mut steps), Ok(()));
    assert!(steps.is_empty());
}

#[test]
fn what_is_wrong_with_a_list_of_lanes_is_named_by_its_number() {
    let snapshot = open_text(&document(&road(
        "1",
        "junction=\"-1\"",
        Line(0.0, 0.0, 0.0, 50.0, 0.0),
        "",
        &section(0.0, &lane(1, ""), &lane(-1, "")),
    )));
    let other = open_text(&document(&road(
        "9",
        "junction=\"-1\"",
        Line(0.0, 0.0, 0.0, 9.0, 0.0),
        "",
        &section(0.0, "", &lane(-1, "")),
    )));
    let (map, mut steps) = (snapshot.map(), Vec::new());
    let own = ids(map, &["1:0:-1", "1:0:1"]);
    let foreign = ids(other.map(), &["9:0:-1"])[0];
    let mut wrong = |lanes: &[LaneId], ends| steps_of_lanes(map, lanes, ends, &mut steps).err();
    let step = |step, source| Some(PathError::Step { step, source });
    assert_eq!(wrong(&own, [0.0, 50.0]), Some(PathError::NotLinked { step: 1 }));
    assert_eq!(wrong(&[foreign], [0.0, 5.0]), step(0, QueryError::ForeignId));
    assert_eq!(wrong(&own, [f64::NAN, 5.0]), step(0, QueryError::NotFinite));
    assert_eq!(wrong(&own, [0.0, f64::INFINITY]), step(1, QueryError::NotFinite));
    assert_eq!(wrong(&[own[0], foreign], [0.0, 5.0]), step(1, QueryError::ForeignId));
    assert_eq!(wrong(&own[..1], [0.0, 500.0]), None);
}

/// Two roads in a row: types with countries, and a lane that is closed to trucks for a while, then to bicycles.
#[test]
fn countries_and_who_may_drive_are_told_as_intervals() {
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    let access = "<access sOffset=\"40\" rule=\"deny\" restriction=\"trucks\"/><access sOffset=\"70\" rule=\"deny\" restriction=\"bicycle\"/>";
    let kind =
        |s: f64, country: &str| format!("<type s=\"{s}\" type=\"town\" country=\"{country}\"/>");
    let one = road(
        "1",
        "junction=\"-1\"",
        Line(0.0, 0.0, 0.0, 100.0, 0.0),
        &link("s road 2 start"),
        &section(0.0, "", &wide(-1, "", "s-1", width, access)),
    );
    let two = road(
        "2",
        "junction=\"-1\"",
        Line(100.0, 0.0, 0.0, 100.0, 0.0),
        &link("p road 1 end"),
        &section(0.0, "", &lane(-1, "p-1")),
    );
    let one = one.replace("<planView>", &format!("{}<planView>", kind(0.0, "DE")));
    let types = kind(0.0, "DE") + &kind(60.0, "NL");
    let two = two.replace("<planView>", &format!("{types}<planView>"));
    let snapshot = open_text(&document(&(one + &two)));
    let map = snapshot.map();
    let (mut steps, mut buffer, mut facts) = (Vec::new(), PathBuffer::default(), Vec::new());
    steps_of_lanes(map, &ids(map, &["1:0:-1", "2:0:-1"]), [10.0, 90.0], &mut steps).expect("steps");
    let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    path.facts(&mut facts);
    let countries: Vec<_> = facts
        .iter()
        .filter_map(|fact| match fact.kind {
            PathFactKind::Country { number } => Some((fact.along, map.country(number)?)),
            _ => None,
        })
        .collect();
    assert_eq!(countries, [([0.0, 150.0], "DE"), ([150.0, 180.0], "NL")]);
    assert_eq!(map.country(u32::MAX), None);
    let trucks: Vec<_> = facts
        .iter()
        .filter_map(|fact| match fact.kind {
            PathFactKind::Access { classes } => {
                let may = |class: VehicleClass| classes & class.bit() != 0;
                assert!(may(VehicleClass::PassengerCar), "{fact:?}");
                Some((fact.along, (may(VehicleClass::Truck), may(VehicleClass::Bicycle))))
            }
            _ => None,
        })
        .collect();
    let (all, none) = ((true, true), (false, true));
    let told = [
        ([0.0, 30.0], all),
        ([30.0, 60.0], none),
        ([60.0, 90.0], (true, false)),
        ([90.0, 180.0], all),
    ];
    assert_eq!(trucks, told);
}

/// 50 km/h, then no limit, then nothing known, then 30 km/h.
#[test]
fn time_is_told_where_a_limit_is_known_and_length_where_none_is() {
    let speed = |s: f64, max: &str| format!("<speed sOffset=\"{s}\" max=\"{max}\" unit=\"km/h\"/>");
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    let limits = speed(0.0, "50")
        + &speed(40.0, "no limit")
        + &speed(55.0, "undefined")
        + &speed(70.0, "30");
    let lanes = section(0.0, "", &wide(-1, "", "", width, &limits));
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let snapshot = open_text(&document(&road("1", "junction=\"-1\"", line, "", &lanes)));
    let map = snapshot.map();
    let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
    steps_of_lanes(map, &ids(map, &["1:0:-1"]), [10.0, 100.0], &mut steps).expect("steps");
    let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    let check = |part: [f64; 2], time: f64, unlimited: f64| {
        let told = path.travel_time(part).expect("a time");
        let off = (told.time - time).abs().max((told.unlimited - unlimited).abs());
        assert!(off < 1e-9, "{part:?}: {told:?}, not {time} s and {unlimited} m");
    };
    let [fast, slow] = [50.0, 30.0].map(|limit| limit * KMH);
    check([0.0, path.length()], 30.0 / fast + 30.0 / slow, 30.0);
    check([-5.0, 500.0], 30.0 / fast + 30.0 / slow, 30.0);
    check([10.0, 20.0], 10.0 / fast, 0.0);
    check([35.0, 45.0], 0.0, 10.0);
    check([50.0, 75.0], 15.0 / slow, 10.0);
    check([20.0, 20.0], 0.0, 0.0);
    for part in [[2.0, 1.0], [f64::NAN, 1.0], [0.0, f64::INFINITY]] {
        assert_eq!(path.travel_time(part).err(), Some(PathError::NotInOrder), "{part:?}");
    }
    // The graph counts no limit as 130 km/h and what is unknown as 50 km/h, and says how much of the sum that is.
    let own = ids(map, &["1:0:-1"])[0];
    let ends = [10.0, 100.0].map(|s| PositionOnLane { lane: own, s });
    let (cost, mut scratch) = (ShortestTime::default(), RouteScratch::default());
    let route =
        map.route(ends[0], ends[1], VehicleClass::PassengerCar, &cost, &mut scratch, &mut steps);
    let route = route.expect("an answer").expect("a way");
    let assumed = 15.0 / (130.0 * KMH) + 15.0 / fast;
    // The graph's node has its whole time in single precision, of which the route drives nine tenths.
    let whole = 40.0 / fast + assumed + 30.0 / slow;
    assert!((route.travel_time - 0.9 * whole).abs() < 1e-5, "{route:?}");
    let share = assumed / (30.0 / fast + assumed + 30.0 / slow);
    assert!((route.assumed_time - share * route.travel_time).abs() < 1e-9, "{route:?}");
    let none = PathTime { time: 0.0, unlimited: 0.0 };
    assert_eq!(path.travel_time([500.0, 600.0]), Ok(none));
}
