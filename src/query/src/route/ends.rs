//! Both ends of a route: lane changes beside the start and beside the target, which do not have a whole piece ahead.

use super::cost::RouteCost;
use super::ways::Ways;
use super::{PositionOnLane, RouteEnd};
use crate::extents::SRange;
use crate::graph::LaneNode;
use crate::lane::Lane;
use crate::map::Map;
use mapd_archive::VehicleClass;

/// Lane changes to one side that are followed at most: a damaged archive might lead round in a circle.
const MOST_BESIDE: usize = 64;

/// A node beside a start or goal, with what changing costs.
#[derive(Clone, Copy)]
pub(super) struct ChainNode {
    pub(super) node: u32,
    /// Of the start and the lane changes from it to here, or of the lane changes from here to the goal and the goal.
    pub(super) changes: f64,
    /// Of what is driven on the piece: here, from the start's s on; or on the goal's own piece, up to its s.
    pub(super) pass: f64,
    /// Share of the piece's length that is driven, likewise.
    pub(super) share: f64,
    /// Place in the chain of the node before it (start) or after it (goal); itself for the first.
    pub(super) link: u32,
    /// Number of the start or goal.
    pub(super) end: u32,
    /// Its s `[m]`.
    pub(super) s: f64,
}

/// Whether a place of a chain is a start or goal itself.
pub(super) fn is_root((place, own): (usize, &ChainNode)) -> bool {
    own.link as usize == place
}

/// s of a place within its lane's section.
pub(super) fn inside(lane: &Lane<'_>, s: f64) -> f64 {
    let (start, end) = (lane.section().s_start(), lane.section().s_end());
    mapd_geometry::clamp(s, start, end.max(start))
}

/// The lane and s of a place.
pub(super) fn lane_of<'a>(map: Map<'a>, place: PositionOnLane) -> Option<(Lane<'a>, f64)> {
    let lane = map.lane(place.lane).ok()?;
    let s = inside(&lane, place.s);
    Some((lane, s))
}

/// Nodes from which a route may start: for each start the one at its place in each direction of travel that counts, then those that lane
/// changes lead to from it.
pub(super) fn start_chain<'a>(
    ways: impl Ways<'a>,
    starts: &[RouteEnd],
    vehicle: VehicleClass,
    cost: &impl RouteCost,
    out: &mut Vec<ChainNode>,
) {
    for (number, end) in starts.iter().enumerate() {
        let Some((lane, s)) = lane_of(ways.map(), end.place) else { continue };
        for way in directions(end) {
            let rest = |node: &LaneNode<'a>| 1.0 - share_before(node, s);
            let first =
                ways.at(&lane, s, way).and_then(|number| Some((number, ways.node(number)?)));
            let Some(first) = first else { continue };
            let share = rest(&first.1);
            let own = ChainNode {
                node: first.0,
                changes: price(end.cost),
                pass: price(cost.pass(&first.1)) * share,
                share,
                link: out.len() as u32,
                end: number as u32,
                s,
            };
            if own.changes == f64::INFINITY {
                continue;
            }
            out.push(own);
            for left in [true, false] {
                let ((mut number, mut at), mut last) = (first, own);
                for _ in 0..MOST_BESIDE {
                    let Some(beside) = ways.change(number, &at, left) else { break };
                    let next = ways.node(beside).filter(|next| next.allows(vehicle));
                    let Some(next) = next else { break };
                    last.changes += price(cost.change(&at, &next));
                    if last.changes == f64::INFINITY {
                        break;
                    }
                    let place = out.len() as u32;
                    (last.node, last.share) = (beside, rest(&next));
                    last.pass = price(cost.pass(&next)) * last.share;
                    out.push(last);
                    last.link = place;
                    (number, at) = (beside, next);
                }
            }
        }
    }
}

/// Nodes from which lane changes lead to a goal, itself first, for each goal.
pub(super) fn target_chain<'a>(
    ways: impl Ways<'a>,
    goals: &[RouteEnd],
    vehicle: VehicleClass,
    cost: &impl RouteCost,
    out: &mut Vec<ChainNode>,
) {
    for (number, end) in goals.iter().enumerate() {
        let Some((lane, s)) = lane_of(ways.map(), end.place) else { continue };
        for way in directions(end) {
            let target =
                ways.at(&lane, s, way).and_then(|number| Some((number, ways.node(number)?)));
            let Some(first) = target.filter(|(_, node)| node.allows(vehicle)) else { continue };
            let share = share_before(&first.1, s);
            let own = ChainNode {
                node: first.0,
                changes: price(end.cost),
                pass: price(cost.pass(&first.1)) * share,
                share,
                link: out.len() as u32,
                end: number as u32,
                s,
            };
            if own.changes == f64::INFINITY {
                continue;
            }
            out.push(own);
            for from_left in [true, false] {
                let ((mut number, mut at), mut last) = (first, own);
                for _ in 0..MOST_BESIDE {
                    let Some(beside) = ways.beside(number, &at, from_left) else { break };
                    let Some(before) = ways.node(beside) else { break };
                    if ways.change(beside, &before, !from_left) != Some(number) {
                        break;
                    }
                    last.changes += price(cost.change(&before, &at));
                    if last.changes == f64::INFINITY {
                        break;
                    }
                    let place = out.len() as u32;
                    last.node = beside;
                    out.push(last);
                    // One may be on a closed lane and leave it, but does not change to it.
                    if !before.allows(vehicle) {
                        break;
                    }
                    last.link = place;
                    (number, at) = (beside, before);
                }
            }
        }
    }
}

/// The directions of travel that count at a start or goal.
fn directions(end: &RouteEnd) -> impl Iterator<Item = bool> + use<> {
    let only = end.forward;
    [true, false].into_iter().filter(move |way| only.is_none_or(|only| only == *way))
}

/// A cost as a search takes it: infinite closes the way.
#[inline]
pub(super) fn price(cost: f64) -> f64 {
    if cost >= 0.0 { cost } else { f64::INFINITY }
}

/// Share of a node's length from its beginning to s.
// Never inlined: it is long, and what it measures takes longer than a call.
#[inline(never)]
pub(crate) fn share_before(node: &LaneNode<'_>, s: f64) -> f64 {
    let Some(lane) = node.lane() else { return 0.0 };
    let SRange { low: from, high: to } = node.s_range();
    let (done, whole) = (lane.length_between(from, s), lane.length_between(from, to));
    if whole <= 0.0 {
        return 0.0;
    }
    let share = mapd_geometry::clamp(done / whole, 0.0, 1.0);
    if node.is_forward() { share } else { 1.0 - share }
}
