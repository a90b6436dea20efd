//! Circular arcs in closed form, stable down to zero curvature.

use crate::clamp;
use crate::point::LocalPoint;
use core::f64::consts::{PI, TAU};
use glam::DVec2;

/// Below this |κ| `[1/m]` an arc is projected as a line: κ times any sane coordinate nears the underflow of f64.
const STRAIGHT: f64 = 1e-150;

/// Half turning angle `[rad]` below which sin(x)/x is taken from its series: 1 − x²/6 is exact to 1e-18 there.
const SMALL_HALF_ANGLE: f64 = 1e-4;

/// Distance `[m]` by which a foot may miss the end of its range and still count as that end, so that rounding at the
/// start of a full circle does not throw the foot one turn further.
const SNAP: f64 = 1e-9;

/// A point's distance from the centre, as a share of the radius, from which on its feet are told apart.
const MIN_ROOM: f64 = 0.2;

/// Turn of an arc `[rad]` by which a point's second foot has to lie beyond a range.
const APART: f64 = 0.05;

/// Position and tangent at `u`: a chord of length u·sinc(κu/2) in direction κu/2, and the double angle.
#[inline]
pub(crate) fn frame(curvature: f64, u: f64) -> LocalPoint {
    let half = 0.5 * curvature * u;
    let (sin, cos) = libm::sincos(half);
    let sinc = if half.abs() < SMALL_HALF_ANGLE { 1.0 - half * half / 6.0 } else { sin / half };
    let direction = DVec2::new(cos, sin);
    let position = direction * (u * sinc);
    LocalPoint { position, tangent: direction.rotate(direction), curvature, speed: 1.0 }
}

/// Offset along the left normal of the foot of `target`, for any foot that is perpendicular: (1 − r)/κ, where r is 1/κ less the
/// distance from the centre, times κ; written so that nothing cancels as κ tends to zero.
#[inline]
pub(crate) fn lateral(curvature: f64, target: DVec2) -> f64 {
    let from_center = DVec2::new(curvature * target.x, 1.0 - curvature * target.y).length();
    (2.0 * target.y - curvature * target.length_squared()) / (1.0 + from_center)
}

/// The u of the point nearest to `target`, if it lies in [lo, hi] and the arc passes it but once there: the same bits as
/// [`project`], for less.
#[inline]
pub(crate) fn project_inside(curvature: f64, target: DVec2, lo: f64, hi: f64) -> Option<f64> {
    let (along, towards) = (curvature * target.x, 1.0 - curvature * target.y);
    // On this side of the centre atan2 is this arc tangent.
    let ahead = curvature.abs() >= STRAIGHT && towards > 0.0;
    if !ahead || curvature.abs() * (hi - lo) >= PI {
        return None;
    }
    let u = libm::atan(along / towards) / curvature;
    (lo <= u && u <= hi).then_some(u)
}

/// As [`project_inside`], and what it means where there is none: whether no place in [lo, hi] has `target` at a right angle beside it. None where an arc turns too far, or the point is too near to its centre, to tell.
#[inline]
pub(crate) fn only_foot(curvature: f64, target: DVec2, lo: f64, hi: f64) -> Option<Option<f64>> {
    let (along, towards) = (curvature * target.x, 1.0 - curvature * target.y);
    let is_far = along * along + towards * towards >= MIN_ROOM * MIN_ROOM;
    let is_ahead = lo * curvature.abs() >= -APART;
    if !(curvature.abs() >= STRAIGHT && towards > 0.0 && is_far && is_ahead) {
        return None;
    }
    let u = libm::atan(along / towards) / curvature;
    // The next one is on the other side of the centre, half a turn ahead; the one half a turn behind lies before the start.
    let other = u + (PI - APART) / curvature.abs();
    (other > hi).then_some((lo <= u && u <= hi).then_some(u))
}

/// The u ∈ [lo, hi] of the point nearest to `target`; among several turns, the one nearest to `seed`.
pub(crate) fn project(curvature: f64, target: DVec2, seed: f64, lo: f64, hi: f64) -> f64 {
    if curvature.abs() < STRAIGHT {
        return clamp(target.x, lo, hi);
    }
    // The centre is (0, 1/κ). Multiplied by κ, nothing cancels as κ tends to zero.
    let angle = libm::atan2(curvature * target.x, 1.0 - curvature * target.y);
    let turn = TAU / curvature.abs();
    let mut u = angle / curvature;
    u += turn * libm::rint((seed - u) / turn);
    if u < lo - SNAP {
        u += turn * libm::ceil((lo - u) / turn);
    } else if u > hi + SNAP {
        u -= turn * libm::ceil((u - hi) / turn);
    }
    if u >= lo - SNAP && u <= hi + SNAP {
        return clamp(u, lo, hi);
    }
    let distance = |u| frame(curvature, u).position.distance_squared(target);
    if distance(hi) < distance(lo) { hi } else { lo }
}
