//! Steps of routes and paths: made of lanes, cut out of a path, found again on the next version of a map; their changes of lane and length.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::ids::mapd_lane_id;
use crate::list::{List, entries, finite, get_mut, put, put_raw, put_some};
use crate::path::{mapd_path, path_of};
use crate::route::{
    cost_of, mapd_cost, mapd_position_on_lane, mapd_route_step, mapd_route_sum, step_of, take_steps,
};
use crate::scratch::mapd_scratch;
use crate::snapshot::{map_of, mapd_snapshot};
use mapd_client::path::{PathChange, PathChangeKind, steps_of_lanes};
use mapd_client::{LaneId, QueryError};

/// `kind` of a path's change: its lane has the same key and has moved, by at most `distance` where it was looked at.
pub const MAPD_PATH_CHANGE_MOVED: u32 = 0;
/// `kind` of a path's change: a lane with another key lies there, at most `distance` away where it was looked at.
pub const MAPD_PATH_CHANGE_REPLACED: u32 = 1;
/// `kind` of a path's change: no lane lies there for the vehicle and its direction.
pub const MAPD_PATH_CHANGE_GONE: u32 = 2;

/// What has become of a stretch of a path on another version of its map.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_change {
    /// S of its beginning on the old path \[m\].
    pub along_from: f64,
    /// S of its end on the old path \[m\].
    pub along_to: f64,
    /// How far away its lane lies now \[m\]; 0 for one that is gone.
    pub distance: f64,
    /// A `MAPD_PATH_CHANGE_…`.
    pub kind: u32,
}

/// The next change of lane on a route.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_lane_change {
    /// Number of the step that is entered by it.
    pub step: usize,
    /// Distance along the route to the first place where it may happen \[m\].
    pub from: f64,
    /// Distance along the route to the last place where it may happen \[m\].
    pub until: f64,
    /// 1: it goes to the left.
    pub left: u8,
}

impl From<&PathChange> for mapd_path_change {
    fn from(own: &PathChange) -> Self {
        let [along_from, along_to] = own.along;
        let (kind, distance) = match own.kind {
            PathChangeKind::Moved(distance) => (MAPD_PATH_CHANGE_MOVED, distance),
            PathChangeKind::Replaced(distance) => (MAPD_PATH_CHANGE_REPLACED, distance),
            _ => (MAPD_PATH_CHANGE_GONE, 0.0),
        };
        Self { along_from, along_to, distance, kind }
    }
}

/// The steps over lanes that follow each other, as `mapd_lane_sequences` lists them, from s \[m\] on the first to s on the last; each in its own
/// driving direction, one for both directions in that which links ask for.
///
/// Errors, by the number of the lane: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for one that does not follow the lane before.
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

/// The part of a path's steps from S, `from`, to S, `to` \[m\]: what a new path over it is made of. `steps` are those that the path was made from.
///
/// Errors: `MAPD_CODE_ARGUMENT` for steps that are not the path's, and where `from` is not less than `to`; `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_steps_between(
    path: *const mapd_path,
    steps: *const mapd_route_step,
    step_count: usize,
    from: f64,
    to: f64,
    scratch: *mut mapd_scratch,
    out: *mut mapd_route_step,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (from, to) = (finite(from)?, finite(to)?);
            let mapd_scratch { steps: own, part, .. } = get_mut(scratch, "a scratch")?;
            take_steps(steps, step_count, own)?;
            path_of(path)?.steps_between(own, [from, to], part)?;
            List { out, capacity, count }.write(part.iter().map(|step| (*step).into()))
        })
    }
}

/// The way of a path on another snapshot, such as the next version of its map: its lanes are found by key, and where there is none or it lies elsewhere
/// by their place. `out` gets the steps of the new route, for `mapd_path_new`, and `sum` what it comes to; null is fine. `changes` gets what has changed and where,
/// in ascending S of the old path: nothing for a map on which all is the same. `MAPD_CODE_NONE` if no way leads along what is left of the path;
/// `changes` are written nevertheless.
///
/// Errors: `MAPD_CODE_CORRUPT`; `MAPD_CODE_ARGUMENT` for an unknown cost or class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_rebase(
    path: *const mapd_path,
    snapshot: *const mapd_snapshot,
    cost: mapd_cost,
    scratch: *mut mapd_scratch,
    sum: *mut mapd_route_sum,
    out: *mut mapd_route_step,
    capacity: usize,
    count: *mut usize,
    changes: *mut mapd_path_change,
    changes_capacity: usize,
    changes_count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let mapd_scratch { route, steps, changes: own, .. } = get_mut(scratch, "a scratch")?;
            let (path, map, (vehicle, cost)) = (path_of(path)?, map_of(snapshot)?, cost_of(cost)?);
            let found: Result<_, QueryError> = path.rebase(map, vehicle, &cost, route, steps, own);
            let found = found.map_err(Failure::from)?;
            let told = List { out: changes, capacity: changes_capacity, count: changes_count }
                .write(own.iter().map(Into::into))?;
            let way = steps.iter().filter(|_| found.is_some()).map(|step| (*step).into());
            let code = List { out, capacity, count }.write(way)?;
            if told != mapd_code::OK {
                return Ok(told);
            }
            let Some(found) = found else { return Ok(mapd_code::NONE) };
            put_raw(sum, found.into())?;
            Ok(code)
        })
    }
}

/// The next change of lane on a route, seen from a place on step number `at`. `MAPD_CODE_NONE` if the route needs no more.
///
/// Errors: as `mapd_route`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_next_lane_change(
    snapshot: *const mapd_snapshot,
    steps: *const mapd_route_step,
    step_count: usize,
    at: usize,
    place: mapd_position_on_lane,
    scratch: *mut mapd_scratch,
    out: *mut mapd_lane_change,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let own = &mut get_mut(scratch, "a scratch")?.steps;
            take_steps(steps, step_count, own)?;
            let next =
                mapd_client::route::next_lane_change(map_of(snapshot)?, own, at, place.into())?;
            let next = next.map(|next| mapd_lane_change {
                step: next.step,
                from: next.from,
                until: next.until,
                left: next.left.into(),
            });
            put_some(out, next)
        })
    }
}

/// The length of a route's steps along centre lines \[m\].
///
/// Errors: as `mapd_route`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_steps_length(
    snapshot: *const mapd_snapshot,
    steps: *const mapd_route_step,
    step_count: usize,
    out: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let map = map_of(snapshot)?;
            let mut sum = 0.0;
            for (number, step) in entries(steps, step_count, "the steps")?.iter().enumerate() {
                let of_step = |wrong: Failure| wrong.of_entry(number);
                let step = step_of(*step).map_err(of_step)?;
                let lane = map.lane(step.lane).map_err(|wrong| of_step(wrong.into()))?;
                sum += lane.length_between(step.s_from, step.s_to);
            }
            put(out, sum)
        })
    }
}
