//! Code written from `schemas/archive.toml`.

mod accessors;
pub(crate) mod rows;
pub(crate) mod tables;
