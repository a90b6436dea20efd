//! Points and poses.

use mapd_client::glam::{DVec2, DVec3};
use mapd_client::{Clamped, LanePosition, Point, Pose, Region, Track, TrackPosition};

/// A place in plan view, inertial \[m\].
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct mapd_vec2 {
    /// East \[m\].
    pub x: f64,
    /// North \[m\].
    pub y: f64,
}

/// A place or direction in space, inertial \[m\].
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct mapd_vec3 {
    /// East \[m\].
    pub x: f64,
    /// North \[m\].
    pub y: f64,
    /// Up \[m\].
    pub z: f64,
}

/// A point that is asked about.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct mapd_point {
    /// East \[m\].
    pub x: f64,
    /// North \[m\].
    pub y: f64,
    /// Up \[m\]; counts only with `has_z`.
    pub z: f64,
    /// Not 0: z is known.
    pub has_z: u64,
}

/// A rectangle along the axes, inertial \[m\], edges included.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct mapd_region {
    /// Smallest x and y.
    pub low: mapd_vec2,
    /// Largest x and y.
    pub high: mapd_vec2,
}

/// Track coordinates of a road (OpenDRIVE 1.8.1, 8.3).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct mapd_track {
    /// Along the reference line \[m\].
    pub s: f64,
    /// Lateral \[m\], positive to the left of the reference line.
    pub t: f64,
    /// Upwards \[m\], perpendicular to the plane rolled by superelevation.
    pub h: f64,
}

/// `clamped` of a place: it was not moved.
pub const MAPD_CLAMPED_NO: u8 = 0;
/// `clamped` of a place: it lay before the beginning of the line and was moved there.
pub const MAPD_CLAMPED_BEFORE: u8 = 1;
/// `clamped` of a place: it lay after the end of the line and was moved there.
pub const MAPD_CLAMPED_AFTER: u8 = 2;

/// A place on or beside a road or lane, with the frame there: of a road ahead is the way its reference line runs, of a lane the way its
/// traffic goes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_pose {
    /// Inertial position \[m\].
    pub position: mapd_vec3,
    /// Direction ahead \[rad\], in (−π, π], counter-clockwise from x: of a road that of its reference line, of a lane its own.
    pub heading: f64,
    /// Curvature of the line that runs this way \[1/m\], positive to the left.
    pub curvature: f64,
    /// Metres upwards per metre of s ahead.
    pub slope: f64,
    /// Superelevation \[rad\], positive lifts the left side.
    pub superelevation: f64,
    /// Whether s lay outside and was moved to the nearer end.
    pub clamped: u8,
}

/// Foot of a point on a road's reference line.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_track_position {
    /// Along the reference line \[m\].
    pub s: f64,
    /// Lateral \[m\], positive to the left.
    pub t: f64,
    /// Upwards \[m\]; 0 without `has_h`.
    pub h: f64,
    /// Plan-view distance from the reference line \[m\].
    pub distance: f64,
    /// 1: the point had a z, and h is known.
    pub has_h: u8,
    /// Whether the foot is an end of the road and the point lies beyond it.
    pub clamped: u8,
    /// 1: (s, t, h) is the point; 0 beyond an end of the road and in the wedge beside a kink of its line.
    pub exact: u8,
}

/// A point in a lane's own coordinates. Left, right and ahead are those of the lane's traffic unless a name says `of_reference_line`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_lane_position {
    /// Along the road's reference line \[m\], within the lane's section.
    pub s: f64,
    /// Lateral on the road \[m\], positive to the left of the reference line.
    pub t: f64,
    /// From the lane's centre \[m\], positive to the left as its traffic goes.
    pub offset: f64,
    /// From the lane's centre \[m\], positive to the left of the reference line.
    pub offset_of_reference_line: f64,
    /// Plan-view distance from the lane's area \[m\]; 0 inside.
    pub distance: f64,
    /// Height of the plane h = 0 at (s, t) \[m\].
    pub z: f64,
    /// The way the lane's traffic goes at s and this offset \[rad\], in (−π, π]: the heading of `mapd_lane_pose_at`.
    pub heading: f64,
    /// Heading of the reference line at s \[rad\], in (−π, π].
    pub heading_of_reference_line: f64,
    /// Whether the point lies before or after the lane's section in the direction of s.
    pub clamped: u8,
}

impl mapd_lane_position {
    /// What stands where there is none.
    pub(crate) const NOWHERE: Self = Self {
        s: 0.0,
        t: 0.0,
        offset: 0.0,
        offset_of_reference_line: 0.0,
        distance: 0.0,
        z: 0.0,
        heading: 0.0,
        heading_of_reference_line: 0.0,
        clamped: 0,
    };
}

impl From<DVec2> for mapd_vec2 {
    #[inline]
    fn from(v: DVec2) -> Self {
        Self { x: v.x, y: v.y }
    }
}

impl From<DVec3> for mapd_vec3 {
    #[inline]
    fn from(v: DVec3) -> Self {
        Self { x: v.x, y: v.y, z: v.z }
    }
}

impl From<mapd_vec3> for DVec3 {
    #[inline]
    fn from(v: mapd_vec3) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}

impl From<mapd_vec2> for DVec2 {
    #[inline]
    fn from(v: mapd_vec2) -> Self {
        Self::new(v.x, v.y)
    }
}

impl From<mapd_point> for Point {
    #[inline]
    fn from(p: mapd_point) -> Self {
        Self { xy: DVec2::new(p.x, p.y), z: (p.has_z != 0).then_some(p.z) }
    }
}

impl From<mapd_region> for Region {
    fn from(r: mapd_region) -> Self {
        Self { low: r.low.into(), high: r.high.into() }
    }
}

impl From<mapd_track> for Track {
    #[inline]
    fn from(t: mapd_track) -> Self {
        Self { s: t.s, t: t.t, h: t.h }
    }
}

/// `MAPD_CLAMPED_…`.
#[inline]
pub(crate) fn clamped_code(clamped: Clamped) -> u8 {
    match clamped {
        Clamped::No => MAPD_CLAMPED_NO,
        Clamped::Before => MAPD_CLAMPED_BEFORE,
        Clamped::After => MAPD_CLAMPED_AFTER,
    }
}

/// The value of a code; one that is none counts as not moved.
#[inline]
pub(crate) fn clamped_of(code: u8) -> Clamped {
    match code {
        MAPD_CLAMPED_BEFORE => Clamped::Before,
        MAPD_CLAMPED_AFTER => Clamped::After,
        _ => Clamped::No,
    }
}

impl From<Pose> for mapd_pose {
    #[inline]
    fn from(pose: Pose) -> Self {
        let Pose { position, heading, curvature, slope, superelevation, clamped } = pose;
        let (position, clamped) = (position.into(), clamped_code(clamped));
        Self { position, heading, curvature, slope, superelevation, clamped }
    }
}

impl From<TrackPosition> for mapd_track_position {
    #[inline]
    fn from(position: TrackPosition) -> Self {
        let TrackPosition { s, t, h, distance, clamped, exact } = position;
        Self {
            s,
            t,
            h: h.unwrap_or(0.0),
            distance,
            has_h: h.is_some().into(),
            clamped: clamped_code(clamped),
            exact: exact.into(),
        }
    }
}

impl From<LanePosition> for mapd_lane_position {
    #[inline]
    fn from(p: LanePosition) -> Self {
        Self {
            s: p.s,
            t: p.t,
            offset: p.offset,
            offset_of_reference_line: p.offset_of_reference_line,
            distance: p.distance,
            z: p.z,
            heading: p.heading,
            heading_of_reference_line: p.heading_of_reference_line,
            clamped: clamped_code(p.clamped),
        }
    }
}

impl From<mapd_lane_position> for LanePosition {
    fn from(p: mapd_lane_position) -> Self {
        Self {
            s: p.s,
            t: p.t,
            offset: p.offset,
            offset_of_reference_line: p.offset_of_reference_line,
            distance: p.distance,
            z: p.z,
            heading: p.heading,
            heading_of_reference_line: p.heading_of_reference_line,
            clamped: clamped_of(p.clamped),
        }
    }
}
