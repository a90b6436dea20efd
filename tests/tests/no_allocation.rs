//! Queries do not allocate: an allocator counts.
#![allow(unsafe_code)]

use mapd_archive::{encode, open_overlay};
use mapd_client::batch::{
    BatchScratch, NearestLanes, Places, PoseMatches, Poses, TrackPositions, Tracks,
};
use mapd_client::geodesy::GeodeticPoint;
use mapd_client::localisation::{
    GroundScratch, MarkFilter, MatchOptions, Sensor, Tracker, TrackerOptions, VehiclePose,
};
use mapd_client::route::{
    AlternativeOptions, LaneSequences, PositionOnLane, Reach, RouteEnd, RouteRequest, RouteScratch,
    Routes, ShortestTime, WithTurns, next_lane_change,
};
use mapd_client::signals::SignalsAhead;
use mapd_client::view::View;
use mapd_client::vocabulary::ClassSet;
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{
    Lane, LaneKey, LaneTypes, NearestOptions, Point, Region, Snapshot, Track,
    glam::{DMat3, DVec2},
};
use mapd_compiler::{CompileOptions, compile};
use mapd_query::path::{
    Corridor, CorridorEdges, LaneChange, PathBuffer, PathOptions, PathPositions,
};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::time::UNIX_EPOCH;

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

struct Counting;

// SAFETY: every call is passed on to the system's allocator; counting touches nothing of it.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller's promises are passed on.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Places in each buffer.
const ROOM: usize = 4096;

/// Signals at the crossing that the tests carry as code.
#[test]
fn queries_about_signals_do_not_allocate() {
    let text = mapd_tests::crossroads::furnished();
    let compiled = compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {});
    let compiled = compiled.expect("reading works");
    let rows = compiled.rows.expect("accepted");
    let snapshot =
        Snapshot::from_bytes(encode(&rows, &compiled.provenance).expect("encodes")).expect("opens");
    let map = snapshot.map();
    let mut ahead = SignalsAhead::with_capacity(ROOM);
    let (mut near, mut inside, mut landmarks) =
        (Vec::with_capacity(ROOM), Vec::with_capacity(ROOM), Vec::with_capacity(ROOM));
    let car = VehicleClass::PassengerCar;
    let (mut scratch, mut steps, mut lines) = (
        RouteScratch::with_capacity(map.lane_nodes().len()),
        Vec::with_capacity(ROOM),
        Vec::with_capacity(ROOM),
    );
    let place = |key: &str| {
        let lane = map.lane_by_key(&key.parse().expect("a key")).expect("a lane");
        PositionOnLane { lane: lane.lane_id(), s: 80.0 }
    };
    let (from, to, cost) = (place("0:0:1"), place("2:0:-1"), ShortestTime::default());
    let before = COUNT.with(Cell::get);
    let mut seen = 0;
    map.route(from, to, car, &cost, &mut scratch, &mut steps).expect("an answer").expect("a route");
    map.signals_along(&steps, &mut ahead).expect("an answer");
    map.lines_along(&steps, &mut lines).expect("an answer");
    seen += lines.len() + ahead.iter().len();
    seen += map.signals().flat_map(|s| s.boards()).map(|b| b.areas().len()).sum::<usize>();
    seen += map.objects().map(|object| object.signals().count()).sum::<usize>();
    for lane in map.lanes() {
        let from = PositionOnLane { lane: lane.lane_id(), s: 80.0 };
        map.signals_ahead(from, 200.0, VehicleClass::PassengerCar, &mut ahead).expect("an answer");
        seen += ahead.iter().filter(|one| map.signal_of(one).is_some()).count();
        seen += lane.movement_lights().count() + lane.yields_to().count();
        seen += usize::from(lane.movement_stop().is_some()) + lane.crossings().count();
        seen += lane.movement_crossings().count();
        seen += usize::from(lane.overtaking_rule_at(5.0).all.is_some());
        seen += usize::from(lane.speed_rule_at(5.0).max.is_some()) + lane.access_at(5.0).count();
        seen += lane.traffic_lights().count() + usize::from(lane.movement_stop_line().is_some());
    }
    seen += map
        .signals()
        .map(|s| s.controllers().count() + s.id().len() + s.movements().count())
        .sum::<usize>();
    seen += usize::from(map.signal_by_id("L1").is_some());
    map.signals_near(DVec2::ZERO, 90.0, &mut near).expect("an answer");
    map.signals_in(Region::around(DVec2::ZERO, 90.0), &mut inside).expect("an answer");
    map.landmarks_near(DVec2::ZERO, 90.0, ClassSet::LANDMARKS, &mut landmarks).expect("an answer");
    seen += near.len() + inside.len() + landmarks.len();
    let after = COUNT.with(Cell::get);
    assert!(seen > 100, "the queries found nothing to count");
    assert_eq!(after - before, 0, "queries allocated");
}

#[test]
fn queries_do_not_allocate() {
    let file = std::fs::File::open(mapd_tests::carried("town.xodr")).expect("the map can be read");
    let compiled = compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
    let rows = compiled.rows.expect("accepted");
    let snapshot =
        Snapshot::from_bytes(encode(&rows, &compiled.provenance).expect("encodes")).expect("opens");
    let key: LaneKey<'_> = "1:0:-1".parse().expect("a key");
    // Lists go into the caller's buffers, which need room.
    let (mut near, mut lanes, mut work, mut borders, mut marks) = (
        Vec::with_capacity(ROOM),
        Vec::with_capacity(ROOM),
        Vec::with_capacity(ROOM),
        Vec::with_capacity(ROOM),
        Vec::with_capacity(ROOM),
    );
    let (car, cost) = (VehicleClass::PassengerCar, ShortestTime::default());
    let all: Vec<PositionOnLane> = snapshot
        .map()
        .lanes()
        .map(|lane| PositionOnLane { lane: lane.lane_id(), s: 1.0 })
        .collect();
    let (mut scratch, mut steps, mut reached, mut sequences) = (
        RouteScratch::with_capacity(snapshot.map().lane_nodes().len()),
        Vec::with_capacity(ROOM),
        Vec::with_capacity(ROOM),
        LaneSequences::with_capacity(ROOM),
    );
    let (mut matches, mut ground) = (Vec::with_capacity(ROOM), GroundScratch::with_capacity(ROOM));
    let objects = mapd_tests::object_maps::open(&mapd_tests::object_maps::document(
        &mapd_tests::object_maps::PLAIN,
        r#"<object id="1" type="tree" s="30" t="8" zOffset="0" radius="1" orientation="none"><repeat s="10" length="80" distance="10" tStart="8" tEnd="8" heightStart="2" heightEnd="2" zOffsetStart="0" zOffsetEnd="0"/></object>
<object id="2" type="crosswalk" s="50" t="0" zOffset="0" orientation="none"><outlines><outline id="0"><cornerRoad s="48" t="-6" dz="0" height="0"/><cornerRoad s="52" t="-6" dz="0" height="0"/><cornerRoad s="52" t="3" dz="0" height="0"/></outline></outlines></object>"#,
    ));
    let (mut near_objects, mut places, mut corners, mut landmarks) = (
        Vec::with_capacity(ROOM),
        Vec::with_capacity(ROOM),
        Vec::with_capacity(ROOM),
        Vec::with_capacity(ROOM),
    );
    let projector = mapd_client::geodesy::Projector::new(
        "+proj=tmerc +lat_0=48 +lon_0=11 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7",
        mapd_client::geodesy::Offset::default(),
    )
    .expect("a projector");
    let before = COUNT.with(Cell::get);
    let copy = snapshot.clone();
    let map = copy.map();
    let mut seen = 0;
    for i in 0..200 {
        let point = DVec2::new(f64::from(i), f64::from(i * 3 % 200));
        let place = projector.to_geodetic(point.extend(1.0)).expect("a place");
        assert!(projector.from_geodetic(place).expect("a point").truncate().distance(point) < 1e-6);
        if let Some(hit) = map.nearest_lane(point, &NearestOptions::default()).expect("an answer") {
            let lane = map.lane(hit.lane).expect("known");
            seen += lane.successors().count() + lane.predecessors().count();
            seen += lane.center_line().len() + lane.left_bound().len() + lane.right_bound().len();
            seen += usize::from(lane.contains(point).expect("an answer"));
            lane.pose_at(1.0, 0.5).expect("a pose");
            lane.road().to_track(point).expect("a foot");
            lane.road().surface_at(hit.position.s, hit.position.t).expect("a surface");
        }
    }
    for i in 0..40 {
        let position = Point::from(DVec2::new(f64::from(i * 5), f64::from(i * 3)));
        let (pose, spread) = (VehiclePose { position, heading: 0.3 }, DMat3::IDENTITY);
        let none = map.match_pose(&pose, &spread, &MatchOptions::default(), &mut matches);
        seen += matches.len() + usize::from(none.expect("an answer") > 0.5);
        seen += usize::from(map.ground_at(position, &mut ground).expect("an answer").is_some());
        let mark = map.nearest_mark(position.xy, &MarkFilter::default()).expect("an answer");
        seen += usize::from(mark.is_some());
    }
    let road = map.road_by_id("1").expect("a road");
    road.to_inertial(Track { s: 3.0, t: 1.0, h: 0.0 }).expect("a pose");
    seen += map.lane_by_key(&key).map_or(0, |lane| lane.speeds().len() + 1);
    seen += map.junction_by_id("1000").map_or(0, |junction| junction.connections().len());
    for i in 0..20 {
        let point = DVec2::new(f64::from(i * 10), f64::from(i * 7));
        let region = Region::around(point, 20.0);
        map.lanes_near(point, &NearestOptions::default(), &mut near).expect("an answer");
        map.lanes_in(region, LaneTypes::ALL, &mut lanes).expect("an answer");
        map.boundary_segments(region, LaneTypes::ALL, &mut work, &mut borders).expect("an answer");
        map.road_mark_segments(region, LaneTypes::ALL, &mut work, &mut borders, &mut marks)
            .expect("an answer");
        seen += near.len() + lanes.len() + borders.len();
        let first = map.lanes().nth(i as usize).expect("a lane");
        seen += first.waypoints(0.5).expect("a step").count();
    }
    for (from, to) in all.iter().zip(all.iter().rev()) {
        let route = map.route(*from, *to, car, &cost, &mut scratch, &mut steps).expect("an answer");
        map.reachable(*from, 30.0, car, &cost, &mut scratch, &mut reached).expect("an answer");
        map.lane_sequences_ahead(*from, 300.0, car, &mut sequences).expect("an answer");
        map.lane_sequences_behind(*from, 300.0, car, &mut sequences).expect("an answer");
        map.next_junction(*from, 300.0, car).expect("an answer");
        next_lane_change(map, &steps, 0, *from).expect("an answer");
        seen += usize::from(route.is_some()) + reached.len() + sequences.iter().len();
        let lane = map.lane(from.lane).expect("known");
        seen += lane.conflicts().count() + usize::from(lane.opposite().is_some());
    }
    let objects = objects.map();
    for i in 0..20 {
        let point = DVec2::new(f64::from(i * 5), 0.0);
        objects.objects_near(point, 20.0, &mut near_objects).expect("an answer");
        objects.objects_in(Region::around(point, 10.0), &mut places).expect("an answer");
        objects
            .landmarks_in(Region::around(point, 10.0), ClassSet::LANDMARKS, &mut landmarks)
            .expect("an answer");
        for place in &places {
            let place = objects.placement(*place).expect("known");
            place.footprint(&mut corners);
            seen += corners.len() + place.object().lanes().len() + place.outlines().len();
        }
        seen +=
            near_objects.len() + objects.lanes().map(|lane| lane.objects().count()).sum::<usize>();
        seen += usize::from(objects.object_by_id("2").is_some());
    }
    let after = COUNT.with(Cell::get);
    assert!(seen > 100, "the queries found nothing to count");
    assert_eq!(after - before, 0, "queries allocated");
}

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
    let first = round();
    let before = COUNT.with(Cell::get);
    let again = round();
    let after = COUNT.with(Cell::get);
    assert!(first > 100 && first == again, "{first}, {again}");
    assert_eq!(after - before, 0, "requests allocated");
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
    let (mut room, mut conflicts, mut places) = (Corridor::default(), Vec::new(), Vec::new());
    let (mut segments, mut facts, mut speeds, mut part) =
        (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let (mut ring, mut other) = (Vec::new(), PathBuffer::default());
    let (mut crossings, mut approaches) = (Vec::new(), Vec::new());
    let lateral = PathOptions { change: LaneChange::Lateral(5.0), ..PathOptions::default() };
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
            path.conflicts(&mut conflicts);
            path.crossings(&mut crossings);
            seen += crossings.len();
            for conflict in &conflicts {
                map.approaches(conflict, 100.0, car, &mut approaches).expect("lanes");
                seen += approaches.len();
            }
            path.segments(car, &mut segments);
            path.facts(&mut facts);
            path.speeds(&mut speeds);
            path.steps_between(&steps, [0.0, at.along], &mut part).expect("steps");
            seen += segments.len() + facts.len() + speeds.len() + part.len();
            let speed = path.speed_at(at.along).is_some();
            seen += room.len() + conflicts.len() + usize::from(speed) + path.joints().len();
        }
        seen
    };
    let first = round();
    let before = COUNT.with(Cell::get);
    let again = round();
    let after = COUNT.with(Cell::get);
    assert!(first > 100 && first == again, "the paths have nothing to count");
    assert_eq!(after - before, 0, "paths allocated");
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
    let before = COUNT.with(Cell::get);
    let mut seen = 0;
    for fixes in &fixes {
        tracker.reset();
        for fix in fixes {
            tracker.update(map, fix, &options).expect("an answer");
            seen += tracker.hypotheses().len();
        }
    }
    let again = batches();
    let after = COUNT.with(Cell::get);
    assert!(seen > fixes[0].len() && first == again, "there is nothing to count");
    assert_eq!(after - before, 0, "tracker or batches allocated");
}

/// What a view adds to a map's answers: nothing on the heap. On the town and on the crossing with signals, under entries of every kind on each third lane.
#[test]
fn views_do_not_allocate_after_the_first_call() {
    for snapshot in [
        mapd_tests::maps::open(&mapd_tests::carried("town.xodr")),
        mapd_tests::object_maps::open(&mapd_tests::crossroads::furnished()),
    ] {
        let map = snapshot.map();
        let (bytes, resolved) = mapd_tests::overlays::over(map, &todays_entries(&snapshot), true);
        assert_eq!(resolved.unplaced, []);
        let overlay = open_overlay(&bytes).expect("opens");
        let view = View::new(map, Some(&overlay), UNIX_EPOCH).expect("its own");
        let mut round = questions_of(view);
        let first = round();
        let before = COUNT.with(Cell::get);
        let again = round();
        let after = COUNT.with(Cell::get);
        assert!(first.iter().all(|seen| *seen > 0) && first == again, "{first:?}, {again:?}");
        assert_eq!(after - before, 0, "a view allocated");
    }
}

/// A document with entries of every kind: on a part of a lane, on whole lanes, some for the time of the epoch's week only.
fn todays_entries(snapshot: &Snapshot) -> String {
    let map = snapshot.map();
    let open = |lane: &Lane<'_>| lane.nodes().any(|node| node.allows(VehicleClass::PassengerCar));
    let lanes = map.lanes().filter(open).step_by(3);
    let mut entries: Vec<String> = lanes
        .enumerate()
        .map(|(i, lane)| {
            let (from, to) = (lane.section().s_start(), lane.section().s_end());
            let (key, third) = (lane.key(), (to - from) / 3.0);
            let (from, to) = (from + third, to - third);
            let what = match i % 6 {
                0 => format!(r#""kind":"closed","lanes":[{{"key":"{key}","s":[{from},{to}]}}]"#),
                1 => format!(r#""kind":"speed","value":3,"lanes":[{{"key":"{key}"}}]"#),
                2 => format!(
                    r#""kind":"wet","weekly":[{{"days":["thu"],"from":"00:00","until":"01:00"}}],"lanes":[{{"key":"{key}"}}]"#
                ),
                3 => format!(r#""kind":"only","vehicles":["passengerCar"],"lanes":[{{"key":"{key}"}}]"#),
                4 => format!(r#""kind":"no-overtaking","lanes":[{{"key":"{key}"}}]"#),
                _ => format!(r#""kind":"warning","text":"cones","lanes":[{{"key":"{key}"}}]"#),
            };
            format!(r#"{{"id":"{i}",{what}}}"#)
        })
        .collect();
    for signal in map.signals() {
        let id = signal.id();
        entries.push(format!(r#"{{"id":"off {id}","kind":"signal-off","signals":["{id}"]}}"#));
    }
    format!(r#"{{"entries":[{}]}}"#, entries.join(","))
}

/// All questions of a view, with buffers that it fills on the first round: how much each group of them found.
fn questions_of(view: View<'_>) -> impl FnMut() -> [usize; 5] {
    let (map, car) = (view.map(), VehicleClass::PassengerCar);
    let cost = ShortestTime::default();
    let places: Vec<PositionOnLane> = map
        .lanes()
        .filter(|lane| lane.nodes().any(|node| node.allows(car)))
        .map(|lane| {
            let s = 0.5 * (lane.section().s_start() + lane.section().s_end());
            PositionOnLane { lane: lane.lane_id(), s }
        })
        .collect();
    let (mut scratch, mut steps, mut reached, mut network, mut routes) =
        (RouteScratch::default(), Vec::new(), Vec::new(), Reach::default(), Routes::default());
    let (mut met, mut on_path, mut room, mut buffer) =
        (Vec::new(), Vec::new(), Corridor::default(), PathBuffer::default());
    let (mut ahead, mut matches) = (SignalsAhead::default(), Vec::new());
    move || {
        let [mut at_place, mut ways, mut along, mut signals, mut poses] = [0; 5];
        for (from, to) in places.iter().zip(places.iter().rev()) {
            let PositionOnLane { lane, s } = *from;
            at_place += view.restrictions_at(lane, s).expect("an answer").count();
            view.overtaking_rule_at(lane, s, car).expect("an answer");
            let permission = view.allows(lane, s, car).expect("an answer");
            let speed = view.speed_rule_at(lane, s, car).expect("an answer");
            at_place += usize::from(permission.restriction.or(speed.restriction).is_some());
            let (starts, goals) = ([RouteEnd::from(*from)], [RouteEnd::from(*to)]);
            let request = RouteRequest {
                starts: &starts,
                goals: &goals,
                vehicle: car,
                cost: &cost,
                avoid: &[],
            };
            let options = AlternativeOptions { share: 0.3, ..AlternativeOptions::default() };
            view.alternatives(&request, &options, &mut scratch, &mut routes).expect("routes");
            view.reachable(*from, 100.0, car, &cost, &mut scratch, &mut reached)
                .expect("an answer");
            view.reach(&request, 30.0, &mut scratch, &mut network).expect("an answer");
            view.reach_to(&request, 30.0, &mut scratch, &mut network).expect("an answer");
            ways += routes.iter().len() + reached.len() + network.reached().len();
            view.find_route(&request, &mut scratch, &mut steps).expect("an answer");
            let found = view.route(*from, *to, car, &cost, &mut scratch, &mut steps);
            view.signals_ahead(*from, 200.0, car, &mut ahead).expect("an answer");
            let point = map.lane(lane).expect("a lane").pose_at(s, 0.0).expect("a pose").position;
            let pose = VehiclePose { position: Point::from(point.truncate()), heading: 0.3 };
            view.match_pose(&pose, &DMat3::IDENTITY, &MatchOptions::default(), &mut matches)
                .expect("an answer");
            poses += matches.len();
            if found.expect("an answer").is_none() {
                continue;
            }
            view.restrictions_along(&steps, car, &mut met).expect("an answer");
            along += met.len();
            let Ok(path) = map.path(&steps, &PathOptions::default(), &mut buffer) else { continue };
            view.restrictions_on_path(&path, car, &mut on_path).expect("an answer");
            let speed = view.speed_on_path(&path, 0.5 * path.length(), car).expect("an answer");
            view.corridor(&path, 0.0, 150.0, 1.0, car, &mut room).expect("a corridor");
            along += on_path.len() + usize::from(speed.restriction.is_some()) + room.len();
        }
        for signal in map.signals() {
            let off = view.signal_out_of_service(signal.signal_id()).expect("an answer");
            signals += usize::from(off.is_some());
        }
        signals += view.entries().filter(|entry| view.holds(entry)).count();
        signals += view.restrictions().count();
        [at_place, ways, along, signals, poses]
    }
}

/// Lists of places, marks and landmarks: what goes into a caller's buffer grows once.
#[test]
fn lists_of_places_do_not_allocate_after_the_first_call() {
    let snapshot = mapd_tests::maps::open(&mapd_tests::carried("town.xodr"));
    let painted_map = mapd_tests::maps::open(&mapd_tests::carried("marks.xodr"));
    let furnished = mapd_tests::object_maps::open(&mapd_tests::crossroads::furnished());
    let (map, painted_map) = (snapshot.map(), painted_map.map());
    let mut random = mapd_tests::maps::Random(5);
    let near_paint: Vec<DVec2> = (0..100).map(|_| random.point(painted_map)).collect();
    let projector = mapd_client::geodesy::Projector::new(
        "+proj=tmerc +lat_0=48 +lon_0=11 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7",
        mapd_client::geodesy::Offset::default(),
    )
    .expect("a projector");
    let flat: Vec<DVec2> =
        (0..100).map(|i| DVec2::new(f64::from(i), f64::from(i * 3 % 100))).collect();
    let points: Vec<Point> = flat.iter().map(|point| Point::from(*point)).collect();
    let raised: Vec<_> = flat.iter().map(|point| point.extend(1.0)).collect();
    let (x, y): (Vec<f64>, Vec<f64>) = flat.iter().map(|point| (point.x, point.y)).unzip();
    let road = map.road_by_id("1").expect("a road");
    let (mut ground, mut grounds) = (GroundScratch::default(), Vec::new());
    let (mut marks, mut painted, mut landmarks) = (Vec::new(), Vec::new(), Vec::new());
    let (mut work, mut borders, mut lines) = (Vec::new(), Vec::new(), Vec::new());
    let (mut poses, mut feet) = (Poses::default(), TrackPositions::default());
    let (mut earth, mut places, mut back) = (Vec::new(), Vec::new(), Vec::new());
    let wheels = [[2.7, 0.8], [2.7, -0.8], [0.0, 0.8], [0.0, -0.8]].map(DVec2::from);
    let sensor = Sensor { position: DVec2::ZERO, heading: 0.5, range: 200.0, field_of_view: 6.2 };
    let mut round = || {
        map.ground_below(&points, &mut ground, &mut grounds).expect("heights");
        let mut stands = 0;
        for position in &points {
            let pose = VehiclePose { position: *position, heading: 0.3 };
            let stance = map.stance(&pose, &wheels, &mut ground).expect("an answer");
            stands += usize::from(stance.is_some());
        }
        let filter = MarkFilter::default();
        painted_map.nearest_marks(&near_paint, &filter, &mut marks).expect("marks");
        let region = Region::around(near_paint[0], 100.0);
        painted_map.mark_points(region, 0.5, &filter, &mut painted).expect("points");
        painted_map
            .road_mark_segments(region, LaneTypes::ALL, &mut work, &mut borders, &mut lines)
            .expect("lines");
        let seen = furnished.map().landmarks_in_view(&sensor, ClassSet::ALL, &mut landmarks);
        seen.expect("landmarks");
        let places_on = Places { x: &x, y: &y, ..Places::default() };
        road.to_track_batch(places_on, &mut feet).expect("feet");
        let tracks = Tracks { s: &feet.s, t: &feet.t, h: None };
        road.to_inertial_batch(tracks, &mut poses).expect("places");
        projector.to_geodetic_batch(&raised, &mut earth);
        places.clear();
        places.extend(earth.iter().flatten());
        projector.from_geodetic_batch(&places, &mut back);
        let mut lanes = 0;
        for place in &places {
            let at = GeodeticPoint {
                latitude: place.latitude,
                longitude: place.longitude,
                altitude: Some(place.altitude),
            };
            let found = map.nearest_lane_geodetic(&projector, at, &NearestOptions::default());
            lanes += usize::from(found.expect("an answer").is_some());
        }
        [
            lanes,
            grounds.iter().flatten().count(),
            stands,
            marks.iter().flatten().count(),
            painted.len(),
            lines.len(),
            landmarks.len(),
            feet.s.len(),
            poses.x.len(),
            back.iter().flatten().count(),
        ]
    };
    let first = round();
    let before = COUNT.with(Cell::get);
    let again = round();
    let after = COUNT.with(Cell::get);
    assert!(first.iter().all(|seen| *seen > 0) && first == again, "{first:?}, {again:?}");
    assert_eq!(after - before, 0, "lists of places allocated");
}
