//! A compiled curve, borrowed from wherever its coefficients are stored.

use crate::bends::{BendsFrom, CubicsFrom, Of};
use crate::cubic_part::CubicPart;
use crate::parametric::{Cubics, IDENTITY, Parametric};
use crate::piecewise::Pieces;
use crate::point::{CurvePoint, CurveRates, LocalPoint, Projection, Tangent};
use crate::primitive::{CurveKind, Start};
use crate::spiral::Spiral;
use crate::transformed::Transformed;
use crate::{arc, clamp, nearest};
use glam::DVec2;

/// The foot of a point at the end of a range is perpendicular if the point lies ahead or behind by no more than this,
/// per metre of its distance and at least this many metres.
const PERPENDICULAR: f64 = 1e-9;

/// Longest last step of a projection `[m]`: what it neglects is of the order of its square.
const LAST_STEP: f64 = 1e-7;

/// A compiled curve over u ∈ [0, length] m, borrowing its coefficients.
///
/// `u` is arc length; only for a paramPoly3 whose true length differs from the written one it is arc length scaled to
/// the written length, and for a transformed curve it stays the u of the curve that was transformed. Every method takes any `f64`: u is clamped to the curve, not-a-number counts as its start.
/// Nothing allocates and nothing panics, also for coefficients that [`compile`](crate::compile()) did not make.
///
/// Errors against the exact curve: line and arc are closed forms, a spiral is within 1e-10 m with exact heading and
/// curvature, a poly3 or paramPoly3 is displaced along itself by at most 1e-7 m, a transformed one has a stated error.
#[derive(Clone, Copy, Debug)]
pub struct Curve<'a> {
    start: Start,
    length: f64,
    parameters: &'a [f64],
    shape: Shape<'a>,
}

#[derive(Clone, Copy, Debug)]
enum Shape<'a> {
    Line,
    Arc { curvature: f64 },
    Spiral(Spiral<'a>),
    Parametric(Parametric<'a>),
    Transformed(Transformed<'a>),
}

/// What a curve knows of a point's feet on it, the places that have the point at a right angle beside them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OnlyFoot {
    /// There is one: its u and its offset along the left normal `[m]`.
    At([f64; 2]),
    /// There is none.
    Nowhere,
    /// There may be any number.
    Unknown,
}

impl<'a> Curve<'a> {
    /// Whether the curve is a line that does not end before u `[m]`.
    #[must_use]
    pub fn is_line_up_to(&self, u: f64) -> bool {
        matches!(self.shape, Shape::Line) && u <= self.length
    }

    /// The curvature `[1/m]` of a line or an arc that does not end before u `[m]`; none of other curves.
    #[must_use]
    pub fn even_curvature_up_to(&self, u: f64) -> Option<f64> {
        let curvature = match self.shape {
            Shape::Line => 0.0,
            Shape::Arc { curvature } => curvature,
            _ => return None,
        };
        (u <= self.length).then_some(curvature)
    }

    /// How parts of the curve bend at most, the first of which begins at u `[m]`. None for a transformed curve.
    #[must_use]
    pub fn bends_from(&self, u: f64) -> Option<BendsFrom<'a>> {
        let of = match self.shape {
            Shape::Line => Of::Even(0.0),
            Shape::Arc { curvature } => Of::Even(curvature),
            Shape::Spiral(spiral) => Of::Spiral(spiral),
            Shape::Parametric(parametric) => Of::Cubics(CubicsFrom::new(parametric, u)),
            Shape::Transformed(_) => return None,
        };
        Some(BendsFrom { length: self.length, u, of })
    }

    /// The part of a poly3 or paramPoly3 from one u up to another `[m]`, by the parameter of its cubics. None for another curve, and
    /// where the two are not in order on the curve.
    #[must_use]
    pub fn cubic_part(&self, from: f64, to: f64) -> Option<CubicPart<'a>> {
        match &self.shape {
            Shape::Parametric(parametric) if 0.0 <= from && to <= self.length => {
                parametric.part(from, to)
            }
            _ => None,
        }
    }

    /// A view of the coefficients that [`compile`](crate::compile()) made for this kind and length `[m]`.
    ///
    /// `None` if their number does not fit the kind, or the length is negative or not finite.
    // Always: where the kind is known to be a line or an arc, nothing of the rest is left.
    #[must_use]
    #[inline(always)]
    pub fn new(
        kind: CurveKind,
        start: Start,
        length: f64,
        coefficients: &'a [f64],
    ) -> Option<Self> {
        if !(length >= 0.0 && length.is_finite()) {
            return None;
        }
        let (shape, pieces) = match kind {
            CurveKind::Line => {
                let [] = coefficients else { return None };
                (Shape::Line, coefficients)
            }
            CurveKind::Arc => {
                let &[curvature] = coefficients else { return None };
                (Shape::Arc { curvature }, &[][..])
            }
            CurveKind::Spiral => {
                let (&[from, to], pieces) = coefficients.split_first_chunk()?;
                (Shape::Spiral(Spiral::new(from, to, length, pieces)?), pieces)
            }
            CurveKind::Poly3 => {
                let (v, pieces) = coefficients.split_first_chunk()?;
                (Shape::parametric(IDENTITY, v, length, pieces)?, pieces)
            }
            CurveKind::ParamPoly3 => {
                let (u, rest) = coefficients.split_first_chunk()?;
                let (v, pieces) = rest.split_first_chunk()?;
                (Shape::parametric(u, v, length, pieces)?, pieces)
            }
            CurveKind::Transformed => {
                let pieces = Pieces::new(coefficients, length)?;
                (Shape::Transformed(Transformed { pieces }), coefficients)
            }
        };
        let parameters = coefficients.get(..coefficients.len() - pieces.len())?;
        Some(Self { start, length, parameters, shape })
    }

    /// The length as written `[m]`.
    #[must_use]
    #[inline]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Where the curve starts, as written.
    #[must_use]
    #[inline]
    pub fn start(&self) -> &Start {
        &self.start
    }

    /// The primitive's own parameters as written: nothing for a line, the curvature of an arc, both curvatures of a
    /// spiral, v of a poly3, u then v of a paramPoly3; nothing for a transformed curve.
    #[must_use]
    #[inline]
    pub fn primitive_parameters(&self) -> &'a [f64] {
        self.parameters
    }

    /// Everything about the point at `u` `[m]`.
    #[must_use]
    #[inline(always)]
    pub fn evaluate(&self, u: f64) -> CurvePoint {
        let u = self.clamp(u);
        let frame = self.frame(u);
        let position = self.start.place(frame.position);
        let tangent = self.start.rotate(frame.tangent);
        CurvePoint {
            x: position.x,
            y: position.y,
            cos: tangent.x,
            sin: tangent.y,
            heading: self.start.heading + self.turned_of(u, frame.tangent),
            curvature: frame.curvature,
        }
    }

    /// Position and unit tangent at `u` `[m]`, the same bits as [`evaluate`](Self::evaluate) gives.
    #[must_use]
    #[inline]
    pub fn tangent(&self, u: f64) -> Tangent {
        let frame = self.frame(self.clamp(u));
        let position = self.start.place(frame.position);
        let tangent = self.start.rotate(frame.tangent);
        Tangent { x: position.x, y: position.y, cos: tangent.x, sin: tangent.y }
    }

    /// Heading at `u` `[m]` in rad: continuous along the curve, counted from the heading of the start, not normalised.
    #[must_use]
    pub fn heading(&self, u: f64) -> f64 {
        self.start.heading + self.turned(self.clamp(u))
    }

    /// Signed curvature at `u` `[m]` in 1/m, positive to the left.
    #[must_use]
    pub fn curvature(&self, u: f64) -> f64 {
        let u = self.clamp(u);
        match &self.shape {
            Shape::Line => 0.0,
            Shape::Arc { curvature } => *curvature,
            Shape::Spiral(spiral) => spiral.curvature(u),
            Shape::Parametric(parametric) => parametric.frame(u).curvature,
            Shape::Transformed(transformed) => transformed.curvature(u),
        }
    }

    /// Metres of the curve per metre of u at `u` `[m]`, and its signed curvature there in 1/m, positive to the left. The first is 1 but for a cubic whose true length is
    /// not the written one, and for a transformed curve.
    #[must_use]
    pub fn speed_and_curvature(&self, u: f64) -> [f64; 2] {
        let u = self.clamp(u);
        match &self.shape {
            Shape::Line => [1.0, 0.0],
            Shape::Arc { curvature } => [1.0, *curvature],
            Shape::Spiral(spiral) => [1.0, spiral.curvature(u)],
            Shape::Parametric(parametric) => parametric.speed_and_curvature(u),
            Shape::Transformed(transformed) => {
                let frame = transformed.frame(u);
                [frame.speed, frame.curvature]
            }
        }
    }

    /// Speed and curvature as [`speed_and_curvature`](Self::speed_and_curvature) gives them, and how they change along u.
    #[must_use]
    pub fn rates(&self, u: f64) -> CurveRates {
        let u = self.clamp(u);
        match &self.shape {
            Shape::Line => CurveRates::even(0.0),
            Shape::Arc { curvature } => CurveRates::even(*curvature),
            Shape::Spiral(spiral) => spiral.rates(u),
            Shape::Parametric(parametric) => parametric.rates(u),
            Shape::Transformed(transformed) => transformed.rates(u),
        }
    }

    /// The foot of (`x`, `y`) `[m]` over u ∈ [`lo`, `hi`], found from `seed`.
    ///
    /// Line and arc give the nearest point of the range in closed form, whatever the seed; if an arc passes that point
    /// several times, the seed chooses. The other kinds give a local minimum of the distance, the one Newton's method
    /// reaches from the seed, or an end of the range. The range is cut to [0, length].
    #[must_use]
    #[inline]
    pub fn project_from(&self, x: f64, y: f64, seed: f64, lo: f64, hi: f64) -> Projection {
        let lo = self.clamp(lo);
        // A missing upper limit is no limit.
        let hi = if hi.is_nan() { self.length } else { clamp(hi, lo, self.length) };
        let seed = clamp(seed, lo, hi);
        let target = self.start.localize(x, y);
        let u = match &self.shape {
            Shape::Line => clamp(target.x, lo, hi),
            Shape::Arc { curvature } => arc::project(*curvature, target, seed, lo, hi),
            Shape::Spiral(spiral) => nearest::descend(|u| spiral.jet(u), target, seed, lo, hi),
            Shape::Parametric(parametric) => {
                nearest::descend(|u| parametric.jet(u), target, seed, lo, hi)
            }
            Shape::Transformed(transformed) => {
                nearest::descend(|u| transformed.jet(u), target, seed, lo, hi)
            }
        };
        self.foot(target, u, lo, hi)
    }

    /// As [`project_from`](Self::project_from), for a point that lies neither ahead of the range nor behind it: u of its foot and
    /// its offset along the left normal there `[m]`, the same bits for less. None where the projection is `clamped`.
    #[must_use]
    #[inline]
    pub fn beside(&self, x: f64, y: f64, seed: f64, lo: f64, hi: f64) -> Option<[f64; 2]> {
        self.closed_foot(x, y, lo, hi).or_else(|| {
            let foot = self.project_from(x, y, seed, lo, hi);
            (!foot.clamped).then_some([foot.u, foot.lateral])
        })
    }

    /// As [`beside`](Self::beside), where a line or an arc tells it in closed form: u of the foot of (`x`, `y`) `[m]` over u ∈ [`lo`, `hi`], and the offset along the
    /// left normal there `[m]`. None of a point elsewhere, of another curve, and where rounding decides.
    #[must_use]
    #[inline]
    pub fn closed_foot(&self, x: f64, y: f64, lo: f64, hi: f64) -> Option<[f64; 2]> {
        let (first, last) = (self.clamp(lo), clamp(hi, self.clamp(lo), self.length));
        let target = self.start.localize(x, y);
        match &self.shape {
            Shape::Line => (first <= target.x && target.x <= last).then_some([target.x, target.y]),
            Shape::Arc { curvature } => arc::project_inside(*curvature, target, first, last)
                .map(|u| [u, arc::lateral(*curvature, target)])
                .filter(|[_, lateral]| lateral.is_finite()),
            _ => None,
        }
    }

    /// The one place between `lo` and `hi` `[m]` of a line or an arc, which goes on before its start and behind its end, that has (`x`, `y`) `[m]`
    /// at a right angle beside it: u and the offset along the left normal there `[m]`, the bits of [`beside`](Self::beside).
    #[must_use]
    #[inline]
    pub fn only_foot(&self, x: f64, y: f64, lo: f64, hi: f64) -> OnlyFoot {
        let target = self.start.localize(x, y);
        let found = match &self.shape {
            Shape::Line => Some((lo <= target.x && target.x <= hi).then_some(target.x)),
            Shape::Arc { curvature } => arc::only_foot(*curvature, target, lo, hi),
            _ => None,
        };
        match (found, &self.shape) {
            (None, _) => OnlyFoot::Unknown,
            (Some(None), _) => OnlyFoot::Nowhere,
            (Some(Some(u)), Shape::Arc { curvature }) => {
                let lateral = arc::lateral(*curvature, target);
                if lateral.is_finite() { OnlyFoot::At([u, lateral]) } else { OnlyFoot::Unknown }
            }
            (Some(Some(u)), _) => OnlyFoot::At([u, target.y]),
        }
    }

    /// The nearest point of the whole curve to (`x`, `y`) `[m]`; of equally near points the first.
    #[must_use]
    pub fn project(&self, x: f64, y: f64) -> Projection {
        self.project_within(x, y, self.length)
    }

    /// As [`project`](Self::project), over u ∈ [0, `limit`] `[m]`: of a geometry that the next one of a road cuts short.
    #[must_use]
    pub fn project_within(&self, x: f64, y: f64, limit: f64) -> Projection {
        let (length, limit) = (self.length, self.clamp(limit));
        let target = self.start.localize(x, y);
        let u = match &self.shape {
            Shape::Line => clamp(target.x, 0.0, limit),
            Shape::Arc { curvature } => arc::project(*curvature, target, 0.0, 0.0, limit),
            Shape::Spiral(spiral) => {
                nearest::search(|u| spiral.jet(u), target, spiral.pieces.count(), length, limit)
            }
            Shape::Parametric(parametric) => {
                let count = parametric.pieces.count();
                nearest::search(|u| parametric.jet(u), target, count, length, limit)
            }
            Shape::Transformed(transformed) => {
                let count = transformed.pieces.count();
                nearest::search(|u| transformed.jet(u), target, count, length, limit)
            }
        };
        self.foot(target, u, 0.0, limit)
    }

    /// What is known about the foot near `u` of a target in the curve's own frame.
    ///
    /// The search for it stops within about 1e-10 m, and takes a spiral's direction from its polynomials. One more step
    /// with the exact direction makes the gap perpendicular to it to rounding, so that a point is met again from its s and
    /// t.
    #[inline]
    fn foot(&self, target: DVec2, u: f64, lo: f64, hi: f64) -> Projection {
        let (mut u, mut frame) = (u, self.frame(u));
        if let Shape::Spiral(_) | Shape::Parametric(_) | Shape::Transformed(_) = self.shape {
            let gap = target - frame.position;
            let bend = 1.0 - frame.curvature * frame.tangent.perp_dot(gap);
            let better = u + gap.dot(frame.tangent) / (bend * frame.speed);
            if better != u && (better - u).abs() <= LAST_STEP && lo < better && better < hi {
                (u, frame) = (better, self.frame(better));
            }
            // The search may stop just short of an end that the target lies beyond.
            let end = if better >= hi { hi } else { lo };
            if !(lo < better && better < hi) && u != end && (end - u).abs() <= LAST_STEP {
                (u, frame) = (end, self.frame(end));
            }
        }
        let gap = target - frame.position;
        let distance_squared = gap.length_squared();
        let ahead = gap.dot(frame.tangent);
        let tolerance = PERPENDICULAR * (1.0 + distance_squared.sqrt());
        let position = self.start.place(frame.position);
        let tangent = self.start.rotate(frame.tangent);
        // Farther away than squares can tell, nothing is known to be perpendicular.
        let clamped = !distance_squared.is_finite()
            || (u >= hi && ahead > tolerance)
            || (u <= lo && ahead < -tolerance);
        let lateral = match &self.shape {
            Shape::Arc { curvature } if !clamped => arc::lateral(*curvature, target),
            _ => frame.tangent.perp_dot(gap),
        };
        Projection {
            u,
            x: position.x,
            y: position.y,
            cos: tangent.x,
            sin: tangent.y,
            lateral,
            distance_squared,
            clamped,
            curvature: frame.curvature,
        }
    }

    /// Position relative to the start and unit tangent at `u` `[m]`, along the inertial axes: small numbers keep digits that
    /// inertial coordinates lose.
    pub(crate) fn relative(&self, u: f64) -> (DVec2, DVec2) {
        let frame = self.frame(self.clamp(u));
        (self.start.rotate(frame.position), self.start.rotate(frame.tangent))
    }

    #[inline]
    fn clamp(&self, u: f64) -> f64 {
        clamp(u, 0.0, self.length)
    }

    /// In the curve's own frame; `u` lies on the curve.
    #[inline(always)]
    fn frame(&self, u: f64) -> LocalPoint {
        match &self.shape {
            Shape::Line => {
                let position = DVec2::new(u, 0.0);
                LocalPoint { position, tangent: DVec2::X, curvature: 0.0, speed: 1.0 }
            }
            Shape::Arc { curvature } => arc::frame(*curvature, u),
            Shape::Spiral(spiral) => spiral.frame(u),
            Shape::Parametric(parametric) => parametric.frame(u),
            Shape::Transformed(transformed) => transformed.frame(u),
        }
    }

    /// As [`Self::turned`], where the tangent in the curve's own frame is known.
    #[inline]
    fn turned_of(&self, u: f64, tangent: DVec2) -> f64 {
        match &self.shape {
            Shape::Transformed(transformed) => transformed.heading(u, tangent),
            _ => self.turned(u),
        }
    }

    /// Heading relative to the start `[rad]`; `u` lies on the curve.
    #[inline]
    fn turned(&self, u: f64) -> f64 {
        match &self.shape {
            Shape::Line => 0.0,
            Shape::Arc { curvature } => curvature * u,
            Shape::Spiral(spiral) => spiral.heading(u),
            Shape::Parametric(parametric) => parametric.heading(u),
            Shape::Transformed(transformed) => transformed.heading(u, transformed.frame(u).tangent),
        }
    }
}

impl<'a> Shape<'a> {
    #[inline]
    fn parametric(
        u: &'a [f64; 4],
        v: &'a [f64; 4],
        length: f64,
        pieces: &'a [f64],
    ) -> Option<Self> {
        let pieces = Pieces::new(pieces, length)?;
        Some(Self::Parametric(Parametric { cubics: Cubics { u, v }, pieces }))
    }
}
