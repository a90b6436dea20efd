//! A path's own steps on another version of its map, where all of them can be driven as before.

use super::Path;
use super::rebase::FAR;
use crate::graph::LaneNode;
use crate::lane::Lane;
use crate::map::Map;
use crate::route::{Enter, Route, RouteCost, RouteStep, Ways, share_before};
use mapd_archive::VehicleClass;

/// Places along a road that differ by less are one `[m]`.
const ROUNDING: f64 = 1e-6;

/// A step on the other map.
#[derive(Clone, Copy)]
struct Kept<'a> {
    step: RouteStep,
    lane: Lane<'a>,
    /// The nodes on which it is entered and left.
    enters: LaneNode<'a>,
    leaves: LaneNode<'a>,
}

/// Adds up what a route is, node by node.
struct Sum<'c, C> {
    cost: &'c C,
    vehicle: VehicleClass,
    route: Route,
}

impl Path<'_, '_> {
    /// The steps of the path on another map, appended, and what they cost there. None where a lane is not there by its key, has moved by
    /// more than [`FAR`], is closed to the vehicle or by its cost, or is not entered as before: then a way has to be searched.
    pub(super) fn keep(
        &self,
        map: Map<'_>,
        vehicle: VehicleClass,
        cost: &impl RouteCost,
        steps: &mut Vec<RouteStep>,
    ) -> Option<Route> {
        let mut sum = Sum { cost, vehicle, route: Route::default() };
        let mut before: Option<Kept<'_>> = None;
        for step in &self.buffer.steps {
            let own = self.kept(step, map)?;
            match before {
                // From here a vehicle leaves even a closed lane.
                None if step.s_from == step.s_to => {}
                _ => sum.is_open(&own).then_some(())?,
            }
            if let Some(before) = before {
                sum.enter(map, &before, &own, steps.len() > 1)?;
            }
            sum.pass(map, &own)?;
            steps.push(own.step);
            before = Some(own);
        }
        Some(sum.route).filter(|route| before.is_some() && route.cost.is_finite())
    }

    /// A step on the lane of the same key.
    fn kept<'a>(&self, step: &RouteStep, map: Map<'a>) -> Option<Kept<'a>> {
        let old = self.map.lane(step.lane).ok()?;
        let lane = map.lane_by_key(&old.key())?;
        let ends = |lane: &Lane<'_>| [lane.section().s_start(), lane.section().s_end()];
        let (was, is) = (ends(&old), ends(&lane));
        let at = |lane: &Lane<'_>, s| lane.pose_at(s, 0.0).map(|pose| pose.position.truncate());
        let mut places = [step.s_from, step.s_to, step.s_latest];
        for s in &mut places {
            let before = at(&old, *s).ok()?;
            // Where the lane ended there, it still does.
            if let Some((_, now)) = was.iter().zip(is).find(|(end, _)| *end == s) {
                *s = now;
            }
            let is_there =
                (is[0]..=is[1]).contains(s) && before.distance(at(&lane, *s).ok()?) <= FAR;
            is_there.then_some(())?;
        }
        let [s_from, s_to, s_latest] = places;
        let step = RouteStep { lane: lane.lane_id(), s_from, s_to, s_latest, ..*step };
        let mut nodes = lane.nodes().filter(|node| node.is_forward() == step.forward);
        let enters = lane.node_at(s_from, step.forward)?;
        // At a cut, what ends there is left.
        let leaves = nodes.find(|node| node.number >= enters.number && !is_before(node, s_to))?;
        Some(Kept { step, lane, enters, leaves })
    }
}

impl<C: RouteCost> Sum<'_, C> {
    /// Whether the vehicle may drive all of a step.
    fn is_open(&self, own: &Kept<'_>) -> bool {
        let nodes = own.enters.number..=own.leaves.number;
        own.lane.nodes().filter(|node| nodes.contains(&node.number)).all(|n| n.allows(self.vehicle))
    }

    /// Adds what entering a step costs; none where it is not entered so.
    fn enter(&mut self, map: Map<'_>, before: &Kept<'_>, own: &Kept<'_>, open: bool) -> Option<()> {
        let Kept { step, enters, .. } = own;
        let left = match step.enter {
            Enter::Start | Enter::Ahead => {
                let goes_on = (before.step.lane, before.step.forward) == (step.lane, step.forward);
                if goes_on && before.step.s_to == step.s_from {
                    return Some(());
                }
                let from = &before.leaves;
                let is_whole =
                    is_at(end(from), before.step.s_to) && is_at(begin(enters), step.s_from);
                let mut linked = false;
                map.ahead(from.number, |next| linked |= next == enters.number);
                (is_whole && linked).then_some(())?;
                return self.add(self.cost.enter(from, enters));
            }
            Enter::Left => true,
            Enter::Right => false,
        };
        // The change is possible wherever it was.
        let mut first = None;
        let nodes = own.lane.nodes().filter(|node| node.is_forward() == step.forward);
        let window = nodes.filter(|node| node.number >= enters.number);
        for node in window
            .take_while(|node| node.number == enters.number || !is_behind(node, step.s_latest))
        {
            let from = LaneNode::new(map, map.changes_from(node.number, &node, !left)?)?;
            let is_it = from.row.lane() == before.step.lane.row() && node.allows(self.vehicle);
            (is_it && (!open || from.allows(self.vehicle))).then_some(())?;
            first = first.or(Some(from));
        }
        self.route.lane_changes += 1;
        self.add(self.cost.change(&first?, enters))
    }

    /// Adds what is driven of a step.
    fn pass(&mut self, map: Map<'_>, own: &Kept<'_>) -> Option<()> {
        let Kept { step, lane, enters, leaves } = own;
        let mut last: Option<LaneNode<'_>> = None;
        for number in enters.number..=leaves.number {
            let node = LaneNode::new(map, number)?;
            if let Some(last) = last {
                self.add(self.cost.enter(&last, &node))?;
            }
            let from = if number == enters.number { step.s_from } else { begin(&node) };
            let to = if number == leaves.number { step.s_to } else { end(&node) };
            let length = lane.length_between(from, to);
            if length > 0.0 {
                let is_whole = from == begin(&node) && to == end(&node);
                let share = if is_whole {
                    1.0
                } else {
                    share_before(&node, to) - share_before(&node, from)
                };
                self.add(self.cost.pass(&node) * share.max(0.0))?;
                self.route.drive(&node, lane, [from, to], length);
            }
            last = Some(node);
        }
        Some(())
    }

    /// Adds a cost; none where it closes the way.
    fn add(&mut self, cost: f64) -> Option<()> {
        self.route.cost += cost;
        (cost >= 0.0).then_some(())
    }
}

/// Where a node is entered `[m]`.
fn begin(node: &LaneNode<'_>) -> f64 {
    let range = node.s_range();
    if node.is_forward() { range.low } else { range.high }
}

/// Where a node is left at its end `[m]`.
fn end(node: &LaneNode<'_>) -> f64 {
    let range = node.s_range();
    if node.is_forward() { range.high } else { range.low }
}

fn is_at(a: f64, b: f64) -> bool {
    (a - b).abs() <= ROUNDING
}

/// Whether a node ends before s, in driving direction.
fn is_before(node: &LaneNode<'_>, s: f64) -> bool {
    let off = s - end(node);
    !is_at(end(node), s) && if node.is_forward() { off > 0.0 } else { off < 0.0 }
}

/// Whether a node begins at s or behind it, in driving direction.
fn is_behind(node: &LaneNode<'_>, s: f64) -> bool {
    let off = begin(node) - s;
    is_at(begin(node), s) || if node.is_forward() { off > 0.0 } else { off < 0.0 }
}
