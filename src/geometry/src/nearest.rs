//! The search for the nearest point of a curve that has no closed form.
//!
//! With r(u) the curve and q the target, the foot is a root of (q − r)·r′ where it turns from positive (the foot is
//! ahead) to negative (it is behind).

use crate::clamp;
use crate::point::Jet;
use glam::DVec2;

/// Newton stops after a step below this `[m]`. Convergence is quadratic, so the error left is about the square of it.
const CONVERGED: f64 = 1e-6;

/// An interval this short `[m]` is a foot, whatever Newton says.
const POINT: f64 = 1e-10;

/// Newton steps before plain bisection takes over. From a seed within a few metres two to four are usual.
const NEWTON_STEPS: usize = 16;

/// Upper bound of all steps: bisection of 1e8 m down to [`POINT`] takes 60.
const MAX_STEPS: usize = NEWTON_STEPS + 64;

/// Where 1 − κt is below this, the target is near or beyond the centre of curvature: Newton's step would be wild or
/// uphill, and a plain step towards the target's tangential offset is taken.
const MIN_BEND: f64 = 0.1;

/// Parts of a piece that are searched for a foot each. A piece turns by at most about half a radian, so an eighth of
/// one can only hide two feet if the target is at the centre of curvature, where they are equally near.
const PARTS: usize = 8;

/// Relative and absolute `[m]` allowance when a piece is ruled out by its distance, for the error of its half length.
const PRUNE_SLACK: f64 = 1e-3;
const PRUNE_MARGIN: f64 = 1e-6;

/// Walks from `seed` to a local minimum of the distance to `target` over [lo, hi], an end of it included.
///
/// Total for any curve, even one that returns not-a-number: at most [`MAX_STEPS`] evaluations.
pub(crate) fn descend(
    curve: impl Fn(f64) -> Jet,
    target: DVec2,
    seed: f64,
    lo: f64,
    hi: f64,
) -> f64 {
    // The foot lies in [below, above]; an end is `tested` once the sign there is known.
    let (mut below, mut above) = (lo, hi);
    let (mut below_tested, mut above_tested) = (false, false);
    let mut on_a_peak = true;
    let mut u = clamp(seed, lo, hi);
    for steps in 0..MAX_STEPS {
        let jet = curve(u);
        let gap = target - jet.position;
        let ahead = gap.dot(jet.first);
        let speed = jet.first.length_squared();
        let bend = speed - gap.dot(jet.second);
        let is_newton = bend > MIN_BEND * speed;
        let step = ahead / if is_newton { bend } else { speed };
        // A step that is not Newton's says how far the target is ahead, not how far the foot is.
        let settled = step.abs() <= if is_newton { CONVERGED } else { POINT };
        if settled && bend < 0.0 && on_a_peak {
            // A seed exactly at the farthest point: leave it towards the longer side.
            on_a_peak = false;
            u = if above - u > u - below { middle(u, above) } else { middle(below, u) };
            continue;
        }
        if settled {
            return clamp(u + step, lo, hi);
        }
        if ahead > 0.0 {
            (below, below_tested) = (u, true);
        } else {
            (above, above_tested) = (u, true);
        }
        if above - below <= POINT {
            // Whatever was never visited and is still the nearest place is the foot itself, not a point beside it.
            return match (below_tested, above_tested) {
                (false, _) => below,
                (true, false) => above,
                (true, true) => u,
            };
        }
        let next = u + step;
        u = if steps >= NEWTON_STEPS {
            middle(below, above)
        } else if next >= above && !above_tested {
            above
        } else if next <= below && !below_tested {
            below
        } else if below < next && next < above {
            next
        } else {
            middle(below, above)
        };
    }
    u
}

/// The nearest point over [0, limit] of a curve in `count` pieces of equal length; the limit lies on the curve.
///
/// Every piece is bounded by the circle around its midpoint; a piece whose circle is farther than the best point so far
/// is skipped, every other one is searched in [`PARTS`] parts. So no turn of a winding curve is missed.
pub(crate) fn search(
    curve: impl Fn(f64) -> Jet + Copy,
    target: DVec2,
    count: usize,
    length: f64,
    limit: f64,
) -> f64 {
    let piece = length / count as f64;
    let mut best = Best { u: 0.0, distance_squared: f64::INFINITY };
    let circle = |index: usize| {
        let u = ((index as f64 + 0.5) * piece).min(limit);
        let jet = curve(u);
        let half = u - index as f64 * piece;
        let radius = half * jet.first.length() * (1.0 + PRUNE_SLACK) + PRUNE_MARGIN;
        (u, jet.position.distance_squared(target), radius)
    };
    // A single piece is searched in any case.
    let reached = |index: &usize| *index == 0 || *index as f64 * piece < limit;
    for index in (0..count).filter(reached).filter(|_| count > 1) {
        let (u, distance_squared, _) = circle(index);
        best.offer(u, distance_squared);
    }
    for index in (0..count).filter(reached) {
        let (_, distance_squared, radius) = circle(index);
        if distance_squared.sqrt() - radius > best.distance_squared.sqrt() {
            continue;
        }
        let border = |part: usize| {
            let u = clamp((index as f64 + part as f64 / PARTS as f64) * piece, 0.0, limit);
            let jet = curve(u);
            let gap = target - jet.position;
            (u, gap.length_squared(), gap.dot(jet.first))
        };
        let mut previous = border(0);
        best.offer(previous.0, previous.1);
        for part in 1..=PARTS {
            let next = border(part);
            best.offer(next.0, next.1);
            if previous.2 > 0.0 && next.2 <= 0.0 {
                let seed =
                    previous.0 + (next.0 - previous.0) * (previous.2 / (previous.2 - next.2));
                let u = descend(curve, target, seed, previous.0, next.0);
                best.offer(u, curve(u).position.distance_squared(target));
            }
            previous = next;
        }
    }
    best.u
}

/// Halfway, without the sum that could overflow.
#[inline]
fn middle(below: f64, above: f64) -> f64 {
    below + 0.5 * (above - below)
}

/// The nearest point so far; the first of equals.
struct Best {
    u: f64,
    distance_squared: f64,
}

impl Best {
    #[inline]
    fn offer(&mut self, u: f64, distance_squared: f64) {
        if distance_squared < self.distance_squared {
            *self = Self { u, distance_squared };
        }
    }
}
