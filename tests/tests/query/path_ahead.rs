//! What lies along a path: lanes that reach the goal, speed limits, signals, lines, junctions.

use crate::path_meets::lane_by;
use crate::paths::each_path;
use mapd_client::Map;
use mapd_client::route::{PositionOnLane, RouteScratch, ShortestLength};
use mapd_client::vocabulary::{Relation, RelationReason, VehicleClass};
use mapd_query::path::{
    PathBuffer, PathError, PathFactKind, PathOptions, PathSegment, PathSpeed, Yields, YieldsBy,
    steps_of_lanes,
};
use mapd_query::rules::{Basis, SpeedOrigin};
use mapd_query::signals::SignalsAhead;
use mapd_query::vocabulary::RoadRules;
use mapd_tests::crossroads::{ARMS, crossroads, signal};
use mapd_tests::graph_maps::{Line, document, lane, road, section, wide};
use mapd_tests::maps::open_text;

const CAR: VehicleClass = VehicleClass::PassengerCar;
const KMH: f64 = 1.0 / 3.6;

/// The route from a place to another as a path, and what a test asks of it.
fn along(
    map: Map<'_>,
    from: (&str, f64),
    to: (&str, f64),
    ask: impl Fn(mapd_query::path::Path<'_, '_>),
) {
    let place = |(key, s): (&str, f64)| PositionOnLane { lane: lane_by(map, key).lane_id(), s };
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let cost = ShortestLength::default();
    let route = map.route(place(from), place(to), CAR, &cost, &mut scratch, &mut steps);
    route.expect("an answer").expect("a way");
    let mut buffer = PathBuffer::default();
    ask(map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path"));
}

#[test]
fn from_every_lane_of_a_stretch_the_goal_is_reached_as_told() {
    each_path(|map, path, _, name, _| {
        let mut found: Vec<PathSegment> = Vec::new();
        path.segments(CAR, &mut found);
        let mut end = 0.0;
        for (i, own) in found.iter().enumerate() {
            let [from, to] = own.along;
            assert!(from == end || found[i - 1].along == own.along, "{name}: {own:?}");
            end = to;
            assert!(
                own.last_change <= own.lane_end && own.lane_end <= path.length(),
                "{name}: {own:?}"
            );
            assert!(own.last_change >= to, "{name}: {own:?}");
            if own.changes == 0 {
                assert_eq!(own.last_change, path.length(), "{name}: {own:?}");
                continue;
            }
            // A change is for a lane with one less, no farther than told.
            let mut later = found[i..].iter().chain(found[..i].iter().rev());
            let nearer = later
                .any(|other| other.changes == own.changes - 1 && other.along[1] <= own.last_change);
            assert!(nearer, "{name}: {own:?}");
        }
        assert_eq!(end, path.length(), "{name}");
        // The path itself shows how many changes are enough.
        let changes = |along: f64| {
            let enter =
                |e| matches!(e, mapd_query::route::Enter::Left | mapd_query::route::Enter::Right);
            path.joints().iter().filter(|j| j.along >= along && enter(j.enter)).count()
        };
        for own in found.iter().filter(|own| own.driven) {
            let at = path.at(own.along[0]).expect("a place");
            if at.lane == own.lane {
                assert!(own.changes as usize <= changes(own.along[0]), "{name}: {own:?}");
            }
            assert!(map.lane(own.lane).is_ok());
        }
    });
}

/// Three lanes; from the left ones the goal on the right one is reached until the mark turns solid at s = 60 m.
#[test]
fn a_solid_mark_ends_the_changes() {
    let marks = |text: &str| text.to_owned();
    let broken = marks(
        "<roadMark sOffset=\"0\" type=\"broken\" laneChange=\"both\"/><roadMark sOffset=\"60\" type=\"solid\" laneChange=\"none\"/>",
    );
    let free = marks("<roadMark sOffset=\"0\" type=\"broken\" laneChange=\"both\"/>");
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    let lanes = wide(-1, "", "", width, &free) + &wide(-2, "", "", width, &broken) + &lane(-3, "");
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let text = document(&road("1", "junction=\"-1\"", line, "", &section(0.0, "", &lanes)));
    let snapshot = open_text(&text);
    let map = snapshot.map();
    let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
    steps_of_lanes(map, &[lane_by(map, "1:0:-3").lane_id()], [10.0, 90.0], &mut steps)
        .expect("steps");
    let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    let mut found = Vec::new();
    path.segments(CAR, &mut found);
    let told = |own: &PathSegment| {
        let key = map.lane(own.lane).expect("a lane").number();
        (own.along, key, own.changes, own.last_change, own.driven)
    };
    let all: Vec<_> = found.iter().map(told).collect();
    assert_eq!(
        all,
        [
            ([0.0, 50.0], -1, 2, 50.0, false),
            ([0.0, 50.0], -2, 1, 50.0, false),
            ([0.0, 50.0], -3, 0, 80.0, true),
            ([50.0, 80.0], -3, 0, 80.0, true),
        ]
    );
}

#[test]
fn what_a_path_comes_by_is_what_the_route_comes_by() {
    each_path(|map, path, steps, name, _| {
        let (mut facts, mut signals, mut lines) = (Vec::new(), SignalsAhead::default(), Vec::new());
        path.facts(&mut facts);
        map.signals_along(steps, &mut signals).expect("signals");
        map.lines_along(steps, &mut lines).expect("lines");
        let mut last = 0.0;
        let (mut junctions, mut types) = (0.0, 0.0);
        for fact in &facts {
            let [from, to] = fact.along;
            assert!(last <= from && from <= to && to <= path.length(), "{name}: {fact:?}");
            last = from;
            match fact.kind {
                PathFactKind::Junction { .. } => junctions += to - from,
                PathFactKind::LaneType(_) => types += to - from,
                PathFactKind::Signal { signal, .. } => {
                    let known = signals.iter().any(|one| {
                        one.signal == signal && (one.distance - from).abs() < 1e-2 * (1.0 + from)
                    });
                    assert!(known, "{name}: {fact:?}");
                }
                PathFactKind::Line { line, .. } => {
                    assert!(lines.iter().any(|one| one.line.source == line.source), "{name}");
                }
                _ => {}
            }
        }
        let told = facts.iter().filter(|f| matches!(f.kind, PathFactKind::Signal { .. })).count();
        let valid = signals
            .iter()
            .filter(|one| map.signal(one.signal).is_ok_and(|signal| !signal.is_invalidated()));
        // A place of the route where a lane is only changed from is none of the path.
        assert!(told <= valid.count(), "{name}");
        let of_junctions = path
            .lanes()
            .filter(|own| map.lane(own.lane).expect("a lane").road().junction().is_some());
        let length: f64 = of_junctions.map(|own| own.along[1] - own.along[0]).sum();
        let rounding = 1e-6 * (1.0 + path.length());
        assert!((junctions - length).abs() < rounding, "{name}: {junctions}, {length}");
        assert!((types - path.length()).abs() < rounding, "{name}: {types}");
    });
}

#[test]
fn speeds_cover_the_path_and_agree_with_each_place() {
    each_path(|_, path, _, name, random| {
        let mut found: Vec<PathSpeed> = Vec::new();
        path.speeds(&mut found);
        let mut end = 0.0;
        for own in &found {
            assert_eq!(own.along[0], end, "{name}");
            end = own.along[1];
        }
        assert_eq!(end, path.length(), "{name}");
        for _ in 0..20 {
            let along = random.between(0.0, path.length());
            let own = found.iter().find(|own| own.along[0] <= along && along < own.along[1]);
            let own = own.expect("a stretch");
            assert_eq!(path.speed_at(along), Some(own.rule), "{name}: {along}");
        }
    });
}

/// A zone that is entered on arm 0 goes on behind the junction: there, lanes alone cannot say what holds, a path can.
#[test]
fn a_zone_lasts_beyond_junctions_until_it_ends() {
    let zone = signal("Z", 50.0, 5.0, "-", "274.1", "value=\"30\" unit=\"km/h\"");
    let end = signal("E", 40.0, -5.0, "+", "274.2", "");
    let limit = signal("L", 20.0, 5.0, "-", "274", "value=\"50\" unit=\"km/h\"");
    let mut signals: [String; ARMS] = std::array::from_fn(|_| String::new());
    (signals[0], signals[1]) = (zone.clone(), end.clone());
    let snapshot = open_text(&crossroads(signals, "", ""));
    let map = snapshot.map();
    let rule = |key: &str, s: f64| lane_by(map, key).speed_rule_at(s);
    assert_eq!(rule("0:0:1", 80.0).max, None);
    assert_eq!(rule("0:0:1", 20.0).max, Some(30.0 * KMH));
    for key in ["01:0:-1", "02:0:-1", "03:0:-1"] {
        assert_eq!(
            (rule(key, 5.0).max, rule(key, 5.0).origin),
            (Some(30.0 * KMH), SpeedOrigin::Signal)
        );
    }
    assert_eq!(rule("12:0:-1", 5.0).max, None);
    for (key, s) in [("1:0:-1", 20.0), ("2:0:-1", 90.0)] {
        assert_eq!((rule(key, s).max, rule(key, s).origin), (None, SpeedOrigin::Depends), "{key}");
        let mut along = lane_by(map, key).speed_rules();
        let own = along.find(|own| own.s.low <= s && s <= own.s.high).expect("a stretch");
        assert_eq!((own.rule, own.lowest), (rule(key, s), Some(30.0 * KMH)), "{key}");
    }
    assert_eq!(rule("1:0:-1", 60.0).origin, SpeedOrigin::None);
    along(map, ("0:0:1", 70.0), ("1:0:-1", 90.0), |path| {
        let mut found = Vec::new();
        path.speeds(&mut found);
        let told: Vec<_> = found.iter().map(|own| (own.along[0].round(), own.rule.max)).collect();
        let there = 20.0 + 60.0;
        assert_eq!(told[..2], [(0.0, None), (20.0, Some(30.0 * KMH))], "{found:?}");
        assert_eq!(told.len(), 3, "{found:?}");
        assert!(told[2].0 > there && told[2].1.is_none(), "{found:?}");
    });
    along(map, ("3:0:1", 70.0), ("1:0:-1", 20.0), |path| {
        assert_eq!(path.speed_at(path.length()).expect("an answer").origin, SpeedOrigin::None);
    });
    // Where all come from the zone, a lane alone can say; a limit within the zone ends at the junction, the zone does not.
    let signals = std::array::from_fn(|_| format!("{zone}{limit}").replace("\"Z\"", "\"Z\""));
    let numbered = |(i, text): (usize, String)| {
        text.replace("\"Z\"", &format!("\"Z{i}\"")).replace("\"L\"", &format!("\"L{i}\""))
    };
    let signals: [String; ARMS] = signals;
    let mut arms = signals.into_iter().enumerate().map(numbered);
    let signals = std::array::from_fn(|_| arms.next().expect("an arm"));
    let snapshot = open_text(&crossroads(signals, "", ""));
    let map = snapshot.map();
    let rule = |key: &str, s: f64| lane_by(map, key).speed_rule_at(s).max;
    assert_eq!(rule("0:0:1", 40.0), Some(30.0 * KMH));
    assert_eq!(rule("0:0:1", 10.0), Some(50.0 * KMH));
    assert_eq!(rule("1:0:-1", 50.0), Some(30.0 * KMH));
}

/// What is left of a path, and what is driven until a place, are paths of their own.
#[test]
fn a_part_of_a_path_is_a_path() {
    each_path(|map, path, steps, name, random| {
        let (mut part, mut buffer) = (Vec::new(), PathBuffer::default());
        for _ in 0..4 {
            let a = random.between(0.0, path.length());
            let b = random.between(0.0, path.length());
            let [from, to] = [a.min(b), a.max(b)];
            if to - from < 1e-3 {
                continue;
            }
            path.steps_between(steps, [from, to], &mut part).expect("steps");
            let own = map.path(&part, &PathOptions::default(), &mut buffer);
            let own = own.unwrap_or_else(|error| panic!("{name}: {error}: {part:?}"));
            // S between stations of the stored line, where the path is cut.
            let off = (own.length() - (to - from)).abs();
            assert!(off < 4e-4, "{name}: {off} of {from} to {to}");
            let places = [(0.0, from), (own.length(), to)];
            for (mine, along) in places {
                let (p, q) = (own.at(mine).expect("a place"), path.at(along).expect("a place"));
                let jumps = path.joints().iter().any(|joint| (joint.along - along).abs() < 1e-6);
                assert!(jumps || p.position.distance(q.position) < 1e-6, "{name}: {p:?}, {q:?}");
            }
        }
        let mut part = |along| path.steps_between(steps, along, &mut part).err();
        assert_eq!(part([2.0, 1.0]), Some(PathError::NotInOrder));
        assert_eq!(part([f64::NAN, 1.0]), Some(PathError::NotInOrder));
        assert_eq!(
            path.steps_between(&[], [0.0, 1.0], &mut Vec::new()).err(),
            Some(PathError::OtherSteps)
        );
    });
}

/// Right before left holds where the caller says so, among equal roads; in Japan it is the left one, in Great Britain neither.
#[test]
fn who_yields_by_rule_is_for_the_caller_to_say() {
    let rules = |country: &str| RoadRules::of(country).expect("its rules");
    assert_eq!(RoadRules::of("XX"), None);
    let check = |arm: usize, kind: &str, expected: [Option<Relation>; 3]| {
        let text = crossroads(Default::default(), "", "");
        let road = format!("<road id=\"{arm}\"");
        let (before, behind) = text.split_once(&road).expect("the road");
        let behind = behind.replacen("<planView>", &format!("{kind}<planView>"), 1);
        let snapshot = open_text(&format!("{before}{road}{behind}"));
        let map = snapshot.map();
        // Both straight on; arm 3 is to the right of who comes in on arm 0... seen from the middle.
        let own = lane_by(map, "02:0:-1");
        let other =
            own.right_of_way().find(|one| one.other().is_some_and(|lane| lane.road().id() == "13"));
        let other = other.expect("they cross");
        assert_eq!((other.basis(), other.relation()), (Basis::Unknown, Relation::Unknown));
        assert_eq!(other.reason(), RelationReason::FromTheRight);
        let found = ["DE", "JP", "GB"].map(|country| other.relation_by(rules(country)));
        assert_eq!(found, expected, "{kind}");
    };
    // Who comes from arm 1 drives south, from the right of who drives west.
    let (yields, priority) = (Some(Relation::Yields), Some(Relation::Priority));
    check(0, "", [yields, priority, None]);
    check(0, "<type s=\"0\" type=\"motorway\"/>", [None; 3]);
    check(0, "<type s=\"0\" type=\"town\"><speed max=\"50\" unit=\"km/h\"/></type>", [None; 3]);
    let snapshot = open_text(&crossroads(Default::default(), "", ""));
    let map = snapshot.map();
    along(map, ("0:0:1", 70.0), ("2:0:-1", 70.0), |path| {
        let (mut together, mut found) = (Vec::new(), Vec::new());
        path.conflicts(&mut together, &mut found);
        assert!(
            found.iter().all(|one| one.yields == Yields::Unknown && one.equal_roads),
            "{found:?}"
        );
        for one in &found {
            let YieldsBy { yields, basis } = one.yields_by(rules("DE"));
            let known = yields != Yields::Unknown;
            assert_eq!(known, basis == Basis::Rule, "{one:?}");
            assert_eq!(known, one.reason != RelationReason::None, "{one:?}");
        }
        assert!(found.iter().any(|one| one.yields_by(rules("DE")).yields == Yields::Yields));
    });
}
