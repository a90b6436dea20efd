//! Spirals (OpenDRIVE 1.8.1, 9.3.3): heading is exact, positions are polynomials per piece.
//!
//! The classic form by Fresnel integrals cancels badly where the curvature hardly changes; here curvature may change
//! sign or not at all.

use crate::gauss::integrate2;
use crate::polynomial::{self, COEFFICIENTS};
use crate::primitive::{CompileError, MAX_PIECES};

/// Numbers of a piece: x and y over [−1, 1].
pub(crate) const PIECE: usize = 2 * COEFFICIENTS;
/// Turn per piece `[rad]` up to which degree 9 stays below 1e-10 m.
const TURN: f64 = 0.25;
/// Accepted error of a fit `[m]`; pieces are halved until it holds.
const ERROR: f64 = 1e-10;
/// Places in a piece at which the fit is compared with quadrature.
const PROBES: usize = 16;
/// Rounding of the sums `[relative to the length]`.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Heading at u relative to the start `[rad]`.
#[inline]
pub(crate) fn turn(start: f64, end: f64, length: f64, u: f64) -> f64 {
    u * (start + 0.5 * rate(start, end, length) * u)
}

/// Change of curvature `[1/m²]`.
#[inline]
pub(crate) fn rate(start: f64, end: f64, length: f64) -> f64 {
    if length > 0.0 { (end - start) / length } else { 0.0 }
}

/// Appends pieces in the start's frame; returns their error `[m]`.
pub(crate) fn pieces(
    start: f64,
    end: f64,
    length: f64,
    out: &mut Vec<f64>,
) -> Result<f64, CompileError> {
    if length == 0.0 {
        return Ok(0.0);
    }
    let needed = (start.abs().max(end.abs()) * length / TURN).ceil().max(1.0);
    if needed > MAX_PIECES as f64 {
        return Err(CompileError::TooManyPieces(needed));
    }
    let mut count = needed as usize;
    let before = out.len();
    loop {
        out.truncate(before);
        let error = fit(start, end, length, count, out);
        if error <= ERROR || count * 2 > MAX_PIECES {
            return Ok(error + length * ROUNDING);
        }
        count *= 2;
    }
}

fn fit(start: f64, end: f64, length: f64, count: usize, out: &mut Vec<f64>) -> f64 {
    let tangent = |u: f64| {
        let (sin, cos) = libm::sincos(turn(start, end, length, u));
        (cos, sin)
    };
    let half = 0.5 * length / count as f64;
    let nodes = polynomial::nodes();
    let (mut x, mut y) = (0.0, 0.0);
    let mut error = 0f64;
    for i in 0..count {
        let middle = (2 * i + 1) as f64 * half;
        let from = middle - half;
        let at = |tau: f64| {
            let (dx, dy) = integrate2(from, middle + half * tau, tangent);
            (x + dx, y + dy)
        };
        let values = nodes.map(at);
        let (px, py) =
            (polynomial::fit(&values.map(|v| v.0)), polynomial::fit(&values.map(|v| v.1)));
        for k in 0..=PROBES {
            let tau = 2.0 * k as f64 / PROBES as f64 - 1.0;
            let exact = at(tau);
            let (ex, ey) =
                (polynomial::value(&px, tau) - exact.0, polynomial::value(&py, tau) - exact.1);
            error = error.max((ex * ex + ey * ey).sqrt());
        }
        out.extend_from_slice(&px);
        out.extend_from_slice(&py);
        (x, y) = at(1.0);
    }
    error
}
