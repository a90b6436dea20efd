//! The schema of `road_mark`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/road_mark.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static ROAD_MARK: ElementSchema = ElementSchema::new(
    "RoadMark",
    &[
        attribute("sOffset", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("type", Kind::Words(&ROAD_MARK_TYPE)).required(from(V1_5)),
        attribute("weight", Kind::Words(&ROAD_MARK_WEIGHT)),
        attribute("color", Kind::Words(&ROAD_MARK_COLOR)).required(from(V1_5)),
        attribute("material", Kind::Text),
        attribute("width", Kind::Double).range(Range::AtLeast0, from(V1_5)),
        attribute("laneChange", Kind::Words(&LANE_CHANGE)),
        attribute("height", Kind::Double).range(Range::Above0, from(V1_7)),
    ],
    &[
        child("sway", &SWAY, 1).only(from(V1_5)),
        child("type", &ROAD_MARK_PATTERN, 2).occurs(0, 1, from(V1_4)),
        child("explicit", &EXPLICIT_ROAD_MARK, 3).only(from(V1_5)).occurs(0, 1, from(V1_4)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static SWAY: ElementSchema = ElementSchema::new(
    "Sway",
    &[
        attribute("ds", Kind::Double)
            .only(from(V1_5))
            .required(from(V1_5))
            .range(Range::AtLeast0, from(V1_4)),
        attribute("a", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("b", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("c", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("d", Kind::Double).only(from(V1_5)).required(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static ROAD_MARK_PATTERN: ElementSchema = ElementSchema::new(
    "RoadMarkPattern",
    &[
        attribute("name", Kind::Text).required(from(V1_5)),
        attribute("width", Kind::Double)
            .required(from(V1_5))
            .range(Range::AtLeast0, between(V1_5, V1_6))
            .range(Range::Above0, from(V1_7)),
    ],
    &[child("line", &ROAD_MARK_LINE, 1).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_5), from(V1_5), from(V1_5));

pub(crate) static ROAD_MARK_LINE: ElementSchema = ElementSchema::new(
    "RoadMarkLine",
    &[
        attribute("length", Kind::Double)
            .required(from(V1_5))
            .loose(between(V1_6, V1_6))
            .range(Range::AtLeast0, between(V1_5, V1_5) | from(V1_7)),
        attribute("space", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("tOffset", Kind::Double).required(from(V1_5)),
        attribute("sOffset", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("rule", Kind::Words(&ROAD_MARK_RULE)),
        attribute("width", Kind::Double)
            .required(between(V1_5, V1_5))
            .loose(between(V1_6, V1_6))
            .range(Range::AtLeast0, between(V1_5, V1_5))
            .range(Range::Above0, from(V1_7)),
        attribute("color", Kind::Words(&ROAD_MARK_COLOR)).only(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static EXPLICIT_ROAD_MARK: ElementSchema = ElementSchema::new(
    "ExplicitRoadMark",
    &[],
    &[child("line", &EXPLICIT_LINE, 1).only(from(V1_5)).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static EXPLICIT_LINE: ElementSchema = ElementSchema::new(
    "ExplicitLine",
    &[
        attribute("length", Kind::Double)
            .only(from(V1_5))
            .required(from(V1_5))
            .loose(between(V1_6, V1_6))
            .range(Range::AtLeast0, between(V1_5, V1_5))
            .range(Range::Above0, from(V1_7)),
        attribute("tOffset", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("sOffset", Kind::Double)
            .only(from(V1_5))
            .required(from(V1_5))
            .range(Range::AtLeast0, from(V1_4)),
        attribute("rule", Kind::Words(&ROAD_MARK_RULE)).only(from(V1_5)),
        attribute("width", Kind::Double)
            .only(from(V1_5))
            .required(between(V1_5, V1_5))
            .loose(between(V1_6, V1_6))
            .range(Range::AtLeast0, between(V1_5, V1_5))
            .range(Range::Above0, from(V1_7)),
    ],
    &[],
)
.additional(
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);
