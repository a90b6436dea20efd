//! The arc length of a plane cubic as a function of its parameter, and the inverse.

use super::CompileError;
use crate::clamp;
use crate::parametric::Cubics;

/// Positive nodes and weights of the ten-point Gauss–Legendre rule.
const RULE: [(f64, f64); 5] = [
    (0.148_874_338_981_631_22, 0.295_524_224_714_752_87),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_35),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
];

/// A panel is halved until its two halves agree with it to this part of the whole length, twice the rounding of a sum.
const AGREEMENT: f64 = 1e-14;

/// Halvings of the parameter range. A kink, the only thing that needs many, is resolved to 1e-9 of it.
const MAX_HALVINGS: u32 = 30;

/// Speeds below this part of the mean speed count as standing still.
const MIN_SPEED: f64 = 1e-6;

/// Mean speeds below this count as standing still `[m per unit of parameter]`.
const MIN_MEAN_SPEED: f64 = 1e-9;

/// Positive node and weights of the three-point rule, for parts of a panel that are at most [`SHORT`].
const SHORT_NODE: f64 = 0.774_596_669_241_483_4;
const SHORT_WEIGHTS: [f64; 2] = [8.0 / 9.0, 5.0 / 9.0];

/// Share of a panel over which the three-point rule is exact to rounding: the ten-point rule is so over the whole, and the error of
/// the three-point one falls with the seventh power of the share.
const SHORT: f64 = 1e-2;

/// Steps of an inversion, each kept within its bracket by bisection.
const MAX_STEPS: usize = 60;

/// A step of at most this share of a panel is the last: what remains is of the size of its third power.
const LAST_STEP: f64 = 1e-6;

/// Arc length up to a panel border, and the speed there.
#[derive(Clone, Copy)]
struct Border {
    parameter: f64,
    length: f64,
    speed: f64,
}

/// Arc length over [0, end], in panels short enough for one application of the rule.
pub(super) struct ArcLength<'a> {
    cubics: Cubics<'a>,
    borders: Vec<Border>,
}

impl<'a> ArcLength<'a> {
    /// Integrates over p ∈ [0, `end`].
    ///
    /// # Errors
    ///
    /// [`CompileError::VanishingSpeed`] if dr/dp vanishes at the start or nearly vanishes anywhere the rule looks; it
    /// looks closest where the speed has a kink.
    pub(super) fn new(cubics: Cubics<'a>, end: f64) -> Result<Self, CompileError> {
        let start = Border { parameter: 0.0, length: 0.0, speed: cubics.first(0.0).length() };
        let mut arc_length = Self { cubics, borders: vec![start] };
        let estimate = arc_length.integrate(0.0, end);
        let mut slowest = Slowest { parameter: 0.0, speed: start.speed };
        slowest.look(&cubics, end);
        arc_length.halve(0.0, end, estimate, AGREEMENT * estimate, MAX_HALVINGS, &mut slowest);
        let mean = if end > 0.0 { arc_length.total() / end } else { slowest.speed };
        if !(mean > MIN_MEAN_SPEED && slowest.speed > MIN_SPEED * mean) {
            return Err(CompileError::VanishingSpeed { parameter: slowest.parameter });
        }
        Ok(arc_length)
    }

    /// The whole length `[m]`.
    pub(super) fn total(&self) -> f64 {
        self.borders.last().map_or(0.0, |border| border.length)
    }

    /// The parameter at arc length `length` `[m]`, which lies in [0, total].
    pub(super) fn parameter(&self, length: f64) -> f64 {
        let after = self.borders.partition_point(|border| border.length < length);
        let (Some(&low), Some(&high)) =
            (self.borders.get(after.saturating_sub(1)), self.borders.get(after))
        else {
            // Beyond the last border by rounding only.
            return self.borders.last().map_or(0.0, |border| border.parameter);
        };
        let (mut below, mut above) = (low.parameter, high.parameter);
        let width = above - below;
        let mut p = guess(&low, &high, length);
        let mut reached = low.length + self.integrate(low.parameter, p);
        for _ in 0..MAX_STEPS {
            let excess = reached - length;
            if excess > 0.0 {
                above = p;
            } else {
                below = p;
            }
            // Newton's step, and how the speed changes on it (Chebyshev's method).
            let first = self.cubics.first(p);
            let squared = first.length_squared();
            let step = excess / squared.sqrt();
            let change = first.dot(self.cubics.second(p)) / squared;
            let next = p - step * (1.0 + 0.5 * change * step);
            if step.abs() <= LAST_STEP * width {
                // Of the bracket, rounding alone leads out.
                return if next.is_finite() {
                    clamp(next, low.parameter, high.parameter)
                } else {
                    p
                };
            }
            let inside = below < next && next < above;
            let before = p;
            p = if inside { next } else { 0.5 * (below + above) };
            reached = if (p - before).abs() <= SHORT * width {
                reached + self.integrate_short(before, p)
            } else {
                low.length + self.integrate(low.parameter, p)
            };
        }
        p
    }

    /// One application of the rule.
    #[inline]
    fn integrate(&self, from: f64, to: f64) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        // All speeds before their sum: they do not wait for each other.
        let speed = |p: f64| self.cubics.first(p).length();
        let before = RULE.map(|(node, _)| speed(middle - half * node));
        let behind = RULE.map(|(node, _)| speed(middle + half * node));
        let pairs = before.iter().zip(&behind).zip(RULE);
        let sum: f64 =
            pairs.map(|((before, behind), (_, weight))| weight * (before + behind)).sum();
        half * sum
    }

    /// One application of the three-point rule.
    fn integrate_short(&self, from: f64, to: f64) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let speed = |p: f64| self.cubics.first(p).length();
        let [at_middle, beside] = SHORT_WEIGHTS;
        let away = half * SHORT_NODE;
        half * (at_middle * speed(middle) + beside * (speed(middle - away) + speed(middle + away)))
    }

    /// Appends borders up to `to`, halving while that changes the integral.
    fn halve(
        &mut self,
        from: f64,
        to: f64,
        whole: f64,
        tolerance: f64,
        halvings: u32,
        slowest: &mut Slowest,
    ) {
        let middle = 0.5 * (from + to);
        let (first, second) = (self.integrate(from, middle), self.integrate(middle, to));
        slowest.look(&self.cubics, middle);
        let agreed = (first + second - whole).abs() <= tolerance;
        if agreed || halvings == 0 {
            for (parameter, part) in [(middle, first), (to, second)] {
                let length = self.total() + part;
                let speed = self.cubics.first(parameter).length();
                self.borders.push(Border { parameter, length, speed });
            }
        } else {
            self.halve(from, middle, first, tolerance, halvings - 1, slowest);
            self.halve(middle, to, second, tolerance, halvings - 1, slowest);
        }
    }
}

/// The parameter at an arc length between two borders, about: the cubic with the right ends and the right slopes there.
fn guess(low: &Border, high: &Border, length: f64) -> f64 {
    let (width, span) = (high.parameter - low.parameter, high.length - low.length);
    let share = if span > 0.0 { (length - low.length) / span } else { 1.0 };
    let bend = |speed: f64| span / (speed * width) - 1.0;
    let rest = 1.0 - share;
    let bent = share + share * rest * (bend(low.speed) * rest - bend(high.speed) * share);
    // Where a speed is nearly none, the slope says nothing.
    let share = if bent > 0.0 && bent < 1.0 { bent } else { share };
    low.parameter + width * share
}

/// The slowest place seen so far.
struct Slowest {
    parameter: f64,
    speed: f64,
}

impl Slowest {
    fn look(&mut self, cubics: &Cubics<'_>, parameter: f64) {
        let speed = cubics.first(parameter).length();
        if speed < self.speed {
            *self = Self { parameter, speed };
        }
    }
}
