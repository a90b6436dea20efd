//! Plain transverse Mercator projections, read without proj4rs: those of nearly all maps, and all that a build for browsers has.

use crate::ellipsoid::Ellipsoid;
use crate::transverse_mercator::TransverseMercator;
use glam::DVec2;
use std::f64::consts::PI;

/// Parameters without meaning for such a projection, in metres.
const IDLE: [&str; 5] = ["units=m", "no_defs", "type=crs", "towgs84", "wktext"];
/// Ellipsoids by their names: semi-major axis `[m]` and inverse flattening, as PROJ has them.
const ELLIPSOIDS: [(&str, f64, f64); 3] = [
    ("WGS84", 6_378_137.0, 298.257_223_563),
    ("GRS80", 6_378_137.0, 298.257_222_101),
    ("bessel", 6_377_397.155, 299.152_812_8),
];
/// False easting and northing of UTM in the south `[m]`, and its scale.
pub(crate) const UTM: (f64, f64, f64) = (500_000.0, 10_000_000.0, 0.9996);

/// The projection that some PROJ parameters define, and its ellipsoid. None if they say anything that is not read here, such as angles in
/// minutes or a parameter twice.
pub(crate) fn transverse(definition: &str) -> Option<(TransverseMercator, Ellipsoid)> {
    let (mut name, mut body, mut is_south) = (None, None, false);
    let [mut latitude, mut longitude, mut scale, mut x, mut y, mut zone] = [None; 6];
    for word in definition.split_whitespace().map(|word| word.trim_start_matches('+')) {
        let (key, value) = word.split_once('=').unwrap_or((word, ""));
        if IDLE.contains(&word) || IDLE.contains(&key) {
            continue;
        }
        let place = match key {
            "proj" | "ellps" | "datum" => {
                let place = if key == "proj" { &mut name } else { &mut body };
                if place.replace(value).is_some() || key == "datum" && value != "WGS84" {
                    return None;
                }
                continue;
            }
            "south" => {
                is_south = true;
                continue;
            }
            "lat_0" => &mut latitude,
            "lon_0" => &mut longitude,
            "k" | "k_0" => &mut scale,
            "x_0" => &mut x,
            "y_0" => &mut y,
            "zone" => &mut zone,
            _ => return None,
        };
        let number = value.parse::<f64>().ok().filter(|number| number.is_finite())?;
        if place.replace(number).is_some() {
            return None;
        }
    }
    let (_, a, inverse) = ELLIPSOIDS.iter().find(|(name, ..)| Some(*name) == body)?;
    let ellipsoid = Ellipsoid::new(*a, (1.0 - 1.0 / inverse) * a);
    let (origin, scale, shift) = match (name?, zone) {
        ("tmerc" | "etmerc", None) if !is_south => {
            let [latitude, longitude] =
                [latitude, longitude].map(|angle| angle.unwrap_or(0.0).to_radians());
            let shift = DVec2::new(x.unwrap_or(0.0), y.unwrap_or(0.0));
            ((latitude, longitude), scale.unwrap_or(1.0), shift)
        }
        ("utm", Some(zone)) if [latitude, longitude, scale, x, y] == [None; 5] => {
            let (east, south, scale) = UTM;
            let north = if is_south { south } else { 0.0 };
            ((0.0, ((zone - 1.0) + 0.5) * PI / 30.0 - PI), scale, DVec2::new(east, north))
        }
        _ => return None,
    };
    Some((TransverseMercator::new(ellipsoid, origin, scale, shift), ellipsoid))
}
