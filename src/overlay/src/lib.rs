//! Today's road over a compiled map: what is said about lanes, read from JSON and resolved against the map that is served.
//!
//! ```text
//!  JSON ── read ──► Document ── resolve ──► OverlayRows ── encode ──► an overlay: mapd_query::view::View
//!          refused whole,       against one map; what does not fit is named
//!          with its place
//! ```
//!
//! Invariants: a document keeps what it was given, in the terms in which it was given; resolving changes nothing in it. Everything is bounded by
//! [`Limits`]. No I/O, no clock: moments are the caller's. Deliberately absent: publishing, which is the daemon's.

mod depth;
mod document;
mod entry;
mod line;
mod on_earth;
mod pieces;
mod place;
mod placements;
mod places;
mod resolve;
mod time;
mod wzdx;

pub use document::{Document, DocumentError, Limits};
pub use entry::{Entry, Kind, Weekly};
pub use place::{Across, AcrossWord, EarthPlace, LaneStretch, RoadId, WIDEST_TOLERANCE};
pub use placements::{EntryLocation, LocatedStretch, Placements};
pub use places::PlaceError;
pub use resolve::{Policy, Resolved, Unplaced, resolve};
pub use time::Moment;
pub use wzdx::{Feed, FeedFinding, WZDX_TOLERANCE, is_feed, read_feed};
