//! Ways, corridors, signals and poses under what is laid over a map.

use crate::code::{answer, mapd_code, mapd_error};
use crate::corridor::{mapd_corridor_station, stations};
use crate::graph::vehicle_of;
use crate::ids::mapd_lane_id;
use crate::list::{List, entries, finite, get_mut, put_raw};
use crate::matching::{mapd_lane_match, mapd_match_options, mapd_vehicle_pose, match_options};
use crate::path::{mapd_path, path_of};
use crate::route::{
    cost_of, mapd_cost, mapd_position_on_lane, mapd_route_step, mapd_route_sum, take_places,
};
use crate::scratch::mapd_scratch;
use crate::signals_ahead::{mapd_signal_ahead, signal_ahead};
use crate::view::{mapd_view, view_of};
use mapd_client::glam::DMat3;
use mapd_client::route::Reached;

/// A node, or a piece of one where an overlay cuts it, that can be reached.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_reached_piece {
    /// The lane.
    pub lane: mapd_lane_id,
    /// Smaller end on the road \[m\].
    pub s_from: f64,
    /// Larger end on the road \[m\].
    pub s_to: f64,
    /// Least cost up to its beginning; of those beside the start, of the lane changes to them.
    pub cost: f64,
    /// Changes of lane on this way.
    pub lane_changes: u32,
    /// 1: it is travelled towards +s.
    pub forward: u8,
}

impl From<&Reached> for mapd_reached_piece {
    fn from(one: &Reached) -> Self {
        let Reached { lane, forward, s_from, s_to, cost, lane_changes, .. } = *one;
        let (low, high) = (s_from.min(s_to), s_from.max(s_to));
        let (lane, forward) = (lane.into(), forward.into());
        Self { lane, s_from: low, s_to: high, cost, lane_changes, forward }
    }
}

/// As `mapd_route`, with the overlay's current entries applied: closed stretches are not entered, opened ones may be, and times are those of today's speeds. The lane of the
/// start may be closed.
///
/// Errors: as `mapd_route`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_route(
    view: *const mapd_view,
    places: *const mapd_position_on_lane,
    place_count: usize,
    cost: mapd_cost,
    scratch: *mut mapd_scratch,
    sum: *mut mapd_route_sum,
    out: *mut mapd_route_step,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (view, (vehicle, cost)) = (view_of(view)?, cost_of(cost)?);
            let mapd_scratch { route, steps, places: own, .. } = get_mut(scratch, "a scratch")?;
            take_places(places, place_count, own)?;
            let found = view.route_via(own, vehicle, &cost, route, steps)?;
            let code = List { out, capacity, count }.write(steps.iter().map(|s| (*s).into()))?;
            let Some(found) = found else { return Ok(mapd_code::NONE) };
            put_raw(sum, found.into())?;
            Ok(code)
        })
    }
}

/// As `mapd_reachable`, with the overlay's current entries applied. If the overlay cuts a node, the answer lists its pieces one by one.
///
/// Errors: as `mapd_reachable`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_reachable(
    view: *const mapd_view,
    from: mapd_position_on_lane,
    limit: f64,
    cost: mapd_cost,
    scratch: *mut mapd_scratch,
    out: *mut mapd_reached_piece,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (view, (vehicle, cost)) = (view_of(view)?, cost_of(cost)?);
            let mapd_scratch { route, reached, .. } = get_mut(scratch, "a scratch")?;
            view.reachable(from.into(), finite(limit)?, vehicle, &cost, route, reached)?;
            List { out, capacity, count }.write(reached.iter().map(Into::into))
        })
    }
}

/// As `mapd_path_corridor`, with the overlay's current entries applied: beside the path a lane that is closed cannot be changed to and adds no room, and one that is opened
/// may and does; the speeds are today's, with the origin `MAPD_SPEED_ORIGIN_OVERLAY` where an entry states them.
///
/// Errors: as `mapd_path_corridor`; `MAPD_CODE_FOREIGN_ID` for a path on another map.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_corridor(
    view: *const mapd_view,
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
            let (view, path, vehicle) = (view_of(view)?, path_of(path)?, vehicle_of(vehicle)?);
            let room = &mut get_mut(scratch, "a scratch")?.corridor;
            view.corridor(&path, from, length, step, vehicle, room)?;
            List { out, capacity, count }.write(stations(room))
        })
    }
}

/// As `mapd_signals_ahead`, with the overlay's current entries applied: ways through closed lanes are not followed. Signals that are out of service are among them;
/// `mapd_view_signal_out_of_service` tells which are.
///
/// Errors: as `mapd_signals_ahead`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_signals_ahead(
    view: *const mapd_view,
    from: mapd_position_on_lane,
    distance: f64,
    vehicle: u8,
    scratch: *mut mapd_scratch,
    out: *mut mapd_signal_ahead,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (view, vehicle) = (view_of(view)?, vehicle_of(vehicle)?);
            let found = &mut get_mut(scratch, "a scratch")?.signals_ahead;
            view.signals_ahead(from.into(), distance, vehicle, found)?;
            List { out, capacity, count }.write(found.iter().map(signal_ahead))
        })
    }
}

/// As `mapd_match_pose`, with the overlay's current entries applied: a lane that is closed to the options' vehicle, without one to passenger cars, has the prior of closed ones.
///
/// Errors: as `mapd_match_pose`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_match_pose(
    view: *const mapd_view,
    pose: mapd_vehicle_pose,
    covariance: *const f64,
    options: *const mapd_match_options,
    scratch: *mut mapd_scratch,
    out: *mut mapd_lane_match,
    capacity: usize,
    count: *mut usize,
    none: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let mapd_scratch { lanes, matches, .. } = get_mut(scratch, "a scratch")?;
            let options = match_options(options, lanes)?;
            let rows = entries(covariance, 9, "the covariance")?;
            let covariance = DMat3::from_cols_slice(rows).transpose();
            let left = view_of(view)?.match_pose(&pose.into(), &covariance, &options, matches)?;
            put_raw(none, left)?;
            List { out, capacity, count }.write(matches.iter().map(mapd_lane_match::from))
        })
    }
}
