//! What a path comes by, how fast it may be driven, and from which lanes its goal is reached.

use crate::code::{answer, mapd_code, mapd_error};
use crate::graph::vehicle_of;
use crate::ids::{MAPD_NO_ROW, mapd_junction_id, mapd_lane_id, mapd_signal_id};
use crate::list::{List, finite, get_mut, put, put_some};
use crate::path::{mapd_path, path_of};
use crate::point::mapd_vec3;
use crate::scratch::mapd_scratch;
use crate::signals::{mapd_speed_rule, speed_rule};
use crate::signals_ahead::{lane_line, mapd_lane_line_at};
use crate::snapshot::{map_of, mapd_snapshot};
use crate::text::mapd_text;
use mapd_client::path::{PathFact, PathFactKind, PathSegment, PathSpeed, PathTime};

/// `kind` of a fact: a junction, from where the path enters it to where it leaves it; `junction`, and in `code` where the movement leads, a `MAPD_TURN_…`.
pub const MAPD_PATH_FACT_JUNCTION: u8 = 0;
/// `kind` of a fact: a signal for the driven lane; `signal`, `governs`.
pub const MAPD_PATH_FACT_SIGNAL: u8 = 1;
/// `kind` of a fact: a stop line, crosswalk or bicycle crossing; `line`, `left`, `right`.
pub const MAPD_PATH_FACT_LINE: u8 = 2;
/// `kind` of a fact: the road's type, where the file gives one; `code` is a `MAPD_ROAD_TYPE_…`.
pub const MAPD_PATH_FACT_ROAD_TYPE: u8 = 3;
/// `kind` of a fact: type of the driven lane; `code` is a `MAPD_LANE_TYPE_…`.
pub const MAPD_PATH_FACT_LANE_TYPE: u8 = 4;
/// `kind` of a fact: a bridge or tunnel; `number` among `mapd_structures`, `code` a `MAPD_STRUCTURE_KIND_…`.
pub const MAPD_PATH_FACT_STRUCTURE: u8 = 5;
/// `kind` of a fact: a part of the document near the path that is left out of the map; `number` among `mapd_quarantined_parts`.
pub const MAPD_PATH_FACT_HOLE: u8 = 6;
/// `kind` of a fact: the country whose rules hold, where the file gives one; `number` for `mapd_country`.
pub const MAPD_PATH_FACT_COUNTRY: u8 = 7;
/// `kind` of a fact: who may use the driven lane in its driven direction; in `number` the bit `1 << MAPD_VEHICLE_CLASS_…` of each class.
pub const MAPD_PATH_FACT_ACCESS: u8 = 8;
/// `kind` of a fact that this release has no word for.
pub const MAPD_PATH_FACT_OTHER: u8 = 255;

/// Something that a path comes by. What the kind does not name is not there: ids with the row `MAPD_NO_ROW`, zeros.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_fact {
    /// S of its beginning \[m\].
    pub along_from: f64,
    /// S of its end \[m\]; that of its beginning for what has a place alone.
    pub along_to: f64,
    /// The driven lane at its beginning.
    pub lane: mapd_lane_id,
    /// The junction.
    pub junction: mapd_junction_id,
    /// The signal.
    pub signal: mapd_signal_id,
    /// The line.
    pub line: mapd_lane_line_at,
    /// Of a line its left end on the driven lane, inertial \[m\].
    pub left: mapd_vec3,
    /// Of a line its right end.
    pub right: mapd_vec3,
    /// What the kind says, such as the number in a list of the map; else `MAPD_NO_ROW`.
    pub number: u32,
    /// What the kind says.
    pub code: u8,
    /// What it is: a `MAPD_PATH_FACT_…`.
    pub kind: u8,
    /// Of a signal, 1: it is for what the path does; a light with arrows is for some of the turns at the next junction only.
    pub governs: u8,
}

/// A stretch of a path on which one speed limit holds.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_speed {
    /// S of its beginning \[m\].
    pub along_from: f64,
    /// S of its end \[m\].
    pub along_to: f64,
    /// What holds there.
    pub rule: mapd_speed_rule,
}

/// How long a path or a part of it takes at the speed limits.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_time {
    /// Time where a limit is known and above 0 \[s\].
    pub time: f64,
    /// Length of the rest, where no limit is known or there is none \[m\]: its time is the caller's to say.
    pub unlimited: f64,
}

/// A lane from which the goal of a path is reached along the path's own roads by allowed changes of lane.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_path_segment {
    /// S of the beginning of the stretch over which this holds \[m\].
    pub along_from: f64,
    /// S of its end \[m\].
    pub along_to: f64,
    /// The lane.
    pub lane: mapd_lane_id,
    /// The largest S at which one can still be on this lane, with the lanes that it leads on to, and come to the goal: the last place for
    /// its next change \[m\]. The path's end where no change is needed.
    pub last_change: f64,
    /// S at which it leads on along the path no more \[m\]; the path's end where it does to the end.
    pub lane_end: f64,
    /// Changes of lane that are left to the goal, at least.
    pub changes: u32,
    /// 1: it is travelled towards +s.
    pub forward: u8,
    /// 1: the path drives on it on this stretch.
    pub driven: u8,
}

/// A fact that is told of nothing yet.
fn bare(fact: &PathFact) -> mapd_path_fact {
    let ([along_from, along_to], nowhere) = (fact.along, mapd_vec3::default());
    mapd_path_fact {
        along_from,
        along_to,
        lane: fact.lane.into(),
        junction: mapd_junction_id::NONE,
        signal: mapd_signal_id::NONE,
        line: mapd_lane_line_at::NONE,
        left: nowhere,
        right: nowhere,
        number: MAPD_NO_ROW,
        code: 0,
        kind: MAPD_PATH_FACT_OTHER,
        governs: 0,
    }
}

impl From<&PathFact> for mapd_path_fact {
    fn from(fact: &PathFact) -> Self {
        let own = bare(fact);
        match fact.kind {
            PathFactKind::Junction { junction, turn } => {
                let (junction, code) = (junction.into(), turn.bit());
                Self { kind: MAPD_PATH_FACT_JUNCTION, junction, code, ..own }
            }
            PathFactKind::Signal { signal, governs } => {
                let (signal, governs) = (signal.into(), governs.into());
                Self { kind: MAPD_PATH_FACT_SIGNAL, signal, governs, ..own }
            }
            PathFactKind::Line { line, ends } => {
                let (line, [left, right]) = (lane_line(line), ends.map(mapd_vec3::from));
                Self { kind: MAPD_PATH_FACT_LINE, line, left, right, ..own }
            }
            PathFactKind::RoadType(kind) => {
                Self { kind: MAPD_PATH_FACT_ROAD_TYPE, code: kind.code(), ..own }
            }
            PathFactKind::LaneType(kind) => {
                Self { kind: MAPD_PATH_FACT_LANE_TYPE, code: kind.code(), ..own }
            }
            PathFactKind::Structure { kind, number } => {
                Self { kind: MAPD_PATH_FACT_STRUCTURE, code: kind.code(), number, ..own }
            }
            PathFactKind::Hole { number } => Self { kind: MAPD_PATH_FACT_HOLE, number, ..own },
            PathFactKind::Country { number } => {
                Self { kind: MAPD_PATH_FACT_COUNTRY, number, ..own }
            }
            PathFactKind::Access { classes } => {
                Self { kind: MAPD_PATH_FACT_ACCESS, number: classes.into(), ..own }
            }
            _ => own,
        }
    }
}

impl From<&PathSpeed> for mapd_path_speed {
    fn from(own: &PathSpeed) -> Self {
        let [along_from, along_to] = own.along;
        Self { along_from, along_to, rule: speed_rule(own.rule) }
    }
}

impl From<&PathSegment> for mapd_path_segment {
    fn from(own: &PathSegment) -> Self {
        let [along_from, along_to] = own.along;
        Self {
            along_from,
            along_to,
            lane: own.lane.into(),
            last_change: own.last_change,
            lane_end: own.lane_end,
            changes: own.changes,
            forward: own.forward.into(),
            driven: own.driven.into(),
        }
    }
}

/// What the path comes by, in ascending S: junctions with the turn, signals, stop lines and crossings, types of roads and lanes, countries, who may use the lane, bridges
/// and tunnels, and holes of the map. What goes on over several lanes stands once. Speed limits are `mapd_path_speeds`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_facts(
    path: *const mapd_path,
    scratch: *mut mapd_scratch,
    out: *mut mapd_path_fact,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let found = &mut get_mut(scratch, "a scratch")?.facts;
            path_of(path)?.facts(found);
            List { out, capacity, count }.write(found.iter().map(Into::into))
        })
    }
}

/// The speed limits along the path, in ascending S without gaps.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_speeds(
    path: *const mapd_path,
    scratch: *mut mapd_scratch,
    out: *mut mapd_path_speed,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let found = &mut get_mut(scratch, "a scratch")?.speeds;
            path_of(path)?.speeds(found);
            List { out, capacity, count }.write(found.iter().map(Into::into))
        })
    }
}

/// How long a vehicle takes from S, `from`, to S, `to` \[m\], at the speed limits. S outside the path is moved to its nearer end.
///
/// Errors: `MAPD_CODE_ARGUMENT` where `from` is more than `to`; `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_travel_time(
    path: *const mapd_path,
    from: f64,
    to: f64,
    out: *mut mapd_path_time,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let part = [finite(from)?, finite(to)?];
            let PathTime { time, unlimited } = path_of(path)?.travel_time(part)?;
            put(out, mapd_path_time { time, unlimited })
        })
    }
}

/// A country of a path's fact, as the file writes it: two or three letters, or a name in older versions. `MAPD_CODE_NONE` for a number that is not one of the
/// map's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_country(
    snapshot: *const mapd_snapshot,
    number: u32,
    out: *mut mapd_text,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put_some(out, map_of(snapshot)?.country(number).map(Into::into))) }
}

/// On every stretch of the path the lanes from which its goal is reached along the same roads, from left to right as the driver sees them. Stretches are
/// in ascending S and cover the path; on each it is the same who may go where. `vehicle` is a `MAPD_VEHICLE_CLASS_…`.
///
/// Errors: `MAPD_CODE_ARGUMENT` for an unknown class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_segments(
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
            let found = &mut get_mut(scratch, "a scratch")?.segments;
            path_of(path)?.segments(vehicle_of(vehicle)?, found);
            List { out, capacity, count }.write(found.iter().map(Into::into))
        })
    }
}
