//! Projections by proj4rs, and definitions that only it reads.

use crate::ellipsoid::Ellipsoid;
use crate::plane::Plane;
use crate::projector::ProjectionError;
use crate::transverse_mercator::TransverseMercator;
use glam::DVec2;
use proj4rs::Proj;
use proj4rs::transform::transform;

/// Distance `[m]` from a point that its place on Earth may have when it is projected again; a tenth of a micrometre is far
/// below what coordinates of any survey mean, and above what double precision leaves at 10,000 km.
const RESIDUAL: f64 = 1e-7;
/// Distance `[m]` from which one correction certainly reaches [`RESIDUAL`], so that it need not be looked at again.
const SMALL: f64 = 1e-4;
/// Largest number of corrections towards [`RESIDUAL`]; one is enough wherever one is needed at all.
const REFINEMENTS: usize = 3;

/// Step of a derivative `[rad]`, 6 m: what it neglects is a millionth of a correction.
const PROBE: f64 = 1e-6;
/// Sine of the angle between the images of east and north below which they do not span the plane.
const SLANTED: f64 = 0.01;
/// Names of conformal projections, of which one derivative tells the other.
const CONFORMAL: [&str; 5] = ["merc", "lcc", "stere", "sterea", "somerc"];
/// Names of projections whose inverse needs no correction: geodesics are solved to nanometres.
const EXACT: [&str; 1] = ["aeqd"];

/// Names of projections that are of a sphere with the surface of the ellipsoid (PROJ's reference systems have it so); other
/// spheres have its semi-major axis.
const AUTHALIC: [&str; 1] = ["mill"];

/// Names of the transverse Mercator projection in PROJ.
const TRANSVERSE: [&str; 3] = ["utm", "tmerc", "etmerc"];
/// Parameters that ask for another form of it, or for something that only proj4rs knows.
const OTHERWISE: [&str; 4] = ["approx", "algo", "over", "axis"];
/// Parameters of datums and ellipsoids, which are looked after elsewhere.
const DATUM: [&str; 11] = ["datum", "towgs84", "ellps", "rf", "f", "es", "e", "a", "b", "R", "R_A"];
/// A projection, and latitudes and longitudes on the ellipsoid or sphere that it computes on.
#[derive(Clone)]
pub(crate) struct Both(pub(crate) Proj, pub(crate) Proj);

/// Reads PROJ parameters, as [`Plane::read`].
pub(crate) fn read(definition: &str) -> Result<(Plane, Ellipsoid), String> {
    let words = || definition.split_whitespace().map(|word| word.trim_start_matches('+'));
    let get = |name: &str| words().find_map(|word| word.strip_prefix(name)?.strip_prefix('='));
    let build = |text: &str| Proj::from_proj_string(text).map_err(|error| error.to_string());
    let given = |name: &str| words().any(|word| word.split('=').next() == Some(name));
    // A sphere that a definition asks for is that of its datum too.
    let is_authalic = get("proj").is_some_and(|name| AUTHALIC.contains(&name))
        && !["R", "R_A"].into_iter().any(given);
    let sphere = if is_authalic { " +R_A" } else { "" };
    let whole = build(&format!("{definition}{sphere}"))?;
    if whole.is_latlong() || whole.is_geocent() {
        return Err("it has no plane in which coordinates are metres".into());
    }
    if !whole.has_inverse() || !whole.has_forward() {
        return Err("it works in one direction only".into());
    }
    // Its own: some projections exist on a sphere only, or on one ellipsoid, whatever that of the datum is.
    let (a, b) = whole.ellipse_parameters();
    let own = Ellipsoid::new(a, b);
    let of_datum = words()
        .filter(|word| is_of_datum(word))
        .fold(String::from("+proj=longlat"), |text, word| text + " +" + word);
    let (a_of_datum, b_of_datum) = build(&of_datum)?.ellipse_parameters();
    let ellipsoid = Ellipsoid::new(a_of_datum, b_of_datum);
    let is_otherwise =
        words().any(|word| OTHERWISE.contains(&word.split('=').next().unwrap_or(word)));
    if TRANSVERSE.contains(&whole.projname()) && a != b && !is_otherwise {
        let origin = (whole.latitude_of_origin(), whole.longitude_of_origin());
        let false_origin = DVec2::new(whole.false_easting(), whole.false_northing());
        let scale = whole.scaling_factor();
        let projection = TransverseMercator::new(own, origin, scale, false_origin);
        return Ok((Plane::Transverse(projection, whole.from_greenwich()), ellipsoid));
    }
    // Without its datum, which is shifted elsewhere.
    let plain: String =
        words().filter(|word| !is_of_datum(word)).map(|word| format!("+{word} ")).collect();
    let plane = build(&format!("{plain}+a={a} +b={b}"))?;
    let earth = build(&format!("+proj=longlat +a={a} +b={b}"))?;
    Ok((Plane::Other(Box::new(Both(plane, earth))), ellipsoid))
}

impl Both {
    /// As [`Plane::inverse`].
    pub(crate) fn inverse(&self, plane: DVec2) -> Result<(f64, f64), ProjectionError> {
        refined(self, plane)
    }

    /// As [`Plane::forward`].
    pub(crate) fn forward(&self, longitude: f64, latitude: f64) -> Result<DVec2, ProjectionError> {
        project(self, longitude, latitude)
    }
}

/// Whether a parameter is one of the datum's or ellipsoid's.
fn is_of_datum(word: &str) -> bool {
    DATUM.contains(&word.split('=').next().unwrap_or(word))
}

/// The inverse of some projections stops some micrometres early; the way there is exact.
fn refined(both: &Both, plane: DVec2) -> Result<(f64, f64), ProjectionError> {
    let mut aim = plane;
    let mut place = unproject(both, aim)?;
    if EXACT.contains(&both.0.projname()) {
        return Ok(place);
    }
    for _ in 0..REFINEMENTS {
        let there = project(both, place.0, place.1)?;
        let missed = plane - there;
        let most = missed.abs().max_element();
        if most <= RESIDUAL {
            break;
        }
        if most <= SMALL
            && let Some(better) = step(both, place, there, missed)
        {
            return Ok(better);
        }
        aim += missed;
        place = unproject(both, aim)?;
        if most <= SMALL {
            break;
        }
    }
    Ok(place)
}

/// One of Newton's steps towards a point that a place misses; none where the projection has no two directions, as at a pole.
fn step(
    both: &Both,
    (longitude, latitude): (f64, f64),
    there: DVec2,
    missed: DVec2,
) -> Option<(f64, f64)> {
    let north = (project(both, longitude, latitude - PROBE).ok()? - there) / -PROBE;
    let east = if CONFORMAL.contains(&both.0.projname()) {
        // As long as on the ellipsoid in relation to the way north, and square to it.
        let (a, b) = both.1.ellipse_parameters();
        let e2 = 1.0 - (b / a) * (b / a);
        let (sin, cos) = libm::sincos(latitude);
        north.perp() * -(cos * (1.0 - e2 * sin * sin) / (1.0 - e2))
    } else {
        (project(both, longitude + PROBE, latitude).ok()? - there) / PROBE
    };
    let area = east.perp_dot(north);
    if area.abs() <= SLANTED * east.length() * north.length() {
        return None;
    }
    Some((longitude + missed.perp_dot(north) / area, latitude + east.perp_dot(missed) / area))
}

fn unproject(Both(plane, earth): &Both, point: DVec2) -> Result<(f64, f64), ProjectionError> {
    let unit = plane.to_meter();
    let mut place = (point.x / unit, point.y / unit, 0.0);
    transform(plane, earth, &mut place).map_err(|_| ProjectionError::Outside)?;
    Ok((place.0, place.1))
}

fn project(
    Both(plane, earth): &Both,
    longitude: f64,
    latitude: f64,
) -> Result<DVec2, ProjectionError> {
    let mut place = (longitude, latitude, 0.0);
    transform(earth, plane, &mut place).map_err(|_| ProjectionError::Outside)?;
    let unit = plane.to_meter();
    Ok(DVec2::new(place.0 * unit, place.1 * unit))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plain;

    #[test]
    fn plain_definitions_are_read_as_proj4rs_reads_them() {
        for definition in [
            "+proj=utm +zone=32 +datum=WGS84",
            "+proj=utm +zone=56 +south +ellps=GRS80 +towgs84=0,0,0,0,0,0,0 +units=m +no_defs",
            "+proj=tmerc +lat_0=48 +lon_0=11 +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs",
            "+proj=tmerc +lat_0=-33.8688 +lon_0=151.2093 +k_0=0.9996 +x_0=1000.5 +y_0=-20 +ellps=GRS80",
            "+proj=etmerc +lon_0=9 +k=1.00001 +x_0=3500000 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7",
        ] {
            let (plain, ellipsoid) = plain::transverse(definition).expect("plain");
            let (plane, expected) = read(definition).expect("a projection");
            assert_eq!(ellipsoid, expected, "{definition}");
            let Plane::Transverse(projection, 0.0) = plane else { panic!("{definition}") };
            assert_eq!(format!("{plain:?}"), format!("{projection:?}"), "{definition}");
        }
        for definition in [
            "+proj=utm +datum=WGS84",
            "+proj=tmerc +lat_0=48d30' +lon_0=11 +datum=WGS84",
            "+proj=tmerc +lon_0=11 +lon_0=12 +datum=WGS84",
            "+proj=tmerc +lon_0=11 +datum=NAD83",
            "+proj=merc +datum=WGS84",
            "+proj=tmerc +lon_0=11 +datum=WGS84 +pm=paris",
            "+proj=tmerc +lon_0=11",
        ] {
            assert!(plain::transverse(definition).is_none(), "{definition}");
        }
    }
}
