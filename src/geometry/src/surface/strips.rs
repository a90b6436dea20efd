//! Cross-section surface of OpenDRIVE 1.8: up to two strips to each side of a shifted middle.

use super::{Along, Height};

/// One strip at an s: its profile across is a cubic whose coefficients vary along the road.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StripProfile {
    /// Width `[m]`; `None` for a strip without an outer end.
    pub width: Option<Along>,
    /// Constant, linear, quadratic and cubic part over the distance from the strip's inner edge.
    pub coefficients: [Along; 4],
    /// Whether the height counts from that of the inner strip's outer edge (`mode="relative"`) instead of the
    /// reference plane.
    pub relative: bool,
}

impl StripProfile {
    /// Height and slopes at a signed distance from the inner edge whose own derivative by s is `by_s`.
    fn at(&self, dt: f64, dt_by_s: f64) -> Height {
        let [a, b, c, d] = self.coefficients;
        let by_t = b.value + dt * (2.0 * c.value + dt * (3.0 * d.value));
        Height {
            h: a.value + dt * (b.value + dt * (c.value + dt * d.value)),
            by_s: a.by_s + dt * (b.by_s + dt * (c.by_s + dt * d.by_s)) + by_t * dt_by_s,
            by_t,
        }
    }
}

/// Height at `t` `[m]` over the strips of the side that t lies on, `inner` (id ±1) and `outer` (id ±2), both counted from
/// the middle at t = `offset` (OpenDRIVE 1.8.1, 10.6).
///
/// Distances are signed as t is: on the right they are negative. A missing inner strip is flat; so is what lies beyond
/// the inner strip where there is no outer one: its edge's height holds.
#[must_use]
pub fn strip_heights(
    offset: Along,
    inner: Option<StripProfile>,
    outer: Option<StripProfile>,
    t: f64,
) -> Height {
    let dt = t - offset.value;
    let side = if dt < 0.0 { -1.0 } else { 1.0 };
    let inner = inner.unwrap_or_default();
    let within = |dt: f64| inner.at(dt, -offset.by_s);
    let Some(width) = inner.width.filter(|width| dt.abs() > width.value) else {
        return within(dt);
    };
    let edge = side * width.value;
    // The height along the inner strip's edge, a function of s alone.
    let at_edge = inner.at(edge, side * width.by_s);
    let at_edge = Height { by_t: 0.0, ..at_edge };
    let Some(outer) = outer else { return at_edge };
    let own = outer.at(dt - edge, -offset.by_s - side * width.by_s);
    if outer.relative { own + at_edge } else { own }
}
