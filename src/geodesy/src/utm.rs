//! Zones of the universal transverse Mercator projection.

use std::fmt;

/// Width of a zone `[deg]`.
const WIDTH: f64 = 6.0;
const ZONES: f64 = 60.0;
/// Latitudes that have zones `[deg]`; beyond, maps of the poles are stereographic.
const SOUTH: f64 = -80.0;
const NORTH: f64 = 84.0;

/// A zone of UTM.
///
/// ```
/// use mapd_geodesy::UtmZone;
///
/// let zone = UtmZone::of(48.14, 11.57).unwrap();
/// assert_eq!((zone.number, zone.is_north), (32, true));
/// assert_eq!(zone.definition(), "+proj=utm +zone=32 +datum=WGS84");
/// assert_eq!(UtmZone::of(89.0, 11.57), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct UtmZone {
    /// 1 to 60, from 180° W to the east.
    pub number: u8,
    /// Whether it is the northern half, whose y begins at the equator.
    pub is_north: bool,
}

impl UtmZone {
    /// The zone of a latitude and longitude `[deg]`: a regular one, 6 degrees wide, without the exceptions around Norway and Svalbard. An edge belongs
    /// to the zone to its east, the equator to the north. Longitudes beyond ±180 go round. `None` beyond 80° S and 84° N, and for what is not finite.
    ///
    /// A map keeps the zone of its own projection: [`crate::Projector::from_geodetic`] puts a fix beyond the zone's edge into that zone, where UTM is
    /// as exact; only its scale and the convergence of its grid grow.
    pub fn of(latitude: f64, longitude: f64) -> Option<Self> {
        let is_there = (SOUTH..=NORTH).contains(&latitude) && longitude.is_finite();
        is_there.then(|| Self::regular(latitude, longitude))
    }

    /// As [`Self::of`], at the poles too.
    pub(crate) fn regular(latitude: f64, longitude: f64) -> Self {
        let turned = (longitude + 180.0).rem_euclid(360.0);
        let number = ((turned / WIDTH).floor() % ZONES) as u8 + 1;
        Self { number, is_north: latitude >= 0.0 }
    }

    /// PROJ parameters of its projection on WGS 84.
    pub fn definition(&self) -> String {
        let south = if self.is_north { "" } else { " +south" };
        format!("+proj=utm +zone={}{south} +datum=WGS84", self.number)
    }
}

impl fmt::Display for UtmZone {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.number, if self.is_north { 'N' } else { 'S' })
    }
}
