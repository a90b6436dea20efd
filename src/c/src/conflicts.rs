//! Who meets a path: other lanes' traffic, where it comes from, and who crosses on foot.

use crate::code::{Failure, Outcome, answer, mapd_code, mapd_error};
use crate::graph::vehicle_of;
use crate::ids::mapd_lane_id;
use crate::list::{List, entries, get_mut, put_raw};
use crate::movement::{basis_code, rules_of};
use crate::path::{mapd_path, path_of};
use crate::scratch::mapd_scratch;
use crate::signals_ahead::{lane_line, mapd_lane_line_at};
use crate::snapshot::{map_of, mapd_snapshot};
use mapd_client::path::{
    ConflictApproach, ConflictLane, PathConflict, PathCrossing, Yields, YieldsBy,
};
use mapd_client::vocabulary::{ConflictKind, Relation, RelationReason};
use std::ffi::c_char;

/// `yields` of a conflict: the vehicle on the path gives way.
pub const MAPD_YIELDS_YIELDS: u8 = 0;
/// `yields` of a conflict: the other gives way.
pub const MAPD_YIELDS_PRIORITY: u8 = 1;
/// `yields` of a conflict: lights decide.
pub const MAPD_YIELDS_LIGHTS: u8 = 2;
/// `yields` of a conflict: the file does not say. A rule of the road may; the reason names it.
pub const MAPD_YIELDS_UNKNOWN: u8 = 3;

/// A place where the traffic of other lanes meets a path: of one lane, or of several that lead into each other.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_conflict {
    /// S of the first common place \[m\], as of `mapd_conflict_lane`.
    pub along_from: f64,
    /// S of the last common place \[m\].
    pub along_to: f64,
    /// The other lane, of several the one that meets the path first.
    pub other: mapd_lane_id,
    /// The smaller s of the common place on its road \[m\].
    pub other_s_from: f64,
    /// The larger s of the common place on its road \[m\].
    pub other_s_to: f64,
    /// S at which to wait \[m\]: the earliest of its lanes.
    pub wait: f64,
    /// Number of its first lane in the list of lanes.
    pub lanes_from: u32,
    /// Number of the one behind its last lane.
    pub lanes_to: u32,
    /// How they meet, a `MAPD_CONFLICT_KIND_…`: merging where one lane merges, else crossing where one crosses.
    pub kind: u8,
    /// Who goes first, by what the file says, a `MAPD_YIELDS_…`: `MAPD_YIELDS_YIELDS` where the path yields to one lane, else `MAPD_YIELDS_UNKNOWN` where the file does not
    /// say of one, else `MAPD_YIELDS_LIGHTS` where they decide about one.
    pub yields: u8,
    /// Why, a `MAPD_RELATION_REASON_…`: of the first lane of which that is said.
    pub reason: u8,
}

/// A lane whose traffic meets a path.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_conflict_lane {
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
    /// Who goes first in the map's own terms, a `MAPD_RELATION_…`: as `yields`, and where a rule of the road would have to say, what right-before-left
    /// and the rule of turns say.
    pub relation: u8,
    /// 1: both come by equal roads, as far as the file says (of one type, with one speed limit, and no motorway), and neither joins a road on which the
    /// other goes straight on, as a ramp does.
    pub equal_roads: u8,
}

/// A lane, or a piece of one, on which traffic comes towards a conflict.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_conflict_approach {
    /// The lane.
    pub lane: mapd_lane_id,
    /// s on its road where the part within the distance begins, in driving direction \[m\].
    pub s_from: f64,
    /// s where it ends \[m\].
    pub s_to: f64,
    /// Distance of its beginning from the conflict's first place along the centre lines \[m\].
    pub distance_from: f64,
    /// Distance of its end \[m\].
    pub distance_to: f64,
    /// 1: it is travelled towards +s.
    pub forward: u8,
}

/// A crosswalk or bicycle crossing over a path.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_crossing {
    /// S of its first place \[m\].
    pub along_from: f64,
    /// S of its last place \[m\]; that of the first one where the file gives a place alone.
    pub along_to: f64,
    /// S at which to wait \[m\]: the last line to stop at on the path, up to 30 m before, else where it begins.
    pub wait: f64,
    /// The crossing, on the driven lane.
    pub line: mapd_lane_line_at,
    /// `MAPD_YIELDS_LIGHTS` where a light for vehicles stands on the path up to 30 m before it, else `MAPD_YIELDS_UNKNOWN`: a rule of the road decides,
    /// nearly everywhere in favour of who crosses.
    pub yields: u8,
}

fn yields_code(yields: Yields) -> u8 {
    match yields {
        Yields::Yields => MAPD_YIELDS_YIELDS,
        Yields::Priority => MAPD_YIELDS_PRIORITY,
        Yields::Lights => MAPD_YIELDS_LIGHTS,
        _ => MAPD_YIELDS_UNKNOWN,
    }
}

impl From<&PathConflict> for mapd_path_conflict {
    fn from(one: &PathConflict) -> Self {
        let ([along_from, along_to], [other_s_from, other_s_to]) = (one.along, one.other_s);
        let [lanes_from, lanes_to] = one.lanes;
        Self {
            along_from,
            along_to,
            other: one.other.into(),
            other_s_from,
            other_s_to,
            wait: one.wait,
            lanes_from,
            lanes_to,
            kind: one.kind.code(),
            yields: yields_code(one.yields),
            reason: one.reason.code(),
        }
    }
}

impl From<&ConflictLane> for mapd_conflict_lane {
    fn from(one: &ConflictLane) -> Self {
        let ([along_from, along_to], [other_s_from, other_s_to]) = (one.along, one.other_s);
        Self {
            along_from,
            along_to,
            other: one.other.into(),
            other_s_from,
            other_s_to,
            wait: one.wait,
            kind: one.kind.code(),
            yields: yields_code(one.yields),
            reason: one.reason.code(),
            relation: one.relation.code(),
            equal_roads: one.equal_roads.into(),
        }
    }
}

impl From<&mapd_conflict_lane> for ConflictLane {
    fn from(one: &mapd_conflict_lane) -> Self {
        Self {
            along: [one.along_from, one.along_to],
            other: one.other.into(),
            other_s: [one.other_s_from, one.other_s_to],
            kind: ConflictKind::from_code(one.kind),
            yields: yields_of(one.yields),
            reason: RelationReason::from_code(one.reason),
            relation: Relation::from_code(one.relation),
            equal_roads: one.equal_roads != 0,
            wait: one.wait,
        }
    }
}

fn yields_of(code: u8) -> Yields {
    match code {
        MAPD_YIELDS_YIELDS => Yields::Yields,
        MAPD_YIELDS_PRIORITY => Yields::Priority,
        MAPD_YIELDS_LIGHTS => Yields::Lights,
        _ => Yields::Unknown,
    }
}

impl From<&ConflictApproach> for mapd_conflict_approach {
    fn from(own: &ConflictApproach) -> Self {
        let ([s_from, s_to], [distance_from, distance_to]) = (own.s, own.distance);
        let (lane, forward) = (own.lane.into(), own.forward.into());
        Self { lane, s_from, s_to, distance_from, distance_to, forward }
    }
}

impl From<&PathCrossing> for mapd_path_crossing {
    fn from(one: &PathCrossing) -> Self {
        let [along_from, along_to] = one.along;
        let (line, yields) = (lane_line(one.line), yields_code(one.yields));
        Self { along_from, along_to, wait: one.wait, line, yields }
    }
}

/// Where other traffic meets the path, in ascending S: on lanes of junctions and others that the map knows to conflict, where lanes merge into
/// one, and on roads that lie at the same place. What the path itself drives just before or behind is left out. Lanes that lead into each other are one conflict where what
/// they have in common with the path touches; `lanes` gets all lanes, those of a conflict behind each other, and `lane_count` their number.
///
/// Errors: `MAPD_CODE_TOO_SMALL` where either list is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_conflicts(
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
            let mapd_scratch { conflicts, conflict_lanes, .. } = get_mut(scratch, "a scratch")?;
            path_of(path)?.conflicts(conflicts, conflict_lanes);
            let own = List { out, capacity, count };
            let of_lanes = List { out: lanes, capacity: lane_capacity, count: lane_count };
            write_conflicts(conflicts, conflict_lanes, own, of_lanes)
        })
    }
}

/// Writes conflicts and their lanes.
///
/// # Safety
///
/// As [`List::write`], of both.
pub(crate) unsafe fn write_conflicts(
    conflicts: &[PathConflict],
    lanes: &[ConflictLane],
    own: List<mapd_path_conflict>,
    of_lanes: List<mapd_conflict_lane>,
) -> Outcome {
    // SAFETY: as promised above.
    let fits = unsafe { of_lanes.write(lanes.iter().map(Into::into)) }?;
    // SAFETY: as promised above.
    let written = unsafe { own.write(conflicts.iter().map(Into::into)) }?;
    Ok(if written == mapd_code::OK { fits } else { written })
}

/// Who goes first at a conflict by what the file says, else by the rules of a country, by its two letters of ISO 3166-1 such as `DE`. That they hold
/// there is for the caller to know. `lanes` are those of the conflict, from its `lanes_from` to its `lanes_to`: who yields to one yields. `yields` gets a `MAPD_YIELDS_…`, `basis` what that rests on, a `MAPD_BASIS_…`; null is fine. `MAPD_CODE_NONE`
/// for a country whose rules are not known.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_conflict_yields_by(
    lanes: *const mapd_conflict_lane,
    lane_count: usize,
    country: *const c_char,
    yields: *mut u8,
    basis: *mut u8,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let lanes = entries(lanes, lane_count, "the conflict's lanes")?;
            let Some(rules) = rules_of(country)? else { return Ok(mapd_code::NONE) };
            let found = YieldsBy::of(lanes.iter().map(Into::into), rules);
            put_raw(yields, yields_code(found.yields))?;
            put_raw(basis, basis_code(found.basis))?;
            Ok(mapd_code::OK)
        })
    }
}

/// The lanes on which traffic comes to a conflict of a path, back to a distance \[m\] from its first place on the other lanes, each by the shortest way,
/// nearest first. `lanes` are those of the conflict, from its `lanes_from` to its `lanes_to`; those come first that none of the others leads to. Changes of lane are not among
/// the ways. `vehicle`, a `MAPD_VEHICLE_CLASS_…`, is the class of who comes, not of who drives the path: lanes that are closed to it bring none, the other lanes neither.
///
/// Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for an unknown class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_conflict_approaches(
    snapshot: *const mapd_snapshot,
    lanes: *const mapd_conflict_lane,
    lane_count: usize,
    distance: f64,
    vehicle: u8,
    scratch: *mut mapd_scratch,
    out: *mut mapd_conflict_approach,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (map, vehicle) = (map_of(snapshot)?, vehicle_of(vehicle)?);
            let given = entries(lanes, lane_count, "the conflict's lanes")?;
            if !given.iter().all(|own| own.other_s_from.is_finite() && own.other_s_to.is_finite()) {
                return Err(Failure::from(mapd_client::QueryError::NotFinite));
            }
            let mapd_scratch { approaches, conflict_lanes, .. } = get_mut(scratch, "a scratch")?;
            conflict_lanes.clear();
            conflict_lanes.extend(given.iter().map(ConflictLane::from));
            map.approaches(conflict_lanes, distance, vehicle, approaches)?;
            List { out, capacity, count }.write(approaches.iter().map(Into::into))
        })
    }
}

/// Crosswalks and bicycle crossings over the path, in ascending S, whether the file writes them as signals or as objects.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_crossings(
    path: *const mapd_path,
    scratch: *mut mapd_scratch,
    out: *mut mapd_path_crossing,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let found = &mut get_mut(scratch, "a scratch")?.crossings;
            path_of(path)?.crossings(found);
            List { out, capacity, count }.write(found.iter().map(Into::into))
        })
    }
}
