//! Polynomials of degree 9 over [−1, 1], fitted at Chebyshev nodes.

use std::f64::consts::PI;

/// Number of coefficients.
pub(crate) const COEFFICIENTS: usize = 10;

/// The nodes at which [`fit`] wants values.
pub(crate) fn nodes() -> [f64; COEFFICIENTS] {
    std::array::from_fn(|k| libm::cos(PI * (k as f64 + 0.5) / COEFFICIENTS as f64))
}

/// Coefficients in ascending order of the polynomial through values at [`nodes`].
pub(crate) fn fit(values: &[f64; COEFFICIENTS]) -> [f64; COEFFICIENTS] {
    const N: usize = COEFFICIENTS;
    let mut out = [0.0; N];
    // Chebyshev polynomials T₍k−1₎ and Tₖ in powers of τ.
    let (mut before, mut current) = ([0.0; N], [0.0; N]);
    current[0] = 1.0;
    for k in 0..N {
        let mut weight = 0.0;
        for (i, value) in values.iter().enumerate() {
            weight += value * libm::cos(PI * k as f64 * (i as f64 + 0.5) / N as f64);
        }
        weight *= if k == 0 { 1.0 } else { 2.0 } / N as f64;
        for j in 0..N {
            out[j] += weight * current[j];
        }
        let mut next = [0.0; N];
        for j in 0..N {
            let shifted = if j > 0 { current[j - 1] } else { 0.0 };
            next[j] = if k == 0 { shifted } else { 2.0 * shifted } - before[j];
        }
        (before, current) = (current, next);
    }
    out
}

/// Value at τ.
#[inline]
pub(crate) fn value(coefficients: &[f64; COEFFICIENTS], tau: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * tau + c)
}
