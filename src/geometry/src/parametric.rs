//! poly3 and paramPoly3: cubics whose parameter is not arc length.
//!
//! A piece holds the parameter as a polynomial of true arc length; position, heading and curvature then come from the
//! file's own cubics, so that an evaluated point lies on the curve exactly and errs along it only.

use crate::cubic::Cubic;
use crate::gauss::integrate;
use crate::polynomial::{self, COEFFICIENTS};
use crate::primitive::{CompileError, MAX_PIECES};

/// Numbers of a piece: the parameter over [−1, 1].
pub(crate) const PIECE: usize = COEFFICIENTS;
/// Aimed-at error along the curve `[m]`.
const ERROR: f64 = 1e-7;
/// Largest error along the curve `[m]` that is accepted where pieces cannot be cut finer.
const WORST_ERROR: f64 = 1e-6;
/// Cuts after which finer ones gain nothing.
const FINEST: usize = 1 << 9;
/// Places in a piece at which the fit is compared with the exact parameter.
const PROBES: usize = 8;
/// Intervals of the table of arc lengths: first try, and the most.
const INTERVALS: (usize, usize) = (16, 4096);
/// Relative change of the length under halving at which the table counts as exact.
const CONVERGED: f64 = 1e-13;
/// Speed below this share of the mean counts as standing still.
const STANDSTILL: f64 = 1e-4;
/// Steps of an inversion; bisection alone needs 53.
const STEPS: usize = 64;

/// How well the pieces fit.
pub(crate) struct Fit {
    pub(crate) error: f64,
    pub(crate) true_length: f64,
}

/// Arc length over the parameter, tabulated.
struct ArcLength<F> {
    speed: F,
    step: f64,
    sums: Vec<f64>,
}

impl<F: Fn(f64) -> f64> ArcLength<F> {
    fn new(speed: F, end: f64) -> Result<Self, CompileError> {
        let mut count = INTERVALS.0;
        let mut last = f64::NAN;
        loop {
            let step = end / count as f64;
            let mut sums = vec![0.0];
            let mut sum = 0.0;
            for i in 0..count {
                sum += integrate(i as f64 * step, (i + 1) as f64 * step, &speed);
                sums.push(sum);
            }
            if !sum.is_finite() {
                return Err(CompileError::NotFinite);
            }
            if (sum - last).abs() <= CONVERGED * sum || count >= INTERVALS.1 {
                return Ok(Self { speed, step, sums });
            }
            last = sum;
            count *= 2;
        }
    }

    fn total(&self) -> f64 {
        self.sums.last().copied().unwrap_or(0.0)
    }

    /// Parameter at an arc length, by Newton's method held between bounds.
    fn invert(&self, length: f64) -> f64 {
        let after = self.sums.partition_point(|sum| *sum < length);
        let i = after.saturating_sub(1).min(self.sums.len().saturating_sub(2));
        let (from, base) = (i as f64 * self.step, self.sums[i]);
        let (mut low, mut high) = (from, from + self.step);
        let mut p =
            from + self.step * ((length - base) / (self.sums[i + 1] - base)).clamp(0.0, 1.0);
        for _ in 0..STEPS {
            let excess = base + integrate(from, p, &self.speed) - length;
            if excess > 0.0 {
                high = p;
            } else {
                low = p;
            }
            let newton = p - excess / (self.speed)(p);
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - p).abs() <= f64::EPSILON * p.abs() {
                return next;
            }
            p = next;
        }
        p
    }
}

/// Appends pieces of v(u); the parameter ends where the arc length reaches `length`.
pub(crate) fn poly3_pieces(
    v: [f64; 4],
    length: f64,
    out: &mut Vec<f64>,
) -> Result<Fit, CompileError> {
    let slope = Cubic::new(v);
    let speed = move |p: f64| (1.0 + slope.derivative(p) * slope.derivative(p)).sqrt();
    // Arc length grows at least as fast as u, so that u = length is far enough.
    let table = ArcLength::new(speed, length)?;
    let error = pieces(&table, length, 1.0, out)?;
    Ok(Fit { error, true_length: length })
}

/// Appends pieces of u(p), v(p) with p ∈ [0, end], scaled so that p = end falls at `length`.
pub(crate) fn param_poly3_pieces(
    u: [f64; 4],
    v: [f64; 4],
    end: f64,
    length: f64,
    out: &mut Vec<f64>,
) -> Result<Fit, CompileError> {
    let (u, v) = (Cubic::new(u), Cubic::new(v));
    let speed = move |p: f64| {
        let (du, dv) = (u.derivative(p), v.derivative(p));
        (du * du + dv * dv).sqrt()
    };
    let table = ArcLength::new(speed, end)?;
    let true_length = table.total();
    if length == 0.0 {
        return Ok(Fit { error: 0.0, true_length });
    }
    let scale = true_length / length;
    let error = pieces(&table, length, scale, out)?;
    Ok(Fit { error, true_length })
}

fn pieces<F: Fn(f64) -> f64>(
    table: &ArcLength<F>,
    length: f64,
    scale: f64,
    out: &mut Vec<f64>,
) -> Result<f64, CompileError> {
    if length == 0.0 {
        return Ok(0.0);
    }
    let end = table.step * (table.sums.len() - 1) as f64;
    let mean = table.total() / end;
    let slowest = (0..=INTERVALS.0 * 4)
        .map(|i| (table.speed)(end * i as f64 / (INTERVALS.0 * 4) as f64))
        .fold(f64::INFINITY, f64::min);
    if !(mean > 0.0 && slowest > STANDSTILL * mean) {
        return Err(CompileError::NotSmooth);
    }
    let before = out.len();
    let mut count = 1;
    loop {
        out.truncate(before);
        let error = fit(table, length, scale, count, out);
        if error <= ERROR {
            return Ok(error);
        }
        if count * 2 > FINEST.min(MAX_PIECES) {
            return if error <= WORST_ERROR { Ok(error) } else { Err(CompileError::NotSmooth) };
        }
        count *= 2;
    }
}

fn fit<F: Fn(f64) -> f64>(
    table: &ArcLength<F>,
    length: f64,
    scale: f64,
    count: usize,
    out: &mut Vec<f64>,
) -> f64 {
    let half = 0.5 * length / count as f64;
    let nodes = polynomial::nodes();
    let mut error = 0f64;
    for i in 0..count {
        let middle = (2 * i + 1) as f64 * half;
        let exact = |tau: f64| table.invert((middle + half * tau) * scale);
        let p = polynomial::fit(&nodes.map(exact));
        for k in 0..=PROBES {
            let tau = 2.0 * k as f64 / PROBES as f64 - 1.0;
            let parameter = exact(tau);
            error = error
                .max((polynomial::value(&p, tau) - parameter).abs() * (table.speed)(parameter));
        }
        out.extend_from_slice(&p);
        // A first try that is far off need not be finished.
        if error > ERROR && count < FINEST {
            return error;
        }
    }
    error
}
