//! Code written from `schemas/archive.toml` and `schemas/ontology`.

mod beside_accessors;
pub(crate) mod classes;
mod network_accessors;
pub(crate) mod rows;
mod signal_accessors;
pub(crate) mod signal_rows;
pub(crate) mod tables;
mod verify_rows;
