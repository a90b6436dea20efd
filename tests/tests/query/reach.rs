//! Requests with several starts and goals, lanes to avoid, headings; and the network of lanes that can be reached.

use crate::routing::{ROUNDING, check_steps, places};
use mapd_client::glam::DVec2;
use mapd_client::{Map, QueryError};
use mapd_query::graph::LaneNode;
use mapd_query::route::{
    Enter, LaneSequences, PositionOnLane, Reach, RouteEnd, RouteError, RouteRequest, RouteScratch,
    ShortestLength, WithFactors,
};
use mapd_query::view::View;
use mapd_query::vocabulary::VehicleClass;
use mapd_query::{LaneId, SRange};
use mapd_tests::maps::{carried_and, found, open};
use mapd_tests::{carried, shared};
use std::collections::BTreeSet;
use std::time::SystemTime;

const CAR: VehicleClass = VehicleClass::PassengerCar;
const LENGTH: ShortestLength = ShortestLength { lane_change: 20.0 };
/// By length, without changes of lane.
const ON_ITS_LANE: ShortestLength = ShortestLength { lane_change: f64::INFINITY };

fn request<'r>(
    starts: &'r [RouteEnd],
    goals: &'r [RouteEnd],
    avoid: &'r [LaneId],
) -> RouteRequest<'r, ShortestLength> {
    RouteRequest { starts, goals, vehicle: CAR, cost: &LENGTH, avoid }
}

/// Of several starts and goals the best pair is found, with what each costs.
#[test]
fn the_best_of_several_starts_and_goals() {
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    for file in carried_and(&["carla/Town05", "sumo/lefthand_netconvert"]) {
        let snapshot = open(&file);
        let map = snapshot.map();
        let mut found = 0;
        for (i, (from, targets)) in places(map, CAR, 250).into_iter().enumerate() {
            let end = |(n, place): (usize, &PositionOnLane)| RouteEnd {
                cost: (n * (i + 3) % 7) as f64 * 15.0,
                ..RouteEnd::from(*place)
            };
            let begins = [&[from], &targets[..2]].concat();
            let starts: Vec<_> = begins.iter().enumerate().map(end).collect();
            let goals: Vec<_> = targets[2..7].iter().enumerate().map(end).collect();
            let mut best = f64::INFINITY;
            for start in &starts {
                for goal in &goals {
                    let route =
                        map.route(start.place, goal.place, CAR, &LENGTH, &mut scratch, &mut steps);
                    let cost = route.expect("an answer").map_or(f64::INFINITY, |r| r.cost);
                    best = best.min(start.cost + cost + goal.cost);
                }
            }
            let route = map.find_route(&request(&starts, &goals, &[]), &mut scratch, &mut steps);
            let route = route.expect("an answer");
            assert_eq!(route.is_some(), best.is_finite());
            let Some(route) = route else { continue };
            assert!((route.cost - best).abs() < ROUNDING * (1.0 + best), "{route:?}, {best}");
            let ends = (starts[route.start].place, goals[route.goal].place);
            check_steps(map, CAR, ends, &steps, route.length);
            // Under no overlay a view is the map.
            let view = View::new(map, None, SystemTime::UNIX_EPOCH).expect("a view");
            let mut other = Vec::new();
            let same = view.find_route(&request(&starts, &goals, &[]), &mut scratch, &mut other);
            assert_eq!((same, other), (Ok(Some(route)), steps.clone()));
            found += 1;
        }
        assert!(found > 3, "{}: {found}", file.display());
    }
}

/// Lanes to avoid are those of an infinite factor; the start may lie on one.
#[test]
fn lanes_to_avoid_are_not_entered() {
    let snapshot = open(&carried("town.xodr"));
    let map = snapshot.map();
    let (mut scratch, mut steps, mut other) = (RouteScratch::default(), Vec::new(), Vec::new());
    let (mut around, mut none) = (0, 0);
    for (from, targets) in places(map, CAR, 200) {
        for to in targets.into_iter().take(5) {
            let (starts, goals) = ([from.into()], [to.into()]);
            let plain = map.find_route(&request(&starts, &goals, &[]), &mut scratch, &mut steps);
            if plain.expect("an answer").is_none() || steps.len() < 3 {
                continue;
            }
            let avoid = [steps[steps.len() / 2].lane, from.lane];
            let ask = request(&starts, &goals, &avoid);
            let found = map.find_route(&ask, &mut scratch, &mut other).expect("an answer");
            assert!(other.iter().skip(1).all(|step| !avoid.contains(&step.lane)), "{other:?}");
            let mut factors = vec![1.0; map.tables().lanes.len()];
            factors[avoid[0].row() as usize] = f64::INFINITY;
            let cost = WithFactors { base: LENGTH, factors: &factors };
            let same = map.route(from, to, CAR, &cost, &mut scratch, &mut steps);
            let same = same.expect("an answer").map(|route| route.cost);
            // A way round over the start's own lane is none, too.
            if same.is_some() && found.is_none() {
                assert!(steps.iter().skip(1).any(|step| step.lane == from.lane));
            } else {
                assert!(found.is_none_or(|f| f.cost >= same.expect("a way") - ROUNDING));
            }
            (around, none) =
                (around + usize::from(found.is_some()), none + usize::from(found.is_none()));
            let gone =
                map.find_route(&request(&starts, &goals, &[to.lane]), &mut scratch, &mut other);
            let gone = gone.expect("an answer");
            assert!(gone.is_none() || from.lane == to.lane, "{gone:?}");
        }
    }
    assert!(around > 20 && none > 0, "{around} ways round, {none} without");
}

/// From pose to pose: headings choose the direction of travel at both ends.
#[test]
fn headings_choose_the_direction() {
    let text = "<OpenDRIVE><header revMajor=\"1\" revMinor=\"8\"/><road id=\"1\" length=\"100\" junction=\"-1\"><planView>\
        <geometry s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"100\"><line/></geometry></planView>\
        <lanes><laneSection s=\"0\"><center><lane id=\"0\" type=\"none\"/></center><right><lane id=\"-1\" type=\"driving\" direction=\"both\">\
        <width sOffset=\"0\" a=\"4\" b=\"0\" c=\"0\" d=\"0\"/></lane></right></laneSection></lanes></road></OpenDRIVE>";
    let snapshot = mapd_tests::maps::open_text(text);
    let map = snapshot.map();
    let pose = |x: f64, heading: f64| {
        RouteEnd::of_pose(map, DVec2::new(x, -2.0), heading, CAR)
            .expect("an answer")
            .expect("a lane")
    };
    let (east, west) = (0.1, std::f64::consts::PI - 0.1);
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    for (start, goal, length) in [
        (pose(10.0, east), pose(60.0, east), Some(50.0)),
        (pose(60.0, west), pose(10.0, west), Some(50.0)),
        (pose(60.0, east), pose(10.0, east), None),
        (pose(10.0, east), pose(60.0, west), None),
        (pose(10.0, west), pose(60.0, east), None),
    ] {
        let (starts, goals) = ([start], [goal]);
        let found = map.find_route(&request(&starts, &goals, &[]), &mut scratch, &mut steps);
        let found = found.expect("an answer").map(|route| route.length);
        let close = found.zip(length).is_none_or(|(a, b)| (a - b).abs() < 1e-6);
        assert!(close && found.is_some() == length.is_some(), "{start:?} to {goal:?}: {found:?}");
    }
    let nowhere = RouteEnd::of_pose(map, DVec2::splat(500.0), 0.0, CAR);
    assert_eq!(nowhere, Ok(None));
    let wrong = RouteEnd::of_pose(map, DVec2::NAN, 0.0, CAR);
    assert_eq!(wrong, Err(QueryError::NotFinite));
}

/// What is wrong is named by its number.
#[test]
fn wrong_ends_are_named() {
    let (snapshot, other) = (open(&carried("town.xodr")), open(&carried("objects.xodr")));
    let map = snapshot.map();
    let lane = map.lanes().next().expect("a lane").lane_id();
    let foreign = other.map().lanes().next().expect("a lane").lane_id();
    let good = RouteEnd::from(PositionOnLane { lane, s: 1.0 });
    let unknown = RouteEnd::from(PositionOnLane { lane, s: f64::NAN });
    let stale = RouteEnd::from(PositionOnLane { lane: foreign, s: 1.0 });
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let mut ask = |starts: &[RouteEnd], goals: &[RouteEnd], avoid: &[LaneId]| {
        map.find_route(&request(starts, goals, avoid), &mut scratch, &mut steps).err()
    };
    let source = QueryError::NotFinite;
    assert_eq!(ask(&[good, unknown], &[good], &[]), Some(RouteError::Start { number: 1, source }));
    assert_eq!(ask(&[good], &[unknown], &[]), Some(RouteError::Goal { number: 0, source }));
    let source = QueryError::ForeignId;
    assert_eq!(ask(&[stale], &[good], &[]), Some(RouteError::Start { number: 0, source }));
    let avoid = [lane, foreign];
    assert_eq!(ask(&[good], &[good], &avoid), Some(RouteError::Avoid { number: 1, source }));
    assert_eq!(ask(&[], &[], &[]), None);
}

/// The network ahead: every node once, with the least cost, its changes of lane, how far the limit lasts, and every way on.
fn check_network(map: Map<'_>, from: PositionOnLane, limit: f64, cost: &ShortestLength) -> usize {
    let (mut scratch, mut out, mut plain) = (RouteScratch::default(), Reach::default(), Vec::new());
    let starts = [from.into()];
    let ask = RouteRequest { starts: &starts, goals: &starts, vehicle: CAR, cost, avoid: &[] };
    map.reach(&ask, limit, &mut scratch, &mut out).expect("an answer");
    map.reachable(from, limit, CAR, cost, &mut scratch, &mut plain).expect("an answer");
    assert_eq!(out.reached(), plain);
    for (number, own) in out.reached().iter().enumerate() {
        let node = map.lane_node(own.node).expect("a node");
        let lane = map.lane(own.lane).expect("a lane");
        let driven = lane.length_between(own.s_from, own.s_to);
        let is_start = own.lane == from.lane && own.s_from == from.s;
        let whole = (driven - node.length()).abs() < 1e-3;
        let cut = (own.cost + driven - limit).abs() < 1e-3;
        let beside = own.s_from == from.s;
        assert!(whole || cut || is_start || beside, "{own:?}: {driven} m of {}", node.length());
        assert!(own.cost + driven <= limit + 1e-3);
        for edge in node.edges().filter_map(|edge| edge.target()) {
            let linked = out.links(number).iter().find(|link| {
                link.enter == Enter::Ahead && out.reached()[link.to].node == edge.node_id()
            });
            let expected = edge.allows(CAR) && own.cost + driven <= limit - 1e-3;
            assert!(!expected || whole == linked.is_some() || beside, "{own:?}");
            if let Some(link) = linked {
                let next = &out.reached()[link.to];
                assert!(next.cost <= own.cost + driven + 1e-3 || !whole, "{own:?}, {next:?}");
            }
        }
        if cost.lane_change == f64::INFINITY {
            assert_eq!(own.lane_changes, 0);
        }
        for link in out.links(number) {
            let changes = u32::from(link.enter != Enter::Ahead);
            let next = &out.reached()[link.to];
            assert!(next.cost <= own.cost + node.length() + 20.0 * f64::from(changes) + 1e-3);
        }
    }
    // Backwards: the search to a place finds what searches from there would reach it.
    let goals = [from.into()];
    let ask = RouteRequest { starts: &goals, goals: &goals, vehicle: CAR, cost, avoid: &[] };
    let mut back = Reach::default();
    map.reach_to(&ask, limit, &mut scratch, &mut back).expect("an answer");
    for (number, own) in back.reached().iter().enumerate() {
        for link in back.links(number) {
            let before = &back.reached()[link.to];
            let node = map.lane_node(before.node).expect("a node");
            let leads = match link.enter {
                Enter::Ahead => {
                    node.edges().any(|e| e.target().is_some_and(|t| t.node_id() == own.node))
                }
                Enter::Left => node.change_left().is_some_and(|to| to.node_id() == own.node),
                _ => node.change_right().is_some_and(|to| to.node_id() == own.node),
            };
            assert!(leads, "{before:?} does not lead to {own:?}");
        }
    }
    out.reached().len()
}

#[test]
fn the_network_ahead_has_every_way_once() {
    for file in carried_and(&["sumo/lefthand_netconvert", "esmini/multi_intersections"]) {
        let snapshot = open(&file);
        let map = snapshot.map();
        for (from, _) in places(map, CAR, 200) {
            for cost in [LENGTH, ON_ITS_LANE] {
                check_network(map, from, 300.0, &cost);
            }
        }
    }
}

/// On a town with many forks all that lies ahead is told, and nothing twice.
#[test]
fn the_network_of_a_town_is_whole() {
    let Some(maps) = shared("maps") else {
        return mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
    };
    let snapshot = open(&maps.join("carla/Town05.xodr"));
    let map = snapshot.map();
    let most = places(map, CAR, 250)
        .into_iter()
        .map(|(from, _)| check_network(map, from, 1_500.0, &ON_ITS_LANE));
    let most = most.max();
    assert!(most > Some(100), "{most:?} nodes");
}

/// Sequences by plain recursion, at most so many; true if these are all.
struct Recursion<'a> {
    vehicle: VehicleClass,
    distance: f64,
    ahead: bool,
    most: usize,
    nodes: Vec<LaneNode<'a>>,
    found: Vec<Vec<LaneId>>,
}

impl<'a> Recursion<'a> {
    fn go(&mut self, node: LaneNode<'a>, length: f64) -> bool {
        self.nodes.push(node);
        let next: Vec<_> = if self.ahead {
            node.edges()
                .filter_map(|edge| edge.target())
                .filter(|to| to.allows(self.vehicle) || self.is_left(&node, to))
                .collect()
        } else {
            let open = |from: &LaneNode<'_>| from.allows(self.vehicle) || self.is_left(from, &node);
            node.predecessors().filter(open).collect()
        };
        let mut all = true;
        if length >= self.distance || next.is_empty() {
            all = self.found.len() < self.most;
            if all {
                let lanes = self.lanes();
                self.found.push(lanes);
            }
        } else {
            for one in next {
                all = all && self.go(one, length + one.length());
            }
        }
        self.nodes.pop();
        all
    }

    /// Whether a closed lane is driven on where the first ends, to be left.
    fn is_left(&self, first: &LaneNode<'_>, second: &LaneNode<'_>) -> bool {
        let id = |node: &LaneNode<'_>| node.lane().expect("a lane").lane_id();
        let [end, begin] = match first.is_forward() {
            true => [first.s_range().high, second.s_range().low],
            false => [first.s_range().low, second.s_range().high],
        };
        let is_next = id(first) == id(second) && end == begin;
        let is_open = [first, second].iter().any(|node| node.allows(self.vehicle));
        is_next && first.is_forward() == second.is_forward() && !is_open
    }

    /// Lanes of the nodes; one that goes on where the node before ends, in the same direction, is the same lane.
    fn lanes(&self) -> Vec<LaneId> {
        let ends = |node: &LaneNode<'_>| {
            let SRange { low, high } = node.s_range();
            if node.is_forward() == self.ahead { [low, high] } else { [high, low] }
        };
        let id = |node: &LaneNode<'_>| node.lane().expect("a lane").lane_id();
        let mut lanes: Vec<LaneId> = Vec::new();
        for (i, node) in self.nodes.iter().enumerate() {
            let before = i.checked_sub(1).map(|before| &self.nodes[before]);
            let is_same = before.is_some_and(|before| {
                id(before) == id(node)
                    && before.is_forward() == node.is_forward()
                    && ends(before)[1] == ends(node)[0]
            });
            if !is_same {
                lanes.push(id(node));
            }
        }
        lanes
    }
}

/// Compares the sequences from a place with those of plain recursion; how many there are, and whether these are all.
fn check_sequences(
    map: Map<'_>,
    from: PositionOnLane,
    vehicle: VehicleClass,
    (distance, ahead, most): (f64, bool, usize),
    scratch: &mut RouteScratch,
    sequences: &mut LaneSequences,
) -> (usize, bool) {
    if ahead {
        map.lane_sequences_ahead(from, distance, vehicle, scratch, sequences).expect("an answer");
    } else {
        map.lane_sequences_behind(from, distance, vehicle, scratch, sequences).expect("an answer");
    }
    let mut plain =
        Recursion { vehicle, distance, ahead, most, nodes: Vec::new(), found: Vec::new() };
    let lane = map.lane(from.lane).expect("a lane");
    let mut all = true;
    for way in [true, false] {
        let Some(node) = lane.node_at(from.s, way) else { continue };
        let SRange { low, high } = node.s_range();
        let end = if node.is_forward() == ahead { high } else { low };
        all = all && plain.go(node, lane.length_between(from.s, end));
    }
    let (mut count, mut seen) = (0, BTreeSet::new());
    while let Some(lanes) = sequences.next_sequence() {
        if count == plain.found.len() {
            assert!(!all, "more than {count}");
            break;
        }
        assert_eq!(lanes, plain.found[count], "number {count}");
        seen.extend(lanes.iter().copied());
        count += 1;
    }
    assert_eq!(count, plain.found.len());
    let network: BTreeSet<_> = sequences.network().reached().iter().map(|own| own.lane).collect();
    assert!(if all { seen == network } else { seen.is_subset(&network) });
    (count, all)
}

#[test]
fn sequences_are_those_of_plain_recursion() {
    let (mut scratch, mut sequences) = (RouteScratch::default(), LaneSequences::default());
    for file in carried_and(&["sumo/lefthand_netconvert", "esmini/multi_intersections"]) {
        let snapshot = open(&file);
        let map = snapshot.map();
        for (from, _) in places(map, CAR, 200) {
            // Lanes on which cars drive are closed to people on foot, but for the first.
            for vehicle in [CAR, VehicleClass::Pedestrian] {
                for ahead in [true, false] {
                    let (limits, out) = ((250.0, ahead, 5_000), &mut sequences);
                    let (count, _) = check_sequences(map, from, vehicle, limits, &mut scratch, out);
                    assert!(count > 0);
                }
            }
        }
    }
}

/// Six hundred metres ahead on Town04: every sequence is told, also where there are more than a list would hold.
#[test]
fn sequences_of_town04_are_complete() {
    let Some(town) = found("maps/Town04.xodr") else { return };
    const AHEAD: f64 = 600.0;
    let snapshot = open(&town);
    let map = snapshot.map();
    let (mut scratch, mut network) = (RouteScratch::default(), Reach::default());
    let mut sequences = LaneSequences::default();
    let (mut most, mut pieces, mut cut) = (0, 0, 0);
    for (from, _) in places(map, CAR, 400) {
        let limits = (AHEAD, true, 100_000);
        let (count, all) = check_sequences(map, from, CAR, limits, &mut scratch, &mut sequences);
        (most, cut) = (most.max(count), cut + usize::from(!all));
        pieces = pieces.max(sequences.network().reached().len());
        let starts = [RouteEnd::from(from)];
        let cost = ON_ITS_LANE;
        let goals = [];
        let request =
            RouteRequest { starts: &starts, goals: &goals, vehicle: CAR, cost: &cost, avoid: &[] };
        map.reach(&request, AHEAD, &mut scratch, &mut network).expect("an answer");
        let (own, other) = (sequences.network(), &network);
        assert_eq!(own.reached().len(), other.reached().len());
        for (number, one) in own.reached().iter().enumerate() {
            let same = other.reached().iter().position(|o| {
                (o.node, o.s_from) == (one.node, one.s_from) && (o.cost - one.cost).abs() < 1e-3
            });
            let same = same.unwrap_or_else(|| panic!("{one:?} is not reached"));
            assert!((one.s_to - other.reached()[same].s_to).abs() < 1e-3, "{one:?}");
            let lane = map.lane(one.lane).expect("a lane");
            let end = one.cost + lane.length_between(one.s_from, one.s_to);
            if end < AHEAD - 1e-3 {
                assert_eq!(own.links(number).len(), other.links(same).len(), "{one:?}");
            }
        }
        let limits = (AHEAD, false, 20_000);
        check_sequences(map, from, CAR, limits, &mut scratch, &mut sequences);
    }
    mapd_tests::say(&format!(
        "at most {most} sequences over {pieces} pieces of lanes; {cut} places with more"
    ));
    assert!(most > 1_024 && pieces > 20, "{most} sequences over {pieces} pieces");
}
