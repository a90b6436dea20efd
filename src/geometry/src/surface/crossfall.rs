//! Crossfall of OpenDRIVE 1.4 and 1.5.

use super::{Along, Height};
use crate::cos_sin;

/// Height at `t` `[m]` of a side that falls outwards by `angle` `[rad]`: −tan(angle)·|t| (OpenDRIVE 1.4H, 5.3.6.2; there
/// the superelevation's rotation comes on top). The angle is that of the side on which t lies.
///
/// At right angles the result is not finite, as the surface is not.
#[must_use]
pub fn crossfall(angle: Along, t: f64) -> Height {
    let (cos, sin) = cos_sin(angle.value);
    let tan = sin / cos;
    let side = if t < 0.0 { -1.0 } else { 1.0 };
    Height { h: -tan * t.abs(), by_s: -angle.by_s / (cos * cos) * t.abs(), by_t: -tan * side }
}
