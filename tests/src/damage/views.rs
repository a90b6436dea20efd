//! Questions about a map under an overlay, of which either may be damaged.

use super::paths;
use mapd_archive::AlignedBytes;
use mapd_client::glam::DMat3;
use mapd_client::localisation::{MatchOptions, VehiclePose};
use mapd_client::path::{Corridor, PathBuffer, PathOptions};
use mapd_client::route::{
    AlternativeOptions, PositionOnLane, Reach, RouteEnd, RouteRequest, RouteScratch, Routes,
    ShortestTime,
};
use mapd_client::signals::SignalsAhead;
use mapd_client::view::View;
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Lane, Map, Point, Snapshot};
use std::time::UNIX_EPOCH;

/// Asks everything of a map under an overlay; only the absence of a panic counts.
pub fn ask_under(map: AlignedBytes, overlay: AlignedBytes) {
    let Ok(snapshot) = Snapshot::from_bytes(map) else { return };
    let Ok(snapshot) = snapshot.with_overlay(overlay) else { return };
    ask(snapshot.view(UNIX_EPOCH));
}

fn ask(view: View<'_>) {
    let (map, car) = (view.map(), VehicleClass::PassengerCar);
    let _ = view.entries().filter(|entry| view.holds(entry)).map(|entry| entry.id().len()).last();
    let _ = view.restrictions().map(|one| one.entry.text().len()).last();
    for signal in map.signals() {
        let _ = view.signal_out_of_service(signal.signal_id());
    }
    for lane in map.lanes().filter(|lane| lane.nodes().next().is_some()) {
        let s = 0.5 * (lane.section().s_start() + lane.section().s_end());
        let id = lane.lane_id();
        let _ = view.restrictions_at(id, s).map(Iterator::count);
        let _ = view.overtaking_rule_at(id, s, car).is_ok();
        let _ = (view.allows(id, s, car).is_ok(), view.speed_rule_at(id, s, car).is_ok());
    }
    ways(view, map, car);
}

fn ways(view: View<'_>, map: Map<'_>, car: VehicleClass) {
    let middle = |lane: &Lane<'_>| {
        let s = 0.5 * (lane.section().s_start() + lane.section().s_end());
        PositionOnLane { lane: lane.lane_id(), s }
    };
    let lanes = map.lanes().filter(|lane| lane.nodes().next().is_some());
    let places: Vec<PositionOnLane> = lanes.map(|lane| middle(&lane)).collect();
    let cost = ShortestTime::default();
    let (mut scratch, mut steps, mut reached, mut network, mut routes) =
        (RouteScratch::default(), Vec::new(), Vec::new(), Reach::default(), Routes::default());
    let (mut buffer, mut room) = (PathBuffer::default(), Corridor::default());
    for (from, to) in places.iter().zip(places.iter().rev()).take(super::FEW) {
        let (starts, goals) = ([RouteEnd::from(*from)], [RouteEnd::from(*to)]);
        let request =
            RouteRequest { starts: &starts, goals: &goals, vehicle: car, cost: &cost, avoid: &[] };
        for share in [0.0, 0.3] {
            let options = AlternativeOptions { share, ..AlternativeOptions::default() };
            let _ = view.alternatives(&request, &options, &mut scratch, &mut routes);
        }
        let _ = view.reachable(*from, 100.0, car, &cost, &mut scratch, &mut reached);
        let _ = view.reach(&request, 30.0, &mut scratch, &mut network);
        let _ = view.reach_to(&request, 30.0, &mut scratch, &mut network);
        let _ = view.signals_ahead(*from, 200.0, car, &mut SignalsAhead::default());
        let Ok(lane) = map.lane(from.lane) else { continue };
        if let Ok(pose) = lane.pose_at(from.s, 0.0) {
            let position = Point::from(pose.position.truncate());
            let pose = VehiclePose { position, heading: 0.3 };
            let options = MatchOptions::default();
            let _ = view.match_pose(&pose, &DMat3::IDENTITY, &options, &mut Vec::new());
        }
        if let Ok(Some(_)) = view.route(*from, *to, car, &cost, &mut scratch, &mut steps) {
            let _ = view.restrictions_along(&steps, car, &mut Vec::new());
        }
    }
    paths::ways(map, |steps| {
        let Ok(path) = map.path(steps, &PathOptions::default(), &mut buffer) else { return };
        let length = path.length();
        let _ = view.restrictions_on_path(&path, car, &mut Vec::new());
        let _ = view.speed_on_path(&path, 0.5 * length, car);
        let _ = view.speeds_on_path(&path, car, &mut Vec::new());
        let _ = view.segments_on_path(&path, car, &mut Vec::new());
        let _ = view.travel_time_on_path(&path, [0.0, length], car);
        let _ = view.corridor(&path, 0.0, length, (length / 100.0).max(1.0), car, &mut room);
    });
}
