//! What a view says along routes and paths: entries that are met, today's limits and times, where a change of lane is due.

use crate::overlays::{at, entries, entry, lane_id, two_lanes, with};
use mapd_archive::open_overlay;
use mapd_query::path::{
    Corridor, Path, PathBuffer, PathError, PathFactKind, PathOptions, PathSegment, Yields,
    steps_of_lanes,
};
use mapd_query::route::{
    Enter, PositionOnLane, RouteScratch, RouteStep, ShortestLength, ShortestTime,
};
use mapd_query::rules::SpeedOrigin;
use mapd_query::view::View;
use mapd_query::vocabulary::VehicleClass;
use mapd_query::{Map, QueryError};
use mapd_tests::carried;
use mapd_tests::crossroads::{ARMS, crossroads, left_hand_crossroads, light, signal};
use mapd_tests::maps::{Random, open, open_text};
use mapd_tests::overlays::over;

const CAR: VehicleClass = VehicleClass::PassengerCar;

/// A step along a lane on the right.
fn step(map: Map<'_>, lane: i32, enter: Enter, [s_from, s_to]: [f64; 2]) -> RouteStep {
    RouteStep { lane: lane_id(map, lane), forward: true, enter, s_from, s_to, s_latest: s_from }
}

/// Runs with the path along one lane from s to s.
fn along(view: View<'_>, lane: i32, span: [f64; 2], test: impl FnOnce(Path<'_, '_>)) {
    let (map, mut steps, mut buffer) = (view.map(), Vec::new(), PathBuffer::default());
    steps_of_lanes(map, &[lane_id(map, lane)], span, &mut steps).expect("steps");
    test(map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path"));
}

/// What a route between places meets: what it drives over or stands in, not what it leaves before or comes back behind.
#[test]
fn what_a_route_meets() {
    type Place = (i32, f64);
    let check = |text: &str, from: Place, to: Place, changes: u32, expected: &[&str]| {
        with(text, at(0.0), |view| {
            let place = |(lane, s): Place| PositionOnLane { lane: lane_id(view.map(), lane), s };
            let (mut scratch, mut steps, mut met) =
                (RouteScratch::default(), Vec::new(), Vec::new());
            let cost = ShortestLength::default();
            let route = view.route(place(from), place(to), CAR, &cost, &mut scratch, &mut steps);
            let route = route.expect("an answer").expect("a route");
            assert_eq!(route.lane_changes, changes, "{from:?} to {to:?}");
            view.restrictions_along(&steps, CAR, &mut met).expect("an answer");
            let met: Vec<_> = met.iter().map(|one| one.entry.id()).collect();
            assert_eq!(met, expected, "{from:?} to {to:?}: {steps:?}");
        });
    };
    let closed = entries(&[entry("works", r#""kind":"closed""#)]);
    // Round it: the lane is entered again exactly where the closure ends.
    check(&closed, (-1, 10.0), (-1, 90.0), 2, &[]);
    check(&closed, (-1, 10.0), (-1, 40.0 - 1e-9), 0, &[]);
    check(&closed, (-2, 10.0), (-1, 90.0), 1, &[]);
    // The vehicle stands in it, or on its edges, and leaves at once.
    check(&closed, (-1, 50.0), (-2, 90.0), 1, &["works"]);
    check(&closed, (-1, 40.0), (-2, 90.0), 1, &["works"]);
    check(&closed, (-1, 60.0), (-2, 90.0), 1, &[]);
    check(&closed, (-1, 50.0), (-1, 90.0), 0, &["works"]);
    let slow = entries(&[entry("slow", r#""kind":"speed","value":5"#)]);
    check(&slow, (-1, 10.0), (-1, 90.0), 0, &["slow"]);
    check(&slow, (-1, 10.0), (-1, 40.0), 0, &[]);
    check(&slow, (-1, 60.0), (-1, 90.0), 0, &[]);
    check(&slow, (-1, 45.0), (-1, 46.0), 0, &["slow"]);
    let trucks = entries(&[entry("slow", r#""kind":"speed","value":5,"vehicles":["truck"]"#)]);
    check(&trucks, (-1, 10.0), (-1, 90.0), 0, &[]);
}

/// Steps that end where a closure begins, and go on beside it: it is not met.
#[test]
fn a_change_of_lane_before_a_closure() {
    let closed = entries(&[entry("works", r#""kind":"closed""#)]);
    with(&closed, at(0.0), |view| {
        let mut met = Vec::new();
        let mut count = |first_to: f64| {
            let steps = [
                step(view.map(), -1, Enter::Start, [10.0, first_to]),
                step(view.map(), -2, Enter::Right, [first_to, 90.0]),
            ];
            view.restrictions_along(&steps, CAR, &mut met).expect("an answer");
            met.len()
        };
        assert_eq!([count(40.0), count(40.1), count(60.0)], [0, 1, 1]);
    });
}

/// Today's limits along a path of no limits in the map: where an entry states one, by which, and what that takes.
#[test]
fn limits_and_times_along_a_path() {
    let slow = |id: &str, value: f64, s: [f64; 2]| {
        let text = entry(id, &format!(r#""kind":"speed","value":{value}"#));
        text.replace("[40,60]", &format!("{s:?}"))
    };
    let both = entries(&[
        slow("a", 5.0, [30.0, 50.0]),
        slow("b", 10.0, [40.0, 60.0]),
        slow("trucks", 1.0, [10.0, 90.0]).replace(r#""kind""#, r#""vehicles":["truck"],"kind""#),
    ]);
    type Stretch = (f64, f64, Option<f64>, Option<&'static str>);
    let check = |lane: i32, span: [f64; 2], expected: &[Stretch], time: f64, unlimited: f64| {
        let text = both.replace(r#""lane":-1"#, &format!(r#""lane":{lane}"#));
        with(&text, at(0.0), |view| {
            along(view, lane, span, |path| {
                let mut found = Vec::new();
                view.speeds_on_path(&path, CAR, &mut found).expect("an answer");
                assert_eq!(found.len(), expected.len(), "{found:?}");
                for (own, (from, to, max, by)) in found.iter().zip(expected) {
                    let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
                    assert!(near(own.along[0], *from) && near(own.along[1], *to), "{found:?}");
                    let entry = own.today.restriction.map(|one| one.entry.id());
                    assert_eq!((own.today.max, entry), (*max, *by), "{found:?}");
                }
                let all = [0.0, path.length()];
                let sum = view.travel_time_on_path(&path, all, CAR).expect("an answer");
                assert!((sum.time - time).abs() < 1e-9, "{sum:?}");
                assert!((sum.unlimited - unlimited).abs() < 1e-9, "{sum:?}");
                let backwards = view.travel_time_on_path(&path, [1.0, 0.0], CAR);
                assert_eq!(backwards, Err(PathError::NotInOrder));
            });
        });
    };
    let on_the_right = [
        (0.0, 20.0, None, None),
        (20.0, 40.0, Some(5.0), Some("a")),
        (40.0, 50.0, Some(10.0), Some("b")),
        (50.0, 80.0, None, None),
    ];
    check(-1, [10.0, 90.0], &on_the_right, 5.0, 50.0);
    let on_the_left = [
        (0.0, 30.0, None, None),
        (30.0, 40.0, Some(10.0), Some("b")),
        (40.0, 60.0, Some(5.0), Some("a")),
        (60.0, 80.0, None, None),
    ];
    check(1, [90.0, 10.0], &on_the_left, 5.0, 50.0);
    check(-1, [35.0, 45.0], &[(0.0, 10.0, Some(5.0), Some("a"))], 2.0, 0.0);
}

/// Before what is closed a change of lane is due; where no way leads round it, no lane leads to the goal. A vehicle that stands in it may leave.
#[test]
fn segments_end_before_what_is_closed() {
    /// Lane, S, changes that are left, last place for the next.
    type Segment = (i32, [f64; 2], u32, f64);
    let check = |closed: &[i32], span: [f64; 2], expected: &[Segment]| {
        let one = |lane: &i32| {
            let text = entry(&lane.to_string(), r#""kind":"closed""#);
            text.replace(r#""lane":-1"#, &format!(r#""lane":{lane}"#))
        };
        let text = entries(&closed.iter().map(one).collect::<Vec<_>>());
        with(&text, at(0.0), |view| {
            along(view, -1, span, |path| {
                let mut found = Vec::new();
                view.segments_on_path(&path, CAR, &mut found).expect("an answer");
                let own = |own: &PathSegment| {
                    let lane = view.map().lane(own.lane).expect("a lane");
                    let along = own.along.map(|along| (along * 1e6).round() * 1e-6);
                    let last = (own.last_change * 1e6).round() * 1e-6;
                    (lane.number(), along, own.changes, last)
                };
                let found: Vec<Segment> = found.iter().map(own).collect();
                assert_eq!(found, expected, "{closed:?} closed, from s to s {span:?}");
            });
        });
    };
    let all = [0.0, 80.0];
    check(&[], [10.0, 90.0], &[(-1, all, 0, 80.0), (-2, all, 1, 80.0)]);
    check(
        &[-1],
        [10.0, 90.0],
        &[
            (-1, [0.0, 30.0], 2, 30.0),
            (-2, [0.0, 30.0], 1, 80.0),
            (-1, [30.0, 50.0], 0, 80.0),
            (-2, [30.0, 50.0], 1, 80.0),
            (-1, [50.0, 80.0], 0, 80.0),
            (-2, [50.0, 80.0], 1, 80.0),
        ],
    );
    check(
        &[-2],
        [10.0, 90.0],
        &[
            (-1, [0.0, 30.0], 0, 80.0),
            (-2, [0.0, 30.0], 1, 30.0),
            (-1, [30.0, 50.0], 0, 80.0),
            (-1, [50.0, 80.0], 0, 80.0),
            (-2, [50.0, 80.0], 1, 80.0),
        ],
    );
    check(
        &[-1, -2],
        [10.0, 90.0],
        &[(-1, [30.0, 50.0], 0, 80.0), (-1, [50.0, 80.0], 0, 80.0), (-2, [50.0, 80.0], 1, 80.0)],
    );
    check(&[-1, -2], [45.0, 55.0], &[(-1, [0.0, 10.0], 0, 10.0)]);
}

/// A path that changes lanes where a closure begins and ends: the changes are left to do until there.
#[test]
fn a_change_of_lane_at_a_cut() {
    let closed = entries(&[entry("works", r#""kind":"closed""#)]);
    with(&closed, at(0.0), |view| {
        let map = view.map();
        let steps = [
            step(map, -1, Enter::Start, [10.0, 40.0]),
            step(map, -2, Enter::Right, [40.0, 60.0]),
            step(map, -1, Enter::Left, [60.0, 90.0]),
        ];
        let (mut buffer, mut found) = (PathBuffer::default(), Vec::new());
        let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
        view.segments_on_path(&path, CAR, &mut found).expect("an answer");
        let own = |own: &PathSegment| {
            let lane = map.lane(own.lane).expect("a lane").number();
            (lane, own.changes, own.driven, own.last_change.round())
        };
        let found: Vec<_> = found.iter().map(own).collect();
        let expected = [
            (-1, 2, true, 30.0),
            (-2, 1, false, 80.0),
            (-2, 1, true, 80.0),
            (-1, 0, true, 80.0),
            (-2, 1, false, 80.0),
        ];
        assert_eq!(found, expected);
    });
}

/// The speeds of a corridor are those of its places, with an entry's by its own name.
#[test]
fn a_corridor_has_todays_speeds() {
    let slow = entries(&[entry("slow", r#""kind":"speed","value":5"#)]);
    with(&slow, at(0.0), |view| {
        along(view, -1, [10.0, 90.0], |path| {
            let mut room = Corridor::default();
            view.corridor(&path, 0.0, 80.0, 10.0, CAR, &mut room).expect("a corridor");
            let speeds: Vec<_> = room.speed.iter().map(|rule| rule.max).collect();
            let slow = [None, None, None, Some(5.0), Some(5.0), None, None, None, None];
            assert_eq!(speeds, slow);
            for (along, rule) in room.along.iter().zip(&room.speed) {
                let today = view.speed_on_path(&path, *along, CAR).expect("an answer");
                assert_eq!(rule.max, today.max, "at {along}");
                let stated = rule.origin == SpeedOrigin::Overlay;
                assert_eq!(stated, today.restriction.is_some(), "at {along}");
            }
        });
    });
}

/// Where nothing is said, or nothing about the vehicle, a view's answers are the path's, bit for bit.
#[test]
fn nothing_said_changes_nothing() {
    let snapshot = open(&carried("town.xodr"));
    let map = snapshot.map();
    let lanes: Vec<_> =
        map.lanes().filter(|lane| lane.nodes().any(|node| node.allows(CAR))).collect();
    let entry = |(i, lane): (usize, &mapd_query::Lane<'_>)| {
        let what = ["closed", "warning"][i % 2];
        let key = lane.key();
        format!(
            r#"{{"id":"{i}","kind":"{what}","vehicles":["truck"],"lanes":[{{"key":"{key}"}}]}}"#
        )
    };
    let all: Vec<_> = lanes.iter().enumerate().map(entry).collect();
    let (bytes, resolved) = over(map, &entries(&all), false);
    assert_eq!(resolved.unplaced, []);
    let overlay = open_overlay(&bytes).expect("opens");
    let mut random = Random(3);
    let mut place = || {
        let lane = &lanes[(random.unit() * lanes.len() as f64) as usize];
        let (from, to) = (lane.section().s_start(), lane.section().s_end());
        PositionOnLane { lane: lane.lane_id(), s: random.between(from, to) }
    };
    let (mut scratch, mut steps, mut buffer) =
        (RouteScratch::default(), Vec::new(), PathBuffer::default());
    let (mut plain, mut speeds, mut today) = (Vec::new(), Vec::new(), Vec::new());
    let (mut segments, mut room, mut own_room) =
        (Vec::new(), Corridor::default(), Corridor::default());
    let mut paths = 0;
    for _ in 0..100 {
        let (from, to) = (place(), place());
        let cost = ShortestTime::default();
        let found = map.route(from, to, CAR, &cost, &mut scratch, &mut steps).expect("an answer");
        let path = map.path(&steps, &PathOptions::default(), &mut buffer);
        let Some(path) = path.ok().filter(|_| found.is_some()) else { continue };
        paths += 1;
        let part = [0.3 * path.length(), 0.9 * path.length()];
        path.speeds(&mut speeds);
        path.segments(CAR, &mut plain);
        path.corridor(0.0, path.length(), 3.0, CAR, &mut room).expect("a corridor");
        for overlay in [None, Some(&overlay)] {
            let view = View::new(map, overlay, at(0.0)).expect("its own");
            view.speeds_on_path(&path, CAR, &mut today).expect("an answer");
            let pairs = today.iter().map(|one| (one.along, one.today.map));
            assert!(pairs.eq(speeds.iter().map(|one| (one.along, one.rule))), "{today:?}");
            let unsaid = today
                .iter()
                .all(|one| one.today.max == one.today.map.max && one.today.restriction.is_none());
            assert!(unsaid, "{today:?}");
            let time = view.travel_time_on_path(&path, part, CAR);
            assert_eq!(time, path.travel_time(part));
            view.segments_on_path(&path, CAR, &mut segments).expect("an answer");
            assert_eq!(segments, plain);
            view.corridor(&path, 0.0, path.length(), 3.0, CAR, &mut own_room).expect("a corridor");
            assert_eq!(own_room.speed, room.speed);
            assert_eq!(own_room.left_mark, room.left_mark);
            assert_eq!(own_room.outer_right, room.outer_right);
        }
    }
    assert!(paths > 50, "{paths} paths");
}

/// A path on another map is refused, and what was found before is gone.
#[test]
fn a_path_on_another_map() {
    let other = open(&carried("town.xodr"));
    let other = View::new(other.map(), None, at(0.0)).expect("a view");
    let snapshot = two_lanes();
    let view = View::new(snapshot.map(), None, at(0.0)).expect("a view");
    along(view, -1, [10.0, 90.0], |path| {
        let (mut speeds, mut segments) = (Vec::new(), Vec::new());
        view.speeds_on_path(&path, CAR, &mut speeds).expect("an answer");
        view.segments_on_path(&path, CAR, &mut segments).expect("an answer");
        assert!(!speeds.is_empty() && !segments.is_empty());
        let foreign = |error: Option<QueryError>| matches!(error, Some(QueryError::ForeignId));
        assert!(foreign(other.speeds_on_path(&path, CAR, &mut speeds).err()));
        assert!(foreign(other.segments_on_path(&path, CAR, &mut segments).err()));
        assert!(speeds.is_empty() && segments.is_empty());
        let time = other.travel_time_on_path(&path, [0.0, 1.0], CAR);
        assert!(matches!(time, Err(PathError::Map(QueryError::ForeignId))), "{time:?}");
    });
}

/// A way over a crossing under a view: each lane that meets it with all that is said of it, and who yields at the crosswalk behind the light.
fn met(view: View<'_>, keys: &[String; 3]) -> (Vec<String>, Vec<Yields>) {
    let map = view.map();
    let lane = |key: &String| map.lane_by_key(&key.parse().expect("a key")).expect("a lane");
    let lanes: Vec<_> = keys.iter().map(|key| lane(key).lane_id()).collect();
    let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
    // The first arm is driven from 40 m before the crossing, against its s.
    steps_of_lanes(map, &lanes, [40.0, 40.0], &mut steps).expect("steps");
    let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    let (mut conflicts, mut lanes, mut crossings) = (Vec::new(), Vec::new(), Vec::new());
    view.conflicts(&path, &mut conflicts, &mut lanes).expect("its own");
    view.crossings(&path, &mut crossings).expect("its own");
    let line = |one: &mapd_query::path::ConflictLane| {
        let said = (one.along, one.kind, one.yields, one.reason, one.relation, one.equal_roads);
        format!("{} {said:?} {}", map.lane(one.other).expect("a lane").key(), one.wait)
    };
    (lanes.iter().map(line).collect(), crossings.iter().map(|one| one.yields).collect())
}

/// Lights that are out of service decide as little as if the file had none of them: signs do, then its priorities, then nothing that is written. In left-hand traffic too.
#[test]
fn lights_out_of_service_decide_nothing() {
    type Make = fn([String; ARMS], &str, &str) -> String;
    let mut changed = 0;
    for (make, out) in [(crossroads as Make, -1), (left_hand_crossroads as Make, 1)] {
        for off in [&[0, 1, 2, 3][..], &[0], &[1, 3]] {
            let arms = |has_all: bool| {
                std::array::from_fn(|arm| {
                    let is_there = has_all || !off.contains(&arm);
                    let lamp = if is_there { light(&format!("L{arm}")) } else { String::new() };
                    let sign = ["206", "", "205", ""][arm];
                    let sign = signal(&format!("S{arm}"), 2.0, 5.0, "-", sign, "");
                    lamp + &sign + &signal(&format!("C{arm}"), 0.5, 0.0, "none", "293", "")
                })
            };
            let priority = "<priority high=\"1\" low=\"3\"/>";
            let [lit, dark] = [true, false].map(|all| open_text(&make(arms(all), priority, "")));
            let names: Vec<_> = off.iter().map(|arm| format!("\"L{arm}\"")).collect();
            let text = entries(&[format!(
                r#"{{"id":"off","kind":"signal-off","signals":[{}]}}"#,
                names.join(",")
            )]);
            let (bytes, resolved) = over(lit.map(), &text, false);
            assert_eq!(resolved.unplaced, []);
            let overlay = open_overlay(&bytes).expect("opens");
            let today = View::new(lit.map(), Some(&overlay), at(0.0)).expect("its own");
            let always = View::new(lit.map(), None, at(0.0)).expect("a view");
            let without = View::new(dark.map(), None, at(0.0)).expect("a view");
            for (from, to) in (0..ARMS).flat_map(|from| (0..ARMS).map(move |to| (from, to))) {
                if from == to {
                    continue;
                }
                let keys = [
                    format!("{from}:0:{}", -out),
                    format!("{from}{to}:0:{out}"),
                    format!("{to}:0:{out}"),
                ];
                let found = met(today, &keys);
                assert!(!found.0.is_empty(), "{keys:?}");
                assert_eq!(found, met(without, &keys), "{keys:?}, off {off:?}");
                changed += usize::from(found != met(always, &keys));
            }
        }
    }
    assert!(changed > 20, "{changed}");
}

/// A light that is out of service governs nothing, and who may use a lane is what holds today.
#[test]
fn facts_are_those_of_today() {
    let text = entries(&[entry("works", r#""kind":"only","vehicles":["truck"]"#)]);
    with(&text, at(0.0), |view| {
        along(view, -1, [10.0, 90.0], |path| {
            let mut facts = Vec::new();
            view.facts(&path, &mut facts).expect("its own");
            let access: Vec<_> = facts
                .iter()
                .filter_map(|fact| match fact.kind {
                    PathFactKind::Access { classes } => {
                        Some((fact.along, classes & CAR.bit() != 0))
                    }
                    _ => None,
                })
                .collect();
            assert_eq!(access, [([0.0, 30.0], true), ([30.0, 50.0], false), ([50.0, 80.0], true)]);
        });
    });
    let snapshot =
        open_text(&crossroads(std::array::from_fn(|arm| light(&format!("L{arm}"))), "", ""));
    let map = snapshot.map();
    let off = entries(&[r#"{"id":"off","kind":"signal-off","signals":["L0"]}"#.to_owned()]);
    let (bytes, _) = over(map, &off, false);
    let overlay = open_overlay(&bytes).expect("opens");
    let today = View::new(map, Some(&overlay), at(0.0)).expect("its own");
    for (arm, expected) in [("0", false), ("1", true)] {
        let lane = map.lane_by_key(&format!("{arm}:0:1").parse().expect("a key")).expect("a lane");
        let (mut steps, mut buffer, mut facts) = (Vec::new(), PathBuffer::default(), Vec::new());
        steps_of_lanes(map, &[lane.lane_id()], [40.0, 0.0], &mut steps).expect("steps");
        let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
        today.facts(&path, &mut facts).expect("its own");
        let governs = facts.iter().find_map(|fact| match fact.kind {
            PathFactKind::Signal { governs, .. } => Some(governs),
            _ => None,
        });
        assert_eq!(governs, Some(expected), "{arm}");
    }
}
