//! A route as one line.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::graph::vehicle_of;
use crate::ids::mapd_lane_id;
use crate::list::{List, close, finite, get, hand_out, put, put_answer, put_some};
use crate::options::{given_options, put_defaults};
use crate::point::{clamped_code, mapd_vec2, mapd_vec3};
use crate::route::{mapd_route_step, take_steps};
use crate::signals::{mapd_speed_rule, speed_rule};
use crate::snapshot::mapd_snapshot;
use mapd_client::Snapshot;
use mapd_client::path::{
    LaneChange, Path, PathBuffer, PathError, PathOptions, PathPoint, PathPosition,
};

/// A route as one line. It keeps its snapshot; several threads may use it at once.
pub struct mapd_path {
    snapshot: Snapshot,
    buffer: PathBuffer,
}

/// A position on a path, as seen by a vehicle that drives along it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_point {
    /// S \[m\].
    pub along: f64,
    /// Inertial position on the plane h = 0 \[m\].
    pub position: mapd_vec3,
    /// Heading of the driven line \[rad\], in (−π, π].
    pub heading: f64,
    /// Curvature of the driven line in plan view \[1/m\], positive to the left.
    pub curvature: f64,
    /// Its change along the line \[1/m²\].
    pub curvature_rate: f64,
    /// Metres upwards per metre of S.
    pub grade: f64,
    /// Superelevation \[rad\]; positive lifts the driver's left side.
    pub superelevation: f64,
    /// Distance to the driven lane's left edge \[m\].
    pub left: f64,
    /// Distance to the driven lane's right edge \[m\].
    pub right: f64,
    /// The driven lane.
    pub lane: mapd_lane_id,
    /// s on its road \[m\].
    pub s: f64,
    /// 1: it is driven towards +s.
    pub forward: u8,
    /// Whether S lay outside the path and was moved to its nearer end.
    pub clamped: u8,
}

/// A point in a path's coordinates.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_position {
    /// S of the foot: the nearest point of the driven line in plan view \[m\].
    pub along: f64,
    /// Offset to the left of the driven line there \[m\].
    pub d: f64,
    /// Plan-view distance from the driven line \[m\].
    pub distance: f64,
    /// Heading of the driven line at the foot \[rad\], in (−π, π].
    pub heading: f64,
    /// The driven lane there.
    pub lane: mapd_lane_id,
    /// s on its road \[m\].
    pub s: f64,
    /// Whether the point lies before the path's start or after its end.
    pub clamped: u8,
}

/// A place where the driven line is not continuous, or changes lanes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_joint {
    /// S \[m\].
    pub along: f64,
    /// How far apart the line's two sides lie in plan view \[m\].
    pub gap: f64,
    /// By how much the line turns there \[rad\], positive to the left, in (−π, π].
    pub kink: f64,
    /// How the lane behind it is entered: a `MAPD_ENTER_…`.
    pub enter: u8,
    /// 1: gap or kink are larger than the options allow. A change of lane that jumps breaks nothing by its gap, unless the options say how short it may be.
    pub broken: u8,
    /// 1: a change of lane that jumps because there is no room for the curve that the options ask for.
    pub is_short: u8,
}

/// How a path is built. Set it with `mapd_path_options_init`, then change what should differ.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_path_options {
    /// Size of this struct as the caller knows it: later releases may append to it.
    pub size: usize,
    /// A joint with a larger gap is broken \[m\]; not negative, infinite for never. Default 0.1.
    pub broken_gap: f64,
    /// A joint with a larger kink is broken \[rad\]; as above. Default 0.3.
    pub broken_kink: f64,
    /// Length of S over which a change of lane is one smooth curve \[m\], for each lane that is changed to, over lanes that follow as far as it is allowed; 0, the default: the line jumps.
    pub change_length: f64,
    /// How short a change may be that is a curve, where less is allowed \[m\]; what has even less room jumps, and its joint is broken. 0, the default: no shorter than its length.
    pub shortest_change: f64,
    /// How far behind the first place where it can be a change begins that is a curve \[m\], as far as there is room; infinite for as late as can be. Default 0.
    pub change_delay: f64,
    /// The class of the vehicle: a `MAPD_VEHICLE_CLASS_…`. A change does not go on over lanes that it may not use. Default a passenger car.
    pub vehicle: u8,
}

impl From<PathError> for Failure {
    fn from(error: PathError) -> Self {
        match error {
            PathError::Step { source, .. } => {
                Self::new(Self::from(source).code(), error.to_string())
            }
            PathError::Map(source) => source.into(),
            error => Self::argument(error.to_string()),
        }
    }
}

impl From<PathPoint> for mapd_path_point {
    fn from(p: PathPoint) -> Self {
        Self {
            along: p.along,
            position: p.position.into(),
            heading: p.heading,
            curvature: p.curvature,
            curvature_rate: p.curvature_rate,
            grade: p.grade,
            superelevation: p.superelevation,
            left: p.left,
            right: p.right,
            lane: p.lane.into(),
            s: p.s,
            forward: p.forward.into(),
            clamped: clamped_code(p.clamped),
        }
    }
}

impl From<PathPosition> for mapd_path_position {
    fn from(p: PathPosition) -> Self {
        Self {
            along: p.along,
            d: p.d,
            distance: p.distance,
            heading: p.heading,
            lane: p.lane.into(),
            s: p.s,
            clamped: clamped_code(p.clamped),
        }
    }
}

/// The path of a handle.
///
/// # Safety
///
/// As [`get`].
pub(crate) unsafe fn path_of<'a>(path: *const mapd_path) -> Result<Path<'a, 'a>, Failure> {
    let path = unsafe { get(path, "a path") }?;
    Ok(Path::of(path.snapshot.map(), &path.buffer)?)
}

/// The options of a caller's; null is the default.
///
/// # Safety
///
/// As [`given_options`].
unsafe fn options_of(options: *const mapd_path_options) -> Result<PathOptions, Failure> {
    let Some(given) = unsafe { given_options(options, "mapd_path_options_init") }? else {
        return Ok(PathOptions::default());
    };
    Ok(PathOptions {
        broken_gap: given.broken_gap,
        broken_kink: given.broken_kink,
        change: if given.change_length == 0.0 {
            LaneChange::Jump
        } else {
            LaneChange::Lateral(given.change_length)
        },
        shortest_change: (given.shortest_change != 0.0).then_some(given.shortest_change),
        change_delay: given.change_delay,
        vehicle: vehicle_of(given.vehicle)?,
    })
}

/// Sets options to their defaults. `size` is `sizeof(mapd_path_options)`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_options_init(
    options: *mut mapd_path_options,
    size: usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let PathOptions { broken_gap, broken_kink, change_delay, vehicle, .. } =
                PathOptions::default();
            let defaults = mapd_path_options {
                size,
                broken_gap,
                broken_kink,
                change_length: 0.0,
                shortest_change: 0.0,
                change_delay,
                vehicle: vehicle.code(),
            };
            put_defaults(options, size, defaults)
        })
    }
}

/// The path along a route's steps. `options`: null is the default. Close it with `mapd_path_close`.
///
/// Errors: steps that do not follow each other, go backwards, or none, and options out of their domain: `MAPD_CODE_ARGUMENT`;
/// `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_new(
    snapshot: *const mapd_snapshot,
    steps: *const mapd_route_step,
    step_count: usize,
    options: *const mapd_path_options,
    out: *mut *mut mapd_path,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let snapshot = get(snapshot, "a snapshot")?.0.clone();
            let (mut own, mut buffer) = (Vec::new(), PathBuffer::default());
            take_steps(steps, step_count, &mut own)?;
            snapshot.map().path(&own, &options_of(options)?, &mut buffer)?;
            hand_out(out, mapd_path { snapshot, buffer })
        })
    }
}

/// Closes a path and sets the handle to null. Null, or a handle that is null, is fine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_close(path: *mut *mut mapd_path) {
    unsafe { close(path) }
}

/// Length: the largest S \[m\].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_length(
    path: *const mapd_path,
    out: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, path_of(path)?.length())) }
}

/// The place at S, `along` \[m\]. S outside the path is moved to its nearer end and flagged.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_at(
    path: *const mapd_path,
    along: f64,
    out: *mut mapd_path_point,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put_answer(out, path_of(path)?.at(along))) }
}

/// A point in the path's coordinates. `hint`: null, or S of a point nearby such as the one before: the search begins there.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_project(
    path: *const mapd_path,
    point: mapd_vec2,
    hint: *const f64,
    out: *mut mapd_path_position,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let hint = if hint.is_null() { None } else { Some(*get(hint, "the hint")?) };
            put_answer(out, path_of(path)?.project(point.into(), hint))
        })
    }
}

/// The speed limit at S, `along` \[m\]; in a junction that which comes in on the path. `MAPD_CODE_NONE` where the path has none.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_speed_at(
    path: *const mapd_path,
    along: f64,
    out: *mut mapd_speed_rule,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || put_some(out, path_of(path)?.speed_at(finite(along)?).map(speed_rule)))
    }
}

/// Gaps, overlaps and kinks of more than rounding, and changes of lane, in ascending S.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_joints(
    path: *const mapd_path,
    out: *mut mapd_path_joint,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let joints = path_of(path)?.joints().iter().map(|joint| mapd_path_joint {
                along: joint.along,
                gap: joint.gap,
                kink: joint.kink,
                enter: crate::route::enter_code(joint.enter),
                broken: joint.broken.into(),
                is_short: joint.short.into(),
            });
            List { out, capacity, count }.write(joints)
        })
    }
}
