//! The schema of `railroad`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/railroad.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static RAILROAD: ElementSchema = ElementSchema::new(
    "Railroad",
    &[],
    &[child("switch", &SWITCH, 1)],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static SWITCH: ElementSchema = ElementSchema::new(
    "Switch",
    &[
        attribute("name", Kind::Text).required(from(V1_5)),
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("position", Kind::Words(&SWITCH_POSITION)).required(from(V1_5)),
    ],
    &[
        child("mainTrack", &MAIN_TRACK, 1).occurs(1, 1, from(V1_4)),
        child("sideTrack", &SIDE_TRACK, 2).occurs(1, 1, from(V1_4)),
        child("partner", &SWITCH_PARTNER, 3).occurs(0, 1, from(V1_4)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static MAIN_TRACK: ElementSchema = ElementSchema::new(
    "MainTrack",
    &[
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("dir", Kind::Words(&ELEMENT_DIR)).required(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_5, V1_6) | from(V1_8),
    between(V1_5, V1_6) | from(V1_8),
    between(V1_5, V1_6) | from(V1_8),
);

pub(crate) static SIDE_TRACK: ElementSchema = ElementSchema::new(
    "SideTrack",
    &[
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("dir", Kind::Words(&ELEMENT_DIR)).required(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_5, V1_6) | from(V1_8),
    between(V1_5, V1_6) | from(V1_8),
    between(V1_5, V1_6) | from(V1_8),
);

pub(crate) static SWITCH_PARTNER: ElementSchema = ElementSchema::new(
    "SwitchPartner",
    &[attribute("name", Kind::Text), attribute("id", Kind::Text).required(from(V1_5))],
    &[],
)
.additional(
    between(V1_5, V1_6) | from(V1_8),
    between(V1_5, V1_6) | from(V1_8),
    between(V1_5, V1_6) | from(V1_8),
);

pub(crate) static STATION: ElementSchema = ElementSchema::new(
    "Station",
    &[
        attribute("name", Kind::Text).required(from(V1_5)),
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("type", Kind::Words(&STATION_TYPE)),
    ],
    &[child("platform", &PLATFORM, 1).occurs(1, MANY, from(V1_4))],
)
.key(1)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static PLATFORM: ElementSchema = ElementSchema::new(
    "Platform",
    &[attribute("name", Kind::Text), attribute("id", Kind::Text).required(from(V1_5))],
    &[child("segment", &PLATFORM_SEGMENT, 1).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_5), from(V1_5), from(V1_5));

pub(crate) static PLATFORM_SEGMENT: ElementSchema = ElementSchema::new(
    "PlatformSegment",
    &[
        attribute("roadId", Kind::Text).required(from(V1_5)),
        attribute("sStart", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("sEnd", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("side", Kind::Words(&PLATFORM_SIDE)).required(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);
