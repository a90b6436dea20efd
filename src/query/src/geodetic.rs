//! Places on Earth (feature `geodesy`).

use crate::error::QueryError;
use crate::extents::HeaderOffset;
use crate::map::Map;
use crate::nearest::{Nearest, NearestOptions};
use crate::types::Point;
use glam::DVec3;
use mapd_geodesy::{DefinitionError, Geodetic, Offset, ProjectionError, Projector};
use thiserror::Error;

/// Why a question about a place on Earth has no answer.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum GeodeticError {
    /// The place has no point in the map's frame.
    #[error(transparent)]
    Projection(#[from] ProjectionError),
    /// The point has no answer.
    #[error(transparent)]
    Query(#[from] QueryError),
}

/// A point on Earth, by the map's datum (WGS 84 for most maps).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct GeodeticPoint {
    /// Latitude `[deg]`, positive to the north.
    pub latitude: f64,
    /// Longitude `[deg]`, positive to the east.
    pub longitude: f64,
    /// Altitude `[m]`, as [`Geodetic::altitude`]; it tells levels apart. `None` if it is not known.
    pub altitude: Option<f64>,
}

impl<'a> Map<'a> {
    /// What converts between this map's inertial frame and WGS 84. Building it allocates; converting does not.
    ///
    /// ```
    /// # use mapd_query::Map;
    /// # use mapd_query::geodesy::Geodetic;
    /// fn place(map: Map<'_>, x: f64, y: f64) -> Result<Geodetic, Box<dyn std::error::Error>> {
    ///     let projector = map.projector()?; // once
    ///     Ok(projector.to_geodetic([x, y, 0.0].into())?)
    /// }
    /// ```
    ///
    /// Errors: the map has no georeference that can be used.
    pub fn projector(&self) -> Result<Projector, DefinitionError> {
        let HeaderOffset { shift, heading } = self.header_offset();
        Projector::new(self.projection(), Offset { shift, heading })
    }

    /// What converts between the file's own frame and WGS 84, of a map that was compiled into another frame; else the same
    /// as [`Map::projector`]. A point of the file and that of the map at one place on Earth are one: through both projectors
    /// either becomes the other.
    ///
    /// Errors: the map has no georeference that can be used.
    pub fn file_projector(&self) -> Result<Projector, DefinitionError> {
        let Some(frame) = self.file_frame() else { return self.projector() };
        let HeaderOffset { shift, heading } = frame.offset();
        Projector::new(frame.projection(), Offset { shift, heading })
    }

    /// As [`Map::nearest_lane`], from a point on Earth, through a projector of this map.
    ///
    /// Errors: the place is not finite or outside the projection's area; options that are not finite.
    pub fn nearest_lane_geodetic(
        &self,
        projector: &Projector,
        at: GeodeticPoint,
        options: &NearestOptions,
    ) -> Result<Option<Nearest>, GeodeticError> {
        let GeodeticPoint { latitude, longitude, altitude } = at;
        let place = Geodetic { latitude, longitude, altitude: altitude.unwrap_or(0.0) };
        let point: DVec3 = projector.from_geodetic(place)?;
        let point = Point { xy: point.truncate(), z: altitude.map(|_| point.z) };
        Ok(self.nearest_lane(point, options)?)
    }
}
