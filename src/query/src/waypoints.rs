//! Places along a lane at a fixed step.

use crate::error::QueryError;
use crate::lane::Lane;
use crate::types::{Clamped, Pose};
use glam::DVec3;
use mapd_geometry::normalize_angle;

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
    /// The centre line's exact place at s, with its own direction: that of the lane where it widens or shifts, not that
    /// of the reference line. s outside the lane's section is moved to its nearer end and flagged.
    ///
    /// Errors: coordinates that are not finite; a damaged archive.
    pub fn waypoint_at(&self, s: f64) -> Result<Waypoint, QueryError> {
        let (at, clamped) = self.place(s)?;
        let edges = self.edge_slopes(at);
        let t = 0.5 * (edges.inner.value + edges.outer.value);
        let drift = 0.5 * (edges.inner.derivative + edges.outer.derivative);
        let Pose { position, heading, curvature, .. } = self.road().pose(at, t, 0.0)?;
        // The lateral place in plan view is t(s)·cos σ(s); its change by s turns the line against the reference line, which
        // itself passes 1 − κ·t·cos σ of its length there.
        let (roll_cos, roll_sin) = self.road().roll(at);
        let roll_slope = self.road().superelevation_slope(at);
        let change = drift * roll_cos - t * roll_sin * roll_slope;
        let along = 1.0 - curvature * t * roll_cos;
        // Beyond the centre of curvature the line runs backwards; traffic does not.
        let turn = mapd_geometry::atan2(if along < 0.0 { -change } else { change }, along.abs());
        let back = if self.is_forward() { 0.0 } else { std::f64::consts::PI };
        let width = (edges.outer.value - edges.inner.value).abs();
        let heading = normalize_angle(heading + turn + back);
        let (start, end) = (self.section().s_start(), self.section().s_end());
        let s = mapd_geometry::clamp(s, start, end);
        Ok(Waypoint { s, position, heading, width, clamped })
    }

    /// Waypoints in driving direction, `step` metres of s apart, from where the lane is entered to where it is left; both
    /// ends are among them, the last step may be shorter. None for lane 0.
    ///
    /// Errors: a step that is not a positive finite number.
    pub fn waypoints(
        &self,
        step: f64,
    ) -> Result<impl Iterator<Item = Result<Waypoint, QueryError>> + use<'a>, QueryError> {
        if !(step.is_finite() && step > 0.0) {
            return Err(QueryError::NotFinite);
        }
        let lane = *self;
        let (start, end) = (self.section().s_start(), self.section().s_end());
        let length = if self.number() == 0 { -1.0 } else { end - start };
        let forward = self.is_forward();
        let mut next = 0u64;
        let mut ended = length < 0.0;
        Ok(std::iter::from_fn(move || {
            if ended {
                return None;
            }
            let gone = next as f64 * step;
            next += 1;
            let gone = if gone >= length {
                ended = true;
                length
            } else {
                gone
            };
            Some(lane.waypoint_at(if forward { start + gone } else { end - gone }))
        }))
    }
}
