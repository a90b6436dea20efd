//! Places along a lane at a fixed step.

use crate::error::QueryError;
use crate::lane::Lane;
use crate::types::{Clamped, Pose};
use glam::DVec3;

/// Places of one answer at most: a step that is too small for its length must not fill the memory.
pub(crate) const MOST_STATIONS: f64 = 1e6;

/// A place on a lane's centre line.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Waypoint {
    /// On the road's reference line `[m]`.
    pub s: f64,
    /// Inertial position on the plane h = 0 `[m]`.
    pub position: DVec3,
    /// Heading of the centre line in driving direction `[rad]`, in (−π, π].
    pub heading: f64,
    /// Width of the lane `[m]`.
    pub width: f64,
    /// Whether the s that was asked for lay outside the lane's section and was moved to its nearer end.
    pub clamped: Clamped,
}

impl<'a> Lane<'a> {
    /// The centre line's exact place at s, with its own direction and the lane's width: the place and heading of [`Lane::pose_at`] at offset 0. s outside the
    /// lane's section is moved to its nearer end and flagged.
    ///
    /// Errors: coordinates that are not finite; a damaged archive.
    pub fn waypoint_at(&self, s: f64) -> Result<Waypoint, QueryError> {
        let (at, clamped) = self.place(s)?;
        let Pose { position, heading, .. } = self.pose_beside_center(at, 0.0)?;
        let width = self.edges(at).width();
        let (start, end) = (self.section().s_start(), self.section().s_end());
        let s = mapd_geometry::clamp(s, start, end);
        Ok(Waypoint { s, position, heading, width, clamped })
    }

    /// Waypoints in driving direction, `step` metres of s apart, from where the lane is entered to where it is left; both
    /// ends are among them, the last step may be shorter. None for lane 0. Their number is known before any is looked at.
    ///
    /// Errors: a step that is not a positive finite number, or gives more than a million of them.
    pub fn waypoints(
        &self,
        step: f64,
    ) -> Result<impl ExactSizeIterator<Item = Result<Waypoint, QueryError>> + use<'a>, QueryError>
    {
        if !(step.is_finite() && step > 0.0) {
            return Err(QueryError::NotFinite);
        }
        let lane = *self;
        let (start, end) = (self.section().s_start(), self.section().s_end());
        let length = if self.number() == 0 { -1.0 } else { end - start };
        if length / step > MOST_STATIONS {
            return Err(QueryError::Option("step"));
        }
        let forward = self.is_forward();
        let count = if length < 0.0 { 0 } else { steps_to(length, step) + 1 };
        Ok((0..count).map(move |number| {
            let gone = f64::from(number) * step;
            let gone = if gone < length { gone } else { length };
            lane.waypoint_at(if forward { start + gone } else { end - gone })
        }))
    }
}

/// The least number of steps that are not shorter than a length together, each multiplied as its place is.
fn steps_to(length: f64, step: f64) -> u32 {
    // Dividing rounds otherwise than multiplying: by one step at most.
    let near = (length / step).ceil() as u32;
    let first = near.saturating_sub(1);
    (first..near)
        .find(|number| f64::from(*number) * step >= length)
        .unwrap_or_else(|| if f64::from(near) * step >= length { near } else { near + 1 })
}
