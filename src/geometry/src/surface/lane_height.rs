//! Lanes that lie above or below the road's surface.

use super::{Along, Height};

/// What a lane's `height` record raises its edges by `[m]` (OpenDRIVE 1.8.1, 11.7.4), held constant until the next record.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LaneRise {
    /// At the edge nearer to lane 0.
    pub inner: f64,
    /// At the edge away from lane 0.
    pub outer: f64,
}

/// Offset of the surface at `t`, linear between the edges of the lane at t = `inner` and t = `outer` `[m]`.
///
/// A lane of no width rises as its inner edge does. Beyond an edge its height holds.
#[must_use]
pub fn lane_height(rise: LaneRise, inner: Along, outer: Along, t: f64) -> Height {
    let width = outer.value - inner.value;
    let share = if width == 0.0 { 0.0 } else { (t - inner.value) / width };
    if share <= 0.0 {
        return Height { h: rise.inner, ..Height::default() };
    }
    if share >= 1.0 {
        return Height { h: rise.outer, ..Height::default() };
    }
    let step = rise.outer - rise.inner;
    let share_by_s = -(inner.by_s + share * (outer.by_s - inner.by_s)) / width;
    Height { h: rise.inner + step * share, by_s: step * share_by_s, by_t: step / width }
}
