//! From an ellipsoid to a plane and back, by whichever projection a definition names.

#[cfg(not(target_family = "wasm"))]
use crate::by_proj4rs::Both;
use crate::ellipsoid::{Ellipsoid, GeodeticRadians, WGS84};
use crate::plain;
use crate::projector::ProjectionError;
use crate::topocentric::Topocentric;
use crate::transverse_mercator::TransverseMercator;
use glam::DVec2;

/// Name of the plane of a topocentric frame.
const TOPOCENTRIC: &str = "topocentric";

/// A projection that is ready for use.
#[derive(Clone)]
pub(crate) enum Plane {
    /// With the longitude of its prime meridian `[rad]`.
    Transverse(TransverseMercator, f64),
    Topocentric(Topocentric),
    /// By proj4rs: the projection, and latitudes and longitudes on the ellipsoid or sphere that it computes on.
    #[cfg(not(target_family = "wasm"))]
    Other(Box<Both>),
}

impl Plane {
    /// Reads PROJ parameters: the projection, and the ellipsoid of its datum, on which latitudes and longitudes lie. Errors:
    /// what is wrong with them.
    pub(crate) fn read(definition: &str) -> Result<(Self, Ellipsoid), String> {
        let words = || definition.split_whitespace().map(|word| word.trim_start_matches('+'));
        let get = |name: &str| words().find_map(|word| word.strip_prefix(name)?.strip_prefix('='));
        if get("proj") == Some(TOPOCENTRIC) {
            let number = |name: &str| match get(name).map(str::parse::<f64>) {
                None => Ok(0.0),
                Some(Ok(number)) if number.is_finite() => Ok(number),
                Some(_) => Err(format!("expected a number for {name}")),
            };
            let (latitude, longitude) = (number("lat_0")?, number("lon_0")?);
            if latitude.abs() > 90.0 || longitude.abs() > 360.0 {
                return Err(
                    "expected a latitude of −90 to 90 and a longitude of −360 to 360".into()
                );
            }
            let (latitude, longitude) = (latitude.to_radians(), longitude.to_radians());
            let origin = GeodeticRadians { longitude, latitude, height: number("h_0")? };
            return Ok((Self::Topocentric(Topocentric::new(origin)), WGS84));
        }
        if let Some((projection, ellipsoid)) = plain::transverse(definition) {
            return Ok((Self::Transverse(projection, 0.0), ellipsoid));
        }
        other(definition)
    }

    pub(crate) fn is_reproducible(&self) -> bool {
        matches!(self, Self::Transverse(..) | Self::Topocentric(_))
    }

    /// Longitude and latitude `[rad]` of a point of the plane `[m]`.
    pub(crate) fn inverse(&self, plane: DVec2) -> Result<(f64, f64), ProjectionError> {
        match self {
            Self::Transverse(projection, meridian) => {
                let (longitude, latitude) = projection.inverse(plane)?;
                Ok((longitude + meridian, latitude))
            }
            Self::Topocentric(projection) => projection.inverse(plane),
            #[cfg(not(target_family = "wasm"))]
            Self::Other(both) => both.inverse(plane),
        }
    }

    /// The point of the plane `[m]` at a longitude and latitude `[rad]`.
    pub(crate) fn forward(&self, longitude: f64, latitude: f64) -> Result<DVec2, ProjectionError> {
        match self {
            Self::Transverse(projection, meridian) => {
                projection.forward(longitude - meridian, latitude)
            }
            Self::Topocentric(projection) => projection.forward(longitude, latitude),
            #[cfg(not(target_family = "wasm"))]
            Self::Other(both) => both.forward(longitude, latitude),
        }
    }

    /// Height above the ellipsoid, as far as the map's heights are, of a height in the plane's frame `[m]`.
    pub(crate) fn height(&self, z: f64) -> f64 {
        match self {
            Self::Topocentric(projection) => z + projection.height,
            _ => z,
        }
    }

    /// The other way.
    pub(crate) fn above(&self, height: f64) -> f64 {
        match self {
            Self::Topocentric(projection) => height - projection.height,
            _ => height,
        }
    }
}

#[cfg(not(target_family = "wasm"))]
use crate::by_proj4rs::read as other;

/// proj4rs is not built for browsers.
#[cfg(target_family = "wasm")]
fn other(_: &str) -> Result<(Plane, Ellipsoid), String> {
    Err("this build knows transverse Mercator and topocentric planes alone".into())
}

impl std::fmt::Debug for Plane {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Transverse(..) => "transverse Mercator",
            Self::Topocentric(_) => TOPOCENTRIC,
            #[cfg(not(target_family = "wasm"))]
            Self::Other(both) => both.0.projname(),
        })
    }
}
