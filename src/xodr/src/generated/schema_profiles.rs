//! The schema of `profiles`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/profiles.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static ELEVATION_PROFILE: ElementSchema = ElementSchema::new(
    "ElevationProfile",
    &[],
    &[child("elevation", &ELEVATION, 1).occurs(1, MANY, between(V1_4, V1_5))],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static ELEVATION: ElementSchema = ElementSchema::new(
    "Elevation",
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

pub(crate) static LATERAL_PROFILE: ElementSchema = ElementSchema::new(
    "LateralProfile",
    &[],
    &[
        child("superelevation", &SUPERELEVATION, 1),
        child("crossfall", &CROSSFALL, 2).only(between(V1_4, V1_5)),
        child("shape", &SHAPE, 3),
        child("crossSectionSurface", &CROSS_SECTION_SURFACE, 4).only(from(V1_8)).occurs(
            0,
            1,
            from(V1_4),
        ),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static SUPERELEVATION: ElementSchema = ElementSchema::new(
    "Superelevation",
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

pub(crate) static CROSSFALL: ElementSchema = ElementSchema::new(
    "Crossfall",
    &[
        attribute("side", Kind::Words(&CROSSFALL_SIDE))
            .only(between(V1_4, V1_5))
            .required(between(V1_5, V1_5)),
        attribute("s", Kind::Double)
            .only(between(V1_4, V1_5))
            .required(between(V1_5, V1_5))
            .range(Range::AtLeast0, from(V1_5)),
        attribute("a", Kind::Double).only(between(V1_4, V1_5)).required(between(V1_5, V1_5)),
        attribute("b", Kind::Double).only(between(V1_4, V1_5)).required(between(V1_5, V1_5)),
        attribute("c", Kind::Double).only(between(V1_4, V1_5)).required(between(V1_5, V1_5)),
        attribute("d", Kind::Double).only(between(V1_4, V1_5)).required(between(V1_5, V1_5)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static SHAPE: ElementSchema = ElementSchema::new(
    "Shape",
    &[
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("t", Kind::Double).required(from(V1_5)),
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

pub(crate) static CROSS_SECTION_SURFACE: ElementSchema = ElementSchema::new(
    "CrossSectionSurface",
    &[],
    &[
        child("tOffset", &SURFACE_OFFSET, 1).only(from(V1_8)).occurs(0, 1, from(V1_4)),
        child("surfaceStrips", &SURFACE_STRIPS, 2).only(from(V1_8)).occurs(1, 1, from(V1_4)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static SURFACE_OFFSET: ElementSchema = ElementSchema::new(
    "SurfaceOffset",
    &[],
    &[child("coefficients", &COEFFICIENTS, 1).only(from(V1_8)).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static COEFFICIENTS: ElementSchema = ElementSchema::new(
    "Coefficients",
    &[
        attribute("a", Kind::Double).only(from(V1_8)),
        attribute("b", Kind::Double).only(from(V1_8)),
        attribute("c", Kind::Double).only(from(V1_8)),
        attribute("d", Kind::Double).only(from(V1_8)),
        attribute("s", Kind::Double)
            .only(from(V1_8))
            .by_text(from(V1_8))
            .range(Range::AtLeast0, from(V1_4)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static SURFACE_STRIPS: ElementSchema = ElementSchema::new(
    "SurfaceStrips",
    &[],
    &[child("strip", &STRIP, 1).only(from(V1_8)).occurs(1, 4, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static STRIP: ElementSchema = ElementSchema::new(
    "Strip",
    &[
        attribute("id", Kind::Int).only(from(V1_8)).by_text(from(V1_8)),
        attribute("mode", Kind::Words(&STRIP_MODE)).only(from(V1_8)),
    ],
    &[
        child("width", &STRIP_WIDTH, 1).only(from(V1_8)).occurs(0, 1, from(V1_4)),
        child("constant", &STRIP_CONSTANT, 2).only(from(V1_8)).occurs(0, 1, from(V1_4)),
        child("linear", &STRIP_LINEAR, 3).only(from(V1_8)).occurs(0, 1, from(V1_4)),
        child("quadratic", &STRIP_QUADRATIC, 4).only(from(V1_8)).occurs(0, 1, from(V1_4)),
        child("cubic", &STRIP_CUBIC, 5).only(from(V1_8)).occurs(0, 1, from(V1_4)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static STRIP_WIDTH: ElementSchema = ElementSchema::new(
    "StripWidth",
    &[],
    &[child("coefficients", &COEFFICIENTS, 1).only(from(V1_8)).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static STRIP_CONSTANT: ElementSchema = ElementSchema::new(
    "StripConstant",
    &[],
    &[child("coefficients", &COEFFICIENTS, 1).only(from(V1_8)).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static STRIP_LINEAR: ElementSchema = ElementSchema::new(
    "StripLinear",
    &[],
    &[child("coefficients", &COEFFICIENTS, 4).only(from(V1_8)).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static STRIP_QUADRATIC: ElementSchema = ElementSchema::new(
    "StripQuadratic",
    &[],
    &[child("coefficients", &COEFFICIENTS, 1).only(from(V1_8)).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static STRIP_CUBIC: ElementSchema = ElementSchema::new(
    "StripCubic",
    &[],
    &[child("coefficients", &COEFFICIENTS, 1).only(from(V1_8)).occurs(1, MANY, from(V1_4))],
)
.additional(from(V1_4), from(V1_4), from(V1_4));
