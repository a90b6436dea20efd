//! Moving a compiled curve into another plane, its parameter kept.
//!
//! The result is what a piecewise polynomial of degree nine makes of the exact images, so that it can be asked like any
//! other curve: no projection is computed when a map is queried.

use super::chebyshev::{checks, expand, factors, nodes};
use super::{MAX_PIECES, rounding};
use crate::curve::Curve;
use crate::piecewise::value;
use crate::primitive::{Start, TERMS, TRANSFORMED_PIECE};
use crate::transformed::{middle_slope, piece};
use core::f64::consts::TAU;
use core::fmt;
use glam::DVec2;

/// Distance `[m]` of a transformed curve from the exact image of its source that pieces may have: far below what any
/// projection resolves at coordinates of UTM's size.
const TOLERANCE: f64 = 1e-9;

/// Distance allowed per metre of length, for curves so long that [`TOLERANCE`] nears the rounding of a coordinate.
const RELATIVE_TOLERANCE: f64 = 1e-13;

/// Size of a term `[m]` that is nothing but the rounding of images. Highest terms below it are left out: a second derivative
/// would magnify them on short curves.
const NOISE: f64 = 1e-12;

/// Curves up to this length `[m]` are moved by the first two derivatives at their start, which keeps the directions of the
/// shortest ones: differences of images would lose them. What is neglected is of the order of δ³/R², 1e-13 m.
const SHORT: f64 = 1.0;

/// Size of a term per metre of a short curve that is nothing but rounding.
const SHORT_NOISE: f64 = 1e-14;

/// Distance `[m]` over which first derivatives are compared for the second ones, which are constant but for 1e-10 of themselves.
const PROBE: f64 = 64.0;

/// Most that a piece turns by `[rad]`; a search for the nearest point relies on it.
const PIECE_TURNING: f64 = 0.5;

/// Cosine of the largest angle between the middle of a piece and a node of it.
const MIN_ALIGNMENT: f64 = 0.85;

/// What the largest distance seen at the check points is multiplied by to bound those between them.
const UNSEEN: f64 = 1.5;

/// A smooth map from a part of one plane to another, near some place.
pub trait Chart {
    /// The place of the source that points count from, inertial `[m]`.
    fn center(&self) -> DVec2;
    /// The image of the centre, inertial in the other plane `[m]`.
    fn origin(&self) -> DVec2;
    /// Distance from the place that the chart was asked for at which it still holds `[m]`.
    fn reach(&self) -> f64;
    /// The image of a point relative to the centre, relative to the origin `[m]`.
    fn image(&self, point: DVec2) -> DVec2;
    /// Derivatives of the image by x and by y at a point relative to the centre.
    fn slopes(&self, point: DVec2) -> [DVec2; 2];
}

/// Where the image of a curve begins.
#[derive(Clone, Copy)]
struct Anchor<'e> {
    /// Origin of the chart at the curve's start.
    origin: DVec2,
    /// Image of the start, from that origin.
    image: DVec2,
    /// The chart about the start, for a short curve.
    near: Option<&'e Expansion>,
}

/// A chart about a place, to the second order.
struct Expansion {
    slopes: [DVec2; 2],
    /// Halves of the second derivatives: by x and x, by y and y; and the whole one by x and y.
    bends: [DVec2; 3],
}

impl Expansion {
    fn of(chart: &impl Chart, point: DVec2) -> Self {
        let change = |step: DVec2| {
            let (ahead, behind) = (chart.slopes(point + step), chart.slopes(point - step));
            [0, 1].map(|i| (ahead[i] - behind[i]) / (2.0 * PROBE))
        };
        let ([xx, xy], [_, yy]) = (change(DVec2::X * PROBE), change(DVec2::Y * PROBE));
        Self { slopes: chart.slopes(point), bends: [xx * 0.5, yy * 0.5, xy] }
    }

    /// Image of a place near by, both relative to the place that this is about.
    fn image(&self, d: DVec2) -> DVec2 {
        let [by_x, by_y] = self.slopes;
        let [xx, yy, xy] = self.bends;
        by_x * d.x + by_y * d.y + xx * (d.x * d.x) + yy * (d.y * d.y) + xy * (d.x * d.y)
    }
}

/// A curve in another plane: what to store, and how good it is.
#[derive(Clone, Debug, PartialEq)]
pub struct TransformedCurve {
    /// Where it starts.
    pub start: Start,
    /// Pieces of equal length in u; see [`CurveKind::Transformed`](crate::CurveKind::Transformed).
    pub coefficients: Vec<f64>,
    /// Bound of the distance between the curve and the image of its source by the charts, at the same u `[m]`.
    pub error: f64,
}

/// Why a curve cannot be moved.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TransformError {
    /// A place of it has no chart.
    Outside {
        /// The place in the source's plane `[m]`.
        x: f64,
        /// The place in the source's plane `[m]`.
        y: f64,
    },
    /// [`MAX_PIECES`] are not enough.
    TooManyPieces,
}

impl fmt::Display for TransformError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Outside { x, y } => {
                write!(f, "the place ({x:.3}, {y:.3}) has no counterpart")
            }
            Self::TooManyPieces => {
                write!(f, "the curve is too long or bends too sharply for {MAX_PIECES} pieces")
            }
        }
    }
}

impl std::error::Error for TransformError {}

/// Where pieces are sampled, and what turns samples into polynomials; made once for many curves.
#[derive(Clone, Debug)]
pub struct CurveTransform {
    nodes: [f64; TERMS],
    checks: [f64; TERMS - 1],
    /// Row k: factors of the Chebyshev polynomials whose sum is 1 at node k and 0 at the others.
    cardinals: [[f64; TERMS]; TERMS],
}

impl Default for CurveTransform {
    fn default() -> Self {
        let cardinals = core::array::from_fn(|k| {
            let mut values = [0.0; TERMS];
            values[k] = 1.0;
            factors(&values)
        });
        Self { nodes: nodes(), checks: checks(), cardinals }
    }
}

/// A piece before it is turned into the frame of the start: polynomials relative to the image of the start.
struct Fitted {
    x: [f64; TERMS],
    y: [f64; TERMS],
    /// Heading of the source's middle relative to its start `[rad]`.
    heading: f64,
}

impl CurveTransform {
    /// Moves a curve. `chart` yields one that holds around a place.
    ///
    /// Errors: a place has no chart, or the curve needs too many pieces. Deterministic as far as the charts are.
    pub fn apply<C: Chart>(
        &self,
        curve: &Curve<'_>,
        mut chart: impl FnMut(DVec2) -> Option<C>,
    ) -> Result<TransformedCurve, TransformError> {
        let length = curve.length();
        let tolerance = TOLERANCE.max(RELATIVE_TOLERANCE * length);
        let start = DVec2::new(curve.start().x, curve.start().y);
        let outside = |at: DVec2| TransformError::Outside { x: at.x, y: at.y };
        let first = chart(start).ok_or_else(|| outside(start))?;
        let image = first.image(start - first.center());
        let is_short = length <= SHORT && curve.relative(length).0.length() <= SHORT;
        let expansion = is_short.then(|| Expansion::of(&first, start - first.center()));
        let turning = (curve.heading(length) - curve.heading(0.0)).abs();
        let least = libm::ceil((turning / PIECE_TURNING).max(length / (2.0 * first.reach())));
        // The cast saturates.
        let mut count = (least as usize).max(1);
        while count <= MAX_PIECES {
            let at_start = Anchor { origin: first.origin(), image, near: expansion.as_ref() };
            let fitted = self.fit(curve, &mut chart, at_start, count, tolerance)?;
            if let Some((pieces, error)) = fitted {
                let start = first.origin() + image;
                return Ok(assemble(curve, start, &pieces, error + rounding(length)));
            }
            count += count.div_ceil(2);
        }
        Err(TransformError::TooManyPieces)
    }

    /// Pieces and the bound of their distance from the exact image; none where there are not enough.
    fn fit<C: Chart>(
        &self,
        curve: &Curve<'_>,
        chart: &mut impl FnMut(DVec2) -> Option<C>,
        anchor: Anchor<'_>,
        count: usize,
        tolerance: f64,
    ) -> Result<Option<(Vec<Fitted>, f64)>, TransformError> {
        let Anchor { origin, image, near } = anchor;
        let length = curve.length();
        let mut pieces = Vec::with_capacity(count);
        let mut worst = 0.0_f64;
        for index in 0..count {
            let u = |t: f64| (index as f64 + 0.5 * (t + 1.0)) / count as f64 * length;
            let middle = curve.tangent(u(0.0));
            let center = DVec2::new(middle.x, middle.y);
            let chart =
                chart(center).ok_or(TransformError::Outside { x: center.x, y: center.y })?;
            // Both differences are small and exact or nearly so; sums of coordinates would lose digits.
            let shift = DVec2::new(curve.start().x, curve.start().y) - chart.center();
            let back = (chart.origin() - origin) - image;
            let direction = DVec2::new(middle.cos, middle.sin);
            let mut within = true;
            let mut at = |t: f64| {
                let (position, tangent) = curve.relative(u(t));
                let place = shift + position;
                within &= place.distance(center - chart.center()) <= chart.reach()
                    && tangent.dot(direction) >= MIN_ALIGNMENT;
                near.map_or_else(|| back + chart.image(place), |near| near.image(position))
            };
            let samples = self.nodes.map(&mut at);
            let (mut x, mut y) = ([0.0; TERMS], [0.0; TERMS]);
            for (sample, row) in samples.iter().zip(&self.cardinals) {
                for ((x, y), factor) in x.iter_mut().zip(&mut y).zip(row) {
                    *x += sample.x * factor;
                    *y += sample.y * factor;
                }
            }
            let mut last = TERMS - 1;
            let noise = if near.is_some() { SHORT_NOISE * length } else { NOISE };
            while last > 1 && x[last].abs() <= noise && y[last].abs() <= noise {
                (x[last], y[last]) = (0.0, 0.0);
                last -= 1;
            }
            let (x, y) = (expand(&x), expand(&y));
            for t in self.checks {
                let distance = at(t).distance(DVec2::new(value(&x, t), value(&y, t)));
                // Not-a-number must not pass for no distance.
                worst =
                    if distance.is_finite() { worst.max(UNSEEN * distance) } else { f64::INFINITY };
            }
            if !within || worst > tolerance {
                return Ok(None);
            }
            let heading = curve.heading(u(0.0)) - curve.start().heading;
            pieces.push(Fitted { x, y, heading });
        }
        Ok(Some((pieces, worst)))
    }
}

/// Turns pieces into the frame of the start, whose heading is that of the source plus what its tangent is turned by.
fn assemble(curve: &Curve<'_>, start: DVec2, pieces: &[Fitted], error: f64) -> TransformedCurve {
    let source = curve.start();
    if curve.length() <= 0.0 {
        // A place with a direction.
        let (mut x, y) = ([0.0; TERMS], [0.0; TERMS]);
        (x[0], x[1]) = (1.0, 1.0);
        let start = Start { x: start.x, y: start.y, ..*source };
        return TransformedCurve { start, coefficients: piece(0.0, &x, &y).to_vec(), error };
    }
    let turned = pieces.first().map_or(0.0, |first| {
        let (_, from) = curve.relative(0.0);
        let to = DVec2::new(slope(&first.x), slope(&first.y));
        libm::atan2(from.perp_dot(to), from.dot(to))
    });
    let start = Start::new(start.x, start.y, source.heading + turned);
    let back = DVec2::new(start.cos, -start.sin);
    let mut coefficients = Vec::with_capacity(pieces.len() * TRANSFORMED_PIECE);
    for fitted in pieces {
        let (mut x, mut y) = ([0.0; TERMS], [0.0; TERMS]);
        for (k, (from_x, from_y)) in fitted.x.iter().zip(&fitted.y).enumerate() {
            let turned = back.rotate(DVec2::new(*from_x, *from_y));
            (x[k], y[k]) = (turned.x, turned.y);
        }
        let middle = middle_slope(&x, &y);
        let principal = libm::atan2(middle.y, middle.x);
        let turns = libm::rint((fitted.heading - principal) / TAU);
        coefficients.extend(piece(principal + turns * TAU, &x, &y));
    }
    TransformedCurve { start, coefficients, error }
}

/// Slope of a polynomial at τ = −1.
fn slope(coefficients: &[f64; TERMS]) -> f64 {
    let terms = coefficients.iter().enumerate().skip(1);
    terms.map(|(k, c)| if k % 2 == 1 { c * k as f64 } else { -c * k as f64 }).sum()
}
