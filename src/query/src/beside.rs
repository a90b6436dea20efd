//! How a line runs that lies beside a reference line: the centre of a lane, or what is driven.

use crate::profile::{At, Slope};
use crate::road::Road;

/// Where such a line lies at a place of the road, and how the road is rolled there.
#[derive(Clone, Copy)]
pub(crate) struct Beside {
    /// t with its growth along s.
    pub(crate) t: Slope,
    /// Cosine and sine of the superelevation.
    roll: (f64, f64),
    /// Growth of the superelevation along s `[rad/m]`; 0 where the road is level across.
    turned: f64,
}

impl Beside {
    /// A line at t, where the superelevation has this cosine and sine.
    #[inline]
    pub(crate) fn new(road: &Road<'_>, at: At, roll: (f64, f64), t: Slope) -> Self {
        let turned = if roll.1 == 0.0 { 0.0 } else { road.superelevation_slope(at) };
        Self { t, roll, turned }
    }

    /// Metres ahead and to the left per metre of s, in plan view; `speed` is that of the reference line, which passes
    /// 1 − κ·t·cos σ of its own length beside it. The lateral place in plan view is t(s)·cos σ(s).
    #[inline]
    pub(crate) fn run(&self, [speed, curvature]: [f64; 2]) -> [f64; 2] {
        let Self { t, roll: (cos, sin), turned } = self;
        let ahead = speed * (1.0 - curvature * t.value * cos);
        [ahead, t.derivative * cos - t.value * sin * turned]
    }

    /// As [`Self::run`], as traffic runs: beyond the centre of curvature the line runs backwards, traffic does not.
    #[inline]
    pub(crate) fn driven(&self, line: [f64; 2]) -> [f64; 2] {
        let [ahead, left] = self.run(line);
        [ahead.abs(), if ahead < 0.0 { -left } else { left }]
    }

    /// Metres of the line per metre of s in plan view.
    #[inline]
    pub(crate) fn growth(&self, line: [f64; 2]) -> f64 {
        length(self.run(line))
    }
}

/// Metres of a line per metre of s in plan view, by those ahead and to the left.
#[inline]
pub(crate) fn length([ahead, left]: [f64; 2]) -> f64 {
    (ahead * ahead + left * left).sqrt()
}
