//! Compiling clothoids.

use super::chebyshev::{SERIES, shorten};
use super::{CompileError, Compiled, MAX_PIECES, rounding};
use crate::primitive::{CurveKind, SPIRAL_PIECE, TERMS};
use glam::DVec2;

/// Most that a piece turns by at the larger curvature of the spiral `[rad]`. The power series below converges to full
/// precision within [`SERIES`] terms there.
const PIECE_TURNING: f64 = 0.5;

/// Position error allowed to the pieces `[m]`, far below the 1e-9 m promised, because it costs next to nothing: error
/// falls with the tenth power of the number of pieces.
const TOLERANCE: f64 = 1e-11;

/// Error allowed per metre of length, for spirals so long that [`TOLERANCE`] is below the rounding of a coordinate.
const RELATIVE_TOLERANCE: f64 = 1e-14;

/// Cuts the spiral into as few pieces of equal length as the tolerance allows.
pub(super) fn compile(from: f64, to: f64, length: f64) -> Result<Compiled, CompileError> {
    let turning = from.abs().max(to.abs()) * length;
    let tolerance = TOLERANCE.max(RELATIVE_TOLERANCE * length);
    let mut count = (libm::ceil(turning / PIECE_TURNING) as usize).clamp(1, MAX_PIECES);
    loop {
        let (coefficients, error) = cut(from, to, length, count);
        if error <= tolerance {
            return Ok(Compiled {
                kind: CurveKind::Spiral,
                coefficients,
                error: error + rounding(length) * (1.0 + turning),
                length_mismatch: 0.0,
            });
        }
        if count == MAX_PIECES {
            return Err(CompileError::TooManyPieces { error });
        }
        count = (count + count.div_ceil(4)).min(MAX_PIECES);
    }
}

/// The coefficients for `count` pieces, and the bound of their error `[m]`.
fn cut(from: f64, to: f64, length: f64, count: usize) -> (Vec<f64>, f64) {
    let mut coefficients = Vec::with_capacity(2 + count * SPIRAL_PIECE);
    coefficients.extend([from, to]);
    let half = 0.5 * length / count as f64;
    // ½·(dκ/du)·half², the quadratic part of the heading in τ.
    let quadratic = (to - from) * half / (4.0 * count as f64);
    let mut joint = DVec2::ZERO;
    let mut worst = 0.0_f64;
    for index in 0..count {
        let ratio = (index as f64 + 0.5) / count as f64;
        let middle = ratio * length;
        let curvature = from + (to - from) * ratio;
        let heading = middle * (from + 0.5 * (to - from) * ratio);
        let (sin, cos) = libm::sincos(heading);
        let turn = DVec2::new(cos, sin) * half;
        let series = displacement(curvature * half, quadratic);
        // The ends of the piece relative to its middle, from the whole series so that no error adds up.
        let (mut behind, mut ahead) = (DVec2::ZERO, DVec2::ZERO);
        for (power, term) in series.iter().enumerate().rev() {
            ahead += *term;
            behind += if power % 2 == 0 { *term } else { -*term };
        }
        let centre = joint - turn.rotate(behind);
        joint = centre + turn.rotate(ahead);

        let placed = series.map(|term| turn.rotate(term));
        let (mut x, x_error) = shorten(placed.map(|term| term.x));
        let (mut y, y_error) = shorten(placed.map(|term| term.y));
        x[0] += centre.x;
        y[0] += centre.y;
        worst = worst.max(libm::hypot(x_error, y_error));
        coefficients.extend::<[f64; TERMS]>(x);
        coefficients.extend::<[f64; TERMS]>(y);
    }
    (coefficients, worst)
}

/// The power series of ∫₀^τ exp(i(aτ + bτ²)) dτ as (real, imaginary) coefficients.
///
/// The integrand f obeys f′ = i(a + 2bτ)·f, hence (k + 1)·f_{k+1} = i(a·f_k + 2b·f_{k−1}). No term is divided by b or a,
/// so arcs and straight lines are not special.
fn displacement(a: f64, b: f64) -> [DVec2; SERIES] {
    let mut series = [DVec2::ZERO; SERIES];
    let (mut previous, mut current) = (DVec2::ZERO, DVec2::X);
    for (k, term) in series.iter_mut().enumerate().skip(1) {
        *term = current / k as f64;
        let next = (current * a + previous * (2.0 * b)).perp() / k as f64;
        (previous, current) = (current, next);
    }
    series
}
