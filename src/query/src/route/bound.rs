//! Lower bounds of what is left to a target, from landmarks (Goldberg and Harrelson's ALT).
//!
//! For a landmark L and any node v: the way from v to the target t costs at least d(L, t) − d(L, v) and at least
//! d(v, L) − d(t, L). The archive stores distances that count a price for each change of lane, rounded down to a step: what
//! is left after one step more is taken off is a bound. Where the caller's changes cost less, it holds in proportion: with
//! n changes, L + n·p ≥ min(1, p/q)·(L + n·q).

use super::cost::CostBound;
use crate::map::Map;
use mapd_archive::NONE;

/// Landmarks that a search looks at; an archive may have more.
const MOST: usize = 32;
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
}

impl<'a> Bounds<'a> {
    /// Bounds towards a node by its place in the tables; none without landmarks.
    pub(super) fn new(map: Map<'a>, bound: CostBound, place: u32) -> Self {
        let tables = map.tables();
        let none = Self { distances: &[], width: 0, target: [0; 2 * MOST], step: 0.0 };
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
        if count == 0 || count > MOST || place == NONE || !(step > 0.0 && step.is_finite()) {
            return none;
        }
        let at = place as usize * width;
        let Some(row) = distances.get(at..at + width) else { return none };
        let mut target = [0; 2 * MOST];
        for (i, (own, stored)) in target.iter_mut().zip(row).enumerate() {
            // No way from the landmark says nothing; no way to it neither. Both make the difference 0.
            *own = if i < count && *stored == u16::MAX { 0 } else { *stored };
        }
        Self { distances, width, target, step: step * SAFE }
    }

    /// Least cost from the beginning of a node to that of the target.
    #[inline]
    pub(super) fn least(&self, place: u32) -> f64 {
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
        f64::from(most.saturating_sub(1)) * self.step
    }
}
