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

mod attribute;
mod checks;
mod cursor;
mod element;
mod extension;
mod finding;
mod findings;
mod generated;
mod limits;
mod markup;
mod notes;
mod other;
mod reader;
mod reading;
pub mod rule_ids;
mod schema;
pub mod source;
pub mod values;
mod variants;
pub mod well_formed;
mod window;

pub use attribute::{Attribute, PositionOrEnd, SpeedLimit};
pub use extension::{Extension, ExtensionKind, Extensions};
pub use finding::{Finding, Severity, Span};
pub use generated::*;
pub use limits::Limits;
pub use reader::Reader;
pub use source::{LineIndex, Position};
