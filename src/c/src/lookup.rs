//! From names and rows to ids and back.

use crate::code::{Failure, Outcome, answer, mapd_code, mapd_error};
use crate::ids::{mapd_junction_id, mapd_lane_id, mapd_object_id, mapd_road_id, mapd_signal_id};
use crate::list::{List, put, put_some};
use crate::snapshot::{map_of, mapd_snapshot};
use crate::text::{copy_out, given, mapd_text};
use mapd_client::{Junction, Lane, LaneKey, Road};
use std::ffi::c_char;

/// A lane of a snapshot.
///
/// # Safety
///
/// As [`map_of`].
#[inline(always)]
pub(crate) unsafe fn lane_of<'a>(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
) -> Result<Lane<'a>, Failure> {
    unsafe { Ok(map_of(snapshot)?.lane(lane.into())?) }
}

/// Asks a lane of a snapshot where it is made: a copy of it would count in a single call.
///
/// # Safety
///
/// As [`map_of`].
#[inline(always)]
pub(crate) unsafe fn ask_lane(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    ask: impl FnOnce(&Lane<'_>) -> Outcome,
) -> Outcome {
    // SAFETY: as promised above.
    match unsafe { map_of(snapshot) }?.lane(lane.into()) {
        Ok(ref lane) => ask(lane),
        Err(error) => Err(error.into()),
    }
}

/// Asks a road of a snapshot where it is made, as [`ask_lane`].
///
/// # Safety
///
/// As [`map_of`].
#[inline(always)]
pub(crate) unsafe fn ask_road(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    ask: impl FnOnce(&Road<'_>) -> Outcome,
) -> Outcome {
    // SAFETY: as promised above.
    match unsafe { map_of(snapshot) }?.road(road.into()) {
        Ok(ref road) => ask(road),
        Err(error) => Err(error.into()),
    }
}

/// A road of a snapshot.
///
/// # Safety
///
/// As [`map_of`].
#[inline(always)]
pub(crate) unsafe fn road_of<'a>(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
) -> Result<Road<'a>, Failure> {
    unsafe { Ok(map_of(snapshot)?.road(road.into())?) }
}

/// A junction of a snapshot.
///
/// # Safety
///
/// As [`map_of`].
pub(crate) unsafe fn junction_of<'a>(
    snapshot: *const mapd_snapshot,
    junction: mapd_junction_id,
) -> Result<Junction<'a>, Failure> {
    unsafe { Ok(map_of(snapshot)?.junction(junction.into())?) }
}

/// The road with OpenDRIVE's id, compared byte by byte. `MAPD_CODE_NONE` if there is none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_by_id(
    snapshot: *const mapd_snapshot,
    id: *const c_char,
    out: *mut mapd_road_id,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let road = map_of(snapshot)?.road_by_id(given(id, "the id")?);
            put_some(out, road.map(|road| road.road_id().into()))
        })
    }
}

/// The junction with OpenDRIVE's id, compared byte by byte. `MAPD_CODE_NONE` if there is none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_junction_by_id(
    snapshot: *const mapd_snapshot,
    id: *const c_char,
    out: *mut mapd_junction_id,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let junction = map_of(snapshot)?.junction_by_id(given(id, "the id")?);
            put_some(out, junction.map(|junction| junction.junction_id().into()))
        })
    }
}

/// A signal with OpenDRIVE's id, compared byte by byte; of several with one id any. `MAPD_CODE_NONE` if there is none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_signal_by_id(
    snapshot: *const mapd_snapshot,
    id: *const c_char,
    out: *mut mapd_signal_id,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let signal = map_of(snapshot)?.signal_by_id(given(id, "the id")?);
            put_some(out, signal.map(|signal| signal.signal_id().into()))
        })
    }
}

/// The object with OpenDRIVE's id, compared byte by byte; of several the first. `MAPD_CODE_NONE` if there is none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_object_by_id(
    snapshot: *const mapd_snapshot,
    id: *const c_char,
    out: *mut mapd_object_id,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let object = map_of(snapshot)?.object_by_id(given(id, "the id")?);
            put_some(out, object.map(|object| object.object_id().into()))
        })
    }
}

/// The lane with a key such as `12:0:-1`; of one in several pieces the first. `MAPD_CODE_NONE` if there is none.
///
/// Errors: `MAPD_CODE_ARGUMENT` for a text that is no key.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_by_key(
    snapshot: *const mapd_snapshot,
    key: *const c_char,
    out: *mut mapd_lane_id,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let map = map_of(snapshot)?;
            let key: LaneKey<'_> = given(key, "the key")?.parse().map_err(
                |error: mapd_client::ParseLaneKeyError| Failure::argument(error.to_string()),
            )?;
            put_some(out, map.lane_by_key(&key).map(|lane| lane.lane_id().into()))
        })
    }
}

/// The lane's stable name, `road:section:lane`, terminated by 0. `length`: without that; may be null. With `MAPD_CODE_TOO_SMALL` the buffer holds
/// the beginning.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_key(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut c_char,
    capacity: usize,
    length: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let key = lane_of(snapshot, lane)?.key().to_string();
            copy_out(&key, out, capacity, length)
        })
    }
}

/// OpenDRIVE's id of a road, verbatim.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_name_id(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    out: *mut mapd_text,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, road_of(snapshot, road)?.id().into())) }
}

/// All roads in file order.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_roads(
    snapshot: *const mapd_snapshot,
    out: *mut mapd_road_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let roads = map_of(snapshot)?.roads().map(|road| road.road_id().into());
            List { out, capacity, count }.write(roads)
        })
    }
}

/// All junctions in file order.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_junctions(
    snapshot: *const mapd_snapshot,
    out: *mut mapd_junction_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = map_of(snapshot)?.junctions().map(|one| one.junction_id().into());
            List { out, capacity, count }.write(all)
        })
    }
}

/// All lanes, those of the number 0 and of the temporary layer left out.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lanes(
    snapshot: *const mapd_snapshot,
    out: *mut mapd_lane_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = map_of(snapshot)?.lanes().map(|one| one.lane_id().into());
            List { out, capacity, count }.write(all)
        })
    }
}

/// All signals in file order, signs on boards behind what carries them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_signals(
    snapshot: *const mapd_snapshot,
    out: *mut mapd_signal_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = map_of(snapshot)?.signals().map(|one| one.signal_id().into());
            List { out, capacity, count }.write(all)
        })
    }
}

/// All objects: those of roads in the order of the roads, then those of junctions.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_objects(
    snapshot: *const mapd_snapshot,
    out: *mut mapd_object_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = map_of(snapshot)?.objects().map(|one| one.object_id().into());
            List { out, capacity, count }.write(all)
        })
    }
}
