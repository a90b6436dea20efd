//! Routes and successors on a connected network of 200,000 lanes and on Town05, against `pathfinding` over the same
//! compressed rows and the crate `xodr`, in one run.
//!
//! The network is SUMO's where netgenerate and netconvert are installed (on the path or in `$SUMO_HOME/bin`), else the
//! town that the project's own generator makes.

use mapd_benches::{Random, maps, percentiles, print};
use mapd_client::compiling::ByRow as _;
use mapd_client::route::{PositionOnLane, RouteScratch, ShortestLength, ShortestTime};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Map, Snapshot};
use mapd_compiler::{CompileOptions, compile};
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Routes of each kind.
const ROUTES: usize = 300;
/// The slow peers get fewer.
const PEER_ROUTES: usize = 60;
/// Ways shorter than this `[m]` are short.
const SHORT: f64 = 2000.0;
/// A short way goes at most so many lanes along a long one.
const SHORT_STEPS: usize = 40;
/// Largest file that the crate `xodr` is asked to load.
const PEER_BYTES: u64 = 20_000_000;
/// Lanes that stay in the caches.
const FEW: usize = 64;
/// Lane queries timed together: a single one is far below the clock's resolution.
const BATCH: usize = 1000;

fn open(path: &Path, landmarks: u8) -> (Snapshot, Duration) {
    let start = Instant::now();
    let file = std::fs::File::open(path).expect("the map opens");
    let options = CompileOptions { landmarks, ..CompileOptions::default() };
    let compiled = compile(file, &options, &mut |_| {}).expect("reading works");
    let time = start.elapsed();
    let rows = compiled.rows.expect("accepted");
    let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
    (Snapshot::from_bytes(archive).expect("opens"), time)
}

/// A network of about 200,000 lanes.
fn network(folder: &Path) -> (&'static str, PathBuf) {
    if let Some(map) = mapd_tests::sumo::grid(folder, 64) {
        return ("grid of SUMO", map);
    }
    print("SUMO is not there; the generated town stands in");
    let path = folder.join("town.xodr");
    std::fs::write(&path, mapd_tests::town::town(100, 100)).expect("written");
    ("town of 100 × 100", path)
}

/// Pairs of places with a way between them, and its length.
fn pairs(map: Map<'_>) -> Vec<(PositionOnLane, PositionOnLane, f64)> {
    let car = VehicleClass::PassengerCar;
    let lanes: Vec<_> =
        map.lanes().filter(|lane| lane.nodes().any(|node| node.allows(car))).collect();
    let mut random = Random(3);
    let mut place = || {
        let lane = &lanes[(random.unit() * lanes.len() as f64) as usize];
        let section = lane.section();
        let s = section.s_start() + random.unit() * (section.s_end() - section.s_start());
        PositionOnLane { lane: lane.lane_id(), s }
    };
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let mut out = Vec::new();
    let cost = ShortestLength::default();
    while out.len() < ROUTES {
        let (from, to) = (place(), place());
        let route = map.route(from, to, car, &cost, &mut scratch, &mut steps).expect("an answer");
        if let Some(route) = route {
            out.push((from, to, route.length));
            // And a short one: to a lane on the way.
            let at = steps.len().min(SHORT_STEPS).saturating_sub(1);
            if let Some(step) = steps.get(at) {
                let to = PositionOnLane { lane: step.lane, s: 0.5 * (step.s_from + step.s_to) };
                let short = map.route(from, to, car, &cost, &mut scratch, &mut steps);
                let short = short.expect("an answer").map_or(f64::INFINITY, |route| route.length);
                if short < SHORT {
                    out.push((from, to, short));
                }
            }
        }
    }
    out
}

fn time_routes(
    map: Map<'_>,
    pairs: &[(PositionOnLane, PositionOnLane)],
    by_time: bool,
) -> (Duration, Duration) {
    let mut scratch = RouteScratch::with_capacity(map.lane_nodes().len());
    let (mut steps, car) = (Vec::with_capacity(4096), VehicleClass::PassengerCar);
    let times = pairs.iter().map(|(from, to)| {
        let start = Instant::now();
        let route = if by_time {
            map.route(*from, *to, car, &ShortestTime::default(), &mut scratch, &mut steps)
        } else {
            map.route(*from, *to, car, &ShortestLength::default(), &mut scratch, &mut steps)
        };
        black_box(route.expect("an answer"));
        start.elapsed()
    });
    percentiles(times.collect())
}

/// `pathfinding` over the archive's own rows, through closures: Dijkstra, and A* with the straight line as bound.
fn time_peer(map: Map<'_>, pairs: &[(PositionOnLane, PositionOnLane)]) -> (Duration, Duration) {
    let tables = map.tables();
    let change = ShortestLength::default().lane_change;
    // Costs in millimetres: the crate wants an order.
    let millimetres = |metres: f64| (metres * 1000.0) as u64;
    let middle = |node: u32| {
        let lane = map.lane_by_row(tables.lane_nodes[node as usize].lane()).expect("a lane");
        lane.center_line().position(0).expect("a point").truncate()
    };
    let positions: Vec<_> = (0..tables.lane_nodes.len() as u32).map(middle).collect();
    let next = |node: &u32| {
        let row = &tables.lane_nodes[*node as usize];
        let at = tables.successor_offsets[*node as usize] as usize
            ..tables.successor_offsets[*node as usize + 1] as usize;
        let pass = millimetres(row.length().into());
        let ahead = tables.successors[at].iter().map(move |to| (*to, pass));
        let beside =
            [row.left(), row.right()].map(|beside| mapd_archive::beside_row(*node, beside));
        let sides = [(2, beside[0]), (4, beside[1])];
        let beside = sides.into_iter().filter(move |(flag, _)| row.flags() & flag != 0);
        ahead.chain(beside.map(move |(_, to)| (to, millimetres(change)))).collect::<Vec<_>>()
    };
    let node = |place: &PositionOnLane| {
        let lane = map.lane(place.lane).expect("known");
        let node = lane.node_at(place.s, lane.is_forward()).expect("a node");
        node.node_id().row()
    };
    let mut times = (Vec::new(), Vec::new());
    for (from, to) in pairs.iter().take(PEER_ROUTES) {
        let (from, to) = (node(from), node(to));
        let start = Instant::now();
        black_box(pathfinding::prelude::dijkstra(&from, next, |node| *node == to));
        times.0.push(start.elapsed());
        let target = positions[to as usize];
        let bound = |node: &u32| {
            // A lane may be as long as the way from its first point is off its ends: half of the straight line is safe.
            millimetres(0.5 * (positions[*node as usize] - target).length())
        };
        let start = Instant::now();
        black_box(pathfinding::prelude::astar(&from, next, bound, |node| *node == to));
        times.1.push(start.elapsed());
    }
    (percentiles(times.0).0, percentiles(times.1).0)
}

/// `route` of the crate `xodr` between the same points; it also projects both and samples what it finds.
fn time_xodr(
    map: Map<'_>,
    path: &Path,
    pairs: &[(PositionOnLane, PositionOnLane)],
) -> Option<Duration> {
    let net = xodr::load_file(path).ok()?;
    let point = |place: &PositionOnLane| {
        let pose = map.lane(place.lane).expect("known").pose_at(place.s, 0.0).expect("a pose");
        let p = pose.position;
        xodr::Point::new(p.x as f32, p.y as f32, p.z as f32)
    };
    let times = pairs.iter().take(PEER_ROUTES).map(|(from, to)| {
        let (from, to) = (point(from), point(to));
        let start = Instant::now();
        black_box(net.route(from, to));
        start.elapsed()
    });
    Some(percentiles(times.collect()).0)
}

/// Time of a lane's successors: of lanes all over the map, or of a few again and again.
fn time_successors(map: Map<'_>, few: Option<usize>) -> Duration {
    let lanes: Vec<_> = map.lanes().take(few.unwrap_or(usize::MAX)).collect();
    let mut random = Random(9);
    let picks: Vec<_> =
        (0..200 * BATCH).map(|_| lanes[(random.unit() * lanes.len() as f64) as usize]).collect();
    let times = picks.chunks_exact(BATCH).map(|batch| {
        let start = Instant::now();
        for lane in batch {
            black_box(lane.successors().next());
        }
        start.elapsed()
    });
    percentiles(times.collect()).0 / BATCH as u32
}

fn measure(name: &str, path: &Path) {
    let (plain, without) = open(path, 0);
    let (snapshot, with) = open(path, CompileOptions::default().landmarks);
    let map = snapshot.map();
    let lanes = map.lanes().count();
    let bytes = (snapshot.bytes().len() - plain.bytes().len()) as f64 / lanes as f64;
    print(&format!(
        "{name}: {lanes} lanes, {} nodes, {} edges, {:.0} km; compiled in {without:.2?}, with {} landmarks in {with:.2?}, which take {bytes:.0} bytes per lane",
        map.lane_nodes().len(),
        map.tables().successors.len(),
        map.road_length() / 1000.0,
        CompileOptions::default().landmarks,
    ));
    let pairs = pairs(map);
    for (kind, is) in [
        ("under 2 km", (|length: f64| length < SHORT) as fn(f64) -> bool),
        ("longer", |length| length >= SHORT),
    ] {
        let few: Vec<_> = pairs.iter().filter(|p| is(p.2)).map(|p| (p.0, p.1)).collect();
        if few.is_empty() {
            continue;
        }
        let mean = pairs.iter().filter(|p| is(p.2)).map(|p| p.2).sum::<f64>() / few.len() as f64;
        let (length, length99) = time_routes(map, &few, false);
        let (time, time99) = time_routes(map, &few, true);
        let (dijkstra, _) = time_routes(plain.map(), &translated(map, plain.map(), &few), false);
        let (peer_dijkstra, peer_astar) = time_peer(map, &few);
        let ratio = |other: Duration| other.as_secs_f64() / length.as_secs_f64();
        print(&format!(
            "{kind} ({} routes, {:.1} km on average): by length p50 {length:.1?} p99 {length99:.1?}, by time p50 {time:.1?} p99 {time99:.1?}; without landmarks p50 {dijkstra:.1?} ({:.1} ×); pathfinding: dijkstra p50 {peer_dijkstra:.1?} ({:.1} ×), astar p50 {peer_astar:.1?} ({:.1} ×)",
            few.len(),
            mean / 1000.0,
            ratio(dijkstra),
            ratio(peer_dijkstra),
            ratio(peer_astar),
        ));
    }
    if std::fs::metadata(path).is_ok_and(|file| file.len() < PEER_BYTES) {
        let all: Vec<_> = pairs.iter().map(|p| (p.0, p.1)).collect();
        let (own, _) = time_routes(map, &all, false);
        if let Some(peer) = time_xodr(map, path, &all) {
            let ratio = peer.as_secs_f64() / own.as_secs_f64();
            print(&format!("all: p50 {own:.1?}; xodr route p50 {peer:.1?} ({ratio:.1} ×)"));
        }
    }
    print(&format!(
        "successors: {:.1?} each, lanes all over the map {:.1?}",
        time_successors(map, Some(FEW)),
        time_successors(map, None)
    ));
}

/// The same places in another archive of the same map.
fn translated(
    from: Map<'_>,
    to: Map<'_>,
    pairs: &[(PositionOnLane, PositionOnLane)],
) -> Vec<(PositionOnLane, PositionOnLane)> {
    let place = |place: &PositionOnLane| {
        let key = from.lane(place.lane).expect("known").key();
        PositionOnLane { lane: to.lane_by_key(&key).expect("a lane").lane_id(), s: place.s }
    };
    pairs.iter().map(|(a, b)| (place(a), place(b))).collect()
}

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    let (name, path) = network(folder.path());
    measure(name, &path);
    for (name, path) in maps(folder.path()).into_iter().take(1) {
        measure(name, &path);
    }
}
