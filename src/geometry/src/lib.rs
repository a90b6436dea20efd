//! Plane curves and cubic profiles of an OpenDRIVE reference line: compile, evaluate, project.
//!
//! Plain arguments in, plain results out. A primitive as written ([`Primitive`]) is compiled once into a list of numbers
//! ([`compile()`]), which can be stored anywhere; a [`Curve`] borrows that list and answers.
//!
//! Invariants: evaluation and projection allocate nothing, do no I/O, hold no global state, and neither panic nor loop
//! without bound on coefficients that are wrong. The same arguments give the same bits on every machine:
//! sines and cosines come from `libm`, never from the system, and no operation is fused. Deliberately absent: which
//! record holds where, lanes, and chains of geometries, which the crates above add; [`surface`] has the heights of one place.
//!
//! Lengths are in metres, angles in radians, counter-clockwise positive; curvature is positive to the left.
//!
//! ```
//! use mapd_geometry::{Curve, Primitive, Start, compile};
//!
//! // A transition from straight to a left curve of 50 m radius, starting at (100, 200), heading north.
//! let spiral = Primitive::Spiral { curvature_start: 0.0, curvature_end: 0.02 };
//! let compiled = compile(&spiral, 40.0)?;
//! let start = Start::new(100.0, 200.0, std::f64::consts::FRAC_PI_2);
//! let curve = Curve::new(compiled.kind, start, 40.0, &compiled.coefficients).expect("just compiled");
//!
//! let end = curve.evaluate(40.0);
//! assert!((end.heading - (start.heading + 0.4)).abs() < 1e-12);
//!
//! // A point 2 m to the left of the end finds its foot there.
//! let foot = curve.project(end.x - 2.0 * end.sin, end.y + 2.0 * end.cos);
//! assert!((foot.u - 40.0).abs() < 1e-9 && (foot.lateral - 2.0).abs() < 1e-9);
//! # Ok::<(), mapd_geometry::CompileError>(())
//! ```

mod angle;
mod arc;
mod attitude;
mod bends;
mod compile;
mod cubic;
mod cubic_part;
mod curve;
mod nearest;
mod parametric;
mod piecewise;
mod point;
mod primitive;
mod spiral;
pub mod surface;
mod transformed;

pub use angle::{atan2, beside, cos_sin, floor, hypot, normalize_angle};
pub use attitude::Attitude;
pub use bends::{Bends, BendsFrom};
pub use compile::{
    Chart, CompileError, Compiled, CurveTransform, MAX_LENGTH, MAX_PIECES, MAX_TURNING,
    TransformError, TransformedCurve, compile,
};
pub use cubic::Cubic;
pub use cubic_part::CubicPart;
pub use curve::{Curve, OnlyFoot};
pub use point::{CurvePoint, CurveRates, Projection, Tangent};
pub use primitive::{
    CurveKind, PARAMETER_PIECE, ParameterRange, Primitive, SPIRAL_PIECE, Start, TRANSFORMED_PIECE,
};

/// `value` within [lo, hi]; not-a-number becomes `lo`. Unlike `f64::clamp` it cannot panic, and unlike `f64::max` it
/// never returns a zero of unspecified sign.
#[inline]
#[must_use]
pub fn clamp(value: f64, lo: f64, hi: f64) -> f64 {
    if value > lo { if value < hi { value } else { hi } } else { lo }
}
