//! Both ends of a route: lane changes beside the start and beside the target, which do not have a whole piece ahead.

use super::PositionOnLane;
use super::cost::RouteCost;
use super::ways::Ways;
use crate::extents::SRange;
use crate::graph::LaneNode;
use crate::lane::Lane;
use crate::map::Map;
use mapd_archive::VehicleClass;

/// Lane changes to one side that are followed at most: a damaged archive might lead round in a circle.
const MOST_BESIDE: usize = 64;

/// A node beside the start or the target, with what changing costs.
#[derive(Clone, Copy)]
pub(super) struct ChainNode {
    pub(super) node: u32,
    /// Of the lane changes from the start to here, or from here to the target.
    pub(super) changes: f64,
    /// Place in the chain of the node before it (start) or after it (target); itself for the first.
    pub(super) link: u32,
}

/// Whether a place of a chain is the start or target itself.
pub(super) fn is_root((place, own): (usize, &ChainNode)) -> bool {
    own.link as usize == place
}

/// The start or target that a place of a chain belongs to.
pub(super) fn root_of(chain: &[ChainNode], place: usize) -> Option<ChainNode> {
    let mut own = chain.get(place).copied()?;
    let mut at = place;
    for _ in 0..=MOST_BESIDE {
        if own.link as usize == at {
            return Some(own);
        }
        at = own.link as usize;
        own = chain.get(at).copied()?;
    }
    None
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

/// Nodes from which a route may start: the one at the place in each direction of travel, then those that lane changes
/// lead to from it.
pub(super) fn start_chain<'a>(
    ways: impl Ways<'a>,
    (place, forward): (PositionOnLane, Option<bool>),
    vehicle: VehicleClass,
    cost: &impl RouteCost,
    out: &mut Vec<ChainNode>,
) {
    let Some((lane, s)) = lane_of(ways.map(), place) else { return };
    for way in [true, false].into_iter().filter(|way| forward.is_none_or(|f| f == *way)) {
        let first = ways.at(&lane, s, way).and_then(|number| Some((number, ways.node(number)?)));
        let Some(first) = first else { continue };
        let root = push(out, first.0, 0.0, None);
        for left in [true, false] {
            let ((mut number, mut at), mut link, mut changes) = (first, root, 0.0);
            for _ in 0..MOST_BESIDE {
                let Some(beside) = ways.change(number, &at, left) else { break };
                let next = ways.node(beside).filter(|next| next.allows(vehicle));
                let Some(next) = next else { break };
                changes += price(cost.change(&at, &next));
                if changes == f64::INFINITY {
                    break;
                }
                link = push(out, beside, changes, Some(link));
                (number, at) = (beside, next);
            }
        }
    }
}

/// Nodes from which lane changes lead to the target, itself first.
pub(super) fn target_chain<'a>(
    ways: impl Ways<'a>,
    place: PositionOnLane,
    vehicle: VehicleClass,
    cost: &impl RouteCost,
    out: &mut Vec<ChainNode>,
) {
    let Some((lane, s)) = lane_of(ways.map(), place) else { return };
    for way in [true, false] {
        let target = ways.at(&lane, s, way).and_then(|number| Some((number, ways.node(number)?)));
        let Some(first) = target.filter(|(_, node)| node.allows(vehicle)) else { continue };
        let root = push(out, first.0, 0.0, None);
        for from_left in [true, false] {
            let ((mut number, mut at), mut link, mut changes) = (first, root, 0.0);
            for _ in 0..MOST_BESIDE {
                let Some(beside) = ways.beside(number, &at, from_left) else { break };
                let before = ways.node(beside).filter(|before| before.allows(vehicle));
                let Some(before) = before else { break };
                if ways.change(beside, &before, !from_left) != Some(number) {
                    break;
                }
                changes += price(cost.change(&before, &at));
                if changes == f64::INFINITY {
                    break;
                }
                link = push(out, beside, changes, Some(link));
                (number, at) = (beside, before);
            }
        }
    }
}

fn push(out: &mut Vec<ChainNode>, node: u32, changes: f64, link: Option<u32>) -> u32 {
    let own = out.len() as u32;
    out.push(ChainNode { node, changes, link: link.unwrap_or(own) });
    own
}

/// A cost as a search takes it: infinite closes the way.
#[inline]
pub(super) fn price(cost: f64) -> f64 {
    if cost >= 0.0 { cost } else { f64::INFINITY }
}

/// Share of a node's length from its beginning to s.
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
