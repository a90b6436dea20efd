//! Views: what they add to a map's answers.

use crate::settles;
use mapd_archive::open_overlay;
use mapd_client::Point;
use mapd_client::glam::DMat3;
use mapd_client::localisation::{MatchOptions, VehiclePose};
use mapd_client::route::{
    AlternativeOptions, PositionOnLane, Reach, RouteEnd, RouteRequest, RouteScratch, Routes,
    ShortestTime,
};
use mapd_client::signals::SignalsAhead;
use mapd_client::view::View;
use mapd_client::vocabulary::VehicleClass;
use mapd_query::path::{Corridor, PathBuffer, PathOptions};
use mapd_tests::overlays::{over, todays_entries};
use std::time::UNIX_EPOCH;

/// What a view adds to a map's answers: nothing on the heap. On the town and on the crossing with signals, under entries of every kind on each third lane.
#[test]
fn views_do_not_allocate_after_the_first_call() {
    for snapshot in [
        mapd_tests::maps::open(&mapd_tests::carried("town.xodr")),
        mapd_tests::object_maps::open(&mapd_tests::crossroads::furnished()),
    ] {
        let map = snapshot.map();
        let (bytes, resolved) = over(map, &todays_entries(map), true);
        assert_eq!(resolved.unplaced, []);
        let overlay = open_overlay(&bytes).expect("opens");
        let view = View::new(map, Some(&overlay), UNIX_EPOCH).expect("its own");
        settles("a view", 0, questions_of(view));
    }
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
    let (mut speeds, mut segments) = (Vec::new(), Vec::new());
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
            view.speeds_on_path(&path, car, &mut speeds).expect("an answer");
            view.segments_on_path(&path, car, &mut segments).expect("an answer");
            let all = [0.0, path.length()];
            let time = view.travel_time_on_path(&path, all, car).expect("an answer");
            along += speeds.len() + segments.len() + usize::from(time.time > 0.0);
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
