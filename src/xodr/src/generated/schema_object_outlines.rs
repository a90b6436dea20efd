//! The schema of `object_outlines`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/object_outlines.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static OUTLINE: ElementSchema = ElementSchema::new(
    "Outline",
    &[
        attribute("id", Kind::Uint).only(from(V1_5)).required(between(V1_5, V1_5)),
        attribute("fillType", Kind::Words(&OUTLINE_FILL_TYPE))
            .only(from(V1_5))
            .required(between(V1_5, V1_5)),
        attribute("outer", Kind::Boolean).only(from(V1_5)).required(between(V1_5, V1_5)),
        attribute("closed", Kind::Boolean).only(from(V1_5)).required(between(V1_5, V1_5)),
        attribute("laneType", Kind::Words(&LANE_TYPE))
            .only(from(V1_5))
            .required(between(V1_5, V1_5)),
    ],
    &[
        child("cornerRoad", &CORNER_ROAD, 1).occurs(2, MANY, from(V1_8_1)).choice(),
        child("cornerLocal", &CORNER_LOCAL, 2).occurs(2, MANY, from(V1_8_1)).choice(),
        child("curveLocal", &CURVE_LOCAL, 3).only(from(V1_9)).occurs(1, MANY, from(V1_4)).choice(),
        child("markings", &MARKINGS, 7).only(from(V1_9)).occurs(0, 1, from(V1_4)),
    ],
)
.choice(Choice::One)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static CORNER_ROAD: ElementSchema = ElementSchema::new(
    "CornerRoad",
    &[
        attribute("id", Kind::Uint).only(from(V1_5)).required(between(V1_5, V1_5)),
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("t", Kind::Double).required(from(V1_5)),
        attribute("dz", Kind::Double).required(from(V1_5)),
        attribute("height", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_7)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static CORNER_LOCAL: ElementSchema = ElementSchema::new(
    "CornerLocal",
    &[
        attribute("id", Kind::Uint).only(from(V1_5)).required(between(V1_5, V1_5)),
        attribute("u", Kind::Double).required(from(V1_5)),
        attribute("v", Kind::Double).required(from(V1_5)),
        attribute("z", Kind::Double).required(from(V1_5)),
        attribute("height", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_7)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static CURVE_LOCAL: ElementSchema = ElementSchema::new(
    "CurveLocal",
    &[
        attribute("id", Kind::Uint).only(from(V1_9)),
        attribute("u", Kind::Double).only(from(V1_9)).required(from(V1_9)),
        attribute("v", Kind::Double).only(from(V1_9)).required(from(V1_9)),
        attribute("z", Kind::Double).only(from(V1_9)).required(from(V1_9)),
        attribute("height", Kind::Double)
            .only(from(V1_9))
            .required(from(V1_9))
            .range(Range::AtLeast0, from(V1_4)),
        attribute("length", Kind::Double)
            .only(from(V1_9))
            .required(from(V1_9))
            .not_by_text()
            .range(Range::Above0, from(V1_4)),
        attribute("hdg", Kind::Double).only(from(V1_9)).required(from(V1_9)).not_by_text(),
    ],
    &[
        child("arc", &CURVE_LOCAL_ARC, 1).only(from(V1_9)).occurs(1, 1, from(V1_4)).choice(),
        child("line", &CURVE_LOCAL_LINE, 2).only(from(V1_9)).occurs(1, 1, from(V1_4)).choice(),
        child("paramPoly3", &CURVE_LOCAL_PARAM_POLY3, 3)
            .only(from(V1_9))
            .occurs(1, 1, from(V1_4))
            .choice(),
    ],
)
.choice(Choice::One);

pub(crate) static CURVE_LOCAL_ARC: ElementSchema = ElementSchema::new(
    "CurveLocalArc",
    &[attribute("curvature", Kind::Double).only(from(V1_9)).required(from(V1_9))],
    &[],
);

pub(crate) static CURVE_LOCAL_LINE: ElementSchema = ElementSchema::new("CurveLocalLine", &[], &[]);

pub(crate) static CURVE_LOCAL_PARAM_POLY3: ElementSchema = ElementSchema::new(
    "CurveLocalParamPoly3",
    &[
        attribute("aU", Kind::Double).only(from(V1_9)).required(from(V1_9)),
        attribute("bU", Kind::Double).only(from(V1_9)).required(from(V1_9)),
        attribute("cU", Kind::Double).only(from(V1_9)).required(from(V1_9)),
        attribute("dU", Kind::Double).only(from(V1_9)).required(from(V1_9)),
        attribute("aV", Kind::Double).only(from(V1_9)).required(from(V1_9)),
        attribute("bV", Kind::Double).only(from(V1_9)).required(from(V1_9)),
        attribute("cV", Kind::Double).only(from(V1_9)).required(from(V1_9)),
        attribute("dV", Kind::Double).only(from(V1_9)).required(from(V1_9)),
        attribute("pRange", Kind::Words(&PARAM_POLY3_RANGE)).only(from(V1_9)).required(from(V1_9)),
    ],
    &[],
);

pub(crate) static MARKINGS: ElementSchema = ElementSchema::new(
    "Markings",
    &[],
    &[child("marking", &MARKING, 1).only(from(V1_5)).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static MARKING: ElementSchema = ElementSchema::new(
    "Marking",
    &[
        attribute("side", Kind::Words(&SIDE_TYPE)).only(from(V1_5)).required(between(V1_5, V1_5)),
        attribute("weight", Kind::Words(&ROAD_MARK_WEIGHT))
            .only(from(V1_5))
            .required(between(V1_5, V1_5)),
        attribute("width", Kind::Double)
            .only(from(V1_5))
            .loose(between(V1_6, V1_6))
            .range(Range::AtLeast0, between(V1_5, V1_5))
            .range(Range::Above0, from(V1_7)),
        attribute("color", Kind::Words(&ROAD_MARK_COLOR)).only(from(V1_5)).required(from(V1_5)),
        attribute("zOffset", Kind::Double).only(from(V1_5)).range(Range::AtLeast0, from(V1_4)),
        attribute("spaceLength", Kind::Double)
            .only(from(V1_5))
            .required(from(V1_5))
            .range(Range::AtLeast0, from(V1_4)),
        attribute("lineLength", Kind::Double)
            .only(from(V1_5))
            .required(from(V1_5))
            .loose(between(V1_6, V1_6))
            .range(Range::AtLeast0, between(V1_5, V1_5))
            .range(Range::Above0, from(V1_7)),
        attribute("startOffset", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("stopOffset", Kind::Double).only(from(V1_5)).required(from(V1_5)),
    ],
    &[child("cornerReference", &CORNER_REFERENCE, 1).only(from(V1_5)).occurs(
        2,
        MANY,
        between(V1_5, V1_5),
    )],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static CORNER_REFERENCE: ElementSchema = ElementSchema::new(
    "CornerReference",
    &[attribute("id", Kind::Uint).only(from(V1_5)).required(from(V1_5))],
    &[],
)
.additional(
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static OUTLINES: ElementSchema = ElementSchema::new(
    "Outlines",
    &[],
    &[child("outline", &OUTLINE, 1).only(from(V1_5)).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static OBJECT_BORDERS: ElementSchema = ElementSchema::new(
    "ObjectBorders",
    &[],
    &[child("border", &OBJECT_BORDER, 1).only(from(V1_5)).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static OBJECT_BORDER: ElementSchema = ElementSchema::new(
    "ObjectBorder",
    &[
        attribute("width", Kind::Double)
            .only(from(V1_5))
            .required(from(V1_5))
            .range(Range::AtLeast0, from(V1_4)),
        attribute("type", Kind::Words(&BORDER_TYPE)).only(from(V1_5)).required(from(V1_5)),
        attribute("outlineId", Kind::Uint).only(from(V1_5)).required(from(V1_5)),
        attribute("useCompleteOutline", Kind::Boolean).only(from(V1_5)),
    ],
    &[child("cornerReference", &CORNER_REFERENCE, 1).only(from(V1_5)).occurs(
        2,
        MANY,
        between(V1_5, V1_5),
    )],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static SKELETON: ElementSchema = ElementSchema::new(
    "Skeleton",
    &[],
    &[child("polyline", &POLYLINE, 1).only(from(V1_8)).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static POLYLINE: ElementSchema = ElementSchema::new(
    "Polyline",
    &[attribute("id", Kind::Uint).only(from(V1_8)).range(Range::AtLeast1, from(V1_4))],
    &[
        child("vertexRoad", &VERTEX_ROAD, 1)
            .only(from(V1_8))
            .occurs(2, MANY, from(V1_8_1))
            .choice(),
        child("vertexLocal", &VERTEX_LOCAL, 2)
            .only(from(V1_8))
            .occurs(2, MANY, from(V1_8_1))
            .choice(),
    ],
)
.choice(Choice::One)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static VERTEX_ROAD: ElementSchema = ElementSchema::new(
    "VertexRoad",
    &[
        attribute("dz", Kind::Double).only(from(V1_8)).by_text(from(V1_8)),
        attribute("radius", Kind::Double).only(from(V1_8)),
        attribute("intersectionPoint", Kind::Boolean).only(from(V1_8)),
        attribute("id", Kind::Uint).only(from(V1_8)).range(Range::AtLeast1, from(V1_4)),
        attribute("s", Kind::Double)
            .only(from(V1_8))
            .by_text(from(V1_8))
            .range(Range::AtLeast0, from(V1_4)),
        attribute("t", Kind::Double).only(from(V1_8)).by_text(from(V1_8)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static VERTEX_LOCAL: ElementSchema = ElementSchema::new(
    "VertexLocal",
    &[
        attribute("radius", Kind::Double).only(from(V1_8)),
        attribute("intersectionPoint", Kind::Boolean).only(from(V1_8)),
        attribute("id", Kind::Uint).only(from(V1_8)).range(Range::AtLeast1, from(V1_4)),
        attribute("u", Kind::Double).only(from(V1_8)).by_text(from(V1_8)),
        attribute("v", Kind::Double).only(from(V1_8)).by_text(from(V1_8)),
        attribute("z", Kind::Double).only(from(V1_8)).by_text(from(V1_8)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));
