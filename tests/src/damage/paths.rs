//! Questions about paths: along routes between lanes, and along single lanes.

use mapd_client::batch::Places;
use mapd_client::glam::DVec2;
use mapd_client::path::{
    Corridor, CorridorEdges, LaneChange, Path, PathBuffer, PathOptions, PathPositions,
    steps_of_lanes,
};
use mapd_client::route::{
    AlternativeOptions, PositionOnLane, Reach, RouteEnd, RouteRequest, RouteScratch, RouteStep,
    Routes, ShortestLength, ShortestTime,
};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Map, Region};

const CAR: VehicleClass = VehicleClass::PassengerCar;
/// Lanes and routes that are asked along.
const PATHS: usize = 4;

/// Calls back with the steps of some ways on a map.
pub(super) fn ways(map: Map<'_>, mut tell: impl FnMut(&[RouteStep])) {
    let middle = |lane: mapd_client::Lane<'_>| {
        let s = 0.5 * (lane.section().s_start() + lane.section().s_end());
        PositionOnLane { lane: lane.lane_id(), s }
    };
    let open = || map.lanes().filter(|lane| lane.nodes().next().is_some());
    let count = open().count();
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    for lane in open().step_by((count / PATHS).max(1)).take(PATHS) {
        let (start, end) = (lane.section().s_start(), lane.section().s_end());
        let ends = if lane.is_forward() { [start, end] } else { [end, start] };
        if steps_of_lanes(map, &[lane.lane_id()], ends, &mut steps).is_ok() {
            tell(&steps);
        }
        let from = middle(lane);
        let Some(to) = open().nth((lane.lane_id().row() as usize * 7 + 3) % count).map(middle)
        else {
            continue;
        };
        if let Ok(Some(_)) =
            map.route(from, to, CAR, &ShortestTime::default(), &mut scratch, &mut steps)
        {
            tell(&steps);
        }
    }
}

pub(super) fn ask(map: Map<'_>) {
    let mut buffer = PathBuffer::default();
    ways(map, |steps| {
        for change in [LaneChange::Jump, LaneChange::Lateral(20.0)] {
            let options = PathOptions { change, ..PathOptions::default() };
            if let Ok(path) = map.path(steps, &options, &mut buffer) {
                along(map, &path, steps);
            }
        }
        requests(map, steps);
    });
}

fn along(map: Map<'_>, path: &Path<'_, '_>, steps: &[RouteStep]) {
    let length = path.length();
    let places = [0.0, 0.3 * length, length];
    for place in places {
        let _ = (path.at(place), path.speed_at(place));
    }
    let _ = path.at_batch(&places, &mut Vec::new());
    let (x, y) = ([3.0, 50.0, 1e4], [1.0, -3.0, 1e5]);
    let mut positions = PathPositions::default();
    let _ = path.project_batch(Places { x: &x, y: &y, ..Places::default() }, &mut positions);
    let _ = path.project(DVec2::new(40.0, 2.0), Some(0.5 * length));
    let (mut conflicts, mut met, mut approaches) = (Vec::new(), Vec::new(), Vec::new());
    path.conflicts(&mut conflicts, &mut met);
    for conflict in conflicts.iter().take(super::FEW) {
        let _ = map.approaches(conflict.lanes_of(&met), 100.0, CAR, &mut approaches);
    }
    path.crossings(&mut Vec::new());
    path.facts(&mut Vec::new());
    path.speeds(&mut Vec::new());
    path.segments(CAR, &mut Vec::new());
    let _ = path.travel_time([0.0, length]);
    let _ = path.steps_between(steps, [0.2 * length, 0.8 * length], &mut Vec::new());
    let (mut scratch, mut again, mut changes) = (RouteScratch::default(), Vec::new(), Vec::new());
    let cost = ShortestLength::default();
    let _ = path.rebase(map, CAR, &cost, &mut scratch, &mut again, &mut changes);
    let mut room = Corridor::default();
    let step = (length / 100.0).max(1.0);
    if path.corridor(0.0, length, step, CAR, &mut room).is_ok() {
        let _ = path.corridor_surface(&mut room);
        for edges in [CorridorEdges::Driven, CorridorEdges::Open] {
            let _ = room.outline(edges, &mut Vec::new());
        }
    }
}

fn requests(map: Map<'_>, steps: &[RouteStep]) {
    let (Some(first), Some(last)) = (steps.first(), steps.last()) else { return };
    let end = |step: &RouteStep, s: f64| RouteEnd::from(PositionOnLane { lane: step.lane, s });
    let (starts, goals) = ([end(first, first.s_from)], [end(last, last.s_to)]);
    let cost = ShortestTime::default();
    let request =
        RouteRequest { starts: &starts, goals: &goals, vehicle: CAR, cost: &cost, avoid: &[] };
    let (mut scratch, mut routes, mut reach) =
        (RouteScratch::default(), Routes::default(), Reach::default());
    for share in [0.0, 0.3] {
        let options = AlternativeOptions { share, ..AlternativeOptions::default() };
        let _ = map.alternatives(&request, &options, &mut scratch, &mut routes);
    }
    let _ = map.find_route(&request, &mut scratch, &mut Vec::new());
    let _ = map.reach(&request, 30.0, &mut scratch, &mut reach);
    let _ = map.reach_to(&request, 30.0, &mut scratch, &mut reach);
    let _ = map.lanes_in(
        Region::around(DVec2::ZERO, 1e3),
        mapd_client::LaneTypes::ALL,
        &mut Vec::new(),
    );
}
