//! Reads ASAM OpenDRIVE 1.4 to 1.9 as written, as a stream, with a source position on everything.
//!
//! [`Reader`] yields one top-level element at a time: header, road, junction and the rest. What is wrong with the document
//! comes back as [`Finding`]s; `Err` is for the environment. The types of elements, the reader and the structural checks
//! follow from one table, `schemas/opendrive`.
//!
//! Invariants: nothing is interpreted; one top-level element is in memory at a time; no input makes it panic, and none
//! makes it stop at the first error where reading on makes sense. Deliberately absent: geometry, links, checks of meaning.
//!
//! ```
//! use mapd_xodr::{Item, Limits, Reader, Text};
//!
//! let text = r#"<OpenDRIVE><header revMajor="1" revMinor="7" name="tiny"/></OpenDRIVE>"#;
//! let mut reader = Reader::new(text.as_bytes(), Limits::default());
//! match reader.next().unwrap() {
//!     Some(Item::Header(header)) => assert_eq!(header.name.text(), "tiny"),
//!     other => panic!("expected a header, found {other:?}"),
//! }
//! assert!(reader.next().unwrap().is_none());
//! ```

mod attribute;
mod batch;
mod checks;
mod counted;
mod cursor;
mod element;
mod extension;
mod finding;
mod findings;
mod generated;
mod layers;
mod limits;
mod markup;
mod notes;
mod other;
mod patch;
mod reader;
mod reading;
mod record;
pub mod rule_ids;
mod same;
mod schema;
pub mod source;
pub mod values;
mod variants;
pub mod well_formed;
mod window;
mod written;

pub use attribute::{Attribute, PositionOrEnd, SpeedLimit, Text, Value};
pub use batch::{Batch, Context, Cutter, ReadBatch, RestOfDocument};
pub use counted::{CountedFinding, CountedFindings};
pub use extension::{Extension, ExtensionElement, ExtensionKind, Extensions};
pub use finding::{Finding, Severity, Span, shorten_id, shorten_message};
pub use generated::*;
pub use limits::Limits;
pub use patch::{LONGEST_PATCH, Patch, PatchError, PatchedId, PatchedKind};
pub use reader::{Delivered, Reader};
pub use record::CubicRecord;
pub use source::{LineIndex, Position};
pub use written::{Keep, Shown, Visit, Written};
