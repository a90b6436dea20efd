//! Which lanes a vehicle may be in, by a pose or by a trace.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::graph::vehicle_of;
use crate::ids::mapd_lane_id;
use crate::list::{List, entries, fill, get_mut, put_raw};
use crate::options::{given_options, put_defaults};
use crate::point::{mapd_lane_position, mapd_point};
use crate::scratch::mapd_scratch;
use crate::snapshot::{map_of, mapd_snapshot};
use mapd_client::glam::DMat3;
use mapd_client::localisation::{
    LaneMatch, MatchError, MatchOptions, TraceFix, TraceMatch, TraceOptions, VehicleOutline,
    VehiclePose,
};
use mapd_client::{LaneId, LaneTypes};

/// What somebody measured: where a vehicle is and which way it heads.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_vehicle_pose {
    /// Place, inertial \[m\]; z only if known.
    pub position: mapd_point,
    /// Heading \[rad\], counter-clockwise from x; any turn of it.
    pub heading: f64,
}

/// Plan view of a vehicle: a rectangle around the place of its pose, along its heading. Each size is in \[0, 100\].
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_vehicle_outline {
    /// How far it reaches from the pose's place ahead \[m\].
    pub front: f64,
    /// How far behind it \[m\].
    pub back: f64,
    /// How far to the left \[m\].
    pub left: f64,
    /// How far to the right \[m\].
    pub right: f64,
}

/// How hypotheses are weighed. Set it with `mapd_match_options_init`, then change what should differ.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_match_options {
    /// Size of this struct as the caller knows it: later releases may append to it.
    pub size: usize,
    /// Lane types that are hypotheses, as in `mapd_nearest_options`. Default all.
    pub types: u64,
    /// Largest difference between the pose's z and the lane's \[m\]; counts only with `has_z_tolerance` and a pose that has z.
    pub z_tolerance: f64,
    /// Standard deviation of a driver's heading from the lane's direction \[rad\], not negative. Default 0.1.
    pub drive_deviation: f64,
    /// Prior of `none`, where a lane has 1; positive. Default 0.01.
    pub none: f64,
    /// Share of the prior that lanes have which the vehicle may not use, in (0, 1\]. Default 0.05.
    pub closed: f64,
    /// Share of the prior that lanes have which are not expected, in (0, 1\]. Default 0.05.
    pub unexpected: f64,
    /// Lanes that are expected, such as those of a route. Default null, which expects nothing.
    pub expected: *const mapd_lane_id,
    /// How many there are.
    pub expected_count: usize,
    /// Not 0: `z_tolerance` counts. Default 0.
    pub has_z_tolerance: u8,
    /// Not 0: `vehicle` counts. Default 0.
    pub has_vehicle: u8,
    /// The class of the vehicle: a `MAPD_VEHICLE_CLASS_…`.
    pub vehicle: u8,
    /// Plan view of the vehicle: a lane's weight is then the share of the vehicle that lies in it. Default zeros, which count as no outline.
    pub outline: mapd_vehicle_outline,
}

/// A lane that a vehicle may be in, in one of its directions.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_lane_match {
    /// The lane.
    pub lane: mapd_lane_id,
    /// The pose's place with respect to it.
    pub position: mapd_lane_position,
    /// Probability among all hypotheses.
    pub probability: f64,
    /// Mahalanobis distance of the pose from the lane's centre line at the pose's s, headed as that line is driven.
    pub mahalanobis: f64,
    /// The given heading less the driving direction at the pose's s and offset \[rad\], in (−π, π].
    pub heading_difference: f64,
    /// 1: the vehicle travels towards +s.
    pub forward: u8,
}

/// A place of a trace.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_trace_fix {
    /// When \[s\]; does not fall along the trace.
    pub time: f64,
    /// Where, inertial \[m\].
    pub position: mapd_point,
    /// Which way it heads \[rad\]; counts only with `has_heading`.
    pub heading: f64,
    /// Not 0: the heading is known.
    pub has_heading: u8,
}

/// How a trace is matched. Set it with `mapd_trace_options_init`, then change what should differ.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_trace_options {
    /// Size of this struct as the caller knows it: later releases may append to it.
    pub size: usize,
    /// Standard deviation of x and of y \[m\], positive. Default 1.
    pub deviation: f64,
    /// Standard deviation of headings \[rad\], of fixes that have one. Default 0.1.
    pub heading_deviation: f64,
    /// Mean time between changes of lane \[s\], positive. Default 30.
    pub change_interval: f64,
    /// Lane types that count, as in `mapd_nearest_options`. Default those that motor vehicles travel on.
    pub types: u64,
    /// The class of the vehicle: a `MAPD_VEHICLE_CLASS_…`. Default a passenger car.
    pub vehicle: u8,
}

/// Where a fix of a trace was.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_trace_match {
    /// The lane; a row of `MAPD_NO_ROW` where the trace is on no lane.
    pub lane: mapd_lane_id,
    /// The place with respect to it; zeros where there is none.
    pub position: mapd_lane_position,
    /// Probability of this, given the whole trace.
    pub probability: f64,
    /// 1: it travels towards +s.
    pub forward: u8,
}

impl From<MatchError> for Failure {
    #[cold]
    fn from(error: MatchError) -> Self {
        let code = match error {
            MatchError::Query(error) => return error.into(),
            MatchError::Pose(_) | MatchError::NotFinite(..) | MatchError::Fix(_) => {
                mapd_code::NOT_FINITE
            }
            _ => mapd_code::ARGUMENT,
        };
        Self::new(code, error.to_string())
    }
}

impl From<mapd_vehicle_pose> for VehiclePose {
    fn from(pose: mapd_vehicle_pose) -> Self {
        Self { position: pose.position.into(), heading: pose.heading }
    }
}

impl From<mapd_vehicle_outline> for VehicleOutline {
    fn from(outline: mapd_vehicle_outline) -> Self {
        let mapd_vehicle_outline { front, back, left, right } = outline;
        Self { front, back, left, right }
    }
}

impl From<mapd_trace_fix> for TraceFix {
    fn from(fix: mapd_trace_fix) -> Self {
        let mapd_trace_fix { time, position, heading, has_heading } = fix;
        let heading = (has_heading != 0).then_some(heading);
        Self { time, position: position.into(), heading }
    }
}

impl From<&LaneMatch> for mapd_lane_match {
    fn from(found: &LaneMatch) -> Self {
        Self {
            lane: found.lane.into(),
            position: found.position.into(),
            probability: found.probability,
            mahalanobis: found.mahalanobis,
            heading_difference: found.heading_difference,
            forward: found.forward.into(),
        }
    }
}

impl From<&TraceMatch> for mapd_trace_match {
    fn from(found: &TraceMatch) -> Self {
        let position = found.place.map(|place| place.position.into());
        Self {
            lane: found.place.map(|place| place.lane).into(),
            position: position.unwrap_or(mapd_lane_position::NOWHERE),
            probability: found.probability,
            forward: found.forward.into(),
        }
    }
}

/// The options of a caller's; null is the default. Expected lanes go into `lanes`.
///
/// # Safety
///
/// As [`given_options`]; `expected` is valid for reads of `expected_count` entries.
pub(crate) unsafe fn match_options(
    options: *const mapd_match_options,
    lanes: &mut Vec<LaneId>,
) -> Result<MatchOptions<'_>, Failure> {
    lanes.clear();
    let Some(given) = (unsafe { given_options(options, "mapd_match_options_init") })? else {
        return Ok(MatchOptions::default());
    };
    // SAFETY: as promised above.
    let expected = unsafe { entries(given.expected, given.expected_count, "the expected lanes") }?;
    lanes.extend(expected.iter().map(|lane| LaneId::from(*lane)));
    Ok(MatchOptions {
        types: LaneTypes::from_bits(given.types),
        z_tolerance: (given.has_z_tolerance != 0).then_some(given.z_tolerance),
        drive_deviation: given.drive_deviation,
        none: given.none,
        vehicle: if given.has_vehicle != 0 { Some(vehicle_of(given.vehicle)?) } else { None },
        closed: given.closed,
        expected: lanes,
        unexpected: given.unexpected,
        outline: Some(given.outline.into()),
    })
}

/// Sets options to their defaults. `size` is `sizeof(mapd_match_options)`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_match_options_init(
    options: *mut mapd_match_options,
    size: usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let MatchOptions { types, drive_deviation, none, closed, unexpected, .. } =
                MatchOptions::default();
            let defaults = mapd_match_options {
                size,
                types: types.bits(),
                z_tolerance: 0.0,
                drive_deviation,
                none,
                closed,
                unexpected,
                expected: std::ptr::null(),
                expected_count: 0,
                has_z_tolerance: 0,
                has_vehicle: 0,
                vehicle: 0,
                outline: mapd_vehicle_outline { front: 0.0, back: 0.0, left: 0.0, right: 0.0 },
            };
            put_defaults(options, size, defaults)
        })
    }
}

/// Sets options to their defaults. `size` is `sizeof(mapd_trace_options)`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_trace_options_init(
    options: *mut mapd_trace_options,
    size: usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let TraceOptions { deviation, heading_deviation, vehicle, change_interval, types } =
                TraceOptions::default();
            let defaults = mapd_trace_options {
                size,
                deviation,
                heading_deviation,
                change_interval,
                types: types.bits(),
                vehicle: vehicle.code(),
            };
            put_defaults(options, size, defaults)
        })
    }
}

/// The lanes that a vehicle may be in by a measured pose, the most probable first. `covariance` has nine entries, row by row: that of
/// (x, y, heading) in \[m²\], \[m·rad\] and \[rad²\]; a heading that is not known has a large one. `options`: null is the default. `none`: the
/// probability that it is in no lane; null is fine. docs/localisation.md has the model.
///
/// Errors: `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for a covariance that is not symmetric and positive semi-definite, and for
/// options out of their domain.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_match_pose(
    snapshot: *const mapd_snapshot,
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
            let left =
                map_of(snapshot)?.match_pose(&pose.into(), &covariance, &options, matches)?;
            put_raw(none, left)?;
            List { out, capacity, count }.write(matches.iter().map(mapd_lane_match::from))
        })
    }
}

/// As `mapd_match_pose`, of `pose_count` poses. There is one covariance of nine entries for all of them, or one for each. `out` gets the lanes of all
/// poses one behind the other; `ends` and `none` have room for an entry for each pose: where its lanes end in `out`, and the probability that it is
/// in none. Null for either is fine.
///
/// Errors: as `mapd_match_pose`, by the number of the first pose that has one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_match_pose_batch(
    snapshot: *const mapd_snapshot,
    poses: *const mapd_vehicle_pose,
    pose_count: usize,
    covariances: *const f64,
    covariance_count: usize,
    options: *const mapd_match_options,
    scratch: *mut mapd_scratch,
    out: *mut mapd_lane_match,
    capacity: usize,
    count: *mut usize,
    ends: *mut usize,
    none: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let mapd_scratch {
                lanes, poses: own, covariances: matrices, batch, batch_matches, ..
            } = get_mut(scratch, "a scratch")?;
            let options = match_options(options, lanes)?;
            let numbers = covariance_count.checked_mul(9);
            let numbers = numbers.ok_or_else(|| Failure::argument("no memory holds so many"))?;
            let numbers = entries(covariances, numbers, "the covariances")?;
            own.clear();
            own.extend(
                entries(poses, pose_count, "the poses")?.iter().map(|p| VehiclePose::from(*p)),
            );
            matrices.clear();
            let nine = numbers.chunks_exact(9).map(|rows| DMat3::from_cols_slice(rows).transpose());
            matrices.extend(nine);
            map_of(snapshot)?
                .match_poses(own, matrices, &options, batch, batch_matches)
                .map_err(|error| Failure::from(error.source).of_entry(error.pose))?;
            let found = &*batch_matches;
            if !ends.is_null() {
                let (mut end, mut pose) = (0, 0..);
                fill(ends, own, |_| {
                    end += pose.next().map_or(0, |pose| found.of(pose).len());
                    Ok::<_, Failure>(end)
                })?;
            }
            if !none.is_null() {
                let mut all = found.none().iter();
                fill(none, own, |_| Ok::<_, Failure>(all.next().copied().unwrap_or(0.0)))?;
            }
            let all = (0..own.len()).flat_map(|i| found.of(i)).map(mapd_lane_match::from);
            List { out, capacity, count }.write(all)
        })
    }
}

/// The lanes of a trace: the most probable way through all its fixes. `out` has room for `count` answers, one for each fix. `options`: null
/// is the default.
///
/// Errors: `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for times that fall and for options out of their domain.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_match_trace(
    snapshot: *const mapd_snapshot,
    fixes: *const mapd_trace_fix,
    count: usize,
    options: *const mapd_trace_options,
    scratch: *mut mapd_scratch,
    out: *mut mapd_trace_match,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let mapd_scratch { trace, fixes: own, traced, .. } = get_mut(scratch, "a scratch")?;
            let options = match given_options(options, "mapd_trace_options_init")? {
                None => TraceOptions::default(),
                Some(given) => TraceOptions {
                    deviation: given.deviation,
                    heading_deviation: given.heading_deviation,
                    vehicle: vehicle_of(given.vehicle)?,
                    change_interval: given.change_interval,
                    types: LaneTypes::from_bits(given.types),
                },
            };
            own.clear();
            own.extend(entries(fixes, count, "the fixes")?.iter().map(|f| TraceFix::from(*f)));
            map_of(snapshot)?.match_trace(own, &options, trace, traced)?;
            let mut written = 0;
            List { out, capacity: count, count: &mut written }
                .write(traced.iter().map(mapd_trace_match::from))
        })
    }
}
