//! The schema of `junction`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/junction.toml; change that file instead.

use crate::generated::schema_objects::*;
use crate::generated::schema_plan_view::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};
use crate::variants;

pub(crate) static JUNCTION: ElementSchema = ElementSchema::new(
    "Junction",
    &[
        attribute("name", Kind::Text),
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("type", Kind::Words(&JUNCTION_TYPE)).only(from(V1_5)),
        attribute("mainRoad", Kind::Text).only(from(V1_7)).by_text(from(V1_8)).when(0b0100),
        attribute("sStart", Kind::Double)
            .only(from(V1_7))
            .by_text(from(V1_8))
            .range(Range::AtLeast0, from(V1_4))
            .when(0b0100),
        attribute("sEnd", Kind::Double)
            .only(from(V1_7))
            .by_text(from(V1_8))
            .range(Range::AtLeast0, from(V1_4))
            .when(0b0100),
        attribute("orientation", Kind::Words(&ORIENTATION))
            .only(from(V1_7))
            .by_text(from(V1_8))
            .when(0b0100),
    ],
    &[
        child("connection", &CONNECTION, 1).occurs(1, MANY, between(V1_4, V1_7)).when(0b0111),
        child("roadSection", &ROAD_SECTION, 1)
            .only(from(V1_8))
            .occurs(1, MANY, from(V1_4))
            .when(0b1000),
        child("crossPath", &CROSS_PATH, 2).only(from(V1_8)).when(0b0101),
        child("priority", &PRIORITY, 3),
        child("controller", &JUNCTION_CONTROLLER, 4),
        child("surface", &JUNCTION_SURFACE, 5).only(from(V1_5)).occurs(0, 1, from(V1_4)),
        child("planView", &PLAN_VIEW, 6).only(from(V1_8)).occurs(0, 1, from(V1_4)),
        child("objects", &OBJECTS, 7).only(from(V1_8)).occurs(0, 1, from(V1_4)),
        child("boundary", &BOUNDARY, 8).only(from(V1_8)).occurs(0, 1, from(V1_4)).when(0b0001),
        child("elevationGrid", &ELEVATION_GRID, 9)
            .only(from(V1_8))
            .occurs(0, 1, from(V1_4))
            .when(0b0001),
    ],
)
.key(1)
.additional(from(V1_4), from(V1_4), from(V1_5))
.variants(&["default", "direct", "virtual", "crossing"], variants::junction);

pub(crate) static CONNECTION: ElementSchema = ElementSchema::new(
    "Connection",
    &[
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("incomingRoad", Kind::Text).required(between(V1_5, V1_5)),
        attribute("contactPoint", Kind::Words(&CONTACT_POINT))
            .required(between(V1_5, V1_5))
            .loose(between(V1_6, V1_6)),
        attribute("type", Kind::Words(&CONNECTION_TYPE)).only(from(V1_5)).when(0b1100),
        attribute("connectingRoad", Kind::Text)
            .required(between(V1_5, V1_5))
            .by_text(from(V1_8))
            .when(0b1101),
        attribute("linkedRoad", Kind::Text).only(from(V1_7)).by_text(from(V1_8)).when(0b0010),
        attribute("connectionMaster", Kind::Text).only(between(V1_5, V1_5)),
    ],
    &[
        child("laneLink", &JUNCTION_LANE_LINK, 1),
        child("predecessor", &CONNECTION_END, 1)
            .only(from(V1_5))
            .occurs(0, 1, between(V1_5, V1_7))
            .occurs(1, 1, from(V1_8))
            .when(0b1000),
        child("successor", &CONNECTION_END, 1)
            .only(from(V1_5))
            .occurs(0, 1, between(V1_5, V1_7))
            .occurs(1, 1, from(V1_8))
            .when(0b1000),
    ],
)
.key(0)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
)
.variants(&["default", "direct", "virtual", "virtual_connection"], variants::connection);

pub(crate) static JUNCTION_LANE_LINK: ElementSchema = ElementSchema::new(
    "JunctionLaneLink",
    &[
        attribute("from", Kind::Int).required(from(V1_5)),
        attribute("to", Kind::Int).required(from(V1_5)),
        attribute("overlapZone", Kind::Double).only(from(V1_8)).range(Range::Above0, from(V1_4)),
        attribute("fromLayer", Kind::Words(&LAYER_TYPE)).only(from(V1_9)),
        attribute("toLayer", Kind::Words(&LAYER_TYPE)).only(from(V1_9)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static CONNECTION_END: ElementSchema = ElementSchema::new(
    "ConnectionEnd",
    &[
        attribute("elementType", Kind::Text)
            .only(from(V1_5))
            .required(from(V1_5))
            .deprecated(from(V1_8))
            .fixed("road"),
        attribute("elementId", Kind::Text)
            .only(from(V1_5))
            .required(from(V1_5))
            .deprecated(from(V1_8)),
        attribute("elementS", Kind::Double)
            .only(from(V1_5))
            .required(from(V1_5))
            .deprecated(from(V1_8))
            .range(Range::Above0, between(V1_5, V1_6))
            .range(Range::AtLeast0, from(V1_7)),
        attribute("elementDir", Kind::Words(&ELEMENT_DIR))
            .only(from(V1_5))
            .required(between(V1_5, V1_7))
            .by_text(from(V1_8))
            .deprecated(from(V1_8)),
    ],
    &[],
)
.additional(
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static ROAD_SECTION: ElementSchema = ElementSchema::new(
    "RoadSection",
    &[
        attribute("id", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
        attribute("roadId", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
        attribute("sStart", Kind::Double)
            .only(from(V1_8))
            .by_text(from(V1_8))
            .range(Range::AtLeast0, from(V1_4)),
        attribute("sEnd", Kind::Double)
            .only(from(V1_8))
            .by_text(from(V1_8))
            .range(Range::AtLeast0, from(V1_4)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static CROSS_PATH: ElementSchema = ElementSchema::new(
    "CrossPath",
    &[
        attribute("crossingRoad", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
        attribute("id", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
        attribute("roadAtEnd", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
        attribute("roadAtStart", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
    ],
    &[
        child("startLaneLink", &CROSS_PATH_LANE_LINK, 1).only(from(V1_8)).occurs(1, 1, from(V1_4)),
        child("endLaneLink", &CROSS_PATH_LANE_LINK, 2).only(from(V1_8)).occurs(1, 1, from(V1_4)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static CROSS_PATH_LANE_LINK: ElementSchema = ElementSchema::new(
    "CrossPathLaneLink",
    &[
        attribute("s", Kind::Double)
            .only(from(V1_8))
            .by_text(from(V1_8))
            .range(Range::AtLeast0, from(V1_4)),
        attribute("from", Kind::Int).only(from(V1_8)).by_text(from(V1_8)),
        attribute("to", Kind::Int).only(from(V1_8)).by_text(from(V1_8)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static PRIORITY: ElementSchema = ElementSchema::new(
    "Priority",
    &[
        attribute("high", Kind::Text).required(from(V1_8_1)),
        attribute("low", Kind::Text).required(from(V1_8_1)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static JUNCTION_CONTROLLER: ElementSchema = ElementSchema::new(
    "JunctionController",
    &[
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("type", Kind::Text),
        attribute("sequence", Kind::Uint),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static BOUNDARY: ElementSchema = ElementSchema::new(
    "Boundary",
    &[],
    &[child("segment", &BOUNDARY_SEGMENT, 1).only(from(V1_8)).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static BOUNDARY_SEGMENT: ElementSchema = ElementSchema::new(
    "BoundarySegment",
    &[
        attribute("roadId", Kind::Text).only(from(V1_8)),
        attribute("type", Kind::Words(&SEGMENT_TYPE)).only(from(V1_8)).by_text(from(V1_8)),
        attribute("boundaryLane", Kind::Int).only(from(V1_8)).by_text(from(V1_8)).when(0b0001),
        attribute("sStart", Kind::PositionOrEnd).only(from(V1_8)).by_text(from(V1_8)).when(0b0001),
        attribute("sEnd", Kind::PositionOrEnd).only(from(V1_8)).by_text(from(V1_8)).when(0b0001),
        attribute("contactPoint", Kind::PositionOrEnd)
            .only(from(V1_8))
            .by_text(from(V1_8))
            .when(0b0010),
        attribute("jointLaneStart", Kind::Int).only(from(V1_8)).when(0b0010),
        attribute("jointLaneEnd", Kind::Int).only(from(V1_8)).when(0b0010),
        attribute("transitionLength", Kind::Double)
            .only(from(V1_8))
            .range(Range::AtLeast0, from(V1_4))
            .when(0b0010),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4))
.variants(&["lane", "joint"], variants::boundary_segment);

pub(crate) static ELEVATION_GRID: ElementSchema = ElementSchema::new(
    "ElevationGrid",
    &[
        attribute("sStart", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
        attribute("gridSpacing", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
    ],
    &[child("elevation", &GRID_ELEVATION, 1).only(from(V1_8))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static GRID_ELEVATION: ElementSchema = ElementSchema::new(
    "GridElevation",
    &[
        attribute("left", Kind::Text).only(from(V1_8)),
        attribute("center", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
        attribute("right", Kind::Text).only(from(V1_8)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static JUNCTION_GROUP: ElementSchema = ElementSchema::new(
    "JunctionGroup",
    &[
        attribute("name", Kind::Text),
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("type", Kind::Words(&JUNCTION_GROUP_TYPE)).required(from(V1_5)),
    ],
    &[child("junctionReference", &JUNCTION_REFERENCE, 1).occurs(1, MANY, from(V1_4))],
)
.key(1)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static JUNCTION_REFERENCE: ElementSchema = ElementSchema::new(
    "JunctionReference",
    &[attribute("junction", Kind::Text).required(from(V1_5))],
    &[],
)
.additional(
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static JUNCTION_SURFACE: ElementSchema =
    ElementSchema::new("JunctionSurface", &[], &[child("CRG", &JUNCTION_CRG, 1).only(from(V1_5))])
        .additional(from(V1_5), from(V1_5), from(V1_5));

pub(crate) static JUNCTION_CRG: ElementSchema = ElementSchema::new(
    "JunctionCrg",
    &[
        attribute("file", Kind::Text).only(from(V1_5)).required(from(V1_5)),
        attribute("sStart", Kind::Double)
            .only(from(V1_8))
            .required(from(V1_8))
            .range(Range::AtLeast0, from(V1_4)),
        attribute("sEnd", Kind::Double)
            .only(from(V1_8))
            .required(from(V1_8))
            .range(Range::AtLeast0, from(V1_4)),
        attribute("orientation", Kind::Words(&DIRECTION)).only(from(V1_8)).required(from(V1_8)),
        attribute("mode", Kind::Words(&CRG_MODE)).only(from(V1_5)).required(from(V1_5)),
        attribute("purpose", Kind::Words(&CRG_PURPOSE)).only(from(V1_5)),
        attribute("sOffset", Kind::Double).only(from(V1_8)),
        attribute("tOffset", Kind::Double).only(from(V1_8)),
        attribute("xOffset", Kind::Double).only(from(V1_9)),
        attribute("yOffset", Kind::Double).only(from(V1_9)),
        attribute("zOffset", Kind::Double).only(from(V1_5)),
        attribute("zScale", Kind::Double).only(from(V1_5)),
        attribute("hOffset", Kind::Double).only(from(V1_8)),
    ],
    &[],
)
.additional(
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);
