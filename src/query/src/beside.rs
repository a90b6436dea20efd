//! How a line runs that lies beside a reference line: the centre of a lane, or what is driven.

use crate::profile::{At, Bend, Slope};
use crate::road::Road;
use mapd_geometry::CurveRates;

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

    /// By how much traffic that runs as [`Self::driven`] turns off the reference line, to the left `[rad]`, in [−π/2, π/2].
    #[inline]
    pub(crate) fn turn(&self, line: [f64; 2]) -> f64 {
        let [ahead, left] = self.driven(line);
        mapd_geometry::atan2(left, ahead)
    }

    /// Curvature of the line in plan view, as traffic runs along it `[1/m]`, positive to the left; 0 where the line stands still. `t` is the second derivative
    /// of t along s, `roll` the superelevation.
    pub(crate) fn curvature(&self, line: &CurveRates, t: f64, roll: &Bend) -> f64 {
        let Self { t: own, roll: (cos, sin), .. } = self;
        let CurveRates { speed, speed_rate, curvature, curvature_rate } = *line;
        let turned = roll.slope.derivative;
        let lateral = own.value * cos;
        let left = own.derivative * cos - own.value * sin * turned;
        let left_rate = t * cos
            - 2.0 * own.derivative * sin * turned
            - own.value * (cos * turned * turned + sin * roll.second);
        let stretch = 1.0 - curvature * lateral;
        let ahead = speed * stretch;
        let ahead_rate =
            speed_rate * stretch - speed * (curvature_rate * lateral + curvature * left);
        let square = ahead * ahead + left * left;
        if square == 0.0 {
            return 0.0;
        }
        let turning = speed * curvature + (ahead * left_rate - left * ahead_rate) / square;
        turning / square.sqrt().copysign(ahead)
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
