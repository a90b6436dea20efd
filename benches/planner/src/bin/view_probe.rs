//! One process that asks a map, or a view over it, a number of questions: `view_probe MAP OVERLAY KIND COUNT`, for counting instructions. OVERLAY is the
//! bytes of an overlay, or `-` for a view without one. Kinds: `speed`, `allows`, `match` (the lanes of a pose), `route` and `find-route` (the fastest way between random
//! places that have one), `reachable` (within a time), each also with `map-` before it, of the map itself; `today-route` asks only for routes that there are under the overlay, so that
//! they are the same on a map with the same written into it; `open-route` for these between open lanes, and `factors-route` has the map search these with what the overlay says of whole
//! lanes as factors of them.

use mapd_archive::AlignedBytes;
use mapd_client::localisation::{MatchOptions, VehiclePose};
use mapd_client::route::{
    PositionOnLane, RouteCost, RouteEnd, RouteRequest, RouteScratch, ShortestTime, WithFactors,
};
use mapd_client::view::View;
use mapd_client::vocabulary::{LaneType, VehicleClass};
use mapd_client::{Lane, LaneId, Map, Point, Snapshot, glam::DMat3};
use mapd_planner::Random;
use std::hint::black_box;
use std::path::Path;
use std::process::ExitCode;
use std::time::UNIX_EPOCH;

/// Places that are prepared; questions go round them.
const PLACES: usize = 4_096;
/// Ways that are prepared.
const PAIRS: usize = 64;
/// How far questions of what can be reached go `[s]`.
const WITHIN: f64 = 60.0;
/// Vehicle that drives them.
const CAR: VehicleClass = VehicleClass::PassengerCar;

/// Places on lanes for traffic, closed or not: the same with closures written into the map.
fn places(map: Map<'_>) -> Vec<(LaneId, f64)> {
    let driven = |lane: &Lane<'_>| lane.kind() == LaneType::Driving;
    let lanes: Vec<Lane<'_>> = map.lanes().filter(driven).collect();
    let mut random = Random(3);
    let mut place = || {
        let lane = &lanes[(random.unit() * lanes.len() as f64) as usize];
        let section = lane.section();
        let s = section.s_start() + random.unit() * (section.s_end() - section.s_start());
        (lane.lane_id(), s)
    };
    (0..PLACES).map(|_| place()).collect()
}

/// Pairs of places with a route between them, on the map itself or under the overlay.
fn routes(view: View<'_>, places: &[(LaneId, f64)], today: bool) -> Vec<[PositionOnLane; 2]> {
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let place = |(lane, s): (LaneId, f64)| PositionOnLane { lane, s };
    let all = places.chunks_exact(2).map(|pair| [place(pair[0]), place(pair[1])]);
    let cost = ShortestTime::default();
    let mut found = |[from, to]: &[PositionOnLane; 2]| {
        let route = match today {
            true => view.route(*from, *to, CAR, &cost, &mut scratch, &mut steps),
            false => view.map().route(*from, *to, CAR, &cost, &mut scratch, &mut steps),
        };
        route.is_ok_and(|route| route.is_some())
    };
    all.filter(|pair| found(pair)).take(PAIRS).collect()
}

/// Those that begin and end on open lanes and have a route under an overlay, too. A view lets a vehicle leave a closed lane, and knows at once that a goal is closed; a
/// search with factors does neither. None where their costs differ by more than a thousandth.
fn still_open(
    view: View<'_>,
    factors: &impl RouteCost,
    pairs: Vec<[PositionOnLane; 2]>,
) -> Option<Vec<[PositionOnLane; 2]>> {
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let cost = ShortestTime::default();
    let open = |place: &PositionOnLane| {
        view.allows(place.lane, place.s, CAR).is_ok_and(|answer| answer.is_allowed)
    };
    let mut found = Vec::new();
    for pair in pairs.into_iter().filter(|pair| pair.iter().all(open)) {
        let [from, to] = pair;
        let today = view.route(from, to, CAR, &cost, &mut scratch, &mut steps).ok()?;
        let own = view.map().route(from, to, CAR, factors, &mut scratch, &mut steps).ok()?;
        match (today, own) {
            (Some(today), Some(own)) if (today.cost - own.cost).abs() < 1e-3 * own.cost => {
                found.push(pair);
            }
            (None, None) => {}
            _ => return None,
        }
    }
    Some(found)
}

/// What an overlay says of whole lanes, as factors of the map's own times: what closes a lane or slows it without a view.
fn factors(view: View<'_>) -> Vec<f64> {
    let factor = |lane: Lane<'_>| {
        let section = lane.section();
        let middle = 0.5 * (section.s_start() + section.s_end());
        let time = lane.nodes().find(|node| node.is_forward() == lane.is_forward())?.travel_time();
        let today = view.speed_rule_at(lane.lane_id(), middle, CAR).ok()?;
        let slower = today.restriction.and(today.max).map_or(1.0, |max| {
            lane.length_between(section.s_start(), section.s_end()) / max / time
        });
        let closes = view.allows(lane.lane_id(), middle, CAR).ok()?.restriction.is_some();
        Some(if closes { f64::INFINITY } else { slower })
    };
    let mut factors = Vec::new();
    for lane in view.map().lanes() {
        // Between them lie the rows of lanes 0.
        factors.resize(lane.lane_id().row() as usize, 1.0);
        factors.push(factor(lane).unwrap_or(1.0));
    }
    factors
}

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [path, overlay, kind, count] = args.as_slice() else { return ExitCode::from(2) };
    let (Ok(mut snapshot), Ok(count)) = (Snapshot::open(Path::new(path)), count.parse::<usize>())
    else {
        return ExitCode::from(1);
    };
    if overlay != "-" {
        let bytes = std::fs::read(overlay).unwrap_or_default();
        let mut aligned = AlignedBytes::with_capacity(bytes.len());
        aligned.extend_from_slice(&bytes);
        let Ok(under) = snapshot.with_overlay(aligned) else { return ExitCode::from(1) };
        snapshot = under;
    }
    let map = snapshot.map();
    let view = snapshot.view(UNIX_EPOCH);
    let places = places(map);
    let middle = |&(lane, s): &(LaneId, f64)| {
        let pose = map.lane(lane).ok()?.pose_at(s, 0.0).ok()?;
        let position = Point::from(pose.position.truncate());
        Some(VehiclePose { position, heading: pose.heading })
    };
    let poses: Vec<VehiclePose> = places.iter().filter_map(middle).collect();
    let pairs = match kind.ends_with("route") {
        true => routes(view, &places, kind == "today-route"),
        false => Vec::new(),
    };
    let cost = ShortestTime::default();
    let options = MatchOptions { vehicle: Some(CAR), ..MatchOptions::default() };
    let (mut matches, mut reached) = (Vec::new(), Vec::new());
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let is_compared = matches!(kind.as_str(), "open-route" | "factors-route");
    let factors = if is_compared { factors(view) } else { Vec::new() };
    let factors = WithFactors { base: cost, factors: &factors };
    let pairs = if is_compared { still_open(view, &factors, pairs) } else { Some(pairs) };
    let Some(pairs) = pairs else { return ExitCode::from(3) };
    for i in 0..count {
        let (lane, s) = places[i % places.len()];
        match kind.as_str() {
            "map-speed" => {
                black_box(&map.lane(lane).map(|lane| lane.speed_rule_at(s)));
            }
            "speed" => {
                black_box(&view.speed_rule_at(lane, s, CAR));
            }
            "map-allows" => {
                black_box(&map.lane(lane).map(|lane| lane.allows_at(s, CAR)));
            }
            "allows" => {
                black_box(&view.allows(lane, s, CAR));
            }
            "map-match" => {
                let pose = &poses[i % poses.len()];
                black_box(&map.match_pose(pose, &DMat3::IDENTITY, &options, &mut matches).ok());
            }
            "match" => {
                let pose = &poses[i % poses.len()];
                black_box(&view.match_pose(pose, &DMat3::IDENTITY, &options, &mut matches).ok());
            }
            "map-reachable" | "reachable" => {
                let from = PositionOnLane { lane, s };
                let out = &mut reached;
                let found = match kind.as_str() {
                    "reachable" => view.reachable(from, WITHIN, CAR, &cost, &mut scratch, out),
                    _ => map.reachable(from, WITHIN, CAR, &cost, &mut scratch, out),
                };
                black_box(&found);
            }
            "map-find-route" | "find-route" => {
                let [starts, goals] = pairs[i % pairs.len()].map(|place| [RouteEnd::from(place)]);
                let (starts, goals) = (&starts[..], &goals[..]);
                let request = RouteRequest { starts, goals, vehicle: CAR, cost: &cost, avoid: &[] };
                let found = match kind.as_str() {
                    "find-route" => view.find_route(&request, &mut scratch, &mut steps),
                    _ => map.find_route(&request, &mut scratch, &mut steps),
                };
                black_box(&found);
            }
            "map-route" => {
                let [from, to] = pairs[i % pairs.len()];
                black_box(&map.route(from, to, CAR, &cost, &mut scratch, &mut steps));
            }
            "factors-route" => {
                let [from, to] = pairs[i % pairs.len()];
                black_box(&map.route(from, to, CAR, &factors, &mut scratch, &mut steps));
            }
            "route" | "open-route" | "today-route" => {
                let [from, to] = pairs[i % pairs.len()];
                black_box(&view.route(from, to, CAR, &cost, &mut scratch, &mut steps));
            }
            _ => return ExitCode::from(2),
        }
    }
    ExitCode::SUCCESS
}
