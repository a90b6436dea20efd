//! Dijkstra's algorithm over states written out in full, as the oracle of routing.

use mapd_query::Map;
use mapd_query::SRange;
use mapd_query::graph::LaneNode;
use mapd_query::route::{PositionOnLane, RouteCost};
use mapd_query::vocabulary::VehicleClass;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// What a node costs and where it leads.
struct Node {
    pass: f64,
    /// What follows, with what it costs to go on there.
    ahead: Vec<(usize, f64)>,
    /// Changes of lane with their cost.
    beside: Vec<(usize, f64)>,
    open: bool,
}

/// Costs as whole numbers have so many to one.
const UNITS: f64 = 1e9;

/// A state of a way that is looked for: nodes beside the start, on the way, and beside the goal are different ones.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum State {
    Source,
    Start(usize),
    Node(usize),
    Goal(usize),
    End,
}

/// A map's graph for one class of vehicles and one cost.
pub struct PlainGraph {
    nodes: Vec<Node>,
}

impl PlainGraph {
    /// Reads the whole graph.
    pub fn new(map: Map<'_>, vehicle: VehicleClass, cost: &impl RouteCost) -> Self {
        let row = |node: LaneNode<'_>| node.node_id().row() as usize;
        let read = |node: LaneNode<'_>| Node {
            pass: cost.pass(&node),
            ahead: node
                .edges()
                .filter_map(|edge| edge.target())
                .map(|to| (row(to), cost.enter(&node, &to)))
                .collect(),
            beside: [node.change_left(), node.change_right()]
                .into_iter()
                .flatten()
                .map(|to| (row(to), cost.change(&node, &to)))
                .collect(),
            open: node.allows(vehicle),
        };
        Self { nodes: map.lane_nodes().map(read).collect() }
    }

    /// Costs of the cheapest ways from one place to each of several; `None` where there is none.
    pub fn costs(
        &self,
        map: Map<'_>,
        from: PositionOnLane,
        to: &[PositionOnLane],
    ) -> Vec<Option<f64>> {
        let all: Vec<LaneNode<'_>> = map.lane_nodes().collect();
        let share = |node: usize, s: f64| share(&all[node], s);
        let beside_start = self.beside(at(map, from).map(|node| (node, 0.0)).collect());
        // Cheapest ways to each node's beginning: from anywhere, and from behind only.
        let mut best = vec![f64::INFINITY; self.nodes.len()];
        let mut behind = vec![f64::INFINITY; self.nodes.len()];
        let mut open = BinaryHeap::new();
        for (start, cost) in &beside_start {
            let left = cost + self.nodes[*start].pass * (1.0 - share(*start, from.s));
            self.leave(*start, left, &mut best, &mut behind, &mut open);
        }
        while let Some(Reverse((bits, node))) = open.pop() {
            let cost = f64::from_bits(bits);
            if cost > best[node] {
                continue;
            }
            let own = &self.nodes[node];
            for (to, change) in own.beside.iter().filter(|(to, _)| self.nodes[*to].open) {
                improve(*to, cost + change, &mut best, &mut open);
            }
            self.leave(node, cost + own.pass, &mut best, &mut behind, &mut open);
        }
        to.iter()
            .map(|place| {
                let mut found = f64::INFINITY;
                for target in at(map, *place).filter(|target| self.nodes[*target].open) {
                    let pass = self.nodes[target].pass;
                    for (node, cost) in beside_start.iter().filter(|(node, _)| *node == target) {
                        let left = share(*node, place.s) - share(*node, from.s);
                        if left >= -1e-12 {
                            found = found.min(cost + pass * left.max(0.0));
                        }
                    }
                    let section = all[target].lane().expect("a lane").section();
                    let nodes = section.lanes().flat_map(|l| l.nodes().collect::<Vec<_>>());
                    let piece = nodes.filter(|node| {
                        node.s_range() == all[target].s_range()
                            && node.is_forward() == all[target].is_forward()
                    });
                    let entered = piece.map(|node| node.node_id().row() as usize);
                    let arrived = self.beside(entered.map(|node| (node, behind[node])).collect());
                    for (_, cost) in arrived.iter().filter(|(node, _)| *node == target) {
                        found = found.min(cost + pass * share(target, place.s));
                    }
                }
                found.is_finite().then_some(found)
            })
            .collect()
    }

    /// Costs of the k best ways from a place to another, by Yen's algorithm of another library over the same states.
    pub fn best_costs(
        &self,
        map: Map<'_>,
        (from, to): (PositionOnLane, PositionOnLane),
        count: usize,
    ) -> Vec<f64> {
        let all: Vec<LaneNode<'_>> = map.lane_nodes().collect();
        let share = |node: usize, s: f64| share(&all[node], s);
        let targets: Vec<usize> = at(map, to).filter(|node| self.nodes[*node].open).collect();
        let group: Vec<usize> = targets.iter().flat_map(|t| self.leads_to(*t)).collect();
        // Costs as whole numbers, as that library has it.
        let cost = |cost: f64| (cost * UNITS).round() as u64;
        let successors = |state: &State| -> Vec<(State, u64)> {
            let beside =
                |node: usize| self.nodes[node].beside.iter().filter(|(to, _)| self.nodes[*to].open);
            let leave = |node: usize, passed: f64| {
                let ahead = self.nodes[node].ahead.iter().filter(|(to, _)| self.nodes[*to].open);
                ahead.flat_map(move |(to, enter)| {
                    [(State::Node(*to), passed + enter), (State::Goal(*to), passed + enter)]
                })
            };
            let mut out: Vec<(State, f64)> = Vec::new();
            match *state {
                State::Source => out.extend(at(map, from).map(|node| (State::Start(node), 0.0))),
                State::Start(node) => {
                    out.extend(leave(node, self.nodes[node].pass * (1.0 - share(node, from.s))));
                    out.extend(beside(node).map(|(to, change)| (State::Start(*to), *change)));
                    let left = share(node, to.s) - share(node, from.s);
                    if targets.contains(&node) && left >= 0.0 {
                        out.push((State::End, self.nodes[node].pass * left));
                    }
                }
                State::Node(node) => {
                    out.extend(leave(node, self.nodes[node].pass));
                    out.extend(beside(node).map(|(to, change)| (State::Node(*to), *change)));
                }
                State::Goal(node) => {
                    out.extend(beside(node).map(|(to, change)| (State::Goal(*to), *change)));
                    if targets.contains(&node) {
                        out.push((State::End, self.nodes[node].pass * share(node, to.s)));
                    }
                }
                State::End => {}
            }
            let known =
                |state: &State| !matches!(state, State::Goal(node) if !group.contains(node));
            out.into_iter()
                .filter(|(state, _)| known(state))
                .map(|(state, c)| (state, cost(c)))
                .collect()
        };
        let found = pathfinding::directed::yen::yen(
            &State::Source,
            successors,
            |state| *state == State::End,
            count,
        );
        found.into_iter().map(|(_, cost)| cost as f64 / UNITS).collect()
    }

    /// Nodes from which changes of lane lead to a node, itself first.
    fn leads_to(&self, target: usize) -> Vec<usize> {
        let mut found = vec![target];
        let mut done = 0;
        while done < found.len() {
            let to = found[done];
            done += 1;
            let from = (0..self.nodes.len()).filter(|from| {
                let own = &self.nodes[*from];
                own.open && own.beside.iter().any(|(beside, _)| *beside == to)
            });
            let new: Vec<usize> = from.filter(|from| !found.contains(from)).collect();
            found.extend(new);
        }
        found
    }

    fn leave(
        &self,
        node: usize,
        cost: f64,
        best: &mut [f64],
        behind: &mut [f64],
        open: &mut BinaryHeap<Reverse<(u64, usize)>>,
    ) {
        for (to, enter) in self.nodes[node].ahead.iter().filter(|(to, _)| self.nodes[*to].open) {
            behind[*to] = behind[*to].min(cost + enter);
            improve(*to, cost + enter, best, open);
        }
    }

    /// Spreads costs over lane changes until nothing gets cheaper (Bellman and Ford).
    fn beside(&self, mut costs: Vec<(usize, f64)>) -> Vec<(usize, f64)> {
        loop {
            let mut better = None;
            for (node, cost) in &costs {
                for (to, change) in &self.nodes[*node].beside {
                    let there = cost + change;
                    let known = costs.iter().any(|(other, cost)| other == to && *cost <= there);
                    if self.nodes[*to].open && !known && there.is_finite() {
                        better = Some((*to, there));
                    }
                }
            }
            let Some((node, cost)) = better else { return costs };
            costs.retain(|(other, _)| *other != node);
            costs.push((node, cost));
        }
    }
}

/// Share of a node's length before s.
fn share(node: &LaneNode<'_>, s: f64) -> f64 {
    let SRange { low, high } = node.s_range();
    let lane = node.lane().expect("a lane");
    let share = lane.length_between(low, s) / lane.length_between(low, high);
    // max takes the number where the other is none: a lane without length.
    let share = if share > 1.0 { 1.0 } else { share.max(0.0) };
    if node.is_forward() { share } else { 1.0 - share }
}

/// Nodes at a place, one for each direction of travel.
fn at(map: Map<'_>, place: PositionOnLane) -> impl Iterator<Item = usize> {
    let lane = map.lane(place.lane).expect("known");
    let ways = [true, false].into_iter().filter_map(move |way| lane.node_at(place.s, way));
    ways.map(|node| node.node_id().row() as usize).collect::<Vec<_>>().into_iter()
}

fn improve(node: usize, cost: f64, best: &mut [f64], open: &mut BinaryHeap<Reverse<(u64, usize)>>) {
    if cost < best[node] {
        best[node] = cost;
        open.push(Reverse((cost.to_bits(), node)));
    }
}
