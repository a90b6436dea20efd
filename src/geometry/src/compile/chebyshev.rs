//! Chebyshev polynomials on [−1, 1]: interpolation, and shortening of a power series with a known error.

use crate::primitive::TERMS;
use core::f64::consts::PI;

/// Terms of the power series that are shortened. The pieces are short enough for the rest to be below 1e-18.
pub(super) const SERIES: usize = 32;

/// Row n holds the coefficients of T_n in ascending order of power: T_n = 2τ·T_{n−1} − T_{n−2}.
static T: [[f64; SERIES]; SERIES] = {
    let mut rows = [[0.0; SERIES]; SERIES];
    rows[0][0] = 1.0;
    rows[1][1] = 1.0;
    let mut n = 2;
    while n < SERIES {
        let mut k = 0;
        while k < SERIES {
            let shifted = if k > 0 { 2.0 * rows[n - 1][k - 1] } else { 0.0 };
            rows[n][k] = shifted - rows[n - 2][k];
            k += 1;
        }
        n += 1;
    }
    rows
};

/// Shortens a power series to degree nine. Returns the bound of the difference on [−1, 1].
///
/// Highest power first, τⁿ is replaced by the multiple of T_n that cancels it; since |T_n| ≤ 1 the factors add up to a
/// bound (Lanczos' economisation).
pub(super) fn shorten(mut series: [f64; SERIES]) -> ([f64; TERMS], f64) {
    let mut error = 0.0;
    for n in (TERMS..SERIES).rev() {
        let factor = series[n] / T[n][n];
        for (term, t) in series.iter_mut().zip(&T[n]) {
            *term -= factor * t;
        }
        error += factor.abs();
    }
    let mut short = [0.0; TERMS];
    short.copy_from_slice(&series[..TERMS]);
    (short, error)
}

/// The nodes of [`interpolate`], ascending from −1 to 1, both ends included so that pieces join without a gap.
pub(super) fn nodes() -> [f64; TERMS] {
    core::array::from_fn(|k| -libm::cos(PI * k as f64 / (TERMS - 1) as f64))
}

/// Halfway between the nodes in angle, where an interpolation is farthest off.
pub(super) fn checks() -> [f64; TERMS - 1] {
    core::array::from_fn(|k| -libm::cos(PI * (k as f64 + 0.5) / (TERMS - 1) as f64))
}

/// The polynomial through `values` at [`nodes`], in ascending order of power.
pub(super) fn interpolate(values: &[f64; TERMS]) -> [f64; TERMS] {
    expand(&factors(values))
}

/// Factors of T_0 to T_9 of the polynomial through `values` at [`nodes`].
pub(super) fn factors(values: &[f64; TERMS]) -> [f64; TERMS] {
    const LAST: usize = TERMS - 1;
    let half_at_ends = |k: usize| if k == 0 || k == LAST { 0.5 } else { 1.0 };
    core::array::from_fn(|degree| {
        let mut factor = 0.0;
        for (k, value) in values.iter().enumerate() {
            // T_n at the node −cos(πk/9) = cos(π(9 − k)/9); the angle is reduced exactly, in whole numbers.
            let angle = (degree * (LAST - k)) % (2 * LAST);
            factor += half_at_ends(k) * value * libm::cos(PI * angle as f64 / LAST as f64);
        }
        factor * (half_at_ends(degree) * 2.0 / LAST as f64)
    })
}

/// The polynomial with these factors of T_0 to T_9, in ascending order of power.
pub(super) fn expand(factors: &[f64; TERMS]) -> [f64; TERMS] {
    let mut polynomial = [0.0; TERMS];
    for (factor, row) in factors.iter().zip(&T) {
        for (term, t) in polynomial.iter_mut().zip(row) {
            *term += factor * t;
        }
    }
    polynomial
}
