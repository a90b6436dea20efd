//! The local origin: large coordinates lose digits in every multiplication, small ones do not.

use mapd_archive::GeometryRow;

/// Coordinates up to this size `[m]` are stored as they are.
const LARGE: f64 = 65_536.0;
/// The origin is a multiple of this `[m]`, so that subtracting it is exact in double precision.
const STEP: f64 = 1024.0;

/// Origin for geometries in absolute coordinates; (0, 0) unless they are large.
pub(crate) fn choose(geometries: &[GeometryRow]) -> (f64, f64) {
    let axis = |get: fn(&GeometryRow) -> f64| {
        let low = geometries.iter().map(get).fold(f64::INFINITY, f64::min);
        let high = geometries.iter().map(get).fold(f64::NEG_INFINITY, f64::max);
        if low.abs().max(high.abs()) > LARGE && low.is_finite() && high.is_finite() {
            ((low + 0.5 * (high - low)) / STEP).round() * STEP
        } else {
            0.0
        }
    };
    (axis(|g| g.x), axis(|g| g.y))
}
