//! Signals and lines ahead, along all ways that lanes lead or along a route.

use crate::code::{answer, mapd_code, mapd_error};
use crate::graph::vehicle_of;
use crate::ids::{mapd_lane_id, mapd_object_id, mapd_signal_id};
use crate::list::{List, get_mut};
use crate::route::{mapd_position_on_lane, mapd_route_step, take_steps};
use crate::scratch::mapd_scratch;
use crate::snapshot::{map_of, mapd_snapshot};
use mapd_client::rules::{LaneLine, LineAhead, LineSource};
use mapd_client::signals::SignalAhead;

/// A signal ahead.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_signal_ahead {
    /// The signal.
    pub signal: mapd_signal_id,
    /// The lane on which it counts.
    pub lane: mapd_lane_id,
    /// Distance along the lanes' centre lines \[m\].
    pub distance: f64,
    /// Its place on that lane's road \[m\].
    pub s: f64,
}

/// A stop line or crosswalk on a lane.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_lane_line_at {
    /// The signal that says so; one of `signal` and `object` names something.
    pub signal: mapd_signal_id,
    /// The object that says so.
    pub object: mapd_object_id,
    /// The lane.
    pub lane: mapd_lane_id,
    /// Where the lane's traffic meets it first, on the road \[m\].
    pub s: f64,
    /// Of a line ahead: distance along the lanes' centre lines from the route's start \[m\]; else 0.
    pub distance: f64,
    /// What it is: a `MAPD_CLASS_…`.
    pub class_code: u16,
}

/// A line of a lane.
pub(crate) fn lane_line(line: LaneLine) -> mapd_lane_line_at {
    let (signal, object) = match line.source {
        LineSource::Signal(signal) => (signal.into(), mapd_object_id::NONE),
        LineSource::Object(object) => (mapd_signal_id::NONE, object.into()),
    };
    mapd_lane_line_at {
        signal,
        object,
        lane: line.lane.into(),
        s: line.s,
        distance: 0.0,
        class_code: line.class.code(),
    }
}

impl mapd_lane_line_at {
    /// What stands where there is none.
    pub(crate) const NONE: Self = Self {
        signal: mapd_signal_id::NONE,
        object: mapd_object_id::NONE,
        lane: mapd_lane_id::NONE,
        s: 0.0,
        distance: 0.0,
        class_code: 0,
    };
}

pub(crate) fn signal_ahead(one: &SignalAhead) -> mapd_signal_ahead {
    mapd_signal_ahead {
        signal: one.signal.into(),
        lane: one.lane.into(),
        distance: one.distance,
        s: one.s,
    }
}

fn line_ahead(one: &LineAhead) -> mapd_lane_line_at {
    mapd_lane_line_at { distance: one.distance, ..lane_line(one.line) }
}

/// Signals for traffic that goes on from a place without changing lanes, up to a distance \[m\] along any way, the nearest first. `vehicle` is a
/// `MAPD_VEHICLE_CLASS_…`.
///
/// Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for an unknown class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_signals_ahead(
    snapshot: *const mapd_snapshot,
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
            let (map, vehicle) = (map_of(snapshot)?, vehicle_of(vehicle)?);
            let found = &mut get_mut(scratch, "a scratch")?.signals_ahead;
            map.signals_ahead(from.into(), distance, vehicle, found)?;
            List { out, capacity, count }.write(found.iter().map(signal_ahead))
        })
    }
}

/// Signals along a route, with distances from its start.
///
/// Errors: as `mapd_signals_ahead`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_signals_along(
    snapshot: *const mapd_snapshot,
    steps: *const mapd_route_step,
    step_count: usize,
    scratch: *mut mapd_scratch,
    out: *mut mapd_signal_ahead,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let mapd_scratch { steps: own, signals_ahead, .. } = get_mut(scratch, "a scratch")?;
            take_steps(steps, step_count, own)?;
            map_of(snapshot)?.signals_along(own, signals_ahead)?;
            List { out, capacity, count }.write(signals_ahead.iter().map(signal_ahead))
        })
    }
}

/// Stop lines, lines to give way at, crosswalks and bicycle crossings along a route, nearest first, whether the file writes them as signals
/// or as objects; one over several lanes stands once for each that is driven on.
///
/// Errors: as `mapd_signals_ahead`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lines_along(
    snapshot: *const mapd_snapshot,
    steps: *const mapd_route_step,
    step_count: usize,
    scratch: *mut mapd_scratch,
    out: *mut mapd_lane_line_at,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let mapd_scratch { steps: own, lines, .. } = get_mut(scratch, "a scratch")?;
            take_steps(steps, step_count, own)?;
            map_of(snapshot)?.lines_along(own, lines)?;
            List { out, capacity, count }.write(lines.iter().map(line_ahead))
        })
    }
}
