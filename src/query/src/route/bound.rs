//! Lower bounds of what is left to a target, from landmarks (Goldberg and Harrelson's ALT).
//!
//! For a landmark L and any node v: the way from v to the target t costs at least d(L, t) − d(L, v) and at least
//! d(v, L) − d(t, L). The archive stores distances that count a price for each change of lane, rounded down to a step: what
//! is left after one step more is taken off is a bound. Where the caller's changes cost less, it holds in proportion: with
//! n changes, L + n·p ≥ min(1, p/q)·(L + n·q).
//!
//! Anchors alone have distances: a way of length w leads from an anchor a to the node v, so that the rest from v costs at least
//! the rest from a less w. What a target's distances are is found from the anchors around it, once for a search (`Around`).

use super::around::NearAnchors;
use super::cost::CostBound;
use crate::graph::LaneNode;
use crate::map::Map;
use mapd_archive::{ArchivedLaneNodeRow, NONE};

/// Landmarks that a search looks at; an archive may have more.
const MOST: usize = 32;
/// Share of a bound that is used, so that rounding of sums cannot make it too large.
const SAFE: f64 = 1.0 - 1e-9;

/// Bounds towards one target.
pub(crate) struct Bounds<'a> {
    distances: &'a [u16],
    /// Entries per node: from each landmark, then to each.
    width: usize,
    /// From each landmark to the target, then from the target to each, as they enter the difference.
    target: [u16; 2 * MOST],
    /// Cost per unit of a difference; 0 where there are no bounds.
    step: f64,
    /// Whether distances are times.
    pub(crate) times: bool,
    /// Least cost of a metre or second.
    pub(crate) per_unit: f64,
}

impl<'a> Bounds<'a> {
    /// Bounds towards a node; none without landmarks.
    pub(super) fn new(map: Map<'a>, bound: CostBound, target: &LaneNode<'a>) -> Self {
        let tables = map.tables();
        let times = matches!(bound, CostBound::PerSecond { .. });
        let per_unit = match bound {
            CostBound::None => 0.0,
            CostBound::PerMetre { metre, .. } => metre,
            CostBound::PerSecond { second, .. } => second,
        };
        let none =
            Self { distances: &[], width: 0, target: [0; 2 * MOST], step: 0.0, times, per_unit };
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
        let (unit, change) = match times {
            true => (graph.time_step(), graph.change_time()),
            false => (graph.length_step(), graph.change_length()),
        };
        let around = NearAnchors::new(map, target, times, change);
        let row = |place: u32| distances.get(place as usize * width..)?.get(..width);
        // Nothing known of a landmark: differences become 0.
        let mut target = [0; 2 * MOST];
        target[count..width].fill(u16::MAX);
        let (from, to) = target.split_at_mut(count);
        // To the target at least the least over the anchors behind it, of those that a landmark has a way to.
        let mut least = [u16::MAX; MOST];
        for (place, way) in around.behind() {
            let Some(row) = row(place) else { continue };
            let way = (way / unit) as u16;
            for (least, stored) in least.iter_mut().zip(&row[..count]) {
                // What there is a way to is no farther than one step before the mark for none.
                let whole = stored.saturating_add(way).min(u16::MAX - 1);
                *least = (*least).min(if *stored == u16::MAX { u16::MAX } else { whole });
            }
        }
        for (own, least) in from.iter_mut().zip(least) {
            *own = if least == u16::MAX { 0 } else { least };
        }
        // From the target at most the way by any anchor ahead.
        for (place, way) in around.ahead() {
            let Some(row) = row(place) else { continue };
            let way = (way / unit).ceil() as u16;
            for (own, stored) in to.iter_mut().zip(&row[count..]) {
                *own = (*own).min(stored.saturating_add(way));
            }
        }
        Self { distances, width, target, step: step * SAFE, times, per_unit }
    }

    /// Least cost from the beginning of a node to that of the target.
    #[inline]
    pub(crate) fn least(&self, node: &ArchivedLaneNodeRow) -> f64 {
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
        // The way from the node's anchor is behind.
        let way = if self.times { node.anchor_time() } else { node.anchor_length() };
        f64::from(most.saturating_sub(1).saturating_sub(way)) * self.step
    }
}
