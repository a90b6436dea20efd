//! Numbers of about 32 digits: the unevaluated sum of two doubles (Dekker, Knuth).

use std::ops::{Add, Div, Mul, Neg, Sub};

/// high + low, with |low| at most half a unit in the last place of high.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Double {
    pub(crate) high: f64,
    low: f64,
}

/// π/2 in three doubles' precision, of which two are kept.
const HALF_PI: Double =
    Double { high: std::f64::consts::FRAC_PI_2, low: 6.123_233_995_736_766e-17 };
/// Terms of the series of sine and cosine over a quarter of a right angle.
const TERMS: i32 = 24;

/// A sum without its rounding error, and the error.
fn two_sum(a: f64, b: f64) -> Double {
    let high = a + b;
    let part = high - a;
    Double { high, low: (a - (high - part)) + (b - part) }
}

/// As [`two_sum`], where |a| ≥ |b|.
fn quick_two_sum(a: f64, b: f64) -> Double {
    let high = a + b;
    Double { high, low: b - (high - a) }
}

impl From<f64> for Double {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = (two_sum(self.high, other.high), two_sum(self.low, other.low));
        let sum = quick_two_sum(high.high, high.low + low.high);
        quick_two_sum(sum.high, sum.low + low.low)
    }
}

impl Neg for Double {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let high = self.high * other.high;
        let error = self.high.mul_add(other.high, -high);
        quick_two_sum(high, error + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Double {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        // Each quotient of leading parts takes 16 digits off the remainder.
        let first = self.high / other.high;
        let remainder = self - other * first.into();
        let second = remainder.high / other.high;
        let remainder = remainder - other * second.into();
        Self::from(first) + second.into() + (remainder.high / other.high).into()
    }
}

impl Double {
    /// The nearest double.
    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }

    pub(crate) fn abs(self) -> f64 {
        self.value().abs()
    }

    /// Of a number that is not negative.
    pub(crate) fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return 0.0.into();
        }
        // Newton's step from the double's root doubles its digits; a second one is for rounding.
        let step = |root: Self| (root + self / root) * 0.5.into();
        step(step(self.high.sqrt().into()))
    }

    /// Sine and cosine, by their series about the nearest multiple of a right angle.
    pub(crate) fn sin_cos(self) -> (Self, Self) {
        let quarter = (self.high / HALF_PI.high).round();
        // Halved twice, so that the series is short, and doubled twice again.
        let x = (self - HALF_PI * quarter.into()) * 0.25.into();
        let square = x * x;
        let (mut sin, mut cos) = (x, Self::from(1.0));
        let (mut odd, mut even) = (x, Self::from(1.0));
        for k in 1..TERMS {
            let k = f64::from(2 * k);
            even = -(even * square) / (k * (k - 1.0)).into();
            odd = -(odd * square) / (k * (k + 1.0)).into();
            (sin, cos) = (sin + odd, cos + even);
        }
        for _ in 0..2 {
            (sin, cos) = (sin * cos * 2.0.into(), cos * cos - sin * sin);
        }
        match quarter.rem_euclid(4.0) as u8 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }
}

/// Nodes of the Gauss–Legendre rule.
const NODES: usize = 12;
/// Halvings of an interval at most.
const DEPTH: u32 = 40;
/// Two approximations of an integral that differ by less agree.
const AGREEMENT: f64 = 1e-24;

/// Adaptive integration.
pub(crate) struct Rule(Vec<(Double, Double)>);

impl Rule {
    pub(crate) fn new() -> Self {
        let legendre = |x: Double| {
            let (mut before, mut current) = (Double::from(1.0), x);
            for k in 2..=NODES {
                let k = k as f64;
                let next =
                    (x * current * (2.0 * k - 1.0).into() - before * (k - 1.0).into()) / k.into();
                (before, current) = (current, next);
            }
            let slope = (x * current - before) * (NODES as f64).into() / (x * x - 1.0.into());
            (current, slope)
        };
        let node = |i: usize| {
            let guess = (std::f64::consts::PI * (i as f64 + 0.75) / (NODES as f64 + 0.5)).cos();
            let mut x = Double::from(guess);
            for _ in 0..8 {
                let (value, slope) = legendre(x);
                x = x - value / slope;
            }
            let slope = legendre(x).1;
            (x, Double::from(2.0) / ((Double::from(1.0) - x * x) * slope * slope))
        };
        Self((0..NODES).map(node).collect())
    }

    fn panel<const N: usize>(
        &self,
        f: &impl Fn(Double) -> [Double; N],
        from: Double,
        to: Double,
    ) -> [Double; N] {
        let (half, middle) = ((to - from) * 0.5.into(), (to + from) * 0.5.into());
        let mut sums = [Double::from(0.0); N];
        for (node, weight) in &self.0 {
            for (sum, value) in sums.iter_mut().zip(f(middle + half * *node)) {
                *sum = *sum + value * *weight;
            }
        }
        sums.map(|sum| sum * half)
    }

    /// The integrals of all components of `f`.
    pub(crate) fn integrate<const N: usize>(
        &self,
        f: &impl Fn(Double) -> [Double; N],
        from: Double,
        to: Double,
    ) -> [Double; N] {
        let whole = self.panel(f, from, to);
        self.refine(f, (from, to), whole, DEPTH)
    }

    fn refine<const N: usize>(
        &self,
        f: &impl Fn(Double) -> [Double; N],
        (from, to): (Double, Double),
        whole: [Double; N],
        depth: u32,
    ) -> [Double; N] {
        let middle = (from + to) * 0.5.into();
        let halves = [self.panel(f, from, middle), self.panel(f, middle, to)];
        let both: [Double; N] = std::array::from_fn(|k| halves[0][k] + halves[1][k]);
        let scale = (to - from).abs().max(1.0);
        let agree = whole.iter().zip(both).all(|(a, b)| (*a - b).abs() <= AGREEMENT * scale);
        if agree || depth == 0 {
            return both;
        }
        let left = self.refine(f, (from, middle), halves[0], depth - 1);
        let right = self.refine(f, (middle, to), halves[1], depth - 1);
        std::array::from_fn(|k| left[k] + right[k])
    }
}
