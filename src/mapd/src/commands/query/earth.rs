//! Latitudes and longitudes.

use super::row::Row;
use mapd_client::Map;
use mapd_client::geodesy::{Geodetic, Projector};
use mapd_query::glam::DVec3;

/// The map's projector, or why it has none.
pub(crate) struct Earth(Result<Projector, String>);

impl Earth {
    pub(crate) fn new(map: Map<'_>) -> Self {
        Self(map.projector().map_err(|error| error.to_string()))
    }

    /// Latitude, longitude and altitude of a point.
    pub(crate) fn place(&self, point: DVec3) -> Result<[f64; 3], String> {
        let projector = self.0.as_ref().map_err(String::clone)?;
        let place = projector.to_geodetic(point).map_err(|error| error.to_string())?;
        Ok([place.latitude, place.longitude, place.altitude])
    }

    /// The point of a row's latitude, longitude and, if any, altitude.
    pub(crate) fn point(&self, row: &Row<'_>) -> Result<DVec3, String> {
        let projector = self.0.as_ref().map_err(String::clone)?;
        let place = Geodetic {
            latitude: row.number("lat")?,
            longitude: row.number("lon")?,
            altitude: row.optional("alt")?.unwrap_or(0.0),
        };
        projector.from_geodetic(place).map_err(|error| error.to_string())
    }
}
