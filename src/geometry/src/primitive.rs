//! What the file says, and what is made of it.

use crate::{parametric, spiral};
use thiserror::Error;

/// Pieces that one geometry may be cut into; more mean that its numbers make no sense for a road.
pub const MAX_PIECES: usize = 1 << 14;

/// Range of a paramPoly3's parameter p (OpenDRIVE 1.8.1, 9.5.1; `@pRange`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterRange {
    /// p ∈ [0, length].
    ArcLength,
    /// p ∈ [0, 1].
    Normalized,
}

/// A geometry's shape as written (OpenDRIVE 1.8.1, 9.3 to 9.5; poly3 in 1.4 to 1.7).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Primitive {
    /// Straight on.
    Line,
    /// Constant curvature.
    Arc {
        /// Curvature `[1/m]`, positive to the left; 0 is a line.
        curvature: f64,
    },
    /// Curvature that changes linearly over the length: a clothoid.
    Spiral {
        /// Curvature at the start `[1/m]`.
        curvature_start: f64,
        /// Curvature at the end `[1/m]`.
        curvature_end: f64,
    },
    /// v(u) = v₀ + v₁u + v₂u² + v₃u³ in the start's frame; u is not arc length.
    Poly3 {
        /// Coefficients in ascending order.
        v: [f64; 4],
    },
    /// u(p), v(p) cubic in the start's frame; p is not arc length.
    ParamPoly3 {
        /// Coefficients of u in ascending order.
        u: [f64; 4],
        /// Coefficients of v in ascending order.
        v: [f64; 4],
        /// Range of p.
        range: ParameterRange,
    },
}

/// Kind of a compiled curve, as archives store it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum CurveKind {
    /// Line.
    Line = 0,
    /// Arc.
    Arc = 1,
    /// Spiral.
    Spiral = 2,
    /// poly3.
    Poly3 = 3,
    /// paramPoly3.
    ParamPoly3 = 4,
}

impl CurveKind {
    /// The kind of a code; `None` for others.
    #[inline]
    pub fn from_code(code: u8) -> Option<Self> {
        Some(match code {
            0 => Self::Line,
            1 => Self::Arc,
            2 => Self::Spiral,
            3 => Self::Poly3,
            4 => Self::ParamPoly3,
            _ => return None,
        })
    }

    /// The code.
    pub fn code(self) -> u8 {
        self as u8
    }

    /// Numbers of the primitive itself, which come before the pieces.
    pub(crate) fn parameters(self) -> usize {
        match self {
            Self::Line => 0,
            Self::Arc => 1,
            Self::Spiral => 2,
            Self::Poly3 => 4,
            Self::ParamPoly3 => 8,
        }
    }

    /// Numbers of each piece; 0 where there are none.
    pub(crate) fn piece_numbers(self) -> usize {
        match self {
            Self::Line | Self::Arc => 0,
            Self::Spiral => spiral::PIECE,
            Self::Poly3 | Self::ParamPoly3 => parametric::PIECE,
        }
    }
}

/// What [`compile`] makes of a primitive.
#[derive(Clone, Debug, PartialEq)]
pub struct Compiled {
    /// The kind.
    pub kind: CurveKind,
    /// The primitive's numbers, then pieces of equal length along u.
    pub coefficients: Vec<f64>,
    /// Bound on the distance of an evaluated point from the exact curve `[m]`, rounding aside.
    pub error: f64,
    /// True arc length minus the stated length `[m]`; 0 where the two agree by definition.
    pub length_mismatch: f64,
}

/// Why a primitive cannot be compiled.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum CompileError {
    /// A number is NaN or infinite.
    #[error("its numbers must be finite")]
    NotFinite,
    /// The length is negative.
    #[error("its length must not be negative, found {0}")]
    Length(f64),
    /// It turns so much that it cannot be a road.
    #[error("it turns too often: it would need {0} pieces")]
    TooManyPieces(f64),
    /// The parametric curve stands still somewhere, or bends too sharply to be followed by arc length.
    #[error("it cannot be followed by arc length: the curve stands still or has a cusp")]
    NotSmooth,
}

/// Compiles a primitive of a length `[m]`.
///
/// Lines, arcs and spirals are exact within [`Compiled::error`] ≤ 1e-10 m. poly3 and paramPoly3 are evaluated in true
/// arc length within 1e-7 m; paramPoly3 is scaled along s so that the parameter's end falls at `length`.
///
/// Errors: numbers that are not finite or absurd; curves that stand still.
pub fn compile(primitive: &Primitive, length: f64) -> Result<Compiled, CompileError> {
    let numbers: &[f64] = match primitive {
        Primitive::Line => &[],
        Primitive::Arc { curvature } => &[*curvature],
        Primitive::Spiral { curvature_start, curvature_end } => &[*curvature_start, *curvature_end],
        Primitive::Poly3 { v } => v,
        Primitive::ParamPoly3 { u, v, .. } => &[u[0], u[1], u[2], u[3], v[0], v[1], v[2], v[3]],
    };
    if !length.is_finite() || numbers.iter().any(|n| !n.is_finite()) {
        return Err(CompileError::NotFinite);
    }
    if length < 0.0 {
        return Err(CompileError::Length(length));
    }
    let mut coefficients = numbers.to_vec();
    let exact =
        |kind, coefficients| Compiled { kind, coefficients, error: 0.0, length_mismatch: 0.0 };
    match *primitive {
        Primitive::Line => Ok(exact(CurveKind::Line, coefficients)),
        Primitive::Arc { .. } => Ok(exact(CurveKind::Arc, coefficients)),
        Primitive::Spiral { curvature_start, curvature_end } => {
            let error = spiral::pieces(curvature_start, curvature_end, length, &mut coefficients)?;
            Ok(Compiled { kind: CurveKind::Spiral, coefficients, error, length_mismatch: 0.0 })
        }
        Primitive::Poly3 { v } => {
            let fit = parametric::poly3_pieces(v, length, &mut coefficients)?;
            Ok(Compiled {
                kind: CurveKind::Poly3,
                coefficients,
                error: fit.error,
                length_mismatch: 0.0,
            })
        }
        Primitive::ParamPoly3 { u, v, range } => {
            let end = match range {
                ParameterRange::ArcLength => length,
                ParameterRange::Normalized => 1.0,
            };
            let fit = parametric::param_poly3_pieces(u, v, end, length, &mut coefficients)?;
            Ok(Compiled {
                kind: CurveKind::ParamPoly3,
                coefficients,
                error: fit.error,
                length_mismatch: fit.true_length - length,
            })
        }
    }
}
