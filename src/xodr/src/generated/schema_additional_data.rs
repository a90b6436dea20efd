//! The schema of `additional_data`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/additional_data.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static DATA_QUALITY: ElementSchema = ElementSchema::new(
    "DataQuality",
    &[],
    &[
        child("error", &DATA_ERROR, 1).only(from(V1_5)).occurs(0, 1, from(V1_4)),
        child("rawData", &RAW_DATA, 2).only(from(V1_5)).occurs(0, 1, from(V1_4)),
    ],
);

pub(crate) static DATA_ERROR: ElementSchema = ElementSchema::new(
    "DataError",
    &[
        attribute("xyAbsolute", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("zAbsolute", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("xyRelative", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("zRelative", Kind::Double).only(from(V1_5)).required(from(V1_5)),
    ],
    &[],
);

pub(crate) static RAW_DATA: ElementSchema = ElementSchema::new(
    "RawData",
    &[
        attribute("date", Kind::Text).only(from(V1_5)).required(from(V1_5)),
        attribute("source", Kind::Words(&RAW_DATA_SOURCE)).only(from(V1_5)).required(from(V1_5)),
        attribute("sourceComment", Kind::Text).only(from(V1_5)),
        attribute("postProcessing", Kind::Words(&POST_PROCESSING))
            .only(from(V1_5))
            .required(from(V1_5)),
        attribute("postProcessingComment", Kind::Text).only(from(V1_5)),
    ],
    &[],
);

pub(crate) static INCLUDE: ElementSchema =
    ElementSchema::new("Include", &[attribute("file", Kind::Text).required(from(V1_5))], &[]);

pub(crate) static USER_DATA: ElementSchema = ElementSchema::new(
    "UserData",
    &[
        attribute("code", Kind::Text).required(from(V1_5)),
        attribute("value", Kind::Text).required(between(V1_5, V1_5)),
    ],
    &[],
)
.any();
