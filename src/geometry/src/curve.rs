//! Evaluating a compiled curve.

use crate::cubic::Cubic;
use crate::polynomial::{self, COEFFICIENTS};
use crate::primitive::CurveKind;
use crate::{arc, cos_sin, spiral};

/// Start of a geometry as written, with cosine and sine of its heading so that evaluation need not repeat them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// x `[m]`.
    pub x: f64,
    /// y `[m]`.
    pub y: f64,
    /// Heading `[rad]`, counter-clockwise from x.
    pub heading: f64,
    /// Cosine of the heading.
    pub cos: f64,
    /// Sine of the heading.
    pub sin: f64,
}

impl Start {
    /// From position `[m]` and heading `[rad]`.
    pub fn new(x: f64, y: f64, heading: f64) -> Self {
        let (cos, sin) = cos_sin(heading);
        Self { x, y, heading, cos, sin }
    }
}

/// A point of a curve with its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// x `[m]`.
    pub x: f64,
    /// y `[m]`.
    pub y: f64,
    /// Cosine of the heading: x of the unit tangent.
    pub cos: f64,
    /// Sine of the heading: y of the unit tangent.
    pub sin: f64,
    /// Heading `[rad]`, not normalised: the start's heading plus the turn.
    pub heading: f64,
    /// Curvature `[1/m]`, positive to the left.
    pub curvature: f64,
}

/// A compiled curve, borrowed; u ∈ [0, length] is the distance from its start along it.
#[derive(Clone, Copy, Debug)]
pub struct Curve<'a> {
    pub(crate) kind: CurveKind,
    pub(crate) start: Start,
    pub(crate) length: f64,
    coefficients: &'a [f64],
}

impl<'a> Curve<'a> {
    /// A curve over numbers that [`crate::compile`] made.
    ///
    /// `None` if there are not as many numbers as the kind has, or the length is negative or not finite.
    #[inline]
    pub fn new(
        kind: CurveKind,
        start: Start,
        length: f64,
        coefficients: &'a [f64],
    ) -> Option<Self> {
        let pieces = coefficients.len().checked_sub(kind.parameters())?;
        let fits = match kind.piece_numbers() {
            0 => pieces == 0,
            numbers => pieces.is_multiple_of(numbers) && (pieces > 0 || length == 0.0),
        };
        (fits && length >= 0.0 && length.is_finite()).then_some(Self {
            kind,
            start,
            length,
            coefficients,
        })
    }

    /// Length `[m]`.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The primitive's own numbers, as written.
    pub fn primitive_parameters(&self) -> &'a [f64] {
        self.coefficients.get(..self.kind.parameters()).unwrap_or(&[])
    }

    /// Number of pieces; 1 for lines and arcs.
    pub(crate) fn pieces(&self) -> usize {
        match self.kind.piece_numbers() {
            0 => 1,
            numbers => (self.coefficients.len() - self.kind.parameters()) / numbers,
        }
    }

    #[inline]
    pub(crate) fn number(&self, i: usize) -> f64 {
        self.coefficients.get(i).copied().unwrap_or(0.0)
    }

    /// The piece that holds u, with u's place in it: τ ∈ [−1, 1].
    #[inline]
    fn piece(&self, u: f64) -> (&'a [f64], f64) {
        let numbers = self.kind.piece_numbers();
        let first = self.kind.parameters();
        let count = (self.coefficients.len().saturating_sub(first)) / numbers.max(1);
        let place = if self.length > 0.0 { u / self.length * count as f64 } else { 0.0 };
        let i = (place as usize).min(count.saturating_sub(1));
        let from = first + i * numbers;
        (self.coefficients.get(from..from + numbers).unwrap_or(&[]), 2.0 * (place - i as f64) - 1.0)
    }

    /// Parameter of a poly3 or paramPoly3 at u.
    #[inline]
    fn parameter(&self, u: f64) -> f64 {
        let (piece, tau) = self.piece(u);
        piece.first_chunk::<COEFFICIENTS>().map_or(0.0, |p| polynomial::value(p, tau))
    }

    fn cubics(&self) -> (Cubic, Cubic) {
        let four = |first: usize| Cubic::new(std::array::from_fn(|i| self.number(first + i)));
        match self.kind {
            CurveKind::Poly3 => (Cubic { a: 0.0, b: 1.0, c: 0.0, d: 0.0 }, four(0)),
            _ => (four(0), four(4)),
        }
    }

    /// Point, frame and curvature at u; u outside [0, length] is moved to the nearer end.
    #[inline]
    pub fn evaluate(&self, u: f64) -> CurvePoint {
        let u = if u > 0.0 { u.min(self.length) } else { 0.0 };
        let start = &self.start;
        // Position and tangent in the start's frame.
        let (x, y, cos, sin, turn, curvature) = match self.kind {
            CurveKind::Line => (u, 0.0, 1.0, 0.0, 0.0, 0.0),
            CurveKind::Arc => {
                let curvature = self.number(0);
                let chord = arc::chord(curvature, u);
                let (cos, sin) =
                    (chord.cos * chord.cos - chord.sin * chord.sin, 2.0 * chord.cos * chord.sin);
                (
                    chord.length * chord.cos,
                    chord.length * chord.sin,
                    cos,
                    sin,
                    curvature * u,
                    curvature,
                )
            }
            CurveKind::Spiral => {
                let (from, to) = (self.number(0), self.number(1));
                let (piece, tau) = self.piece(u);
                let (x, y) = match (piece.first_chunk(), piece.last_chunk()) {
                    (Some(px), Some(py)) => {
                        (polynomial::value(px, tau), polynomial::value(py, tau))
                    }
                    _ => (0.0, 0.0),
                };
                let turn = spiral::turn(from, to, self.length, u);
                let (cos, sin) = cos_sin(turn);
                (x, y, cos, sin, turn, from + spiral::rate(from, to, self.length) * u)
            }
            CurveKind::Poly3 | CurveKind::ParamPoly3 => {
                let p = self.parameter(u);
                let (cu, cv) = self.cubics();
                let (du, dv) = (cu.derivative(p), cv.derivative(p));
                let speed = (du * du + dv * dv).sqrt();
                let (cos, sin) = if speed > 0.0 { (du / speed, dv / speed) } else { (1.0, 0.0) };
                let bend = du * cv.second_derivative(p) - dv * cu.second_derivative(p);
                let curvature = if speed > 0.0 { bend / (speed * speed * speed) } else { 0.0 };
                (cu.value(p), cv.value(p), cos, sin, libm::atan2(sin, cos), curvature)
            }
        };
        CurvePoint {
            x: start.x + (start.cos * x - start.sin * y),
            y: start.y + (start.sin * x + start.cos * y),
            cos: start.cos * cos - start.sin * sin,
            sin: start.sin * cos + start.cos * sin,
            heading: start.heading + turn,
            curvature,
        }
    }

    /// Heading at u `[rad]`, not normalised.
    pub fn heading(&self, u: f64) -> f64 {
        self.evaluate(u).heading
    }

    /// Curvature at u `[1/m]`, positive to the left.
    pub fn curvature(&self, u: f64) -> f64 {
        self.evaluate(u).curvature
    }
}
