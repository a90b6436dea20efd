//! Lanes near a place.

use crate::code::{Failure, Outcome, answer, mapd_code, mapd_error};
use crate::graph::vehicle_of;
use crate::ids::mapd_lane_id;
use crate::list::{List, entries, fill, get, get_mut, put, put_found};
use crate::options::{given_options, put_defaults};
use crate::point::{mapd_lane_position, mapd_point, mapd_region};
use crate::scratch::mapd_scratch;
use crate::snapshot::{map_of, mapd_snapshot};
use mapd_client::batch::Places;
use mapd_client::{LaneTypes, Map, Nearest, NearestOptions, QueryError};

/// The nearest lane and the point in its coordinates.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_nearest {
    /// The lane; of a point of a batch that has none, a row of `MAPD_NO_ROW`.
    pub lane: mapd_lane_id,
    /// The point's place with respect to it.
    pub position: mapd_lane_position,
}

/// What counts as a match. Set it with `mapd_nearest_options_init`, then change what should differ.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_nearest_options {
    /// Size of this struct as the caller knows it: later releases may append to it.
    pub size: usize,
    /// Largest plan-view distance from the lane's area \[m\]. Default 10.
    pub radius: f64,
    /// Lane types that count: the bit of each is `1 << code`; `UINT64_MAX`, the default, is all. See `mapd_lane_types_drivable` and `mapd_lane_types_routable`.
    pub types: u64,
    /// Largest difference between the point's z and the lane's \[m\]; counts only with `has_z_tolerance` and a point that has z.
    pub z_tolerance: f64,
    /// Heading of travel \[rad\]; counts only with `has_heading`. Breaks ties, and excludes places by `heading_tolerance`.
    pub heading: f64,
    /// Largest difference between `heading` and the lane's driving direction \[rad\]; counts only with `has_heading_tolerance`.
    pub heading_tolerance: f64,
    /// Not 0: `z_tolerance` counts. Default 0.
    pub has_z_tolerance: u8,
    /// Not 0: `heading` counts. Default 0.
    pub has_heading: u8,
    /// Not 0: `heading_tolerance` counts. Default 0.
    pub has_heading_tolerance: u8,
    /// Not 0: `vehicle` counts. Default 0.
    pub has_vehicle: u8,
    /// Only places that this class of vehicles may use count, in either direction: a `MAPD_VEHICLE_CLASS_…`.
    pub vehicle: u8,
    /// The answer for a point nearby, such as the one before on a trajectory: it makes the search cheaper and never changes its answer.
    /// Default null.
    pub hint: *const mapd_nearest,
}

impl From<Nearest> for mapd_nearest {
    #[inline]
    fn from(nearest: Nearest) -> Self {
        Self { lane: nearest.lane.into(), position: nearest.position.into() }
    }
}

impl From<mapd_nearest> for Nearest {
    fn from(nearest: mapd_nearest) -> Self {
        Self { lane: nearest.lane.into(), position: nearest.position.into() }
    }
}

/// The options of a caller's; null is the default.
///
/// # Safety
///
/// As [`given_options`]; so is its `hint`.
#[inline(always)]
pub(crate) unsafe fn options_of(
    options: *const mapd_nearest_options,
) -> Result<NearestOptions, Failure> {
    let mut own = NearestOptions::default();
    // SAFETY: as promised above.
    unsafe { set_options(&mut own, options) }?;
    Ok(own)
}

/// As [`options_of`], in place: a hundred bytes that are copied count in a single call.
///
/// # Safety
///
/// As [`options_of`].
#[inline(always)]
unsafe fn set_options(
    own: &mut NearestOptions,
    options: *const mapd_nearest_options,
) -> Result<(), Failure> {
    if let Some(given) = unsafe { given_options(options, "mapd_nearest_options_init") }? {
        own.radius = given.radius;
        own.types = LaneTypes::from_bits(given.types);
        let flags = [
            given.has_z_tolerance,
            given.has_heading,
            given.has_heading_tolerance,
            given.has_vehicle,
        ];
        if flags != [0; 4] || !given.hint.is_null() {
            // SAFETY: as promised above.
            unsafe { set_further(own, given) }?;
        }
    }
    Ok(())
}

/// Sets the options that most callers leave as they are: out of the way, so that those who do pay nothing for them.
///
/// # Safety
///
/// The `hint` is null or valid for reads.
#[inline(never)]
unsafe fn set_further(
    own: &mut NearestOptions,
    given: &mapd_nearest_options,
) -> Result<(), Failure> {
    own.z_tolerance = (given.has_z_tolerance != 0).then_some(given.z_tolerance);
    own.heading = (given.has_heading != 0).then_some(given.heading);
    own.heading_tolerance = (given.has_heading_tolerance != 0).then_some(given.heading_tolerance);
    if given.has_vehicle != 0 {
        own.vehicle = Some(vehicle_of(given.vehicle)?);
    }
    if !given.hint.is_null() {
        // SAFETY: as promised above.
        own.hint = Some(Nearest::from(*unsafe { get(given.hint, "hint") }?));
    }
    Ok(())
}

/// Sets options to their defaults. `size` is `sizeof(mapd_nearest_options)`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_nearest_options_init(
    options: *mut mapd_nearest_options,
    size: usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let NearestOptions { radius, types, .. } = NearestOptions::default();
            let defaults = mapd_nearest_options {
                size,
                radius,
                types: types.bits(),
                z_tolerance: 0.0,
                heading: 0.0,
                heading_tolerance: 0.0,
                has_z_tolerance: 0,
                has_heading: 0,
                has_heading_tolerance: 0,
                has_vehicle: 0,
                vehicle: 0,
                hint: std::ptr::null(),
            };
            put_defaults(options, size, defaults)
        })
    }
}

/// Bits of the lane types that are built for motor vehicles, whoever may use them.
#[unsafe(no_mangle)]
pub extern "C" fn mapd_lane_types_drivable() -> u64 {
    LaneTypes::drivable().bits()
}

/// Bits of the lane types that routes lead over: those that the lane graph opens to motor vehicles where no access record says otherwise.
#[unsafe(no_mangle)]
pub extern "C" fn mapd_lane_types_routable() -> u64 {
    LaneTypes::routable().bits()
}

/// The lane whose area is nearest to a point in plan view, within the options' radius; distance 0 inside. Ties go by heading difference, z
/// difference, lanes without width last, |offset|, then key. `options`: null is the default. `MAPD_CODE_NONE` if nothing is near enough.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_nearest_lane(
    snapshot: *const mapd_snapshot,
    point: mapd_point,
    options: *const mapd_nearest_options,
    out: *mut mapd_nearest,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let map = map_of(snapshot)?;
            let mut own = NearestOptions::default();
            set_options(&mut own, options)?;
            put_found(out, map.nearest_lane(point, &own))
        })
    }
}

/// As `mapd_nearest_lane`, of `count` points; `out` has room for as many answers. What has none gets a lane with the row `MAPD_NO_ROW`
/// and a position of zeros. Points near each other, in whatever order, cost a fraction of single calls.
///
/// Errors: as `mapd_nearest_lane`, with the number of the point; what `out` holds then has no meaning.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_nearest_lane_batch(
    snapshot: *const mapd_snapshot,
    points: *const mapd_point,
    count: usize,
    options: *const mapd_nearest_options,
    scratch: *mut mapd_scratch,
    out: *mut mapd_nearest,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (map, options) = (map_of(snapshot)?, options_of(options)?);
            let points = entries(points, count, "the points")?;
            let scratch = get_mut(scratch, "a scratch")?;
            batch(map, points, options, scratch, out)
        })
    }
}

unsafe fn batch(
    map: Map<'_>,
    points: &[mapd_point],
    mut options: NearestOptions,
    scratch: &mut mapd_scratch,
    out: *mut mapd_nearest,
) -> Outcome {
    let none = mapd_nearest { lane: mapd_lane_id::NONE, position: mapd_lane_position::NOWHERE };
    let with_z = points.iter().filter(|point| point.has_z != 0).count();
    if with_z != 0 && with_z != points.len() {
        // Columns have a z for all points or for none.
        let ask = |point: &mapd_point| {
            map.nearest_lane(*point, &options).map(|found| {
                options.hint = found.or(options.hint);
                found.map_or(none, mapd_nearest::from)
            })
        };
        return unsafe { fill(out, points, ask) };
    }
    let mapd_scratch { columns: [x, y, z], batch, nearest_lanes, .. } = scratch;
    let coordinates: [fn(&mapd_point) -> f64; 3] =
        [|point| point.x, |point| point.y, |point| point.z];
    for (column, coordinate) in [&mut *x, y, z].into_iter().zip(coordinates) {
        column.clear();
        column.extend(points.iter().map(coordinate));
    }
    let places = Places { x, y, z: (with_z > 0).then_some(z), heading: None };
    map.nearest_lanes(places, &options, batch, nearest_lanes)?;
    let mut numbers = 0..points.len();
    let answer = |_: &mapd_point| {
        let found = numbers.next().and_then(|number| nearest_lanes.get(number));
        Ok::<_, QueryError>(found.map_or(none, mapd_nearest::from))
    };
    unsafe { fill(out, points, answer) }
}

/// Every lane whose area lies within the options' radius of a point, nearest first, each once.
///
/// Errors: as `mapd_nearest_lane`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lanes_near(
    snapshot: *const mapd_snapshot,
    point: mapd_point,
    options: *const mapd_nearest_options,
    scratch: *mut mapd_scratch,
    out: *mut mapd_nearest,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let near = &mut get_mut(scratch, "a scratch")?.near;
            map_of(snapshot)?.lanes_near(point, &options_of(options)?, near)?;
            List { out, capacity, count }.write(near.iter().map(|one| (*one).into()))
        })
    }
}

/// Whether a point lies on a lane, edges included, in plan view: 1 or 0. A point with z only on one within `z_tolerance` \[m\], where
/// that is not negative.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_covers(
    snapshot: *const mapd_snapshot,
    point: mapd_point,
    z_tolerance: f64,
    out: *mut u8,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let tolerance = if z_tolerance < 0.0 { None } else { Some(z_tolerance) };
            put(out, map_of(snapshot)?.covers(point, tolerance)?.into())
        })
    }
}

/// Every lane of these types whose area meets a rectangle in plan view, in the order of their rows.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lanes_in(
    snapshot: *const mapd_snapshot,
    region: mapd_region,
    types: u64,
    scratch: *mut mapd_scratch,
    out: *mut mapd_lane_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let lanes = &mut get_mut(scratch, "a scratch")?.lanes;
            map_of(snapshot)?.lanes_in(region.into(), LaneTypes::from_bits(types), lanes)?;
            List { out, capacity, count }.write(lanes.iter().map(|one| (*one).into()))
        })
    }
}
