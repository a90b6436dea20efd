//! How the probability of a lane spreads over the lane graph while a vehicle drives on.
//!
//! All of it goes ahead: at the end of a node it is shared between those that follow, by their priors; some of it changes lanes on
//! the way. As far as noise may lead, it also goes back, so that a fix that was taken for the next lane's is no mistake for ever.

use super::{LaneMatch, MatchOptions};
use crate::graph::LaneNode;
use crate::map::Map;
use crate::route::share_before;
use mapd_geometry::clamp;

/// Nodes that are still to be visited at most, and nodes that are visited from one place: what is left has the least probability of
/// all, for ways branch and each branch has its share.
pub(super) const MOST_OPEN: usize = 64;
const MOST_VISITS: usize = 192;
/// Shares below this are not followed.
const LEAST_SHARE: f64 = 1e-7;
/// Changes of lane between two fixes at most.
const MOST_CHANGES: u8 = 2;
/// Share of changes of lane that happen where marks forbid them.
const FORBIDDEN_CHANGES: f64 = 0.05;
/// Nodes count whose place differs from the way driven by so many of its deviations.
const WINDOW: f64 = 8.0;

/// What was driven between two fixes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Drive {
    /// Way driven, ahead `[m]`.
    pub(super) way: f64,
    /// Mean difference of ways along the graph from it `[m]`.
    pub(super) deviation: f64,
    /// Probability of a change of lane.
    pub(super) change: f64,
}

/// A node that a share of the probability comes to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Visit {
    pub(super) node: u32,
    /// From where the drive began to the node's beginning, along the graph `[m]`.
    pub(super) begin: f64,
    pub(super) share: f64,
    changes: u8,
    back: bool,
}

/// Tells of every node near the end of a drive from a lane's place; `open` is room to work in, of which no more than [`MOST_OPEN`]
/// is used.
pub(super) fn spread(
    map: Map<'_>,
    from: &LaneMatch,
    drive: &Drive,
    options: &MatchOptions<'_>,
    open: &mut Vec<Visit>,
    mut arrive: impl FnMut(&Visit),
) {
    open.clear();
    let lane = map.lane(from.lane).ok();
    let Some(node) = lane.and_then(|lane| lane.node_at(from.position.s, from.forward)) else {
        return;
    };
    let begin = -share_before(&node, from.position.s) * node.length();
    let own = Visit { node: node.number, begin, share: 1.0, changes: 0, back: false };
    push(open, own);
    let window = WINDOW * drive.deviation;
    let (low, high) = (drive.way - window, drive.way + window);
    go_back(&node, &own, low, open);
    let mut visits = 0;
    while let Some(visit) = likeliest(open).filter(|_| visits < MOST_VISITS) {
        visits += 1;
        let Some(node) = LaneNode::new(map, visit.node) else { continue };
        arrive(&visit);
        if visit.back {
            go_back(&node, &visit, low, open);
            continue;
        }
        let end = visit.begin + node.length();
        let changed = change(&node, &visit, drive, options, open);
        let stays = Visit { share: visit.share - changed, ..visit };
        if end < high {
            go_ahead(&node, &stays, options, open);
        }
    }
}

/// Adds a visit; to a list that is full, in place of the one with the least share.
fn push(open: &mut Vec<Visit>, visit: Visit) {
    if visit.share <= LEAST_SHARE {
        return;
    }
    if open.len() < MOST_OPEN {
        return open.push(visit);
    }
    let least = open.iter_mut().min_by(|a, b| a.share.total_cmp(&b.share));
    if let Some(least) = least.filter(|least| least.share < visit.share) {
        *least = visit;
    }
}

/// Takes the visit with the greatest share: where lanes are cut into many nodes, the limits must not end the likeliest way.
fn likeliest(open: &mut Vec<Visit>) -> Option<Visit> {
    let each = open.iter().enumerate();
    let (number, _) = each.max_by(|(_, a), (_, b)| a.share.total_cmp(&b.share))?;
    Some(open.swap_remove(number))
}

/// How much of what comes to a fork goes into a node; 0 into those that are no hypotheses.
fn prior(node: &LaneNode<'_>, options: &MatchOptions<'_>) -> f64 {
    let lane = node.lane().filter(|lane| options.types.contains(lane.kind()));
    lane.map_or(0.0, |lane| options.prior(lane.lane_id(), || Some(*node)))
}

fn go_ahead(node: &LaneNode<'_>, visit: &Visit, options: &MatchOptions<'_>, open: &mut Vec<Visit>) {
    let next = || node.edges().filter_map(|edge| edge.target());
    let sum: f64 = next().map(|node| prior(&node, options)).sum();
    for after in next().filter(|_| sum > 0.0) {
        let share = visit.share * prior(&after, options) / sum;
        let begin = visit.begin + node.length();
        push(open, Visit { node: after.number, begin, share, ..*visit });
    }
}

/// Into the nodes before, as long as they end within the window.
fn go_back(node: &LaneNode<'_>, visit: &Visit, low: f64, open: &mut Vec<Visit>) {
    if visit.begin <= low {
        return;
    }
    let share = visit.share / node.predecessors().count() as f64;
    for before in node.predecessors() {
        let begin = visit.begin - before.length();
        push(open, Visit { node: before.number, begin, share, back: true, ..*visit });
    }
}

/// Changes of lane on a node, in proportion to the part of the drive that is on it; the share that leaves.
fn change(
    node: &LaneNode<'_>,
    visit: &Visit,
    drive: &Drive,
    options: &MatchOptions<'_>,
    open: &mut Vec<Visit>,
) -> f64 {
    if visit.changes == MOST_CHANGES {
        return 0.0;
    }
    let way = drive.way.abs().max(f64::MIN_POSITIVE);
    let on_it = (visit.begin + node.length()).min(drive.way) - visit.begin.max(0.0);
    let here = if visit.begin <= 0.0 && drive.way <= 0.0 { 1.0 } else { on_it / way };
    let leaving = visit.share * drive.change * clamp(here, 0.0, 1.0);
    let mut left = 0.0;
    let sides = [
        (node.left(), node.change_left().is_some()),
        (node.right(), node.change_right().is_some()),
    ];
    for (side, allowed) in sides {
        let Some(side) = side else { continue };
        let marks = if allowed { 1.0 } else { FORBIDDEN_CHANGES };
        let share = 0.5 * leaving * marks * prior(&side, options);
        left += share;
        push(open, Visit { node: side.number, share, changes: visit.changes + 1, ..*visit });
    }
    left
}
