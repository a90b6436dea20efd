//! The schema of `controller`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/controller.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static CONTROLLER: ElementSchema = ElementSchema::new(
    "Controller",
    &[
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("name", Kind::Text),
        attribute("sequence", Kind::Uint),
    ],
    &[child("control", &CONTROL, 1).occurs(1, MANY, from(V1_4))],
)
.key(0)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static CONTROL: ElementSchema = ElementSchema::new(
    "Control",
    &[attribute("signalId", Kind::Text).required(from(V1_5)), attribute("type", Kind::Text)],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);
