//! What can be reached within a cost.

use super::LanePlace;
use super::cost::RouteCost;
use super::ends::{lane_of, price, share_before, start_chain};
use super::scratch::{Open, RouteScratch};
use crate::error::QueryError;
use crate::graph::LaneNode;
use crate::ids::NodeId;
use crate::lane::edges_of;
use crate::map::Map;
use mapd_archive::VehicleClass;

/// A node that can be reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// The node.
    pub node: NodeId,
    /// Least cost up to its beginning; of the nodes beside the start, of the lane changes to them.
    pub cost: f64,
}

impl<'a> Map<'a> {
    /// Every node whose beginning can be reached within a cost, nearest first; the start's own node and those beside it come
    /// first of all.
    ///
    /// Errors: ids of another map; an s that is no finite number.
    pub fn reachable(
        &self,
        from: LanePlace,
        limit: f64,
        vehicle: VehicleClass,
        cost: &impl RouteCost,
        scratch: &mut RouteScratch,
        out: &mut Vec<Reached>,
    ) -> Result<(), QueryError> {
        out.clear();
        self.lane(from.lane)?;
        if !from.s.is_finite() {
            return Err(QueryError::NotFinite);
        }
        let map = *self;
        let content = map.content();
        scratch.begin(map.tables().lane_nodes.len());
        start_chain(map, (from, None), vehicle, cost, &mut scratch.start);
        let Some((_, s)) = lane_of(map, from) else { return Ok(()) };
        for i in 0..scratch.start.len() {
            let Some(start) = scratch.start.get(i).copied() else { continue };
            let Some(node) = LaneNode::new(map, start.node) else { continue };
            if start.changes > limit {
                continue;
            }
            out.push(Reached { node: NodeId { row: start.node, content }, cost: start.changes });
            let passed = start.changes + price(cost.pass(&node)) * (1.0 - share_before(&node, s));
            ahead(map, &node, passed, limit, vehicle, scratch);
        }
        while let Some(open) = scratch.heap.pop() {
            if open.key() > scratch.cost(open.node) {
                continue;
            }
            let Some(node) = LaneNode::new(map, open.node) else { continue };
            out.push(Reached { node: NodeId { row: open.node, content }, cost: open.key() });
            ahead(map, &node, open.key() + price(cost.pass(&node)), limit, vehicle, scratch);
            for to in [node.change_left(), node.change_right()].into_iter().flatten() {
                enter(&to, open.key() + price(cost.change(&node, &to)), limit, vehicle, scratch);
            }
        }
        Ok(())
    }
}

fn ahead(
    map: Map<'_>,
    node: &LaneNode<'_>,
    passed: f64,
    limit: f64,
    vehicle: VehicleClass,
    scratch: &mut RouteScratch,
) {
    let tables = map.tables();
    for next in edges_of(tables.successor_offsets, tables.successors, node.number) {
        if let Some(to) = LaneNode::new(map, *next) {
            enter(&to, passed, limit, vehicle, scratch);
        }
    }
}

fn enter(
    to: &LaneNode<'_>,
    cost: f64,
    limit: f64,
    vehicle: VehicleClass,
    scratch: &mut RouteScratch,
) {
    if cost <= limit && to.allows(vehicle) && scratch.improve(to.number, cost, 0) {
        scratch.heap.push(Open::new(cost, cost, to.number));
    }
}
