//! Ellipsoids of revolution, and places in space about their centre.

use glam::DVec3;

/// A place on or above an ellipsoid: longitude and latitude `[rad]`, height `[m]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct GeodeticRadians {
    pub(crate) longitude: f64,
    pub(crate) latitude: f64,
    pub(crate) height: f64,
}

/// An ellipsoid of revolution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ellipsoid {
    /// Semi-major axis `[m]`.
    pub(crate) a: f64,
    /// Flattening (a − b)/a.
    pub(crate) f: f64,
}

/// That of WGS 84.
pub(crate) const WGS84: Ellipsoid = Ellipsoid { a: 6_378_137.0, f: 1.0 / 298.257_223_563 };

/// Steps of Bowring's iteration: one is good to micrometres at heights of kilometres, each further one divides by 10⁵.
const STEPS: usize = 2;

impl Ellipsoid {
    /// From both semi-axes `[m]`.
    pub(crate) fn new(a: f64, b: f64) -> Self {
        Self { a, f: (a - b) / a }
    }

    /// First eccentricity, squared.
    pub(crate) fn e2(&self) -> f64 {
        self.f * (2.0 - self.f)
    }

    /// Geocentric coordinates `[m]`: x towards longitude 0, z towards the north pole.
    pub(crate) fn to_geocentric(self, place: GeodeticRadians) -> DVec3 {
        let (sin_lat, cos_lat) = libm::sincos(place.latitude);
        let (sin_lon, cos_lon) = libm::sincos(place.longitude);
        let e2 = self.e2();
        let normal = self.a / (1.0 - e2 * sin_lat * sin_lat).sqrt();
        let across = (normal + place.height) * cos_lat;
        let z = (normal * (1.0 - e2) + place.height) * sin_lat;
        DVec3::new(across * cos_lon, across * sin_lon, z)
    }

    /// The place at geocentric coordinates `[m]`, by Bowring's iteration (1976) of the reduced latitude's tangent.
    pub(crate) fn to_geodetic(self, point: DVec3) -> GeodeticRadians {
        let e2 = self.e2();
        let b = self.a * (1.0 - self.f);
        // Second eccentricity squared times b, and first eccentricity squared times a.
        let (polar, equatorial) = (e2 * self.a * self.a / b, e2 * self.a);
        let across = (point.x * point.x + point.y * point.y).sqrt();
        let (mut sin, mut cos) = unit(point.z * self.a, across * b);
        let (mut up, mut out) = (point.z, across);
        for _ in 0..STEPS {
            up = point.z + polar * sin * sin * sin;
            out = across - equatorial * cos * cos * cos;
            (sin, cos) = unit(up * (1.0 - self.f), out);
        }
        let (sin_lat, cos_lat) = unit(up, out);
        let normal = self.a * (1.0 - e2 * sin_lat * sin_lat).sqrt();
        GeodeticRadians {
            longitude: libm::atan2(point.y, point.x),
            latitude: libm::atan2(up, out),
            height: across * cos_lat + point.z * sin_lat - normal,
        }
    }
}

/// Sine and cosine of a direction.
fn unit(up: f64, out: f64) -> (f64, f64) {
    let length = (up * up + out * out).sqrt();
    (up / length, out / length)
}
