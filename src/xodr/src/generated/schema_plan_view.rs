//! The schema of `plan_view`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/plan_view.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static PLAN_VIEW: ElementSchema = ElementSchema::new(
    "PlanView",
    &[],
    &[child("geometry", &GEOMETRY, 1).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_5), from(V1_5), from(V1_5));

pub(crate) static GEOMETRY: ElementSchema = ElementSchema::new(
    "Geometry",
    &[
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("x", Kind::Double).required(from(V1_5)),
        attribute("y", Kind::Double).required(from(V1_5)),
        attribute("hdg", Kind::Double).required(from(V1_5)),
        attribute("length", Kind::Double)
            .required(from(V1_5))
            .loose(between(V1_6, V1_6))
            .range(Range::AtLeast0, between(V1_5, V1_5))
            .range(Range::Above0, from(V1_7)),
    ],
    &[
        child("line", &LINE, 1).occurs(1, 1, from(V1_4)).choice(),
        child("spiral", &SPIRAL, 2).occurs(1, 1, from(V1_4)).choice(),
        child("arc", &ARC, 3).occurs(1, 1, from(V1_4)).choice(),
        child("poly3", &POLY3, 4).occurs(1, 1, from(V1_4)).choice(),
        child("paramPoly3", &PARAM_POLY3, 5).occurs(1, 1, from(V1_4)).choice(),
    ],
)
.key(0)
.choice(Choice::One)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static LINE: ElementSchema = ElementSchema::new("Line", &[], &[]).additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static SPIRAL: ElementSchema = ElementSchema::new(
    "Spiral",
    &[
        attribute("curvStart", Kind::Double).required(from(V1_5)),
        attribute("curvEnd", Kind::Double).required(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static ARC: ElementSchema =
    ElementSchema::new("Arc", &[attribute("curvature", Kind::Double).required(from(V1_5))], &[])
        .additional(
            between(V1_4, V1_5) | from(V1_8),
            between(V1_4, V1_5) | from(V1_8),
            between(V1_5, V1_5) | from(V1_8),
        );

pub(crate) static POLY3: ElementSchema = ElementSchema::new(
    "Poly3",
    &[
        attribute("a", Kind::Double).required(from(V1_5)).deprecated(from(V1_8)),
        attribute("b", Kind::Double).required(from(V1_5)).deprecated(from(V1_8)),
        attribute("c", Kind::Double).required(from(V1_5)).deprecated(from(V1_8)),
        attribute("d", Kind::Double).required(from(V1_5)).deprecated(from(V1_8)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static PARAM_POLY3: ElementSchema = ElementSchema::new(
    "ParamPoly3",
    &[
        attribute("aU", Kind::Double).required(from(V1_5)),
        attribute("bU", Kind::Double).required(from(V1_5)),
        attribute("cU", Kind::Double).required(from(V1_5)),
        attribute("dU", Kind::Double).required(from(V1_5)),
        attribute("aV", Kind::Double).required(from(V1_5)),
        attribute("bV", Kind::Double).required(from(V1_5)),
        attribute("cV", Kind::Double).required(from(V1_5)),
        attribute("dV", Kind::Double).required(from(V1_5)),
        attribute("pRange", Kind::Words(&PARAM_POLY3_RANGE)).required(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);
