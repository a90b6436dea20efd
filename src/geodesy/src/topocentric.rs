//! East and north of a place: the plane of a topocentric frame.
//!
//! A point of this plane is the vertical projection, onto the plane that touches the surface of the origin's height at the
//! origin, of the place at that height. East and north are those of the topocentric frame (EPSG method 9837) for places at
//! the height of the origin. The third coordinate is the height above that of the origin, along the plumb line of the place
//! itself, so that level ground stays level; it exceeds the topocentric "up" by d²/2R: 8 cm at 1 km.

use crate::ellipsoid::{GeodeticRadians, WGS84};
use crate::projector::ProjectionError;
use glam::{DVec2, DVec3};

/// The inverse stops where heights agree within this `[m]`: geocentric coordinates have a nanometre, and the place is off by
/// the hundredth part of it even 60 km away.
const CONVERGED: f64 = 1e-8;
/// Steps of the inverse at most. Each divides the error by (R/d)²: 100 km away by 4,000.
const STEPS: usize = 12;

/// The projection.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Topocentric {
    /// Geocentric coordinates of the origin `[m]`.
    origin: DVec3,
    east: DVec3,
    north: DVec3,
    up: DVec3,
    pub(crate) height: f64,
}

impl Topocentric {
    /// About an origin on WGS 84.
    pub(crate) fn new(origin: GeodeticRadians) -> Self {
        let (sin_lat, cos_lat) = libm::sincos(origin.latitude);
        let (sin_lon, cos_lon) = libm::sincos(origin.longitude);
        Self {
            origin: WGS84.to_geocentric(origin),
            east: DVec3::new(-sin_lon, cos_lon, 0.0),
            north: DVec3::new(-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat),
            up: DVec3::new(cos_lat * cos_lon, cos_lat * sin_lon, sin_lat),
            height: origin.height,
        }
    }

    /// From longitude and latitude `[rad]` to the plane `[m]`.
    pub(crate) fn forward(&self, longitude: f64, latitude: f64) -> Result<DVec2, ProjectionError> {
        let place =
            WGS84.to_geocentric(GeodeticRadians { longitude, latitude, height: self.height });
        // The other half of the Earth would fall onto the same plane.
        if place.dot(self.up) <= 0.0 {
            return Err(ProjectionError::Outside);
        }
        let away = place - self.origin;
        Ok(DVec2::new(away.dot(self.east), away.dot(self.north)))
    }

    /// From the plane `[m]` to longitude and latitude `[rad]`.
    pub(crate) fn inverse(&self, point: DVec2) -> Result<(f64, f64), ProjectionError> {
        let mut up = -point.length_squared() / (2.0 * WGS84.a);
        for _ in 0..STEPS {
            let away = self.east * point.x + self.north * point.y + self.up * up;
            let place = WGS84.to_geodetic(self.origin + away);
            let over = place.height - self.height;
            if over.abs() <= CONVERGED {
                return Ok((place.longitude, place.latitude));
            }
            up -= over;
        }
        Err(ProjectionError::Outside)
    }
}
