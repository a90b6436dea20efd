//! Plane curves and cubic profiles of an OpenDRIVE reference line: compile, evaluate, project.
//!
//! A [`Primitive`] is what the file says. [`compile`] turns it into numbers that are cheap to evaluate, with a bound on
//! their error; a [`Curve`] borrows these numbers and evaluates or projects.
//!
//! Invariants: evaluation and projection allocate nothing, keep no state and never panic, whatever the numbers; every
//! transcendental function comes from `libm`, so that results are equal bit for bit on every machine. Deliberately
//! absent: roads, lanes and anything that knows s of a road (here u runs from 0 to a geometry's length).
//!
//! ```
//! use mapd_geometry::{Curve, Primitive, Start, compile};
//!
//! let compiled = compile(&Primitive::Arc { curvature: 0.1 }, 5.0).unwrap();
//! let curve = Curve::new(compiled.kind, Start::new(0.0, 0.0, 0.0), 5.0, &compiled.coefficients).unwrap();
//! let end = curve.evaluate(5.0);
//! assert!((end.heading - 0.5).abs() < 1e-15);
//! assert!((curve.project(end.x, end.y).u - 5.0).abs() < 1e-12);
//! ```

mod arc;
mod cubic;
mod curve;
mod gauss;
mod parametric;
mod polynomial;
mod primitive;
mod project;
mod spiral;

pub use cubic::Cubic;
pub use curve::{Curve, CurvePoint, Start};
pub use primitive::{
    CompileError, Compiled, CurveKind, MAX_PIECES, ParameterRange, Primitive, compile,
};
pub use project::Projection;

use std::f64::consts::{PI, TAU};

/// Cosine and sine of an angle `[rad]`, by `libm`.
#[inline]
pub fn cos_sin(angle: f64) -> (f64, f64) {
    let (sin, cos) = libm::sincos(angle);
    (cos, sin)
}

/// An angle `[rad]` moved into (−π, π]. Not finite stays not finite.
pub fn normalize_angle(angle: f64) -> f64 {
    if angle > -PI && angle <= PI {
        return angle;
    }
    let turned = angle - TAU * ((angle + PI) / TAU).floor();
    if turned <= -PI {
        turned + TAU
    } else if turned > PI {
        turned - TAU
    } else {
        turned
    }
}
