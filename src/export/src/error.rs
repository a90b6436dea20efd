//! Why a map cannot be written.

use mapd_client::QueryError;
#[cfg(any(feature = "flatgeobuf", feature = "geojson", feature = "lanelet2"))]
use mapd_client::geodesy::{DefinitionError, ProjectionError};
#[cfg(feature = "svg")]
use mapd_client::path::PathError;
#[cfg(feature = "svg")]
use mapd_client::route::RouteError;
use std::io;

/// Why a map cannot be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The format has latitudes and longitudes, and the map has no georeference that can be used.
    #[cfg(any(feature = "flatgeobuf", feature = "geojson", feature = "lanelet2"))]
    #[error(
        "this format needs latitudes and longitudes: add the map's projection as PROJ parameters, such as +proj=utm +zone=32 +datum=WGS84, \
         to header/geoReference of the OpenDRIVE file, or say with --origin LAT,LON where the map's point 0, 0 is to lie"
    )]
    NoGeoreference(#[source] DefinitionError),
    /// An origin is given for a map that has a georeference, which is this one.
    #[error("the map has a georeference ({0}): --origin is for maps without one")]
    TwoGeoreferences(String),
    /// The map's projection has no latitude and longitude for one of its points.
    #[cfg(any(feature = "flatgeobuf", feature = "geojson", feature = "lanelet2"))]
    #[error("the point x {x} m, y {y} m has no latitude and longitude")]
    OffEarth {
        /// Inertial `[m]`.
        x: f64,
        /// Inertial `[m]`.
        y: f64,
        /// What the projection says.
        source: ProjectionError,
    },
    /// The route that is to be drawn is none: why.
    #[error("{0}")]
    NoRoute(String),
    /// The route cannot be asked for, as on a damaged archive.
    #[cfg(feature = "svg")]
    #[error(transparent)]
    Route(#[from] RouteError),
    /// The route has no path, as on a damaged archive.
    #[cfg(feature = "svg")]
    #[error(transparent)]
    Path(#[from] PathError),
    /// A query cannot be answered, as on a damaged archive.
    #[error(transparent)]
    Query(#[from] QueryError),
    /// A feature cannot be encoded.
    #[error("{0}")]
    Encoding(String),
    /// What writing gives.
    #[error(transparent)]
    Io(#[from] io::Error),
}

/// What writing a map gives.
pub type Result<T, E = ExportError> = std::result::Result<T, E>;
