//! Chebyshev polynomials on [−1, 1]: interpolation, and shortening of a power series with a known error.

use crate::primitive::TERMS;

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

/// cos(πk/9) for k = 0 to 4.
const COSINES: [f64; 5] =
    [1.0, 0.939_692_620_785_908_4, 0.766_044_443_118_978, 0.5, 0.173_648_177_666_930_36];

/// cos(π(k + ½)/9) for k = 0 to 3; for k = 4 it is 0.
const COSINES_BETWEEN: [f64; 4] = [
    0.984_807_753_012_208,
    0.866_025_403_784_438_6,
    0.642_787_609_686_539_4,
    0.342_020_143_325_668_7,
];

/// cos(πk/9) for k = 0 to 17: a whole turn.
static TURN: [f64; 2 * LAST] = {
    let mut turn = [0.0; 2 * LAST];
    let mut k = 0;
    while k < 2 * LAST {
        // The same forwards and backwards, and of the other sign beyond a quarter.
        let half = if k > LAST { 2 * LAST - k } else { k };
        turn[k] = if half < 5 { COSINES[half] } else { -COSINES[LAST - half] };
        k += 1;
    }
    turn
};

/// The degree of what is interpolated.
const LAST: usize = TERMS - 1;

/// The nodes of [`interpolate`], ascending from −1 to 1, both ends included so that pieces join without a gap.
pub(super) fn nodes() -> [f64; TERMS] {
    core::array::from_fn(|k| -TURN[k])
}

/// Halfway between the nodes in angle, where an interpolation is farthest off.
pub(super) fn checks() -> [f64; TERMS - 1] {
    let [a, b, c, d] = COSINES_BETWEEN;
    [-a, -b, -c, -d, 0.0, d, c, b, a]
}

/// The polynomial through `values` at [`nodes`], in ascending order of power.
pub(super) fn interpolate(values: &[f64; TERMS]) -> [f64; TERMS] {
    expand(&factors(values))
}

/// Factors of T_0 to T_9 of the polynomial through `values` at [`nodes`].
pub(super) fn factors(values: &[f64; TERMS]) -> [f64; TERMS] {
    let half_at_ends = |k: usize| if k == 0 || k == LAST { 0.5 } else { 1.0 };
    core::array::from_fn(|degree| {
        let mut factor = 0.0;
        for (k, value) in values.iter().enumerate() {
            // T_n at the node −cos(πk/9) = cos(π(9 − k)/9); the angle is reduced exactly, in whole numbers.
            factor += half_at_ends(k) * value * TURN[degree * (LAST - k) % TURN.len()];
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
