//! Single queries, into buffers with room.

use crate::counted;
use mapd_client::localisation::{
    GroundScratch, MarkFilter, MatchOptions, VehicleOutline, VehiclePose,
};
use mapd_client::route::{
    LaneSequences, PositionOnLane, RouteScratch, ShortestTime, next_lane_change,
};
use mapd_client::signals::SignalsAhead;
use mapd_client::vocabulary::{ClassSet, VehicleClass};
use mapd_client::{
    LaneKey, LaneTypes, NearestOptions, Point, Region, Track,
    glam::{DMat3, DVec2},
};

/// Places in each buffer.
const ROOM: usize = 4096;

/// Signals at the crossing that the tests carry as code.
#[test]
fn queries_about_signals_do_not_allocate() {
    let snapshot = mapd_tests::object_maps::open(&mapd_tests::crossroads::furnished());
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
    let (seen, allocations) = counted(|| {
        let mut seen = 0;
        map.route(from, to, car, &cost, &mut scratch, &mut steps)
            .expect("an answer")
            .expect("a route");
        map.signals_along(&steps, &mut ahead).expect("an answer");
        map.lines_along(&steps, &mut lines).expect("an answer");
        seen += lines.len() + ahead.iter().len();
        seen += map.signals().flat_map(|s| s.boards()).map(|b| b.areas().len()).sum::<usize>();
        seen += map.objects().map(|object| object.signals().count()).sum::<usize>();
        for lane in map.lanes() {
            let from = PositionOnLane { lane: lane.lane_id(), s: 80.0 };
            map.signals_ahead(from, 200.0, VehicleClass::PassengerCar, &mut ahead)
                .expect("an answer");
            seen += ahead.iter().filter(|one| map.signal_of(one).is_some()).count();
            seen += lane.movement_lights().count() + lane.yields_to().count();
            seen += usize::from(lane.movement_stop().is_some()) + lane.crossings().count();
            seen += lane.movement_crossings().count();
            seen += usize::from(lane.overtaking_rule_at(5.0).all.is_some());
            seen += lane.speed_rules().count();
            seen +=
                usize::from(lane.speed_rule_at(5.0).max.is_some()) + lane.access_at(5.0).count();
            seen +=
                lane.traffic_lights().count() + usize::from(lane.movement_stop_line().is_some());
        }
        seen += map
            .signals()
            .map(|s| s.controllers().count() + s.id().len() + s.movements().count())
            .sum::<usize>();
        seen += usize::from(map.signal_by_id("L1").is_some());
        map.signals_near(DVec2::ZERO, 90.0, &mut near).expect("an answer");
        map.signals_in(Region::around(DVec2::ZERO, 90.0), &mut inside).expect("an answer");
        map.landmarks_near(DVec2::ZERO, 90.0, ClassSet::LANDMARKS, &mut landmarks)
            .expect("an answer");
        seen += near.len() + inside.len() + landmarks.len();
        seen
    });
    assert!(seen > 100, "the queries found nothing to count");
    assert_eq!(allocations, 0, "queries allocated");
}

#[test]
fn queries_do_not_allocate() {
    let snapshot = mapd_tests::maps::open(&mapd_tests::carried("town.xodr"));
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
    let (seen, allocations) = counted(|| {
        let copy = snapshot.clone();
        let map = copy.map();
        let mut seen = 0;
        for i in 0..200 {
            let point = DVec2::new(f64::from(i), f64::from(i * 3 % 200));
            let place = projector.to_geodetic(point.extend(1.0)).expect("a place");
            assert!(
                projector.from_geodetic(place).expect("a point").truncate().distance(point) < 1e-6
            );
            if let Some(hit) =
                map.nearest_lane(point, &NearestOptions::default()).expect("an answer")
            {
                let lane = map.lane(hit.lane).expect("known");
                seen += lane.successors().count() + lane.predecessors().count();
                seen +=
                    lane.center_line().len() + lane.left_bound().len() + lane.right_bound().len();
                seen += usize::from(lane.contains(point).expect("an answer"));
                lane.pose_at(1.0, 0.5).expect("a pose");
                lane.road().to_track(point).expect("a foot");
                lane.road().surface_at(hit.position.s, hit.position.t).expect("a surface");
            }
        }
        for i in 0..40 {
            let position = Point::from(DVec2::new(f64::from(i * 5), f64::from(i * 3)));
            let (pose, spread) = (VehiclePose { position, heading: 0.3 }, DMat3::IDENTITY);
            let outline = VehicleOutline { front: 3.6, back: 1.0, left: 0.9, right: 0.9 };
            for outline in [None, Some(outline)] {
                let options = MatchOptions { outline, ..MatchOptions::default() };
                let none = map.match_pose(&pose, &spread, &options, &mut matches);
                seen += matches.len() + usize::from(none.expect("an answer") > 0.5);
            }
            let found = map.ground_at(position, &[], &mut ground).expect("an answer");
            seen += usize::from(found.is_some());
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
            map.boundary_segments(region, LaneTypes::ALL, &mut work, &mut borders)
                .expect("an answer");
            map.road_mark_segments(region, LaneTypes::ALL, &mut work, &mut borders, &mut marks)
                .expect("an answer");
            seen += near.len() + lanes.len() + borders.len();
            let first = map.lanes().nth(i as usize).expect("a lane");
            seen += first.waypoints(0.5).expect("a step").count();
        }
        for (from, to) in all.iter().zip(all.iter().rev()) {
            let route =
                map.route(*from, *to, car, &cost, &mut scratch, &mut steps).expect("an answer");
            map.reachable(*from, 30.0, car, &cost, &mut scratch, &mut reached).expect("an answer");
            map.lane_sequences_behind(*from, 300.0, car, &mut scratch, &mut sequences)
                .expect("an answer");
            map.lane_sequences_ahead(*from, 300.0, car, &mut scratch, &mut sequences)
                .expect("an answer");
            while let Some(lanes) = sequences.next_sequence() {
                seen += lanes.len();
            }
            map.next_junction(*from, 300.0, car).expect("an answer");
            next_lane_change(map, &steps, 0, *from).expect("an answer");
            seen += usize::from(route.is_some()) + reached.len();
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
            seen += near_objects.len()
                + objects.lanes().map(|lane| lane.objects().count()).sum::<usize>();
            seen += usize::from(objects.object_by_id("2").is_some());
        }
        seen
    });
    assert!(seen > 100, "the queries found nothing to count");
    assert_eq!(allocations, 0, "queries allocated");
}
