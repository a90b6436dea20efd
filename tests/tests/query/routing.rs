//! Routes cost what plain Dijkstra finds, and drive only where it is allowed.

use mapd_client::{Map, Snapshot};
use mapd_query::SRange;
use mapd_query::graph::LaneNode;
use mapd_query::route::{
    CostBound, Enter, PositionOnLane, Reached, RouteCost, RouteScratch, RouteStep, ShortestLength,
    ShortestTime, WithFactors, WithTurns,
};
use mapd_query::vocabulary::{LaneType, VehicleClass};
use mapd_tests::maps::{Random, open};
use mapd_tests::plain_route::PlainGraph;
use mapd_tests::{carried, say, shared, sumo};

/// Ten maps of the shared corpus: towns, motorways, roundabouts, left-hand traffic.
const MAPS: [&str; 10] = [
    "carla/Town01",
    "carla/Town03",
    "carla/Town05",
    "Scenic/Town10HD",
    "SMARTS/od_newmarket_map",
    "drone_dataset/rdb5",
    "sumo/lefthand_netconvert",
    "sumo/adlershof_dlr_netconvert",
    "esmini/multi_intersections",
    "maliput_malidrive/onramp",
];
/// Pairs of places on each map.
const PAIRS: usize = 1000;
/// Pairs that share a start: the oracle finds the ways to many targets at once.
const PER_START: usize = 25;
/// Costs may differ by rounding of sums.
pub(crate) const ROUNDING: f64 = 1e-6;
/// Metres, and what turns are worth.
const TURNS: WithTurns<ShortestLength> =
    WithTurns { base: ShortestLength { lane_change: 20.0 }, left: 60.0, right: 15.0, back: 300.0 };

/// A caller's own cost: fast roads cost half, changes to the right more than to the left.
struct Own {
    bound: CostBound,
}

impl RouteCost for Own {
    fn pass(&self, node: &LaneNode<'_>) -> f64 {
        let speed = node.length() / node.travel_time().max(1e-3);
        node.length() * if speed > 15.0 { 0.5 } else { 1.0 }
    }

    fn change(&self, from: &LaneNode<'_>, to: &LaneNode<'_>) -> f64 {
        let left = from.left().is_some_and(|left| left.node_id() == to.node_id());
        if left { 5.0 } else { 9.0 }
    }

    fn bound(&self) -> CostBound {
        self.bound
    }
}

/// Starts, each with its targets.
pub(crate) fn places(
    map: Map<'_>,
    vehicle: VehicleClass,
    pairs: usize,
) -> Vec<(PositionOnLane, Vec<PositionOnLane>)> {
    let open: Vec<_> =
        map.lanes().filter(|lane| lane.nodes().any(|node| node.allows(vehicle))).collect();
    let mut random = Random(11);
    let mut place = || {
        let lane = &open[(random.unit() * open.len() as f64) as usize];
        let section = lane.section();
        let s = random.between(section.s_start(), section.s_end());
        PositionOnLane { lane: lane.lane_id(), s }
    };
    if open.is_empty() {
        return Vec::new();
    }
    let starts = 0..pairs.div_ceil(PER_START);
    starts.map(|_| (place(), (0..PER_START).map(|_| place()).collect())).collect()
}

/// Compares every pair with the oracle; returns how many have a way.
fn check(map: Map<'_>, vehicle: VehicleClass, cost: &impl RouteCost, pairs: usize) -> usize {
    let graph = PlainGraph::new(map, vehicle, cost);
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let mut found = 0;
    for (from, targets) in places(map, vehicle, pairs) {
        let expected = graph.costs(map, from, &targets);
        for (to, expected) in targets.into_iter().zip(expected) {
            let route =
                map.route(from, to, vehicle, cost, &mut scratch, &mut steps).expect("an answer");
            let close = match (route, expected) {
                (None, None) => true,
                (Some(route), Some(expected)) => {
                    (route.cost - expected).abs() <= ROUNDING * (1.0 + expected)
                }
                _ => false,
            };
            assert!(close, "{from:?} to {to:?}: {route:?}, expected {expected:?}");
            if let Some(route) = route {
                found += 1;
                check_steps(map, vehicle, (from, to), &steps, route.length);
            }
        }
    }
    found
}

/// A route is driven without a gap, in driving direction, by allowed changes, on lanes open to the vehicle.
pub(crate) fn check_steps(
    map: Map<'_>,
    vehicle: VehicleClass,
    (from, to): (PositionOnLane, PositionOnLane),
    steps: &[RouteStep],
    expected: f64,
) {
    let (first, last) = (steps.first().expect("a start"), steps.last().expect("an end"));
    assert_eq!((first.lane, first.enter, last.lane), (from.lane, Enter::Start, to.lane));
    assert!((first.s_from - from.s).abs() < 1e-9 && (last.s_to - to.s).abs() < 1e-9);
    let mut length = 0.0;
    for (i, step) in steps.iter().enumerate() {
        let lane = map.lane(step.lane).expect("known");
        length += lane.length_between(step.s_from, step.s_to);
        // Pedestrians go either way.
        let walked = matches!(lane.kind(), LaneType::Walking | LaneType::Sidewalk);
        let either = lane.is_bidirectional() || walked;
        assert!(either || lane.is_forward() == step.forward, "{}", lane.key());
        let driven = if step.forward { step.s_to - step.s_from } else { step.s_from - step.s_to };
        assert!(driven >= 0.0, "{} is driven backwards: {step:?}", lane.key());
        let Some(before) = i.checked_sub(1).map(|i| &steps[i]) else { continue };
        let previous = map.lane(before.lane).expect("known");
        assert!(lane.nodes().any(|node| node.allows(vehicle)), "{} is closed", lane.key());
        match step.enter {
            Enter::Start => panic!("starts again"),
            Enter::Ahead => {
                let mut ways = previous.nodes().flat_map(|n| n.edges().collect::<Vec<_>>());
                let leads = ways.any(|edge| {
                    let target = edge.target().expect("a node");
                    target.lane().expect("a lane").lane_id() == step.lane
                        && target.is_forward() == step.forward
                });
                assert!(leads, "{} does not lead into {}", previous.key(), lane.key());
            }
            Enter::Left | Enter::Right => {
                assert_eq!(before.s_to, step.s_from);
                // Somewhere between the first and the last place of the change.
                let middle = 0.5 * (step.s_from + step.s_latest);
                let node = previous.node_at(middle, before.forward).expect("a node");
                let left = step.enter == Enter::Left;
                let change = if left { node.change_left() } else { node.change_right() };
                let to = change.and_then(|node| node.lane()).map(|lane| lane.lane_id());
                assert_eq!(to, Some(step.lane), "no change at {middle} on {}", previous.key());
            }
        }
    }
    assert!((length - expected).abs() < 1e-6 * (1.0 + expected), "{length} is not {expected}");
}

fn check_map(name: &str, snapshot: &Snapshot, pairs: usize) {
    let map = snapshot.map();
    let car = VehicleClass::PassengerCar;
    let found = [
        check(map, car, &ShortestLength::default(), pairs),
        check(map, car, &ShortestTime::default(), pairs / 4),
        check(map, car, &ShortestLength { lane_change: 0.0 }, pairs / 4),
        check(map, car, &Own { bound: CostBound::None }, pairs / 4),
        check(map, car, &TURNS, pairs / 4),
        check(map, car, &Own { bound: CostBound::PerMetre { metre: 0.5, change: 5.0 } }, pairs / 4),
        check(map, VehicleClass::Bicycle, &ShortestLength::default(), pairs / 8),
        check(map, VehicleClass::Pedestrian, &ShortestLength::default(), pairs / 8),
    ];
    assert!(found[0] > 0, "{name}: no way at all");
    say(&format!("{name}: {found:?} ways of {pairs} pairs and shares of them"));
}

#[test]
fn as_plain_dijkstra_on_the_carried_town() {
    check_map("town", &open(&carried("town.xodr")), PAIRS);
}

#[test]
fn as_plain_dijkstra_on_ten_maps() {
    let Some(maps) = shared("maps") else {
        return say("SKIPPED: no shared corpus beside the workspace");
    };
    for name in MAPS {
        check_map(name, &open(&maps.join(format!("{name}.xodr"))), PAIRS);
    }
}

/// The town that the generator makes, of 300 km and more.
#[test]
fn as_plain_dijkstra_on_a_large_town() {
    let text = mapd_tests::town::town(46, 46);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("town.xodr");
    std::fs::write(&path, text).expect("written");
    let snapshot = open(&path);
    assert!(snapshot.map().road_length() > 300e3);
    check_map("town of 46 × 46", &snapshot, PAIRS);
}

/// A network of SUMO's netgenerate with turn lanes, of 299 km and more, where the tools are installed: on the path or in
/// `$SUMO_HOME/bin`.
#[test]
fn as_plain_dijkstra_on_a_network_of_sumo() {
    let folder = tempfile::tempdir().expect("a folder");
    let Some(path) = sumo::grid(folder.path(), 21) else {
        return say("SKIPPED: SUMO's netgenerate and netconvert are not there");
    };
    let snapshot = open(&path);
    assert!(snapshot.map().road_length() > 300e3);
    check_map("grid of SUMO", &snapshot, PAIRS);
}

#[test]
fn reachable_is_what_routes_reach() {
    let snapshot = open(&carried("town.xodr"));
    let map = snapshot.map();
    let car = VehicleClass::PassengerCar;
    let cost = ShortestLength::default();
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let mut reached: Vec<Reached> = Vec::new();
    for (from, _) in places(map, car, 20 * PER_START) {
        let limit = 250.0;
        map.reachable(from, limit, car, &cost, &mut scratch, &mut reached).expect("an answer");
        assert!(reached.is_sorted_by(|a, b| a.cost <= b.cost), "nearest first");
        for lane in map.lanes().filter(|lane| lane.lane_id() != from.lane) {
            let Some(node) = lane.nodes().find(|node| node.allows(car)) else { continue };
            let SRange { low, high } = node.s_range();
            let to = PositionOnLane {
                lane: lane.lane_id(),
                s: if node.is_forward() { low } else { high },
            };
            let route = map.route(from, to, car, &cost, &mut scratch, &mut steps);
            let route = route.expect("an answer").filter(|route| route.cost <= limit);
            let own = reached.iter().find(|reached| reached.node == node.node_id());
            match (route, own) {
                (Some(route), Some(own)) => assert!((route.cost - own.cost).abs() < 1e-6),
                (None, None) => {}
                other => panic!("{}: {other:?}", lane.key()),
            }
        }
    }
}

/// Who can reach a place: compared with the routes from the beginning of every node.
#[test]
fn reachable_to_is_what_routes_come_from() {
    let snapshot = open(&carried("town.xodr"));
    let map = snapshot.map();
    let car = VehicleClass::PassengerCar;
    let cost = ShortestLength::default();
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let mut reached: Vec<Reached> = Vec::new();
    let limit = 250.0;
    for (to, _) in places(map, car, 20 * PER_START) {
        map.reachable_to(to, limit, car, &cost, &mut scratch, &mut reached).expect("an answer");
        assert!(reached.is_sorted_by(|a, b| a.cost <= b.cost), "nearest first");
        for lane in map.lanes() {
            let Some(node) = lane.nodes().find(|node| node.allows(car)) else { continue };
            let SRange { low, high } = node.s_range();
            let s = if node.is_forward() { low } else { high };
            let from = PositionOnLane { lane: lane.lane_id(), s };
            let route = map.route(from, to, car, &cost, &mut scratch, &mut steps);
            let route = route.expect("an answer").filter(|route| route.cost <= limit);
            let own = reached.iter().find(|reached| reached.node == node.node_id());
            match (route, own) {
                (Some(route), Some(own)) => {
                    assert!((route.cost - own.cost).abs() < 1e-6, "{}: {route:?}", lane.key());
                }
                (None, None) => {}
                other => panic!("{}: {other:?}", lane.key()),
            }
        }
    }
}

/// Factors by lane: those of 1 change nothing, an infinite one closes its lane, and what is found is what a search without bounds finds.
#[test]
fn factors_make_lanes_dearer_or_close_them() {
    let snapshot = open(&carried("town.xodr"));
    let map = snapshot.map();
    let car = VehicleClass::PassengerCar;
    let base = ShortestLength::default();
    let (mut scratch, mut steps, mut other) = (RouteScratch::default(), Vec::new(), Vec::new());
    let rows = map.lanes().map(|lane| lane.lane_id().row() as usize + 1).max().expect("lanes");
    let mut closed = 0;
    for (from, targets) in places(map, car, 8 * PER_START) {
        for to in targets {
            let mut find = |factors: &[f64], steps: &mut Vec<RouteStep>| {
                let cost = WithFactors { base, factors };
                map.route(from, to, car, &cost, &mut scratch, steps).expect("an answer")
            };
            let mut factors = vec![1.0; rows];
            let plain = find(&[], &mut steps);
            assert_eq!(find(&factors, &mut other), plain);
            assert_eq!(steps, other);
            let Some(middle) = steps.get(steps.len() / 2).filter(|_| steps.len() > 2) else {
                continue;
            };
            for factor in [3.0, f64::INFINITY, -1.0, f64::NAN, 0.25] {
                factors[middle.lane.row() as usize] = factor;
                let found = find(&factors, &mut other);
                if factor == 3.0 {
                    let (found, plain) = (found.expect("a way"), plain.expect("a way"));
                    assert!(found.cost >= plain.cost - ROUNDING, "{found:?}, {plain:?}");
                } else if factor != 0.25 {
                    assert!(other.iter().all(|step| step.lane != middle.lane), "{factor}");
                    closed += 1;
                }
            }
        }
    }
    assert!(closed > 100, "{closed}");
}
