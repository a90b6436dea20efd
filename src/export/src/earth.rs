//! Where the shapes of files for other programs lie.

#[cfg(any(feature = "flatgeobuf", feature = "geojson"))]
use crate::layers::Shape;
use crate::{ExportError, Result};
use mapd_client::Map;
use mapd_client::geodesy::{Geodetic, Offset, Projector};
use mapd_client::glam::DVec3;
use std::str::FromStr;

/// A point of a file: x or longitude, y or latitude, z.
#[cfg(any(feature = "flatgeobuf", feature = "geojson"))]
pub(super) type Coordinate = [f64; 3];

/// Digits behind the point of longitudes and latitudes: a ten thousandth of a metre.
#[cfg(any(feature = "flatgeobuf", feature = "geojson"))]
const DEGREE_DIGITS: f64 = 1e9;
/// Digits behind the point of heights: a ten thousandth of a metre.
#[cfg(any(feature = "flatgeobuf", feature = "geojson"))]
const METRE_DIGITS: f64 = 1e4;

/// Where a map without a georeference is to lie: the place on WGS 84 of its point x = 0, y = 0, with x to the east and y to the north.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Origin {
    /// `[deg]`, positive to the north.
    latitude: f64,
    /// `[deg]`, positive to the east.
    longitude: f64,
}

impl FromStr for Origin {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wanted = || format!("expected LAT,LON in degrees, such as 49.01,8.43, found {text:?}");
        let (latitude, longitude) = text.split_once(',').ok_or_else(wanted)?;
        let number = |text: &str| text.trim().parse::<f64>().map_err(|_| wanted());
        let (latitude, longitude) = (number(latitude)?, number(longitude)?);
        if latitude.abs() < 90.0 && longitude.abs() <= 180.0 {
            Ok(Self { latitude, longitude })
        } else {
            Err("expected a latitude between −90 and 90 and a longitude of −180 to 180 degrees"
                .into())
        }
    }
}

/// The projector of a map, for a format that has latitudes and longitudes.
///
/// Errors: the map has none, with what to add; it has one, and an origin is given, too.
pub(super) fn projector(map: Map<'_>, origin: Option<Origin>) -> Result<Projector> {
    let Some(Origin { latitude, longitude }) = origin else {
        return map.projector().map_err(ExportError::NoGeoreference);
    };
    if !map.projection().is_empty() {
        return Err(ExportError::TwoGeoreferences(map.projection().to_owned()));
    }
    let plane =
        format!("+proj=tmerc +lat_0={latitude} +lon_0={longitude} +k=1 +datum=WGS84 +units=m");
    Projector::new(&plane, Offset::default()).map_err(ExportError::NoGeoreference)
}

/// Where a point of the map lies on Earth.
///
/// Errors: it lies outside the projection's area.
pub(super) fn place(projector: &Projector, point: DVec3) -> Result<Geodetic> {
    let place = projector.to_geodetic(point);
    place.map_err(|source| ExportError::OffEarth { x: point.x, y: point.y, source })
}

/// The points of a shape as longitude, latitude `[deg]` and altitude `[m]`. Of a shape across the antimeridian the longitudes
/// pass 180 or −180, so that it stays in one piece.
///
/// Errors: a point outside the projection's area.
#[cfg(any(feature = "flatgeobuf", feature = "geojson"))]
pub(super) fn on_earth(shape: &Shape, projector: &Projector) -> Result<Vec<Coordinate>> {
    let mut first = None;
    let place = |point: &DVec3| {
        let place = place(projector, *point)?;
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
#[cfg(feature = "geojson")]
pub(super) fn is_clockwise(corners: &[Coordinate]) -> bool {
    let Some([x, y, _]) = corners.first() else { return false };
    let next = corners.iter().cycle().skip(1);
    let cross =
        |(a, b): (&Coordinate, &Coordinate)| (a[0] - x) * (b[1] - y) - (b[0] - x) * (a[1] - y);
    corners.iter().zip(next).map(cross).sum::<f64>() < 0.0
}
