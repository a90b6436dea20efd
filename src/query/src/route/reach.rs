//! What can be reached within a cost, and who can reach a place.

use super::cost::RouteCost;
use super::ends::{is_root, price, start_chain, target_chain};
use super::request::Avoiding;
use super::scratch::{Open, RouteScratch};
use super::ways::Ways;
use super::{Enter, PositionOnLane, RouteError, RouteRequest};
use crate::error::QueryError;
use crate::extents::SRange;
use crate::graph::LaneNode;
use crate::ids::{LaneId, NodeId};
use crate::map::Map;
use mapd_archive::{NONE, VehicleClass};

/// A node of the lane graph, or under an overlay a piece of one, that can be reached, and what of it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Reached {
    /// The node.
    pub node: NodeId,
    /// Its lane.
    pub lane: LaneId,
    /// Whether it is travelled towards +s.
    pub forward: bool,
    /// s at which the part within the limit begins, in driving direction `[m]`: where the node is entered, or where one starts.
    pub s_from: f64,
    /// s up to which the limit lasts, in driving direction `[m]`: where the node is left, or where the goal is.
    pub s_to: f64,
    /// Least cost between its beginning and the start or goal; of nodes beside a start, of the lane changes to them.
    pub cost: f64,
    /// Changes of lane on this way.
    pub lane_changes: u32,
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(super) number: u32,
}

/// What can be reached, and how one goes on from each to the others: the network ahead, in which ways that meet again are told once. In
/// buffers that are used again.
#[derive(Clone, Debug, Default)]
pub struct Reach {
    pub(super) reached: Vec<Reached>,
    pub(super) links: Vec<ReachLink>,
    /// First link of each, and the end.
    pub(super) first: Vec<u32>,
}

/// How one goes on from one node that is reached to another.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ReachLink {
    /// Number of the other.
    pub to: usize,
    /// How it is entered.
    pub enter: Enter,
}

impl Reach {
    /// Everything that is reached, nearest first; starts and what lies beside them come first of all.
    pub fn reached(&self) -> &[Reached] {
        &self.reached
    }

    /// How one goes on from the one of this number: in driving direction of [`Map::reach`], against it of [`Map::reach_to`]. What lies
    /// beyond the limit is not among the links.
    pub fn links(&self, number: usize) -> &[ReachLink] {
        let ends = self.first.get(number).zip(self.first.get(number + 1));
        ends.and_then(|(a, b)| self.links.get(*a as usize..*b as usize)).unwrap_or(&[])
    }

    pub(super) fn with_capacity(pieces: usize) -> Self {
        Self {
            reached: Vec::with_capacity(pieces),
            links: Vec::with_capacity(pieces),
            first: Vec::with_capacity(pieces),
        }
    }

    pub(super) fn clear(&mut self) {
        self.reached.clear();
        self.links.clear();
        self.first.clear();
    }
}

impl<'a> Map<'a> {
    /// Every node whose beginning can be reached from a place within a cost, nearest first; the start's own node and those beside it come
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
        let starts = &[from.into()];
        let request = RouteRequest { starts, goals: &[], vehicle, cost, avoid: &[] };
        Ok(reach(*self, &request, limit, scratch, out)?)
    }

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
        let goals = &[to.into()];
        let request = RouteRequest { starts: &[], goals, vehicle, cost, avoid: &[] };
        Ok(reach_to(*self, &request, limit, scratch, out)?)
    }

    /// What can be reached from a request's starts within a cost, with the ways on: the network of lanes ahead, without lane changes where
    /// these cost infinitely much. Its goals count for nothing.
    ///
    /// Errors: as [`Map::find_route`].
    pub fn reach(
        &self,
        request: &RouteRequest<'_, impl RouteCost>,
        limit: f64,
        scratch: &mut RouteScratch,
        out: &mut Reach,
    ) -> Result<(), RouteError> {
        network(*self, request, WithinCost { limit, ahead: true }, scratch, out)
    }

    /// What a request's goals can be reached from within a cost, with the ways back: the network of lanes that lead there. Its starts
    /// count for nothing. Closed lanes are not among them, though who is on one may leave it.
    ///
    /// Errors: as [`Map::find_route`].
    pub fn reach_to(
        &self,
        request: &RouteRequest<'_, impl RouteCost>,
        limit: f64,
        scratch: &mut RouteScratch,
        out: &mut Reach,
    ) -> Result<(), RouteError> {
        network(*self, request, WithinCost { limit, ahead: false }, scratch, out)
    }
}

/// How far a [`network`] of lanes goes.
pub(crate) struct WithinCost {
    /// Largest cost.
    pub(crate) limit: f64,
    /// From the starts on; else back from the goals.
    pub(crate) ahead: bool,
}

/// As [`Map::reach`] or [`Map::reach_to`], on a map or under an overlay.
///
/// Errors: as [`Map::find_route`].
pub(crate) fn network<'a>(
    ways: impl Ways<'a>,
    request: &RouteRequest<'_, impl RouteCost>,
    WithinCost { limit, ahead }: WithinCost,
    scratch: &mut RouteScratch,
    out: &mut Reach,
) -> Result<(), RouteError> {
    out.clear();
    let Reach { reached, links, first } = out;
    if ahead {
        reach(ways, request, limit, scratch, reached)?;
    } else {
        reach_to(ways, request, limit, scratch, reached)?;
    }
    let closed = request.closed(ways.map(), scratch);
    let cost = Avoiding { base: request.cost, closed: &closed };
    for own in reached.iter() {
        first.push(links.len() as u32);
        let Some(node) = ways.node(own.number) else { continue };
        // A label's parent is its node's number among those that are reached.
        let mut link = |scratch: &RouteScratch, other: u32, price: f64, enter: Enter| {
            if price < f64::INFINITY
                && let Some(label) = scratch.label(other)
            {
                links.push(ReachLink { to: label.parent as usize, enter });
            }
        };
        let at = |other: u32| ways.node(other).unwrap_or(node);
        if ahead {
            ways.ahead(own.number, |next| {
                let to = at(next);
                if node.leads_into(&to, request.vehicle) {
                    link(scratch, next, price(cost.enter(&node, &to)), Enter::Ahead);
                }
            });
        } else {
            ways.behind(own.number, |from| {
                link(scratch, from, price(cost.enter(&at(from), &node)), Enter::Ahead);
            });
        }
        // Beside a start one is where its own changes lead, not at the beginning of a node.
        let place = scratch.start.iter().position(|s| s.end as usize + 1 == first.len());
        if let Some(place) = place.filter(|_| ahead) {
            let chain = scratch.start.iter().enumerate();
            for (_, next) in chain.filter(|(i, s)| s.link as usize == place && *i != place) {
                let is_left = ways.change(own.number, &node, true) == Some(next.node);
                let enter = if is_left { Enter::Left } else { Enter::Right };
                if next.end != NONE {
                    links.push(ReachLink { to: next.end as usize, enter });
                }
            }
            continue;
        }
        for left in [true, false] {
            // Changes to the right lead here from the left.
            let enter = if left == ahead { Enter::Left } else { Enter::Right };
            if ahead && let Some(to) = ways.change(own.number, &node, left) {
                if at(to).allows(request.vehicle) {
                    link(scratch, to, price(cost.change(&node, &at(to))), enter);
                }
            } else if !ahead && let Some(from) = ways.changes_from(own.number, &node, left) {
                link(scratch, from, price(cost.change(&at(from), &node)), enter);
            }
        }
    }
    first.push(links.len() as u32);
    scratch.closed = closed;
    Ok(())
}

/// What is reached of a node: all of it, or as far as a limit lasts.
pub(super) struct ReachedPart<'n, 'a> {
    pub(super) node: &'n LaneNode<'a>,
    pub(super) number: u32,
    /// s between which it would be driven, in the direction in which it is followed.
    pub(super) s: [f64; 2],
    pub(super) cost: f64,
    pub(super) lane_changes: u32,
}

impl<'a> ReachedPart<'_, 'a> {
    /// As far as what is left to pay lasts, where all of it costs `pass`.
    pub(super) fn cut(self, rest: f64, pass: f64) -> Option<Reached> {
        let lane = self.node.lane()?;
        let [s_from, mut s_to] = self.s;
        if pass > rest {
            let share = if rest > 0.0 { rest / pass } else { 0.0 };
            s_to = lane.s_after(s_from, s_to, lane.length_between(s_from, s_to) * share);
        }
        Some(Reached {
            node: self.node.node_id(),
            lane: lane.lane_id(),
            forward: self.node.is_forward(),
            s_from,
            s_to,
            cost: self.cost,
            lane_changes: self.lane_changes,
            number: self.number,
        })
    }
}

/// Both ends of a node in driving direction.
fn ends_of(node: &LaneNode<'_>) -> [f64; 2] {
    let SRange { low, high } = node.s_range();
    if node.is_forward() { [low, high] } else { [high, low] }
}

/// Lists everything whose beginning can be reached within a limit, nearest first.
///
/// Errors: as [`Map::find_route`].
pub(crate) fn reach<'a>(
    ways: impl Ways<'a>,
    request: &RouteRequest<'_, impl RouteCost>,
    limit: f64,
    scratch: &mut RouteScratch,
    out: &mut Vec<Reached>,
) -> Result<(), RouteError> {
    out.clear();
    request.check(ways.map())?;
    let closed = request.closed(ways.map(), scratch);
    let cost = Avoiding { base: request.cost, closed: &closed };
    let vehicle = request.vehicle;
    scratch.begin(ways.count());
    start_chain(ways, request.starts, vehicle, &cost, &mut scratch.start);
    // Until a node is reached for good, its label has the changes of lane as its parent; then its number among what is reached.
    let enter = |scratch: &mut RouteScratch, number: u32, cost: f64, changes: u32| {
        if cost <= limit && scratch.improve(number, cost, changes) {
            scratch.heap.push(Open::new(cost, cost, number));
        }
    };
    for i in 0..scratch.start.len() {
        let Some(start) = scratch.start.get(i).copied() else { continue };
        let Some(node) = ways.node(start.node) else { continue };
        // Who links what is reached finds it by its number.
        let at = if start.changes > limit { NONE } else { out.len() as u32 };
        if let Some(start) = scratch.start.get_mut(i) {
            start.end = at;
        }
        if at == NONE {
            continue;
        }
        let lane_changes = changes_of(&scratch.start, i);
        let s = [start.s, ends_of(&node)[1]];
        let (number, own) = (start.node, start.changes);
        let part = ReachedPart { node: &node, number, s, cost: own, lane_changes };
        out.extend(part.cut(limit - own, start.pass));
        let passed = own + start.pass;
        ways.ahead(number, |next| {
            let to = ways.node(next).filter(|to| node.leads_into(to, vehicle));
            let Some(to) = to else { return };
            enter(scratch, next, passed + price(cost.enter(&node, &to)), lane_changes);
        });
    }
    while let Some(open) = scratch.heap.pop() {
        let (number, own) = (open.node, open.key());
        let Some(label) = scratch.label(number).filter(|label| own <= label.cost) else { continue };
        let Some(node) = ways.node(number) else { continue };
        let pass = price(cost.pass(&node));
        let lane_changes = label.parent;
        let part = ReachedPart { node: &node, number, s: ends_of(&node), cost: own, lane_changes };
        scratch.set_parent(number, out.len() as u32);
        out.extend(part.cut(limit - own, pass));
        let passed = own + pass;
        if passed <= limit {
            ways.ahead(number, |next| {
                // What entering costs only adds to it.
                if scratch.cost(next) <= passed {
                    return;
                }
                let to = ways.node(next).filter(|to| node.leads_into(to, vehicle));
                let Some(to) = to else { return };
                enter(scratch, next, passed + price(cost.enter(&node, &to)), lane_changes);
            });
        }
        for left in [true, false] {
            let beside = ways.change(number, &node, left);
            let Some(beside) = beside.filter(|to| scratch.cost(*to) > own) else { continue };
            let Some(to) = ways.node(beside).filter(|to| to.allows(vehicle)) else { continue };
            enter(scratch, beside, own + price(cost.change(&node, &to)), lane_changes + 1);
        }
    }
    scratch.closed = closed;
    Ok(())
}

/// Lists everything from whose beginning a goal can be reached within a limit, nearest first.
///
/// Errors: as [`Map::find_route`].
pub(crate) fn reach_to<'a>(
    ways: impl Ways<'a>,
    request: &RouteRequest<'_, impl RouteCost>,
    limit: f64,
    scratch: &mut RouteScratch,
    out: &mut Vec<Reached>,
) -> Result<(), RouteError> {
    out.clear();
    request.check(ways.map())?;
    let closed = request.closed(ways.map(), scratch);
    let cost = Avoiding { base: request.cost, closed: &closed };
    let vehicle = request.vehicle;
    scratch.begin(ways.count());
    target_chain(ways, request.goals, vehicle, &cost, &mut scratch.target);
    scratch.note_goals();
    let enter = |scratch: &mut RouteScratch, number: u32, cost: f64, changes: u32| {
        let is_open = cost <= limit && ways.node(number).is_some_and(|to| to.allows(vehicle));
        if is_open && scratch.improve(number, cost, changes) {
            scratch.heap.push(Open::new(cost, cost, number));
        }
    };
    for i in 0..scratch.target.len() {
        let Some(own) = scratch.target.get(i).copied() else { continue };
        // The length counts on the goal itself, whichever lane beside it is entered.
        let changes = changes_of(&scratch.target, i);
        enter(scratch, own.node, own.changes + own.pass, changes);
    }
    while let Some(open) = scratch.heap.pop() {
        let (number, own) = (open.node, open.key());
        let Some(label) = scratch.label(number).filter(|label| own <= label.cost) else { continue };
        let Some(node) = ways.node(number) else { continue };
        let lane_changes = label.parent;
        let mut s = ends_of(&node);
        let roots = scratch.target.iter().enumerate();
        if let Some((_, goal)) = roots.filter(|t| is_root(*t)).find(|(_, t)| t.node == number)
            && own <= goal.changes + goal.pass
        {
            s[1] = goal.s;
        }
        let part = ReachedPart { node: &node, number, s, cost: own, lane_changes };
        scratch.set_parent(number, out.len() as u32);
        out.extend(part.cut(f64::INFINITY, 0.0));
        ways.behind(number, |from| {
            let Some(before) = ways.node(from) else { return };
            let pass = price(cost.pass(&before)) + price(cost.enter(&before, &node));
            enter(scratch, from, own + pass, lane_changes);
        });
        // Beside the goal itself, changes may lie beyond it: its chain has those that do not.
        if scratch.is_goal(number) {
            continue;
        }
        for left in [true, false] {
            let Some(from) = ways.changes_from(number, &node, left) else { continue };
            let Some(before) = ways.node(from) else { continue };
            enter(scratch, from, own + price(cost.change(&before, &node)), lane_changes + 1);
        }
    }
    scratch.closed = closed;
    Ok(())
}

/// Changes of lane between a place of a chain and its start or goal.
fn changes_of(chain: &[super::ends::ChainNode], mut place: usize) -> u32 {
    let mut changes = 0;
    while let Some(own) = chain.get(place).filter(|own| own.link as usize != place) {
        place = own.link as usize;
        changes += 1;
    }
    changes
}

#[cfg(feature = "serde")]
impl serde::Serialize for Reach {
    /// Pairs of what is reached and the ways on from there.
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(self.reached.iter().enumerate().map(|(i, one)| (one, self.links(i))))
    }
}
