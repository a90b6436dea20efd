//! A projection that is ready for use.

use crate::datum::Shift;
use crate::ellipsoid::GeodeticRadians;
use crate::offset::Offset;
use crate::plane::Plane;
use crate::values;
use glam::DVec3;
use std::f64::consts::{PI, TAU};
use thiserror::Error;

/// Words of definitions that want grid files, in lower case: the parameter, and the one named datum that is given by grids.
const GRIDS: [&str; 2] = ["nadgrids", "nad27"];

/// Steps along a meridian to either side of a point `[deg]`: 11 m, so that rounding of coordinates turns it by 1e-10 rad at most.
const NORTH_STEP: f64 = 1e-4;

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

/// Why a definition cannot be used.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum DefinitionError {
    /// There is no definition: the map has no georeference, or the compiler could not use it.
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
#[non_exhaustive]
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
#[derive(Clone, Debug)]
pub struct Projector {
    plane: Plane,
    shift: Option<Shift>,
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
        values::check(definition).map_err(unusable)?;
        let (plane, ellipsoid) = Plane::read(definition).map_err(unusable)?;
        let shift = Shift::read(definition, ellipsoid).map_err(unusable)?;
        Ok(Self { plane, shift, offset })
    }

    /// Whether the same bits come out on every machine: true for transverse Mercator projections (UTM too) and topocentric
    /// frames; the others' functions are those of the C library, whose last digits differ.
    pub fn is_reproducible(&self) -> bool {
        self.plane.is_reproducible()
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
        let (longitude, latitude) = self.plane.inverse(plane.truncate())?;
        let height = self.plane.height(plane.z);
        let mut place = GeodeticRadians { longitude, latitude, height };
        if let Some(shift) = self.shift {
            place = shift.to_wgs84(place);
        }
        let place = Geodetic {
            latitude: place.latitude.to_degrees(),
            longitude: wrapped(place.longitude).to_degrees(),
            altitude: place.height,
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
        let (longitude, latitude) = (longitude.to_radians(), latitude.to_radians());
        let mut place = GeodeticRadians { longitude, latitude, height: altitude };
        if let Some(shift) = self.shift {
            place = shift.of_wgs84(place);
        }
        let plane = self.plane.forward(place.longitude, place.latitude)?;
        let z = self.plane.above(place.height);
        let point = self.offset.invert(plane.extend(z));
        if point.is_finite() { Ok(point) } else { Err(ProjectionError::Outside) }
    }

    /// Heading of true north at a point of the map `[rad]`, counter-clockwise from x, in (−π, π]: the meridian's direction. A
    /// heading that a receiver gives clockwise from true north is this minus that one. The grid's convergence, how far grid north
    /// lies clockwise from true north, is this minus π/2 where the header's offset does not turn the map.
    ///
    /// Errors: as [`Self::to_geodetic`]; places so near a pole that no meridian passes through them.
    pub fn north_at(&self, point: DVec3) -> Result<f64, ProjectionError> {
        let place = self.to_geodetic(point)?;
        let beside =
            |by: f64| self.from_geodetic(Geodetic { latitude: place.latitude + by, ..place });
        // A meridian's bend counts on both sides alike.
        let along = beside(NORTH_STEP)? - beside(-NORTH_STEP)?;
        Ok(libm::atan2(along.y, along.x))
    }

    /// As [`Self::north_at`] for many points; `out` gets one answer for each.
    pub fn north_at_batch(&self, points: &[DVec3], out: &mut Vec<Result<f64, ProjectionError>>) {
        out.clear();
        out.extend(points.iter().map(|point| self.north_at(*point)));
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

/// A longitude `[rad]` within −π to π; those that are there already stay as they are.
fn wrapped(longitude: f64) -> f64 {
    if longitude.abs() <= PI { longitude } else { longitude - TAU * libm::rint(longitude / TAU) }
}
