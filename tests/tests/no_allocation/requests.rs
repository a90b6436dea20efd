//! Searches, paths, trackers and batches: their buffers grow once.

use crate::{counted, settles};
use mapd_client::NearestOptions;
use mapd_client::batch::{BatchScratch, NearestLanes, Places, PoseMatches};
use mapd_client::glam::DMat3;
use mapd_client::localisation::{MatchOptions, Tracker, TrackerOptions};
use mapd_client::route::{
    AlternativeOptions, PositionOnLane, Reach, RouteEnd, RouteRequest, RouteScratch, Routes,
    ShortestTime, WithTurns,
};
use mapd_client::vocabulary::{ConflictKind, VehicleClass};
use mapd_query::path::{
    Corridor, CorridorEdges, LaneChange, PathBuffer, PathOptions, PathPositions, steps_of_lanes,
};
use mapd_tests::graph_maps::{Line, document, lane, link, road, section};
use std::f64::consts::FRAC_PI_2;

/// A search's buffers grow once, whatever is asked of it.
#[test]
fn requests_do_not_allocate_after_the_first_call() {
    let snapshot = mapd_tests::maps::open(&mapd_tests::carried("town.xodr"));
    let map = snapshot.map();
    let base = ShortestTime::default();
    let all: Vec<RouteEnd> = map
        .lanes()
        .map(|lane| RouteEnd::from(PositionOnLane { lane: lane.lane_id(), s: 1.0 }))
        .collect();
    let avoid = [all[7].place.lane];
    let cost = WithTurns { base, left: 5.0, right: 1.0, back: 9.0 };
    let (mut scratch, mut steps, mut network, mut routes) =
        (RouteScratch::default(), Vec::new(), Reach::default(), Routes::default());
    let mut round = || {
        let mut seen = 0;
        for (starts, goals) in all.chunks(3).zip(all.rchunks(2)).step_by(9) {
            let vehicle = VehicleClass::PassengerCar;
            let request = RouteRequest { starts, goals, vehicle, cost: &cost, avoid: &avoid };
            let found = map.find_route(&request, &mut scratch, &mut steps).expect("an answer");
            map.reach(&request, 30.0, &mut scratch, &mut network).expect("an answer");
            map.reach_to(&request, 30.0, &mut scratch, &mut network).expect("an answer");
            seen += usize::from(found.is_some()) + network.reached().len();
            for share in [0.0, 0.3] {
                let options = AlternativeOptions { share, ..AlternativeOptions::default() };
                map.alternatives(&request, &options, &mut scratch, &mut routes).expect("routes");
                seen += routes.iter().len();
            }
        }
        seen
    };
    settles("requests", 100, || [round()]);
}

/// A path's buffers grow once; then nothing along it allocates.
#[test]
fn paths_do_not_allocate_after_the_first_call() {
    let snapshot = mapd_tests::maps::open(&mapd_tests::carried("town.xodr"));
    let map = snapshot.map();
    let (car, cost) = (VehicleClass::PassengerCar, ShortestTime::default());
    let all: Vec<PositionOnLane> =
        map.lanes().map(|lane| PositionOnLane { lane: lane.lane_id(), s: 1.0 }).collect();
    let (mut scratch, mut steps, mut buffer) =
        (RouteScratch::default(), Vec::new(), PathBuffer::default());
    let mut feet = PathPositions::default();
    let (mut room, mut places) = (Corridor::default(), Vec::new());
    let (mut conflicts, mut met) = (Vec::new(), Vec::new());
    let (mut segments, mut facts, mut speeds, mut part) =
        (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let (mut ring, mut other) = (Vec::new(), PathBuffer::default());
    let (mut crossings, mut approaches) = (Vec::new(), Vec::new());
    let lateral = PathOptions {
        change: LaneChange::Lateral(40.0),
        shortest_change: Some(5.0),
        ..PathOptions::default()
    };
    let stations = [0.0, 5.0, 10.0, 1e9];
    let mut round = || {
        let mut seen = 0;
        for (from, to) in all.iter().zip(all.iter().rev()) {
            let found = map.route(*from, *to, car, &cost, &mut scratch, &mut steps);
            if found.expect("an answer").is_none() {
                continue;
            }
            let Ok(path) = map.path(&steps, &PathOptions::default(), &mut buffer) else { continue };
            let at = path.at(0.5 * path.length()).expect("a place");
            let point = at.position.truncate();
            path.project(point, Some(at.along)).expect("a foot");
            let both = Places { x: &[point.x, 0.0], y: &[point.y, 0.0], ..Places::default() };
            path.project_batch(both, &mut feet).expect("feet");
            path.at_batch(&stations, &mut places).expect("places");
            path.corridor(0.0, 150.0, 1.0, car, &mut room).expect("a corridor");
            path.corridor_surface(&mut room).expect("surfaces");
            room.outline(CorridorEdges::Open, &mut ring);
            let curved = map.path(&steps, &lateral, &mut other).expect("a path");
            seen += curved.joints().len();
            path.conflicts(&mut conflicts, &mut met);
            path.crossings(&mut crossings);
            seen += crossings.len();
            for conflict in &conflicts {
                map.approaches(conflict.lanes_of(&met), 100.0, car, &mut approaches)
                    .expect("lanes");
                seen += approaches.len();
            }
            path.segments(car, &mut segments);
            path.facts(&mut facts);
            path.speeds(&mut speeds);
            path.steps_between(&steps, [0.0, at.along], &mut part).expect("steps");
            seen += segments.len() + facts.len() + speeds.len() + part.len();
            let time = path.travel_time([0.0, at.along]).expect("a time");
            seen += usize::from(time.time + time.unlimited > 0.0);
            let speed = path.speed_at(at.along).is_some();
            seen += room.len() + conflicts.len() + usize::from(speed) + path.joints().len();
        }
        seen
    };
    settles("paths", 100, || [round()]);
}

/// Two roads cross without a junction, and one lane of a third joins: what the carried town has none of.
#[test]
fn overlaps_and_merges_do_not_allocate_after_the_first_call() {
    let plain = "junction=\"-1\"";
    let own = |links: &str| section(0.0, "", &lane(-1, links));
    let main =
        road("1", plain, Line(0.0, 0.0, 0.0, 100.0, 0.0), &link("s road 2 start"), &own("s-1"));
    let next =
        road("2", plain, Line(100.0, 0.0, 0.0, 50.0, 0.0), &link("p road 1 end"), &own("p-1"));
    let across = road("3", plain, Line(50.0, -50.0, FRAC_PI_2, 100.0, 0.0), "", &own(""));
    let joins =
        road("4", plain, Line(0.5, -9.98, 0.1, 100.0, 0.0), &link("s road 2 start"), &own("s-1"));
    let snapshot = mapd_tests::maps::open_text(&document(&(main + &next + &across + &joins)));
    let map = snapshot.map();
    let id = |key: &str| map.lane_by_key(&key.parse().expect("a key")).expect("a lane").lane_id();
    let lanes = [id("1:0:-1"), id("2:0:-1")];
    let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
    let (mut together, mut found) = (Vec::new(), Vec::new());
    let mut round = || {
        steps_of_lanes(map, &lanes, [5.0, 40.0], &mut steps).expect("steps");
        let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
        path.conflicts(&mut together, &mut found);
        let of = |kind: ConflictKind| found.iter().filter(|one| one.kind == kind).count();
        [of(ConflictKind::Overlap), of(ConflictKind::Merge)]
    };
    settles("overlaps", 0, &mut round);
}

/// A tracker takes all its memory when it is made; batches grow once.
#[test]
fn trackers_and_batches_do_not_allocate_after_the_start() {
    let snapshot = mapd_tests::maps::open(&mapd_tests::carried("town.xodr"));
    let (map, random) = (snapshot.map(), &mut mapd_tests::maps::Random(5));
    let truth = mapd_tests::drives::drive(map, 60.0, random);
    let fixes = [[0.3, 0.05], [20.0, 0.5]]
        .map(|noise| mapd_tests::drives::localise(&truth, 1, noise, true, random));
    let (options, mut tracker) = (TrackerOptions::default(), Tracker::new());
    let (mut x, mut y, mut poses) = (Vec::new(), Vec::new(), Vec::new());
    for fix in fixes.iter().flatten() {
        x.push(fix.pose.position.xy.x);
        y.push(fix.pose.position.xy.y);
        poses.push(fix.pose);
    }
    let places = Places { x: &x, y: &y, z: None, heading: None };
    let (mut scratch, mut lanes, mut matches) =
        (BatchScratch::default(), NearestLanes::default(), PoseMatches::default());
    let mut batches = || {
        let options = NearestOptions::default();
        map.nearest_lanes(places, &options, &mut scratch, &mut lanes).expect("answers");
        let options = MatchOptions::default();
        map.match_poses(&poses, &[DMat3::IDENTITY], &options, &mut scratch, &mut matches)
            .expect("answers");
        lanes.lane.iter().flatten().count() + matches.of(0).len()
    };
    let first = batches();
    let ((seen, again), allocations) = counted(|| {
        let mut seen = 0;
        for fixes in &fixes {
            tracker.reset();
            for fix in fixes {
                tracker.update(map, fix, &options).expect("an answer");
                seen += tracker.hypotheses().len();
            }
        }
        (seen, batches())
    });
    assert!(seen > fixes[0].len() && first == again, "there is nothing to count");
    assert_eq!(allocations, 0, "tracker or batches allocated");
}
