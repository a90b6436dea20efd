//! The schema of `road`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/road.toml; change that file instead.

use crate::generated::schema_lanes::*;
use crate::generated::schema_objects::*;
use crate::generated::schema_plan_view::*;
use crate::generated::schema_profiles::*;
use crate::generated::schema_railroad::*;
use crate::generated::schema_signals::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static ROAD: ElementSchema = ElementSchema::new(
    "Road",
    &[
        attribute("name", Kind::Text),
        attribute("length", Kind::Double)
            .required(from(V1_5))
            .loose(between(V1_6, V1_6))
            .range(Range::AtLeast0, between(V1_5, V1_5))
            .range(Range::Above0, from(V1_7)),
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("junction", Kind::Text).required(from(V1_5)),
        attribute("rule", Kind::Words(&TRAFFIC_RULE)).only(from(V1_5)),
    ],
    &[
        child("link", &ROAD_LINK, 1).occurs(0, 1, from(V1_4)),
        child("type", &ROAD_TYPE_RECORD, 2),
        child("planView", &PLAN_VIEW, 3).occurs(1, 1, from(V1_4)),
        child("elevationProfile", &ELEVATION_PROFILE, 4).occurs(0, 1, from(V1_4)),
        child("lateralProfile", &LATERAL_PROFILE, 5).occurs(0, 1, from(V1_4)),
        child("lanes", &LANES, 6).occurs(1, 1, between(V1_4, V1_8_1)).occurs(1, 2, from(V1_9)),
        child("objects", &OBJECTS, 7).occurs(0, 1, from(V1_4)),
        child("signals", &SIGNALS, 8).occurs(0, 1, from(V1_4)),
        child("surface", &ROAD_SURFACE, 9).occurs(0, 1, from(V1_4)),
        child("railroad", &RAILROAD, 10).occurs(0, 1, from(V1_4)),
    ],
)
.key(2)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static ROAD_LINK: ElementSchema = ElementSchema::new(
    "RoadLink",
    &[],
    &[
        child("predecessor", &LINKED_ELEMENT, 1).occurs(0, 1, from(V1_4)),
        child("successor", &LINKED_ELEMENT, 2).occurs(0, 1, from(V1_4)),
        child("neighbor", &NEIGHBOR, 3).only(between(V1_4, V1_5)).occurs(0, 2, from(V1_4)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static LINKED_ELEMENT: ElementSchema = ElementSchema::new(
    "LinkedElement",
    &[
        attribute("elementId", Kind::Text).required(from(V1_5)),
        attribute("elementType", Kind::Words(&ELEMENT_TYPE))
            .required(between(V1_5, V1_5))
            .by_text(from(V1_8))
            .loose(between(V1_6, V1_6)),
        attribute("contactPoint", Kind::Words(&CONTACT_POINT)).loose(between(V1_6, V1_6)),
        attribute("elementS", Kind::Double).only(from(V1_5)).range(Range::AtLeast0, from(V1_4)),
        attribute("elementDir", Kind::Words(&ELEMENT_DIR))
            .only(from(V1_5))
            .loose(between(V1_6, V1_6)),
    ],
    &[],
)
.additional(
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static NEIGHBOR: ElementSchema = ElementSchema::new(
    "Neighbor",
    &[
        attribute("side", Kind::Words(&NEIGHBOR_SIDE))
            .only(between(V1_4, V1_5))
            .required(between(V1_5, V1_5)),
        attribute("elementId", Kind::Text).only(between(V1_4, V1_5)).required(between(V1_5, V1_5)),
        attribute("direction", Kind::Words(&DIRECTION))
            .only(between(V1_4, V1_5))
            .required(between(V1_5, V1_5)),
    ],
    &[],
)
.additional(from(V1_5), from(V1_5), from(V1_5));

pub(crate) static ROAD_TYPE_RECORD: ElementSchema = ElementSchema::new(
    "RoadTypeRecord",
    &[
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("type", Kind::Words(&ROAD_TYPE)).required(from(V1_5)),
        attribute("country", Kind::Country).only(from(V1_5)),
    ],
    &[child("speed", &ROAD_SPEED, 1).occurs(0, 1, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static ROAD_SPEED: ElementSchema = ElementSchema::new(
    "RoadSpeed",
    &[
        attribute("max", Kind::SpeedLimit).required(from(V1_5)).range(Range::AtLeast0, from(V1_4)),
        attribute("unit", Kind::Words(&UNIT_SPEED)).by_text(from(V1_8)),
    ],
    &[],
)
.additional(
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static ROAD_SURFACE: ElementSchema = ElementSchema::new(
    "RoadSurface",
    &[],
    &[child("CRG", &ROAD_CRG, 1)],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static ROAD_CRG: ElementSchema = ElementSchema::new(
    "RoadCrg",
    &[
        attribute("file", Kind::Text).required(from(V1_5)),
        attribute("sStart", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("sEnd", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("orientation", Kind::Words(&DIRECTION)).required(from(V1_5)),
        attribute("mode", Kind::Words(&CRG_MODE)).required(from(V1_5)),
        attribute("purpose", Kind::Words(&CRG_PURPOSE)),
        attribute("sOffset", Kind::Double),
        attribute("tOffset", Kind::Double),
        attribute("xOffset", Kind::Double).only(from(V1_9)),
        attribute("yOffset", Kind::Double).only(from(V1_9)),
        attribute("zOffset", Kind::Double),
        attribute("zScale", Kind::Double),
        attribute("hOffset", Kind::Double),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);
