//! What is laid over a map along a path: entries, today's limits and times, from which lanes the goal is reached.

use crate::code::{answer, mapd_code, mapd_error};
use crate::conflicts::{
    mapd_conflict_lane, mapd_path_conflict, mapd_path_crossing, write_conflicts,
};
use crate::graph::vehicle_of;
use crate::list::{List, finite, get_mut, put, put_answer};
use crate::path::{mapd_path, path_of};
use crate::path_facts::{mapd_path_fact, mapd_path_segment, mapd_path_time};
use crate::scratch::mapd_scratch;
use crate::view::{mapd_restriction, mapd_speed_today, mapd_view, view_of};
use mapd_client::path::PathTime;
use mapd_client::view::{PathRestriction, PathSpeedToday};

/// An entry that holds on a stretch of a path.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_restriction {
    /// S of the beginning of what is driven of it \[m\].
    pub along_from: f64,
    /// S of its end \[m\].
    pub along_to: f64,
    /// The entry, on the lane that is driven there.
    pub restriction: mapd_restriction,
}

/// A stretch of a path on which one speed limit holds today.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_speed_today {
    /// S of its beginning \[m\].
    pub along_from: f64,
    /// S of its end \[m\].
    pub along_to: f64,
    /// What holds there. Where an entry states it, the stretch is on one lane.
    pub today: mapd_speed_today,
}

impl From<&PathRestriction<'_>> for mapd_path_restriction {
    fn from(one: &PathRestriction<'_>) -> Self {
        let [along_from, along_to] = one.along;
        Self { along_from, along_to, restriction: one.restriction.into() }
    }
}

impl From<&PathSpeedToday<'_>> for mapd_path_speed_today {
    fn from(one: &PathSpeedToday<'_>) -> Self {
        let [along_from, along_to] = one.along;
        Self { along_from, along_to, today: one.today.into() }
    }
}

/// What holds now for a class of vehicles along a path, in ascending S: each entry once for each stretch of a driven lane. The path itself is the map's: a
/// lane that is closed stays where it is.
///
/// Errors: `MAPD_CODE_FOREIGN_ID` for a path on another map; `MAPD_CODE_ARGUMENT` for an unknown class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_restrictions_on_path(
    view: *const mapd_view,
    path: *const mapd_path,
    vehicle: u8,
    out: *mut mapd_path_restriction,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (view, path, mut found) = (view_of(view)?, path_of(path)?, Vec::new());
            view.restrictions_on_path(&path, vehicle_of(vehicle)?, &mut found)?;
            List { out, capacity, count }.write(found.iter().map(Into::into))
        })
    }
}

/// The speed limit at S of a path, `along` \[m\], for a class of vehicles: the lowest that an entry states, else as `mapd_path_speed_at`.
///
/// Errors: as `mapd_view_allows`; `MAPD_CODE_FOREIGN_ID` for a path on another map.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_speed_on_path(
    view: *const mapd_view,
    path: *const mapd_path,
    along: f64,
    vehicle: u8,
    out: *mut mapd_speed_today,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (view, path) = (view_of(view)?, path_of(path)?);
            put_answer(out, view.speed_on_path(&path, along, vehicle_of(vehicle)?))
        })
    }
}

/// The speed limits along a path for a class of vehicles, in ascending S without gaps, each place as `mapd_view_speed_on_path` has it. `vehicle` is a
/// `MAPD_VEHICLE_CLASS_…`.
///
/// Errors: `MAPD_CODE_FOREIGN_ID` for a path on another map; `MAPD_CODE_ARGUMENT` for an unknown class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_speeds_on_path(
    view: *const mapd_view,
    path: *const mapd_path,
    vehicle: u8,
    out: *mut mapd_path_speed_today,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            // It borrows from the view, so that no scratch can keep it.
            let (view, path, mut found) = (view_of(view)?, path_of(path)?, Vec::new());
            view.speeds_on_path(&path, vehicle_of(vehicle)?, &mut found)?;
            List { out, capacity, count }.write(found.iter().map(Into::into))
        })
    }
}

/// As `mapd_path_travel_time` for a class of vehicles, at the limits of `mapd_view_speeds_on_path`. What is closed takes as long as if it were open:
/// `mapd_view_restrictions_on_path` tells of it.
///
/// Errors: as `mapd_path_travel_time`; `MAPD_CODE_FOREIGN_ID` for a path on another map; `MAPD_CODE_ARGUMENT` for an unknown class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_travel_time_on_path(
    view: *const mapd_view,
    path: *const mapd_path,
    from: f64,
    to: f64,
    vehicle: u8,
    out: *mut mapd_path_time,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (view, path, vehicle) = (view_of(view)?, path_of(path)?, vehicle_of(vehicle)?);
            let part = [finite(from)?, finite(to)?];
            let PathTime { time, unlimited } = view.travel_time_on_path(&path, part, vehicle)?;
            put(out, mapd_path_time { time, unlimited })
        })
    }
}

/// As `mapd_path_segments`, with the overlay's current entries applied: a lane that is closed is not entered, so that before it a change of lane is due; one that is
/// opened may be.
///
/// Errors: `MAPD_CODE_FOREIGN_ID` for a path on another map; `MAPD_CODE_ARGUMENT` for an unknown class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_segments_on_path(
    view: *const mapd_view,
    path: *const mapd_path,
    vehicle: u8,
    scratch: *mut mapd_scratch,
    out: *mut mapd_path_segment,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (view, path, vehicle) = (view_of(view)?, path_of(path)?, vehicle_of(vehicle)?);
            let found = &mut get_mut(scratch, "a scratch")?.segments;
            view.segments_on_path(&path, vehicle, found)?;
            List { out, capacity, count }.write(found.iter().map(Into::into))
        })
    }
}

/// As `mapd_path_conflicts`, with lights that are out of service now left out: where they would decide, signs do, then priorities of the file, then rules of the road.
///
/// Errors: as `mapd_path_conflicts`; `MAPD_CODE_FOREIGN_ID` for a path on another map.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_conflicts(
    view: *const mapd_view,
    path: *const mapd_path,
    scratch: *mut mapd_scratch,
    out: *mut mapd_path_conflict,
    capacity: usize,
    count: *mut usize,
    lanes: *mut mapd_conflict_lane,
    lane_capacity: usize,
    lane_count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (view, path) = (view_of(view)?, path_of(path)?);
            let mapd_scratch { conflicts, conflict_lanes, .. } = get_mut(scratch, "a scratch")?;
            view.conflicts(&path, conflicts, conflict_lanes)?;
            let own = List { out, capacity, count };
            let of_lanes = List { out: lanes, capacity: lane_capacity, count: lane_count };
            write_conflicts(conflicts, conflict_lanes, own, of_lanes)
        })
    }
}

/// As `mapd_path_crossings`, with lights that are out of service now left out.
///
/// Errors: `MAPD_CODE_FOREIGN_ID` for a path on another map.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_crossings(
    view: *const mapd_view,
    path: *const mapd_path,
    scratch: *mut mapd_scratch,
    out: *mut mapd_path_crossing,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (view, path) = (view_of(view)?, path_of(path)?);
            let found = &mut get_mut(scratch, "a scratch")?.crossings;
            view.crossings(&path, found)?;
            List { out, capacity, count }.write(found.iter().map(Into::into))
        })
    }
}

/// As `mapd_path_facts`, with today's permissions; a light that is out of service now governs nothing.
///
/// Errors: `MAPD_CODE_FOREIGN_ID` for a path on another map.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_facts(
    view: *const mapd_view,
    path: *const mapd_path,
    scratch: *mut mapd_scratch,
    out: *mut mapd_path_fact,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (view, path) = (view_of(view)?, path_of(path)?);
            let found = &mut get_mut(scratch, "a scratch")?.facts;
            view.facts(&path, found)?;
            List { out, capacity, count }.write(found.iter().map(Into::into))
        })
    }
}
