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

mod document;
mod entry;
mod pieces;
mod places;
mod resolve;
mod time;

pub use document::{Document, DocumentError, Limits};
pub use entry::{Entry, Kind, LanePlace, RoadId, Weekly};
pub use resolve::{Policy, Resolved, Unplaced, resolve};
pub use time::Moment;
