//! Angles.

use core::f64::consts::{PI, TAU};
use glam::DVec3;

/// The same direction as `angle` `[rad]`, in (−π, π].
///
/// The result is exact to the rounding of 2π itself: an angle of `n` turns comes back with an error of about
/// `n · 2.5e-16` rad. Not-a-number and infinities give not-a-number.
#[must_use]
pub fn normalize_angle(angle: f64) -> f64 {
    if angle > -PI && angle <= PI {
        return angle;
    }
    // The remainder of fmod is exact, so no digits are lost before the single correction below.
    let remainder = libm::fmod(angle, TAU);
    if remainder > PI {
        remainder - TAU
    } else if remainder <= -PI {
        remainder + TAU
    } else {
        remainder
    }
}

/// Angle of the direction (x, y) `[rad]`, in [−π, π], by `libm`: equal bit for bit on every machine.
#[inline]
#[must_use]
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// The largest whole number that is not above `value`, by `libm`.
#[inline]
#[must_use]
pub fn floor(value: f64) -> f64 {
    libm::floor(value)
}

/// Length of (x, y), by `libm`: equal bit for bit on every machine, and without overflow on the way.
#[inline]
#[must_use]
pub fn hypot(x: f64, y: f64) -> f64 {
    libm::hypot(x, y)
}

/// Cosine and sine of an angle `[rad]`, by `libm`: equal bit for bit on every machine.
#[inline]
#[must_use]
pub fn cos_sin(angle: f64) -> (f64, f64) {
    let (sin, cos) = libm::sincos(angle);
    (cos, sin)
}

/// The point so far to the left of a heading `[rad]` in plan view, and so far upwards of a point `[m]`.
#[must_use]
pub fn beside(origin: DVec3, heading: f64, left: f64, up: f64) -> DVec3 {
    let (cos, sin) = cos_sin(heading);
    origin + DVec3::new(-left * sin, left * cos, up)
}
