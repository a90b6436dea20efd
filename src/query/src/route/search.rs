//! The search itself: A*, which without bounds is Dijkstra's algorithm.
//!
//! A label's cost reaches to its node's beginning. The start is inside a node: its chain of nodes side by side has no labels
//! of its own, their successors have. The target is inside a node too: a way ends when it enters, from behind, a node of
//! the target's chain; a label that came from the side does not count there, because its change may lie beyond the target.
//! Bounds may shrink by rounding along an edge, so a node is looked at again when a better way to it turns up: what is
//! found is the optimum whenever no bound is too large.
//!
//! A way is a list of hops: from the start's chain into a node, from node to node, and at last into the goal's chain.

use super::bound::Bounds;
use super::cost::{CostBound, RouteCost};
use super::ends::{price, share_before, start_chain, target_chain};
use super::scratch::{DIRECT, FROM_SIDE, FROM_START, GOAL, Hop, Open, PathNode, RouteScratch};
use super::ways::Ways;
use super::{Enter, Route, RouteEnd, RouteStep, ends, steps};
use crate::error::QueryError;
use crate::graph::LaneNode;
use mapd_archive::VehicleClass;
use std::ops::Range;

pub(super) struct Search<'s, W, C> {
    pub(super) ways: W,
    pub(super) vehicle: VehicleClass,
    pub(super) cost: &'s C,
    pub(super) scratch: &'s mut RouteScratch,
    pub(super) best: Option<Best>,
    /// Ways that cost as much are not looked for.
    pub(super) cutoff: f64,
}

/// The best complete way so far.
#[derive(Clone, Copy)]
pub(super) struct Best {
    pub(super) cost: f64,
    /// Its last hop.
    pub(super) last: Hop,
}

impl<'a, 's, W: Ways<'a>, C: RouteCost> Search<'s, W, C> {
    pub(super) fn new(
        ways: W,
        vehicle: VehicleClass,
        cost: &'s C,
        scratch: &'s mut RouteScratch,
    ) -> Self {
        scratch.begin(ways.count());
        Self { ways, vehicle, cost, scratch, best: None, cutoff: f64::INFINITY }
    }

    /// The best way's steps, appended; `None` if there is no way.
    pub(super) fn run(
        mut self,
        ends: [&[RouteEnd]; 2],
        out: &mut Vec<RouteStep>,
    ) -> Result<Option<Route>, QueryError> {
        let Some(bounds) = self.place(ends)? else { return Ok(None) };
        self.find(&bounds);
        let Some(best) = self.best else { return Ok(None) };
        let hops = self.trace(best, None);
        Ok(Some(self.write(hops, best.cost, out)))
    }

    /// Notes starts and goals, and bounds towards these; `None` where no way can begin or end.
    pub(super) fn place(
        &mut self,
        [starts, goals]: [&[RouteEnd]; 2],
    ) -> Result<Option<Bounds<'a>>, QueryError> {
        if self.ways.count() >= FROM_SIDE as usize {
            return Err(QueryError::Corrupt);
        }
        let (ways, vehicle, cost) = (self.ways, self.vehicle, self.cost);
        start_chain(ways, starts, vehicle, cost, &mut self.scratch.start);
        target_chain(ways, goals, vehicle, cost, &mut self.scratch.target);
        self.scratch.note_goals();
        let target = self.scratch.target.first().and_then(|t| ways.node(t.node));
        let (Some(target), false) = (target, self.scratch.start.is_empty()) else {
            return Ok(None);
        };
        let motor = VehicleClass::MOTOR & vehicle.bit() != 0;
        let roots = self.scratch.target.iter().enumerate().filter(|t| ends::is_root(*t));
        // A bound for one goal, or one direction in which it may be reached, does not hold for another.
        let bounded = motor && roots.count() == 1 && ways.has_bounds();
        let bound = if bounded { cost.bound() } else { CostBound::None };
        let map = ways.map();
        let whole = LaneNode::new(map, target.number).unwrap_or(target);
        Ok(Some(Bounds::new(map, bound, &whole)))
    }

    /// Looks for the best way.
    pub(super) fn find(&mut self, bounds: &Bounds<'a>) {
        self.on_one_piece(&[]);
        self.seed(bounds, &[]);
        self.expand(bounds, 0.0);
    }

    /// Ways that cost as much are not better.
    #[inline]
    fn most(&self) -> f64 {
        self.best.map_or(self.cutoff, |best| best.cost)
    }

    /// Start and target on pieces beside each other, the target ahead.
    pub(super) fn on_one_piece(&mut self, banned: &[Hop]) {
        for (i, start) in self.scratch.start.iter().enumerate() {
            let roots = self.scratch.target.iter().enumerate().filter(|t| ends::is_root(*t));
            for (place, target) in roots.filter(|(_, target)| target.node == start.node) {
                let Some(node) = self.ways.node(start.node) else { continue };
                let [from, to] = [start.s, target.s];
                if if node.is_forward() { to < from } else { to > from } {
                    continue;
                }
                let share = share_before(&node, to) - share_before(&node, from);
                let drive = price(self.cost.pass(&node)) * share.max(0.0);
                let cost = start.changes + drive + target.changes;
                let last = Hop { from: FROM_START | i as u32, to: DIRECT | place as u32 };
                if cost < self.best.map_or(self.cutoff, |best| best.cost) && !banned.contains(&last)
                {
                    self.best = Some(Best { cost, last });
                }
            }
        }
    }

    /// Leaves the start's piece on each lane of its chain.
    pub(super) fn seed(&mut self, bounds: &Bounds<'a>, banned: &[Hop]) {
        for i in 0..self.scratch.start.len() {
            let Some(start) = self.scratch.start.get(i).copied() else { continue };
            let Some(node) = self.ways.node(start.node) else { continue };
            let cost = start.changes + start.pass;
            self.leave(start.node, &node, cost, FROM_START | i as u32, bounds, banned);
        }
    }

    /// Goes on until no better way is left; looks at all that costs less than a limit, whatever is found.
    pub(super) fn expand(&mut self, bounds: &Bounds<'a>, limit: f64) {
        while let Some(open) = self.scratch.heap.pop() {
            if open.key() >= self.most().max(limit) {
                // A search that goes on from here needs it.
                self.scratch.heap.push(open);
                break;
            }
            let cost = f64::from_bits(open.cost);
            if cost > self.scratch.cost(open.node) {
                continue;
            }
            self.expand_node(open.node, cost, bounds, &[]);
        }
    }

    /// Leaves a node at its end and to its sides.
    #[inline]
    pub(super) fn expand_node(
        &mut self,
        number: u32,
        cost: f64,
        bounds: &Bounds<'a>,
        banned: &[Hop],
    ) {
        let Some(node) = self.ways.node(number) else { return };
        let passed = cost + price(self.cost.pass(&node));
        self.leave(number, &node, passed, number, bounds, banned);
        for left in [true, false] {
            if let Some(beside) = self.ways.change(number, &node, left)
                && let Some(to) = self.ways.node(beside).filter(|to| to.allows(self.vehicle))
            {
                let changed = cost + price(self.cost.change(&node, &to));
                let hop = Hop { from: FROM_SIDE | number, to: beside };
                self.enter(hop, &to, changed, bounds, banned);
            }
        }
    }

    /// Enters all successors of a node that is left at its end.
    #[inline]
    fn leave(
        &mut self,
        number: u32,
        node: &LaneNode<'a>,
        cost: f64,
        from: u32,
        bounds: &Bounds<'a>,
        banned: &[Hop],
    ) {
        if cost == f64::INFINITY {
            return;
        }
        let ways = self.ways;
        ways.ahead(number, |next| {
            let Some(to) = ways.node(next) else { return };
            if !to.allows(self.vehicle) {
                if node.allows(self.vehicle) {
                    return;
                }
                return self.stay(number, Hop { from, to: next }, cost, banned);
            }
            let entered = cost + price(self.cost.enter(node, &to));
            if self.scratch.is_goal(next) {
                self.finish(next, entered, from, banned);
            }
            self.enter(Hop { from, to: next }, &to, entered, bounds, banned);
        });
    }

    /// Goes on to the end of a closed lane on which the start is. Landmarks need not know of closed lanes, so no bound counts.
    #[cold]
    fn stay(&mut self, number: u32, hop: Hop, cost: f64, banned: &[Hop]) {
        let Some((node, to)) = self.ways.node(number).zip(self.ways.node(hop.to)) else { return };
        let entered = cost + price(self.cost.enter(&node, &to));
        if entered == f64::INFINITY || !node.stays_on_closed(&to, self.vehicle) {
            return;
        }
        if self.scratch.is_goal(hop.to) {
            self.finish(hop.to, entered, hop.from, banned);
        }
        if !banned.contains(&hop) && self.scratch.improve(hop.to, entered, hop.from) {
            self.scratch.heap.push(Open::new(entered, entered, hop.to));
        }
    }

    /// Ends the way as the node that is entered from behind is beside the target.
    #[inline]
    fn finish(&mut self, entered: u32, cost: f64, from: u32, banned: &[Hop]) {
        let most = self.cutoff;
        for (place, own) in self.scratch.target.iter().enumerate() {
            let whole = cost + own.changes + own.pass;
            let last = Hop { from, to: GOAL | place as u32 };
            if own.node == entered
                && whole < self.best.map_or(most, |best| best.cost)
                && !banned.contains(&last)
            {
                self.best = Some(Best { cost: whole, last });
            }
        }
    }

    #[inline]
    fn enter(
        &mut self,
        hop: Hop,
        to: &LaneNode<'a>,
        cost: f64,
        bounds: &Bounds<'a>,
        banned: &[Hop],
    ) {
        let is_open = cost < f64::INFINITY && (banned.is_empty() || !banned.contains(&hop));
        if is_open && self.scratch.improve(hop.to, cost, hop.from) {
            let key = cost + self.ways.least(bounds, to);
            self.scratch.heap.push(Open::new(key, cost, hop.to));
        }
    }

    /// Appends the hops of a way to those of the scratch, from the start, or from the node at which it leaves another; returns which.
    pub(super) fn trace(&mut self, best: Best, spur: Option<u32>) -> Range<usize> {
        let scratch = &mut *self.scratch;
        let first = scratch.hops.len();
        scratch.hops.push(best.last);
        let mut at = best.last.from;
        // The number of labels bounds the walk, whatever a damaged archive has led to.
        for _ in 0..self.ways.count() {
            if at & FROM_START != 0 || Some(at) == spur {
                break;
            }
            let Some(from) = scratch.parent(at) else { break };
            scratch.hops.push(Hop { from, to: at });
            at = node_of(from);
        }
        scratch.hops[first..].reverse();
        first..scratch.hops.len()
    }

    /// What a hop adds to the cost at the beginning of the node that it leaves, in the order in which a search adds it.
    pub(super) fn after(&self, cost: f64, hop: Hop) -> f64 {
        let Some(to) = self.ways.node(hop.to) else { return f64::INFINITY };
        let start = self.scratch.start.get((hop.from & !FROM_START) as usize);
        if let Some(start) = start.filter(|_| hop.from & FROM_START != 0) {
            let Some(from) = self.ways.node(start.node) else { return f64::INFINITY };
            return start.changes + start.pass + price(self.cost.enter(&from, &to));
        }
        let Some(from) = self.ways.node(node_of(hop.from)) else { return f64::INFINITY };
        match hop.from & FROM_SIDE {
            0 => cost + price(self.cost.pass(&from)) + price(self.cost.enter(&from, &to)),
            _ => cost + price(self.cost.change(&from, &to)),
        }
    }

    /// Appends the steps of a way, given by its hops.
    pub(super) fn write(
        &mut self,
        hops: Range<usize>,
        cost: f64,
        out: &mut Vec<RouteStep>,
    ) -> Route {
        let ways = self.ways;
        let RouteScratch { path, start, target, hops: all, .. } = &mut *self.scratch;
        path.clear();
        let hops = all.get(hops).unwrap_or(&[]);
        let (Some(first), Some(last)) = (hops.first(), hops.last()) else {
            return Route::default();
        };
        let mut place = first.from & !FROM_START;
        while let Some(own) = start.get(place as usize) {
            let before = start.get(own.link as usize).filter(|_| own.link != place);
            let enter = before.map_or(Enter::Start, |before| side(ways, before.node, own.node));
            path.push(PathNode { node: own.node, enter });
            if own.link == place {
                break;
            }
            place = own.link;
        }
        path.reverse();
        let begin = start.get((first.from & !FROM_START) as usize);
        for hop in hops.iter().filter(|hop| hop.to & GOAL == 0) {
            let is_side = hop.from & (FROM_START | FROM_SIDE) == FROM_SIDE;
            let enter = if is_side { side(ways, node_of(hop.from), hop.to) } else { Enter::Ahead };
            path.push(PathNode { node: hop.to, enter });
        }
        let mut place = last.to & !DIRECT;
        let end = target.get(place as usize);
        let mut before = None;
        while let Some(own) = target.get(place as usize).filter(|_| last.to & DIRECT != DIRECT) {
            let enter = before.map_or(Enter::Ahead, |before| side(ways, before, own.node));
            path.push(PathNode { node: own.node, enter });
            if own.link == place {
                break;
            }
            (before, place) = (Some(own.node), own.link);
        }
        let (Some(begin), Some(end)) = (begin, end) else { return Route::default() };
        let ends = Route { start: begin.end as usize, goal: end.end as usize, ..Route::default() };
        steps::write(ways, path, [begin.s, end.s], Route { cost, ..ends }, out)
    }
}

/// The node that a hop comes from, or the place of the start's chain with its mark.
#[inline]
pub(super) fn node_of(from: u32) -> u32 {
    if from & (FROM_START | FROM_SIDE) == FROM_SIDE { from & !FROM_SIDE } else { from }
}

/// The side to which a change from one node to one beside it goes.
fn side<'a>(ways: impl Ways<'a>, from: u32, to: u32) -> Enter {
    match ways.node(from).and_then(|node| ways.beside(from, &node, true)) {
        Some(left) if left == to => Enter::Left,
        _ => Enter::Right,
    }
}
