//! Alternatives: the k best routes, or those of the best that differ.
//!
//! **The k best** are found by Yen's algorithm with Lawler's rule: the next best route leaves one that is known at some node, by a hop that none that
//! is known takes there. **Those that differ** are looked for among the cheapest ways over each node of the graph (single-via paths): the way from
//! the start to the node and from there to the goal, cheapest first; a way counts if it drives a share of its length where no route before
//! it does. Two searches find them all.

use super::bound::Bounds;
use super::cost::RouteCost;
use super::ends::{ChainNode, price};
use super::request::Avoiding;
use super::scratch::{
    DIRECT, FROM_SIDE, FROM_START, GOAL, Hop, Open, Others, RouteScratch, is_set, set,
};
use super::search::{Best, Search, node_of};
use super::ways::Ways;
use super::{Route, RouteError, RouteRequest, RouteStep};
use crate::map::Map;
use std::ops::Range;

/// Routes of one answer at most: each has a bit.
const MOST_ROUTES: usize = 32;
/// Ways that are compared with the routes so far, at most.
const MOST_COMPARED: usize = 4_096;
/// Costs that differ by a smaller share are equal.
const ROUNDING: f64 = 1e-9;

/// Which alternatives are wanted.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct AlternativeOptions {
    /// Routes, the best one among them: 1 to 32. Default 3.
    pub count: usize,
    /// Share of its length that each drives on other sections of road, or the other way, than any one of those before it, 0 to 1. 0 for the k best routes, which may differ by a change of lane. Default 0.3.
    pub share: f64,
    /// How many times the cheapest one's cost a route may cost, at least 1. Default 1.5.
    pub longest: f64,
}

impl Default for AlternativeOptions {
    fn default() -> Self {
        Self { count: 3, share: 0.3, longest: 1.5 }
    }
}

impl AlternativeOptions {
    /// Errors: by name, an option out of its domain.
    fn check(&self) -> Result<(), RouteError> {
        let rules = [
            ("count", (1..=MOST_ROUTES).contains(&self.count)),
            ("share", (0.0..=1.0).contains(&self.share)),
            ("longest", self.longest >= 1.0),
        ];
        match rules.iter().find(|(_, holds)| !holds) {
            Some((name, _)) => Err(RouteError::Option(name)),
            None => Ok(()),
        }
    }
}

/// Several routes, in buffers that are used again.
#[derive(Clone, Debug, Default)]
pub struct Routes {
    routes: Vec<Route>,
    steps: Vec<RouteStep>,
    /// End of each one's steps.
    ends: Vec<usize>,
}

impl Routes {
    /// Each route with its steps, cheapest first.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (&Route, &[RouteStep])> {
        self.routes.iter().enumerate().map(|(i, route)| {
            let from = i.checked_sub(1).and_then(|i| self.ends.get(i)).copied().unwrap_or(0);
            (route, self.ends.get(i).and_then(|to| self.steps.get(from..*to)).unwrap_or(&[]))
        })
    }

    fn clear(&mut self) {
        self.routes.clear();
        self.steps.clear();
        self.ends.clear();
    }

    fn end(&mut self, route: Route) {
        self.routes.push(route);
        self.ends.push(self.steps.len());
    }
}

/// A way that was found, by its hops.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnownRoute {
    cost: f64,
    first: usize,
    end: usize,
    /// Hops that it shares with the way that it leaves.
    shared: usize,
    is_taken: bool,
}

/// Where another way leaves a known one.
#[derive(Clone, Copy)]
struct Deviation {
    known: KnownRoute,
    /// Number of the known way's hops that are kept.
    shared: usize,
    /// The node behind which the ways part (Yen's spur node); none where they part at the start.
    spur: Option<u32>,
    /// Cost up to the end of the spur node.
    cost: f64,
}

/// What another way must not exceed to count.
#[derive(Clone, Copy)]
struct Limits {
    /// Ways that are still looked for.
    count: usize,
    /// Greatest cost.
    cost: f64,
}

impl KnownRoute {
    fn hops(&self) -> Range<usize> {
        self.first..self.end
    }
}

impl<'a> Map<'a> {
    /// The cheapest route and alternatives to it, cheapest first. `out` is emptied first. The share of 0 costs a search for each node of each
    /// route; a larger one costs two searches.
    ///
    /// Errors: as [`Map::find_route`]; options out of their domain.
    pub fn alternatives(
        &self,
        request: &RouteRequest<'_, impl RouteCost>,
        options: &AlternativeOptions,
        scratch: &mut RouteScratch,
        out: &mut Routes,
    ) -> Result<(), RouteError> {
        alternatives(*self, request, options, scratch, out)
    }
}

/// As [`Map::alternatives`], on a map or under an overlay.
///
/// Errors: as [`Map::alternatives`].
pub(crate) fn alternatives<'a>(
    ways: impl Ways<'a>,
    request: &RouteRequest<'_, impl RouteCost>,
    options: &AlternativeOptions,
    scratch: &mut RouteScratch,
    out: &mut Routes,
) -> Result<(), RouteError> {
    out.clear();
    options.check()?;
    request.check(ways.map())?;
    let closed = request.closed(ways.map(), scratch);
    let cost = Avoiding { base: request.cost, closed: &closed };
    let mut search = Search::new(ways, request.vehicle, &cost, scratch);
    let bounds = search.place([request.starts, request.goals]);
    if let Ok(Some(bounds)) = &bounds {
        search.find(bounds);
        if let Some(best) = search.best {
            if options.share > 0.0 {
                search.differing(bounds, best, options, out);
            } else {
                search.best_ones(bounds, best, options, out);
            }
        }
    }
    scratch.closed = closed;
    bounds.map(|_| ()).map_err(RouteError::Query)
}

impl<'a, W: Ways<'a>, C: RouteCost> Search<'_, W, C> {
    /// Yen's algorithm.
    fn best_ones(
        &mut self,
        bounds: &Bounds<'a>,
        best: Best,
        options: &AlternativeOptions,
        out: &mut Routes,
    ) {
        let Range { start: first, end } = self.trace(best, None);
        let worst = (best.cost * options.longest).max(best.cost);
        let found = &mut self.scratch.others.found;
        found.clear();
        found.push(KnownRoute { cost: best.cost, first, end, shared: 0, is_taken: false });
        for taken in 1..=options.count {
            let found = &mut self.scratch.others.found;
            let open = found.iter_mut().filter(|found| !found.is_taken);
            let Some(next) = open.min_by(|a, b| a.cost.total_cmp(&b.cost)) else { return };
            next.is_taken = true;
            let own = *next;
            let route = self.write(own.hops(), own.cost, &mut out.steps);
            out.end(route);
            if taken < options.count {
                let limits = Limits { count: options.count - taken, cost: worst };
                self.leave_at_each(own, limits, bounds);
                self.tidy(options.count - taken);
            }
        }
    }

    /// Finds the best way that leaves a known one at each of its nodes, from the one at which it left another on.
    fn leave_at_each(&mut self, known: KnownRoute, limits: Limits, bounds: &Bounds<'a>) {
        // Cost at the beginning of the node at which the way is left.
        let mut cost = 0.0;
        for at in 0..known.end - known.first {
            let place = known.first + at;
            let Some(hop) = self.scratch.hops.get(place).copied() else { return };
            let spur = self.scratch.hops.get(place.wrapping_sub(1)).filter(|_| at > 0);
            let spur = spur.map(|before| before.to);
            if at >= known.shared {
                self.leave_at(Deviation { known, shared: at, spur, cost }, limits, bounds);
            }
            if hop.to & GOAL == 0 {
                cost = self.after(cost, hop);
            }
        }
    }

    fn leave_at(&mut self, deviation: Deviation, limits: Limits, bounds: &Bounds<'a>) {
        let Deviation { known, shared: at, spur, cost } = deviation;
        self.scratch.restart();
        (self.best, self.cutoff) = (None, self.cutoff(limits.count, limits.cost));
        let mut banned = std::mem::take(&mut self.scratch.others.banned);
        banned.clear();
        let RouteScratch { hops, others, .. } = &*self.scratch;
        let shared = hops.get(known.first..known.first + at).unwrap_or(&[]);
        for other in others.found.iter().filter(|other| other.is_taken) {
            let own = hops.get(other.hops()).unwrap_or(&[]);
            if own.get(..at) == Some(shared) {
                banned.extend(own.get(at));
            }
        }
        for i in known.first..known.first + at {
            let Some(hop) = self.scratch.hops.get(i).copied() else { break };
            self.scratch.ban(hop.to);
        }
        match spur {
            Some(node) => self.expand_node(node, cost, bounds, &banned),
            None => {
                self.on_one_piece(&banned);
                self.seed(bounds, &banned);
            }
        }
        self.expand(bounds, 0.0);
        self.scratch.others.banned = banned;
        let Some(best) = self.best else { return };
        let first = self.scratch.hops.len();
        self.scratch.hops.extend_from_within(known.first..known.first + at);
        let end = self.trace(best, spur).end;
        let new = KnownRoute { cost: best.cost, first, end, shared: at, is_taken: false };
        self.scratch.others.found.push(new);
    }

    /// What a way has to cost less than to be wanted: as the last of those that are wanted still, if there are as many.
    fn cutoff(&self, wanted: usize, worst: f64) -> f64 {
        let mut costs = [f64::INFINITY; MOST_ROUTES];
        let known = self.scratch.others.found.iter().filter(|found| !found.is_taken);
        for cost in known.map(|found| found.cost) {
            // Insertion: the least so far, in order.
            let mut new = cost;
            for own in costs.iter_mut().take(wanted) {
                if new < *own {
                    std::mem::swap(&mut new, own);
                }
            }
        }
        let last = wanted.checked_sub(1).and_then(|last| costs.get(last));
        // A way that costs as much as may be is still wanted.
        last.copied().unwrap_or(f64::INFINITY).min(worst.next_up())
    }

    /// Forgets ways that are not among the best that are wanted still, and their hops.
    fn tidy(&mut self, wanted: usize) {
        let RouteScratch { others: Others { found, .. }, hops, .. } = &mut *self.scratch;
        found.sort_unstable_by(|a, b| {
            b.is_taken.cmp(&a.is_taken).then(a.cost.total_cmp(&b.cost)).then(a.first.cmp(&b.first))
        });
        let taken = found.iter().filter(|found| found.is_taken).count();
        found.truncate(taken + wanted);
        found.sort_unstable_by_key(|found| found.first);
        let mut at = 0;
        for own in found.iter_mut() {
            let length = own.end - own.first;
            hops.copy_within(own.hops(), at);
            (own.first, own.end) = (at, at + length);
            at += length;
        }
        hops.truncate(at);
    }

    /// The cheapest way over each node, cheapest first, if it differs.
    fn differing(
        &mut self,
        bounds: &Bounds<'a>,
        best: Best,
        options: &AlternativeOptions,
        out: &mut Routes,
    ) {
        let count = self.ways.count();
        let known = self.ways.map().tables().sections.len();
        let Others { back, done, seen, sections, .. } = &mut self.scratch.others;
        if back.len() < count {
            back.resize(count, super::scratch::Label::default());
        }
        for bits in [done, seen] {
            bits.clear();
            bits.resize(count.div_ceil(64), 0);
        }
        sections.clear();
        sections.resize(2 * known, 0);
        let hops = self.trace(best, None);
        self.list_driven(hops.clone());
        self.take(hops, best.cost, out);
        let worst = (best.cost * options.longest).max(best.cost).next_up();
        self.expand(bounds, worst);
        self.expand_back(worst);
        for node in 0..count as u32 {
            let (ahead, back) = (self.scratch.label(node), self.scratch.back(node));
            if let Some((ahead, back)) = ahead.zip(back)
                && ahead.cost + back.cost < worst
            {
                let cost = ahead.cost + back.cost;
                self.scratch.heap.push(Open::new(cost, cost, node));
            }
        }
        let mut compared = 0;
        while out.routes.len() < options.count && compared < MOST_COMPARED {
            let Some(open) = self.scratch.heap.pop() else { return };
            if is_set(&self.scratch.others.done, open.node) {
                continue;
            }
            compared += 1;
            let cost = open.key();
            let Some(hops) = self.over(open.node, cost) else { continue };
            self.list_driven(hops.clone());
            if self.differs(options.share, out.routes.len()) {
                self.take(hops, cost, out);
            }
        }
    }

    /// Writes a way, and notes what it drives over, which has been listed.
    fn take(&mut self, hops: Range<usize>, cost: f64, out: &mut Routes) {
        let number = out.routes.len() as u32;
        let Others { sections, driven, .. } = &mut self.scratch.others;
        for (place, _) in &*driven {
            if let Some(bits) = sections.get_mut(*place) {
                *bits |= 1 << number;
            }
        }
        let route = self.write(hops, cost, &mut out.steps);
        out.end(route);
    }

    /// Lists what a way drives on: section and direction of each node, and the length driven `[m]`; not nodes that are changed from.
    // Never inlined: it is long, and asked of each way that is compared.
    #[inline(never)]
    fn list_driven(&mut self, hops: Range<usize>) {
        let RouteScratch { hops: all, start: starts, target, others, .. } = &mut *self.scratch;
        others.driven.clear();
        let mut on = |number: u32, share: f64| {
            let Some(node) = self.ways.node(number) else { return };
            let Some(lane) = node.lane() else { return };
            let place = 2 * lane.row.section() as usize + usize::from(node.is_forward());
            others.driven.push((place, node.length() * share));
        };
        for &Hop { from, to } in all.get(hops).unwrap_or(&[]) {
            // Straight on from the start on its piece: not from the piece's beginning.
            let (mut before, is_direct) = (0.0, to & DIRECT == DIRECT);
            if from & FROM_START != 0 {
                match starts.get((from & !FROM_START) as usize) {
                    Some(start) if is_direct => before = 1.0 - start.share,
                    Some(start) => on(start.node, start.share),
                    None => {}
                }
            } else if from & FROM_SIDE == 0 {
                on(from, 1.0);
            }
            if to & GOAL != 0
                && let Some(goal) = root(target, to & !DIRECT)
            {
                on(goal.node, (goal.share - before).max(0.0));
            }
        }
    }

    /// Whether a way, whose list has been made, drives a share of its length on other sections than each of the routes so far.
    fn differs(&self, share: f64, routes: usize) -> bool {
        let (mut length, mut shared) = (0.0, [0.0; MOST_ROUTES]);
        let Others { sections, driven, .. } = &self.scratch.others;
        for (place, own) in driven {
            length += own;
            let bits = sections.get(*place).copied().unwrap_or(0);
            for (i, shared) in shared.iter_mut().enumerate().take(routes) {
                if bits >> i & 1 != 0 {
                    *shared += own;
                }
            }
        }
        let most = (1.0 - share) * length;
        length > 0.0 && shared.iter().take(routes).all(|shared| *shared <= most + ROUNDING * length)
    }

    /// The hops of the cheapest way over a node; none if it comes by a place twice. Nodes on it over which no other way is as cheap are
    /// done.
    fn over(&mut self, via: u32, cost: f64) -> Option<Range<usize>> {
        self.scratch.hops.clear();
        let mut at = via;
        for _ in 0..self.ways.count() {
            let from = self.scratch.parent(at)?;
            self.scratch.hops.push(Hop { from, to: at });
            if from & FROM_START != 0 {
                break;
            }
            at = node_of(from);
        }
        self.scratch.hops.reverse();
        at = via;
        for _ in 0..self.ways.count() {
            let next = self.scratch.back(at)?.parent;
            // The next node is named as a hop's `from` names the one before.
            let is_goal = next & GOAL != 0;
            let from = if !is_goal && next & FROM_SIDE != 0 { FROM_SIDE | at } else { at };
            let to = if is_goal { next } else { next & !FROM_SIDE };
            self.scratch.hops.push(Hop { from, to });
            if is_goal {
                break;
            }
            at = to;
        }
        let whole = 0..self.scratch.hops.len();
        let is_equal = |scratch: &RouteScratch, node: u32| {
            let both = scratch.label(node).zip(scratch.back(node));
            both.is_some_and(|(a, b)| a.cost + b.cost >= cost * (1.0 - ROUNDING))
        };
        let mut is_simple = true;
        for i in whole.clone() {
            let Some(to) = self.scratch.hops.get(i).map(|hop| hop.to) else { break };
            if to & GOAL == 0 {
                is_simple &= set(&mut self.scratch.others.seen, to);
                if is_equal(self.scratch, to) {
                    set(&mut self.scratch.others.done, to);
                }
            }
        }
        for i in whole.clone() {
            let Some(to) = self.scratch.hops.get(i).map(|hop| hop.to) else { break };
            if let Some(word) = self.scratch.others.seen.get_mut(to as usize / 64) {
                *word = 0;
            }
        }
        is_simple.then_some(whole)
    }

    /// The best ways from nodes to the goal that cost less than a limit.
    fn expand_back(&mut self, limit: f64) {
        self.scratch.heap.clear();
        let (ways, vehicle, cost) = (self.ways, self.vehicle, self.cost);
        let enter = |scratch: &mut RouteScratch, from: u32, cost: f64, next: u32| {
            if cost < limit && scratch.improve_back(from, cost, next) {
                scratch.heap.push(Open::new(cost, cost, from));
            }
        };
        let scratch = &mut *self.scratch;
        let behind = |scratch: &mut RouteScratch, number: u32, rest: f64, next: u32| {
            let Some(node) = ways.node(number) else { return };
            ways.behind(number, |from| {
                let before = ways.node(from).filter(|from| from.leads_into(&node, vehicle));
                let Some(before) = before else { return };
                let pass = price(cost.pass(&before)) + price(cost.enter(&before, &node));
                enter(scratch, from, pass + rest, next);
            });
        };
        for place in 0..scratch.target.len() {
            let Some(own) = scratch.target.get(place).copied() else { continue };
            behind(scratch, own.node, own.changes + own.pass, GOAL | place as u32);
        }
        while let Some(open) = scratch.heap.pop() {
            let (number, own) = (open.node, open.key());
            if scratch.back(number).is_none_or(|label| own > label.cost) {
                continue;
            }
            behind(scratch, number, own, number);
            let open = ways.node(number).filter(|node| node.allows(vehicle));
            let Some(node) = open else { continue };
            for left in [true, false] {
                let Some(from) = ways.changes_from(number, &node, left) else { continue };
                let Some(before) = ways.node(from) else { continue };
                let changed = price(cost.change(&before, &node)) + own;
                enter(scratch, from, changed, FROM_SIDE | number);
            }
        }
    }
}

/// The goal itself that a place of the goals' chain leads to.
fn root(chain: &[ChainNode], mut place: u32) -> Option<&ChainNode> {
    // Each place leads to one before it.
    loop {
        let own = chain.get(place as usize)?;
        if own.link >= place {
            return Some(own);
        }
        place = own.link;
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Routes {
    /// Pairs of a route and its steps, as [`Self::iter`] has them.
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(self.iter())
    }
}
