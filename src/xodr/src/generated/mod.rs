//! The document's types, the schema and the reader that follow from the table.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive; change those files instead.

#![allow(clippy::single_match, reason = "elements differ in how many attributes they have")]

mod additional_data;
mod controller;
mod document;
mod header;
mod junction;
mod lanes;
mod object_outlines;
mod objects;
mod plan_view;
mod profiles;
mod railroad;
mod read_additional_data;
mod read_controller;
pub(crate) mod read_document;
mod read_header;
mod read_junction;
mod read_lanes;
mod read_object_outlines;
mod read_objects;
mod read_plan_view;
mod read_profiles;
mod read_railroad;
mod read_road;
mod read_road_mark;
mod read_semantics;
mod read_signals;
mod road;
mod road_mark;
pub(crate) mod schema_additional_data;
pub(crate) mod schema_controller;
pub(crate) mod schema_document;
pub(crate) mod schema_header;
pub(crate) mod schema_junction;
pub(crate) mod schema_lanes;
pub(crate) mod schema_object_outlines;
pub(crate) mod schema_objects;
pub(crate) mod schema_plan_view;
pub(crate) mod schema_profiles;
pub(crate) mod schema_railroad;
pub(crate) mod schema_road;
pub(crate) mod schema_road_mark;
pub(crate) mod schema_semantics;
pub(crate) mod schema_signals;
pub(crate) mod schema_words;
mod semantics;
mod signals;
mod words;

pub use additional_data::*;
pub use controller::*;
pub use document::*;
pub use header::*;
pub use junction::*;
pub use lanes::*;
pub use object_outlines::*;
pub use objects::*;
pub use plan_view::*;
pub use profiles::*;
pub use railroad::*;
pub use road::*;
pub use road_mark::*;
pub use semantics::*;
pub use signals::*;
pub use words::*;
