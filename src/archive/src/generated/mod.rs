//! Code written from `schemas/archive.toml` and `schemas/ontology`.

mod beside_accessors;
pub(crate) mod classes;
mod network_accessors;
pub(crate) mod rows;
pub(crate) mod tables;
