//! Code written from `schemas/archive.toml`.

mod beside_accessors;
mod network_accessors;
pub(crate) mod rows;
pub(crate) mod tables;
