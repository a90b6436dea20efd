//! Code written from `schemas/archive.toml`.

pub(crate) mod rows;
pub(crate) mod tables;
