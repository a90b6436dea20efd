//! Reads the common core of ASAM OpenDRIVE as written, as a stream, with a source position on everything.
//!
//! [`Reader`] yields one top-level element at a time: header, road, junction. What is wrong with the document comes back
//! as [`Finding`]s; `Err` is for the environment.
//!
//! Invariants: nothing is interpreted; one top-level element is in memory at a time; no input makes it panic, and none
//! makes it stop at the first error where reading on makes sense. Deliberately absent: geometry, links, checks of meaning.
//!
//! ```
//! use mapd_xodr::{Item, Limits, Reader};
//!
//! let text = r#"<OpenDRIVE><header revMajor="1" revMinor="7" name="tiny"/></OpenDRIVE>"#;
//! let mut reader = Reader::new(text.as_bytes(), Limits::default());
//! match reader.next().unwrap() {
//!     Some(Item::Header(header)) => assert_eq!(header.name, "tiny"),
//!     other => panic!("expected a header, found {other:?}"),
//! }
//! assert!(reader.next().unwrap().is_none());
//! ```

mod attributes;
mod cursor;
mod elements;
mod finding;
mod limits;
mod names;
mod reader;
pub mod rule_ids;
pub mod source;
mod types;
pub mod values;
pub mod well_formed;

pub use finding::{Finding, Severity, Span};
pub use limits::Limits;
pub use names::{LaneKind, RoadTypeKind};
pub use reader::{Item, Reader};
pub use source::{LineIndex, Position};
pub use types::*;
