//! Latitudes and longitudes.

use super::row::Row;
use mapd_client::{Geodetic, Map, Projector};
use mapd_query::glam::DVec3;

/// Parts into which each edge of the bounds is cut: meridians and parallels bend in a projection's plane.
const EDGE_PARTS: usize = 8;

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

/// Smallest and largest latitude and longitude `[deg]` along the edge of the map's bounds; none without a usable
/// georeference, or where the map lies outside its area.
pub(crate) fn bounds(map: Map<'_>) -> Option<[[f64; 2]; 2]> {
    let projector = map.projector().ok()?;
    let (min, max) = map.bounds();
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    for part in 0..=EDGE_PARTS {
        let at = min.lerp(max, part as f64 / EDGE_PARTS as f64);
        for (x, y) in [(at.x, min.y), (at.x, max.y), (min.x, at.y), (max.x, at.y)] {
            let place = projector.to_geodetic(DVec3::new(x, y, at.z)).ok()?;
            for (axis, value) in [place.latitude, place.longitude].into_iter().enumerate() {
                low[axis] = low[axis].min(value);
                high[axis] = high[axis].max(value);
            }
        }
    }
    Some([low, high])
}
