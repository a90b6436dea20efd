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
    ahead: Vec<usize>,
    /// Changes of lane with their cost.
    beside: Vec<(usize, f64)>,
    open: bool,
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
            ahead: node.edges().filter_map(|edge| edge.target()).map(row).collect(),
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
        let share = |node: usize, s: f64| {
            let SRange { low, high } = all[node].s_range();
            let lane = all[node].lane().expect("a lane");
            let share = lane.length_between(low, s) / lane.length_between(low, high);
            // max takes the number where the other is none: a lane without length.
            let share = if share > 1.0 { 1.0 } else { share.max(0.0) };
            if all[node].is_forward() { share } else { 1.0 - share }
        };
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

    fn leave(
        &self,
        node: usize,
        cost: f64,
        best: &mut [f64],
        behind: &mut [f64],
        open: &mut BinaryHeap<Reverse<(u64, usize)>>,
    ) {
        for to in self.nodes[node].ahead.iter().filter(|to| self.nodes[**to].open) {
            behind[*to] = behind[*to].min(cost);
            improve(*to, cost, best, open);
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
