//! What motor vehicles may use of the lane graph, and what it costs.

use super::csr;
use mapd_archive::{LaneNodeRow, NONE, Rows, VehicleClass, beside_row, node_flags};

/// What a change of lane counts `[m]`: as routing counts it by default.
pub(super) const CHANGE_LENGTH: f32 = 20.0;
/// What a change of lane counts `[s]`: as routing counts it by default.
pub(super) const CHANGE_TIME: f32 = 2.0;

/// What an edge costs.
#[derive(Clone, Copy)]
pub(super) struct Weight {
    pub(super) length: f32,
    pub(super) time: f32,
}

/// Nodes that motor vehicles may use: each has a place, ascending with the nodes.
pub(super) struct Places {
    /// By node its place; [`NONE`] where no motor vehicle may go.
    pub(super) of_nodes: Vec<u32>,
    /// Number of places.
    pub(super) count: usize,
}

impl Places {
    pub(super) fn of(rows: &Rows) -> Self {
        let mut count = 0;
        let place = |node: &LaneNodeRow| {
            if node.access & VehicleClass::MOTOR == 0 {
                return NONE;
            }
            count += 1;
            count - 1
        };
        let of_nodes = rows.lane_nodes.iter().map(place).collect();
        Self { of_nodes, count: count as usize }
    }

    pub(super) fn get(&self, node: u32) -> u32 {
        self.of_nodes.get(node as usize).copied().unwrap_or(NONE)
    }

    /// By place its rank in an order that depends on names only.
    pub(super) fn ranks(&self, rows: &Rows) -> Vec<u32> {
        let of_nodes = self.of_nodes.iter().zip(csr::ranks(rows));
        of_nodes.filter(|(place, _)| **place != NONE).map(|(_, rank)| rank).collect()
    }
}

/// An edge between places.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    pub(super) from: u32,
    pub(super) to: u32,
    pub(super) weight: Weight,
}

impl Edge {
    pub(super) fn turned(self) -> Self {
        Self { from: self.to, to: self.from, ..self }
    }
}

/// All edges between places, by the node that is left.
pub(super) fn edges(rows: &Rows, places: &Places) -> Vec<Edge> {
    let mut edges = Vec::with_capacity(rows.successors.len());
    for (number, (node, own)) in rows.lane_nodes.iter().zip(&places.of_nodes).enumerate() {
        if *own == NONE {
            continue;
        }
        let at = |i: usize| rows.successor_offsets.get(i).copied().unwrap_or(0) as usize;
        let ahead = rows.successors.get(at(number)..at(number + 1)).unwrap_or(&[]);
        let pass = Weight { length: node.length, time: node.time };
        let change = Weight { length: CHANGE_LENGTH, time: CHANGE_TIME };
        let beside_it = [node.left, node.right].map(|beside| beside_row(number as u32, beside));
        let sides = [node_flags::CHANGE_LEFT, node_flags::CHANGE_RIGHT].into_iter().zip(beside_it);
        let beside = sides.filter(|(flag, _)| node.flags & flag != 0);
        let all = ahead.iter().map(|to| (*to, pass)).chain(beside.map(|(_, to)| (to, change)));
        let usable = all.map(|(to, weight)| Edge { from: *own, to: places.get(to), weight });
        edges.extend(usable.filter(|edge| edge.to != NONE));
    }
    edges
}

/// Edges as compressed sparse rows.
pub(super) struct Sparse {
    offsets: Vec<u32>,
    /// Place that is entered, and the cost.
    pub(super) targets: Vec<(u32, Weight)>,
}

impl Sparse {
    pub(super) fn of(edges: impl Iterator<Item = Edge> + Clone, count: usize) -> Self {
        let offsets = csr::offsets(count, edges.clone().map(|edge| edge.from));
        let none = (NONE, Weight { length: 0.0, time: 0.0 });
        let mut targets = vec![none; offsets[count] as usize];
        let mut next = offsets.clone();
        for edge in edges {
            let at = &mut next[edge.from as usize];
            targets[*at as usize] = (edge.to, edge.weight);
            *at += 1;
        }
        Self { offsets, targets }
    }

    /// Number of places.
    pub(super) fn places(&self) -> usize {
        self.offsets.len() - 1
    }

    /// The edges that leave a place.
    pub(super) fn leaving(&self, place: u32) -> &[(u32, Weight)] {
        let at = place as usize;
        &self.targets[self.offsets[at] as usize..self.offsets[at + 1] as usize]
    }
}
