//! One process that opens an archive and asks a number of queries: `query_probe PATH KIND COUNT`, for counting
//! instructions. Kinds: `nearest` (random over the roads), `trajectory` (in steps of half a metre), `beside` (the same
//! beside the road, in no lane), `turn` (beside tight turns), `hinted` (that with the last answer as a hint), `inertial` and `inertial-trajectory` (s, t to x, y, z), `inertial-batch` (that of 5,000 places along the longest road, as a batch), `route` (the shortest way between random
//! places that have one), `border` (all points of a lane's border), `near` (all lanes within the radius), `near-few` (within a metre), `nearest-few` (the nearest within a metre); of the nearest lane or its road
//! `track` (x, y to s, t), `position`, `contains`, `length` and `short-length` (along the whole longest lane and over a metre of it); `cloud` and `cloud-single` (5,000 particles as a batch, and one by one); `none`.

use mapd_client::batch::{BatchScratch, NearestLanes, Places, Poses, Tracks};
use mapd_client::route::{PositionOnLane, RouteScratch, ShortestLength};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Lane, Map, NearestOptions, Snapshot, Track, glam::DVec2};
use mapd_planner::{PARTICLES, Random, cloud, places};
use std::hint::black_box;
use std::process::ExitCode;

/// Places that are prepared; queries go round them.
const PLACES: usize = 4_096;
/// t of places beside the roads `[m]`.
const BESIDE: f64 = -12.0;
/// Ways that are prepared.
const WAYS: usize = 64;
/// Vehicle that drives them.
const CAR: VehicleClass = VehicleClass::PassengerCar;

/// How far along a tight turn a point beside it lies, as a share of the section: where no stretch ends.
const ALONG_TURN: f64 = 0.4;
/// How far beside the lane it lies `[m]`.
const BESIDE_TURN: f64 = 0.4;
/// Where it then lies, as a share of the way from the reference line to the centre of the turn.
const NEAR_CENTER: [f64; 2] = [0.6, 0.95];

/// Points beside tight turns, on the side of their centres, where lanes may have several feet.
fn beside_turns(map: Map<'_>) -> Vec<DVec2> {
    let beside = |lane: Lane<'_>| {
        let section = lane.section();
        let s = section.s_start() + ALONG_TURN * (section.s_end() - section.s_start());
        let t = lane.edges_at(s).outer + BESIDE_TURN * f64::from(lane.number().signum());
        let pose = lane.road().to_inertial(Track { s, t, h: 0.0 }).ok()?;
        let nearness = lane.road().to_inertial(Track { s, t: 0.0, h: 0.0 }).ok()?.curvature * t;
        let is_near = NEAR_CENTER[0] < nearness && nearness < NEAR_CENTER[1];
        is_near.then(|| pose.position.truncate())
    };
    map.lanes().filter(|lane| lane.number() != 0).filter_map(beside).collect()
}

/// Pairs of places with a way between them.
fn ways(map: Map<'_>, scratch: &mut RouteScratch) -> Vec<[PositionOnLane; 2]> {
    let open = |lane: &Lane<'_>| lane.nodes().any(|node| node.allows(CAR));
    let lanes: Vec<Lane<'_>> = map.lanes().filter(open).collect();
    let (mut random, mut steps) = (Random(3), Vec::new());
    let mut place = || {
        let lane = &lanes[(random.unit() * lanes.len() as f64) as usize];
        let section = lane.section();
        let s = section.s_start() + random.unit() * (section.s_end() - section.s_start());
        PositionOnLane { lane: lane.lane_id(), s }
    };
    let pairs = std::iter::repeat_with(|| [place(), place()]);
    let cost = ShortestLength::default();
    let mut found = |[from, to]: &[PositionOnLane; 2]| {
        map.route(*from, *to, CAR, &cost, scratch, &mut steps).is_ok_and(|route| route.is_some())
    };
    pairs.filter(|pair| found(pair)).take(WAYS).collect()
}

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [path, kind, count] = args.as_slice() else { return ExitCode::from(2) };
    let (Ok(snapshot), Ok(count)) =
        (Snapshot::open(std::path::Path::new(path)), count.parse::<usize>())
    else {
        return ExitCode::from(1);
    };
    let map = snapshot.map();
    let beside = matches!(kind.as_str(), "beside" | "hinted");
    let along = beside || matches!(kind.as_str(), "trajectory" | "inertial-trajectory");
    let mut places = places(map, along, PLACES);
    if beside {
        places.iter_mut().for_each(|(_, _, t)| *t = BESIDE);
    }
    let roads: Vec<_> = map.roads().collect();
    let turns = if kind == "turn" { beside_turns(map) } else { Vec::new() };
    if kind == "turn" && turns.is_empty() {
        return ExitCode::from(1);
    }
    let point = |&(road, s, t): &(u32, f64, f64)| {
        roads[road as usize].to_inertial(Track { s, t, h: 0.0 }).ok().map(|pose| pose.position)
    };
    let points: Vec<DVec2> =
        places.iter().filter_map(|place| Some(point(place)?.truncate())).collect();
    let mut options = NearestOptions::default();
    if kind.ends_with("-few") {
        options.radius = 1.0;
    }
    let mut scratch = RouteScratch::with_capacity(map.lane_nodes().len());
    let ways = if kind == "route" { ways(map, &mut scratch) } else { Vec::new() };
    let lanes: Vec<Lane<'_>> = map.lanes().collect();
    let (mut steps, cost) = (Vec::new(), ShortestLength::default());
    let own = |point: &DVec2| {
        let hit = map.nearest_lane(*point, &NearestOptions::default()).ok().flatten();
        hit.and_then(|hit| map.lane(hit.lane).ok())
    };
    let own: Vec<Option<Lane<'_>>> = points.iter().map(own).collect();
    let uneven = |lane: &&Lane<'_>| lane.center_line().len();
    let Some(longest) = lanes.iter().max_by_key(uneven) else { return ExitCode::from(1) };
    let [low, high] = [longest.section().s_start(), longest.section().s_end()];
    let mut near = Vec::new();
    let particles = cloud(points[0], PARTICLES);
    let (x, y): (Vec<f64>, Vec<f64>) = particles.iter().map(|p| (p.x, p.y)).unzip();
    let (mut scratch_of_batch, mut found) = (BatchScratch::default(), NearestLanes::default());
    let long_road = longest.road();
    let share = |i: usize| long_road.length() * i as f64 / PARTICLES as f64;
    let along_s: Vec<f64> = (0..PARTICLES).map(share).collect();
    let along_t: Vec<f64> = (0..PARTICLES).map(|i| (i % 9) as f64 - 4.0).collect();
    let mut poses = Poses::default();
    for i in 0..count {
        match kind.as_str() {
            "nearest" | "nearest-few" | "trajectory" | "beside" => {
                black_box(map.nearest_lane(points[i % points.len()], &options).ok());
            }
            "turn" => {
                black_box(map.nearest_lane(turns[i % turns.len()], &options).ok());
            }
            "hinted" => {
                let hit = map.nearest_lane(points[i % points.len()], &options);
                options.hint = black_box(hit.ok().flatten());
            }
            "inertial" | "inertial-trajectory" => {
                black_box(point(&places[i % places.len()]));
            }
            "inertial-batch" => {
                let tracks = Tracks { s: &along_s, t: &along_t, h: None };
                black_box(long_road.to_inertial_batch(tracks, &mut poses).ok());
            }
            "route" => {
                // A map may have no ways.
                let Some([from, to]) = ways.get(i % ways.len().max(1)) else { continue };
                black_box(map.route(*from, *to, CAR, &cost, &mut scratch, &mut steps).ok());
            }
            "near" | "near-few" => {
                black_box(map.lanes_near(points[i % points.len()], &options, &mut near).ok());
            }
            "track" | "position" | "contains" => {
                let at = i % points.len();
                let Some(lane) = &own[at] else { continue };
                match kind.as_str() {
                    "track" => {
                        black_box(lane.road().to_track(points[at]).ok());
                    }
                    "position" => {
                        black_box(lane.position_of(points[at]).ok());
                    }
                    _ => {
                        black_box(lane.contains(points[at]).ok());
                    }
                }
            }
            "length" => {
                black_box(longest.length_between(black_box(low), high));
            }
            "short-length" => {
                let middle = low.midpoint(high);
                black_box(longest.length_between(black_box(middle), middle + 1.0));
            }
            "cloud" => {
                let places = Places { x: &x, y: &y, z: None, heading: None };
                black_box(
                    map.nearest_lanes(places, &options, &mut scratch_of_batch, &mut found).ok(),
                );
            }
            "cloud-single" => {
                for point in &particles {
                    black_box(map.nearest_lane(*point, &options).ok());
                }
            }
            "border" => {
                for position in lanes[i % lanes.len()].border().positions() {
                    black_box(position);
                }
            }
            _ => {}
        }
    }
    ExitCode::SUCCESS
}
