//! Elements of `document`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/document.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;

/// A top-level element.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// `header`.
    Header(Box<Header>),
    /// `road`.
    Road(Box<Road>),
    /// `controller`.
    Controller(Box<Controller>),
    /// `junction`.
    Junction(Box<Junction>),
    /// `junctionGroup`.
    JunctionGroup(Box<JunctionGroup>),
    /// `station`.
    Station(Box<Station>),
    /// `vmsGroup`.
    VmsGroup(Box<VmsGroup>),
}
