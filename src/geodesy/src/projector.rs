//! A projection that is ready for use.

use crate::offset::Offset;
use glam::DVec3;
use proj4rs::Proj;
use proj4rs::transform::transform;
use thiserror::Error;

/// What latitudes and longitudes are given in.
const WGS84: &str = "+proj=longlat +datum=WGS84 +no_defs";

/// Words of definitions that want grid files, in lower case: the parameter, and the one named datum that is given by grids.
const GRIDS: [&str; 2] = ["nadgrids", "nad27"];

/// Distance `[m]` from a point that its place on Earth may have when it is projected again; a tenth of a micrometre is far
/// below what coordinates of any survey mean, and above what double precision leaves at 10,000 km.
const RESIDUAL: f64 = 1e-7;
/// Distance `[m]` from which one correction certainly reaches [`RESIDUAL`], so that it need not be looked at again.
const SMALL: f64 = 1e-4;
/// Largest number of corrections towards [`RESIDUAL`]; one is enough wherever one is needed at all.
const REFINEMENTS: usize = 3;

/// A place on Earth, on the ellipsoid of WGS 84.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Geodetic {
    /// Latitude `[deg]`, positive to the north.
    pub latitude: f64,
    /// Longitude `[deg]`, positive to the east, −180 to 180.
    pub longitude: f64,
    /// Altitude `[m]`: the map's z with the header's offset, and where the datum is shifted, with that shift. No geoid is
    /// applied: it is above the ellipsoid only where the map's z is.
    pub altitude: f64,
}

/// Why a definition is of no use.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum DefinitionError {
    /// There is none: the map has no georeference, or one that was found to be of no use when it was compiled.
    #[error("the map has no georeference that can be used")]
    None,
    /// It is not understood.
    #[error("the projection {definition:?} cannot be used: {reason}")]
    Unusable {
        /// The definition.
        definition: String,
        /// What is wrong with it.
        reason: String,
    },
}

/// Why a point has no counterpart.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum ProjectionError {
    /// A coordinate is not finite.
    #[error("expected finite coordinates")]
    NotFinite,
    /// A latitude or longitude that there is not.
    #[error("expected a latitude of −90 to 90 and a longitude of −360 to 360 degrees")]
    OutOfRange,
    /// The projection does not reach so far.
    #[error("the place lies outside the area of the map's projection")]
    Outside,
}

/// Converts between a map's inertial frame and WGS 84. Built once; converting allocates nothing.
#[derive(Clone)]
pub struct Projector {
    plane: Proj,
    earth: Proj,
    offset: Offset,
}

impl Projector {
    /// Builds a projector from PROJ parameters, such as `+proj=utm +zone=32 +datum=WGS84`, and the header's offset.
    /// Coordinates of the plane are metres whatever the unit of the definition is, as OpenDRIVE wants them.
    ///
    /// Errors: there is no definition, or it is not understood.
    pub fn new(definition: &str, offset: Offset) -> Result<Self, DefinitionError> {
        if definition.is_empty() {
            return Err(DefinitionError::None);
        }
        let unusable = |reason: String| DefinitionError::Unusable {
            definition: definition.to_owned(),
            reason,
        };
        // proj4rs would look for files.
        let lower = definition.to_ascii_lowercase();
        if GRIDS.iter().any(|grid| lower.contains(grid)) {
            return Err(unusable("it wants a grid file".into()));
        }
        let build = |text: &str| Proj::from_proj_string(text).map_err(|e| unusable(e.to_string()));
        let (plane, earth) = (build(definition)?, build(WGS84)?);
        if plane.is_latlong() || plane.is_geocent() {
            return Err(unusable("it has no plane in which coordinates are metres".into()));
        }
        if !plane.has_inverse() || !plane.has_forward() {
            return Err(unusable("it works in one direction only".into()));
        }
        Ok(Self { plane, earth, offset })
    }

    /// The header's offset.
    pub fn offset(&self) -> Offset {
        self.offset
    }

    /// Where a point of the map (inertial, `[m]`) lies on Earth.
    ///
    /// Errors: it is not finite, or lies outside the projection's area.
    pub fn to_geodetic(&self, point: DVec3) -> Result<Geodetic, ProjectionError> {
        if !point.is_finite() {
            return Err(ProjectionError::NotFinite);
        }
        let plane = self.offset.apply(point);
        let mut aim = plane;
        let mut place = self.earth_of(aim)?;
        for _ in 0..REFINEMENTS {
            // The inverse of some projections stops some micrometres early; the way there is exact.
            let missed = plane - self.plane_of(place)?;
            let most = missed.abs().max_element();
            if most <= RESIDUAL {
                break;
            }
            aim += missed;
            place = self.earth_of(aim)?;
            if most <= SMALL {
                break;
            }
        }
        let place = Geodetic {
            latitude: place.1.to_degrees(),
            longitude: place.0.to_degrees(),
            altitude: place.2,
        };
        let sound = place.latitude.abs() <= 90.0 && place.longitude.abs() <= 360.0;
        if sound && place.altitude.is_finite() { Ok(place) } else { Err(ProjectionError::Outside) }
    }

    /// The point of the map (inertial, `[m]`) at a place on Earth.
    ///
    /// Errors: it is not finite or no place on Earth, or lies outside the projection's area.
    pub fn from_geodetic(&self, place: Geodetic) -> Result<DVec3, ProjectionError> {
        let Geodetic { latitude, longitude, altitude } = place;
        if !(latitude.is_finite() && longitude.is_finite() && altitude.is_finite()) {
            return Err(ProjectionError::NotFinite);
        }
        if latitude.abs() > 90.0 || longitude.abs() > 360.0 {
            return Err(ProjectionError::OutOfRange);
        }
        let plane = self.plane_of((longitude.to_radians(), latitude.to_radians(), altitude))?;
        let point = self.offset.invert(plane);
        if point.is_finite() { Ok(point) } else { Err(ProjectionError::Outside) }
    }

    /// Longitude and latitude `[rad]` and altitude of a point of the plane `[m]`.
    fn earth_of(&self, plane: DVec3) -> Result<(f64, f64, f64), ProjectionError> {
        let unit = self.plane.to_meter();
        let mut place = (plane.x / unit, plane.y / unit, plane.z);
        transform(&self.plane, &self.earth, &mut place).map_err(|_| ProjectionError::Outside)?;
        Ok(place)
    }

    /// The point of the plane `[m]` at a longitude and latitude `[rad]` and altitude.
    fn plane_of(&self, mut place: (f64, f64, f64)) -> Result<DVec3, ProjectionError> {
        transform(&self.earth, &self.plane, &mut place).map_err(|_| ProjectionError::Outside)?;
        let unit = self.plane.to_meter();
        Ok(DVec3::new(place.0 * unit, place.1 * unit, place.2))
    }

    /// As [`Self::to_geodetic`] for many points; `out` gets one answer for each.
    pub fn to_geodetic_batch(
        &self,
        points: &[DVec3],
        out: &mut Vec<Result<Geodetic, ProjectionError>>,
    ) {
        out.clear();
        out.extend(points.iter().map(|point| self.to_geodetic(*point)));
    }

    /// As [`Self::from_geodetic`] for many places; `out` gets one answer for each.
    pub fn from_geodetic_batch(
        &self,
        places: &[Geodetic],
        out: &mut Vec<Result<DVec3, ProjectionError>>,
    ) {
        out.clear();
        out.extend(places.iter().map(|place| self.from_geodetic(*place)));
    }
}

impl std::fmt::Debug for Projector {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let name = self.plane.projname();
        f.debug_struct("Projector")
            .field("projection", &name)
            .field("offset", &self.offset)
            .finish()
    }
}
