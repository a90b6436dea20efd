//! Shifts between datums, by three or seven parameters.
//!
//! Positions are turned as `+towgs84` has it (position vector, EPSG method 9606), about the centre of the Earth.

use crate::ellipsoid::{Ellipsoid, GeodeticRadians, WGS84};
use glam::DVec3;

/// Seconds of arc in a radian.
const SECONDS: f64 = 206_264.806_247_096_36;
/// Flattenings that differ by less are those of one ellipsoid: WGS 84 and GRS 80 differ by 1.6e-11, which is 0.1 mm.
const SAME_FLATTENING: f64 = 2.5e-11;

/// Named datums of PROJ that are given by parameters: shift `[m]`, turn `[arc seconds]`, scale `[ppm]`.
const NAMED: [(&str, [f64; 7]); 15] = [
    ("GGRS87", [-199.87, 74.79, 246.62, 0.0, 0.0, 0.0, 0.0]),
    ("potsdam", [598.1, 73.7, 418.2, 0.202, 0.045, -2.455, 6.7]),
    ("carthage", [-263.0, 6.0, 431.0, 0.0, 0.0, 0.0, 0.0]),
    ("hermannskogel", [577.326, 90.129, 463.919, 5.137, 1.474, 5.297, 2.4232]),
    ("ire65", [482.530, -130.596, 564.557, -1.042, -0.214, -0.631, 8.15]),
    ("nzgd49", [59.47, -5.04, 187.44, 0.47, -0.1, 1.024, -4.5993]),
    ("OSGB36", [446.448, -125.157, 542.060, 0.1502, 0.2470, 0.8421, -20.4894]),
    ("ch1903", [674.374, 15.056, 405.346, 0.0, 0.0, 0.0, 0.0]),
    ("osni52", [482.530, -130.596, 564.557, -1.042, -0.214, -0.631, 8.15]),
    ("rassadiran", [-133.63, -157.5, -158.62, 0.0, 0.0, 0.0, 0.0]),
    ("s_jtsk", [589.0, 76.0, 480.0, 0.0, 0.0, 0.0, 0.0]),
    ("beduaram", [-106.0, -87.0, 188.0, 0.0, 0.0, 0.0, 0.0]),
    ("gunung_segara", [-403.0, 684.0, 41.0, 0.0, 0.0, 0.0, 0.0]),
    ("rnb72", [106.869, -52.2978, 103.724, -0.33657, 0.456955, -1.84218, 1.0]),
    ("NAD83", [0.0; 7]),
];

/// How a datum's places become those of WGS 84.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shift {
    ellipsoid: Ellipsoid,
    by: DVec3,
    /// Turn about the axes `[rad]`.
    turn: DVec3,
    scale: f64,
}

impl Shift {
    /// What PROJ parameters say beside an ellipsoid; none where nothing is shifted, or the datum is not known.
    ///
    /// Errors: a shift that is not three or seven numbers, a name that is not known.
    pub(crate) fn read(definition: &str, ellipsoid: Ellipsoid) -> Result<Option<Self>, String> {
        let get = |name: &str| {
            let mut words = definition.split_whitespace().map(|word| word.trim_start_matches('+'));
            words.find_map(|word| word.strip_prefix(name)?.strip_prefix('='))
        };
        let [x, y, z, rx, ry, rz, ppm] = match (get("towgs84"), get("datum")) {
            (Some(text), _) => {
                let numbers: Result<Vec<f64>, _> =
                    text.split(',').map(|number| number.trim().parse()).collect();
                match numbers.as_deref() {
                    Ok(&[x, y, z]) => [x, y, z, 0.0, 0.0, 0.0, 0.0],
                    Ok(&[x, y, z, rx, ry, rz, ppm]) => [x, y, z, rx, ry, rz, ppm],
                    _ => return Err(format!("expected three or seven numbers in towgs84={text}")),
                }
            }
            (None, Some(name)) if name.eq_ignore_ascii_case("WGS84") => [0.0; 7],
            (None, Some(name)) => {
                let named = NAMED.iter().find(|(known, _)| known.eq_ignore_ascii_case(name));
                named.ok_or_else(|| format!("the datum {name} is not known"))?.1
            }
            (None, None) => return Ok(None),
        };
        let shift = Self {
            ellipsoid,
            by: DVec3::new(x, y, z),
            turn: DVec3::new(rx, ry, rz) / SECONDS,
            scale: 1.0 + ppm / 1e6,
        };
        let alike = ellipsoid.a == WGS84.a && (ellipsoid.f - WGS84.f).abs() < SAME_FLATTENING;
        let still = shift.by == DVec3::ZERO && shift.turn == DVec3::ZERO && ppm == 0.0;
        Ok(Some(shift).filter(|_| !(alike && still)))
    }

    /// Exactly undoes [`Self::of_wgs84`]: a = (p + r×p + (r·p)r)/(1 + r²) solves a − r×a = p.
    pub(crate) fn to_wgs84(self, place: GeodeticRadians) -> GeodeticRadians {
        let (p, r) = (self.ellipsoid.to_geocentric(place), self.turn);
        let turned = (p + r.cross(p) + r * r.dot(p)) / (1.0 + r.length_squared());
        WGS84.to_geodetic(turned * self.scale + self.by)
    }

    /// As PROJ has it: turned back by the transposed matrix, which is the inverse but for the square of the turn.
    pub(crate) fn of_wgs84(self, place: GeodeticRadians) -> GeodeticRadians {
        let aim = (WGS84.to_geocentric(place) - self.by) / self.scale;
        self.ellipsoid.to_geodetic(aim - self.turn.cross(aim))
    }
}
