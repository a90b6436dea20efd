//! Who can reach a place within a cost.

use super::cost::RouteCost;
use super::ends::{lane_of, price, root_of, share_before, target_chain};
use super::scratch::{Open, RouteScratch};
use super::{PositionOnLane, Reached};
use crate::error::QueryError;
use crate::graph::LaneNode;
use crate::ids::NodeId;
use crate::map::Map;
use mapd_archive::VehicleClass;

impl<'a> Map<'a> {
    /// Every node from whose beginning a place can be reached within a cost, nearest first: who can come here. The place's own node
    /// and those beside it come with what is to be driven on them.
    ///
    /// Errors: as [`Map::reachable`].
    pub fn reachable_to(
        &self,
        to: PositionOnLane,
        limit: f64,
        vehicle: VehicleClass,
        cost: &impl RouteCost,
        scratch: &mut RouteScratch,
        out: &mut Vec<Reached>,
    ) -> Result<(), QueryError> {
        out.clear();
        self.lane(to.lane)?;
        if !to.s.is_finite() {
            return Err(QueryError::NotFinite);
        }
        let map = *self;
        let content = map.content();
        scratch.begin(map.tables().lane_nodes.len());
        target_chain(map, to, vehicle, cost, &mut scratch.target);
        let Some((_, s)) = lane_of(map, to) else { return Ok(()) };
        for i in 0..scratch.target.len() {
            let Some(own) = scratch.target.get(i).copied() else { continue };
            // The length counts on the target itself, whichever lane beside it is entered.
            let Some(node) = LaneNode::new(map, own.node) else { continue };
            let root = root_of(&scratch.target, i);
            let target = root.and_then(|root| LaneNode::new(map, root.node));
            let rest = target.map_or(0.0, |t| price(cost.pass(&t)) * share_before(&t, s));
            enter(&node, own.changes + rest, limit, vehicle, scratch);
        }
        while let Some(open) = scratch.heap.pop() {
            if open.key() > scratch.cost(open.node) {
                continue;
            }
            let Some(node) = LaneNode::new(map, open.node) else { continue };
            out.push(Reached { node: NodeId::new(open.node, content), cost: open.key() });
            for before in node.predecessors() {
                enter(&before, open.key() + price(cost.pass(&before)), limit, vehicle, scratch);
            }
            // Beside the target itself, changes may lie beyond it: its chain has those that do not.
            if scratch.target.iter().any(|own| own.node == open.node) {
                continue;
            }
            let sides = [
                node.left().filter(|left| is_way(left.change_right(), &node)),
                node.right().filter(|right| is_way(right.change_left(), &node)),
            ];
            for beside in sides.into_iter().flatten() {
                let changed = open.key() + price(cost.change(&beside, &node));
                enter(&beside, changed, limit, vehicle, scratch);
            }
        }
        Ok(())
    }
}

fn is_way(change: Option<LaneNode<'_>>, to: &LaneNode<'_>) -> bool {
    change.is_some_and(|change| change.number == to.number)
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
