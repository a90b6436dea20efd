//! Compiling poly3 and paramPoly3: the curve parameter as a piecewise polynomial of arc length.

use super::arc_length::ArcLength;
use super::chebyshev::{checks, interpolate, nodes};
use super::{CompileError, Compiled, MAX_PIECES, rounding};
use crate::parametric::{Cubics, IDENTITY};
use crate::piecewise::value;
use crate::primitive::{CurveKind, PARAMETER_PIECE, TERMS};

/// Displacement along the curve allowed to the pieces `[m]`.
const TOLERANCE: f64 = 1e-8;

/// Displacement allowed per metre of length, for curves so long that [`TOLERANCE`] nears the rounding of a coordinate.
const RELATIVE_TOLERANCE: f64 = 1e-13;

/// What the largest displacement seen at the check points is multiplied by to bound those between them.
const UNSEEN: f64 = 1.5;

/// `v(u)` over the abscissae that `length` of arc uses up.
pub(super) fn compile_poly3(v: &[f64; 4], length: f64) -> Result<Compiled, CompileError> {
    let cubics = Cubics { u: IDENTITY, v };
    // Arc length is never shorter than the abscissa, so the end lies within.
    let arc_length = ArcLength::new(cubics, length)?;
    let fitted = fit(&arc_length, cubics, v.to_vec(), length, length)?;
    Ok(Compiled { kind: CurveKind::Poly3, length_mismatch: 0.0, ..fitted })
}

/// `u(p), v(p)` over p ∈ [0, `end`], spread evenly over the written `length`.
pub(super) fn compile_param_poly3(
    u: &[f64; 4],
    v: &[f64; 4],
    end: f64,
    length: f64,
) -> Result<Compiled, CompileError> {
    let cubics = Cubics { u, v };
    let arc_length = ArcLength::new(cubics, end)?;
    let total = arc_length.total();
    let parameters = [*u, *v].concat();
    let fitted =
        fit(&arc_length, cubics, parameters, if length > 0.0 { total } else { 0.0 }, length)?;
    Ok(Compiled { kind: CurveKind::ParamPoly3, length_mismatch: total - length, ..fitted })
}

/// Appends to `coefficients` as few pieces as the tolerance allows for the first `used` metres of arc.
fn fit(
    arc_length: &ArcLength<'_>,
    cubics: Cubics<'_>,
    coefficients: Vec<f64>,
    used: f64,
    length: f64,
) -> Result<Compiled, CompileError> {
    let tolerance = TOLERANCE.max(RELATIVE_TOLERANCE * used);
    let mut count = 1;
    loop {
        let (pieces, error) = cut(arc_length, cubics, used, count, tolerance);
        if error <= tolerance {
            return Ok(Compiled {
                kind: CurveKind::ParamPoly3,
                coefficients: [coefficients, pieces].concat(),
                error: error + rounding(length.max(used)),
                length_mismatch: 0.0,
            });
        }
        if count == MAX_PIECES {
            return Err(CompileError::TooManyPieces { error });
        }
        count = (count + count.div_ceil(2)).min(MAX_PIECES);
    }
}

/// `count` pieces, and the bound of their displacement `[m]`; stops at the first piece that is worse than `tolerance`.
fn cut(
    arc_length: &ArcLength<'_>,
    cubics: Cubics<'_>,
    used: f64,
    count: usize,
    tolerance: f64,
) -> (Vec<f64>, f64) {
    let mut pieces = Vec::with_capacity(count * PARAMETER_PIECE);
    let mut worst = 0.0_f64;
    let (nodes, checks) = (nodes(), checks());
    for index in 0..count {
        let at = |t: f64| {
            let share = (index as f64 + 0.5 * (t + 1.0)) / count as f64;
            arc_length.parameter(share * used)
        };
        let piece: [f64; TERMS] = interpolate(&nodes.map(at));
        for t in checks {
            let exact = at(t);
            let displaced = (value(&piece, t) - exact).abs() * cubics.first(exact).length();
            // Not-a-number must not pass for no displacement.
            worst =
                if displaced.is_finite() { worst.max(UNSEEN * displaced) } else { f64::INFINITY };
        }
        if worst > tolerance {
            break;
        }
        pieces.extend(piece);
    }
    (pieces, worst)
}
