//! Independent values for curves: nothing but quadrature of the definitions, slow and simple.

use mapd_geometry::{Compiled, Curve, CurveKind, ParameterRange, Primitive, Start, compile};
use std::f64::consts::PI;

/// Nodes of the Gauss–Legendre rule.
const NODES: usize = 20;
/// Turning angle per panel of a spiral `[rad]`; the rule is exact to rounding there.
const PANEL_TURNING: f64 = 0.5;
/// Panels of a parametric cubic.
const PANELS: usize = 400;
/// Halvings that find a parameter.
const HALVINGS: usize = 60;

/// A small, fast, repeatable generator (splitmix64).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [lo, hi).
    pub(crate) fn range(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// Uniform in its logarithm.
    pub(crate) fn magnitude(&mut self, lo: f64, hi: f64) -> f64 {
        self.range(lo.ln(), hi.ln()).exp()
    }

    pub(crate) fn index(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }

    pub(crate) fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.index(from.len())]
    }

    pub(crate) fn start(&mut self) -> Start {
        Start::new(self.range(-1e4, 1e4), self.range(-1e4, 1e4), self.range(-7.0, 7.0))
    }

    /// An arc or spiral that turns by at most `turning`.
    pub(crate) fn arc_or_spiral(&mut self, turning: f64) -> (Primitive, f64) {
        let length = self.magnitude(1e-6, 1e3);
        let limit = (self.magnitude(1e-6, 1.0) * turning / length).min(0.2);
        let (from, to) = (self.range(-limit, limit), self.range(-limit, limit));
        let primitive = match self.index(4) {
            0 => Primitive::Arc { curvature: from },
            1 => Primitive::Spiral { curvature_start: 0.0, curvature_end: to },
            2 => Primitive::Spiral { curvature_start: from, curvature_end: from * (1.0 + 1e-9) },
            _ => Primitive::Spiral { curvature_start: from, curvature_end: to },
        };
        (primitive, length)
    }

    /// A poly3 or paramPoly3 as roads have them: no cusp, at most about a right angle of turning.
    pub(crate) fn cubic(&mut self) -> (Primitive, f64) {
        let length = self.magnitude(0.1, 300.0);
        let bend = |random: &mut Self, power: i32, limit: f64| {
            random.range(-limit, limit) / length.powi(power - 1)
        };
        if self.index(3) == 0 {
            let v = [
                self.range(-1.0, 1.0),
                self.range(-0.3, 0.3),
                bend(self, 2, 0.5),
                bend(self, 3, 0.3),
            ];
            return (Primitive::Poly3 { v }, length);
        }
        // With |c|, |d| this small the speed stays above a third of b.
        let u = [0.0, 1.0, bend(self, 2, 0.15), bend(self, 3, 0.1)];
        let v = [0.0, 0.0, bend(self, 2, 0.6), bend(self, 3, 0.4)];
        if self.index(2) == 0 {
            return (Primitive::ParamPoly3 { u, v, range: ParameterRange::ArcLength }, length);
        }
        let normalize = |c: [f64; 4]| std::array::from_fn(|k| c[k] * length.powi(k as i32));
        let range = ParameterRange::Normalized;
        (Primitive::ParamPoly3 { u: normalize(u), v: normalize(v), range }, length)
    }
}

/// A compiled primitive with all that a [`Curve`] borrows.
pub(crate) struct Sample {
    pub(crate) primitive: Primitive,
    pub(crate) length: f64,
    pub(crate) start: Start,
    pub(crate) compiled: Compiled,
}

impl Sample {
    pub(crate) fn new(primitive: Primitive, length: f64, start: Start) -> Self {
        let compiled = compile(&primitive, length)
            .unwrap_or_else(|error| panic!("{primitive:?} over {length}: {error}"));
        Self { primitive, length, start, compiled }
    }

    pub(crate) fn curve(&self) -> Curve<'_> {
        let Compiled { kind, coefficients, .. } = &self.compiled;
        Curve::new(*kind, self.start, self.length, coefficients).expect("as compiled")
    }

    /// Number of pieces.
    pub(crate) fn pieces(&self) -> usize {
        let (parameters, numbers) = shape(self.compiled.kind);
        self.compiled.coefficients.len().saturating_sub(parameters) / numbers.max(1)
    }
}

/// Numbers of the primitive, and of one piece, that the documentation promises.
pub(crate) fn shape(kind: CurveKind) -> (usize, usize) {
    match kind {
        CurveKind::Line => (0, 0),
        CurveKind::Arc => (1, 0),
        CurveKind::Spiral => (2, 20),
        CurveKind::Poly3 => (4, 10),
        CurveKind::ParamPoly3 => (8, 10),
        CurveKind::Transformed => (0, 21),
    }
}

/// An exact point; the heading is continuous from the start.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exact {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) heading: f64,
    pub(crate) curvature: f64,
}

pub(crate) struct Oracle {
    start: Start,
    length: f64,
    rule: Vec<(f64, f64)>,
    shape: Shape,
}

enum Shape {
    Spiral {
        from: f64,
        to: f64,
    },
    /// u and v, the end of the parameter, and true arc lengths and continuous headings at the panel borders.
    Cubics {
        u: [f64; 4],
        v: [f64; 4],
        end: f64,
        sums: Vec<f64>,
        headings: Vec<f64>,
        used: f64,
    },
}

impl Oracle {
    pub(crate) fn new(sample: &Sample) -> Self {
        let rule = rule();
        let length = sample.length;
        let shape = match sample.primitive {
            Primitive::Line => Shape::Spiral { from: 0.0, to: 0.0 },
            Primitive::Arc { curvature } => Shape::Spiral { from: curvature, to: curvature },
            Primitive::Spiral { curvature_start, curvature_end } => {
                Shape::Spiral { from: curvature_start, to: curvature_end }
            }
            Primitive::Poly3 { v } => cubics(&rule, [0.0, 1.0, 0.0, 0.0], v, length, Some(length)),
            Primitive::ParamPoly3 { u, v, range } => {
                let end = if range == ParameterRange::Normalized { 1.0 } else { length };
                cubics(&rule, u, v, end, None)
            }
        };
        Self { start: sample.start, length, rule, shape }
    }

    /// True arc length [m].
    pub(crate) fn true_length(&self) -> f64 {
        match &self.shape {
            Shape::Spiral { .. } => self.length,
            Shape::Cubics { used, .. } => *used,
        }
    }

    pub(crate) fn at(&self, u: f64) -> Exact {
        let (x, y, turned, curvature) = match &self.shape {
            Shape::Spiral { from, to } => self.spiral(*from, *to, u),
            Shape::Cubics { u: cu, v: cv, end, sums, headings, used } => {
                let share = if self.length > 0.0 { u / self.length } else { 0.0 };
                let p = parameter(&self.rule, cu, cv, *end, sums, share * used);
                let (du, dv) = (slope(cu, p), slope(cv, p));
                let panel = ((p / end * PANELS as f64) as usize).min(PANELS - 1);
                let heading = unwrap(headings[panel], dv.atan2(du));
                let speed = du.hypot(dv);
                let curvature = (du * bend(cv, p) - dv * bend(cu, p)) / speed.powi(3);
                (value(cu, p), value(cv, p), heading, curvature)
            }
        };
        let (sin, cos) = self.start.heading.sin_cos();
        Exact {
            x: self.start.x + (cos * x - sin * y),
            y: self.start.y + (sin * x + cos * y),
            heading: self.start.heading + turned,
            curvature,
        }
    }

    fn spiral(&self, from: f64, to: f64, u: f64) -> (f64, f64, f64, f64) {
        let change = if self.length > 0.0 { (to - from) / self.length } else { 0.0 };
        let heading = |w: f64| w * (from + 0.5 * change * w);
        let panels = (from.abs().max(to.abs()) * u / PANEL_TURNING).ceil().max(1.0) as usize;
        let step = u / panels as f64;
        let (mut x, mut y) = (0.0, 0.0);
        for panel in 0..panels {
            for (node, weight) in &self.rule {
                let (sin, cos) = heading((panel as f64 + 0.5 + 0.5 * node) * step).sin_cos();
                x += 0.5 * step * weight * cos;
                y += 0.5 * step * weight * sin;
            }
        }
        (x, y, heading(u), from + change * u)
    }
}

fn cubics(rule: &[(f64, f64)], u: [f64; 4], v: [f64; 4], end: f64, used: Option<f64>) -> Shape {
    let border = |i: usize| end * i as f64 / PANELS as f64;
    let (mut sums, mut headings) = (vec![0.0], vec![slope(&v, 0.0).atan2(slope(&u, 0.0))]);
    for i in 0..PANELS {
        sums.push(sums[i] + arc(rule, &u, &v, border(i), border(i + 1)));
        let p = border(i + 1);
        headings.push(unwrap(headings[i], slope(&v, p).atan2(slope(&u, p))));
    }
    let used = used.unwrap_or(sums[PANELS]);
    Shape::Cubics { u, v, end, sums, headings, used }
}

/// The parameter at a true arc length, by halving alone.
fn parameter(
    rule: &[(f64, f64)],
    u: &[f64; 4],
    v: &[f64; 4],
    end: f64,
    sums: &[f64],
    length: f64,
) -> f64 {
    let panel = sums.partition_point(|sum| *sum < length).clamp(1, PANELS) - 1;
    let from = end * panel as f64 / PANELS as f64;
    let (mut low, mut high) = (from, end * (panel + 1) as f64 / PANELS as f64);
    for _ in 0..HALVINGS {
        let p = 0.5 * (low + high);
        if sums[panel] + arc(rule, u, v, from, p) < length {
            low = p;
        } else {
            high = p;
        }
    }
    0.5 * (low + high)
}

fn arc(rule: &[(f64, f64)], u: &[f64; 4], v: &[f64; 4], from: f64, to: f64) -> f64 {
    let half = 0.5 * (to - from);
    let speed = |p: f64| slope(u, p).hypot(slope(v, p));
    rule.iter().map(|(node, weight)| half * weight * speed(from + half * (1.0 + node))).sum()
}

fn value(c: &[f64; 4], p: f64) -> f64 {
    c[0] + c[1] * p + c[2] * p * p + c[3] * p * p * p
}

fn slope(c: &[f64; 4], p: f64) -> f64 {
    c[1] + 2.0 * c[2] * p + 3.0 * c[3] * p * p
}

fn bend(c: &[f64; 4], p: f64) -> f64 {
    2.0 * c[2] + 6.0 * c[3] * p
}

/// `angle` plus whole turns, as near to `near` as it gets.
fn unwrap(near: f64, angle: f64) -> f64 {
    angle + 2.0 * PI * ((near - angle) / (2.0 * PI)).round()
}

/// Gauss–Legendre nodes and weights by Newton's method on the Legendre polynomial.
fn rule() -> Vec<(f64, f64)> {
    let legendre = |x: f64| {
        let (mut before, mut current) = (1.0, x);
        for k in 2..=NODES {
            let k = k as f64;
            (before, current) = (current, ((2.0 * k - 1.0) * x * current - (k - 1.0) * before) / k);
        }
        (current, NODES as f64 * (x * current - before) / (x * x - 1.0))
    };
    (0..NODES)
        .map(|i| {
            let mut x = (PI * (i as f64 + 0.75) / (NODES as f64 + 0.5)).cos();
            for _ in 0..20 {
                let (value, slope) = legendre(x);
                x -= value / slope;
            }
            let slope = legendre(x).1;
            (x, 2.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}
