//! Parts of a map that have errors are left out, and the map remembers where.
//!
//! A document is read once. Where errors are found, the smallest parts that hold them are named, and it is read again without
//! them, until nothing more is wrong: what refers to a part that is gone is then seen as it will be. So nothing is ever
//! taken back from tables, and a document without errors costs nothing.

mod cause;
mod exclusions;
mod policy;
mod units;

pub(crate) use cause::{Cause, is_outside};
pub(crate) use exclusions::Exclusions;
pub use policy::{OnError, Policy};
pub use units::PartKind;
pub(crate) use units::{Unit, Units};

use std::sync::Arc;

/// How a part with errors is treated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Treatment {
    /// It is not in the map.
    Dropped,
    /// A road is in the map as its reference line alone: no lanes, no links, nothing along it.
    ReferenceLine,
}

/// A part that is not in the map as the document has it.
#[derive(Clone, Debug, PartialEq)]
pub struct QuarantinedPart {
    /// What it is.
    pub kind: PartKind,
    /// Its id; of a lane link that of its connection and the lanes that it names, as in `0:-1:-2`.
    pub id: String,
    /// Id of the road or junction that it belongs to; its own for a road or junction.
    pub owner: String,
    /// What that is; its own kind for a part of its own.
    pub owner_kind: PartKind,
    /// What became of it.
    pub treatment: Treatment,
    /// Smallest x, smallest y, largest x, largest y `[m]`, where it could be told.
    pub extent: Option<[f64; 4]>,
    /// Length of a road `[m]`; 0 for other parts.
    pub length: f64,
    /// Rule whose finding is the reason.
    pub rule: &'static str,
    /// What the finding says.
    pub message: String,
    /// Line of the finding, from 1.
    pub line: u32,
    /// Column of the finding in bytes, from 1.
    pub column: u32,
    /// The included file that the finding stands in; empty for the document itself.
    pub file: Arc<str>,
    /// The objects and signals that are missing with a road or junction.
    pub contents: Vec<QuarantinedContent>,
}

/// An object or signal that is missing because the part that it belongs to is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct QuarantinedContent {
    /// What it is.
    pub kind: PartKind,
    /// Its id as written.
    pub id: String,
}

impl QuarantinedPart {
    /// What it is called in messages: `object 12 of road 7`.
    pub fn name(&self) -> String {
        let (kind, owner_kind) = (self.kind.name(), self.owner_kind.name());
        match self.owner_kind == self.kind {
            true => format!("{kind} {}", self.id),
            false => format!("{kind} {} of {owner_kind} {}", self.id, self.owner),
        }
    }
}
