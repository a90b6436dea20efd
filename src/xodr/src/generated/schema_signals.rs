//! The schema of `signals`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/signals.toml; change that file instead.

use crate::generated::schema_objects::*;
use crate::generated::schema_semantics::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static SIGNALS: ElementSchema = ElementSchema::new(
    "Signals",
    &[],
    &[child("signal", &SIGNAL, 1), child("signalReference", &SIGNAL_REFERENCE, 2)],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static SIGNAL: ElementSchema = ElementSchema::new(
    "Signal",
    &[
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("name", Kind::Text),
        attribute("dynamic", Kind::YesNo).required(from(V1_5)),
        attribute("orientation", Kind::Words(&ORIENTATION)).required(from(V1_5)),
        attribute("country", Kind::Country).loose(between(V1_4, V1_4)),
        attribute("countryRevision", Kind::Text).only(from(V1_5)),
        attribute("type", Kind::Text).required(from(V1_5)),
        attribute("subtype", Kind::Text).required(from(V1_5)),
        attribute("value", Kind::Double),
        attribute("text", Kind::Text),
        attribute("unit", Kind::Words(&UNIT)),
        attribute("height", Kind::Double)
            .required(between(V1_5, V1_5))
            .range(Range::AtLeast0, from(V1_5)),
        attribute("length", Kind::Double).only(from(V1_8)).range(Range::AtLeast0, from(V1_4)),
        attribute("hOffset", Kind::Double),
        attribute("width", Kind::Double)
            .required(between(V1_5, V1_5))
            .range(Range::AtLeast0, from(V1_5)),
        attribute("roll", Kind::Double),
        attribute("pitch", Kind::Double),
        attribute("invalidated", Kind::XsBoolean).only(from(V1_9)),
        attribute("temporary", Kind::XsBoolean).only(from(V1_9)),
        attribute("s", Kind::Double)
            .required(between(V1_5, V1_7))
            .by_text(from(V1_8))
            .range(Range::AtLeast0, from(V1_5)),
        attribute("t", Kind::Double).required(between(V1_5, V1_7)).by_text(from(V1_8)),
        attribute("zOffset", Kind::Double).required(between(V1_5, V1_7)).by_text(from(V1_8)),
    ],
    &[
        child("validity", &LANE_VALIDITY, 1),
        child("dependency", &SIGNAL_DEPENDENCY, 2),
        child("reference", &SIGNAL_LINK, 3).only(from(V1_5)),
        child("positionInertial", &POSITION_INERTIAL, 4)
            .only(from(V1_5))
            .occurs(0, 1, from(V1_4))
            .choice(),
        child("positionRoad", &POSITION_ROAD, 5).only(from(V1_5)).occurs(0, 1, from(V1_4)).choice(),
        child("semantics", &SEMANTICS, 9).only(from(V1_8)).occurs(0, 1, from(V1_4)),
        child("staticBoard", &STATIC_BOARD, 9).only(from(V1_8)),
        child("vmsBoard", &VMS_BOARD, 9).only(from(V1_8)),
    ],
)
.key(0)
.choice(Choice::AtMostOne)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static SIGNAL_DEPENDENCY: ElementSchema = ElementSchema::new(
    "SignalDependency",
    &[attribute("id", Kind::Text).required(from(V1_5)), attribute("type", Kind::Text)],
    &[],
)
.additional(
    between(V1_4, V1_5) | from(V1_8),
    between(V1_4, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static SIGNAL_LINK: ElementSchema = ElementSchema::new(
    "SignalLink",
    &[
        attribute("elementType", Kind::Words(&REFERENCE_ELEMENT_TYPE))
            .only(from(V1_5))
            .required(from(V1_5)),
        attribute("elementId", Kind::Text).only(from(V1_5)).required(from(V1_5)),
        attribute("type", Kind::Text).only(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static POSITION_INERTIAL: ElementSchema = ElementSchema::new(
    "PositionInertial",
    &[
        attribute("x", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("y", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("z", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("hdg", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("pitch", Kind::Double).only(from(V1_5)),
        attribute("roll", Kind::Double).only(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static POSITION_ROAD: ElementSchema = ElementSchema::new(
    "PositionRoad",
    &[
        attribute("roadId", Kind::Text).only(from(V1_5)).required(from(V1_5)),
        attribute("s", Kind::Double)
            .only(from(V1_5))
            .required(from(V1_5))
            .range(Range::AtLeast0, from(V1_4)),
        attribute("t", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("zOffset", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("hOffset", Kind::Double).only(from(V1_5)).required(from(V1_5)),
        attribute("pitch", Kind::Double).only(from(V1_5)),
        attribute("roll", Kind::Double).only(from(V1_5)),
    ],
    &[],
)
.additional(
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
    between(V1_5, V1_5) | from(V1_8),
);

pub(crate) static STATIC_BOARD: ElementSchema = ElementSchema::new(
    "StaticBoard",
    &[],
    &[
        child("validity", &LANE_VALIDITY, 1).only(from(V1_8)),
        child("dependency", &SIGNAL_DEPENDENCY, 2).only(from(V1_8)),
        child("reference", &SIGNAL_LINK, 3).only(from(V1_8)),
        child("sign", &BOARD_SIGN, 7).only(from(V1_8)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static BOARD_SIGN: ElementSchema = ElementSchema::new(
    "BoardSign",
    &[
        attribute("id", Kind::Text).only(from(V1_8)).required(from(V1_8)),
        attribute("name", Kind::Text).only(from(V1_8)),
        attribute("dynamic", Kind::YesNo).only(from(V1_8)).required(from(V1_8)),
        attribute("orientation", Kind::Words(&ORIENTATION)).only(from(V1_8)).required(from(V1_8)),
        attribute("country", Kind::Country).only(from(V1_8)),
        attribute("countryRevision", Kind::Text).only(from(V1_8)),
        attribute("type", Kind::Text).only(from(V1_8)).required(from(V1_8)),
        attribute("subtype", Kind::Text).only(from(V1_8)).required(from(V1_8)),
        attribute("value", Kind::Double).only(from(V1_8)),
        attribute("text", Kind::Text).only(from(V1_8)),
        attribute("unit", Kind::Words(&UNIT)).only(from(V1_8)),
        attribute("height", Kind::Double).only(from(V1_8)).range(Range::AtLeast0, from(V1_4)),
        attribute("length", Kind::Double).only(from(V1_8)).range(Range::AtLeast0, from(V1_4)),
        attribute("hOffset", Kind::Double).only(from(V1_8)),
        attribute("width", Kind::Double).only(from(V1_8)).range(Range::AtLeast0, from(V1_4)),
        attribute("roll", Kind::Double).only(from(V1_8)),
        attribute("pitch", Kind::Double).only(from(V1_8)),
        attribute("invalidated", Kind::XsBoolean).only(from(V1_9)),
        attribute("temporary", Kind::XsBoolean).only(from(V1_9)),
        attribute("v", Kind::Double).only(from(V1_8)).by_text(from(V1_8)),
        attribute("z", Kind::Double).only(from(V1_8)).by_text(from(V1_8)),
    ],
    &[
        child("validity", &LANE_VALIDITY, 1).only(from(V1_8)),
        child("dependency", &SIGNAL_DEPENDENCY, 2).only(from(V1_8)),
        child("reference", &SIGNAL_LINK, 3).only(from(V1_8)),
        child("positionInertial", &POSITION_INERTIAL, 4)
            .only(from(V1_8))
            .occurs(0, 1, from(V1_4))
            .choice(),
        child("positionRoad", &POSITION_ROAD, 5).only(from(V1_8)).occurs(0, 1, from(V1_4)).choice(),
        child("semantics", &SEMANTICS, 9).only(from(V1_8)).occurs(0, 1, from(V1_4)),
        child("staticBoard", &STATIC_BOARD, 9).only(between(V1_8, V1_8)),
        child("vmsBoard", &VMS_BOARD, 9).only(between(V1_8, V1_8)),
    ],
)
.choice(Choice::AtMostOne)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static VMS_BOARD: ElementSchema = ElementSchema::new(
    "VmsBoard",
    &[
        attribute("displayHeight", Kind::Double).only(from(V1_8)),
        attribute("displayType", Kind::Words(&DISPLAY_TYPE)).only(from(V1_8)).by_text(from(V1_8)),
        attribute("displayWidth", Kind::Double).only(from(V1_8)),
        attribute("v", Kind::Double).only(from(V1_8)).by_text(from(V1_8)),
        attribute("z", Kind::Double).only(from(V1_8)).by_text(from(V1_8)),
    ],
    &[
        child("validity", &LANE_VALIDITY, 1).only(from(V1_8)),
        child("dependency", &SIGNAL_DEPENDENCY, 2).only(from(V1_8)),
        child("reference", &SIGNAL_LINK, 3).only(from(V1_8)),
        child("displayArea", &DISPLAY_AREA, 7).only(from(V1_8)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static DISPLAY_AREA: ElementSchema = ElementSchema::new(
    "DisplayArea",
    &[
        attribute("height", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
        attribute("index", Kind::Int).only(from(V1_8)).by_text(from(V1_8)),
        attribute("v", Kind::Double).only(from(V1_8)).by_text(from(V1_8)),
        attribute("width", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
        attribute("z", Kind::Double).only(from(V1_8)).by_text(from(V1_8)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static SIGNAL_REFERENCE: ElementSchema = ElementSchema::new(
    "SignalReference",
    &[
        attribute("s", Kind::Double).required(from(V1_5)).range(Range::AtLeast0, from(V1_5)),
        attribute("t", Kind::Double).required(from(V1_5)),
        attribute("id", Kind::Text).required(from(V1_5)),
        attribute("orientation", Kind::Words(&ORIENTATION)).required(from(V1_5)),
    ],
    &[child("validity", &LANE_VALIDITY, 1)],
)
.additional(from(V1_4), from(V1_4), from(V1_5));

pub(crate) static VMS_GROUP: ElementSchema = ElementSchema::new(
    "VmsGroup",
    &[attribute("id", Kind::Text).only(from(V1_8)).by_text(from(V1_8))],
    &[child("vmsBoardReference", &VMS_BOARD_REFERENCE, 1).only(from(V1_8)).occurs(
        1,
        MANY,
        from(V1_4),
    )],
)
.key(0)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static VMS_BOARD_REFERENCE: ElementSchema = ElementSchema::new(
    "VmsBoardReference",
    &[
        attribute("signalId", Kind::Text).only(from(V1_8)).by_text(from(V1_8)),
        attribute("vmsIndex", Kind::Int).only(from(V1_8)).by_text(from(V1_8)),
        attribute("groupIndex", Kind::Int).only(from(V1_8)).by_text(from(V1_8)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));
