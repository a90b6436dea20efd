//! Who meets a path: lanes that merge into it, lanes of other roads at the same place, crosswalks, and the lanes that lead there.

use crate::paths::each_path;
use mapd_client::vocabulary::{Class, ConflictKind, RelationReason, VehicleClass};
use mapd_client::{Lane, Map, NearestOptions};
use mapd_query::path::{
    ConflictApproach, ConflictLane, PathBuffer, PathOptions, Yields, YieldsBy, steps_of_lanes,
};
use mapd_query::rules::Basis;
use mapd_query::vocabulary::RoadRules;
use mapd_tests::crossroads::{ARMS, crossroads, furnished, signal};
use mapd_tests::graph_maps::{Line, document, lane, link, road, section, side_road, wide};
use mapd_tests::maps::open_text;
use std::cell::Cell;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

const CAR: VehicleClass = VehicleClass::PassengerCar;
/// How far back lanes are followed `[m]`.
const BACK: f64 = 120.0;

pub(crate) fn lane_by<'a>(map: Map<'a>, key: &str) -> Lane<'a> {
    map.lane_by_key(&key.parse().expect("a key")).unwrap_or_else(|| panic!("no lane {key}"))
}

/// What meets the path over a lane from s to s.
fn meets(map: Map<'_>, keys: &[&str], ends: [f64; 2]) -> Vec<ConflictLane> {
    let lanes: Vec<_> = keys.iter().map(|key| lane_by(map, key).lane_id()).collect();
    let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
    let (mut found, mut lanes_met) = (Vec::new(), Vec::new());
    steps_of_lanes(map, &lanes, ends, &mut steps).expect("steps");
    let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    path.conflicts(&mut found, &mut lanes_met);
    lanes_met
}

/// Two roads that cross at x = 50 m without a junction, one as high above the other as told.
#[test]
fn a_road_at_the_same_place_is_met_on_the_same_level() {
    for (height, count) in [(0.0, 1), (1.0, 1), (6.0, 0)] {
        let one = section(0.0, "", &lane(-1, ""));
        let line = |x, y, heading| Line(x, y, heading, 100.0, 0.0);
        let high = format!(
            "<elevationProfile><elevation s=\"0\" a=\"{height}\" b=\"0\" c=\"0\" d=\"0\"/></elevationProfile>"
        );
        let flat = road("1", "junction=\"-1\"", line(0.0, 0.0, 0.0), "", &one);
        let across = road("2", "junction=\"-1\"", line(50.0, -50.0, FRAC_PI_2), "", &one)
            .replace("<lanes>", &format!("{high}<lanes>"));
        let snapshot = open_text(&document(&format!("{flat}{across}")));
        let found = meets(snapshot.map(), &["1:0:-1"], [10.0, 90.0]);
        assert_eq!(found.len(), count, "{height}: {found:?}");
        for own in found {
            assert_eq!((own.kind, own.yields), (ConflictKind::Overlap, Yields::Unknown));
            assert_eq!(own.other, lane_by(snapshot.map(), "2:0:-1").lane_id());
            // The other lane lies at x from 50 to 53.5 m.
            let [from, to] = own.along;
            assert!(from > 36.0 && from < 42.5 && to > 41.0 && to < 48.0, "{own:?}");
            assert_eq!(own.wait, from);
        }
    }
}

/// Conflicts of the path over lanes from s to s: keys of the lanes of each.
fn together(map: Map<'_>, keys: &[&str], ends: [f64; 2]) -> Vec<String> {
    let lanes: Vec<_> = keys.iter().map(|key| lane_by(map, key).lane_id()).collect();
    let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
    let (mut found, mut met) = (Vec::new(), Vec::new());
    steps_of_lanes(map, &lanes, ends, &mut steps).expect("steps");
    let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    path.conflicts(&mut found, &mut met);
    let key = |one: &ConflictLane| map.lane(one.other).expect("a lane").key().to_string();
    let keys = |lanes: &[ConflictLane]| lanes.iter().map(key).collect::<Vec<_>>().join(" ");
    found.iter().map(|one| keys(one.lanes_of(&met))).collect()
}

/// A road that crosses another aslant, without a junction: sections cut neither its lane nor the path's into several conflicts, as long as their
/// lanes lead into each other; in left-hand traffic too.
#[test]
fn sections_do_not_cut_conflicts() {
    for (rule, id) in [("", -1), (" rule=\"LHT\"", 1)] {
        let attributes = format!("junction=\"-1\"{rule}");
        let side = |s: f64, links: &str| {
            let own = lane(id, links);
            if id < 0 { section(s, "", &own) } else { section(s, &own, "") }
        };
        let cut = |at: f64, first: &str, second: &str| side(0.0, first) + &side(at, second);
        let numbers = [format!("s{id}"), format!("p{id}")];
        let linked = |at: f64| cut(at, &numbers[0], &numbers[1]);
        let ask = |flat: &str, across: &str, keys: &[&str]| {
            let flat = road("1", &attributes, Line(0.0, 0.0, 0.0, 100.0, 0.0), "", flat);
            let begin = 50.0 * FRAC_PI_4.sin();
            let line = Line(50.0 - begin, -begin, FRAC_PI_4, 100.0, 0.0);
            let across = road("2", &attributes, line, "", across);
            let snapshot = open_text(&document(&(flat + &across)));
            together(snapshot.map(), keys, [10.0, 90.0])
        };
        // The lanes are cut in the middle of what they have in common: the path's at x, the other at y.
        let off = 1.75 * f64::from(id) * (0.5 * FRAC_PI_4).tan();
        let (x, y) = (50.0 - off, 50.0 + off);
        let [own, next, first, second] =
            ["1:0", "1:1", "2:0", "2:1"].map(|section| format!("{section}:{id}"));
        let whole = side(0.0, "");
        let found = ask(&whole, &linked(y), &[&own]);
        assert_eq!(found, [format!("{first} {second}")], "{rule}");
        let found = ask(&linked(x), &whole, &[&own, &next]);
        assert_eq!(found, std::slice::from_ref(&first), "{rule}");
        // Without links neither leads into the other.
        assert_eq!(ask(&whole, &cut(y, "", ""), &[&own]), [first, second], "{rule}");
    }
}

/// The right lane ends where its section does: its traffic comes into the lane beside it.
#[test]
fn a_lane_that_ends_beside_merges() {
    let free = "<roadMark sOffset=\"0\" type=\"broken\" laneChange=\"both\"/>";
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    let two = wide(-1, "", "s-1", width, free) + &wide(-2, "", "", width, free);
    let one = lane(-1, "p-1");
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let both = section(0.0, "", &two) + &section(60.0, "", &one);
    let text = document(&road("1", "junction=\"-1\"", line, "", &both));
    let snapshot = open_text(&text);
    let map = snapshot.map();
    let found = meets(map, &["1:0:-1", "1:1:-1"], [10.0, 90.0]);
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!((found[0].kind, found[0].along), (ConflictKind::Merge, [0.0, 50.0]));
    assert_eq!(found[0].other, lane_by(map, "1:0:-2").lane_id());
}

/// Two roads that cross at x = 50 m without a junction: signs up to 30 m before say who goes first, and a line where to wait.
#[test]
fn signs_outside_junctions_say_who_goes_first() {
    let one = section(0.0, "", &lane(-1, ""));
    let signs = |text: String| format!("<signals>{text}</signals></road>");
    let check = |own: &[(&str, f64)],
                 other: &[(&str, f64)],
                 expected: (Yields, RelationReason),
                 wait: f64| {
        let sign = |road: &str, list: &[(&str, f64)]| -> String {
            let all = list.iter().enumerate();
            all.map(|(i, (kind, s))| signal(&format!("{road}{i}"), *s, -5.0, "+", kind, ""))
                .collect()
        };
        let flat = road("1", "junction=\"-1\"", Line(0.0, 0.0, 0.0, 100.0, 0.0), "", &one)
            .replace("</road>", &signs(sign("a", own)));
        let across =
            road("2", "junction=\"-1\"", Line(50.0, -50.0, FRAC_PI_2, 100.0, 0.0), "", &one)
                .replace("</road>", &signs(sign("b", other)));
        let snapshot = open_text(&document(&format!("{flat}{across}")));
        let found = meets(snapshot.map(), &["1:0:-1"], [10.0, 90.0]);
        assert_eq!(found.len(), 1, "{own:?}, {other:?}: {found:?}");
        let told = &found[0];
        assert_eq!((told.yields, told.reason), expected, "{own:?}, {other:?}");
        let basis = if expected.0 == Yields::Unknown { Basis::Unknown } else { Basis::Written };
        let rules = RoadRules::of("DE").expect("its rules");
        assert_eq!(told.yields_by(rules), YieldsBy { yields: expected.0, basis });
        // On the other road, s is 46.5 to 50 m where this lane lies.
        let [from, to] = told.other_s;
        assert!(from > 46.0 && from < 47.0 && to > 49.0 && to < 50.1, "{told:?}");
        assert!(
            (told.wait - if wait > 0.0 { wait } else { told.along[0] }).abs() < 1e-9,
            "{told:?}"
        );
    };
    let unknown = (Yields::Unknown, RelationReason::None);
    check(&[], &[], unknown, 0.0);
    check(&[("205", 40.0)], &[], (Yields::Yields, RelationReason::YieldSign), 0.0);
    check(&[("206", 40.0)], &[], (Yields::Yields, RelationReason::StopSign), 0.0);
    check(&[("206", 40.0), ("294", 42.0)], &[], (Yields::Yields, RelationReason::StopSign), 32.0);
    check(&[], &[("205", 40.0)], (Yields::Priority, RelationReason::YieldSign), 0.0);
    check(&[("306", 30.0)], &[], (Yields::Priority, RelationReason::PriorityRoad), 0.0);
    check(&[("205", 40.0)], &[("205", 40.0)], unknown, 0.0);
    check(&[("205", 40.0)], &[("206", 40.0)], (Yields::Priority, RelationReason::StopSign), 0.0);
    // Too far before, and behind.
    check(&[("205", 12.0)], &[("205", 12.0)], unknown, 0.0);
    check(&[("205", 60.0), ("294", 60.0)], &[("205", 60.0)], unknown, 0.0);
}

/// A ramp comes in at a slight angle, without a junction: both lie over each other before they are one, and who gives way waits before that.
#[test]
fn a_ramp_is_waited_for_before_both_lie_over_each_other() {
    const ANGLE: f64 = 0.1;
    let own = |links: &str| section(0.0, "", &lane(-1, links));
    let main = road(
        "1",
        "junction=\"-1\"",
        Line(-100.0, 0.0, 0.0, 100.0, 0.0),
        &link("s road 2 start"),
        &own("s-1"),
    );
    let next = road(
        "2",
        "junction=\"-1\"",
        Line(0.0, 0.0, 0.0, 100.0, 0.0),
        &link("p road 1 end"),
        &own("p-1"),
    );
    let from = (-100.0 * ANGLE.cos(), -100.0 * ANGLE.sin());
    let ramp = road(
        "3",
        "junction=\"-1\"",
        Line(from.0, from.1, ANGLE, 100.0, 0.0),
        &link("s road 2 start"),
        &own("s-1"),
    );
    let yields = signal("Y", 45.0, -5.0, "+", "205", "");
    let ramp = ramp.replace("</road>", &format!("<signals>{yields}</signals></road>"));
    let snapshot = open_text(&document(&(main + &next + &ramp)));
    let found = meets(snapshot.map(), &["1:0:-1", "2:0:-1"], [10.0, 90.0]);
    assert_eq!(found.len(), 1, "{found:?}");
    let told = &found[0];
    assert_eq!(told.kind, ConflictKind::Merge);
    assert_eq!(
        (told.yields, told.reason),
        (Yields::Priority, RelationReason::YieldSign),
        "{told:?}"
    );
    // The ramp's left edge meets the right one of the main road, 3.5 m beside its line, so far before the end.
    let apart = 3.5 / ANGLE.sin();
    let [from, to] = told.along;
    assert!((to - 90.0).abs() < 1e-9 && (from - (90.0 - apart)).abs() < 4.0, "{told:?}");
    let [from, to] = told.other_s;
    assert!((from - (100.0 - apart)).abs() < 4.0 && (to - 100.0).abs() < 1.0, "{told:?}");
    assert_eq!(told.wait, told.along[0]);
}

/// A side road without connecting roads leads into the middle of a lane, at s = 60 m, and is entered from there, and from a road before it.
#[test]
fn what_leads_into_or_out_of_the_middle_of_a_lane_merges_there() {
    let text = side_road("elementId=\"2\" elementS=\"0\" elementDir=\"+\"");
    let merges = |text: &str, keys: &[&str], ends: [f64; 2], other: &str| {
        let snapshot = open_text(text);
        let other = lane_by(snapshot.map(), other).lane_id();
        let mut found = meets(snapshot.map(), keys, ends);
        found.retain(|own| own.other == other && own.kind == ConflictKind::Merge);
        assert_eq!(found.len(), 1, "{keys:?}: {found:?}");
        found[0]
    };
    let into = merges(&text, &["1:0:-1"], [10.0, 110.0], "2:0:1");
    assert!((into.along[1] - 50.0).abs() < 1e-6 && into.other_s[0] == 0.0, "{into:?}");
    let (main, side) = text.split_at(text.find("<road id=\"2\"").expect("the side road"));
    let before = road(
        "3",
        "junction=\"-1\"",
        Line(60.0, 46.5, -FRAC_PI_2, 50.0, 0.0),
        &link("s road 2 start"),
        &section(0.0, "", &lane(-1, "s-1")),
    );
    let linked = side
        .replacen("<link></link>", &format!("<link>{}</link>", link("p road 3 end")), 1)
        .replacen(&lane(-1, ""), &lane(-1, "p-1"), 1);
    let text = format!("{main}{before}{linked}");
    let out_of = merges(&text, &["3:0:-1", "2:0:-1"], [10.0, 40.0], "1:0:-1");
    assert!((out_of.along[1] - 40.0).abs() < 1e-6, "{out_of:?}");
    // The main road's lane is left at s = 60 m, not where it ends.
    assert!(out_of.other_s[0] <= 60.0 && out_of.other_s[1] < 70.0, "{out_of:?}");
}

/// A lane that leaves the main road of a virtual junction was told as one that crosses who goes straight on.
#[test]
fn who_leaves_a_main_road_meets_nobody_there() {
    let all = mapd_tests::graph_maps::all();
    let own = all.iter().find(|map| map.name == "virtual junction with a side road");
    let own = own.expect("the map");
    let snapshot = open_text(&own.text);
    let map = snapshot.map();
    let found = meets(map, &["1:0:-1"], [0.0, 120.0]);
    let told: Vec<_> = found.iter().map(|own| (own.other, own.kind)).collect();
    assert_eq!(told, [(lane_by(map, "6:0:-1").lane_id(), ConflictKind::Merge)], "{found:?}");
    // It enters at s = 75 m.
    assert!(found[0].along[0] > 60.0 && found[0].along[0] < 74.0, "{found:?}");
    assert!((found[0].along[1] - 75.0).abs() < 1.0, "{found:?}");
    let kinds = lane_by(map, "1:0:-1").conflicts().map(|own| own.kind()).collect::<Vec<_>>();
    assert_eq!(kinds, [ConflictKind::Merge]);
    assert_eq!(meets(map, &["5:0:-1", "2:0:-1"], [0.0, 40.0]), []);
    // Who comes against them on a lane for both directions meets those who leave.
    let both = own.text.replacen("type=\"driving\"", "type=\"bidirectional\"", 2);
    let snapshot = open_text(&both);
    let lane = lane_by(snapshot.map(), "1:0:-1");
    let others = lane.conflicts().filter_map(|own| Some(own.other()?.key().to_string()));
    assert_eq!(others.collect::<Vec<_>>(), ["5:0:-1", "6:0:-1"]);
}

#[test]
fn lanes_that_lead_to_a_conflict_are_told_with_their_distance() {
    each_path(|map, path, _, name, _| {
        let (mut conflicts, mut met, mut out) = (Vec::new(), Vec::new(), Vec::new());
        path.conflicts(&mut conflicts, &mut met);
        for conflict in conflicts.iter().take(5) {
            let met = conflict.lanes_of(&met);
            map.approaches(met, BACK, CAR, &mut out).expect("lanes");
            let mut last = 0.0;
            for own in &out {
                let [far, near] = own.distance;
                assert!(last <= near && near <= far && far <= BACK + 1e-6, "{name}: {own:?}");
                last = near;
                let lane = map.lane(own.lane).expect("a lane");
                let [from, to] = own.s;
                let off = (lane.length_between(from, to) - (far - near)).abs();
                assert!(off < 1e-2 * (1.0 + far - near), "{name}: {off} of {own:?}");
                if near == 0.0 {
                    continue;
                }
                let leads = out.iter().any(|next| {
                    let linked = lane.successors_towards(own.forward).any(|id| id == next.lane);
                    let goes_on = next.lane == own.lane;
                    (linked || goes_on) && (next.distance[0] - near).abs() < 1e-9
                });
                assert!(leads, "{name}: {own:?}");
            }
            let is_met = |own: &ConflictApproach| met.iter().any(|met| met.other == own.lane);
            assert!(out.first().is_none_or(is_met), "{name}");
            // The class is that of who comes: a lane that is closed to it brings nobody.
            for class in [CAR, VehicleClass::Bicycle, VehicleClass::Tram] {
                let is_open = met.iter().any(|met| {
                    let (other, [low, high]) = (map.lane(met.other).expect("a lane"), met.other_s);
                    [(low, true), (high, false)].into_iter().any(|(s, forward)| {
                        other.node_at(s, forward).is_some_and(|node| node.allows(class))
                    })
                });
                map.approaches(met, BACK, class, &mut out).expect("lanes");
                assert_eq!(out.is_empty(), !is_open, "{name}: {class:?} {conflict:?}");
            }
        }
    });
}

#[test]
fn crosswalks_are_waited_for_before() {
    let snapshot = open_text(&furnished());
    let map = snapshot.map();
    let mut seen = 0;
    for key in ["02", "20", "13", "31"] {
        let (mut steps, mut buffer, mut found) = (Vec::new(), PathBuffer::default(), Vec::new());
        let (from, to) = (&key[..1], &key[1..]);
        let keys = [format!("{from}:0:1"), format!("{key}:0:-1"), format!("{to}:0:-1")];
        let lanes: Vec<_> = keys.iter().map(|key| lane_by(map, key).lane_id()).collect();
        steps_of_lanes(map, &lanes, [70.0, 70.0], &mut steps).expect("steps");
        let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
        path.crossings(&mut found);
        let mut last = 0.0;
        for own in &found {
            let [from, to] = own.along;
            assert!(last <= from && from <= to && to <= path.length(), "{key}: {own:?}");
            last = from;
            assert!(own.wait <= from && from - own.wait <= 30.0, "{key}: {own:?}");
            assert!(matches!(own.line.class, Class::Crosswalk | Class::BicycleCrossing));
            assert!(map.lane(own.line.lane).is_ok());
        }
        seen += found.len();
    }
    assert!(seen > 0, "no crosswalk");
}

/// A stop sign without a line: the movement waits before it meets the first other lane.
#[test]
fn a_sign_without_marking_is_waited_at() {
    let mut signals: [String; ARMS] = std::array::from_fn(|_| String::new());
    signals[0] = signal("S", 5.0, 5.0, "-", "206", "");
    let snapshot = open_text(&crossroads(signals, "", ""));
    let map = snapshot.map();
    for key in ["01:0:-1", "02:0:-1", "03:0:-1"] {
        let lane = lane_by(map, key);
        let stop = lane.movement_stop().unwrap_or_else(|| panic!("{key}: nothing to wait at"));
        assert_eq!((stop.class, stop.lane), (Class::Stop, lane.lane_id()), "{key}");
        let first = lane.conflicts().map(|one| one.s_range().low).fold(f64::INFINITY, f64::min);
        assert_eq!(stop.s, first, "{key}");
    }
    assert_eq!(lane_by(map, "12:0:-1").movement_stop(), None);
}

/// Every lane of another road that holds a place of the driven line on its level is among the conflicts, and no other overlaps.
#[test]
fn lanes_of_other_roads_that_hold_the_line_are_all_told() {
    let options =
        NearestOptions { radius: 0.0, z_tolerance: Some(2.0), ..NearestOptions::default() };
    // Places that another lane holds, and overlaps that are looked at again.
    let (places, overlaps) = (Cell::new(0), Cell::new(0));
    each_path(|map, path, _, name, _| {
        let (mut together, mut conflicts, mut held) = (Vec::new(), Vec::new(), Vec::new());
        path.conflicts(&mut together, &mut conflicts);
        let driven: Vec<_> = path.lanes().collect();
        for own in &driven {
            let lane = map.lane(own.lane).expect("its lane");
            let junction = lane.road().junction().map(|junction| junction.junction_id());
            // The middle of a piece that is compared with others in one place.
            let along = 0.5 * (own.along[0] + own.along[1]);
            if own.along[1] - own.along[0] > 2.0 {
                continue;
            }
            let at = path.at(along).expect("a place");
            map.lanes_near(at.position, &options, &mut held).expect("an answer");
            for found in &held {
                let other = map.lane(found.lane).expect("a lane");
                let linked = |id| id == found.lane;
                let same = other.road().road_id() == lane.road().road_id()
                    || driven.iter().any(|own| own.lane == found.lane)
                    || (junction.is_some()
                        && other.road().junction().map(|j| j.junction_id()) == junction)
                    || lane.successors_towards(own.forward).any(linked)
                    || lane.predecessors_towards(own.forward).any(linked)
                    || !other.nodes().any(|node| node.is_open());
                let told = conflicts.iter().any(|one| {
                    one.other == found.lane
                        && one.along[0] - 2.0 <= along
                        && along <= one.along[1] + 2.0
                });
                assert!(same || told, "{name}: {} at {along}", other.key());
                places.set(places.get() + usize::from(!same));
            }
        }
        for one in conflicts.iter().filter(|one| one.kind == ConflictKind::Overlap) {
            let other = map.lane(one.other).expect("a lane");
            // Areas of one junction's lanes meet, not only lines.
            if other.conflicts().next().is_some() {
                continue;
            }
            let spot = |share: f64| {
                let at = path.at(one.along[0] + share * (one.along[1] - one.along[0]));
                at.expect("a place").position.truncate()
            };
            let near = (0..=20).map(|i| {
                let position = other.position_of(spot(f64::from(i) / 20.0));
                position.expect("a position").distance
            });
            assert!(near.fold(f64::INFINITY, f64::min) < 1.5, "{name}: {one:?}");
            overlaps.set(overlaps.get() + 1);
        }
    });
    let seen = [places.get(), overlaps.get()];
    assert!(seen[0] > 0 && seen[1] > 0 || mapd_tests::shared("maps").is_none(), "{seen:?}");
}
