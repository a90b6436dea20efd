//! The search itself: A*, which without bounds is Dijkstra's algorithm.
//!
//! A label's cost reaches to its node's beginning. The start is inside a node: its chain of nodes side by side has no labels
//! of its own, their successors have. The target is inside a node too: a way ends when it enters, from behind, a node of
//! the target's chain; a label that came from the side does not count there, because its change may lie beyond the target.
//! Bounds may shrink by rounding along an edge, so a node is looked at again when a better way to it turns up: what is
//! found is the optimum whenever no bound is too large.

use super::bound::Bounds;
use super::cost::{CostBound, RouteCost};
use super::ends::{price, share_before, start_chain, target_chain};
use super::scratch::{FROM_SIDE, FROM_START, Open, PathNode, RouteScratch};
use super::ways::Ways;
use super::{Enter, PositionOnLane, Route, RouteStep, ends, steps};
use crate::error::QueryError;
use crate::graph::LaneNode;
use mapd_archive::VehicleClass;

pub(super) struct Search<'s, W, C> {
    ways: W,
    vehicle: VehicleClass,
    cost: &'s C,
    scratch: &'s mut RouteScratch,
    best: Option<Best>,
}

/// The best complete way so far.
#[derive(Clone, Copy)]
struct Best {
    cost: f64,
    /// Parent of the entered node as in labels; none where start and target lie on one piece.
    parent: Option<u32>,
    /// Place in the target's chain that is entered, or in the start's chain that reaches the target.
    entered: u32,
}

impl<'a, 's, W: Ways<'a>, C: RouteCost> Search<'s, W, C> {
    pub(super) fn new(
        ways: W,
        vehicle: VehicleClass,
        cost: &'s C,
        scratch: &'s mut RouteScratch,
    ) -> Self {
        scratch.begin(ways.count());
        Self { ways, vehicle, cost, scratch, best: None }
    }

    /// Appends the way's steps; `None` if there is no way.
    pub(super) fn run(
        mut self,
        from: (PositionOnLane, Option<bool>),
        to: PositionOnLane,
        out: &mut Vec<RouteStep>,
    ) -> Result<Option<Route>, QueryError> {
        let map = self.ways.map();
        if self.ways.count() >= FROM_SIDE as usize {
            return Err(QueryError::Corrupt);
        }
        start_chain(self.ways, from, self.vehicle, self.cost, &mut self.scratch.start);
        target_chain(self.ways, to, self.vehicle, self.cost, &mut self.scratch.target);
        let target = self.scratch.target.first().and_then(|t| self.node(t.node));
        let (Some(target), false) = (target, self.scratch.start.is_empty()) else {
            return Ok(None);
        };
        let motor = VehicleClass::MOTOR & self.vehicle.bit() != 0;
        let one_way =
            self.scratch.target.iter().enumerate().filter(|t| ends::is_root(*t)).count() == 1;
        // A target that may be reached in two directions is two nodes: no bound for one holds for both.
        let bounded = motor && one_way && self.ways.has_bounds();
        let bound = if bounded { self.cost.bound() } else { CostBound::None };
        let whole = LaneNode::new(map, target.number).unwrap_or(target);
        let bounds = Bounds::new(map, bound, &whole);
        let (_, s_from) = ends::lane_of(map, from.0).ok_or(QueryError::Corrupt)?;
        let (_, s_to) = ends::lane_of(map, to).ok_or(QueryError::Corrupt)?;
        self.on_one_piece(s_from, s_to);
        self.seed(s_from, s_to, &bounds);
        self.expand(s_to, &bounds);
        Ok(self.best.map(|best| {
            steps::write(self.ways, self.scratch_path(best), s_from, s_to, best.cost, out)
        }))
    }

    fn node(&self, number: u32) -> Option<LaneNode<'a>> {
        self.ways.node(number)
    }

    /// Start and target on pieces beside each other, the target ahead.
    fn on_one_piece(&mut self, s_from: f64, s_to: f64) {
        let scratch = &self.scratch;
        let mut best = self.best;
        for (i, start) in scratch.start.iter().enumerate() {
            let mut targets = scratch.target.iter().enumerate().filter(|t| ends::is_root(*t));
            if !targets.any(|(_, target)| target.node == start.node) {
                continue;
            }
            let Some(node) = self.ways.node(start.node) else { continue };
            let ahead = if node.is_forward() { s_to >= s_from } else { s_to <= s_from };
            if ahead {
                let share = share_before(&node, s_to) - share_before(&node, s_from);
                let cost = start.changes + price(self.cost.pass(&node)) * share.max(0.0);
                if cost.is_finite() && best.is_none_or(|b| cost < b.cost) {
                    best = Some(Best { cost, parent: None, entered: i as u32 });
                }
            }
        }
        self.best = best;
    }

    /// Leaves the start's piece on each lane of its chain.
    fn seed(&mut self, s_from: f64, s_to: f64, bounds: &Bounds<'a>) {
        for i in 0..self.scratch.start.len() {
            let Some(start) = self.scratch.start.get(i).copied() else { continue };
            let Some(node) = self.node(start.node) else { continue };
            let rest = 1.0 - share_before(&node, s_from);
            let cost = start.changes + price(self.cost.pass(&node)) * rest;
            self.leave(start.node, cost, FROM_START | i as u32, s_to, bounds);
        }
    }

    fn expand(&mut self, s_to: f64, bounds: &Bounds<'a>) {
        while let Some(open) = self.scratch.heap.pop() {
            if self.best.is_some_and(|best| open.key() >= best.cost) {
                break;
            }
            let cost = f64::from_bits(open.cost);
            if cost > self.scratch.cost(open.node) {
                continue;
            }
            let Some(node) = self.node(open.node) else { continue };
            let passed = cost + price(self.cost.pass(&node));
            self.leave(open.node, passed, open.node, s_to, bounds);
            for left in [true, false] {
                if let Some(beside) = self.ways.change(open.node, &node, left)
                    && let Some(to) = self.node(beside).filter(|to| to.allows(self.vehicle))
                {
                    let changed = cost + price(self.cost.change(&node, &to));
                    self.enter((beside, &to), changed, FROM_SIDE | open.node, bounds);
                }
            }
        }
    }

    /// Enters all successors of a node that is left at its end.
    #[inline]
    fn leave(&mut self, node: u32, cost: f64, parent: u32, s_to: f64, bounds: &Bounds<'a>) {
        if cost == f64::INFINITY {
            return;
        }
        let ways = self.ways;
        ways.ahead(node, |next| {
            let Some(to) = ways.node(next).filter(|to| to.allows(self.vehicle)) else { return };
            self.finish(next, cost, parent, s_to);
            self.enter((next, &to), cost, parent, bounds);
        });
    }

    /// Ends the way if the node that is entered from behind is beside the target.
    #[inline]
    fn finish(&mut self, entered: u32, cost: f64, parent: u32, s_to: f64) {
        // The target's nodes are few and lie near each other in the archive: most nodes are told apart at once.
        let chain = &self.scratch.target;
        let Some(place) = chain.iter().position(|t| t.node == entered) else { return };
        let Some(own) = chain.get(place).copied() else { return };
        let mut last = place as u32;
        while let Some(link) = chain.get(last as usize).map(|t| t.link).filter(|l| *l != last) {
            last = link;
        }
        let Some(target) = chain.get(last as usize).and_then(|t| self.node(t.node)) else { return };
        let pass = price(self.cost.pass(&target)) * share_before(&target, s_to);
        let whole = cost + own.changes + pass;
        if whole.is_finite() && self.best.is_none_or(|best| whole < best.cost) {
            self.best = Some(Best { cost: whole, parent: Some(parent), entered: place as u32 });
        }
    }

    #[inline]
    fn enter(
        &mut self,
        (number, to): (u32, &LaneNode<'a>),
        cost: f64,
        parent: u32,
        bounds: &Bounds<'a>,
    ) {
        if cost < f64::INFINITY && self.scratch.improve(number, cost, parent) {
            let key = cost + self.ways.least(bounds, to, self.cost);
            self.scratch.heap.push(Open::new(key, cost, number));
        }
    }

    /// The nodes of a way in driving order, with how each is entered.
    fn scratch_path(&mut self, best: Best) -> &[PathNode] {
        let ways = self.ways;
        let scratch = &mut *self.scratch;
        scratch.path.clear();
        let start_of = |scratch: &mut RouteScratch, mut place: u32| {
            while let Some(own) = scratch.start.get(place as usize).copied() {
                let before = scratch.start.get(own.link as usize).filter(|_| own.link != place);
                let enter = match before {
                    Some(before) => side(ways, before.node, own.node),
                    None => Enter::Start,
                };
                scratch.path.push(PathNode { node: own.node, enter });
                if own.link == place {
                    break;
                }
                place = own.link;
            }
        };
        let Some(mut parent) = best.parent else {
            start_of(scratch, best.entered);
            scratch.path.reverse();
            return &scratch.path;
        };
        // Backwards: from the target through its chain to the node that was entered, then by labels.
        let mut place = best.entered;
        let mut tail = 0;
        while let Some(own) = scratch.target.get(place as usize).copied() {
            let enter = if place == best.entered { Enter::Ahead } else { Enter::Left };
            scratch.path.push(PathNode { node: own.node, enter });
            tail += 1;
            if own.link == place {
                break;
            }
            place = own.link;
        }
        for i in 1..tail {
            let (before, own) = (scratch.path[i - 1].node, scratch.path[i].node);
            scratch.path[i].enter = side(ways, before, own);
        }
        scratch.path.reverse();
        // The number of labels bounds the walk, whatever a damaged archive has led to.
        for _ in 0..ways.count() {
            if parent & FROM_START != 0 {
                break;
            }
            let Some(before) = scratch.parent(parent) else { break };
            let from_side = before & (FROM_START | FROM_SIDE) == FROM_SIDE;
            let enter =
                if from_side { side(ways, before & !FROM_SIDE, parent) } else { Enter::Ahead };
            scratch.path.push(PathNode { node: parent, enter });
            parent = if from_side { before & !FROM_SIDE } else { before };
        }
        start_of(scratch, parent & !FROM_START);
        scratch.path.reverse();
        &scratch.path
    }
}

/// The side to which a change from one node to one beside it goes.
fn side<'a>(ways: impl Ways<'a>, from: u32, to: u32) -> Enter {
    match ways.node(from).and_then(|node| ways.beside(from, &node, true)) {
        Some(left) if left == to => Enter::Left,
        _ => Enter::Right,
    }
}
