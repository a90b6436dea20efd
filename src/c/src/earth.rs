//! Places on Earth.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::list::{close, entries, fill, get, hand_out, put_answer, put_some};
use crate::nearest::{mapd_nearest, mapd_nearest_options, options_of};
use crate::point::mapd_vec3;
use crate::snapshot::{map_of, mapd_snapshot};
use mapd_client::geodesy::{Geodetic, GeodeticPoint, Projector};

/// Converts between a map's inertial frame and WGS 84. Several threads may use it at once. It is made from a snapshot and needs it no longer.
pub struct mapd_projector(Projector);

/// A place on Earth, on the ellipsoid of WGS 84.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_geodetic {
    /// Latitude \[deg\], positive to the north.
    pub latitude: f64,
    /// Longitude \[deg\], positive to the east, −180 to 180.
    pub longitude: f64,
    /// Altitude \[m\]: the map's z with the header's offset. No geoid is applied.
    pub altitude: f64,
}

impl From<Geodetic> for mapd_geodetic {
    fn from(place: Geodetic) -> Self {
        let Geodetic { latitude, longitude, altitude } = place;
        Self { latitude, longitude, altitude }
    }
}

impl From<mapd_geodetic> for Geodetic {
    fn from(place: mapd_geodetic) -> Self {
        let mapd_geodetic { latitude, longitude, altitude } = place;
        Self { latitude, longitude, altitude }
    }
}

unsafe fn projector_of<'a>(projector: *const mapd_projector) -> Result<&'a Projector, Failure> {
    unsafe { Ok(&get(projector, "a projector")?.0) }
}

/// What converts between this map's inertial frame and WGS 84. Close it with `mapd_projector_close`.
///
/// Errors: `MAPD_CODE_NO_PROJECTION`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_projector_new(
    snapshot: *const mapd_snapshot,
    out: *mut *mut mapd_projector,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || hand_out(out, mapd_projector(map_of(snapshot)?.projector()?))) }
}

/// What converts between the file's own frame and WGS 84, of a map that was compiled into another frame; else as `mapd_projector_new`.
///
/// Errors: `MAPD_CODE_NO_PROJECTION`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_projector_of_file(
    snapshot: *const mapd_snapshot,
    out: *mut *mut mapd_projector,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || hand_out(out, mapd_projector(map_of(snapshot)?.file_projector()?))) }
}

/// Closes a projector and sets the handle to null. Null, or a handle that is null, is fine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_projector_close(projector: *mut *mut mapd_projector) {
    unsafe { close(projector) }
}

/// Where a point of the map lies on Earth.
///
/// Errors: `MAPD_CODE_NOT_FINITE`, `MAPD_CODE_OUTSIDE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_to_geodetic(
    projector: *const mapd_projector,
    point: mapd_vec3,
    out: *mut mapd_geodetic,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put_answer(out, projector_of(projector)?.to_geodetic(point.into()))) }
}

/// The point of the map at a place on Earth.
///
/// Errors: `MAPD_CODE_NOT_FINITE`, `MAPD_CODE_NO_PLACE_ON_EARTH`, `MAPD_CODE_OUTSIDE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_from_geodetic(
    projector: *const mapd_projector,
    place: mapd_geodetic,
    out: *mut mapd_vec3,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || put_answer(out, projector_of(projector)?.from_geodetic(place.into())))
    }
}

/// As `mapd_to_geodetic`, of `count` points; `out` has room for as many.
///
/// Errors: as `mapd_to_geodetic`, of the first point that has one; the answers before it are written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_to_geodetic_batch(
    projector: *const mapd_projector,
    points: *const mapd_vec3,
    count: usize,
    out: *mut mapd_geodetic,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let projector = projector_of(projector)?;
            let points = entries(points, count, "the points")?;
            fill(out, points, |point| projector.to_geodetic((*point).into()).map(Into::into))
        })
    }
}

/// As `mapd_from_geodetic`, of `count` places; `out` has room for as many.
///
/// Errors: as `mapd_from_geodetic`, of the first place that has one; the answers before it are written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_from_geodetic_batch(
    projector: *const mapd_projector,
    places: *const mapd_geodetic,
    count: usize,
    out: *mut mapd_vec3,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let projector = projector_of(projector)?;
            let places = entries(places, count, "the places")?;
            fill(out, places, |place| projector.from_geodetic((*place).into()).map(Into::into))
        })
    }
}

/// Heading of true north at each of `count` points of the map \[rad\], counter-clockwise from x, in (−π, π\]. A heading that a receiver gives clockwise
/// from true north is this minus that one. `out` has room for as many.
///
/// Errors: as `mapd_to_geodetic`, of the first point that has one; the answers before it are written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_north_at_batch(
    projector: *const mapd_projector,
    points: *const mapd_vec3,
    count: usize,
    out: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let projector = projector_of(projector)?;
            let points = entries(points, count, "the points")?;
            fill(out, points, |point| projector.north_at((*point).into()))
        })
    }
}

/// East, north and up \[m\] of each of `count` points of the map, from `origin`, a point of the map: the topocentric frame, in the plane that touches
/// the Earth there. `out` has room for as many.
///
/// Errors: as `mapd_to_geodetic`, of the origin or the first point that has one; the answers before it are written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_to_enu_batch(
    projector: *const mapd_projector,
    origin: mapd_vec3,
    points: *const mapd_vec3,
    count: usize,
    out: *mut mapd_vec3,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let frame = projector_of(projector)?.enu_at(origin.into())?;
            let points = entries(points, count, "the points")?;
            fill(out, points, |point| frame.to_enu((*point).into()).map(Into::into))
        })
    }
}

/// The points of the map at each of `count` easts, norths and ups \[m\] from `origin`, a point of the map. `out` has room for as many.
///
/// Errors: as `mapd_to_enu_batch`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_from_enu_batch(
    projector: *const mapd_projector,
    origin: mapd_vec3,
    places: *const mapd_vec3,
    count: usize,
    out: *mut mapd_vec3,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let frame = projector_of(projector)?.enu_at(origin.into())?;
            let places = entries(places, count, "the places")?;
            fill(out, places, |place| frame.from_enu((*place).into()).map(Into::into))
        })
    }
}

/// As `mapd_nearest_lane`, from a place on Earth through a projector of this map. The altitude counts where `has_altitude` is not 0.
/// `MAPD_CODE_NONE` if no lane is within the radius.
///
/// Errors: as `mapd_from_geodetic`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_nearest_lane_geodetic(
    snapshot: *const mapd_snapshot,
    projector: *const mapd_projector,
    place: mapd_geodetic,
    has_altitude: u8,
    options: *const mapd_nearest_options,
    out: *mut mapd_nearest,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (map, projector) = (map_of(snapshot)?, projector_of(projector)?);
            let altitude = (has_altitude != 0).then_some(place.altitude);
            let mapd_geodetic { latitude, longitude, .. } = place;
            let place = GeodeticPoint { latitude, longitude, altitude };
            let found = map.nearest_lane_geodetic(projector, place, &options_of(options)?)?;
            put_some(out, found.map(mapd_nearest::from))
        })
    }
}
