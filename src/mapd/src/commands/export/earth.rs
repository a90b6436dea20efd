//! Where the shapes of files for other programs lie.

use super::layers::Shape;
use anyhow::{Context, Result};
use mapd_client::{Map, Projector};

/// A point of a file: x or longitude, y or latitude, z.
pub(super) type Place = [f64; 3];

/// Digits behind the point of longitudes and latitudes: a ten thousandth of a metre.
const DEGREE_DIGITS: f64 = 1e9;
/// Digits behind the point of heights: a ten thousandth of a metre.
const METRE_DIGITS: f64 = 1e4;

/// What to add to a map without a georeference.
const NO_GEOREFERENCE: &str = "this format needs latitudes and longitudes: add the map's projection as \
    PROJ parameters, such as +proj=utm +zone=32 +datum=WGS84, to header/geoReference of the OpenDRIVE file";

/// The projector of a map, for a format that has latitudes and longitudes.
///
/// Errors: the map has none, with what to add.
pub(super) fn projector(map: Map<'_>) -> Result<Projector> {
    map.projector().context(NO_GEOREFERENCE)
}

/// The points of a shape as longitude, latitude `[deg]` and altitude `[m]`. Of a shape across the antimeridian the longitudes
/// pass 180 or −180, so that it stays in one piece.
///
/// Errors: a point outside the projection's area.
pub(super) fn on_earth(shape: &Shape, projector: &Projector) -> Result<Vec<Place>> {
    let mut first = None;
    let place = |point: &mapd_client::glam::DVec3| {
        let place = projector.to_geodetic(*point).with_context(|| {
            format!("the point x {} m, y {} m has no latitude and longitude", point.x, point.y)
        })?;
        let first = *first.get_or_insert(place.longitude);
        let turns = ((first - place.longitude) / 360.0).round();
        let rounded = |value: f64, digits: f64| (value * digits).round() / digits;
        Ok([
            rounded(place.longitude + 360.0 * turns, DEGREE_DIGITS),
            rounded(place.latitude, DEGREE_DIGITS),
            rounded(place.altitude, METRE_DIGITS),
        ])
    };
    shape.points().iter().map(place).collect()
}

/// Whether the corners of an area run clockwise in plan view.
pub(super) fn is_clockwise(corners: &[Place]) -> bool {
    let Some([x, y, _]) = corners.first() else { return false };
    let next = corners.iter().cycle().skip(1);
    let cross = |(a, b): (&Place, &Place)| (a[0] - x) * (b[1] - y) - (b[0] - x) * (a[1] - y);
    corners.iter().zip(next).map(cross).sum::<f64>() < 0.0
}
