//! Projecting a point onto a compiled curve.

use crate::curve::Curve;
use crate::primitive::CurveKind;
use std::f64::consts::TAU;

/// Distance along the curve `[m]` up to which a point beside an end does not count as beyond it.
const BESIDE: f64 = 1e-9;
/// Steps of a local search: Newton's method needs four or five, bisection as its safeguard the rest.
const STEPS: usize = 60;
/// Step `[m]` at which a local search ends.
const FOUND: f64 = 1e-12;
/// Smallest slope 1 − κ·t that Newton's method divides by.
const MIN_SLOPE: f64 = 1e-3;
/// Samples per piece of the global search.
const SAMPLES: usize = 2;
/// Fewest samples of the global search.
const MIN_SAMPLES: usize = 8;

/// The foot of a point on a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// Place of the foot, u ∈ [0, length] `[m]`.
    pub u: f64,
    /// x of the foot `[m]`.
    pub x: f64,
    /// y of the foot `[m]`.
    pub y: f64,
    /// Cosine of the heading there.
    pub cos: f64,
    /// Sine of the heading there.
    pub sin: f64,
    /// Signed distance across the curve `[m]`, positive to the left.
    pub lateral: f64,
    /// Squared distance from the foot `[m²]`.
    pub distance_squared: f64,
    /// Whether the foot is an end of the searched range and the point lies beyond it.
    pub clamped: bool,
    /// Curvature at the foot `[1/m]`.
    pub curvature: f64,
}

impl Curve<'_> {
    /// The foot nearest to `seed` with u ∈ [lo, hi]: Newton's method on the distance, held between bounds. Right
    /// wherever the distance has one minimum in the range; 1e-12 m along the curve.
    #[inline]
    pub fn project_from(&self, x: f64, y: f64, seed: f64, lo: f64, hi: f64) -> Projection {
        let lo = lo.max(0.0).min(self.length);
        let hi = hi.min(self.length).max(lo);
        match self.kind {
            CurveKind::Line => {
                let (dx, dy) = (x - self.start.x, y - self.start.y);
                self.foot(x, y, (dx * self.start.cos + dy * self.start.sin).max(lo).min(hi), lo, hi)
            }
            CurveKind::Arc if self.number(0) != 0.0 => {
                self.foot(x, y, self.arc_place(x, y, seed, lo, hi), lo, hi)
            }
            _ => self.newton(x, y, seed.max(lo).min(hi), lo, hi),
        }
    }

    /// The nearest foot of the whole curve, also where it winds several times.
    pub fn project(&self, x: f64, y: f64) -> Projection {
        match self.kind {
            CurveKind::Line | CurveKind::Arc => {
                self.project_from(x, y, 0.5 * self.length, 0.0, self.length)
            }
            _ => self.project_by_samples(x, y),
        }
    }

    /// Place on an arc: the point's angle around the centre, in whichever winding lies nearest to the seed.
    fn arc_place(&self, x: f64, y: f64, seed: f64, lo: f64, hi: f64) -> f64 {
        let curvature = self.number(0);
        let (dx, dy) = (x - self.start.x, y - self.start.y);
        let (along, across) =
            (dx * self.start.cos + dy * self.start.sin, dy * self.start.cos - dx * self.start.sin);
        // Turn from the start to the point as seen from the centre (0, 1/κ).
        let turn = libm::atan2(along * curvature, 1.0 - across * curvature);
        let winding = TAU / curvature.abs();
        let u = turn / curvature;
        let near = |place: f64| u + winding * ((place - u) / winding).round();
        let (at_seed, at_lo, at_hi) = (near(seed), near(lo), near(hi));
        for u in [at_seed, at_lo, at_hi] {
            if u >= lo && u <= hi {
                return u;
            }
        }
        // The nearest place of the circle lies outside: the end that is nearer to it along the circle.
        if (at_lo - lo).abs() <= (at_hi - hi).abs() { lo } else { hi }
    }

    fn newton(&self, x: f64, y: f64, seed: f64, lo: f64, hi: f64) -> Projection {
        let (mut low, mut high) = (lo, hi);
        let mut u = seed;
        for _ in 0..STEPS {
            let p = self.evaluate(u);
            let (dx, dy) = (x - p.x, y - p.y);
            let along = dx * p.cos + dy * p.sin;
            let across = dy * p.cos - dx * p.sin;
            if along > 0.0 {
                low = u;
            } else {
                high = u;
            }
            let slope = 1.0 - p.curvature * across;
            let newton = u + along / if slope > MIN_SLOPE { slope } else { 1.0 };
            let next = if newton >= low && newton <= high {
                newton
            } else if newton < lo && low == lo {
                // Beyond the range on a side that has not been visited: look at its end before halving.
                lo
            } else if newton > hi && high == hi {
                hi
            } else {
                0.5 * (low + high)
            };
            if !((next - u).abs() > FOUND) {
                u = next;
                break;
            }
            u = next;
        }
        self.foot(x, y, u, lo, hi)
    }

    fn foot(&self, x: f64, y: f64, u: f64, lo: f64, hi: f64) -> Projection {
        let p = self.evaluate(u);
        let (dx, dy) = (x - p.x, y - p.y);
        let along = dx * p.cos + dy * p.sin;
        Projection {
            u,
            x: p.x,
            y: p.y,
            cos: p.cos,
            sin: p.sin,
            lateral: dy * p.cos - dx * p.sin,
            distance_squared: dx * dx + dy * dy,
            clamped: (u <= lo && along < -BESIDE) || (u >= hi && along > BESIDE),
            curvature: p.curvature,
        }
    }

    /// Samples first; then every stretch between two samples that may hold a nearer point than the best so far.
    fn project_by_samples(&self, x: f64, y: f64) -> Projection {
        let count = (self.pieces() * SAMPLES).max(MIN_SAMPLES);
        let step = self.length / count as f64;
        let place = |i: usize| if i == count { self.length } else { i as f64 * step };
        let distance = |i: usize| {
            let p = self.evaluate(place(i));
            ((x - p.x) * (x - p.x) + (y - p.y) * (y - p.y)).sqrt()
        };
        let (mut nearest, mut best_distance) = (0, f64::INFINITY);
        for i in 0..=count {
            let d = distance(i);
            if d < best_distance {
                (nearest, best_distance) = (i, d);
            }
        }
        let mut best = self.foot(x, y, place(nearest), 0.0, self.length);
        let mut left = distance(0);
        for i in 0..count {
            let right = distance(i + 1);
            // Parametric curves are scaled along u; twice the step bounds them as far as the ratio stays below two,
            // which holds for every curve near its stated length.
            if 0.5 * (left + right) - step <= best.distance_squared.sqrt() {
                let seed = if left < right { place(i) } else { place(i + 1) };
                let foot = self.newton(x, y, seed, place(i), place(i + 1));
                if foot.distance_squared < best.distance_squared {
                    best = self.foot(x, y, foot.u, 0.0, self.length);
                }
            }
            left = right;
        }
        best
    }
}
