//! What lies along a path: its lanes, its room, and who crosses it.

use crate::code::{answer, mapd_code, mapd_error};
use crate::graph::vehicle_of;
use crate::ids::mapd_lane_id;
use crate::list::{List, entries, fill, get_mut, put, put_some};
use crate::path::{mapd_path, mapd_path_point, mapd_path_position, path_of};
use crate::point::{mapd_vec2, mapd_vec3};
use crate::route::mapd_route_step;
use crate::scratch::mapd_scratch;
use crate::snapshot::{map_of, mapd_snapshot};
use mapd_client::LaneId;
use mapd_client::path::{EdgeMark, PathConflict, PathLane, Yields, steps_of_lanes};

/// A lane of a path and what of it is driven.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_lane {
    /// The lane.
    pub lane: mapd_lane_id,
    /// S where it is entered \[m\].
    pub along_from: f64,
    /// S where it is left \[m\].
    pub along_to: f64,
    /// s on its road where it is entered \[m\].
    pub s_from: f64,
    /// s on its road where it is left \[m\].
    pub s_to: f64,
    /// Number of the route's step.
    pub step: usize,
    /// 1: it is travelled towards +s.
    pub forward: u8,
}

/// What lies on an edge of the driven lane.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_edge_mark {
    /// A `MAPD_ROAD_MARK_KIND_…`; none where there is none.
    pub kind: u8,
    /// A `MAPD_ROAD_MARK_COLOR_…`.
    pub color: u8,
    /// 1: a change of lane over this edge is allowed, into a lane of its direction that the vehicle may use.
    pub may_cross: u8,
}

/// The room at one station of a path. Left and right are those of who drives; edges lie on the plane h = 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_corridor_station {
    /// S \[m\].
    pub along: f64,
    /// The driven lane.
    pub lane: mapd_lane_id,
    /// Left edge of the driven lane \[m\].
    pub left: mapd_vec3,
    /// Right edge of the driven lane \[m\].
    pub right: mapd_vec3,
    /// Left edge of the leftmost lane beside it that has its direction and is open to the vehicle \[m\].
    pub outer_left: mapd_vec3,
    /// Right edge of the rightmost such lane \[m\].
    pub outer_right: mapd_vec3,
    /// What lies on the left edge of the driven lane.
    pub left_mark: mapd_edge_mark,
    /// What lies on its right edge.
    pub right_mark: mapd_edge_mark,
}

/// `yields` of a conflict: who drives along the path gives way.
pub const MAPD_YIELDS_YIELDS: u8 = 0;
/// `yields` of a conflict: the other gives way.
pub const MAPD_YIELDS_PRIORITY: u8 = 1;
/// `yields` of a conflict: lights decide.
pub const MAPD_YIELDS_LIGHTS: u8 = 2;
/// `yields` of a conflict: the file's priorities say nothing about the two.
pub const MAPD_YIELDS_OPEN: u8 = 3;
/// `yields` of a conflict: the file does not say, and a rule of the road would have to.
pub const MAPD_YIELDS_UNKNOWN: u8 = 4;

/// A place where the traffic of another lane meets a path.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_conflict {
    /// S of the first common place \[m\]; too early by up to half a metre.
    pub along_from: f64,
    /// S of the last common place \[m\]; too late by up to half a metre.
    pub along_to: f64,
    /// The other lane.
    pub other: mapd_lane_id,
    /// The smaller s of the common place on its road \[m\].
    pub other_s_from: f64,
    /// The larger s of the common place on its road \[m\].
    pub other_s_to: f64,
    /// S at which to wait \[m\]: the line to stop at on the path, else the last place before the common one.
    pub wait: f64,
    /// How the two meet: a `MAPD_CONFLICT_KIND_…`.
    pub kind: u8,
    /// Who goes first, by what the file says: a `MAPD_YIELDS_…`.
    pub yields: u8,
    /// Why: a `MAPD_RELATION_REASON_…`; what a rule of the road would say where `yields` is `MAPD_YIELDS_UNKNOWN`.
    pub reason: u8,
}

impl From<PathLane> for mapd_path_lane {
    fn from(own: PathLane) -> Self {
        let ([along_from, along_to], [s_from, s_to]) = (own.along, own.s);
        let (lane, forward, step) = (own.lane.into(), own.forward.into(), own.step);
        Self { lane, along_from, along_to, s_from, s_to, step, forward }
    }
}

impl From<EdgeMark> for mapd_edge_mark {
    fn from(mark: EdgeMark) -> Self {
        let (kind, color) = (mark.kind.code(), mark.color.code());
        Self { kind, color, may_cross: mark.may_cross.into() }
    }
}

impl From<&PathConflict> for mapd_path_conflict {
    fn from(one: &PathConflict) -> Self {
        let ([along_from, along_to], [other_s_from, other_s_to]) = (one.along, one.other_s);
        Self {
            along_from,
            along_to,
            other: one.other.into(),
            other_s_from,
            other_s_to,
            wait: one.wait,
            kind: one.kind.code(),
            yields: match one.yields {
                Yields::Yields => MAPD_YIELDS_YIELDS,
                Yields::Priority => MAPD_YIELDS_PRIORITY,
                Yields::Lights => MAPD_YIELDS_LIGHTS,
                Yields::Open => MAPD_YIELDS_OPEN,
                _ => MAPD_YIELDS_UNKNOWN,
            },
            reason: one.reason.code(),
        }
    }
}

/// The steps over lanes that follow each other, as `mapd_lane_sequences` lists them, from s \[m\] on the first to s on the last; each in its own
/// driving direction.
///
/// Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_steps_of_lanes(
    snapshot: *const mapd_snapshot,
    lanes: *const mapd_lane_id,
    lane_count: usize,
    s_from: f64,
    s_to: f64,
    scratch: *mut mapd_scratch,
    out: *mut mapd_route_step,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let mapd_scratch { lanes: own, steps, .. } = get_mut(scratch, "a scratch")?;
            own.clear();
            own.extend(entries(lanes, lane_count, "the lanes")?.iter().map(|l| LaneId::from(*l)));
            steps_of_lanes(map_of(snapshot)?, own, [s_from, s_to], steps)?;
            List { out, capacity, count }.write(steps.iter().map(|step| (*step).into()))
        })
    }
}

/// The lanes that are driven on, in ascending S; one that is only changed from is not among them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_lanes(
    path: *const mapd_path,
    out: *mut mapd_path_lane,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            List { out, capacity, count }.write(path_of(path)?.lanes().map(Into::into))
        })
    }
}

/// S of a place on one of the path's lanes \[m\]: the first where it is driven over several times. `MAPD_CODE_NONE` for one that the path does
/// not pass.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_along_of(
    path: *const mapd_path,
    lane: mapd_lane_id,
    s: f64,
    out: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put_some(out, path_of(path)?.along_of(lane.into(), s))) }
}

/// 1 where some joint is broken: a gap of more than 0.1 m or a kink of more than 0.3 rad.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_is_broken(
    path: *const mapd_path,
    out: *mut u8,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, path_of(path)?.is_broken().into())) }
}

/// As `mapd_path_at`, of `count` places; `out` has room for as many.
///
/// Errors: as `mapd_path_at`; the answers before the place that has one are written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_at_batch(
    path: *const mapd_path,
    along: *const f64,
    count: usize,
    out: *mut mapd_path_point,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let path = path_of(path)?;
            let along = entries(along, count, "the places")?;
            fill(out, along, |along| path.at(*along).map(Into::into))
        })
    }
}

/// As `mapd_path_project` without a hint, of `count` points; `out` has room for as many.
///
/// Errors: as `mapd_path_project`; the answers before the point that has one are written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_project_batch(
    path: *const mapd_path,
    points: *const mapd_vec2,
    count: usize,
    out: *mut mapd_path_position,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let path = path_of(path)?;
            let points = entries(points, count, "the points")?;
            fill(out, points, |point| path.project((*point).into(), None).map(Into::into))
        })
    }
}

/// The room along the path from S, `from` \[m\], on: a station every `step` \[m\] and one at the end, `length` \[m\] on or where the path ends.
/// `vehicle` is a `MAPD_VEHICLE_CLASS_…`.
///
/// Errors: `MAPD_CODE_NOT_FINITE`, also for a step that is not positive or gives more than a million stations; `MAPD_CODE_ARGUMENT` for an
/// unknown class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_corridor(
    path: *const mapd_path,
    from: f64,
    length: f64,
    step: f64,
    vehicle: u8,
    scratch: *mut mapd_scratch,
    out: *mut mapd_corridor_station,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let room = &mut get_mut(scratch, "a scratch")?.corridor;
            path_of(path)?.corridor(from, length, step, vehicle_of(vehicle)?, room)?;
            let station = |i: usize| mapd_corridor_station {
                along: room.along[i],
                lane: room.lane[i].into(),
                left: room.left[i].into(),
                right: room.right[i].into(),
                outer_left: room.outer_left[i].into(),
                outer_right: room.outer_right[i].into(),
                left_mark: room.left_mark[i].into(),
                right_mark: room.right_mark[i].into(),
            };
            List { out, capacity, count }.write((0..room.len()).map(station))
        })
    }
}

/// Where lanes of junctions and other lanes that the map knows to conflict meet the path, in ascending S. Lanes that the path itself drives on
/// are left out.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_conflicts(
    path: *const mapd_path,
    scratch: *mut mapd_scratch,
    out: *mut mapd_path_conflict,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let conflicts = &mut get_mut(scratch, "a scratch")?.conflicts;
            path_of(path)?.conflicts(conflicts);
            List { out, capacity, count }.write(conflicts.iter().map(Into::into))
        })
    }
}
