//! Curves that were moved into another plane: position from polynomial pieces, direction and curvature from their derivatives.

use crate::piecewise::{Pieces, derivatives, third_derivative};
use crate::point::{CurveRates, Jet, LocalPoint};
use crate::primitive::{TERMS, TRANSFORMED_PIECE};
use glam::DVec2;

/// Tangent of an angle below which four terms of the arc tangent's series are exact to 1e-19.
const NEARLY_STRAIGHT: f64 = 0.01;

/// A compiled transformed curve. Its speed |dr/du| is the local scale of the transformation, not 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Transformed<'a> {
    pub(crate) pieces: Pieces<'a, TRANSFORMED_PIECE>,
}

/// x(τ) and y(τ), which follow the heading of the piece's middle.
#[inline]
fn split(piece: &[f64; TRANSFORMED_PIECE]) -> &[f64; 2 * TERMS] {
    const NONE: &[f64; 2 * TERMS] = &[0.0; 2 * TERMS];
    piece.last_chunk().unwrap_or(NONE)
}

impl Transformed<'_> {
    /// Heading relative to the start `[rad]` of the unit tangent at `u`, continuous: a piece turns by less than half a circle from
    /// its middle.
    #[inline]
    pub(crate) fn heading(&self, u: f64, tangent: DVec2) -> f64 {
        let (piece, _) = self.pieces.find(u);
        let [middle, ..] = *piece;
        // The slope at the middle.
        let at_middle = DVec2::new(piece[2], piece[2 + TERMS]);
        let (aside, along) = (at_middle.perp_dot(tangent), at_middle.dot(tangent));
        let ratio = aside / along;
        middle
            + if along > 0.0 && ratio.abs() < NEARLY_STRAIGHT {
                let square = ratio * ratio;
                ratio * (1.0 - square * (1.0 / 3.0 - square * (0.2 - square * (1.0 / 7.0))))
            } else {
                libm::atan2(aside, along)
            }
    }

    #[inline]
    pub(crate) fn frame(&self, u: f64) -> LocalPoint {
        let (piece, t) = self.pieces.find(u);
        let (position, first, second) = derivatives(split(piece), t);
        let length = first.length();
        let per_length = 1.0 / length;
        LocalPoint {
            position,
            tangent: first * per_length,
            curvature: first.perp_dot(second) * (per_length * per_length * per_length),
            speed: length * self.pieces.rate(),
        }
    }

    #[inline]
    pub(crate) fn jet(&self, u: f64) -> Jet {
        let (piece, t) = self.pieces.find(u);
        let (position, first, second) = derivatives(split(piece), t);
        let rate = self.pieces.rate();
        Jet { position, first: first * rate, second: second * (rate * rate) }
    }

    pub(crate) fn rates(&self, u: f64) -> CurveRates {
        let (piece, t) = self.pieces.find(u);
        let (_, first, second) = derivatives(split(piece), t);
        CurveRates::of([first, second, third_derivative(split(piece), t)], self.pieces.rate())
    }

    #[inline]
    pub(crate) fn curvature(&self, u: f64) -> f64 {
        self.frame(u).curvature
    }
}

/// What a piece stores.
pub(crate) fn piece(heading: f64, x: &[f64; TERMS], y: &[f64; TERMS]) -> [f64; TRANSFORMED_PIECE] {
    let mut piece = [heading; TRANSFORMED_PIECE];
    let (for_x, for_y) = piece[1..].split_at_mut(TERMS);
    for_x.copy_from_slice(x);
    for_y.copy_from_slice(y);
    piece
}

/// Direction of a piece's middle, up to its length.
pub(crate) fn middle_slope(x: &[f64; TERMS], y: &[f64; TERMS]) -> DVec2 {
    DVec2::new(x[1], y[1])
}
