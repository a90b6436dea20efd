//! Places along a path: its lanes, and many places at once.

use crate::code::{answer, mapd_code, mapd_error};
use crate::ids::mapd_lane_id;
use crate::list::{List, entries, fill, put, put_some};
use crate::path::{mapd_path, mapd_path_point, mapd_path_position, path_of};
use crate::point::mapd_vec2;
use mapd_client::path::PathLane;

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

impl From<PathLane> for mapd_path_lane {
    fn from(own: PathLane) -> Self {
        let ([along_from, along_to], [s_from, s_to]) = (own.along, own.s);
        let (lane, forward, step) = (own.lane.into(), own.forward.into(), own.step);
        Self { lane, along_from, along_to, s_from, s_to, step, forward }
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

/// Whether some joint is broken, 1 or 0: a gap of more than 0.1 m or a kink of more than 0.3 rad.
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
