//! From map coordinates to latitude and longitude and back.
//!
//! [`Reference::read`] (feature `read`) classifies the text of an OpenDRIVE file's `geoReference` and turns it into a
//! definition: PROJ parameters, only such as are understood, in a canonical form. A [`Projector`] is built from a
//! definition and the header's [`Offset`] once, which allocates, and then converts points without allocating.
//!
//! Invariants: no I/O (grids are refused, never looked for), no global state, no panic on any text. Deliberately absent:
//! geoids and vertical datums; altitude is the map's own z above whatever the file measures it from.
//!
//! ```
//! use mapd_geodesy::{Offset, Projector};
//!
//! let projector = Projector::new("+proj=utm +zone=32 +datum=WGS84", Offset::default()).unwrap();
//! let place = projector.to_geodetic([500_000.0, 5_320_000.0, 12.0].into()).unwrap();
//! assert_eq!(place.longitude, 9.0);
//! assert!(projector.from_geodetic(place).unwrap().distance([500_000.0, 5_320_000.0, 12.0].into()) < 1e-6);
//! ```

#[cfg(not(target_family = "wasm"))]
mod by_proj4rs;
mod datum;
mod ellipsoid;
mod enu;
mod offset;
#[cfg(feature = "read")]
mod parameters;
mod plain;
mod plane;
mod projector;
#[cfg(feature = "read")]
mod reference;
#[cfg(feature = "read")]
mod target;
mod topocentric;
mod transverse_mercator;
mod utm;
mod values;
#[cfg(feature = "read")]
mod warning;

pub use enu::EnuFrame;
pub use glam;
pub use offset::Offset;
pub use projector::{DefinitionError, Geodetic, ProjectionError, Projector};
#[cfg(feature = "read")]
pub use reference::{Form, Reference, ReferenceError};
#[cfg(feature = "read")]
pub use target::{Target, TargetError};
pub use utm::UtmZone;
#[cfg(feature = "read")]
pub use warning::DefinitionWarning;
