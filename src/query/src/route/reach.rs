//! What can be reached within a cost.

use super::PositionOnLane;
use super::cost::RouteCost;
use super::ends::{lane_of, price, share_before, start_chain};
use super::scratch::{Open, RouteScratch};
use super::ways::Ways;
use crate::error::QueryError;
use crate::ids::NodeId;
use crate::map::Map;
use mapd_archive::VehicleClass;

/// A node that can be reached.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Reached {
    /// The node.
    pub node: NodeId,
    /// Least cost between its beginning and the place that was asked for; of nodes beside the start, of the lane changes to them.
    pub cost: f64,
}

impl<'a> Map<'a> {
    /// Every node whose beginning can be reached within a cost, nearest first; the start's own node and those beside it come
    /// first of all.
    ///
    /// Errors: ids of another map; an s that is no finite number.
    pub fn reachable(
        &self,
        from: PositionOnLane,
        limit: f64,
        vehicle: VehicleClass,
        cost: &impl RouteCost,
        scratch: &mut RouteScratch,
        out: &mut Vec<Reached>,
    ) -> Result<(), QueryError> {
        out.clear();
        let content = self.content();
        reach(*self, from, (limit, vehicle), cost, scratch, |row, cost| {
            out.push(Reached { node: NodeId::new(row, content), cost });
        })
    }
}

/// Tells of everything whose beginning can be reached within a limit, nearest first.
///
/// Errors: as [`Map::reachable`].
pub(crate) fn reach<'a>(
    ways: impl Ways<'a>,
    from: PositionOnLane,
    (limit, vehicle): (f64, VehicleClass),
    cost: &impl RouteCost,
    scratch: &mut RouteScratch,
    mut found: impl FnMut(u32, f64),
) -> Result<(), QueryError> {
    ways.map().lane(from.lane)?;
    if !from.s.is_finite() {
        return Err(QueryError::NotFinite);
    }
    scratch.begin(ways.count());
    start_chain(ways, (from, None), vehicle, cost, &mut scratch.start);
    let Some((_, s)) = lane_of(ways.map(), from) else { return Ok(()) };
    let enter = |scratch: &mut RouteScratch, number: u32, cost: f64| {
        let is_open = cost <= limit && ways.node(number).is_some_and(|to| to.allows(vehicle));
        if is_open && scratch.improve(number, cost, 0) {
            scratch.heap.push(Open::new(cost, cost, number));
        }
    };
    for i in 0..scratch.start.len() {
        let Some(start) = scratch.start.get(i).copied() else { continue };
        let Some(node) = ways.node(start.node) else { continue };
        if start.changes > limit {
            continue;
        }
        found(start.node, start.changes);
        let passed = start.changes + price(cost.pass(&node)) * (1.0 - share_before(&node, s));
        ways.ahead(start.node, |next| enter(scratch, next, passed));
    }
    while let Some(open) = scratch.heap.pop() {
        if open.key() > scratch.cost(open.node) {
            continue;
        }
        let Some(node) = ways.node(open.node) else { continue };
        found(open.node, open.key());
        let passed = open.key() + price(cost.pass(&node));
        ways.ahead(open.node, |next| enter(scratch, next, passed));
        for left in [true, false] {
            let Some(beside) = ways.change(open.node, &node, left) else { continue };
            let Some(to) = ways.node(beside) else { continue };
            enter(scratch, beside, open.key() + price(cost.change(&node, &to)));
        }
    }
    Ok(())
}
