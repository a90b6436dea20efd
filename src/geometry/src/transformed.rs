//! Curves that were moved into another plane: position from polynomial pieces, direction and curvature from their derivatives.

use crate::piecewise::{Pieces, derivatives, point_and_derivative};
use crate::point::{Frame, Jet};
use crate::primitive::{TERMS, TRANSFORMED_PIECE};
use glam::DVec2;

/// A compiled transformed curve. Its speed |dr/du| is the local scale of the transformation, not 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Transformed<'a> {
    pub(crate) pieces: Pieces<'a, TRANSFORMED_PIECE>,
}

/// The heading of a piece's middle relative to the start `[rad]`, and x(τ), y(τ).
#[inline]
fn split(piece: &[f64; TRANSFORMED_PIECE]) -> (f64, &[f64; 2 * TERMS]) {
    const NONE: &[f64; 2 * TERMS] = &[0.0; 2 * TERMS];
    let [heading, ..] = *piece;
    (heading, piece.last_chunk().unwrap_or(NONE))
}

impl Transformed<'_> {
    /// Heading relative to the start `[rad]`, continuous: a piece turns by less than half a circle from its middle.
    pub(crate) fn heading(&self, u: f64) -> f64 {
        let (piece, t) = self.pieces.find(u);
        let (middle, xy) = split(piece);
        let (_, slope) = point_and_derivative(xy, t);
        let (_, at_middle) = point_and_derivative(xy, 0.0);
        middle + libm::atan2(at_middle.perp_dot(slope), at_middle.dot(slope))
    }

    #[inline]
    pub(crate) fn frame(&self, u: f64) -> Frame {
        let (piece, t) = self.pieces.find(u);
        let (position, first, second) = derivatives(split(piece).1, t);
        let length = first.length();
        let per_length = 1.0 / length;
        Frame {
            position,
            tangent: first * per_length,
            curvature: first.perp_dot(second) * (per_length * per_length * per_length),
            speed: length * self.pieces.rate(),
        }
    }

    #[inline]
    pub(crate) fn jet(&self, u: f64) -> Jet {
        let (piece, t) = self.pieces.find(u);
        let (position, first, second) = derivatives(split(piece).1, t);
        let rate = self.pieces.rate();
        Jet { position, first: first * rate, second: second * (rate * rate) }
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
