//! The schema of `objects`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/objects.toml; change that file instead.

use crate::generated::schema_object_outlines::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static OBJECTS: ElementSchema = ElementSchema::new(
    "Objects",
    &[],
    &[
        child("object", &OBJECT, 1),
        child("objectReference", &OBJECT_REFERENCE, 2),
        child("tunnel", &TUNNEL, 3),
        child("bridge", &BRIDGE, 4),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static OBJECT: ElementSchema = ElementSchema::new(
    "Object",
    &[
        attribute("t", Kind::Double).required(from(V1_5)),
        attribute("zOffset", Kind::Double).required(from(V1_5)),
        attribute("type", Kind::Words(&OBJECT_TYPE)).loose(between(V1_4, V1_4)),
        attribute("validLength", Kind::Double)
            .required(between(V1_5, V1_5))
            .range(Range::AtLeast0, from(V1_5)),
        attribute("orientation", Kind::Words(&ORIENTATION)).required(between(V1_5, V1_5)),
        attribute("subtype", Kind::Text).only(from(V1_5)),
        attribute("dynamic", Kind::YesNo).only(from(V1_5)).required(between(V1_5, V1_5)),
        attribute("hdg", Kind::Double).required(between(V1_5, V1_5)),
        attribute("name", Kind::Text),
        attribute("pitch", Kind::Double).required(between(V1_5, V1_5)),
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("roll", Kind::Double).required(between(V1_5, V1_5)),
        attribute("height", Kind::Double)
            .required(between(V1_5, V1_5))
            .range(Range::AtLeast0, from(V1_7)),
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("length", Kind::Double).range(Range::Above0, from(V1_7)),
        attribute("width", Kind::Double),
        attribute("radius", Kind::Double).range(Range::Above0, from(V1_7)),
        attribute("perpToRoad", Kind::Boolean).only(from(V1_7)),
        attribute("invalidated", Kind::XsBoolean).only(from(V1_9)),
        attribute("temporary", Kind::XsBoolean).only(from(V1_9)),
    ],
    &[
        child("repeat", &OBJECT_REPEAT, 1).occurs(0, 1, between(V1_5, V1_5)),
        child("outline", &OUTLINE, 2).occurs(0, 1, from(V1_4)),
        child("outlines", &OUTLINES, 3).only(from(V1_5)).occurs(0, 1, from(V1_4)),
        child("material", &OBJECT_MATERIAL, 4).occurs(0, 1, between(V1_4, V1_4)),
        child("validity", &LANE_VALIDITY, 5),
        child("parkingSpace", &PARKING_SPACE, 6).occurs(0, 1, from(V1_4)),
        child("markings", &MARKINGS, 7).only(from(V1_5)).occurs(0, 1, from(V1_4)),
        child("borders", &OBJECT_BORDERS, 8).only(from(V1_5)).occurs(0, 1, from(V1_4)),
        child("surface", &OBJECT_SURFACE, 12).only(from(V1_7)).occurs(0, 1, from(V1_4)),
        child("skeleton", &SKELETON, 13).only(from(V1_8)).occurs(0, 1, from(V1_4)),
    ],
)
.key(10)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static OBJECT_REPEAT: ElementSchema = ElementSchema::new(
    "ObjectRepeat",
    &[
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("length", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("distance", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("tStart", Kind::Double).required(from(V1_5)),
        attribute("tEnd", Kind::Double).required(from(V1_5)),
        attribute("heightStart", Kind::Double)
            .required(from(V1_5))
            .not_by_text()
            .range(Range::AtLeast0, from(V1_7)),
        attribute("heightEnd", Kind::Double)
            .required(from(V1_5))
            .not_by_text()
            .range(Range::AtLeast0, from(V1_7)),
        attribute("zOffsetStart", Kind::Double).required(from(V1_5)),
        attribute("zOffsetEnd", Kind::Double).required(from(V1_5)),
        attribute("widthStart", Kind::Double)
            .required(between(V1_5, V1_5))
            .range(Range::AtLeast0, from(V1_5)),
        attribute("widthEnd", Kind::Double)
            .required(between(V1_5, V1_5))
            .range(Range::AtLeast0, from(V1_5)),
        attribute("lengthStart", Kind::Double).only(from(V1_5)).range(Range::AtLeast0, from(V1_4)),
        attribute("lengthEnd", Kind::Double).only(from(V1_5)).range(Range::AtLeast0, from(V1_4)),
        attribute("radiusStart", Kind::Double).only(from(V1_5)).range(Range::AtLeast0, from(V1_4)),
        attribute("radiusEnd", Kind::Double).only(from(V1_5)).range(Range::AtLeast0, from(V1_4)),
        attribute("detachFromReferenceLine", Kind::Boolean).only(from(V1_8)),
        attribute("bT", Kind::Double).only(from(V1_9)).range(Range::AtLeast0, from(V1_4)),
        attribute("cT", Kind::Double).only(from(V1_9)).range(Range::AtLeast0, from(V1_4)),
        attribute("dT", Kind::Double).only(from(V1_9)).range(Range::AtLeast0, from(V1_4)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static OBJECT_MATERIAL: ElementSchema = ElementSchema::new(
    "ObjectMaterial",
    &[
        attribute("surface", Kind::Text),
        attribute("friction", Kind::Double).range(Range::AtLeast0, from(V1_5)),
        attribute("roughness", Kind::Double).range(Range::AtLeast0, from(V1_5)),
        attribute("roadMarkColor", Kind::Words(&ROAD_MARK_COLOR)).only(from(V1_8)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static LANE_VALIDITY: ElementSchema = ElementSchema::new(
    "LaneValidity",
    &[
        attribute("fromLane", Kind::Int).required(from(V1_5)),
        attribute("toLane", Kind::Int).required(from(V1_5)),
        attribute("layer", Kind::Words(&LAYER_TYPE)).only(from(V1_9)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static PARKING_SPACE: ElementSchema = ElementSchema::new(
    "ParkingSpace",
    &[
        attribute("access", Kind::Words(&PARKING_SPACE_ACCESS)).required(from(V1_5)),
        attribute("restrictions", Kind::Text),
    ],
    &[child("marking", &PARKING_SPACE_MARKING, 1).only(between(V1_4, V1_4)).occurs(
        0,
        4,
        from(V1_4),
    )],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static PARKING_SPACE_MARKING: ElementSchema = ElementSchema::new(
    "ParkingSpaceMarking",
    &[
        attribute("side", Kind::Words(&PARKING_SPACE_MARKING_SIDE)).only(between(V1_4, V1_4)),
        attribute("type", Kind::Words(&ROAD_MARK_TYPE)).only(between(V1_4, V1_4)),
        attribute("width", Kind::Double).only(between(V1_4, V1_4)),
        attribute("color", Kind::Words(&ROAD_MARK_COLOR)).only(between(V1_4, V1_4)),
    ],
    &[],
);

pub(crate) static OBJECT_SURFACE: ElementSchema = ElementSchema::new(
    "ObjectSurface",
    &[],
    &[child("CRG", &OBJECT_CRG, 4).only(from(V1_7)).occurs(0, 1, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static OBJECT_CRG: ElementSchema = ElementSchema::new(
    "ObjectCrg",
    &[
        attribute("file", Kind::Text).only(from(V1_7)).by_text(from(V1_8)),
        attribute("hideRoadSurfaceCRG", Kind::Boolean).only(from(V1_7)).by_text(from(V1_8)),
        attribute("zScale", Kind::Double).only(from(V1_7)).by_text(from(V1_8)),
    ],
    &[],
)
.additional(from(V1_8), from(V1_8), from(V1_8));

pub(crate) static OBJECT_REFERENCE: ElementSchema = ElementSchema::new(
    "ObjectReference",
    &[
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("t", Kind::Double).required(from(V1_5)),
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("zOffset", Kind::Double).required(between(V1_5, V1_5)),
        attribute("validLength", Kind::Double)
            .required(between(V1_5, V1_5))
            .range(Range::AtLeast0, from(V1_5)),
        attribute("orientation", Kind::Words(&ORIENTATION)).required(from(V1_5)),
    ],
    &[child("validity", &LANE_VALIDITY, 1)],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static TUNNEL: ElementSchema = ElementSchema::new(
    "Tunnel",
    &[
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("length", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("name", Kind::Text),
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("type", Kind::Words(&TUNNEL_TYPE)).required(from(V1_5)),
        attribute("lighting", Kind::Double).range(Range::ZeroToOne, from(V1_5)),
        attribute("daylight", Kind::Double).range(Range::ZeroToOne, from(V1_5)),
    ],
    &[child("validity", &LANE_VALIDITY, 1)],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static BRIDGE: ElementSchema = ElementSchema::new(
    "Bridge",
    &[
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("length", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("name", Kind::Text),
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("type", Kind::Words(&BRIDGE_TYPE)).required(from(V1_5)),
    ],
    &[child("validity", &LANE_VALIDITY, 1)],
)
.additional(from(V1_4), from(V1_4), from(V1_5));
