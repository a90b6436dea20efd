//! Right-handed frames in space: where the axes of something point.

use crate::{atan2, cos_sin};
use glam::DVec3;

/// The axes of a body in its parent's frame: u ahead, v to the left, w upwards; orthonormal.
///
/// Angles are applied as OpenDRIVE has them (1.8.1, 8.2): heading about w, then pitch about the turned v (positive lowers
/// the front), then roll about the turned u (positive lifts the left side).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attitude {
    /// Ahead.
    pub u: DVec3,
    /// To the left.
    pub v: DVec3,
    /// Upwards.
    pub w: DVec3,
}

impl Attitude {
    /// The parent's own axes.
    pub const LEVEL: Self = Self { u: DVec3::X, v: DVec3::Y, w: DVec3::Z };

    /// Axes turned by heading, pitch and roll `[rad]`. Angles that are 0 cost no trigonometry and no rounding.
    #[must_use]
    pub fn new(heading: f64, pitch: f64, roll: f64) -> Self {
        let turn = |angle: f64| if angle == 0.0 { (1.0, 0.0) } else { cos_sin(angle) };
        let ((ch, sh), (cp, sp), (cr, sr)) = (turn(heading), turn(pitch), turn(roll));
        Self {
            u: DVec3::new(ch * cp, sh * cp, -sp),
            v: DVec3::new(ch * sp * sr - sh * cr, sh * sp * sr + ch * cr, cp * sr),
            w: DVec3::new(ch * sp * cr + sh * sr, sh * sp * cr - ch * sr, cp * cr),
        }
    }

    /// A vector of this frame in the parent's.
    #[inline]
    #[must_use]
    pub fn to_parent(&self, local: DVec3) -> DVec3 {
        self.u * local.x + self.v * local.y + self.w * local.z
    }

    /// A vector of the parent's frame in this one.
    #[inline]
    #[must_use]
    pub fn to_local(&self, vector: DVec3) -> DVec3 {
        DVec3::new(self.u.dot(vector), self.v.dot(vector), self.w.dot(vector))
    }

    /// Axes that are given in this frame, in the parent's.
    #[must_use]
    pub fn then(&self, inner: &Self) -> Self {
        Self { u: self.to_parent(inner.u), v: self.to_parent(inner.v), w: self.to_parent(inner.w) }
    }

    /// Heading, pitch and roll `[rad]` that [`Attitude::new`] makes these axes of; pitch in [−π/2, π/2].
    #[must_use]
    pub fn angles(&self) -> [f64; 3] {
        let level = libm::hypot(self.u.x, self.u.y);
        [atan2(self.u.y, self.u.x), atan2(-self.u.z, level), atan2(self.v.z, self.w.z)]
    }
}

#[cfg(test)]
mod tests {
    use super::Attitude;
    use glam::DVec3;

    const ANGLES: [f64; 5] = [-1.2, -0.4, 0.0, 0.7, 1.5];

    fn each(mut check: impl FnMut([f64; 3])) {
        for h in ANGLES {
            for p in ANGLES {
                for r in ANGLES {
                    check([h, p, r]);
                }
            }
        }
    }

    #[test]
    fn axes_are_orthonormal_and_right_handed() {
        each(|[h, p, r]| {
            let a = Attitude::new(h, p, r);
            assert!((a.u.cross(a.v) - a.w).length() < 1e-15, "{h} {p} {r}");
            assert!((a.u.length() - 1.0).abs() < 1e-15 && a.u.dot(a.v).abs() < 1e-15);
        });
    }

    #[test]
    fn angles_come_back() {
        each(|angles| {
            let [h, p, r] = angles;
            let back = Attitude::new(h, p, r).angles();
            assert!(back.iter().zip(angles).all(|(a, b)| (a - b).abs() < 1e-14), "{angles:?}");
        });
    }

    #[test]
    fn turning_one_after_the_other_is_turning_once() {
        each(|[h, p, r]| {
            let steps = Attitude::new(h, 0.0, 0.0)
                .then(&Attitude::new(0.0, p, 0.0))
                .then(&Attitude::new(0.0, 0.0, r));
            let once = Attitude::new(h, p, r);
            assert!((steps.v - once.v).length() < 1e-15 && (steps.w - once.w).length() < 1e-15);
            let vector = DVec3::new(1.0, -2.0, 0.5);
            assert!((once.to_local(once.to_parent(vector)) - vector).length() < 1e-15);
        });
    }

    #[test]
    fn pitch_lowers_the_front_and_roll_lifts_the_left() {
        assert!(Attitude::new(0.0, 0.1, 0.0).u.z < 0.0);
        assert!(Attitude::new(0.0, 0.0, 0.1).v.z > 0.0);
    }
}
