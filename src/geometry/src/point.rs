//! What evaluation and projection return.

use glam::DVec2;

/// A point of a curve with everything first order about it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// Inertial x `[m]`.
    pub x: f64,
    /// Inertial y `[m]`.
    pub y: f64,
    /// x component of the unit tangent.
    pub cos: f64,
    /// y component of the unit tangent.
    pub sin: f64,
    /// Heading `[rad]`: continuous along the geometry, counted from the heading of its start and not normalised.
    pub heading: f64,
    /// Signed curvature `[1/m]`, positive to the left.
    pub curvature: f64,
}

/// Position and unit tangent: the cheapest evaluation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tangent {
    /// Inertial x `[m]`.
    pub x: f64,
    /// Inertial y `[m]`.
    pub y: f64,
    /// x component of the unit tangent.
    pub cos: f64,
    /// y component of the unit tangent.
    pub sin: f64,
}

/// The foot of a point on a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// Where the foot is along the geometry `[m]`, in the range that was searched.
    pub u: f64,
    /// Inertial x of the foot `[m]`.
    pub x: f64,
    /// Inertial y of the foot `[m]`.
    pub y: f64,
    /// x component of the unit tangent at the foot.
    pub cos: f64,
    /// y component of the unit tangent at the foot.
    pub sin: f64,
    /// Signed offset of the point along the left normal of the foot `[m]`, positive to the left. If `clamped`, the point
    /// also lies ahead of or behind the foot and this is not the whole distance.
    pub lateral: f64,
    /// Squared distance from the point to the foot `[m²]`.
    pub distance_squared: f64,
    /// The foot is an end of the range that was searched, and the point is not perpendicular to the curve there.
    pub clamped: bool,
    /// Signed curvature at the foot `[1/m]`, positive to the left.
    pub curvature: f64,
}

/// Position, unit tangent and curvature in the geometry's own frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LocalPoint {
    pub(crate) position: DVec2,
    pub(crate) tangent: DVec2,
    pub(crate) curvature: f64,
    /// |dr/du|, as far as the last step of a projection needs it.
    pub(crate) speed: f64,
}

/// How fast a curve is run through and how it bends, with the change of both along u.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveRates {
    /// Metres of the curve per metre of u.
    pub speed: f64,
    /// Its change per metre of u `[1/m]`.
    pub speed_rate: f64,
    /// Signed curvature `[1/m]`, positive to the left.
    pub curvature: f64,
    /// Its change per metre of u `[1/m²]`.
    pub curvature_rate: f64,
}

impl CurveRates {
    /// Of a curve along which neither changes.
    #[inline]
    pub(crate) fn even(curvature: f64) -> Self {
        Self { speed: 1.0, speed_rate: 0.0, curvature, curvature_rate: 0.0 }
    }

    /// By the first three derivatives with respect to a parameter that grows by `rate` per metre of u.
    pub(crate) fn of([first, second, third]: [DVec2; 3], rate: f64) -> Self {
        let length = first.length();
        let cube = length * length * length;
        let (across, along) = (first.perp_dot(second), first.dot(second));
        let bend = first.perp_dot(third) - 3.0 * across * along / (length * length);
        Self {
            speed: length * rate,
            speed_rate: along / length * rate * rate,
            curvature: across / cube,
            curvature_rate: bend / cube * rate,
        }
    }
}

/// Position and derivatives with respect to u in the geometry's own frame: what one Newton step needs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jet {
    pub(crate) position: DVec2,
    pub(crate) first: DVec2,
    /// The second derivative up to a multiple of `first`, which does not change where Newton's method converges to.
    pub(crate) second: DVec2,
}
