//! The rectangle around one segment of the index, apart from its leaf.

use crate::held::slack;
use crate::index::PRODUCTS;
use glam::DVec2;
use mapd_archive::ArchivedIndexLeafRow;
use mapd_archive::packed_index::{ANY, REACH_UNIT};

/// The square of the distance from the line through a segment, times the square of the segment's length.
pub(super) struct Beside(f32);

/// What [`crate::index::places_around`] tests for one place of a leaf, in the same numbers.
#[derive(Clone, Copy)]
pub(super) struct Rectangle {
    /// The leaf's corner.
    corner: DVec2,
    start: [f32; 2],
    delta: [f32; 2],
    /// Square of the segment's length.
    squared: f32,
    /// Squares of how far the rectangle reaches sideways, and ahead and back, times that.
    reach: f32,
    overshoot: f32,
    /// How far the lane's centre may be from the line through the segment `[m]`.
    slack: f32,
}

impl Rectangle {
    /// One that holds nothing.
    pub(super) const NOWHERE: Self = Self {
        corner: DVec2::ZERO,
        start: [0.0; 2],
        delta: [0.0; 2],
        squared: 0.0,
        reach: -1.0,
        overshoot: -1.0,
        slack: f32::INFINITY,
    };

    /// Of the k-th place; `k` is below the leaf's width. The tolerance is the map's.
    pub(super) fn of(leaf: &ArchivedIndexLeafRow, k: usize, tolerance: f32) -> Self {
        let step = leaf.step();
        let place = |values: &[u16; 16]| f32::from(values[k]);
        let (start_x, start_y) = (place(leaf.start_x()), place(leaf.start_y()));
        let delta =
            [(place(leaf.end_x()) - start_x) * step, (place(leaf.end_y()) - start_y) * step];
        let length = delta[0] * delta[0] + delta[1] * delta[1];
        let squared = if length > f32::MIN_POSITIVE { length } else { f32::MIN_POSITIVE };
        let square = |units: u16| {
            let distance = if units == ANY { f32::INFINITY } else { f32::from(units) * REACH_UNIT };
            distance * distance * (squared * PRODUCTS)
        };
        Self {
            corner: DVec2::new(f64::from(leaf.x()), f64::from(leaf.y())),
            start: [start_x * step, start_y * step],
            delta,
            squared,
            reach: square(leaf.reach()[k]),
            overshoot: square(leaf.overshoot()[k]),
            slack: slack(tolerance, step),
        }
    }

    /// If it holds a point (relative to the local origin), how far that lies beside the line through the segment. What is no number is not outside.
    #[inline(always)]
    pub(super) fn holds(&self, local: DVec2) -> Option<Beside> {
        let (qx, qy) = ((local.x - self.corner.x) as f32, (local.y - self.corner.y) as f32);
        let (ex, ey) = (qx - self.start[0], qy - self.start[1]);
        let [dx, dy] = self.delta;
        let forward = ex * dx + ey * dy;
        let sideways = ex * dy - ey * dx;
        let past = (-forward).max(forward - self.squared).max(0.0);
        let beside = sideways * sideways > self.reach;
        let beyond = past * past > self.overshoot;
        (!(beside | beyond)).then_some(Beside(sideways * sideways))
    }

    /// The lane's centre is not nearer than this `[m]`.
    #[inline]
    pub(super) fn off_center(&self, Beside(beside): Beside) -> f32 {
        (beside / (self.squared * PRODUCTS)).sqrt() - self.slack
    }
}
