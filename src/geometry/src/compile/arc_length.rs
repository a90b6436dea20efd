//! The arc length of a plane cubic as a function of its parameter, and the inverse.

use super::CompileError;
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

/// Newton steps of an inversion, each kept within its bracket by bisection.
const MAX_STEPS: usize = 60;

/// Arc length up to a panel border.
#[derive(Clone, Copy)]
struct Border {
    parameter: f64,
    length: f64,
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
        let mut arc_length = Self { cubics, borders: vec![Border { parameter: 0.0, length: 0.0 }] };
        let estimate = arc_length.integrate(0.0, end);
        let mut slowest = Slowest { parameter: 0.0, speed: cubics.first(0.0).length() };
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
        let span = high.length - low.length;
        let share = if span > 0.0 { (length - low.length) / span } else { 1.0 };
        let mut p = below + (above - below) * share;
        for _ in 0..MAX_STEPS {
            let excess = low.length + self.integrate(low.parameter, p) - length;
            if excess > 0.0 {
                above = p;
            } else {
                below = p;
            }
            let step = excess / self.cubics.first(p).length();
            if step.abs() <= 2.0 * f64::EPSILON * p || excess == 0.0 {
                break;
            }
            let next = p - step;
            let inside = below < next && next < above;
            p = if inside { next } else { 0.5 * (below + above) };
        }
        p
    }

    /// One application of the rule.
    fn integrate(&self, from: f64, to: f64) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let speed = |p: f64| self.cubics.first(p).length();
        let sum: f64 = RULE
            .iter()
            .map(|(node, weight)| {
                weight * (speed(middle - half * node) + speed(middle + half * node))
            })
            .sum();
        half * sum
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
                self.borders.push(Border { parameter, length });
            }
        } else {
            self.halve(from, middle, first, tolerance, halvings - 1, slowest);
            self.halve(middle, to, second, tolerance, halvings - 1, slowest);
        }
    }
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
