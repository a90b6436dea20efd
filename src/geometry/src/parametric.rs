//! Plane cubics u(p), v(p) run through by arc length: poly3 (with u(p) = p) and paramPoly3.

use crate::piecewise::{Pieces, value, value_and_derivative};
use crate::point::{CurveRates, Jet, LocalPoint};
use crate::primitive::PARAMETER_PIECE;
use core::f64::consts::TAU;
use glam::DVec2;

/// u(p) = p: the abscissa of a poly3.
pub(crate) const IDENTITY: &[f64; 4] = &[0.0, 1.0, 0.0, 0.0];

/// The two cubics, in ascending order of power.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cubics<'a> {
    pub(crate) u: &'a [f64; 4],
    pub(crate) v: &'a [f64; 4],
}

impl Cubics<'_> {
    #[inline]
    pub(crate) fn position(&self, p: f64) -> DVec2 {
        let cubic = |[a, b, c, d]: &[f64; 4]| a + p * (b + p * (c + p * d));
        DVec2::new(cubic(self.u), cubic(self.v))
    }

    /// dr/dp: direction of travel, length = speed.
    #[inline]
    pub(crate) fn first(&self, p: f64) -> DVec2 {
        let slope = |[_, b, c, d]: &[f64; 4]| b + p * (2.0 * c + p * (3.0 * d));
        DVec2::new(slope(self.u), slope(self.v))
    }

    /// d²r/dp².
    #[inline]
    pub(crate) fn second(&self, p: f64) -> DVec2 {
        let bend = |[_, _, c, d]: &[f64; 4]| 2.0 * c + p * (6.0 * d);
        DVec2::new(bend(self.u), bend(self.v))
    }

    /// d³r/dp³, the same everywhere.
    #[inline]
    pub(crate) fn third(&self) -> DVec2 {
        6.0 * DVec2::new(self.u[3], self.v[3])
    }

    /// |dr/dp| and the curvature.
    #[inline]
    pub(crate) fn speed_and_curvature(&self, p: f64) -> [f64; 2] {
        let (first, second) = (self.first(p), self.second(p));
        let length = first.length();
        [length, first.perp_dot(second) / (length * length * length)]
    }

    /// Direction of travel at `p` relative to the frame's x axis `[rad]`, continuous in p from its value at p = 0.
    ///
    /// dr/dp is quadratic in p, so its cross product with its own start is p·(A + B·p): besides p = 0 it vanishes at
    /// one place only. If the direction there is opposite to that of the start, it crosses the cut of atan2 there.
    pub(crate) fn heading(&self, p: f64) -> f64 {
        let start = self.first(0.0);
        let (c, d) = (self.second(0.0), DVec2::new(3.0 * self.u[3], 3.0 * self.v[3]));
        let (linear, quadratic) = (start.perp_dot(c), start.perp_dot(d));
        let crossing = -linear / quadratic;
        let now = self.first(p);
        // p·(A + B·p) instead of the cross product: its sign then agrees with `crossing`.
        let turned = libm::atan2(p * (linear + quadratic * p), start.dot(now));
        let wrapped = crossing > 0.0 && p > crossing && start.dot(self.first(crossing)) < 0.0;
        let turns = if wrapped { TAU.copysign(linear) } else { 0.0 };
        libm::atan2(start.y, start.x) + (turned + turns)
    }
}

/// A compiled poly3 or paramPoly3.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parametric<'a> {
    pub(crate) cubics: Cubics<'a>,
    pub(crate) pieces: Pieces<'a, PARAMETER_PIECE>,
}

impl Parametric<'_> {
    /// The curve parameter at `u`.
    #[inline]
    pub(crate) fn parameter(&self, u: f64) -> f64 {
        let (piece, t) = self.pieces.find(u);
        value(piece, t)
    }

    #[inline]
    pub(crate) fn heading(&self, u: f64) -> f64 {
        self.cubics.heading(self.parameter(u))
    }

    #[inline]
    pub(crate) fn frame(&self, u: f64) -> LocalPoint {
        let p = self.parameter(u);
        let (first, second) = (self.cubics.first(p), self.cubics.second(p));
        let per_speed = 1.0 / first.length();
        LocalPoint {
            position: self.cubics.position(p),
            tangent: first * per_speed,
            curvature: first.perp_dot(second) * (per_speed * per_speed * per_speed),
            speed: 1.0,
        }
    }

    /// |dr/du| and the curvature.
    #[inline]
    pub(crate) fn speed_and_curvature(&self, u: f64) -> [f64; 2] {
        let (piece, t) = self.pieces.find(u);
        let (p, slope) = value_and_derivative(piece, t);
        let [speed, curvature] = self.cubics.speed_and_curvature(p);
        [speed * slope.abs() * self.pieces.rate(), curvature]
    }

    pub(crate) fn rates(&self, u: f64) -> CurveRates {
        let (piece, t) = self.pieces.find(u);
        let (p, slope) = value_and_derivative(piece, t);
        let slope = slope.abs() * self.pieces.rate();
        let derivatives = [self.cubics.first(p), self.cubics.second(p), self.cubics.third()];
        // It is run through by its length: what is left of the change of speed is what rounding leaves.
        CurveRates { speed_rate: 0.0, ..CurveRates::of(derivatives, slope) }
    }

    #[inline]
    pub(crate) fn jet(&self, u: f64) -> Jet {
        let (piece, t) = self.pieces.find(u);
        let (p, slope) = value_and_derivative(piece, t);
        let rate = slope * self.pieces.rate();
        Jet {
            position: self.cubics.position(p),
            first: self.cubics.first(p) * rate,
            // The missing term (dr/dp)·p'' is along `first`.
            second: self.cubics.second(p) * (rate * rate),
        }
    }
}
