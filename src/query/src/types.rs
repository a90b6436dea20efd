//! Coordinates and results, in the field's words.

use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// Track coordinates of a road (OpenDRIVE 1.8.1, 8.3).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Track {
    /// Along the reference line `[m]`, s ∈ [0, length].
    pub s: f64,
    /// Lateral `[m]`, positive to the left of the reference line.
    pub t: f64,
    /// Upwards `[m]`, perpendicular to the plane rolled by superelevation.
    pub h: f64,
}

/// Whether a place along a line was moved to one of the line's ends, because what was asked for lies beyond it.
#[repr(u8)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum Clamped {
    /// It was not.
    #[default]
    No,
    /// It lay before the beginning.
    Before,
    /// It lay after the end.
    After,
}

impl Clamped {
    /// Where a value lies with respect to an interval; of what is no number, `No`.
    #[inline]
    pub(crate) fn of(value: f64, start: f64, end: f64) -> Self {
        if value < start {
            Self::Before
        } else if value > end {
            Self::After
        } else {
            Self::No
        }
    }

    /// Whether it was moved.
    #[inline]
    pub fn is_clamped(self) -> bool {
        self != Self::No
    }

    /// `before`, `after`, or nothing.
    pub fn name(self) -> &'static str {
        match self {
            Self::No => "",
            Self::Before => "before",
            Self::After => "after",
        }
    }
}

/// A place on or beside a road or lane, with the frame there: of a road ([`crate::Road::to_inertial`]) ahead is the way its reference
/// line runs, of a lane ([`crate::Lane::pose_at`]) the way its traffic goes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Pose {
    /// Inertial position `[m]`.
    pub position: DVec3,
    /// Direction ahead `[rad]`, in (−π, π], counter-clockwise from x: of a road that of its reference line, of a lane its own.
    pub heading: f64,
    /// Curvature of the line that runs this way `[1/m]`, positive to the left.
    pub curvature: f64,
    /// Slope of the reference line: metres upwards per metre of s ahead.
    pub slope: f64,
    /// Superelevation `[rad]`, positive lifts the left side.
    pub superelevation: f64,
    /// Whether s lay outside the road, or the lane's section, and was moved to its nearer end.
    pub clamped: Clamped,
}

impl Pose {
    /// The same place, as who goes against the reference line sees it.
    #[inline]
    #[must_use]
    pub(crate) fn turned(self) -> Self {
        Self {
            heading: turned(self.heading),
            curvature: -self.curvature,
            slope: -self.slope,
            superelevation: -self.superelevation,
            ..self
        }
    }
}

/// The opposite of a heading in (−π, π], in (−π, π].
#[inline]
pub(crate) fn turned(heading: f64) -> f64 {
    if heading > 0.0 { heading - PI } else { heading + PI }
}

/// Foot of a point on a road's reference line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TrackPosition {
    /// Along the reference line `[m]`.
    pub s: f64,
    /// Lateral `[m]`, positive to the left.
    pub t: f64,
    /// Upwards `[m]`; only where the point had a z.
    pub h: Option<f64>,
    /// Plan-view distance from the reference line `[m]`.
    pub distance: f64,
    /// Whether the foot is an end of the road and the point lies beyond it.
    pub clamped: Clamped,
    /// Whether (s, t, h) is the point: [`crate::Road::to_inertial`] leads back to it. It is not where the point lies beyond an end
    /// of the road, nor where it lies in the wedge beside a kink or gap of the reference line, where no foot is perpendicular.
    pub exact: bool,
}

/// Coordinates beyond this are no place of a map `[m]`: a hundred times more than any projection of the Earth has, and little enough
/// that squares of distances keep millimetres apart.
pub(crate) const FARTHEST: f64 = 1e9;

/// Whether a number can be a coordinate: finite, and not absurd.
#[inline]
pub(crate) fn is_coordinate(number: f64) -> bool {
    // What is no number compares as false.
    number.abs() <= FARTHEST
}

/// As [`is_coordinate`], of both.
#[inline]
pub(crate) fn is_place(xy: DVec2) -> bool {
    is_coordinate(xy.x) && is_coordinate(xy.y)
}

/// A point to be matched.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Point {
    /// Plan-view position `[m]`, inertial.
    pub xy: DVec2,
    /// Height `[m]`, if known.
    pub z: Option<f64>,
}

impl Point {
    /// Whether its coordinates can be those of a place.
    #[inline]
    pub(crate) fn is_place(&self) -> bool {
        is_place(self.xy) && self.z.is_none_or(is_coordinate)
    }
}

impl From<DVec2> for Point {
    fn from(xy: DVec2) -> Self {
        Self { xy, z: None }
    }
}

impl From<DVec3> for Point {
    fn from(p: DVec3) -> Self {
        Self { xy: p.truncate(), z: Some(p.z) }
    }
}

/// Both edges of a lane at s, as lateral coordinates.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LaneEdges {
    /// t of the edge nearer to lane 0 `[m]`.
    pub inner: f64,
    /// t of the edge away from lane 0 `[m]`.
    pub outer: f64,
}

impl LaneEdges {
    /// Edges of a place that is none.
    pub(crate) const NOWHERE: Self = Self { inner: f64::NAN, outer: f64::NAN };

    /// Width `[m]`, never negative.
    pub fn width(self) -> f64 {
        (self.outer - self.inner).abs()
    }

    /// t of the centre `[m]`.
    pub fn center(self) -> f64 {
        0.5 * (self.inner + self.outer)
    }
}

/// A point in a lane's own coordinates. Left, right and ahead are those of the lane's traffic ([`crate::Lane::is_forward`]) unless a
/// name says `of_reference_line`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LanePosition {
    /// Along the road's reference line `[m]`, within the lane's section.
    pub s: f64,
    /// Lateral coordinate on the road `[m]`, positive to the left of the reference line.
    pub t: f64,
    /// From the lane's centre `[m]`, positive to the left as its traffic goes.
    pub offset: f64,
    /// From the lane's centre `[m]`, positive to the left of the reference line.
    pub offset_of_reference_line: f64,
    /// Plan-view distance from the lane's area `[m]`; 0 inside.
    pub distance: f64,
    /// Height of the plane h = 0 at (s, t) `[m]`.
    pub z: f64,
    /// The way the lane's traffic goes at s and this offset `[rad]`, in (−π, π]: the heading of [`crate::Lane::pose_at`].
    pub heading: f64,
    /// Heading of the reference line at s `[rad]`, in (−π, π].
    pub heading_of_reference_line: f64,
    /// Whether the point lies before or after the lane's section in the direction of s, which has no foot for it.
    pub clamped: Clamped,
}
