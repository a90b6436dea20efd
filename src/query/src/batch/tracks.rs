//! Many places of a road, from track coordinates and to them.

use super::{Places, check_columns, number};
use crate::error::QueryError;
use crate::line_stretch::LineStretch;
use crate::profile;
use crate::road::{Road, kept};
use crate::types::{Clamped, Pose, Track, TrackPosition, is_coordinate};

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

    fn resize(&mut self, count: usize) {
        self.columns().into_iter().for_each(|column| column.resize(count, 0.0));
        self.clamped.resize(count, Clamped::No);
    }

    /// Sets the pose of this number.
    #[inline]
    fn set(&mut self, i: usize, pose: &Pose) {
        let Pose { position: p, heading, curvature, slope, superelevation, clamped } = *pose;
        let values = [p.x, p.y, p.z, heading, curvature, slope, superelevation];
        for (column, value) in self.columns().into_iter().zip(values) {
            column.get_mut(i).into_iter().for_each(|place| *place = value);
        }
        self.clamped.get_mut(i).into_iter().for_each(|place| *place = clamped);
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

/// Gives places along a road their poses: what holds at one place is not looked up again for the next where it still does.
struct Placer<'a> {
    road: Road<'a>,
    end: f64,
    stretch: Option<LineStretch<'a>>,
}

impl Placer<'_> {
    /// As [`Road::to_inertial`], bit for bit.
    #[inline]
    fn pose(&mut self, track: Track) -> Result<Pose, QueryError> {
        let (s, clamped) = kept(track.s, self.end)?;
        if !(is_coordinate(track.t) && is_coordinate(track.h)) {
            return Err(QueryError::NotFinite);
        }
        if !self.stretch.as_ref().is_some_and(|stretch| stretch.held.contains(s)) {
            self.stretch = LineStretch::at(&self.road, s);
        }
        let stretch = self.stretch.as_ref().ok_or(QueryError::Corrupt)?;
        let point = stretch.piece.curve.evaluate(s - stretch.piece.s);
        let superelevation = stretch.superelevation.value(s);
        let (roll_cos, roll_sin) = profile::roll(superelevation);
        let roll = (roll_cos, roll_sin, superelevation);
        let beside = [track.t, track.h];
        let pose = self.road.pose_beside(&point, stretch.elevation.slope(s), roll, beside);
        Ok(Pose { clamped, ..pose })
    }
}

impl Road<'_> {
    /// [`Road::to_inertial`] of many places, in their order. What `out` had before is gone, after an error too; it grows only if it is too small.
    ///
    /// Errors: a column that is not as long as the others, by its name; coordinates that are not finite, by the number of the
    /// place; a damaged archive.
    pub fn to_inertial_batch(&self, tracks: Tracks<'_>, out: &mut Poses) -> Result<(), QueryError> {
        let placed = self.place_all(tracks, out);
        if placed.is_err() {
            out.resize(0);
        }
        placed
    }

    fn place_all(&self, tracks: Tracks<'_>, out: &mut Poses) -> Result<(), QueryError> {
        check_columns(&[("s", Some(tracks.s)), ("t", Some(tracks.t)), ("h", tracks.h)])?;
        out.resize(tracks.s.len());
        let mut placer = Placer { road: *self, end: self.reference_end().max(0.0), stretch: None };
        for i in 0..tracks.s.len() {
            let h = tracks.h.map_or(0.0, |h| number(h, i));
            let track = Track { s: number(tracks.s, i), t: number(tracks.t, i), h };
            out.set(i, &placer.pose(track)?);
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
