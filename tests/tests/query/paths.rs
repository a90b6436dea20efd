//! Routes as lines: S, joints, projection, edges, conflicts.

use mapd_client::glam::DVec2;
use mapd_client::route::{PositionOnLane, RouteScratch, RouteStep, ShortestLength};
use mapd_client::vocabulary::{ConflictKind, VehicleClass};
use mapd_client::{Lane, Map};
use mapd_query::path::{
    ConflictLane, Corridor, LaneChange, Path, PathBuffer, PathConflict, PathError, PathLane,
    PathOptions, Yields, steps_of_lanes,
};
use mapd_query::route::Enter;
use mapd_query::{Clamped, QueryError};
use mapd_tests::maps::{Random, carried_and, open, open_accepted};
use std::cell::Cell;
use std::path::PathBuf;

/// Towns, left-hand traffic, gaps and kinks; with those that the project carries eight.
const MAPS: [&str; 6] = [
    "carla/Town05",
    "sumo/lefthand_netconvert",
    "esmini/multi_intersections",
    "Scenic/Town10HD",
    "SMARTS/od_newmarket_map",
    "drone_dataset/rdb5",
];
/// Pairs of places on each map between which a way is looked for.
const PAIRS: usize = 40;
/// Places on each path.
const PLACES: usize = 40;
/// What S and positions may be off `[m]`.
const TOLERANCE: f64 = 1e-6;
/// Offsets of places from the line `[m]`, as long as they are a smaller share of its radius.
const OFFSET: f64 = 4.0;
const BEND: f64 = 0.8;
/// Places this near to a joint are not projected `[m]`: a foot may lie on either side of it.
const NEAR_JOINT: f64 = 0.5;

/// Random routes of each map.
pub(crate) fn each_path(check: impl Fn(Map<'_>, &Path<'_, '_>, &[RouteStep], &str, &mut Random)) {
    each_path_with(&PathOptions::default(), check);
}

/// Random routes of each map, built with options.
pub(crate) fn each_path_with(
    options: &PathOptions,
    check: impl Fn(Map<'_>, &Path<'_, '_>, &[RouteStep], &str, &mut Random),
) {
    each_path_of(carried_and(&MAPS), PAIRS, options, check);
}

/// Random routes of these maps, but for those that are rejected, between so many pairs of places.
pub(crate) fn each_path_of(
    files: Vec<PathBuf>,
    pairs: usize,
    options: &PathOptions,
    check: impl Fn(Map<'_>, &Path<'_, '_>, &[RouteStep], &str, &mut Random),
) {
    for file in files {
        let Some(snapshot) = open_accepted(&file) else {
            assert!(pairs < PAIRS, "{} is rejected", file.display());
            continue;
        };
        let map = snapshot.map();
        let name = file.display().to_string();
        let lanes: Vec<_> = map.lanes().filter(|lane| lane.nodes().any(|n| n.is_open())).collect();
        let mut random = Random(17);
        let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
        let mut buffer = PathBuffer::default();
        let mut found = 0;
        for _ in 0..pairs.min(PAIRS * lanes.len()) {
            let mut place = || {
                let lane = &lanes[(random.unit() * lanes.len() as f64) as usize];
                let (low, high) = (lane.section().s_start(), lane.section().s_end());
                PositionOnLane { lane: lane.lane_id(), s: random.between(low, high) }
            };
            let (from, to) = (place(), place());
            let (car, cost) = (VehicleClass::PassengerCar, ShortestLength::default());
            let route = map.route(from, to, car, &cost, &mut scratch, &mut steps);
            let Some(route) = route.expect("an answer") else { continue };
            match map.path(&steps, options, &mut buffer) {
                Ok(path) => {
                    let off = (path.length() - route.length).abs();
                    let jumps = options.change == LaneChange::Jump;
                    let most = 1e-3 * (1.0 + route.length);
                    assert!(!jumps || off < most, "{name}: {off} m of {route:?}");
                    check(map, &path, &steps, &name, &mut random);
                    found += 1;
                }
                Err(error) => assert_eq!(error, PathError::Empty, "{name}: {steps:?}"),
            }
        }
        assert!(found > 3 || pairs < PAIRS, "{name}: {found} paths");
    }
}

/// Whether S is near a joint of a path.
pub(crate) fn is_near_joint(path: &Path<'_, '_>, along: f64) -> bool {
    path.joints().iter().any(|joint| (joint.along - along).abs() < NEAR_JOINT)
}

#[test]
fn a_place_on_the_path_is_found_again_by_its_s_and_offset() {
    let (again_at_s, all) = (Cell::new(0), Cell::new(0));
    each_path(|_, path, _, name, random| {
        for _ in 0..PLACES {
            let along = random.between(0.0, path.length());
            let at = path.at(along).expect("a place");
            if is_near_joint(path, along) {
                continue;
            }
            // Beyond the centre of curvature the foot is another one.
            let reach = (BEND / at.curvature.abs()).min(OFFSET);
            let d = random.between(-reach, reach);
            let left = DVec2::from_angle(at.heading).perp();
            for d in [0.0, d] {
                all.set(all.get() + 1);
                let point = at.position.truncate() + d * left;
                let found = path.project(point, Some(along)).expect("a foot");
                // Another branch, or another bend, may be nearer than the place that we come from.
                assert!(found.distance <= d.abs() + TOLERANCE, "{name}: {found:?} of {at:?}, {d}");
                if (found.along - along).abs() < NEAR_JOINT || d == 0.0 {
                    let again = path.at(found.along).expect("a place").position.truncate();
                    let same = (found.along - along).abs() < TOLERANCE;
                    // A path that comes by twice within reach of the hint has two such places.
                    let twice = again.distance(at.position.truncate()) < TOLERANCE;
                    assert!(same || twice, "{name}: {found:?} of {at:?}, {d}");
                    if same {
                        assert!((found.d - d).abs() < TOLERANCE, "{name}: {found:?}, {d}");
                        assert_eq!(found.clamped, Clamped::No);
                        assert!(found.heading_difference(at.heading).abs() < 1e-6);
                        again_at_s.set(again_at_s.get() + 1);
                    }
                }
            }
        }
    });
    // The rest has another branch, or another bend, nearer by.
    let (again, all) = (again_at_s.get(), all.get());
    assert!(10 * again > 9 * all, "{again} of {all}");
}

#[test]
fn s_grows_by_what_is_driven_and_joints_are_listed() {
    each_path(|map, path, _, name, random| {
        for _ in 0..PLACES {
            // A chord is no longer than the line; joints in between are told.
            let a = random.between(0.0, path.length());
            let b = (a + random.between(0.0, 20.0)).min(path.length());
            let (p, q) = (path.at(a).expect("a place"), path.at(b).expect("a place"));
            let between = path.joints().iter().filter(|j| j.along >= a && j.along <= b);
            let gaps: f64 = between.map(|joint| joint.gap).sum();
            let chord = p.position.truncate().distance(q.position.truncate());
            // S between stations of the stored line.
            let rounding = 4e-4;
            assert!(
                chord <= (b - a) + gaps + rounding,
                "{name}: {chord} m from {a} to {b}, {gaps}"
            );
        }
        let mut last = 0.0;
        for own in path.lanes() {
            assert_eq!(own.along[0], last, "{name}");
            assert!(own.along[1] >= own.along[0]);
            last = own.along[1];
            // Every point of the path lies in the path's lanes.
            let lane = map.lane(own.lane).expect("its lane");
            let at = path.at(0.5 * (own.along[0] + own.along[1])).expect("a place");
            let position = lane.position_of(at.position.truncate()).expect("a position");
            assert!(position.distance < TOLERANCE, "{name}: {position:?} of {at:?}");
            let found = path.along_of(own.lane, at.s).expect("on the path");
            assert!((found - at.along).abs() < TOLERANCE || found < at.along, "{name}");
        }
        assert_eq!(last, path.length());
        for joint in path.joints() {
            let changes = matches!(joint.enter, Enter::Left | Enter::Right);
            assert!(changes || joint.gap > 0.0 || joint.kink != 0.0, "{name}: {joint:?}");
            assert_eq!(joint.broken, joint.kink.abs() > 0.3 || (!changes && joint.gap > 0.1));
        }
    });
}

/// All routes of a thousand random pairs on eight maps: every place of the path lies in its lane and is driven the way that the lane may be, and every
/// change is allowed where it is made.
#[test]
fn every_place_of_a_thousand_routes_lies_in_the_paths_lanes() {
    for file in carried_and(&MAPS) {
        let snapshot = open(&file);
        let (map, name) = (snapshot.map(), file.display().to_string());
        let car = VehicleClass::PassengerCar;
        let (mut scratch, mut steps, mut buffer) =
            (RouteScratch::default(), Vec::new(), PathBuffer::default());
        let mut found = 0;
        for (from, targets) in crate::routing::places(map, car, 1_000) {
            for to in targets {
                let cost = ShortestLength::default();
                let route = map.route(from, to, car, &cost, &mut scratch, &mut steps);
                if route.expect("an answer").is_none() {
                    continue;
                }
                // The path itself refuses changes that are not allowed and lanes that do not follow each other.
                let Ok(path) = map.path(&steps, &PathOptions::default(), &mut buffer) else {
                    let error = map.path(&steps, &PathOptions::default(), &mut buffer).err();
                    assert_eq!(error, Some(PathError::Empty), "{name}: {steps:?}");
                    continue;
                };
                found += 1;
                for own in path.lanes() {
                    let lane = map.lane(own.lane).expect("its lane");
                    let node = lane.node_at(0.5 * (own.s[0] + own.s[1]), own.forward);
                    let open = node.is_some_and(|node| node.allows(car));
                    assert!(open || own.step == 0, "{name}: {} is closed", lane.key());
                    for share in [0.02, 0.98] {
                        let along = own.along[0] + share * (own.along[1] - own.along[0]);
                        let at = path.at(along).expect("a place");
                        let in_lane = lane.position_of(at.position.truncate());
                        let in_lane = in_lane.expect("a position");
                        let near = in_lane.distance < TOLERANCE && at.lane == own.lane;
                        assert!(near, "{name}: {} at {along}, {in_lane:?}", lane.key());
                    }
                }
            }
        }
        assert!(found > 100 || map.lanes().count() < 10, "{name}: {found}");
    }
}

#[test]
fn the_corridors_edges_are_those_of_the_lanes() {
    each_path(|map, path, _, name, _| {
        let mut room = Corridor::default();
        let car = VehicleClass::PassengerCar;
        path.corridor(0.0, 150.0, 2.5, car, &mut room).expect("a corridor");
        assert!(!room.is_empty());
        for i in 0..room.len() {
            let at = path.at(room.along[i]).expect("a place");
            assert_eq!(at.lane, room.lane[i], "{name}");
            let lane = map.lane(at.lane).expect("its lane");
            let edges = lane.edge_points_at(at.s).expect("edges");
            let own = [room.left[i], room.right[i]];
            assert!(own == edges || own == [edges[1], edges[0]], "{name}: {own:?}, {edges:?}");
            let left = DVec2::from_angle(at.heading).perp();
            if lane.width_at(at.s) > 0.1 && at.curvature.abs() < 0.1 {
                let side =
                    |p: mapd_client::glam::DVec3| (p.truncate() - at.position.truncate()).dot(left);
                assert!(side(own[0]) > 0.0 && side(own[1]) < 0.0, "{name}: lane {}", lane.key());
                assert!(side(room.outer_left[i]) >= side(own[0]) - TOLERANCE, "{name}");
                assert!(side(room.outer_right[i]) <= side(own[1]) + TOLERANCE, "{name}");
                assert!((at.left - side(own[0])).abs() < 0.1, "{name}: {at:?}");
            }
            let node = lane.node_at(at.s, at.forward).expect("a node");
            let open = |next: Option<mapd_client::graph::LaneNode<'_>>| {
                next.is_some_and(|n| n.allows(car))
            };
            assert_eq!(room.left_mark[i].may_cross, open(node.change_left()), "{name}");
            assert_eq!(room.right_mark[i].may_cross, open(node.change_right()), "{name}");
        }
        assert_eq!(room.along[room.len() - 1], path.length().min(150.0));
    });
}

/// Each lane is one conflict's, each conflict has lanes, and it is what they are.
fn are_of_their_lanes(conflicts: &[PathConflict], lanes: &[ConflictLane], name: &str) {
    let (mut number, mut last) = (0, 0.0);
    for one in conflicts {
        assert!(one.lanes[0] == number && one.lanes[1] > number, "{name}: {one:?}");
        number = one.lanes[1];
        assert!(one.along[0] >= last, "{name}: {one:?}");
        last = one.along[0];
        let own = one.lanes_of(lanes);
        let has = |yields: Yields| own.iter().any(|lane| lane.yields == yields);
        let who = [Yields::Yields, Yields::Unknown, Yields::Lights, Yields::Priority];
        assert_eq!(
            who.into_iter().find(|yields| has(*yields)),
            Some(one.yields),
            "{name}: {one:?}"
        );
        assert!(own.iter().any(|lane| (lane.yields, lane.reason) == (one.yields, one.reason)));
        let is = |kind: ConflictKind| own.iter().any(|lane| lane.kind == kind);
        let how = [ConflictKind::Merge, ConflictKind::Cross].into_iter().find(|kind| is(*kind));
        assert_eq!(how.unwrap_or(own[0].kind), one.kind, "{name}: {one:?}");
        let low = |of: fn(&ConflictLane) -> f64| own.iter().map(of).fold(f64::INFINITY, f64::min);
        let high = own.iter().map(|lane| lane.along[1]).fold(0.0, f64::max);
        assert_eq!([low(|lane| lane.along[0]), high], one.along, "{name}: {one:?}");
        assert_eq!(low(|lane| lane.wait), one.wait, "{name}: {one:?}");
        assert_eq!((own[0].other, own[0].other_s), (one.other, one.other_s), "{name}");
    }
    assert_eq!(number as usize, lanes.len(), "{name}");
}

/// No lane of a conflict leads into one of another where both meet the path, or is the same, with common places that touch.
fn are_apart(map: Map<'_>, conflicts: &[PathConflict], lanes: &[ConflictLane], name: &str) {
    let touch = |a: [f64; 2], b: [f64; 2]| (b[0] - a[1]).max(a[0] - b[1]) <= 0.5;
    let ends = |lane: &Lane<'_>| {
        let section = lane.section();
        let ends = [section.s_start(), section.s_end()];
        if lane.is_forward() { ends } else { [ends[1], ends[0]] }
    };
    for (number, one) in conflicts.iter().enumerate() {
        let others = conflicts.iter().enumerate().filter(|(other, _)| *other != number);
        let others: Vec<_> = others.flat_map(|(_, other)| other.lanes_of(lanes)).collect();
        for a in one.lanes_of(lanes) {
            let lane = map.lane(a.other).expect("a lane");
            for b in others.iter().filter(|b| touch(a.along, b.along)) {
                let is_one = if a.other == b.other {
                    touch(a.other_s, b.other_s)
                } else {
                    let next = map.lane(b.other).expect("a lane");
                    lane.successors().any(|id| id == b.other)
                        && touch(a.other_s, [ends(&lane)[1]; 2])
                        && touch(b.other_s, [ends(&next)[0]; 2])
                };
                assert!(!is_one, "{name}: {a:?}, {b:?}");
            }
        }
    }
}

#[test]
fn conflicts_lie_where_the_map_has_them_and_are_waited_for_before() {
    each_path(|map, path, _, name, _| {
        let (mut conflicts, mut lanes) = (Vec::new(), Vec::new());
        path.conflicts(&mut conflicts, &mut lanes);
        are_of_their_lanes(&conflicts, &lanes, name);
        are_apart(map, &conflicts, &lanes, name);
        lanes.sort_by(|a, b| a.along[0].total_cmp(&b.along[0]));
        let mut last = 0.0;
        for one in &lanes {
            let [from, to] = one.along;
            assert!(last <= from && from <= to && to <= path.length(), "{name}: {one:?}");
            last = from;
            assert!(one.wait <= from, "{name}: {one:?}");
            let own = map.lane(path.at(0.5 * (from + to)).expect("a place").lane).expect("a lane");
            let met = own.conflicts().any(|c| c.other().is_some_and(|o| o.lane_id() == one.other));
            let other = map.lane(one.other).expect("a lane");
            let elsewhere = match one.kind {
                ConflictKind::Merge => {
                    let ends = other.nodes().any(|node| node.edges().len() == 0);
                    let into = |id| path.lanes().any(|own| own.lane == id);
                    ends || other.successors().any(into) || other.is_bidirectional()
                }
                ConflictKind::Overlap => other.road().road_id() != own.road().road_id(),
                _ => false,
            };
            assert!(met || elsewhere, "{name}: lane {} and {one:?}", own.key());
            // A lane that the path comes from or goes on to there is no other's, but for what lies before its entry.
            let near = |a: f64, b: f64| (a - b).abs() < 1e-6;
            let [low, high] = one.other_s;
            let is_own = |driven: PathLane| {
                let [begin, end] = driven.s;
                let comes = near(driven.along[1], from) && low <= end && end <= high;
                let is_whole = if driven.forward { begin <= low } else { high <= begin };
                let goes_on = near(driven.along[0], to) && is_whole;
                driven.lane == one.other && (comes || goes_on)
            };
            assert!(!path.lanes().any(is_own), "{name}: {one:?}");
        }
    });
}

/// The curvature of the driven line is that of its own lane, not of the reference line; before the end and after it places are
/// clamped and told.
#[test]
fn places_on_a_bend_and_beyond_the_ends() {
    let text = "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/><road id=\"1\" length=\"100\" junction=\"-1\"><planView>\
        <geometry s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"100\"><arc curvature=\"0.02\"/></geometry></planView>\
        <elevationProfile><elevation s=\"0\" a=\"5\" b=\"0.03\" c=\"0\" d=\"0\"/></elevationProfile>\
        <lanes><laneSection s=\"0\"><left><lane id=\"1\" type=\"driving\"><width sOffset=\"0\" a=\"4\" b=\"0\" c=\"0\" d=\"0\"/></lane></left>\
        <center><lane id=\"0\"/></center><right><lane id=\"-1\" type=\"driving\">\
        <width sOffset=\"0\" a=\"4\" b=\"0\" c=\"0\" d=\"0\"/></lane></right></laneSection></lanes></road></OpenDRIVE>";
    let snapshot = mapd_tests::maps::open_text(text);
    let map = snapshot.map();
    for (key, radius, ends, turn) in
        [("1:0:-1", 52.0, [0.0, 100.0], 1.0), ("1:0:1", 48.0, [100.0, 0.0], -1.0)]
    {
        let lane = map.lane_by_key(&key.parse().expect("a key")).expect("a lane");
        let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
        steps_of_lanes(map, &[lane.lane_id()], ends, &mut steps).expect("steps");
        let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
        assert!((path.length() - 2.0 * radius).abs() < TOLERANCE, "{key}: {}", path.length());
        assert!(path.joints().is_empty(), "{:?}", path.joints());
        let at = path.at(30.0).expect("a place");
        assert!((at.curvature - turn / radius).abs() < 1e-9, "{at:?}");
        assert!(at.curvature_rate.abs() < 1e-6 && (at.left, at.right) == (2.0, 2.0), "{at:?}");
        let grade = turn * 0.03 * 50.0 / radius;
        assert!((at.grade - grade).abs() < 1e-9, "{at:?}");
        for (along, clamped) in [(-1.0, Clamped::Before), (1e9, Clamped::After)] {
            assert_eq!(path.at(along).expect("an end").clamped, clamped);
        }
        let end = path.at(path.length()).expect("the end");
        let beyond = end.position.truncate() + 3.0 * DVec2::from_angle(end.heading);
        let found = path.project(beyond, None).expect("a foot");
        assert_eq!((found.clamped, found.along), (Clamped::After, path.length()));
        assert!((found.distance - 3.0).abs() < TOLERANCE);
        assert_eq!(path.at(f64::NAN).err(), Some(QueryError::NotFinite));
        let refused = path.at_batch(&[0.0, f64::NAN], &mut Vec::new());
        assert_eq!(refused, Err(QueryError::NotFiniteAt(1)));
        for absurd in [f64::NAN, f64::INFINITY, 1e300, -1e300, 1.1e9] {
            for point in [DVec2::new(absurd, 0.0), DVec2::new(0.0, absurd)] {
                assert_eq!(path.project(point, None).err(), Some(QueryError::NotFinite));
                assert_eq!(path.project(point, Some(1.0)).err(), Some(QueryError::NotFinite));
            }
        }
        let far = path.project(DVec2::splat(1e9), None).expect("a foot");
        assert!(far.d.is_finite() && far.distance > 1.4e9, "{far:?}");
        assert_eq!(path.project(beyond, Some(f64::NAN)).err(), Some(QueryError::NotFinite));
        assert!(path.speed_at(f64::INFINITY).is_none());
        let mut room = Corridor::default();
        for step in [0.0, -1.0, f64::NAN, 1e-9] {
            let car = VehicleClass::PassengerCar;
            let refused = path.corridor(0.0, 50.0, step, car, &mut room);
            assert_eq!(refused, Err(QueryError::Option("step")), "{step}");
        }
        // Against the traffic's own direction, one after the other without a link, and nothing at all.
        let mut turned = steps.clone();
        (turned[0].s_from, turned[0].s_to) = (steps[0].s_to, steps[0].s_from);
        let mut path = |steps: &[RouteStep]| {
            map.path(steps, &PathOptions::default(), &mut buffer).map(|_| ()).err()
        };
        assert_eq!(path(&turned), Some(PathError::Backwards { step: 0 }));
        // Nothing is cut silently: a step beyond its lane is named.
        for wrong in [101.0, 1e300, -1e-3] {
            let outside = [
                RouteStep { s_from: wrong, ..steps[0] },
                RouteStep { s_to: wrong, ..steps[0] },
                RouteStep { s_latest: wrong, ..steps[0] },
            ];
            for step in outside {
                assert_eq!(path(&[step]), Some(PathError::OutsideLane { step: 0 }), "{step:?}");
            }
        }
        let unknown = RouteStep { s_latest: f64::NAN, ..steps[0] };
        let source = QueryError::NotFinite;
        assert_eq!(path(&[unknown]), Some(PathError::Step { step: 0, source }));
        assert_eq!(path(&[]), Some(PathError::Empty));
        let twice = [steps[0], RouteStep { enter: Enter::Ahead, ..steps[0] }];
        assert_eq!(path(&twice), Some(PathError::NotLinked { step: 1 }));
        let beside = [steps[0], RouteStep { enter: Enter::Left, ..steps[0] }];
        assert_eq!(path(&beside), Some(PathError::NotBeside { step: 1 }));
    }
}

/// A path that crosses itself: with a hint the answer stays on its branch.
#[test]
fn with_a_hint_the_answer_stays_on_its_branch() {
    // Three quarters of a circle back over its own beginning.
    let text = "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/><road id=\"1\" length=\"400\" junction=\"-1\"><planView>\
        <geometry s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"100\"><line/></geometry>\
        <geometry s=\"100\" x=\"100\" y=\"0\" hdg=\"0\" length=\"235.61944901923448\"><arc curvature=\"0.02\"/></geometry>\
        <geometry s=\"335.61944901923448\" x=\"50\" y=\"50\" hdg=\"4.71238898038469\" length=\"64.38055098076552\"><line/></geometry></planView>\
        <lanes><laneSection s=\"0\"><center><lane id=\"0\"/></center><right><lane id=\"-1\" type=\"driving\">\
        <width sOffset=\"0\" a=\"0.001\" b=\"0\" c=\"0\" d=\"0\"/></lane></right></laneSection></lanes></road></OpenDRIVE>";
    let snapshot = mapd_tests::maps::open_text(text);
    let map = snapshot.map();
    let lane = map.lane_by_key(&"1:0:-1".parse().expect("a key")).expect("a lane");
    let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
    steps_of_lanes(map, &[lane.lane_id()], [0.0, 400.0], &mut steps).expect("steps");
    let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    // 0.2 m from the first branch, 0.4 m from the second one.
    let point = DVec2::new(50.4, 0.2);
    let near = |hint| path.project(point, hint).expect("a foot").along;
    assert!((near(None) - 50.4).abs() < 0.01 && (near(Some(45.0)) - 50.4).abs() < 0.01);
    assert!((near(Some(380.0)) - 385.4).abs() < 0.1, "{}", near(Some(380.0)));
}

/// What only a rule of the road decides is unknown without one: a motorway does not yield to a ramp "from the right".
#[test]
fn without_written_priority_nobody_is_said_to_yield() {
    use mapd_client::vocabulary::RelationReason::{FromTheRight, Turn};
    each_path(|_, path, _, name, _| {
        let (mut conflicts, mut lanes) = (Vec::new(), Vec::new());
        path.conflicts(&mut conflicts, &mut lanes);
        for one in lanes {
            let by_rule = matches!(one.reason, FromTheRight | Turn);
            assert!(!by_rule || one.yields == Yields::Unknown, "{name}: {one:?}");
        }
    });
}
