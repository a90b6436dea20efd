//! The schema of `document`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/document.toml; change that file instead.

use crate::generated::schema_controller::*;
use crate::generated::schema_header::*;
use crate::generated::schema_junction::*;
use crate::generated::schema_railroad::*;
use crate::generated::schema_road::*;
use crate::generated::schema_signals::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static OPEN_DRIVE: ElementSchema = ElementSchema::new(
    "OpenDrive",
    &[],
    &[
        child("header", &HEADER, 1).occurs(1, 1, from(V1_4)),
        child("road", &ROAD, 2).occurs(1, MANY, from(V1_4)),
        child("controller", &CONTROLLER, 3),
        child("junction", &JUNCTION, 4),
        child("junctionGroup", &JUNCTION_GROUP, 5),
        child("station", &STATION, 6),
        child("vmsGroup", &VMS_GROUP, 10).only(from(V1_8)),
    ],
)
.additional(from(V1_5), from(V1_5), from(V1_5));
