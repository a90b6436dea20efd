//! Lower bounds of what is left to a target, from landmarks (Goldberg and Harrelson's ALT).
//!
//! For a landmark L and any node v: the way from v to the target t costs at least d(L, t) − d(L, v) and at least
//! d(v, L) − d(t, L). The archive stores distances that count a price for each change of lane, rounded down to a step: what
//! is left after one step more is taken off is a bound. Where the caller's changes cost less, it holds in proportion: with
//! n changes, L + n·p ≥ min(1, p/q)·(L + n·q).
//!
//! Anchors alone have distances: a way of length w leads from an anchor a to the node v, so that the rest from v costs at least
//! the rest from a less w. In the same way a target is replaced by the next anchor ahead of it.

use super::cost::CostBound;
use crate::graph::LaneNode;
use crate::lane::edges_of;
use crate::map::Map;
use mapd_archive::{ArchivedLaneNodeRow, NONE, VehicleClass};

/// Landmarks that a search looks at; an archive may have more.
const MOST: usize = 32;
/// Nodes on the way from a target to an anchor: a way from an anchor forks once, and what it leads to is one, or ends it.
/// Without an anchor after so many there are no bounds.
const MOST_AHEAD: usize = 4096;
/// Share of a bound that is used, so that rounding of sums cannot make it too large.
const SAFE: f64 = 1.0 - 1e-9;

/// Bounds towards one target.
pub(super) struct Bounds<'a> {
    distances: &'a [u16],
    /// Entries per node: from each landmark, then to each.
    width: usize,
    /// From each landmark to the target, then from the target to each, as they enter the difference.
    target: [u16; 2 * MOST],
    /// Cost per unit of a difference; 0 where there are no bounds.
    step: f64,
    /// Steps from the target to the anchor ahead of it that bounds lead to.
    beyond: u16,
    /// Whether distances are times.
    times: bool,
}

impl<'a> Bounds<'a> {
    /// Bounds towards a node; none without landmarks.
    pub(super) fn new(map: Map<'a>, bound: CostBound, target: &LaneNode<'a>) -> Self {
        let tables = map.tables();
        let times = matches!(bound, CostBound::PerSecond { .. });
        let none =
            Self { distances: &[], width: 0, target: [0; 2 * MOST], step: 0.0, beyond: 0, times };
        let Some(graph) = tables.graph.first() else { return none };
        let (distances, step, cost, change, stored) = match bound {
            CostBound::None => return none,
            CostBound::PerMetre { metre, change } => {
                let stored = graph.change_length();
                (tables.landmark_lengths, graph.length_step(), metre, change, stored)
            }
            CostBound::PerSecond { second, change } => {
                let stored = graph.change_time();
                (tables.landmark_times, graph.time_step(), second, change, stored)
            }
        };
        let step = step * cost.min(change / stored);
        let count = graph.landmarks() as usize;
        let width = 2 * count;
        if count == 0 || count > MOST || !(step > 0.0 && step.is_finite()) {
            return none;
        }
        let steps = Steps { length: graph.length_step(), time: graph.time_step(), times };
        let Some((place, beyond)) = steps.anchor_ahead(map, target) else { return none };
        let at = place as usize * width;
        let Some(row) = distances.get(at..at + width) else { return none };
        let mut target = [0; 2 * MOST];
        for (i, (own, stored)) in target.iter_mut().zip(row).enumerate() {
            // No way from the landmark says nothing; no way to it neither. Both make the difference 0.
            *own = if i < count && *stored == u16::MAX { 0 } else { *stored };
        }
        Self { distances, width, target, step: step * SAFE, beyond, times }
    }

    /// Least cost from the beginning of a node to that of the target.
    #[inline]
    pub(super) fn least(&self, node: &ArchivedLaneNodeRow) -> f64 {
        let place = node.bound();
        if self.step == 0.0 || place == NONE {
            return 0.0;
        }
        let at = place as usize * self.width;
        let Some(row) = self.distances.get(at..at + self.width) else { return 0.0 };
        let count = self.width / 2;
        let mut most = 0u16;
        for (own, target) in row[..count].iter().zip(&self.target[..count]) {
            most = most.max(target.saturating_sub(*own));
        }
        for (own, target) in row[count..].iter().zip(&self.target[count..self.width]) {
            most = most.max(own.saturating_sub(*target));
        }
        // The way from the node's anchor is not left any more, that from the target to its anchor never was.
        let way = if self.times { node.anchor_time() } else { node.anchor_length() };
        f64::from(most.saturating_sub(1).saturating_sub(way).saturating_sub(self.beyond))
            * self.step
    }
}

/// Steps of the tables.
struct Steps {
    length: f64,
    time: f64,
    times: bool,
}

impl Steps {
    /// Place of the next anchor from a node's beginning on, and the steps up to it, rounded up.
    fn anchor_ahead(&self, map: Map<'_>, node: &LaneNode<'_>) -> Option<(u32, u16)> {
        let tables = map.tables();
        let (mut node, mut way) = (*node, 0f64);
        for _ in 0..MOST_AHEAD {
            if node.row.bound() == NONE {
                return None;
            }
            if node.row.anchor_length() == 0 {
                return Some((node.row.bound(), way.ceil() as u16))
                    .filter(|_| way < f64::from(u16::MAX));
            }
            way += if self.times {
                node.travel_time() / self.time
            } else {
                node.length() / self.length
            };
            let ahead = edges_of(tables.successor_offsets, tables.successors, node.number);
            let motor = |node: &LaneNode<'_>| node.row.access() & VehicleClass::MOTOR != 0;
            node = ahead.iter().find_map(|next| LaneNode::new(map, *next).filter(motor))?;
        }
        None
    }
}
