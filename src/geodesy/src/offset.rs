//! The header's offset.

use glam::{DVec2, DVec3};

/// Where a file's inertial frame lies in the plane of its projection (`header/offset`, ASAM OpenDRIVE 1.8.1, 8.4.3).
///
/// A point p of the file lies at R(heading)·p + (x, y), its height at z: first turned, then shifted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Offset {
    /// Shift along x, y and z `[m]`.
    pub shift: DVec3,
    /// Turn about the inertial frame's origin `[rad]`, counter-clockwise.
    pub heading: f64,
}

impl Offset {
    /// Whether it changes nothing.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// With the shift's sign turned, which is how netconvert of Eclipse SUMO writes it.
    #[must_use]
    pub fn negated(self) -> Self {
        // A difference, so that no zero becomes a negative one.
        Self { shift: DVec3::ZERO - self.shift, ..self }
    }

    /// From the file's frame into the projection's plane `[m]`.
    pub fn apply(&self, point: DVec3) -> DVec3 {
        self.axis().rotate(point.truncate()).extend(point.z) + self.shift
    }

    /// From the projection's plane into the file's frame `[m]`.
    pub fn invert(&self, point: DVec3) -> DVec3 {
        let moved = point - self.shift;
        let axis = self.axis();
        DVec2::new(axis.x, -axis.y).rotate(moved.truncate()).extend(moved.z)
    }

    /// Direction of the file's x axis in the plane. libm: the same on every machine.
    fn axis(&self) -> DVec2 {
        DVec2::new(libm::cos(self.heading), libm::sin(self.heading))
    }
}
