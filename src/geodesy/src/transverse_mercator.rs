//! Transverse Mercator, by Krüger's series to the sixth order of the third flattening: within nanometres up to 3,000 km from
//! the central meridian.
//!
//! Source: C. F. F. Karney, "Transverse Mercator with an accuracy of a few nanometers", J. Geodesy 85 (2011), eq. 35 and 36;
//! for conformal latitudes K. Engsager and K. Poder (ICC 2007), the algorithm of PROJ. The functions are libm's: places are
//! the same on every machine.

use crate::ellipsoid::Ellipsoid;
use crate::projector::ProjectionError;
use glam::DVec2;

/// Order of the series.
const ORDER: usize = 6;
/// Largest distance from the central meridian in units of the rectifying radius that the series are used to, as in PROJ:
/// 150 degrees on the sphere.
const FARTHEST: f64 = 2.623_395_162_778;

/// The projection.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TransverseMercator {
    /// Rectifying radius with the scale on the central meridian `[m]`.
    radius: f64,
    longitude: f64,
    /// False easting and northing `[m]`, the latter less that of the origin's latitude.
    shift: DVec2,
    to_conformal: [f64; ORDER],
    from_conformal: [f64; ORDER],
    to_plane: [f64; ORDER],
    from_plane: [f64; ORDER],
}

/// Value of a polynomial in n whose terms begin at the power `first`.
fn series<const N: usize>(n: f64, first: i32, terms: [f64; N]) -> f64 {
    let sum = terms.iter().rev().fold(0.0, |sum, term| sum * n + term);
    (0..first).fold(sum, |value, _| value * n)
}

/// Σ c_k·sin(2kx) for k = 1…6, from sin 2x and cos 2x (Clenshaw's recurrence).
fn sines(c: &[f64; ORDER], sin: f64, cos: f64) -> f64 {
    let (mut one, mut two) = (0.0, 0.0);
    for c in c.iter().rev() {
        (one, two) = (2.0 * cos * one - two + c, one);
    }
    one * sin
}

/// The same for complex x, of which sin 2x and cos 2x are given as (real, imaginary).
fn complex_sines(c: &[f64; ORDER], sin: DVec2, cos: DVec2) -> DVec2 {
    let (mut one, mut two) = (DVec2::ZERO, DVec2::ZERO);
    for c in c.iter().rev() {
        (one, two) = (cos.rotate(one) * 2.0 - two + DVec2::new(*c, 0.0), one);
    }
    one.rotate(sin)
}

impl TransverseMercator {
    /// With its origin at a latitude and longitude `[rad]`, a scale on the central meridian, and a false origin `[m]`.
    pub(crate) fn new(
        ellipsoid: Ellipsoid,
        (latitude, longitude): (f64, f64),
        scale: f64,
        false_origin: DVec2,
    ) -> Self {
        let n = ellipsoid.f / (2.0 - ellipsoid.f);
        let n2 = n * n;
        let to_conformal = [
            series(n, 1, [-2.0, 2.0 / 3.0, 4.0 / 3.0, -82.0 / 45.0, 32.0 / 45.0, 4642.0 / 4725.0]),
            series(n, 2, [5.0 / 3.0, -16.0 / 15.0, -13.0 / 9.0, 904.0 / 315.0, -1522.0 / 945.0]),
            series(n, 3, [-26.0 / 15.0, 34.0 / 21.0, 8.0 / 5.0, -12686.0 / 2835.0]),
            series(n, 4, [1237.0 / 630.0, -12.0 / 5.0, -24832.0 / 14175.0]),
            series(n, 5, [-734.0 / 315.0, 109_598.0 / 31185.0]),
            series(n, 6, [444_337.0 / 155_925.0]),
        ];
        let from_conformal = [
            series(n, 1, [2.0, -2.0 / 3.0, -2.0, 116.0 / 45.0, 26.0 / 45.0, -2854.0 / 675.0]),
            series(n, 2, [7.0 / 3.0, -8.0 / 5.0, -227.0 / 45.0, 2704.0 / 315.0, 2323.0 / 945.0]),
            series(n, 3, [56.0 / 15.0, -136.0 / 35.0, -1262.0 / 105.0, 73814.0 / 2835.0]),
            series(n, 4, [4279.0 / 630.0, -332.0 / 35.0, -399_572.0 / 14175.0]),
            series(n, 5, [4174.0 / 315.0, -144_838.0 / 6237.0]),
            series(n, 6, [601_676.0 / 22275.0]),
        ];
        let to_plane = [
            series(
                n,
                1,
                [0.5, -2.0 / 3.0, 5.0 / 16.0, 41.0 / 180.0, -127.0 / 288.0, 7891.0 / 37800.0],
            ),
            series(
                n,
                2,
                [13.0 / 48.0, -0.6, 557.0 / 1440.0, 281.0 / 630.0, -1_983_433.0 / 1_935_360.0],
            ),
            series(n, 3, [61.0 / 240.0, -103.0 / 140.0, 15061.0 / 26880.0, 167_603.0 / 181_440.0]),
            series(n, 4, [49561.0 / 161_280.0, -179.0 / 168.0, 6_601_661.0 / 7_257_600.0]),
            series(n, 5, [34729.0 / 80640.0, -3_418_889.0 / 1_995_840.0]),
            series(n, 6, [212_378_941.0 / 319_334_400.0]),
        ];
        let from_plane = [
            series(
                n,
                1,
                [-0.5, 2.0 / 3.0, -37.0 / 96.0, 1.0 / 360.0, 81.0 / 512.0, -96199.0 / 604_800.0],
            ),
            series(
                n,
                2,
                [
                    -1.0 / 48.0,
                    -1.0 / 15.0,
                    437.0 / 1440.0,
                    -46.0 / 105.0,
                    1_118_711.0 / 3_870_720.0,
                ],
            ),
            series(n, 3, [-17.0 / 480.0, 37.0 / 840.0, 209.0 / 4480.0, -5569.0 / 90720.0]),
            series(n, 4, [-4397.0 / 161_280.0, 11.0 / 504.0, 830_251.0 / 7_257_600.0]),
            series(n, 5, [-4583.0 / 161_280.0, 108_847.0 / 3_991_680.0]),
            series(n, 6, [-20_648_693.0 / 638_668_800.0]),
        ];
        let radius =
            scale * ellipsoid.a / (1.0 + n) * (1.0 + n2 * (0.25 + n2 * (1.0 / 64.0 + n2 / 256.0)));
        let mut projection = Self {
            radius,
            longitude,
            shift: DVec2::ZERO,
            to_conformal,
            from_conformal,
            to_plane,
            from_plane,
        };
        // On the central meridian: the rectifying latitude of the origin.
        let (sin, cos) = libm::sincos(2.0 * latitude);
        let conformal = latitude + sines(&to_conformal, sin, cos);
        let (sin, cos) = libm::sincos(2.0 * conformal);
        let north = conformal + sines(&to_plane, sin, cos);
        projection.shift = false_origin - DVec2::new(0.0, radius * north);
        projection
    }

    /// From longitude and latitude `[rad]` to the plane `[m]`.
    pub(crate) fn forward(&self, longitude: f64, latitude: f64) -> Result<DVec2, ProjectionError> {
        let (sin, cos) = libm::sincos(latitude);
        let conformal =
            latitude + sines(&self.to_conformal, 2.0 * sin * cos, 1.0 - 2.0 * sin * sin);
        let (sin_lat, cos_lat) = libm::sincos(conformal);
        let (sin_lon, cos_lon) = libm::sincos(longitude - self.longitude);
        // The spherical projection: ξ northwards, η eastwards.
        let out = cos_lat * cos_lon;
        let near = (sin_lat * sin_lat + out * out).sqrt();
        let sinh = sin_lon * cos_lat / near;
        let xi = libm::atan2(sin_lat, out);
        let eta = libm::asinh(sinh);
        let (sin, cos) = (sin_lat / near, out / near);
        let (sin, cos) = (2.0 * sin * cos, 1.0 - 2.0 * sin * sin);
        let (sinh, cosh) = (2.0 * sinh / near, 1.0 + 2.0 * sinh * sinh);
        let more = complex_sines(
            &self.to_plane,
            DVec2::new(sin * cosh, cos * sinh),
            DVec2::new(cos * cosh, -sin * sinh),
        );
        let (north, east) = (xi + more.x, eta + more.y);
        if east.abs() <= FARTHEST {
            Ok(DVec2::new(east, north) * self.radius + self.shift)
        } else {
            Err(ProjectionError::Outside)
        }
    }

    /// From the plane `[m]` to longitude and latitude `[rad]`; the longitude may lie beyond ±π.
    pub(crate) fn inverse(&self, point: DVec2) -> Result<(f64, f64), ProjectionError> {
        let unit = (point - self.shift) / self.radius;
        let (east, north) = (unit.x, unit.y);
        if !(-FARTHEST..=FARTHEST).contains(&east) {
            return Err(ProjectionError::Outside);
        }
        let (sin, cos) = libm::sincos(2.0 * north);
        let half = libm::sinh(east);
        let (sinh, cosh) = (2.0 * half * (1.0 + half * half).sqrt(), 1.0 + 2.0 * half * half);
        let more = complex_sines(
            &self.from_plane,
            DVec2::new(sin * cosh, cos * sinh),
            DVec2::new(cos * cosh, -sin * sinh),
        );
        let (sin, cos) = libm::sincos(north + more.x);
        let sinh = libm::sinh(east + more.y);
        let across = (sinh * sinh + cos * cos).sqrt();
        let length = (1.0 + sinh * sinh).sqrt();
        let (sin_lat, cos_lat) = (sin / length, across / length);
        let conformal = libm::atan2(sin, across);
        let (sin, cosine) = (2.0 * sin_lat * cos_lat, 1.0 - 2.0 * sin_lat * sin_lat);
        let latitude = conformal + sines(&self.from_conformal, sin, cosine);
        Ok((self.longitude + libm::atan2(sinh, cos), latitude))
    }
}
