//! The schema of `header`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/header.toml; change that file instead.

use crate::generated::schema_semantics::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static HEADER: ElementSchema = ElementSchema::new(
    "Header",
    &[
        attribute("revMajor", Kind::Int).required(from(V1_5)).range(Range::Exactly(1), from(V1_4)),
        attribute("revMinor", Kind::Int).required(from(V1_5)),
        attribute("name", Kind::Text),
        attribute("version", Kind::Text).numeric(between(V1_4, V1_5)),
        attribute("date", Kind::Text),
        attribute("north", Kind::Double),
        attribute("south", Kind::Double),
        attribute("east", Kind::Double),
        attribute("west", Kind::Double),
        attribute("vendor", Kind::Text),
    ],
    &[
        child("geoReference", &GEO_REFERENCE, 1).occurs(0, 1, from(V1_4)),
        child("offset", &OFFSET, 2).only(from(V1_5)).occurs(0, 1, from(V1_4)),
        child("license", &LICENSE, 3).only(from(V1_8)).occurs(0, 1, from(V1_4)),
        child("defaultRegulations", &DEFAULT_REGULATIONS, 7).only(from(V1_8)).occurs(
            0,
            1,
            from(V1_4),
        ),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static GEO_REFERENCE: ElementSchema = ElementSchema::new("GeoReference", &[], &[])
    .content(Kind::Text)
    .additional(between(V1_5, V1_7), between(V1_5, V1_7), between(V1_5, V1_7));

pub(crate) static OFFSET: ElementSchema = ElementSchema::new(
    "Offset",
    &[
        attribute("x", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("y", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("z", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("hdg", Kind::Double).only(from(V1_5)).required(from(V1_5)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static LICENSE: ElementSchema = ElementSchema::new(
    "License",
    &[
        attribute("name", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
        attribute("spdxid", Kind::Text).only(from(V1_8)),
        attribute("text", Kind::Text).only(from(V1_8)),
        attribute("resource", Kind::Text).only(from(V1_8)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static DEFAULT_REGULATIONS: ElementSchema = ElementSchema::new(
    "DefaultRegulations",
    &[],
    &[
        child("roadRegulations", &ROAD_REGULATION, 1).only(from(V1_8)),
        child("signalRegulations", &SIGNAL_REGULATION, 2).only(from(V1_8)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static ROAD_REGULATION: ElementSchema = ElementSchema::new(
    "RoadRegulation",
    &[attribute("type", Kind::Words(&ROAD_TYPE)).only(from(V1_8)).by_text(from(V1_8))],
    &[child("semantics", &SEMANTICS, 5).only(from(V1_8)).occurs(0, 1, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static SIGNAL_REGULATION: ElementSchema = ElementSchema::new(
    "SignalRegulation",
    &[
        attribute("type", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
        attribute("subtype", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
    ],
    &[child("semantics", &SEMANTICS, 5).only(from(V1_8)).occurs(0, 1, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));
