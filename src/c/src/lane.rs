//! Lanes: facts, places on them, neighbours, successors.

use crate::code::{answer, mapd_code, mapd_error};
use crate::ids::{mapd_junction_id, mapd_lane_id, mapd_road_id, mapd_signal_id};
use crate::list::{List, finite, put, put_answer, put_some};
use crate::lookup::{ask_lane, lane_of};
use crate::point::{clamped_code, mapd_lane_position, mapd_point, mapd_pose, mapd_vec3};
use crate::snapshot::mapd_snapshot;
use mapd_client::roads::Waypoint;
use mapd_client::rules::OvertakingRule;
use mapd_client::{Lane, QueryError};

/// Which signs forbid overtaking at a place.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_overtaking_rule {
    /// The sign that forbids it to all motor vehicles, if one does.
    pub all: mapd_signal_id,
    /// The sign that forbids it to trucks, if one does.
    pub trucks: mapd_signal_id,
}

impl From<OvertakingRule> for mapd_overtaking_rule {
    fn from(rule: OvertakingRule) -> Self {
        Self { all: rule.all.into(), trucks: rule.trucks.into() }
    }
}

/// A lane.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_lane_facts {
    /// The lane itself.
    pub lane: mapd_lane_id,
    /// Its road.
    pub road: mapd_road_id,
    /// The junction that its road is a connecting road of, if any.
    pub junction: mapd_junction_id,
    /// Start of its section on the road \[m\].
    pub s_start: f64,
    /// End of its section on the road \[m\].
    pub s_end: f64,
    /// OpenDRIVE's lane number: positive left of lane 0, negative right.
    pub number: i32,
    /// Number of its section in the road, from 0.
    pub section: u32,
    /// Its type: a `MAPD_LANE_TYPE_…`.
    pub kind: u8,
    /// 1: motor vehicles travel on lanes of this type.
    pub is_drivable: u8,
    /// 1: vehicles travel towards +s. Left, right and ahead of a lane are those of this direction.
    pub is_forward: u8,
    /// 1: it may be travelled in both directions.
    pub is_bidirectional: u8,
    /// 1: it is of the temporary layer.
    pub is_temporary: u8,
    /// 1: it is the same as its namesake in the section before.
    pub continues: u8,
}

/// Both edges of a lane at s, as lateral coordinates \[m\].
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_lane_edges {
    /// t of the edge nearer to lane 0.
    pub inner: f64,
    /// t of the edge away from lane 0.
    pub outer: f64,
}

/// Both edges of a lane at s, inertial \[m\], on the plane h = 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_lane_bounds {
    /// On the left of the lane's traffic.
    pub left: mapd_vec3,
    /// On the right of the lane's traffic.
    pub right: mapd_vec3,
}

/// A place on a lane's centre line.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_waypoint {
    /// On the road's reference line \[m\].
    pub s: f64,
    /// Inertial position on the plane h = 0 \[m\].
    pub position: mapd_vec3,
    /// Heading of the centre line in driving direction \[rad\], in (−π, π].
    pub heading: f64,
    /// Width of the lane \[m\].
    pub width: f64,
    /// Whether s lay outside the lane's section and was moved to its nearer end.
    pub clamped: u8,
}

/// `side` of `mapd_lane_beside`: to the left of the lane's traffic, whichever way that lane is travelled itself.
pub const MAPD_BESIDE_LEFT: u32 = 0;
/// `side` of `mapd_lane_beside`: to the right of the lane's traffic.
pub const MAPD_BESIDE_RIGHT: u32 = 1;
/// `side` of `mapd_lane_beside`: towards lane 0, lane 0 included.
pub const MAPD_BESIDE_INNER: u32 = 2;
/// `side` of `mapd_lane_beside`: the nearest one that is travelled the other way.
pub const MAPD_BESIDE_OPPOSITE: u32 = 3;
/// `side` of `mapd_lane_beside`: to the left of the reference line's direction; lane 0 is skipped.
pub const MAPD_BESIDE_LEFT_OF_REFERENCE_LINE: u32 = 4;
/// `side` of `mapd_lane_beside`: to the right of the reference line's direction; lane 0 is skipped.
pub const MAPD_BESIDE_RIGHT_OF_REFERENCE_LINE: u32 = 5;

fn facts(lane: &Lane<'_>) -> mapd_lane_facts {
    let (section, road) = (lane.section(), lane.road());
    mapd_lane_facts {
        lane: lane.lane_id().into(),
        road: road.road_id().into(),
        junction: road.junction().map(|junction| junction.junction_id()).into(),
        s_start: section.s_start(),
        s_end: section.s_end(),
        number: lane.number(),
        section: section.number(),
        kind: lane.kind().code(),
        is_drivable: lane.kind().is_drivable().into(),
        is_forward: lane.is_forward().into(),
        is_bidirectional: lane.is_bidirectional().into(),
        is_temporary: lane.is_temporary().into(),
        continues: lane.continues().into(),
    }
}

impl From<Waypoint> for mapd_waypoint {
    fn from(w: Waypoint) -> Self {
        let Waypoint { s, position, heading, width, clamped } = w;
        Self { s, position: position.into(), heading, width, clamped: clamped_code(clamped) }
    }
}

/// What a lane is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_facts_of(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut mapd_lane_facts,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, facts(&lane_of(snapshot, lane)?))) }
}

/// A point in the lane's coordinates: exact foot on the reference line within the lane's section, distance from the lane's area.
///
/// Errors: `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_CORRUPT` for lane 0, which has no area.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_position_of(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    point: mapd_point,
    out: *mut mapd_lane_position,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, move || {
            ask_lane(snapshot, lane, move |lane| put_answer(out, lane.position_of(point)))
        })
    }
}

/// Pose at s as the lane's traffic has it, `offset` \[m\] to its left of the lane's centre, on the plane h = 0. Heading and curvature are those of the
/// line that keeps this offset, in driving direction; slope and superelevation are the road's. s outside the lane's section is moved to its nearer end and flagged.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_pose_at(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    offset: f64,
    out: *mut mapd_pose,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, move || {
            ask_lane(snapshot, lane, move |lane| put_answer(out, lane.pose_at(s, offset)))
        })
    }
}

/// As `mapd_lane_pose_at`, in the road's frame: heading and curvature are those of the reference line, ahead is the way s rises, and `offset` counts to the left of that.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_pose_of_reference_line(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    offset: f64,
    out: *mut mapd_pose,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, move || {
            ask_lane(snapshot, lane, move |lane| {
                put_answer(out, lane.pose_of_reference_line(s, offset))
            })
        })
    }
}

/// The centre line's exact place at s, with its own direction: that of `mapd_lane_pose_at` at offset 0. s outside the lane's section is moved to its nearer end and flagged.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_waypoint_at(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    out: *mut mapd_waypoint,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, move || {
            ask_lane(snapshot, lane, move |lane| put_answer(out, lane.waypoint_at(s)))
        })
    }
}

/// Waypoints in driving direction, `step` \[m\] of s apart, from where the lane is entered to where it is left; both ends are among them.
///
/// Errors: `MAPD_CODE_NOT_FINITE` for a step that is not a positive finite number; `MAPD_CODE_ARGUMENT` for one that gives more than a million.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_waypoints(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    step: f64,
    out: *mut mapd_waypoint,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = lane_of(snapshot, lane)?.waypoints(step)?;
            List { out, capacity, count }.write_counted(all.map(|one| one.map(Into::into)))
        })
    }
}

/// Both edges at s, as lateral coordinates. s outside the lane's section counts as its nearer end.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_edges_at(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    out: *mut mapd_lane_edges,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let edges = lane_of(snapshot, lane)?.edges_at(finite(s)?);
            put(out, mapd_lane_edges { inner: edges.inner, outer: edges.outer })
        })
    }
}

/// Both edges at s, inertial. s outside the lane's section counts as its nearer end.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_bounds_at(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    out: *mut mapd_lane_bounds,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let bounds = lane_of(snapshot, lane)?.bounds_at(finite(s)?);
            let [left, right] = bounds.ok_or(QueryError::Corrupt)?;
            put(out, mapd_lane_bounds { left: left.into(), right: right.into() })
        })
    }
}

/// Width at s \[m\], never negative. s outside the lane's section counts as its nearer end.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_width_at(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    out: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, lane_of(snapshot, lane)?.width_at(finite(s)?))) }
}

/// The speed limit that is recorded at s \[m/s\]: in the lane's own record, else in that of the road's type; infinite where the file says `no limit`. What holds may be
/// another: `mapd_lane_speed_rule_at`. `MAPD_CODE_NONE` where the file says nothing or states a limit that cannot be read.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_recorded_speed_limit_at(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    out: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            put_some(out, lane_of(snapshot, lane)?.recorded_speed_limit_at(finite(s)?))
        })
    }
}

/// Length of the centre line in plan view between two places on the road \[m\]. s outside the lane's section counts as its nearer end.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_length_between(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    a: f64,
    b: f64,
    out: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || put(out, lane_of(snapshot, lane)?.length_between(finite(a)?, finite(b)?)))
    }
}

/// What a route by time counts for the centre line between two places on the road \[s\]: its length at `mapd_lane_recorded_speed_limit_at`, at 50 km/h where no limit is recorded,
/// at 130 km/h where there is none. The time at the limits of a way is `mapd_path_travel_time`. s outside the lane's section counts as its nearer end.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_time_between(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    a: f64,
    b: f64,
    out: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || put(out, lane_of(snapshot, lane)?.time_between(finite(a)?, finite(b)?)))
    }
}

/// Which signs forbid overtaking at s. A sign holds from its place on, in driving direction, until another one ends it, over lanes that lead on alone, and
/// not beyond a junction. What road marks forbid is `change_left` and `change_right` of `mapd_node_facts`.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_overtaking_rule_at(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    out: *mut mapd_overtaking_rule,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || put(out, lane_of(snapshot, lane)?.overtaking_rule_at(finite(s)?).into()))
    }
}

/// The lane beside this one; `side` is a `MAPD_BESIDE_…`. `MAPD_CODE_NONE` if there is none. One that shares the direction and may be
/// changed to is `change_left` or `change_right` of `mapd_node_facts`.
///
/// Errors: `MAPD_CODE_ARGUMENT` for an unknown side.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_beside(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    side: u32,
    out: *mut mapd_lane_id,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let lane = lane_of(snapshot, lane)?;
            let beside = match side {
                MAPD_BESIDE_LEFT => lane.left(),
                MAPD_BESIDE_RIGHT => lane.right(),
                MAPD_BESIDE_INNER => lane.inner(),
                MAPD_BESIDE_OPPOSITE => lane.opposite(),
                MAPD_BESIDE_LEFT_OF_REFERENCE_LINE => lane.left_of_reference_line(),
                MAPD_BESIDE_RIGHT_OF_REFERENCE_LINE => lane.right_of_reference_line(),
                _ => return Err(crate::code::Failure::argument(format!("{side} is no side"))),
            };
            put_some(out, beside.map(|lane| lane.lane_id().into()))
        })
    }
}

/// Lanes entered from this one in its own driving direction, in order of road id, section and lane.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_successors(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut mapd_lane_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = lane_of(snapshot, lane)?.successors().map(mapd_lane_id::from);
            List { out, capacity, count }.write(all)
        })
    }
}

/// Lanes from which this one is entered in its own driving direction, in order of road id, section and lane.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_predecessors(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut mapd_lane_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = lane_of(snapshot, lane)?.predecessors().map(mapd_lane_id::from);
            List { out, capacity, count }.write(all)
        })
    }
}
