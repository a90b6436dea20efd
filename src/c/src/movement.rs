//! Movements through junctions and who goes first.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::ids::{mapd_lane_id, mapd_signal_id};
use crate::list::{List, put, put_some};
use crate::lookup::lane_of;
use crate::signals::{lane_signal, mapd_lane_signal};
use crate::signals_ahead::{lane_line, mapd_lane_line_at};
use crate::snapshot::{map_of, mapd_snapshot};
use crate::text::given;
use mapd_client::rules::{Basis, RightOfWay, Turn};
use mapd_client::vocabulary::{Relation, RoadRules};
use std::ffi::c_char;

/// `turn` of a movement: to the left.
pub const MAPD_TURN_LEFT: u8 = 1;
/// `turn` of a movement: straight on.
pub const MAPD_TURN_STRAIGHT: u8 = 2;
/// `turn` of a movement: to the right.
pub const MAPD_TURN_RIGHT: u8 = 4;
/// `turn` of a movement: back.
pub const MAPD_TURN_BACK: u8 = 8;

/// `basis` of a right of way: the file says so, by signs, lights or `junction/priority`.
pub const MAPD_BASIS_WRITTEN: u8 = 0;
/// `basis` of a right of way: a rule of the road says so, of a country that the caller names.
pub const MAPD_BASIS_RULE: u8 = 1;
/// `basis` of a right of way: nothing decides.
pub const MAPD_BASIS_UNKNOWN: u8 = 2;

/// Who goes first where a lane of a junction meets another.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct mapd_right_of_way {
    /// The other lane.
    pub other: mapd_lane_id,
    /// Who goes first: a `MAPD_RELATION_…`.
    pub relation: u8,
    /// Why: a `MAPD_RELATION_REASON_…`; where nothing is written, which rule of the road would have to say.
    pub reason: u8,
    /// What that rests on: a `MAPD_BASIS_…`.
    pub basis: u8,
}

/// `which` of `mapd_lane_lines`: lines at which the lane's traffic stops or gives way.
pub const MAPD_LANE_LINES_TO_STOP_AT: u32 = 0;
/// `which` of `mapd_lane_lines`: crosswalks and bicycle crossings over the lane.
pub const MAPD_LANE_LINES_CROSSINGS: u32 = 1;
/// `which` of `mapd_lane_lines`: crosswalks and bicycle crossings that the movement through this lane of a junction passes.
pub const MAPD_LANE_LINES_MOVEMENT_CROSSINGS: u32 = 2;

fn right_of_way(one: &RightOfWay<'_>) -> mapd_right_of_way {
    mapd_right_of_way {
        other: one.other().map(|lane| lane.lane_id()).into(),
        relation: one.relation().code(),
        reason: one.reason().code(),
        basis: basis_code(one.basis()),
    }
}

/// `MAPD_BASIS_…`.
pub(crate) fn basis_code(basis: Basis) -> u8 {
    match basis {
        Basis::Written => MAPD_BASIS_WRITTEN,
        Basis::Rule => MAPD_BASIS_RULE,
        _ => MAPD_BASIS_UNKNOWN,
    }
}

/// A country's rules of the road, if they are known.
///
/// # Safety
///
/// As [`given`].
pub(crate) unsafe fn rules_of(
    country: *const c_char,
) -> Result<Option<&'static RoadRules>, Failure> {
    unsafe { Ok(RoadRules::of(given(country, "the country")?)) }
}

/// Where the movement through this lane of a junction leads: a `MAPD_TURN_…`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_turn(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut u8,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let turn = match lane_of(snapshot, lane)?.turn() {
                Turn::Left => MAPD_TURN_LEFT,
                Turn::Straight => MAPD_TURN_STRAIGHT,
                Turn::Right => MAPD_TURN_RIGHT,
                Turn::Back => MAPD_TURN_BACK,
            };
            put(out, turn)
        })
    }
}

/// Lanes from which the junction is entered on the way through this one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_entries(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut mapd_lane_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = lane_of(snapshot, lane)?.entries().map(|one| one.lane_id().into());
            List { out, capacity, count }.write(all)
        })
    }
}

/// Lanes of the junction that the movement through this one goes over, first to last; itself where it is in no junction.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_movement_lanes(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut mapd_lane_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = lane_of(snapshot, lane)?.movement_lanes().map(|one| one.lane_id().into());
            List { out, capacity, count }.write(all)
        })
    }
}

/// Lights that govern the movement through this lane of a junction.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_movement_lights(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut mapd_lane_signal,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let lane = lane_of(snapshot, lane)?;
            let all = lane.movement_lights().map(|one| lane_signal(&one));
            List { out, capacity, count }.write(all)
        })
    }
}

/// Where the movement through this lane of a junction stops: at the marked line nearest to the junction, up to 30 m before it or on the movement's
/// first lane; without one at its light. `MAPD_CODE_NONE` where neither is known.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_movement_stop(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut mapd_lane_line_at,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || put_some(out, lane_of(snapshot, lane)?.movement_stop().map(lane_line)))
    }
}

/// Lines on a lane, or that its movement passes; `which` is a `MAPD_LANE_LINES_…`.
///
/// Errors: `MAPD_CODE_ARGUMENT` for an unknown `which`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_lines(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    which: u32,
    out: *mut mapd_lane_line_at,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (lane, list) = (lane_of(snapshot, lane)?, List { out, capacity, count });
            match which {
                MAPD_LANE_LINES_TO_STOP_AT => list.write(lane.lines_to_stop_at().map(lane_line)),
                MAPD_LANE_LINES_CROSSINGS => list.write(lane.crossings().map(lane_line)),
                MAPD_LANE_LINES_MOVEMENT_CROSSINGS => {
                    list.write(lane.movement_crossings().map(lane_line))
                }
                _ => Err(Failure::argument(format!("{which} names no lines of a lane"))),
            }
        })
    }
}

/// Who goes first where this lane of a junction meets others, by what the file says: unknown where a rule of the road would have to say.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_right_of_way(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut mapd_right_of_way,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = lane_of(snapshot, lane)?.right_of_way().map(|one| right_of_way(&one));
            List { out, capacity, count }.write(all)
        })
    }
}

/// As `mapd_lane_right_of_way` by what the file says, else by the rules of a country, by its two letters of ISO 3166-1 such as `DE`: that they hold there is
/// for the caller to know. Where neither says, the relation is unknown. `MAPD_CODE_NONE` for a country whose rules are not known.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_right_of_way_by(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    country: *const c_char,
    out: *mut mapd_right_of_way,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let lane = lane_of(snapshot, lane)?;
            let Some(rules) = rules_of(country)? else { return Ok(mapd_code::NONE) };
            let of = |one: RightOfWay<'_>| mapd_right_of_way {
                relation: one.relation_by(rules).unwrap_or(Relation::Unknown).code(),
                basis: basis_code(one.basis_by(rules)),
                ..right_of_way(&one)
            };
            List { out, capacity, count }.write(lane.right_of_way().map(of))
        })
    }
}

/// First lanes of the movements through junctions that a light governs; none of what is no light. Looks at all places of signals of the map.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_signal_movements(
    snapshot: *const mapd_snapshot,
    signal: mapd_signal_id,
    out: *mut mapd_lane_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = map_of(snapshot)?.signal(signal.into())?.movements();
            List { out, capacity, count }.write(all.map(|one| one.lane_id().into()))
        })
    }
}
