//! From a primitive as written to the numbers a [`Curve`](crate::Curve) evaluates.

mod arc_length;
mod chebyshev;
mod error;
mod parametric;
mod spiral;
mod transform;

use crate::primitive::{CurveKind, ParameterRange, Primitive};
pub use error::CompileError;
pub use transform::{Chart, CurveTransform, TransformError, TransformedCurve};

/// The longest geometry that is compiled `[m]`: more than twice around the earth.
pub const MAX_LENGTH: f64 = 1e8;

/// The largest turning angle of an arc or a spiral `[rad]`: forty full circles.
pub const MAX_TURNING: f64 = 256.0;

/// The most pieces a curve is cut into, which also bounds the memory a hostile file can ask for: 160 kB per geometry.
pub const MAX_PIECES: usize = 1024;

/// The largest |curvature| `[1/m]`: a radius of a micrometre.
const MAX_CURVATURE: f64 = 1e6;

/// The largest magnitude `[m]` that one term of a cubic may reach within its range.
const MAX_TERM: f64 = 1e9;

/// Rounding errors per operation chain, as a multiple of length × ε, in the closed forms.
const ROUNDINGS: f64 = 4.0;

/// A compiled primitive: what to store, and how good it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Compiled {
    /// What the coefficients mean.
    pub kind: CurveKind,
    /// The primitive's own parameters as written, then pieces of equal length; see [`CurveKind`].
    pub coefficients: Vec<f64>,
    /// Bound of the distance between the compiled and the exact curve at the same u `[m]`.
    pub error: f64,
    /// True arc length minus the written length of a paramPoly3 `[m]`. Zero for the other kinds, whose parameter is arc
    /// length (line, arc, spiral) or ends where the written length is used up (poly3).
    pub length_mismatch: f64,
}

/// Compiles a primitive of the given written length `[m]`.
///
/// # Errors
///
/// [`CompileError`] if the length or a parameter is not finite, negative where it must not be, or absurdly large, if the
/// curve stands still somewhere (its direction is then undefined), or if [`MAX_PIECES`] do not reach the accuracy.
///
/// Deterministic: the same arguments give the same bits on every machine.
pub fn compile(primitive: &Primitive, length: f64) -> Result<Compiled, CompileError> {
    if !(0.0..=MAX_LENGTH).contains(&length) {
        return Err(CompileError::Length { length });
    }
    match *primitive {
        Primitive::Line => Ok(Compiled {
            kind: CurveKind::Line,
            coefficients: Vec::new(),
            error: rounding(length),
            length_mismatch: 0.0,
        }),
        Primitive::Arc { curvature } => {
            check_turning(&[curvature], length)?;
            Ok(Compiled {
                kind: CurveKind::Arc,
                coefficients: vec![curvature],
                error: rounding(length) * (1.0 + curvature.abs() * length),
                length_mismatch: 0.0,
            })
        }
        Primitive::Spiral { curvature_start, curvature_end } => {
            check_turning(&[curvature_start, curvature_end], length)?;
            spiral::compile(curvature_start, curvature_end, length)
        }
        Primitive::Poly3 { v } => {
            check_terms(&v, length)?;
            parametric::compile_poly3(&v, length)
        }
        Primitive::ParamPoly3 { u, v, range } => {
            let end = match range {
                ParameterRange::ArcLength => length,
                ParameterRange::Normalized => 1.0,
            };
            check_terms(&u, end)?;
            check_terms(&v, end)?;
            parametric::compile_param_poly3(&u, &v, end, length)
        }
    }
}

/// The rounding error of a closed form over `length` `[m]`.
fn rounding(length: f64) -> f64 {
    ROUNDINGS * f64::EPSILON * length
}

/// Curvatures are finite and sane, and so is the angle they turn by.
fn check_turning(curvatures: &[f64], length: f64) -> Result<(), CompileError> {
    for &curvature in curvatures {
        if !(-MAX_CURVATURE..=MAX_CURVATURE).contains(&curvature) {
            return Err(CompileError::Parameter { value: curvature, limit: MAX_CURVATURE });
        }
        let turning = curvature.abs() * length;
        if turning > MAX_TURNING {
            return Err(CompileError::Turning { turning });
        }
    }
    Ok(())
}

/// Every coefficient is finite, and no term of the cubic leaves the plane that f64 resolves.
fn check_terms(coefficients: &[f64; 4], end: f64) -> Result<(), CompileError> {
    let mut power = 1.0;
    for &value in coefficients {
        if !(value.abs() <= MAX_TERM && value.abs() * power <= MAX_TERM) {
            return Err(CompileError::Parameter { value, limit: MAX_TERM });
        }
        power *= end;
    }
    Ok(())
}
