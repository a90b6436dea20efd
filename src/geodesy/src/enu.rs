//! East, north and up of a place of the map.

use crate::ellipsoid::{GeodeticRadians, WGS84};
use crate::projector::{Geodetic, ProjectionError, Projector};
use glam::DVec3;

/// The topocentric frame of a place (EPSG method 9837): east, north and up `[m]` from there, in the plane that touches the Earth. It is straight in
/// space: level ground falls below it by d²/2R, 8 cm at 1 km. Made by [`Projector::enu_at`]; converting allocates nothing.
#[derive(Clone, Debug)]
pub struct EnuFrame<'a> {
    projector: &'a Projector,
    /// Geocentric coordinates of the origin `[m]`.
    origin: DVec3,
    east: DVec3,
    north: DVec3,
    up: DVec3,
}

impl Projector {
    /// The topocentric frame of a point of the map (inertial, `[m]`).
    ///
    /// Errors: as [`Projector::to_geodetic`].
    pub fn enu_at(&self, point: DVec3) -> Result<EnuFrame<'_>, ProjectionError> {
        let origin = radians(self.to_geodetic(point)?);
        let (sin_lat, cos_lat) = libm::sincos(origin.latitude);
        let (sin_lon, cos_lon) = libm::sincos(origin.longitude);
        Ok(EnuFrame {
            projector: self,
            origin: WGS84.to_geocentric(origin),
            east: DVec3::new(-sin_lon, cos_lon, 0.0),
            north: DVec3::new(-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat),
            up: DVec3::new(cos_lat * cos_lon, cos_lat * sin_lon, sin_lat),
        })
    }
}

impl EnuFrame<'_> {
    /// East, north and up `[m]` of a point of the map (inertial, `[m]`).
    ///
    /// Errors: as [`Projector::to_geodetic`].
    pub fn to_enu(&self, point: DVec3) -> Result<DVec3, ProjectionError> {
        let place = WGS84.to_geocentric(radians(self.projector.to_geodetic(point)?));
        let away = place - self.origin;
        Ok(DVec3::new(away.dot(self.east), away.dot(self.north), away.dot(self.up)))
    }

    /// The point of the map (inertial, `[m]`) at an east, north and up `[m]`.
    ///
    /// Errors: it is not finite, or lies outside the projection's area.
    pub fn from_enu(&self, place: DVec3) -> Result<DVec3, ProjectionError> {
        if !place.is_finite() {
            return Err(ProjectionError::NotFinite);
        }
        let away = self.east * place.x + self.north * place.y + self.up * place.z;
        let place = WGS84.to_geodetic(self.origin + away);
        self.projector.from_geodetic(Geodetic {
            latitude: place.latitude.to_degrees(),
            longitude: place.longitude.to_degrees(),
            altitude: place.height,
        })
    }

    /// As [`Self::to_enu`] for many points; `out` gets one answer for each.
    pub fn to_enu_batch(&self, points: &[DVec3], out: &mut Vec<Result<DVec3, ProjectionError>>) {
        out.clear();
        out.extend(points.iter().map(|point| self.to_enu(*point)));
    }

    /// As [`Self::from_enu`] for many places; `out` gets one answer for each.
    pub fn from_enu_batch(&self, places: &[DVec3], out: &mut Vec<Result<DVec3, ProjectionError>>) {
        out.clear();
        out.extend(places.iter().map(|place| self.from_enu(*place)));
    }
}

fn radians(place: Geodetic) -> GeodeticRadians {
    GeodeticRadians {
        longitude: place.longitude.to_radians(),
        latitude: place.latitude.to_radians(),
        height: place.altitude,
    }
}
