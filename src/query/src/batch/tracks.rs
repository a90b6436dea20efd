//! Many places of a road, from track coordinates and to them.

use super::{Places, check_columns, number};
use crate::error::QueryError;
use crate::road::Road;
use crate::types::{Clamped, Pose, Track, TrackPosition};

/// Track coordinates, a column each, all as long as `s`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Tracks<'a> {
    /// Along the reference line `[m]`.
    pub s: &'a [f64],
    /// Lateral `[m]`, positive to the left of the reference line.
    pub t: &'a [f64],
    /// Upwards `[m]`; 0 where there is no column.
    pub h: Option<&'a [f64]>,
}

/// Places with the frame there, a column for each part of [`Pose`].
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Poses {
    /// Inertial x `[m]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub x: Vec<f64>,
    /// Inertial y `[m]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub y: Vec<f64>,
    /// Inertial z `[m]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub z: Vec<f64>,
    /// Direction of the reference line `[rad]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub heading: Vec<f64>,
    /// Curvature of the reference line `[1/m]`, positive to the left.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub curvature: Vec<f64>,
    /// Metres upwards per metre of s.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub slope: Vec<f64>,
    /// Superelevation `[rad]`, positive lifts the left side.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub superelevation: Vec<f64>,
    /// Whether s lay outside the road and was moved to its nearer end.
    pub clamped: Vec<Clamped>,
}

impl Poses {
    fn columns(&mut self) -> [&mut Vec<f64>; 7] {
        let Self { x, y, z, heading, curvature, slope, superelevation, .. } = self;
        [x, y, z, heading, curvature, slope, superelevation]
    }

    fn clear(&mut self) {
        self.columns().into_iter().for_each(Vec::clear);
        self.clamped.clear();
    }

    fn push(&mut self, pose: &Pose) {
        let Pose { position: p, heading, curvature, slope, superelevation, clamped } = *pose;
        let values = [p.x, p.y, p.z, heading, curvature, slope, superelevation];
        self.columns().into_iter().zip(values).for_each(|(column, value)| column.push(value));
        self.clamped.push(clamped);
    }
}

/// Feet on a road's reference line, a column for each part of [`TrackPosition`].
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TrackPositions {
    /// Along the reference line `[m]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub s: Vec<f64>,
    /// Lateral `[m]`, positive to the left.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub t: Vec<f64>,
    /// Upwards `[m]`; NaN where the place had no z.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub h: Vec<f64>,
    /// Plan-view distance from the reference line `[m]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub distance: Vec<f64>,
    /// Whether the foot is an end of the road and the point lies beyond it.
    pub clamped: Vec<Clamped>,
    /// Whether (s, t, h) is the point.
    pub exact: Vec<bool>,
}

impl TrackPositions {
    fn columns(&mut self) -> [&mut Vec<f64>; 4] {
        [&mut self.s, &mut self.t, &mut self.h, &mut self.distance]
    }

    fn clear(&mut self) {
        self.columns().into_iter().for_each(Vec::clear);
        self.clamped.clear();
        self.exact.clear();
    }

    fn push(&mut self, at: &TrackPosition) {
        let values = [at.s, at.t, at.h.unwrap_or(f64::NAN), at.distance];
        self.columns().into_iter().zip(values).for_each(|(column, value)| column.push(value));
        self.clamped.push(at.clamped);
        self.exact.push(at.exact);
    }
}

impl Road<'_> {
    /// [`Road::to_inertial`] of many places, in their order. `out` is emptied first; it grows only if it is too small.
    ///
    /// Errors: a column that is not as long as the others, by its name; coordinates that are not finite, by the number of the
    /// place; a damaged archive.
    pub fn to_inertial_batch(&self, tracks: Tracks<'_>, out: &mut Poses) -> Result<(), QueryError> {
        out.clear();
        check_columns(&[("s", Some(tracks.s)), ("t", Some(tracks.t)), ("h", tracks.h)])?;
        for i in 0..tracks.s.len() {
            let h = tracks.h.map_or(0.0, |h| number(h, i));
            out.push(&self.to_inertial(Track {
                s: number(tracks.s, i),
                t: number(tracks.t, i),
                h,
            })?);
        }
        Ok(())
    }

    /// [`Road::to_track`] of many places, in their order. `out` is emptied first; it grows only if it is too small.
    ///
    /// Errors: as [`Road::to_inertial_batch`].
    pub fn to_track_batch(
        &self,
        places: Places<'_>,
        out: &mut TrackPositions,
    ) -> Result<(), QueryError> {
        out.clear();
        places.check()?;
        for i in 0..places.len() {
            out.push(&self.to_track(places.point(i))?);
        }
        Ok(())
    }
}
