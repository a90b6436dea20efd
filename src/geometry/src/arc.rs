//! Arcs (OpenDRIVE 1.8.1, 9.3.2), stable down to curvature 0.

/// Half turns below this `[rad]` use the series of sin(x)/x: its next term is below rounding.
const SMALL: f64 = 1e-4;

/// Chord of an arc: its length `[m]`, and cosine and sine of half its turn.
#[derive(Clone, Copy)]
pub(crate) struct Chord {
    pub(crate) length: f64,
    pub(crate) cos: f64,
    pub(crate) sin: f64,
}

/// The chord from the start to u.
#[inline]
pub(crate) fn chord(curvature: f64, u: f64) -> Chord {
    let half = 0.5 * curvature * u;
    let (sin, cos) = libm::sincos(half);
    let sinc = if half.abs() < SMALL { 1.0 - half * half / 6.0 } else { sin / half };
    Chord { length: u * sinc, cos, sin }
}
