//! The schema of `lanes`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/lanes.toml; change that file instead.

use crate::generated::schema_road_mark::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static LANES: ElementSchema = ElementSchema::new(
    "Lanes",
    &[attribute("layer", Kind::Words(&LAYER_TYPE)).only(from(V1_9))],
    &[
        child("laneOffset", &LANE_OFFSET, 1),
        child("laneSection", &LANE_SECTION, 2).occurs(1, MANY, from(V1_4)),
    ],
)
.additional(from(V1_5), from(V1_5), from(V1_5));

pub(crate) static LANE_OFFSET: ElementSchema = ElementSchema::new(
    "LaneOffset",
    &[
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("a", Kind::Double).required(from(V1_5)),
        attribute("b", Kind::Double).required(from(V1_5)),
        attribute("c", Kind::Double).required(from(V1_5)),
        attribute("d", Kind::Double).required(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static LANE_SECTION: ElementSchema = ElementSchema::new(
    "LaneSection",
    &[
        attribute("length", Kind::Double).only(from(V1_9)).range(Range::AtLeast0, from(V1_4)),
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("singleSide", Kind::Boolean),
    ],
    &[
        child("left", &LANE_SECTION_SIDE, 1).occurs(0, 1, from(V1_4)),
        child("center", &LANE_SECTION_CENTER, 2)
            .occurs(1, 1, between(V1_4, V1_4) | from(V1_6))
            .occurs(0, 1, between(V1_5, V1_5)),
        child("right", &LANE_SECTION_SIDE, 3).occurs(0, 1, from(V1_4)),
    ],
)
.key(1)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static LANE_SECTION_SIDE: ElementSchema = ElementSchema::new(
    "LaneSectionSide",
    &[],
    &[child("lane", &LANE, 1).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static LANE: ElementSchema = ElementSchema::new(
    "Lane",
    &[
        attribute("type", Kind::Words(&LANE_TYPE)).required(from(V1_5)),
        attribute("advisory", Kind::Words(&LANE_ADVISORY)).only(from(V1_8)),
        attribute("direction", Kind::Words(&LANE_DIRECTION)).only(from(V1_8)),
        attribute("dynamicLaneType", Kind::Boolean).only(from(V1_8)),
        attribute("dynamicLaneDirection", Kind::Boolean).only(from(V1_8)),
        attribute("level", Kind::Boolean),
        attribute("roadWorks", Kind::Boolean).only(from(V1_8)),
        attribute("id", Kind::Int).required(from(V1_5)).range(Range::Not0, from(V1_5)),
    ],
    &[
        child("link", &LANE_LINK, 1).occurs(0, 1, from(V1_4)),
        child("border", &LANE_BORDER, 2).occurs(1, MANY, between(V1_4, V1_5)).choice(),
        child("width", &LANE_WIDTH, 3).occurs(1, MANY, between(V1_4, V1_5)).choice(),
        child("roadMark", &ROAD_MARK, 4),
        child("material", &LANE_MATERIAL, 5),
        child("visibility", &LANE_VISIBILITY, 6).only(between(V1_4, V1_5)),
        child("speed", &LANE_SPEED, 7),
        child("access", &LANE_ACCESS, 8),
        child("height", &LANE_HEIGHT, 9),
        child("rule", &LANE_RULE, 10),
    ],
)
.key(7)
.choice(Choice::AtMostOne)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static LANE_LINK: ElementSchema = ElementSchema::new(
    "LaneLink",
    &[],
    &[
        child("predecessor", &LINKED_LANE, 1).occurs(0, 1, between(V1_4, V1_4)),
        child("successor", &LINKED_LANE, 2).occurs(0, 1, between(V1_4, V1_4)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static LINKED_LANE: ElementSchema = ElementSchema::new(
    "LinkedLane",
    &[
        attribute("id", Kind::Int).required(from(V1_5)),
        attribute("layer", Kind::Text).only(from(V1_9)),
    ],
    &[],
)
.additional(
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static LANE_BORDER: ElementSchema = ElementSchema::new(
    "LaneBorder",
    &[
        attribute("sOffset", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("a", Kind::Double).required(from(V1_5)),
        attribute("b", Kind::Double).required(from(V1_5)),
        attribute("c", Kind::Double).required(from(V1_5)),
        attribute("d", Kind::Double).required(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static LANE_WIDTH: ElementSchema = ElementSchema::new(
    "LaneWidth",
    &[
        attribute("sOffset", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("a", Kind::Double).required(from(V1_5)),
        attribute("b", Kind::Double).required(from(V1_5)),
        attribute("c", Kind::Double).required(from(V1_5)),
        attribute("d", Kind::Double).required(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static LANE_MATERIAL: ElementSchema = ElementSchema::new(
    "LaneMaterial",
    &[
        attribute("sOffset", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("surface", Kind::Text),
        attribute("friction", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("roughness", Kind::Double).range(Range::AtLeast0, from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static LANE_SPEED: ElementSchema = ElementSchema::new(
    "LaneSpeed",
    &[
        attribute("sOffset", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("max", Kind::LaneSpeedLimit)
            .required(from(V1_5))
            .range(Range::AtLeast0, from(V1_5)),
        attribute("unit", Kind::Words(&UNIT_SPEED)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static LANE_VISIBILITY: ElementSchema = ElementSchema::new(
    "LaneVisibility",
    &[
        attribute("sOffset", Kind::Double)
            .only(between(V1_4, V1_5))
            .required(between(V1_5, V1_5))
            .range(Range::AtLeast0, from(V1_5)),
        attribute("forward", Kind::Double)
            .only(between(V1_4, V1_5))
            .required(between(V1_5, V1_5))
            .range(Range::AtLeast0, from(V1_5)),
        attribute("back", Kind::Double)
            .only(between(V1_4, V1_5))
            .required(between(V1_5, V1_5))
            .range(Range::AtLeast0, from(V1_5)),
        attribute("left", Kind::Double)
            .only(between(V1_4, V1_5))
            .required(between(V1_5, V1_5))
            .range(Range::AtLeast0, from(V1_5)),
        attribute("right", Kind::Double)
            .only(between(V1_4, V1_5))
            .required(between(V1_5, V1_5))
            .range(Range::AtLeast0, from(V1_5)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static LANE_ACCESS: ElementSchema = ElementSchema::new(
    "LaneAccess",
    &[
        attribute("sOffset", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("rule", Kind::Words(&ACCESS_RULE)).only(from(V1_5)).required(between(V1_5, V1_5)),
        attribute("restriction", Kind::Words(&ACCESS_RESTRICTION_TYPE))
            .required(between(V1_5, V1_7))
            .deprecated(from(V1_8)),
    ],
    &[child("restriction", &ACCESS_RESTRICTION, 1).only(from(V1_8))],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static ACCESS_RESTRICTION: ElementSchema = ElementSchema::new(
    "AccessRestriction",
    &[attribute("type", Kind::Words(&ACCESS_RESTRICTION_TYPE))
        .only(from(V1_8))
        .by_text(from(V1_8))],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static LANE_HEIGHT: ElementSchema = ElementSchema::new(
    "LaneHeight",
    &[
        attribute("sOffset", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("inner", Kind::Double).required(from(V1_5)),
        attribute("outer", Kind::Double).required(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static LANE_RULE: ElementSchema = ElementSchema::new(
    "LaneRule",
    &[
        attribute("sOffset", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("value", Kind::Text).required(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static LANE_SECTION_CENTER: ElementSchema = ElementSchema::new(
    "LaneSectionCenter",
    &[],
    &[child("lane", &CENTER_LANE, 1)
        .occurs(0, 1, between(V1_4, V1_4))
        .occurs(1, MANY, between(V1_5, V1_7))
        .occurs(1, 1, from(V1_8))],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static CENTER_LANE: ElementSchema = ElementSchema::new(
    "CenterLane",
    &[
        attribute("id", Kind::Int).required(from(V1_5)).range(Range::Exactly(0), from(V1_4)),
        attribute("type", Kind::Words(&LANE_TYPE))
            .required(between(V1_5, V1_7))
            .deprecated(from(V1_8)),
        attribute("level", Kind::Boolean).deprecated(from(V1_8)),
    ],
    &[
        child("link", &LANE_LINK, 1).occurs(0, 1, from(V1_4)),
        child("border", &LANE_BORDER, 2).only(between(V1_6, V1_7)).choice(),
        child("width", &LANE_WIDTH, 3).only(between(V1_6, V1_7)).choice(),
        child("roadMark", &ROAD_MARK, 4),
        child("material", &LANE_MATERIAL, 5).only(between(V1_6, V1_7)),
        child("speed", &LANE_SPEED, 6).only(between(V1_6, V1_7)),
        child("access", &LANE_ACCESS, 7).only(between(V1_6, V1_7)),
        child("height", &LANE_HEIGHT, 8).only(between(V1_6, V1_7)),
        child("rule", &LANE_RULE, 9).only(between(V1_6, V1_7)),
    ],
)
.key(0)
.additional(between(V1_4, V1_7), between(V1_4, V1_7), between(V1_5, V1_7));
