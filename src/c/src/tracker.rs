//! The lane of a vehicle that drives, from fix to fix.

use crate::code::{answer, mapd_code, mapd_error};
use crate::ids::mapd_lane_id;
use crate::list::{List, close, entries, get, get_mut, hand_out, put, put_answer};
use crate::matching::{mapd_lane_match, mapd_match_options, mapd_vehicle_pose, match_options};
use crate::options::{given_options, put_defaults};
use crate::point::mapd_lane_position;
use crate::snapshot::{map_of, mapd_snapshot};
use mapd_client::LaneId;
use mapd_client::glam::DMat3;
use mapd_client::localisation::{LaneMatch, Tracked, Tracker, TrackerFix, TrackerOptions};

/// A running filter over poses. All its memory is taken when it is made. It belongs to one thread at a time and to no map.
pub struct mapd_tracker {
    tracker: Tracker,
    expected: Vec<LaneId>,
}

/// What is known of a vehicle at a moment.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_tracker_fix {
    /// When \[s\]; does not fall from fix to fix.
    pub time: f64,
    /// Where it is measured to be.
    pub pose: mapd_vehicle_pose,
    /// Covariance of (x, y, heading), row by row \[m², m·rad, rad²\], as for `mapd_match_pose`.
    pub covariance: [f64; 9],
    /// Way driven since any beginning \[m\]; it falls while a vehicle reverses. Counts only with `has_odometer`; else the straight way from the last
    /// fix counts.
    pub odometer: f64,
    /// Not 0: `odometer` counts.
    pub has_odometer: u8,
}

/// How a running drive is matched. Set it with `mapd_tracker_options_init`, then change what should differ.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_tracker_options {
    /// Size of this struct as the caller knows it: later releases may append to it.
    pub size: usize,
    /// How fixes are weighed. The priors of lanes (`vehicle`, `expected`) weigh the lanes of the first fix, and then the ways at forks. Default null:
    /// the default of `mapd_match_options` with the types that motor vehicles travel on.
    pub matching: *const mapd_match_options,
    /// Mean time between changes of lane \[s\], positive. Default 30.
    pub change_interval: f64,
    /// Time over which errors of fixes are alike \[s\], not negative: fixes nearer to each other count for less. Default 0.
    pub correlation_time: f64,
    /// Time without a fix \[s\], after which the tracker begins anew; positive. Default 30.
    pub memory: f64,
    /// Probability from which a lane, or none, is the answer; in (0, 1\]. Default 0.5.
    pub enough: f64,
}

/// `state` of a tracked vehicle: it is in the lane.
pub const MAPD_TRACKED_LANE: u8 = 0;
/// `state` of a tracked vehicle: it is in no lane, or across them.
pub const MAPD_TRACKED_NO_LANE: u8 = 1;
/// `state` of a tracked vehicle: unknown.
pub const MAPD_TRACKED_UNKNOWN: u8 = 2;

/// Where a tracked vehicle is.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_tracked {
    /// The lane, of `MAPD_TRACKED_LANE`; else one with the row `MAPD_NO_ROW`, and zeros.
    pub found: mapd_lane_match,
    /// A `MAPD_TRACKED_…`.
    pub state: u8,
}

/// What stands where there is no lane.
const NO_MATCH: mapd_lane_match = mapd_lane_match {
    lane: mapd_lane_id::NONE,
    position: mapd_lane_position::NOWHERE,
    probability: 0.0,
    mahalanobis: 0.0,
    heading_difference: 0.0,
    forward: 0,
};

impl From<&mapd_tracker_fix> for TrackerFix {
    fn from(fix: &mapd_tracker_fix) -> Self {
        Self {
            time: fix.time,
            pose: fix.pose.into(),
            covariance: DMat3::from_cols_array(&fix.covariance).transpose(),
            odometer: (fix.has_odometer != 0).then_some(fix.odometer),
        }
    }
}

impl From<Tracked> for mapd_tracked {
    fn from(tracked: Tracked) -> Self {
        match tracked {
            Tracked::Lane(found) => Self { found: (&found).into(), state: MAPD_TRACKED_LANE },
            Tracked::NoLane => Self { found: NO_MATCH, state: MAPD_TRACKED_NO_LANE },
            Tracked::Unknown => Self { found: NO_MATCH, state: MAPD_TRACKED_UNKNOWN },
        }
    }
}

/// Makes a tracker that has seen nothing. Close it with `mapd_tracker_close`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_tracker_new(
    out: *mut *mut mapd_tracker,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            hand_out(out, mapd_tracker { tracker: Tracker::new(), expected: Vec::new() })
        })
    }
}

/// Closes a tracker and sets the handle to null. Null, or a handle that is null, is fine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_tracker_close(tracker: *mut *mut mapd_tracker) {
    unsafe { close(tracker) }
}

/// Sets options to their defaults. `size` is `sizeof(mapd_tracker_options)`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_tracker_options_init(
    options: *mut mapd_tracker_options,
    size: usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let TrackerOptions { change_interval, correlation_time, memory, enough, .. } =
                TrackerOptions::default();
            let defaults = mapd_tracker_options {
                size,
                matching: std::ptr::null(),
                change_interval,
                correlation_time,
                memory,
                enough,
            };
            put_defaults(options, size, defaults)
        })
    }
}

/// Takes the next fix. The first one, one after `memory` without any, and the first on a map of other content begin anew. `options`: null is the default.
///
/// Errors: `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for a covariance that is not symmetric and positive semi-definite, a time before that of the
/// last fix, and options out of their domain. The tracker stays as it was.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_tracker_update(
    tracker: *mut mapd_tracker,
    snapshot: *const mapd_snapshot,
    fix: *const mapd_tracker_fix,
    options: *const mapd_tracker_options,
    out: *mut mapd_tracked,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            get(out, "the answer")?;
            let mapd_tracker { tracker, expected } = get_mut(tracker, "a tracker")?;
            let fix = TrackerFix::from(get(fix, "a fix")?);
            let defaults = TrackerOptions::default();
            let options = match given_options(options, "mapd_tracker_options_init")? {
                None => defaults,
                Some(given) => TrackerOptions {
                    matching: if given.matching.is_null() {
                        defaults.matching
                    } else {
                        match_options(given.matching, expected)?
                    },
                    change_interval: given.change_interval,
                    correlation_time: given.correlation_time,
                    memory: given.memory,
                    enough: given.enough,
                },
            };
            put_answer(out, tracker.update(map_of(snapshot)?, &fix, &options))
        })
    }
}

/// The lanes that the vehicle may be in, the most probable one first; at most 32. `none`: the probability that it is in none, or across them; null is
/// fine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_tracker_hypotheses(
    tracker: *const mapd_tracker,
    out: *mut mapd_lane_match,
    capacity: usize,
    count: *mut usize,
    none: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let tracker = &get(tracker, "a tracker")?.tracker;
            crate::list::put_raw(none, tracker.none())?;
            let all = tracker.hypotheses().iter().map(|one: &LaneMatch| one.into());
            List { out, capacity, count }.write(all)
        })
    }
}

/// Probability that the vehicle is in one of these lanes, such as those of its route: when it has left them, this falls.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_tracker_probability_in(
    tracker: *mut mapd_tracker,
    lanes: *const mapd_lane_id,
    lane_count: usize,
    out: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let mapd_tracker { tracker, expected: own } = get_mut(tracker, "a tracker")?;
            own.clear();
            own.extend(entries(lanes, lane_count, "the lanes")?.iter().map(|l| LaneId::from(*l)));
            put(out, tracker.probability_in(own))
        })
    }
}

/// Has the tracker forget everything.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_tracker_reset(
    tracker: *mut mapd_tracker,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            get_mut(tracker, "a tracker")?.tracker.reset();
            Ok(mapd_code::OK)
        })
    }
}
