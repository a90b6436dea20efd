//! Overlays: what is refused, when entries hold, what a view says.

use mapd_archive::{OpenError, OverlayRows, Range, open_overlay, verify_overlay};
use mapd_client::view::OverlayKind;
use mapd_client::{Map, Snapshot};
use mapd_overlay::{Document, DocumentError, Limits, Placements, Policy, resolve};
use mapd_query::glam::{DMat3, DVec2, DVec3};
use mapd_query::localisation::{MatchOptions, VehiclePose};
use mapd_query::path::{Corridor, PathBuffer, PathOptions, steps_of_lanes};
use mapd_query::route::{
    AlternativeOptions, PositionOnLane, Reach, RouteRequest, RouteScratch, RouteStep, Routes,
    ShortestLength,
};
use mapd_query::signals::SignalsAhead;
use mapd_query::view::View;
use mapd_query::vocabulary::VehicleClass;
use mapd_query::{LaneId, QueryError};
use mapd_tests::crossroads::{crossroads, left_hand_crossroads, signal};
use mapd_tests::graph_maps::{Line, document, lane, road, section};
use mapd_tests::maps::{Random, open_text};
use mapd_tests::overlays::over;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

const CAR: VehicleClass = VehicleClass::PassengerCar;

/// Road A, 100 m, of two lanes each way and a hard shoulder.
pub(crate) fn two_lanes() -> Snapshot {
    let right = lane(-1, "") + &lane(-2, "") + &lane(-3, "").replace("driving", "shoulder");
    let left = lane(2, "") + &lane(1, "");
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    open_text(&document(&road("A", "", line, "", &section(0.0, &left, &right))))
}

/// The same with a light at 80 m for the lanes on the right.
fn with_signal() -> String {
    let right = lane(-1, "") + &lane(-2, "");
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let light = r#"<signals><signal s="80" t="-8" id="light" dynamic="yes" orientation="+" type="1000001" subtype="-1" country="OpenDRIVE" zOffset="3" height="1" width="0.4"/></signals>"#;
    let text = road("A", "", line, "", &section(0.0, "", &right));
    document(&text.replace("</lanes>", &format!("</lanes>{light}")))
}

pub(crate) fn lane_id(map: Map<'_>, number: i32) -> LaneId {
    let section = map.road_by_id("A").expect("a road").section(0).expect("a section");
    section.lane(number).expect("a lane").lane_id()
}

pub(crate) fn at(seconds: f64) -> SystemTime {
    UNIX_EPOCH + Duration::from_secs_f64(seconds)
}

/// Runs with the view of a document over the road, at a moment.
pub(crate) fn with(text: &str, moment: SystemTime, test: impl FnOnce(View<'_>)) {
    let snapshot = two_lanes();
    let (bytes, resolved) = over(snapshot.map(), text, true);
    assert_eq!(resolved.unplaced, []);
    let overlay = open_overlay(&bytes).expect("opens");
    test(View::new(snapshot.map(), Some(&overlay), moment).expect("its own"));
}

/// An entry about lane −1 from 40 m to 60 m.
pub(crate) fn entry(id: &str, more: &str) -> String {
    format!(r#"{{"id":"{id}",{more},"lanes":[{{"road":"A","s":[40,60],"lane":-1}}]}}"#)
}

pub(crate) fn entries(all: &[String]) -> String {
    format!(r#"{{"entries":[{}]}}"#, all.join(","))
}

#[test]
fn a_closed_stretch_is_named() {
    let text = entries(&[entry("works", r#""kind":"closed","source":"city","text":"cable""#)]);
    with(&text, at(0.0), |view| {
        let lane = lane_id(view.map(), -1);
        for (s, allowed) in [(39.9, true), (40.0, false), (59.9, false), (60.0, true)] {
            let answer = view.allows(lane, s, CAR).expect("an answer");
            assert_eq!(answer.is_allowed, allowed, "at {s}");
            let named = answer.restriction.map(|one| (one.entry.id(), one.s_from, one.s_to));
            assert_eq!(named, (!allowed).then_some(("works", 40.0, 60.0)), "at {s}");
        }
        let one = view.restrictions_at(lane, 50.0).expect("an answer").next().expect("one");
        assert_eq!((one.entry.source(), one.entry.text(), one.lane), ("city", "cable", lane));
        assert_eq!(view.restrictions_at(lane_id(view.map(), -2), 50.0).expect("none").count(), 0);
        let nan = view.allows(lane, f64::NAN, CAR);
        assert!(nan.is_err());
    });
}

/// Changes of lane lead round a closed stretch, also back behind it.
#[test]
fn routes_lead_round_it() {
    let text = entries(&[entry("works", r#""kind":"closed""#)]);
    with(&text, at(0.0), |view| {
        let lane = lane_id(view.map(), -1);
        let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
        let mut cost = |from: f64, to: f64| {
            let [from, to] = [from, to].map(|s| PositionOnLane { lane, s });
            let cost = ShortestLength::default();
            let route =
                view.route(from, to, CAR, &cost, &mut scratch, &mut steps).expect("an answer");
            route.map(|route| (route.length, route.lane_changes))
        };
        assert_eq!(cost(10.0, 90.0), Some((80.0, 2)));
        assert_eq!(cost(50.0, 90.0), Some((40.0, 0)), "the start may be closed");
        assert_eq!(cost(10.0, 50.0), None, "the target may not");
        let from = PositionOnLane { lane, s: 10.0 };
        let mut reached = Vec::new();
        let cost = ShortestLength::default();
        view.reachable(from, 1e3, CAR, &cost, &mut scratch, &mut reached).expect("an answer");
        let own = reached.iter().filter(|piece| piece.lane == lane);
        let pieces: Vec<_> = own.map(|piece| (piece.s_from, piece.s_to)).collect();
        assert_eq!(pieces, [(10.0, 40.0), (60.0, 100.0)]);
    });
}

/// Whatever a request asks: the closed stretch is neither driven on nor reached.
#[test]
fn requests_heed_it() {
    let text = entries(&[entry("works", r#""kind":"closed""#)]);
    with(&text, at(0.0), |view| {
        let lane = lane_id(view.map(), -1);
        let (mut scratch, mut steps, mut routes, mut network) =
            (RouteScratch::default(), Vec::new(), Routes::default(), Reach::default());
        let [starts, goals] = [10.0, 90.0].map(|s| [PositionOnLane { lane, s }.into()]);
        let cost = ShortestLength::default();
        let ask = |avoid| RouteRequest {
            starts: &starts,
            goals: &goals,
            vehicle: CAR,
            cost: &cost,
            avoid,
        };
        let beside = [lane_id(view.map(), -2)];
        let found = view.find_route(&ask(&[]), &mut scratch, &mut steps).expect("an answer");
        assert_eq!(found.map(|route| (route.length, route.lane_changes)), Some((80.0, 2)));
        let none = view.find_route(&ask(&beside), &mut scratch, &mut steps).expect("an answer");
        assert_eq!(none, None, "the way round is to be avoided");
        for share in [0.0, 0.3] {
            let options = AlternativeOptions { share, ..AlternativeOptions::default() };
            view.alternatives(&ask(&[]), &options, &mut scratch, &mut routes).expect("routes");
            assert_eq!(routes.iter().next().map(|(route, _)| *route), found);
            let is_closed = |step: &RouteStep| {
                let (low, high) = (step.s_from.min(step.s_to), step.s_from.max(step.s_to));
                step.lane == lane && low < 60.0 && high > 40.0
            };
            assert!(routes.iter().all(|(_, steps)| !steps.iter().any(is_closed)));
        }
        let own = |network: &Reach| {
            let all = network.reached().iter().filter(|one| one.lane == lane);
            all.map(|one| (one.s_from, one.s_to)).collect::<Vec<_>>()
        };
        view.reach(&ask(&[]), 1e3, &mut scratch, &mut network).expect("a network");
        assert_eq!(own(&network), [(10.0, 40.0), (60.0, 100.0)]);
        view.reach_to(&ask(&[]), 1e3, &mut scratch, &mut network).expect("a network");
        assert_eq!(own(&network), [(60.0, 90.0), (0.0, 40.0)]);
        view.reach_to(&ask(&beside), 1e3, &mut scratch, &mut network).expect("a network");
        assert_eq!(own(&network), [(60.0, 90.0)]);
    });
}

/// Along a path: entries by S, limits, the room beside it; signals ahead, and where a pose may be.
#[test]
fn ways_heed_it() {
    let beside = entry("works", r#""kind":"closed""#);
    let slow = entry("slow", r#""kind":"speed","value":5"#).replace("[40,60]", "[30,50]");
    let text = entries(&[beside, slow.replace(r#""lane":-1"#, r#""lane":-2"#)]);
    with(&text, at(0.0), |view| {
        let map = view.map();
        let mut steps = Vec::new();
        steps_of_lanes(map, &[lane_id(map, -2)], [10.0, 90.0], &mut steps).expect("steps");
        let mut buffer = PathBuffer::default();
        let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
        let mut met = Vec::new();
        view.restrictions_on_path(&path, CAR, &mut met).expect("an answer");
        let near = |a: f64, b: f64| (a - b).abs() < 1e-6;
        let [one] = met[..] else { panic!("{met:?}") };
        assert!(near(one.along[0], 20.0) && near(one.along[1], 40.0), "{met:?}");
        assert_eq!(one.restriction.entry.id(), "slow");
        for (along, max) in [(10.0, None), (30.0, Some(5.0)), (50.0, None)] {
            let today = view.speed_on_path(&path, along, CAR).expect("an answer");
            assert_eq!(today.max, max, "at {along}");
        }
        let (mut plain, mut heeded) = (Corridor::default(), Corridor::default());
        path.corridor(0.0, 80.0, 10.0, CAR, &mut plain).expect("an answer");
        view.corridor(&path, 0.0, 80.0, 10.0, CAR, &mut heeded).expect("an answer");
        for (i, along) in plain.along.iter().enumerate() {
            let closed = (30.0..50.0).contains(along);
            assert!(plain.left_mark[i].may_cross, "at {along}");
            assert_eq!(heeded.left_mark[i].may_cross, !closed, "at {along}");
            let is_narrow = heeded.outer_left[i] == heeded.left[i];
            assert_eq!(is_narrow, closed, "at {along}");
        }
        // A pose between both lanes.
        let pose = VehiclePose { position: DVec2::new(50.0, -3.5).into(), heading: 0.0 };
        let covariance = DMat3::from_diagonal(DVec3::new(1.0, 1.0, 0.01));
        let options = MatchOptions { vehicle: Some(CAR), ..MatchOptions::default() };
        let mut found = Vec::new();
        let mut share = |view: View<'_>| {
            view.match_pose(&pose, &covariance, &options, &mut found).expect("an answer");
            let own = found.iter().find(|one| one.lane == lane_id(map, -1));
            own.map_or(0.0, |one| one.probability)
        };
        let bare = View::new(map, None, at(0.0)).expect("a view");
        let (open, closed) = (share(bare), share(view));
        assert!(open > 0.45 && closed < 0.1, "{open} {closed}");
    });
}

/// Ways through closed lanes are not followed.
#[test]
fn signals_behind_what_is_closed() {
    let snapshot = open_text(&with_signal());
    let map = snapshot.map();
    let mut ahead = SignalsAhead::default();
    let mut count = |text: &str| {
        let (bytes, resolved) = over(map, text, false);
        assert_eq!(resolved.unplaced, []);
        let overlay = open_overlay(&bytes).expect("opens");
        let view = View::new(map, Some(&overlay), at(0.0)).expect("its own");
        let from = PositionOnLane { lane: lane_id(map, -1), s: 10.0 };
        view.signals_ahead(from, 200.0, CAR, &mut ahead).expect("an answer");
        let signal = map.signal_by_id("light").expect("a signal").signal_id();
        let off = view.signal_out_of_service(signal).expect("an answer");
        (ahead.iter().count(), off.map(|entry| entry.id().to_owned()))
    };
    assert_eq!(count(&entries(&[])), (1, None));
    assert_eq!(count(&entries(&[entry("works", r#""kind":"closed""#)])), (0, None));
    let wet = entry("rain", r#""kind":"wet""#);
    assert_eq!(count(&entries(&[wet])), (1, None));
    let off = r#"{"id":"off","kind":"signal-off","signals":["light"]}"#.to_owned();
    assert_eq!(count(&entries(&[off])), (1, Some("off".to_owned())));
}

/// When an entry holds, for whom, and what wins.
#[test]
fn moments_vehicles_and_what_wins() {
    // 1970-01-01 was a Thursday.
    const DAY: f64 = 86_400.0;
    let lane = -1;
    let check = |more: &[&str], moment: f64, vehicle: VehicleClass, number: i32, open: bool| {
        let all: Vec<_> = more
            .iter()
            .enumerate()
            .map(|(i, more)| {
                entry(&i.to_string(), more).replace(r#""lane":-1"#, &format!(r#""lane":{number}"#))
            })
            .collect();
        with(&entries(&all), at(moment), |view| {
            let answer =
                view.allows(lane_id(view.map(), number), 50.0, vehicle).expect("an answer");
            assert_eq!(answer.is_allowed, open, "{more:?} at {moment} for {}", vehicle.name());
        });
    };
    let truck = VehicleClass::Truck;
    let closed = r#""kind":"closed""#;
    check(&[], 0.0, CAR, lane, true);
    check(&[closed], 0.0, CAR, lane, false);
    let times = r#""kind":"closed","from":100,"until":"1970-01-01T00:03:20Z""#;
    for (moment, open) in [(99.9, true), (100.0, false), (199.9, false), (200.0, true)] {
        check(&[times], moment, CAR, lane, open);
    }
    let night =
        r#""kind":"closed","weekly":[{"days":["thu","sun"],"from":"22:00","until":"06:00"}]"#;
    for (hours, open) in [(21.9, true), (22.0, false), (29.9, false), (30.0, true), (46.0, true)] {
        check(&[night], hours * 3600.0, CAR, lane, open);
    }
    // From Sunday to Monday the week begins anew.
    check(&[night], 4.0 * DAY + 5.0 * 3600.0, CAR, lane, false);
    check(&[night], 4.0 * DAY + 6.0 * 3600.0, CAR, lane, true);
    check(&[r#""kind":"closed","vehicles":["truck"]"#], 0.0, CAR, lane, true);
    check(&[r#""kind":"closed","vehicles":["truck"]"#], 0.0, truck, lane, false);
    check(&[r#""kind":"only","vehicles":["truck"]"#], 0.0, CAR, lane, false);
    check(&[r#""kind":"only","vehicles":["truck"]"#], 0.0, truck, lane, true);
    let open = r#""kind":"open","vehicles":["passengerCar"]"#;
    check(&[], 0.0, CAR, -3, false);
    check(&[open], 0.0, CAR, -3, true);
    check(&[open], 0.0, truck, -3, false);
    check(&[open, closed], 0.0, CAR, -3, false);
    for other in ["no-overtaking", "wet", "icy", "snow", "rough", "warning"] {
        check(&[&format!(r#""kind":"{other}""#)], 0.0, CAR, lane, true);
    }
}

#[test]
fn the_lowest_speed_holds() {
    let speed = |id: &str, value: f64| entry(id, &format!(r#""kind":"speed","value":{value}"#));
    let text = entries(&[speed("a", 9.0), speed("b", 7.0), entry("c", r#""kind":"icy""#)]);
    with(&text, at(0.0), |view| {
        let lane = lane_id(view.map(), -1);
        let today = view.speed_rule_at(lane, 50.0, CAR).expect("an answer");
        assert_eq!((today.max, today.map.max), (Some(7.0), None));
        assert_eq!(today.restriction.map(|one| one.entry.id()), Some("b"));
        assert_eq!(view.speed_rule_at(lane, 30.0, CAR).expect("an answer").max, None);
        let kinds: Vec<_> = view.entries().map(|entry| entry.kind()).collect();
        assert_eq!(kinds, [OverlayKind::Speed, OverlayKind::Speed, OverlayKind::Icy]);
    });
}

/// An entry forbids overtaking to whom it is about where it holds; what signs forbid stays forbidden, to those whom they mean.
#[test]
fn overtaking_is_forbidden_by_entries_and_signs() {
    let sign = |id: &str, s: f64, code: &str| {
        format!(
            r#"<signal s="{s}" t="-8" id="{id}" dynamic="no" orientation="+" type="{code}" subtype="-1" country="DE" zOffset="2" height="0.6" width="0.6"/>"#
        )
    };
    let signs = format!("<signals>{}{}</signals>", sign("T", 70.0, "277"), sign("N", 80.0, "276"));
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let text = road("A", "", line, "", &section(0.0, "", &lane(-1, "")));
    let snapshot = open_text(&document(&text.replace("</lanes>", &format!("</lanes>{signs}"))));
    let map = snapshot.map();
    let said = entries(&[
        entry("works", r#""kind":"no-overtaking""#),
        entry("trucks", r#""kind":"no-overtaking","vehicles":["truck"],"until":5"#)
            .replace("[40,60]", "[10,20]"),
        entry("wet", r#""kind":"wet""#).replace("[40,60]", "[20,30]"),
    ]);
    let (bytes, resolved) = over(map, &said, false);
    assert_eq!(resolved.unplaced, []);
    let overlay = open_overlay(&bytes).expect("opens");
    let (lane, truck) = (lane_id(map, -1), VehicleClass::Truck);
    let bicycle = VehicleClass::Bicycle;
    for (overlaid, moment, s, vehicle, forbidden, by) in [
        (true, 0.0, 50.0, CAR, true, Some("works")),
        (false, 0.0, 50.0, CAR, false, None),
        (true, 0.0, 35.0, CAR, false, None),
        (true, 0.0, 25.0, CAR, false, None),
        (true, 0.0, 15.0, CAR, false, None),
        (true, 0.0, 15.0, truck, true, Some("trucks")),
        (true, 5.0, 15.0, truck, false, None),
        (true, 0.0, 75.0, CAR, false, None),
        (true, 0.0, 75.0, truck, true, None),
        (true, 0.0, 90.0, CAR, true, None),
        (true, 0.0, 90.0, bicycle, false, None),
    ] {
        let view = View::new(map, overlaid.then_some(&overlay), at(moment)).expect("its own");
        let today = view.overtaking_rule_at(lane, s, vehicle).expect("an answer");
        let found = (today.is_forbidden, today.restriction.map(|one| one.entry.id()));
        assert_eq!(found, (forbidden, by), "{} at {s}: {today:?}", vehicle.name());
        assert_eq!(today.map, map.lane(lane).expect("a lane").overtaking_rule_at(s));
    }
    let view = View::new(map, Some(&overlay), at(0.0)).expect("its own");
    let nan = view.overtaking_rule_at(lane, f64::NAN, CAR);
    assert_eq!(nan.err(), Some(QueryError::NotFinite));
    let foreign = view.overtaking_rule_at(lane_id(two_lanes().map(), -1), 50.0, CAR);
    assert!(foreign.is_err());
}

/// Where nothing is laid over it, a view is the map.
#[test]
fn without_an_overlay() {
    let snapshot = two_lanes();
    let view = View::new(snapshot.map(), None, at(0.0)).expect("a view");
    assert_eq!(view.entries().count(), 0);
    assert!(view.allows(lane_id(view.map(), -1), 50.0, CAR).expect("an answer").is_allowed);
    let (bytes, _) =
        over(open_text(&mapd_tests::town::town(2, 2)).map(), r#"{"entries":[]}"#, false);
    let overlay = open_overlay(&bytes).expect("opens");
    assert!(View::new(snapshot.map(), Some(&overlay), at(0.0)).is_err(), "another map's");
    assert_eq!(open_overlay(snapshot.bytes()).err(), Some(OpenError::NotAnOverlay));
    assert_eq!(
        Snapshot::from_bytes(bytes).err().map(|error| error.to_string().contains("overlay")),
        Some(true)
    );
}

/// Refused whole, with entry and field.
#[test]
fn bad_documents() {
    let check = |text: &str, place: &str| {
        let error = Document::read(text.as_bytes(), &Limits::default()).expect_err(text);
        let found = match &error {
            DocumentError::Entry { id, field, .. } => format!("{id} {field}"),
            DocumentError::Json { place, .. } => place.clone(),
            other => other.to_string(),
        };
        assert_eq!(found, place, "{error}");
    };
    let one = |more: &str| entries(&[entry("a", more)]);
    check("", "document");
    check("[]", "document");
    check(r#"{"entries":[]} {}"#, "document");
    check(r#"{"entries":[{"id":5}]}"#, "entries[0].id");
    check(&one(r#""kind":"shut""#), "entries[0].kind");
    check(&one(r#""kind":"closed","speed":3"#), "entries[0].speed");
    check(&one(r#""kind":"speed","value":"fast""#), "entries[0].value");
    check(&one(r#""kind":"speed""#), "a value");
    check(&one(r#""kind":"speed","value":-1"#), "a value");
    check(&one(r#""kind":"closed","value":1"#), "a value");
    check(&one(r#""kind":"closed","from":"soon""#), "entries[0].from");
    check(&one(r#""kind":"closed","from":20,"until":10"#), "a until");
    check(&one(r#""kind":"closed","confidence":2"#), "a confidence");
    check(&one(r#""kind":"closed","vehicles":["spaceship"]"#), "a vehicles[0]");
    check(&one(r#""kind":"only""#), "a vehicles");
    check(&one(r#""kind":"closed","signals":["1"]"#), "a signals");
    check(
        &one(r#""kind":"closed","weekly":[{"days":[],"from":"07:00","until":"08:00"}]"#),
        "a weekly[0].days",
    );
    check(
        &one(r#""kind":"closed","weekly":[{"days":["mon"],"from":"7","until":"08:00"}]"#),
        "entries[0].weekly[0].from",
    );
    check(&entries(&[r#"{"id":"a","kind":"closed"}"#.into()]), "a lanes");
    check(&entries(&[r#"{"id":"a","kind":"closed","lanes":[{}]}"#.into()]), "a lanes[0].road");
    check(&one(r#""kind":"closed""#).replace("[40,60]", "[60,40]"), "a lanes[0].s");
    check(&one(r#""kind":"closed""#).replace("[40,60]", "[40]"), "entries[0].lanes[0].s");
    check(&one(r#""kind":"closed""#).replace("-1", "0"), "a lanes[0].lane");
    check(&one(r#""kind":"closed""#).replace("-1", "1.5"), "entries[0].lanes[0].lane");
    let twice = [entry("a", r#""kind":"closed""#), entry("a", r#""kind":"icy""#)];
    check(&entries(&twice), "a id");
    let many: Vec<_> = (0..10_001).map(|i| entry(&i.to_string(), r#""kind":"wet""#)).collect();
    check(&entries(&many), "10001 entries; at most 10000 are taken (--overlay-entries)");
    let long = " ".repeat(Limits::default().bytes) + "x";
    check(&long, "4194305 bytes; at most 4194304 are taken (--overlay-bytes)");
}

/// What the map does not have, and what would allow more than it does.
#[test]
fn what_does_not_fit() {
    let snapshot = two_lanes();
    let check = |place: &str, more: &str, field: &str| {
        let text = format!(r#"{{"entries":[{{"id":"a",{more}{place}}}]}}"#);
        let document = Document::read(text.as_bytes(), &Limits::default()).expect(&text);
        let resolved = resolve(snapshot.map(), &document, Policy::default());
        let fields: Vec<_> = resolved.unplaced.iter().map(|unfit| unfit.field.as_str()).collect();
        assert_eq!(fields, [field], "{text}: {:?}", resolved.unplaced);
    };
    let closed = |place: &str, field: &str| {
        check(&format!(r#","lanes":[{place}]"#), r#""kind":"closed""#, field);
    };
    closed(r#"{"road":"B"}"#, "lanes[0].road");
    closed(r#"{"road":"A","lane":-4}"#, "lanes[0].lane");
    closed(r#"{"road":"A","s":[90,110]}"#, "lanes[0].s");
    closed(r#"{"road":"A","s":[-1,10]}"#, "lanes[0].s");
    closed(r#"{"road":"A","s":[10,10.05]}"#, "lanes[0].s");
    closed(r#"{"key":"A:1:-1"}"#, "lanes[0].key");
    closed(r#"{"key":"A"}"#, "lanes[0].key");
    closed(r#"{"road":"A"},{"road":"C"}"#, "lanes[1].road");
    check(r#","objects":["tree"]"#, r#""kind":"closed""#, "objects[0]");
    check(r#","signals":["9"]"#, r#""kind":"signal-off""#, "signals[0]");
    check(r#","lanes":[{"road":"A","lane":-3}]"#, r#""kind":"open""#, "kind");
}

/// An entry of a speed is refused if it raises the limit on any part of a lane, for any way that leads there: between two records, from a sign on, in a
/// zone that some come from, behind a junction's entries, by the header's regulations; on the right and on the left.
#[test]
fn what_raises_a_limit_anywhere_is_refused() {
    const KMH: f64 = 1.0 / 3.6;
    let check = |snapshot: &Snapshot, road: &str, number: i32, s: &str, lowest: Option<f64>| {
        let refused = |value: f64| {
            let lanes = format!(r#""lanes":[{{"road":"{road}","lane":{number}{s}}}]"#);
            let text =
                format!(r#"{{"entries":[{{"id":"a","kind":"speed","value":{value},{lanes}}}]}}"#);
            let document = Document::read(text.as_bytes(), &Limits::default()).expect(&text);
            let unplaced = resolve(snapshot.map(), &document, Policy::default()).unplaced;
            assert!(unplaced.iter().all(|unfit| unfit.field == "value"), "{text}: {unplaced:?}");
            !unplaced.is_empty()
        };
        let what = format!("{road}, {number}{s}");
        match lowest {
            Some(lowest) => {
                assert!(!refused(lowest), "{what}: as low");
                assert!(refused(lowest + 0.02), "{what}: {lowest}");
            }
            None => assert!(!refused(100.0), "{what}: unknown"),
        }
    };
    let sign = |id: &str, s: f64, t: f64, orientation: &str, code: &str, value: u32| {
        signal(id, s, t, orientation, code, &format!(r#"value="{value}" unit="km/h""#))
    };
    let straight = |signals: &str, types: &str, lane_speeds: &str| {
        let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
        let right = lane(-1, "").replace("</lane>", &format!("{lane_speeds}</lane>"));
        let text = road("A", "", line, "", &section(0.0, &lane(1, ""), &right));
        let text = text.replace("</lanes>", &format!("</lanes><signals>{signals}</signals>"));
        open_text(&document(&text.replace("<planView>", &format!("{types}<planView>"))))
    };
    let fifty = r#"<type s="0" type="town"><speed max="50" unit="km/h"/></type>"#;
    // A sign and its end between the road's only record and its end, where neither the ends of the entry nor its middle lie.
    for (number, t, orientation, [begin, end]) in
        [(-1, -5.0, "+", [20.0, 40.0]), (1, 5.0, "-", [40.0, 20.0])]
    {
        let signals = sign("b", begin, t, orientation, "274", 30)
            + &sign("e", end, t, orientation, "278", 30);
        let map = straight(&signals, fifty, "");
        check(&map, "A", number, "", Some(30.0 * KMH));
        check(&map, "A", number, r#","s":[35,45]"#, Some(30.0 * KMH));
        check(&map, "A", number, r#","s":[40,90]"#, Some(50.0 * KMH));
        check(&map, "A", -number, "", Some(50.0 * KMH));
    }
    let records = r#"<speed sOffset="60" max="20" unit="km/h"/><speed sOffset="61" max="70" unit="km/h"/><speed sOffset="80" max="90" unit="knots"/>"#;
    let map = straight("", fifty, records);
    check(&map, "A", -1, "", Some(20.0 * KMH));
    check(&map, "A", -1, r#","s":[61,79]"#, Some(70.0 * KMH));
    check(&map, "A", -1, r#","s":[80,100]"#, None);
    // Behind the junction the zone holds for those who come by arm 0 only; in it, the limit of the arm.
    for left_hand in [false, true] {
        let side = if left_hand { -1.0 } else { 1.0 };
        let signals = std::array::from_fn(|arm| match arm {
            0 => sign("Z", 50.0, 5.0 * side, "-", "274.1", 30),
            1 => sign("L", 50.0, 5.0 * side, "-", "274", 40),
            _ => String::new(),
        });
        let map = open_text(&match left_hand {
            true => left_hand_crossroads(signals, "", ""),
            false => crossroads(signals, "", ""),
        });
        let (inward, outward) = if left_hand { (-1, 1) } else { (1, -1) };
        check(&map, "0", inward, r#","s":[0,50]"#, Some(30.0 * KMH));
        check(&map, "0", inward, r#","s":[50,90]"#, None);
        check(&map, "2", outward, "", Some(30.0 * KMH));
        check(&map, "0", outward, "", None);
        check(&map, "12", outward, "", Some(40.0 * KMH));
    }
}

/// What is about other vehicles does not cut a vehicle's ways; an overlay that does not say whom its nodes concern gives the same routes.
#[test]
fn what_is_about_others_changes_no_way() {
    let snapshot = two_lanes();
    let map = snapshot.map();
    let text = entries(&[
        entry("a", r#""kind":"closed","vehicles":["truck"]"#),
        entry("b", r#""kind":"warning""#).replace("[40,60]", "[20,30]"),
    ]);
    let (_, resolved) = over(map, &text, false);
    let encode = |rows: &OverlayRows| {
        mapd_archive::encode_overlay(rows, map.content_hash()).expect("encodes")
    };
    let named = encode(&resolved.rows);
    let mut rows = resolved.rows;
    // Lanes of the section are cut together, so all of them concern who is concerned on one.
    let truck = VehicleClass::Truck;
    assert!(rows.node_vehicles.iter().all(|classes| *classes == truck.bit()));
    let nodes = rows.nodes.len();
    for wrong in [vec![truck.bit(); nodes - 1], vec![CAR.bit(); nodes]] {
        rows.node_vehicles = wrong.into();
        let error = verify_overlay(&encode(&rows)).err().map(|error| error.to_string());
        assert!(error.as_ref().is_some_and(|e| e.contains("node_vehicles")), "{error:?}");
    }
    rows.node_vehicles.clear();
    let unnamed = encode(&rows);
    verify_overlay(&unnamed).expect("proves");
    let lane = lane_id(map, -1);
    let [from, to] = [10.0, 90.0].map(|s| PositionOnLane { lane, s });
    let (mut scratch, mut steps, mut reached) = (RouteScratch::default(), Vec::new(), Vec::new());
    let cost = ShortestLength::default();
    let mut ask = |bytes: &[u8], vehicle| {
        let overlay = open_overlay(bytes).expect("opens");
        let view = View::new(map, Some(&overlay), at(0.0)).expect("its own");
        let route = view.route(from, to, vehicle, &cost, &mut scratch, &mut steps);
        let route = route.expect("an answer").expect("a way");
        view.reachable(from, 200.0, vehicle, &cost, &mut scratch, &mut reached).expect("an answer");
        (route.cost, steps.len(), reached.len())
    };
    let (car, car_unnamed) = (ask(&named, CAR), ask(&unnamed, CAR));
    assert_eq!((car.0, car.1), (80.0, 1));
    assert!(car.2 < car_unnamed.2, "{car:?} {car_unnamed:?}");
    assert!((car.0 - car_unnamed.0).abs() < 1e-6, "{car:?} {car_unnamed:?}");
    let by_truck = ask(&named, truck);
    assert!(by_truck.0 > 80.0 && by_truck.1 > 1, "{by_truck:?}");
    assert_eq!(by_truck, ask(&unnamed, truck));
}

/// Entries within each other: of those at one place so many are taken that the tables grow with entries and pieces, not with both together. Who comes first stays.
#[test]
fn entries_within_each_other() {
    /// As docs/overlay.md says.
    const MOST_AT_A_PLACE: usize = 256;
    const ENTRIES: usize = 600;
    let right = lane(-1, "") + &lane(-2, "");
    let line = Line(0.0, 0.0, 0.0, 1000.0, 0.0);
    let snapshot = open_text(&document(&road("A", "", line, "", &section(0.0, "", &right))));
    let nested = |i: usize| {
        let (id, s) = (i.to_string(), 0.5 * i as f64);
        let what = if i == 0 { r#""kind":"closed""# } else { r#""kind":"warning""# };
        entry(&id, what).replace("[40,60]", &format!("[{s},{}]", 900.0 - s))
    };
    // What lies beside them has room, and what comes later at another place.
    let beside = entry("beside", r#""kind":"closed""#).replace("[40,60]", "[950,960]");
    let all: Vec<String> = (0..ENTRIES).map(nested).chain([beside]).collect();
    let (bytes, resolved) = over(snapshot.map(), &entries(&all), false);
    let OverlayRows { entries, pieces, piece_entries, .. } = &resolved.rows;
    assert_eq!(entries.len(), MOST_AT_A_PLACE + 1);
    assert!(piece_entries.len() <= MOST_AT_A_PLACE * pieces.len());
    let left_out: Vec<_> = resolved.unplaced.iter().map(|unfit| unfit.number).collect();
    assert_eq!(left_out, (MOST_AT_A_PLACE..ENTRIES).collect::<Vec<_>>());
    for unfit in &resolved.unplaced {
        assert!(unfit.why.contains("256 entries") && !unfit.is_part, "{unfit:?}");
    }
    let overlay = open_overlay(&bytes).expect("opens");
    let view = View::new(snapshot.map(), Some(&overlay), at(0.0)).expect("its own");
    for (s, by) in [(10.0, Some("0")), (450.0, Some("0")), (920.0, None), (955.0, Some("beside"))] {
        let answer = view.allows(lane_id(snapshot.map(), -1), s, CAR).expect("an answer");
        assert_eq!(answer.restriction.map(|one| one.entry.id()), by, "at {s}");
    }
}

/// What an overlay says of rows of its map is proven, too: nodes beside each other are cut alike, and a search meets no piece that is not there.
#[test]
fn overlays_that_do_not_fit_their_map() {
    let snapshot = two_lanes();
    let map = snapshot.map();
    let text = entries(&[entry("a", r#""kind":"closed""#)]);
    let (bytes, resolved) = over(map, &text, true);
    let mut scratch = RouteScratch::default();
    let mut check = |rows: &OverlayRows, expected: &str| {
        let bytes = mapd_archive::encode_overlay(rows, map.content_hash()).expect("encodes");
        verify_overlay(&bytes).expect("proves by itself");
        let under = snapshot.with_overlay(bytes).expect("opens");
        let error = under.verify().err().map(|error| format!("{error:?}")).unwrap_or_default();
        assert!(error.contains(expected) && !expected.is_empty(), "{expected}: {error}");
        let (view, lane) = (under.view(at(0.0)), lane_id(map, -1));
        let [from, to] = [10.0, 90.0].map(|s| PositionOnLane { lane, s });
        let (cost, mut steps) = (ShortestLength::default(), Vec::new());
        let _ = view.route(from, to, CAR, &cost, &mut scratch, &mut steps);
        let _ = view.reachable(from, 1e3, CAR, &cost, &mut scratch, &mut Vec::new());
    };
    snapshot.with_overlay(bytes).expect("opens").verify().expect("fits");
    let parts = |rows: &OverlayRows| rows.nodes[0].pieces.count;
    assert_eq!(parts(&resolved.rows), 3);
    // All pieces of all nodes but the last are the first node's.
    let mut one = resolved.rows;
    let mut first = 0;
    let nodes = one.nodes.len();
    for i in 0..nodes {
        let count = if i + 1 < nodes { 1 } else { one.pieces.len() as u32 - first };
        one.nodes[i].pieces = Range { first, count };
        for piece in &mut one.pieces[first as usize..(first + count) as usize] {
            piece.node = i as u32;
        }
        first += count;
    }
    one.node_vehicles.clear();
    check(&one, "beside it");
    one.nodes.last_mut().expect("nodes").node = 63;
    let touched = one.touched.last_mut().expect("words");
    touched.bits = (touched.bits & !(1 << touched.bits.ilog2())) | 1 << 63;
    check(&one, "a node of the map");
}

/// Whatever a damaged overlay says, nothing panics, and no search runs for ever.
#[test]
fn damaged_overlays() {
    let snapshot = two_lanes();
    let text =
        entries(&[entry("a", r#""kind":"closed""#), entry("b", r#""kind":"speed","value":3"#)]);
    let (bytes, _) = over(snapshot.map(), &text, true);
    let mut random = Random(3);
    let (mut scratch, mut steps, mut opened) = (RouteScratch::default(), Vec::new(), 0);
    for _ in 0..2000 {
        let mut bad = bytes.clone();
        for _ in 0..4 {
            let place = 128 + (random.unit() * (bad.len() - 128) as f64) as usize;
            bad[place] = (random.unit() * 256.0) as u8;
        }
        assert!(verify_overlay(&bad).is_err() || bad[..] == bytes[..]);
        let Ok(overlay) = open_overlay(&bad) else { continue };
        opened += 1;
        let view = View::new(snapshot.map(), Some(&overlay), at(0.0)).expect("the header is whole");
        let lane = lane_id(view.map(), -1);
        for s in [10.0, 50.0] {
            let _ = view.allows(lane, s, CAR);
            let _ = view.speed_rule_at(lane, s, CAR);
        }
        let [from, to] = [10.0, 90.0].map(|s| PositionOnLane { lane, s });
        let cost = ShortestLength::default();
        let _ = view.route(from, to, CAR, &cost, &mut scratch, &mut steps);
        view.entries().for_each(|entry| assert!(entry.id().len() < 10_000));
    }
    assert!(opened > 100, "{opened}");
}

/// What was placed once is not placed again, and what is put together of it is what is resolved at once.
#[test]
fn what_is_known_is_not_placed_again() {
    let snapshot = two_lanes();
    let map = snapshot.map();
    let document = |all: &[String]| {
        let text = format!(r#"{{"entries":[{}]}}"#, all.join(","));
        Document::read(text.as_bytes(), &Limits::default()).expect("a document")
    };
    let mut entries: Vec<String> =
        (0..100).map(|i| entry(&i.to_string(), r#""kind":"closed""#)).collect();
    entries.push(entry("far", r#""kind":"wet""#).replace("\"A\"", "\"Z\""));
    let mut placed = Placements::new(map, Policy::default());
    let mut check = |all: &[String], missing: &[&str]| {
        let document = document(all);
        let found = placed.missing(&document);
        let found: Vec<&str> = found.entries.iter().map(|entry| entry.id.as_str()).collect();
        assert_eq!(found, missing);
        let (kept, fresh) =
            (placed.resolve(map, &document), resolve(map, &document, Policy::default()));
        let bytes = |rows| mapd_archive::encode_overlay(rows, map.content_hash()).expect("encodes");
        assert_eq!(bytes(&kept.rows)[..], bytes(&fresh.rows)[..]);
        assert_eq!(kept.unplaced, fresh.unplaced);
        assert_eq!(placed.missing(&document).entries, []);
    };
    let all: Vec<String> = (0..100).map(|i| i.to_string()).chain(["far".to_owned()]).collect();
    check(&entries, &all.iter().map(String::as_str).collect::<Vec<_>>());
    entries.push(entry("new", r#""kind":"closed""#));
    check(&entries, &["new"]);
    entries[7] = entry("7", r#""kind":"wet""#);
    check(&entries, &["7"]);
    entries.truncate(3);
    check(&entries, &[]);
    let other = open_text(&with_signal());
    assert!(!placed.is_of(other.map()));
}
