//! Clothoids: position from polynomial pieces, heading and curvature exact.

use crate::piecewise::{Pieces, point, point_and_derivative, reciprocal};
use crate::point::{CurveRates, Jet, LocalPoint};
use crate::primitive::SPIRAL_PIECE;
use glam::DVec2;

/// A compiled spiral.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spiral<'a> {
    curvature_start: f64,
    /// Change of curvature over the whole length `[1/m]`.
    change: f64,
    /// 1/length `[1/m]`.
    per_length: f64,
    pub(crate) pieces: Pieces<'a, SPIRAL_PIECE>,
}

impl<'a> Spiral<'a> {
    #[inline]
    pub(crate) fn new(
        curvature_start: f64,
        curvature_end: f64,
        length: f64,
        pieces: &'a [f64],
    ) -> Option<Self> {
        Some(Self {
            curvature_start,
            change: curvature_end - curvature_start,
            per_length: reciprocal(length),
            pieces: Pieces::new(pieces, length)?,
        })
    }

    /// Heading relative to the start `[rad]`.
    #[inline]
    pub(crate) fn heading(&self, u: f64) -> f64 {
        u * (self.curvature_start + 0.5 * self.change * (u * self.per_length))
    }

    #[inline]
    pub(crate) fn curvature(&self, u: f64) -> f64 {
        self.curvature_start + self.change * (u * self.per_length)
    }

    /// What the curvature changes by per metre, whatever the sign `[1/m²]`.
    pub(crate) fn curvature_change(&self) -> f64 {
        (self.change * self.per_length).abs()
    }

    pub(crate) fn rates(&self, u: f64) -> CurveRates {
        let curvature_rate = self.change * self.per_length;
        CurveRates { curvature_rate, ..CurveRates::even(self.curvature(u)) }
    }

    #[inline]
    pub(crate) fn frame(&self, u: f64) -> LocalPoint {
        let (piece, t) = self.pieces.find(u);
        let (sin, cos) = libm::sincos(self.heading(u));
        LocalPoint {
            position: point(piece, t),
            tangent: DVec2::new(cos, sin),
            curvature: self.curvature(u),
            speed: 1.0,
        }
    }

    /// The tangent comes from the polynomials here: no sine or cosine per Newton step.
    #[inline]
    pub(crate) fn jet(&self, u: f64) -> Jet {
        let (piece, t) = self.pieces.find(u);
        let (position, slope) = point_and_derivative(piece, t);
        let first = slope * self.pieces.rate();
        Jet { position, first, second: first.perp() * self.curvature(u) }
    }
}
