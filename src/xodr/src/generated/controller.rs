//! Elements of `controller`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/controller.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// Signals that switch together (`t_controller`; section 14.6).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Controller {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@name`: Name for people.
    pub name: Option<Attribute<Box<str>>>,
    /// `@sequence`: Rank in a sequence.
    pub sequence: Option<Attribute<u32>>,
    /// `control`: A signal of a controller.
    pub control: Vec<Control>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A signal of a controller (`t_controller_control`; section 14.6).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Control {
    /// The start tag.
    pub span: Span,
    /// `@signalId`: Signal that is meant. Required since 1.5.
    pub signal_id: Option<Attribute<Box<str>>>,
    /// `@type`: Kind.
    pub r#type: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
