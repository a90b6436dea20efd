//! Why a primitive cannot be compiled.

use super::{MAX_LENGTH, MAX_PIECES, MAX_TURNING};
use core::fmt;

/// Why a primitive cannot be compiled: the primitive, not this crate, has to change.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CompileError {
    /// The length is not in [0, [`MAX_LENGTH`]].
    Length {
        /// The length found `[m]`.
        length: f64,
    },
    /// A parameter is not finite or too large in magnitude.
    Parameter {
        /// The value found.
        value: f64,
        /// What its magnitude, or that of its term within the curve, may reach.
        limit: f64,
    },
    /// The curve turns by more than [`MAX_TURNING`].
    Turning {
        /// The turning angle at the larger curvature `[rad]`.
        turning: f64,
    },
    /// dr/dp vanishes or nearly vanishes, so that the curve has no direction there.
    VanishingSpeed {
        /// Where: the curve parameter p.
        parameter: f64,
    },
    /// The curve bends too sharply to be represented within [`MAX_PIECES`] pieces.
    TooManyPieces {
        /// The error that the most pieces reach `[m]`.
        error: f64,
    },
}

impl fmt::Display for CompileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { length } => {
                write!(f, "expected a length from 0 to {MAX_LENGTH:e} m, found {length}")
            }
            Self::Parameter { value, limit } => {
                write!(
                    f,
                    "expected a parameter that is finite and stays within {limit:e}, found {value}"
                )
            }
            Self::Turning { turning } => write!(
                f,
                "expected a curve that turns by at most {MAX_TURNING} rad, found {turning} rad: \
                 check curvature (1/m) and length"
            ),
            Self::VanishingSpeed { parameter } => write!(
                f,
                "the curve stands still at parameter {parameter} and has no direction there: \
                 check the linear coefficients"
            ),
            Self::TooManyPieces { error } => write!(
                f,
                "the curve bends too sharply: {MAX_PIECES} pieces leave an error of {error:e} m"
            ),
        }
    }
}

impl std::error::Error for CompileError {}
