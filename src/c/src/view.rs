//! A map under what is laid over it, at a moment: closures, temporary limits, warnings.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::graph::vehicle_of;
use crate::ids::{MAPD_NO_ROW, mapd_lane_id, mapd_signal_id};
use crate::lane::mapd_overtaking_rule;
use crate::list::{List, close, finite, get, get_mut, hand_out, put, put_some};
use crate::route::{mapd_route_step, take_steps};
use crate::scratch::mapd_scratch;
use crate::signals::{mapd_speed_rule, speed_rule};
use crate::snapshot::mapd_snapshot;
use crate::text::mapd_text;
use mapd_client::Snapshot;
use mapd_client::view::{OverlayEntry, Restriction, SpeedToday, View};
use mapd_client::vocabulary::VehicleClass;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// A map under its overlay at a moment. It keeps its snapshot; several threads may use it at once.
pub struct mapd_view {
    snapshot: Snapshot,
    at: SystemTime,
}

/// Something that an overlay says.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_overlay_entry {
    /// Its name, which no other entry has.
    pub id: mapd_text,
    /// Who says so; empty where that is not said.
    pub source: mapd_text,
    /// What is said, for people; may be empty.
    pub text: mapd_text,
    /// Of a speed, the limit \[m/s\]; of other kinds negative.
    pub value: f64,
    /// How sure the source is, from 0 to 1.
    pub confidence: f64,
    /// Classes of vehicles that are concerned: the bit of each is `1 << code`, of a `MAPD_VEHICLE_CLASS_…`.
    pub vehicles: u64,
    /// Its place among the overlay's entries, from 0.
    pub number: u32,
    /// What it says: a `MAPD_OVERLAY_KIND_…`.
    pub kind: u8,
    /// 1: it holds at the view's moment.
    pub holds: u8,
}

/// An entry that holds on a stretch of a lane.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_restriction {
    /// The lane; a row of `MAPD_NO_ROW` where there is no restriction.
    pub lane: mapd_lane_id,
    /// Smaller end of the stretch on the road \[m\]: at least the part of it on which the same entries hold.
    pub s_from: f64,
    /// Larger end \[m\].
    pub s_to: f64,
    /// Number of the entry, see `mapd_view_entries`; `MAPD_NO_ROW` where there is no restriction.
    pub entry: u32,
}

/// Whether a class of vehicles may use a lane at a place.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_permission {
    /// The entry that decides so; none where the map does.
    pub restriction: mapd_restriction,
    /// 1: it may.
    pub is_allowed: u8,
}

/// The speed limit at a place, with what is said of it today.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_speed_today {
    /// Limit \[m/s\], infinite where there is none; counts only with `has_max`.
    pub max: f64,
    /// What the map says.
    pub map: mapd_speed_rule,
    /// The entry that says otherwise; none where the map's limit holds.
    pub restriction: mapd_restriction,
    /// 1: somebody says something.
    pub has_max: u8,
}

/// Whether a class of vehicles may overtake at a place, with what is said of it today.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_overtaking_today {
    /// The map's signs.
    pub map: mapd_overtaking_rule,
    /// The first entry that forbids it to the class; none where none does.
    pub restriction: mapd_restriction,
    /// 1: a sign or an entry forbids it to the class. Of signs, those for all count for motor vehicles, those for trucks for `MAPD_VEHICLE_CLASS_TRUCK`.
    pub is_forbidden: u8,
}

impl From<Restriction<'_>> for mapd_restriction {
    fn from(one: Restriction<'_>) -> Self {
        let (lane, entry) = (one.lane.into(), one.entry.number());
        Self { lane, s_from: one.s_from, s_to: one.s_to, entry }
    }
}

impl From<Option<Restriction<'_>>> for mapd_restriction {
    fn from(one: Option<Restriction<'_>>) -> Self {
        let none = Self { lane: mapd_lane_id::NONE, s_from: 0.0, s_to: 0.0, entry: MAPD_NO_ROW };
        one.map_or(none, Self::from)
    }
}

impl From<SpeedToday<'_>> for mapd_speed_today {
    fn from(today: SpeedToday<'_>) -> Self {
        Self {
            max: today.max.unwrap_or(0.0),
            map: speed_rule(today.map),
            restriction: today.restriction.into(),
            has_max: today.max.is_some().into(),
        }
    }
}

fn entry(view: &View<'_>, own: &OverlayEntry<'_>) -> mapd_overlay_entry {
    let concerned = VehicleClass::ALL.iter().filter(|class| own.concerns(**class));
    mapd_overlay_entry {
        id: own.id().into(),
        source: own.source().into(),
        text: own.text().into(),
        value: own.value().unwrap_or(-1.0),
        confidence: own.confidence(),
        vehicles: concerned.fold(0, |all, class| all | 1 << class.code()),
        number: own.number(),
        kind: own.kind().code(),
        holds: view.holds(own).into(),
    }
}

/// A moment in seconds since 1970-01-01 00:00 UTC.
///
/// Errors: no number, or farther away than a clock counts.
fn moment(seconds: f64) -> Result<SystemTime, Failure> {
    let away = Duration::try_from_secs_f64(finite(seconds)?.abs()).ok();
    let at = away.and_then(|away| {
        if seconds < 0.0 { UNIX_EPOCH.checked_sub(away) } else { UNIX_EPOCH.checked_add(away) }
    });
    at.ok_or_else(|| Failure::argument(format!("{seconds} s is no moment that a clock has")))
}

/// The view of a handle.
///
/// # Safety
///
/// As [`get`].
pub(crate) unsafe fn view_of<'a>(view: *const mapd_view) -> Result<View<'a>, Failure> {
    let own = unsafe { get(view, "a view") }?;
    Ok(own.snapshot.view(own.at))
}

/// The snapshot's map under its overlay at a moment, `at_s` \[s\] since 1970-01-01 00:00 UTC; where nothing is laid over it, the map. It is cheap: make one
/// for each cycle. Close it with `mapd_view_close`.
///
/// Errors: `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for a moment that no clock has.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_new(
    snapshot: *const mapd_snapshot,
    at_s: f64,
    out: *mut *mut mapd_view,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let snapshot = get(snapshot, "a snapshot")?.0.clone();
            hand_out(out, mapd_view { snapshot, at: moment(at_s)? })
        })
    }
}

/// Closes a view and sets the handle to null. Null, or a handle that is null, is fine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_close(view: *mut *mut mapd_view) {
    unsafe { close(view) }
}

/// Everything that the overlay says, whether it holds now or not, in the order in which it was given: entry k has the number k.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_entries(
    view: *const mapd_view,
    out: *mut mapd_overlay_entry,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let view = view_of(view)?;
            List { out, capacity, count }.write(view.entries().map(|own| entry(&view, &own)))
        })
    }
}

/// What holds now, wherever it does: each entry once for each piece of a lane, for each way in which that is travelled.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_restrictions(
    view: *const mapd_view,
    out: *mut mapd_restriction,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            List { out, capacity, count }.write(view_of(view)?.restrictions().map(Into::into))
        })
    }
}

/// Entries that hold now at s of a lane, in its direction of travel, for any class of vehicles, in the order of the overlay.
///
/// Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_restrictions_at(
    view: *const mapd_view,
    lane: mapd_lane_id,
    s: f64,
    out: *mut mapd_restriction,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let found = view_of(view)?.restrictions_at(lane.into(), s)?;
            List { out, capacity, count }.write(found.map(Into::into))
        })
    }
}

/// What holds now along a route or any list of steps, in its order: each entry once for each stretch on which it holds that a step drives over. `vehicle` is a
/// `MAPD_VEHICLE_CLASS_…`.
///
/// Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for an unknown class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_restrictions_along(
    view: *const mapd_view,
    steps: *const mapd_route_step,
    step_count: usize,
    vehicle: u8,
    scratch: *mut mapd_scratch,
    out: *mut mapd_restriction,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let own = &mut get_mut(scratch, "a scratch")?.steps;
            take_steps(steps, step_count, own)?;
            // It borrows from the view, so that no scratch can keep it.
            let mut found = Vec::new();
            view_of(view)?.restrictions_along(own, vehicle_of(vehicle)?, &mut found)?;
            List { out, capacity, count }.write(found.into_iter().map(Into::into))
        })
    }
}

/// Whether a class of vehicles may use a lane at s, in its own direction: as `mapd_lane_allows_at`, unless an entry closes or opens it. What one entry
/// closes no other opens.
///
/// Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for an unknown class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_allows(
    view: *const mapd_view,
    lane: mapd_lane_id,
    s: f64,
    vehicle: u8,
    out: *mut mapd_permission,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let found = view_of(view)?.allows(lane.into(), s, vehicle_of(vehicle)?)?;
            let (restriction, is_allowed) = (found.restriction.into(), found.is_allowed.into());
            put(out, mapd_permission { restriction, is_allowed })
        })
    }
}

/// The speed limit at s of a lane for a class of vehicles: the lowest that an entry states, else as `mapd_lane_speed_rule_at`.
///
/// Errors: as `mapd_view_allows`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_speed_rule_at(
    view: *const mapd_view,
    lane: mapd_lane_id,
    s: f64,
    vehicle: u8,
    out: *mut mapd_speed_today,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let found = view_of(view)?.speed_rule_at(lane.into(), s, vehicle_of(vehicle)?)?;
            put(out, found.into())
        })
    }
}

/// Whether a class of vehicles may overtake at s of a lane: what signs forbid, as `mapd_lane_overtaking_rule_at`, and entries.
///
/// Errors: as `mapd_view_allows`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_overtaking_rule_at(
    view: *const mapd_view,
    lane: mapd_lane_id,
    s: f64,
    vehicle: u8,
    out: *mut mapd_overtaking_today,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let found = view_of(view)?.overtaking_rule_at(lane.into(), s, vehicle_of(vehicle)?)?;
            let (map, restriction) = (found.map.into(), found.restriction.into());
            let is_forbidden = found.is_forbidden.into();
            put(out, mapd_overtaking_today { map, restriction, is_forbidden })
        })
    }
}

/// The number of the entry by which a signal is out of service now. `MAPD_CODE_NONE` for one that is in service.
///
/// Errors: `MAPD_CODE_FOREIGN_ID`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_signal_out_of_service(
    view: *const mapd_view,
    signal: mapd_signal_id,
    out: *mut u32,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let found = view_of(view)?.signal_out_of_service(signal.into())?;
            put_some(out, found.map(|entry| entry.number()))
        })
    }
}
