//! Pieces of equal length and polynomials of fixed degree.

use crate::primitive::TERMS;
use glam::DVec2;

/// Finds the piece that covers `u`, and the coordinate τ ∈ [−1, 1] in it, without searching.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pieces<'a, const N: usize> {
    pieces: &'a [[f64; N]],
    /// Pieces per metre; zero for a curve of no length.
    density: f64,
}

impl<'a, const N: usize> Pieces<'a, N> {
    /// `None` unless `numbers` is a whole, positive number of pieces.
    #[inline]
    pub(crate) fn new(numbers: &'a [f64], length: f64) -> Option<Self> {
        let (pieces, []) = numbers.as_chunks::<N>() else { return None };
        if pieces.is_empty() {
            return None;
        }
        Some(Self { pieces, density: pieces.len() as f64 * reciprocal(length) })
    }

    #[inline]
    pub(crate) fn count(&self) -> usize {
        self.pieces.len()
    }

    /// dτ/du `[1/m]`.
    #[inline]
    pub(crate) fn rate(&self) -> f64 {
        2.0 * self.density
    }

    /// The piece that covers `u`, and τ. At a joint, the later piece.
    #[inline]
    pub(crate) fn find(&self, u: f64) -> (&'a [f64; N], f64) {
        let place = u * self.density;
        // The cast saturates: not-a-number and negative values select the first piece.
        let index = (place as usize).min(self.pieces.len() - 1);
        match self.pieces.get(index) {
            Some(piece) => (piece, 2.0 * (place - index as f64) - 1.0),
            None => (&[0.0; N], -1.0),
        }
    }
}

/// 1/length, or zero where that is not a number to compute with.
#[inline]
pub(crate) fn reciprocal(length: f64) -> f64 {
    let value = 1.0 / length;
    if value.is_finite() { value } else { 0.0 }
}

/// A polynomial by Horner's rule.
#[inline]
pub(crate) fn value(coefficients: &[f64; TERMS], t: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * t + c)
}

/// A polynomial and its derivative.
#[inline]
pub(crate) fn value_and_derivative(coefficients: &[f64; TERMS], t: f64) -> (f64, f64) {
    coefficients.iter().rev().fold((0.0, 0.0), |(sum, slope), c| (sum * t + c, slope * t + sum))
}

/// Both polynomials of a piece and their first two derivatives with respect to τ.
#[inline]
pub(crate) fn derivatives(piece: &[f64; 2 * TERMS], t: f64) -> (DVec2, DVec2, DVec2) {
    let (x, y) = split_xy(piece);
    let zero = (DVec2::ZERO, DVec2::ZERO, DVec2::ZERO);
    let (value, first, half) = x.iter().zip(y).rev().fold(zero, |(value, first, half), (x, y)| {
        (value * t + DVec2::new(*x, *y), first * t + value, half * t + first)
    });
    (value, first, half * 2.0)
}

/// The third derivative of both polynomials of a piece with respect to τ.
pub(crate) fn third_derivative(piece: &[f64; 2 * TERMS], t: f64) -> DVec2 {
    let (x, y) = split_xy(piece);
    let terms = x.iter().zip(y).enumerate().skip(3).rev();
    terms.fold(DVec2::ZERO, |sum, (power, (x, y))| {
        let power = power as f64;
        sum * t + DVec2::new(*x, *y) * (power * (power - 1.0) * (power - 2.0))
    })
}

/// x(τ) and y(τ) of a spiral piece.
#[inline]
pub(crate) fn split_xy(piece: &[f64; 2 * TERMS]) -> (&[f64; TERMS], &[f64; TERMS]) {
    const NONE: &[f64; TERMS] = &[0.0; TERMS];
    (piece.first_chunk().unwrap_or(NONE), piece.last_chunk().unwrap_or(NONE))
}

/// Both polynomials of a spiral piece at once.
#[inline]
pub(crate) fn point(piece: &[f64; 2 * TERMS], t: f64) -> DVec2 {
    let (x, y) = split_xy(piece);
    DVec2::new(value(x, t), value(y, t))
}

/// Both polynomials of a spiral piece and their derivatives with respect to τ.
#[inline]
pub(crate) fn point_and_derivative(piece: &[f64; 2 * TERMS], t: f64) -> (DVec2, DVec2) {
    let (x, y) = split_xy(piece);
    let ((x, dx), (y, dy)) = (value_and_derivative(x, t), value_and_derivative(y, t));
    (DVec2::new(x, y), DVec2::new(dx, dy))
}
