//! Code written from `schemas/archive.toml` and `schemas/ontology`.

mod annotation_accessors;
pub(crate) mod annotation_rows;
pub(crate) mod append;
mod beside_accessors;
pub(crate) mod beside_rows;
pub(crate) mod classes;
mod index_accessors;
pub(crate) mod index_rows;
pub(crate) mod known_tables;
mod move_rows;
mod network_accessors;
pub(crate) mod network_rows;
mod object_accessors;
pub(crate) mod object_rows;
mod overlay_accessors;
pub(crate) mod overlay_rows;
pub(crate) mod overlay_tables;
pub(crate) mod road_rules;
pub(crate) mod rows;
mod signal_accessors;
pub(crate) mod signal_rows;
pub(crate) mod tables;
mod unknown_codes;
mod verify_rows;
