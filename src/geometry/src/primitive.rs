//! Reference-line primitives as written in a file.

use glam::DVec2;

/// Where a geometry starts, as written, with the cosine and sine of its heading.
///
/// Every evaluation needs cosine and sine, so they are computed once, by libm, when the map is compiled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// Inertial x `[m]`.
    pub x: f64,
    /// Inertial y `[m]`.
    pub y: f64,
    /// Heading `[rad]`, counter-clockwise from the x axis, as written (not normalised).
    pub heading: f64,
    /// Cosine of the heading.
    pub cos: f64,
    /// Sine of the heading.
    pub sin: f64,
}

impl Start {
    /// A start at (`x`, `y`) `[m]` in direction `heading` `[rad]`.
    #[must_use]
    pub fn new(x: f64, y: f64, heading: f64) -> Self {
        let (sin, cos) = libm::sincos(heading);
        Self { x, y, heading, cos, sin }
    }

    /// From the geometry's own frame (origin at the start, heading along +x) to inertial coordinates.
    #[inline]
    pub(crate) fn place(&self, local: DVec2) -> DVec2 {
        DVec2::new(self.x, self.y) + self.rotate(local)
    }

    /// From inertial coordinates to the geometry's own frame.
    #[inline]
    pub(crate) fn localize(&self, x: f64, y: f64) -> DVec2 {
        DVec2::new(self.cos, -self.sin).rotate(DVec2::new(x - self.x, y - self.y))
    }

    /// A direction in the geometry's own frame, turned into the inertial frame.
    #[inline]
    pub(crate) fn rotate(&self, local: DVec2) -> DVec2 {
        DVec2::new(self.cos, self.sin).rotate(local)
    }
}

/// How the parameter `p` of a [`Primitive::ParamPoly3`] runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterRange {
    /// p ∈ [0, length]. Despite the name p is not arc length unless the writer made it so.
    ArcLength,
    /// p ∈ [0, 1]. Also what an absent attribute means.
    Normalized,
}

/// A plan-view primitive as written in the file, in the geometry's own frame (origin at the start, heading along +x).
///
/// Curvatures are signed `[1/m]`, positive to the left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Primitive {
    /// A straight line.
    Line,
    /// A circular arc. Zero curvature is discouraged by the standard, occurs, and is a line.
    Arc {
        /// Curvature `[1/m]`.
        curvature: f64,
    },
    /// A clothoid: the curvature is linear in arc length.
    Spiral {
        /// Curvature at the start `[1/m]`.
        curvature_start: f64,
        /// Curvature at the end `[1/m]`; may have the other sign, or be equal.
        curvature_end: f64,
    },
    /// `v(u) = a + b·u + c·u² + d·u³`, deprecated. The abscissa u is not arc length.
    Poly3 {
        /// Coefficients of v in ascending order of power.
        v: [f64; 4],
    },
    /// Two cubics u(p), v(p).
    ParamPoly3 {
        /// Coefficients of u in ascending order of power.
        u: [f64; 4],
        /// Coefficients of v in ascending order of power.
        v: [f64; 4],
        /// The range of p.
        range: ParameterRange,
    },
}

/// The kind of a compiled curve, dense so that an archive can hold it in one byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum CurveKind {
    /// [`Primitive::Line`]: no coefficients.
    Line = 0,
    /// [`Primitive::Arc`]: the curvature.
    Arc = 1,
    /// [`Primitive::Spiral`]: two curvatures, then pieces of [`SPIRAL_PIECE`] numbers.
    Spiral = 2,
    /// [`Primitive::Poly3`]: v, then pieces of [`PARAMETER_PIECE`] numbers.
    Poly3 = 3,
    /// [`Primitive::ParamPoly3`]: u, v, then pieces of [`PARAMETER_PIECE`] numbers.
    ParamPoly3 = 4,
    /// Any of them, moved into another plane ([`CurveTransform`](crate::CurveTransform)): pieces of [`TRANSFORMED_PIECE`] numbers.
    Transformed = 5,
}

/// Coefficients of a polynomial piece: degree nine. Lower degrees need more pieces for the same error, higher degrees
/// cost more than the piece they save.
pub(crate) const TERMS: usize = 10;

/// Numbers in one piece of a spiral: x(τ), then y(τ), τ ∈ [−1, 1], in ascending order of power.
pub const SPIRAL_PIECE: usize = 2 * TERMS;

/// Numbers in one piece of a poly3 or paramPoly3: the curve parameter p(τ), τ ∈ [−1, 1], in ascending order of power.
pub const PARAMETER_PIECE: usize = TERMS;

/// Numbers in one piece of a transformed curve: the heading of its middle relative to the start `[rad]`, then x(τ) and y(τ),
/// τ ∈ [−1, 1], in ascending order of power.
pub const TRANSFORMED_PIECE: usize = 1 + 2 * TERMS;

impl CurveKind {
    /// The kind a stored code stands for; `None` for codes that no release has written.
    #[must_use]
    pub fn from_code(code: u8) -> Option<Self> {
        match code {
            0 => Some(Self::Line),
            1 => Some(Self::Arc),
            2 => Some(Self::Spiral),
            3 => Some(Self::Poly3),
            4 => Some(Self::ParamPoly3),
            5 => Some(Self::Transformed),
            _ => None,
        }
    }

    /// The code to store.
    #[must_use]
    pub fn code(self) -> u8 {
        self as u8
    }
}
