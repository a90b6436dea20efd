//! Changes of lane as a curve over a length.

use crate::paths::{each_path_with, is_near_joint};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Map, NearestOptions};
use mapd_query::path::{
    LaneChange, Path, PathBuffer, PathError, PathJoint, PathOptions, steps_of_lanes,
};
use mapd_query::route::{Enter, PositionOnLane, RouteScratch, RouteStep, ShortestTime};
use mapd_tests::graph_maps::{Line, document, lane, road, section, wide};
use mapd_tests::maps::{Random, open_text};

/// Length of a change `[m]`.
const LENGTH: f64 = 8.0;
/// Chords along a change, and by how much S may be off within it `[m]`.
const CHORDS: u32 = 400;
const ALONG: f64 = 3e-4;
/// What places may be off `[m]`.
const TOLERANCE: f64 = 1e-6;

fn options(length: f64) -> PathOptions {
    PathOptions { change: LaneChange::Lateral(length), ..PathOptions::default() }
}

#[test]
fn a_curve_has_no_jump_and_is_projected_back() {
    let counts = std::cell::Cell::new([0, 0]);
    let near = std::cell::RefCell::new(Vec::new());
    each_path_with(&options(LENGTH), |map, path, steps, name, random| {
        let mut near = near.borrow_mut();
        for joint in path.joints() {
            let changes = matches!(joint.enter, Enter::Left | Enter::Right);
            assert!(changes || !joint.short, "{name}: {joint:?}");
            if !changes {
                continue;
            }
            // Where lanes do not meet, there is a gap with a curve, too.
            assert!(joint.short || joint.broken || joint.gap < 0.1, "{name}: {joint:?}");
            let mut all = counts.get();
            all[usize::from(joint.short)] += 1;
            counts.set(all);
            // S is what is driven.
            let end = joint.along + 0.9 * LENGTH;
            let is_in = |other: &&PathJoint| other.along > joint.along && other.along <= end;
            if end < path.length() && path.joints().iter().find(is_in).is_none() {
                let place = |i: u32| {
                    let along =
                        joint.along + (end - joint.along) * f64::from(i) / f64::from(CHORDS);
                    path.at(along).expect("a place").position.truncate()
                };
                let driven: f64 = (0..CHORDS).map(|i| place(i).distance(place(i + 1))).sum();
                let off = (driven - (end - joint.along)).abs();
                assert!(off < ALONG, "{name}: {driven} m from {} to {end}", joint.along);
            }
            for _ in 0..8 {
                let along = joint.along + random.between(0.0, LENGTH);
                if along > path.length() || is_near_joint(path, along) {
                    continue;
                }
                let at = path.at(along).expect("a place");
                let found = path.project(at.position.truncate(), Some(along)).expect("a foot");
                assert!(found.distance < TOLERANCE, "{name}: {found:?} of {at:?}");
                let off = (found.along - along).abs();
                assert!(off < TOLERANCE, "{name}: {off} m of {at:?}, {found:?}");
                let turned = found.heading_difference(at.heading).abs();
                assert!(turned < 1e-6, "{name}: {turned}");
                // On one of the route's lanes, or one that leads on beside them.
                let on = map.lanes_near(
                    at.position.truncate(),
                    &NearestOptions { radius: TOLERANCE, ..NearestOptions::default() },
                    &mut near,
                );
                on.expect("an answer");
                let roads = steps.iter().map(|own| map.lane(own.lane).expect("a lane").road());
                let roads: Vec<_> = roads.map(|road| road.road_id()).collect();
                let on = near.iter().any(|near| {
                    let road = map.lane(near.lane).expect("a lane").road().road_id();
                    roads.contains(&road)
                });
                assert!(on, "{name}: {at:?}");
            }
        }
    });
    let [curves, jumps] = counts.get();
    // The carried maps have one change of lane on these paths: without the others, which is said aloud, there is nothing to count.
    let has_others = mapd_tests::shared("maps").is_some();
    assert!(!has_others || curves > 20 && jumps > 0, "{curves} curves, {jumps} jumps");
}

/// Two lanes of 3.5 m: the line goes from one middle to the other over the length, and not beyond the last place for the change.
#[test]
fn from_one_middle_to_the_next() {
    let free = "<roadMark sOffset=\"0\" type=\"broken\" laneChange=\"both\"/>";
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    let lanes = wide(-1, "", "", width, free) + &lane(-2, "");
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let text = document(&road("1", "junction=\"-1\"", line, "", &section(0.0, "", &lanes)));
    let snapshot = open_text(&text);
    let map = snapshot.map();
    let id = |key: &str| map.lane_by_key(&key.parse().expect("a key")).expect("a lane").lane_id();
    let step = |key: &str, enter, [s_from, s_to]: [f64; 2], s_latest| RouteStep {
        lane: id(key),
        forward: true,
        enter,
        s_from,
        s_to,
        s_latest,
    };
    let steps = [
        step("1:0:-1", Enter::Start, [10.0, 20.0], 10.0),
        step("1:0:-2", Enter::Right, [20.0, 90.0], 60.0),
    ];
    let mut buffer = PathBuffer::default();
    let path = map.path(&steps, &options(30.0), &mut buffer).expect("a path");
    // 1 − 10u³ + 15u⁴ − 6u⁵ is one half in the middle.
    for (along, expected) in [(10.0, -1.75), (25.0, -3.5), (40.0, -5.25), (70.0, -5.25)] {
        let at = path.at(along).expect("a place");
        assert!((at.position.y - expected).abs() < TOLERANCE, "{along}: {at:?}");
        assert!((at.left + at.right - 3.5).abs() < 1e-9, "{at:?}");
    }
    let start = path.at(10.0).expect("its beginning");
    assert!((start.left + 1.75).abs() < 1e-9 && start.curvature.abs() < 1e-2, "{start:?}");
    assert_eq!(path.joints().len(), 1, "{:?}", path.joints());
    assert!(!path.joints()[0].short && path.joints()[0].gap < TOLERANCE);
    assert!(path.length() > 80.0 && path.length() < 80.5, "{}", path.length());
    let path = map.path(&steps, &options(50.0), &mut buffer).expect("a path");
    assert!(path.joints()[0].short && (path.joints()[0].gap - 3.5).abs() < TOLERANCE);
    assert_eq!(path.length(), 80.0);
}

#[test]
fn options_out_of_their_domain_are_refused_by_name() {
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let snapshot = open_text(&document(&road("1", "", line, "", &section(0.0, "", &lane(-1, "")))));
    let map = snapshot.map();
    let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
    let id = map.lanes().find(|lane| lane.number() == -1).expect("a lane").lane_id();
    steps_of_lanes(map, &[id], [0.0, 100.0], &mut steps).expect("steps");
    let mut built = |options: PathOptions| map.path(&steps, &options, &mut buffer).err();
    let normal = PathOptions::default();
    let never = PathOptions { broken_gap: f64::INFINITY, broken_kink: f64::INFINITY, ..normal };
    assert_eq!((built(normal), built(never)), (None, None));
    for bad in [f64::NAN, -1.0] {
        let refused = |name| Some(PathError::Option(name));
        assert_eq!(built(PathOptions { broken_gap: bad, ..normal }), refused("broken_gap"));
        assert_eq!(built(PathOptions { broken_kink: bad, ..normal }), refused("broken_kink"));
        assert_eq!(built(options(bad)), refused("change"));
    }
    assert_eq!(built(options(f64::INFINITY)), Some(PathError::Option("change")));
    for bad in [f64::NAN, -1.0, 0.0] {
        let refused = Some(PathError::Option("shortest_change"));
        assert_eq!(built(PathOptions { shortest_change: Some(bad), ..options(40.0) }), refused);
    }
    for bad in [f64::NAN, -1.0] {
        let refused = Some(PathError::Option("change_delay"));
        assert_eq!(built(PathOptions { change_delay: bad, ..options(40.0) }), refused);
    }
}

/// The lane that is left narrows from a place within the change on, where the other lane goes on as before.
#[test]
fn the_lane_that_is_left_may_change_its_width_on_the_way() {
    let free = "<roadMark sOffset=\"0\" type=\"broken\" laneChange=\"both\"/>";
    let taper = "<width sOffset=\"50\" a=\"3.5\" b=\"-0.05\" c=\"0\" d=\"0\"/>";
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    let lanes = wide(-1, "", "", width, free) + &wide(-2, "", "", width, &format!("{taper}{free}"));
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let text = document(&road("1", "junction=\"-1\"", line, "", &section(0.0, "", &lanes)));
    let snapshot = open_text(&text);
    let map = snapshot.map();
    let id = |key: &str| map.lane_by_key(&key.parse().expect("a key")).expect("a lane").lane_id();
    let step = |key: &str, enter, [s_from, s_to]: [f64; 2], s_latest| RouteStep {
        lane: id(key),
        forward: true,
        enter,
        s_from,
        s_to,
        s_latest,
    };
    let steps = [
        step("1:0:-2", Enter::Start, [0.0, 10.0], 0.0),
        step("1:0:-1", Enter::Left, [10.0, 95.0], 90.0),
    ];
    let mut buffer = PathBuffer::default();
    let path = map.path(&steps, &options(80.0), &mut buffer).expect("a path");
    let gaps = path.joints().iter().map(|joint| joint.gap).fold(0.0, f64::max);
    assert!(gaps < TOLERANCE, "{:?}", path.joints());
    for along in (0..95).map(f64::from) {
        let at = path.at(along).expect("a place");
        let u = mapd_geometry::clamp((along - 10.0) / 80.0, 0.0, 1.0);
        let share = 1.0 - u * u * u * (10.0 - u * (15.0 - 6.0 * u));
        let width = 3.5 - 0.05 * (at.s - 50.0).max(0.0);
        let expected = -1.75 - share * 0.5 * (3.5 + width);
        assert!((at.position.y - expected).abs() < TOLERANCE, "{expected}: {at:?}");
        let found = path.project(at.position.truncate(), Some(along)).expect("a foot");
        assert!((found.along - along).abs() < 1e-3 && found.distance < TOLERANCE, "{found:?}");
    }
}

/// Two lanes or three beside each other, over sections of 15 m and geometries that meet without a spiral; the marks between lanes as they are named by section.
fn lanes_over_sections(lanes: i32, marks: [&str; 6], rule: &str) -> mapd_client::Snapshot {
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    let sections: String = (0..6)
        .map(|number| {
            let links = match number {
                0 => "s",
                5 => "p",
                _ => "ps",
            };
            let mark = match marks[number] {
                "free" => "<roadMark sOffset=\"0\" type=\"broken\" laneChange=\"both\"/>",
                "closed" => "<roadMark sOffset=\"0\" type=\"broken\" laneChange=\"both\"/><access sOffset=\"0\" rule=\"deny\" restriction=\"passengerCar\"/>",
                _ => "<roadMark sOffset=\"0\" type=\"solid\" laneChange=\"none\"/>",
            };
            let free = "<roadMark sOffset=\"0\" type=\"broken\" laneChange=\"both\"/>";
            let each: String = (1..=lanes)
                .map(|id| {
                    let links: String =
                        links.chars().map(|kind| format!("{kind}{} ", -id)).collect();
                    let own = if marks[number] == "closed" && id != 1 { free } else { mark };
                    wide(-id, "", &links, width, own)
                })
                .collect();
            section(15.0 * number as f64, "", &each)
        })
        .collect();
    let geometry = |s: f64, x: f64, y: f64, hdg: f64, length: f64, shape: &str| {
        format!(
            "<geometry s=\"{s}\" x=\"{x}\" y=\"{y}\" hdg=\"{hdg}\" length=\"{length}\">{shape}</geometry>"
        )
    };
    // 20 m straight on, then to the left by 0.8 rad with a radius of 50 m, then straight on.
    let (radius, turn) = (50.0, 0.8f64);
    let [x, y] = [20.0 + radius * turn.sin(), radius * (1.0 - turn.cos())];
    let view = geometry(0.0, 0.0, 0.0, 0.0, 20.0, "<line/>")
        + &geometry(20.0, 20.0, 0.0, 0.0, radius * turn, "<arc curvature=\"0.02\"/>")
        + &geometry(60.0, x, y, turn, 30.0, "<line/>");
    open_text(&document(&format!(
        "<road id=\"1\" length=\"90\" junction=\"-1\" {rule}><planView>{view}</planView><lanes>{sections}</lanes></road>"
    )))
}

/// The route from the lane nearest to the middle to the outermost one, over all of the road.
fn steps_outwards(map: Map<'_>, lanes: i32) -> Vec<RouteStep> {
    let lane = |key: String| map.lane_by_key(&key.parse().expect("a key")).expect("a lane");
    let forward = lane("1:0:-1".to_owned()).is_forward();
    let order: Vec<usize> = if forward { (0..6).collect() } else { (0..6).rev().collect() };
    let mut steps = Vec::new();
    for (number, section) in order.into_iter().enumerate() {
        let (low, high) = (15.0 * section as f64, 15.0 * (section + 1) as f64);
        let [begin, end] = if forward { [low, high] } else { [high, low] };
        let mut add = |id: i32, enter, s_from, s_to, s_latest| {
            let lane = lane(format!("1:{section}:{}", -id)).lane_id();
            steps.push(RouteStep { lane, forward, enter, s_from, s_to, s_latest });
        };
        // In the first section it changes 5 m behind the beginning, as soon as it may.
        let change = if forward { begin + 5.0 } else { begin - 5.0 };
        if number == 0 {
            add(1, Enter::Start, begin, change, begin);
            for id in 2..=lanes {
                let to = if id == lanes { end } else { change };
                let enter = if forward { Enter::Right } else { Enter::Left };
                add(id, enter, change, to, end);
            }
        } else {
            add(lanes, Enter::Ahead, begin, end, begin);
        }
    }
    steps
}

/// How far the driven line lies beside the middle of the route's lane `[m]`.
fn beside(path: &Path<'_, '_>, along: f64) -> f64 {
    let at = path.at(along).expect("a place");
    0.5 * (at.right - at.left).abs()
}

fn share(u: f64) -> f64 {
    let u = mapd_geometry::clamp(u, 0.0, 1.0);
    1.0 - u * u * u * (10.0 - u * (15.0 - 6.0 * u))
}

/// Every place lies beside the lane's middle as curves with these ends say, and nowhere is a gap.
fn check_curves(path: &Path<'_, '_>, curves: &[[f64; 2]], what: &str) {
    for joint in path.joints() {
        let is_change = matches!(joint.enter, Enter::Left | Enter::Right);
        assert!(!joint.short && !joint.broken && joint.gap < TOLERANCE, "{what}: {joint:?}");
        // Beside geometries that meet with another curvature the lanes turn on smoothly.
        assert!(is_change || joint.kink.abs() < TOLERANCE, "{what}: {joint:?}");
    }
    for i in 0..=1000 {
        let along = path.length() * f64::from(i) / 1000.0;
        let own = |[begin, end]: &[f64; 2]| 3.5 * share((along - begin) / (end - begin));
        let expected: f64 = if along < 5.0 { 0.0 } else { curves.iter().map(own).sum() };
        let found = beside(path, along);
        // As a function of S it is the formula, so that it has both derivatives wherever sections and geometries meet.
        assert!((found - expected).abs() < TOLERANCE, "{what} at {along}: {found}, not {expected}");
    }
}

const FREE: [&str; 6] = ["free"; 6];

#[test]
fn a_change_goes_on_over_lanes_that_follow() {
    for rule in ["", "rule=\"LHT\""] {
        let snapshot = lanes_over_sections(2, FREE, rule);
        let map = snapshot.map();
        let (steps, mut buffer) = (steps_outwards(map, 2), PathBuffer::default());
        let path = map.path(&steps, &options(40.0), &mut buffer).expect("a path");
        check_curves(&path, &[[5.0, 45.0]], rule);
        // The S of the path is what is driven.
        let place = |i: u32| {
            let along = path.length() * f64::from(i) / 20_000.0;
            path.at(along).expect("a place").position.truncate()
        };
        let driven: f64 = (0..20_000).map(|i| place(i).distance(place(i + 1))).sum();
        assert!((driven - path.length()).abs() < 1e-3, "{driven}, {}", path.length());
        // Later, where that is asked for, and as late as can be.
        for (change_delay, begin) in [(12.0, 17.0), (f64::INFINITY, f64::NAN)] {
            let late = PathOptions { change_delay, ..options(30.0) };
            let path = map.path(&steps, &late, &mut buffer).expect("a path");
            let begin = if begin.is_nan() {
                // It ends with the road, or in a bend a little before.
                let first = (0..900).map(|i| 0.1 * f64::from(i));
                let begin = first.rev().find(|along| beside(&path, *along) > 3.5 - 1e-9);
                let begin = begin.expect("a beginning");
                assert!(begin > path.length() - 36.0 && begin < path.length() - 24.0, "{begin}");
                continue;
            } else {
                begin
            };
            check_curves(&path, &[[begin, begin + 30.0]], rule);
        }
    }
}

#[test]
fn changes_that_follow_each_other_do_not_overlap() {
    for rule in ["", "rule=\"LHT\""] {
        let snapshot = lanes_over_sections(3, FREE, rule);
        let map = snapshot.map();
        let (steps, mut buffer) = (steps_outwards(map, 3), PathBuffer::default());
        let path = map.path(&steps, &options(30.0), &mut buffer).expect("a path");
        check_curves(&path, &[[5.0, 35.0], [35.0, 65.0]], rule);
        // Where two have no room one after the other, both are shorter; with less room than one has, they jump.
        let path = map.path(&steps, &options(60.0), &mut buffer).expect("a path");
        assert!(path.joints().iter().all(|joint| !joint.short && joint.gap < TOLERANCE));
        let path = map.path(&steps, &options(200.0), &mut buffer).expect("a path");
        let jumps: Vec<_> = path.joints().iter().filter(|joint| joint.short).collect();
        assert!(jumps.len() == 1 && (jumps[0].gap - 7.0).abs() < TOLERANCE, "{jumps:?}");
        assert!(!jumps[0].broken);
    }
}

#[test]
fn a_change_waits_for_where_it_is_allowed_for_long_enough() {
    // Allowed for 10 m, then not for 15 m, then for 60 m: 40 m fit there alone.
    let marks = ["free", "solid", "free", "free", "free", "free"];
    let snapshot = lanes_over_sections(2, marks, "");
    let map = snapshot.map();
    let (steps, mut buffer) = (steps_outwards(map, 2), PathBuffer::default());
    let path = map.path(&steps, &options(40.0), &mut buffer).expect("a path");
    assert!(path.joints().iter().all(|joint| !joint.short && joint.gap < TOLERANCE));
    let last = (5..60).map(f64::from).rev().find(|along| beside(&path, *along) > 3.49);
    let last = last.expect("a beginning");
    assert!(last > 28.0 && last < 36.0, "{last}");
    let s_of = |along: f64| path.at(along).expect("a place").s;
    assert!(s_of(last) > 28.0, "it begins before {last}");
    // What is shorter fits at once.
    let path = map.path(&steps, &options(8.0), &mut buffer).expect("a path");
    check_curves(&path, &[[5.0, 13.0]], "at once");
}

#[test]
fn a_shortest_length_lets_a_change_be_shorter_or_breaks_its_joint() {
    // The lane that is left is closed to cars from 30 m on, or its marks forbid a change: 25 m of room.
    for rest in ["closed", "solid"] {
        let marks = ["free", "free", rest, rest, rest, rest];
        let snapshot = lanes_over_sections(2, marks, "");
        let map = snapshot.map();
        let (steps, mut buffer) = (steps_outwards(map, 2), PathBuffer::default());
        let built = |shortest: Option<f64>, buffer: &mut PathBuffer| {
            let own = PathOptions { shortest_change: shortest, ..options(40.0) };
            let path = map.path(&steps, &own, buffer).expect("a path");
            let joint = path.joints().iter().find(|joint| joint.enter == Enter::Right);
            let joint = *joint.expect("a change");
            let done = (0..900)
                .map(|i| 0.1 * f64::from(i))
                .find(|along| *along > 5.0 && beside(&path, *along) < 1e-6);
            let done = path.at(done.expect("an end")).expect("a place").s;
            (joint.short, joint.broken, path.is_broken(), done)
        };
        assert!(built(None, &mut buffer).0, "{rest}");
        assert!(!built(None, &mut buffer).1, "{rest}");
        let (short, broken, any, done) = built(Some(10.0), &mut buffer);
        assert!(!short && !broken && !any && done > 28.0 && done <= 30.1, "{rest}: {done}");
        let (short, broken, any, _) = built(Some(28.0), &mut buffer);
        assert!(short && broken && any, "{rest}");
        // A lorry may go on in the lane that is closed to cars.
        let lorry = PathOptions { vehicle: VehicleClass::Truck, ..options(40.0) };
        let path = map.path(&steps, &lorry, &mut buffer).expect("a path");
        let is_short = path.joints().iter().any(|joint| joint.short);
        assert_eq!(is_short, rest == "solid");
    }
}

/// Maps with lanes beside each other.
const MANY: [&str; 20] = [
    "carla/Town01",
    "carla/Town03",
    "carla/Town05",
    "Scenic/Town07",
    "Scenic/Town10HD",
    "Scenic/Issue189",
    "Scenic/Issue295a",
    "Scenic/borregasave",
    "SMARTS/od_newmarket_map",
    "libOpenDRIVE/test",
    "sumo/adlershof_dlr_netconvert",
    "sumo/lefthand_netconvert",
    "sumo/4arm_opendrive",
    "esmini/multi_intersections",
    "esmini/e6mini",
    "esmini/soderleden",
    "esmini/highway_example_with_merge_and_split",
    "drone_dataset/rdb2",
    "maliput_malidrive/onramp",
    "bark/4way_intersection",
];
/// Routes of each map.
const ROUTES: usize = 80;

#[test]
fn there_is_no_jump_where_the_path_has_room() {
    const WANTED: f64 = 40.0;
    const STEP: f64 = 0.25;
    let Some(folder) = mapd_tests::shared("maps") else { return };
    let car = VehicleClass::PassengerCar;
    let (mut curves, mut jumps) = (0, 0);
    for name in MANY {
        let snapshot = mapd_tests::maps::open(&folder.join(format!("{name}.xodr")));
        let map = snapshot.map();
        let random = &mut Random(7);
        let lanes: Vec<_> = map
            .lanes()
            .filter(|lane| lane.kind().is_drivable() && lane.road().junction().is_none())
            .collect();
        let mut pick = || {
            let lane = &lanes[(random.unit() * lanes.len() as f64) as usize];
            let (start, end) = (lane.section().s_start(), lane.section().s_end());
            PositionOnLane { lane: lane.lane_id(), s: start + (end - start) * random.unit() }
        };
        let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
        let (mut buffer, mut segments) = (PathBuffer::default(), Vec::new());
        for _ in 0..ROUTES {
            let (from, to, cost) = (pick(), pick(), ShortestTime::default());
            let route =
                map.route(from, to, car, &cost, &mut scratch, &mut steps).expect("an answer");
            if route.is_none() {
                continue;
            }
            let Ok(path) = map.path(&steps, &options(WANTED), &mut buffer) else { continue };
            path.segments(car, &mut segments);
            for joint in path.joints() {
                if !matches!(joint.enter, Enter::Left | Enter::Right) {
                    continue;
                }
                if !joint.short {
                    curves += 1;
                    continue;
                }
                jumps += 1;
                let here = segments.iter().filter(|own| {
                    own.driven && own.changes > 0 && (own.along[1] - joint.along).abs() < TOLERANCE
                });
                let room = here.map(|own| own.last_change - joint.along).fold(0.0, f64::max);
                // Marks may forbid it in between: nowhere is it allowed for long enough.
                let is_allowed = |gone: f64| {
                    let at = path.at(joint.along + gone).expect("a place");
                    let lane = map.lane(at.lane).expect("a lane");
                    let own = lane.node_at(at.s, at.forward).expect("a node");
                    let is_left = joint.enter == Enter::Left;
                    let beside = if is_left { own.right() } else { own.left() };
                    let change = beside.filter(|beside| beside.allows(car)).and_then(|beside| {
                        if is_left { beside.change_left() } else { beside.change_right() }
                    });
                    change.is_some_and(|change| change.node_id() == own.node_id())
                };
                let mut allowed = 0.0;
                let mut gone = 0.0;
                while gone < room {
                    allowed = if is_allowed(gone) { allowed + STEP } else { 0.0 };
                    assert!(
                        allowed <= WANTED + STEP,
                        "{name}: {joint:?} has {room} m, from {from:?} to {to:?}"
                    );
                    gone += STEP;
                }
            }
        }
    }
    assert!(curves > 100 && jumps > 0, "{curves} curves, {jumps} jumps");
}
