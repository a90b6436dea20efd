//! The schema of `semantics`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/semantics.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use crate::generated::schema_words::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::schema::{
    Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9,
    attribute, between, child, from,
};

pub(crate) static SEMANTICS: ElementSchema = ElementSchema::new(
    "Semantics",
    &[],
    &[
        child("speed", &SPEED_SEMANTICS, 1).only(from(V1_8)),
        child("lane", &LANE_SEMANTICS, 2).only(from(V1_8)),
        child("priority", &PRIORITY_SEMANTICS, 3).only(from(V1_8)),
        child("prohibited", &PROHIBITED_SEMANTICS, 4).only(from(V1_8)),
        child("warning", &WARNING_SEMANTICS, 5).only(from(V1_8)),
        child("routing", &ROUTING_SEMANTICS, 6).only(from(V1_8)),
        child("streetname", &STREETNAME_SEMANTICS, 7).only(from(V1_8)),
        child("parking", &PARKING_SEMANTICS, 8).only(from(V1_8)),
        child("tourist", &TOURIST_SEMANTICS, 9).only(from(V1_8)),
        child("supplementaryTime", &SUPPLEMENTARY_TIME_SEMANTICS, 10).only(from(V1_8)),
        child("supplementaryAllows", &SUPPLEMENTARY_ALLOWS_SEMANTICS, 11).only(from(V1_8)),
        child("supplementaryProhibits", &SUPPLEMENTARY_PROHIBITS_SEMANTICS, 12).only(from(V1_8)),
        child("supplementaryDistance", &SUPPLEMENTARY_DISTANCE_SEMANTICS, 13).only(from(V1_8)),
        child("supplementaryEnvironment", &SUPPLEMENTARY_ENVIRONMENT_SEMANTICS, 14)
            .only(from(V1_8)),
        child("supplementaryExplanatory", &SUPPLEMENTARY_EXPLANATORY_SEMANTICS, 15)
            .only(from(V1_8)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static SPEED_SEMANTICS: ElementSchema = ElementSchema::new(
    "SpeedSemantics",
    &[
        attribute("type", Kind::Words(&SPEED_SEMANTICS_KIND))
            .only(from(V1_8_1))
            .by_text(from(V1_8_1)),
        attribute("value", Kind::Double).only(from(V1_8_1)).by_text(from(V1_8_1)),
        attribute("unit", Kind::Words(&UNIT_SPEED)).only(from(V1_8_1)).by_text(from(V1_8_1)),
    ],
    &[
        child("type", &SPEED_SEMANTICS_TYPE, 1).only(between(V1_8, V1_8)).occurs(1, 1, from(V1_4)),
        child("unit", &SPEED_SEMANTICS_UNIT, 2).only(between(V1_8, V1_8)).occurs(1, 1, from(V1_4)),
        child("value", &SPEED_SEMANTICS_VALUE, 3).only(between(V1_8, V1_8)).occurs(
            1,
            1,
            from(V1_4),
        ),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static SPEED_SEMANTICS_TYPE: ElementSchema =
    ElementSchema::new("SpeedSemanticsType", &[], &[]).content(Kind::Words(&SPEED_SEMANTICS_KIND));

pub(crate) static SPEED_SEMANTICS_UNIT: ElementSchema =
    ElementSchema::new("SpeedSemanticsUnit", &[], &[]).content(Kind::Words(&UNIT_SPEED));

pub(crate) static SPEED_SEMANTICS_VALUE: ElementSchema =
    ElementSchema::new("SpeedSemanticsValue", &[], &[]).content(Kind::Double);

pub(crate) static LANE_SEMANTICS: ElementSchema = ElementSchema::new(
    "LaneSemantics",
    &[attribute("type", Kind::Words(&LANE_SEMANTICS_TYPE)).only(from(V1_8)).by_text(from(V1_8))],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static PRIORITY_SEMANTICS: ElementSchema = ElementSchema::new(
    "PrioritySemantics",
    &[attribute("type", Kind::Words(&PRIORITY_SEMANTICS_TYPE))
        .only(from(V1_8))
        .by_text(from(V1_8))],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static PROHIBITED_SEMANTICS: ElementSchema = ElementSchema::new(
    "ProhibitedSemantics",
    &[],
    &[
        child("animal", &ANIMAL_SEMANTICS, 4).only(from(V1_9)),
        child("person", &PERSON_SEMANTICS, 5).only(from(V1_9)),
        child("vehicle", &VEHICLE_SEMANTICS, 6).only(from(V1_9)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static ANIMAL_SEMANTICS: ElementSchema = ElementSchema::new("AnimalSemantics", &[], &[]);

pub(crate) static PERSON_SEMANTICS: ElementSchema = ElementSchema::new(
    "PersonSemantics",
    &[],
    &[child("type", &PERSON_SEMANTICS_TYPE, 1).only(from(V1_9)).occurs(1, 1, from(V1_4))],
);

pub(crate) static PERSON_SEMANTICS_TYPE: ElementSchema =
    ElementSchema::new("PersonSemanticsType", &[], &[]).content(Kind::Words(&PERSON_CATEGORY));

pub(crate) static VEHICLE_SEMANTICS: ElementSchema = ElementSchema::new(
    "VehicleSemantics",
    &[],
    &[child("type", &VEHICLE_SEMANTICS_TYPE, 1).only(from(V1_9)).occurs(1, 1, from(V1_4))],
);

pub(crate) static VEHICLE_SEMANTICS_TYPE: ElementSchema =
    ElementSchema::new("VehicleSemanticsType", &[], &[]).content(Kind::Words(&VEHICLE_CATEGORY));

pub(crate) static WARNING_SEMANTICS: ElementSchema =
    ElementSchema::new("WarningSemantics", &[], &[]).additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static ROUTING_SEMANTICS: ElementSchema =
    ElementSchema::new("RoutingSemantics", &[], &[]).additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static STREETNAME_SEMANTICS: ElementSchema = ElementSchema::new(
    "StreetnameSemantics",
    &[],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static PARKING_SEMANTICS: ElementSchema =
    ElementSchema::new("ParkingSemantics", &[], &[]).additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static TOURIST_SEMANTICS: ElementSchema =
    ElementSchema::new("TouristSemantics", &[], &[]).additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static SUPPLEMENTARY_TIME_SEMANTICS: ElementSchema = ElementSchema::new(
    "SupplementaryTimeSemantics",
    &[
        attribute("type", Kind::Words(&TIME_SEMANTICS_TYPE)).only(from(V1_8)).by_text(from(V1_8)),
        attribute("value", Kind::Double).only(from(V1_8)).by_text(from(V1_8)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static SUPPLEMENTARY_ALLOWS_SEMANTICS: ElementSchema = ElementSchema::new(
    "SupplementaryAllowsSemantics",
    &[],
    &[
        child("animal", &ANIMAL_SEMANTICS, 4).only(from(V1_9)),
        child("person", &PERSON_SEMANTICS, 5).only(from(V1_9)),
        child("vehicle", &VEHICLE_SEMANTICS, 6).only(from(V1_9)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static SUPPLEMENTARY_PROHIBITS_SEMANTICS: ElementSchema = ElementSchema::new(
    "SupplementaryProhibitsSemantics",
    &[],
    &[
        child("animal", &ANIMAL_SEMANTICS, 4).only(from(V1_9)),
        child("person", &PERSON_SEMANTICS, 5).only(from(V1_9)),
        child("vehicle", &VEHICLE_SEMANTICS, 6).only(from(V1_9)),
    ],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static SUPPLEMENTARY_DISTANCE_SEMANTICS: ElementSchema = ElementSchema::new(
    "SupplementaryDistanceSemantics",
    &[
        attribute("type", Kind::Words(&DISTANCE_SEMANTICS_TYPE))
            .only(from(V1_8))
            .by_text(from(V1_8)),
        attribute("value", Kind::Double).only(from(V1_8)).by_text(from(V1_8)),
        attribute("unit", Kind::Words(&UNIT_DISTANCE)).only(from(V1_8)).by_text(from(V1_8)),
    ],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static SUPPLEMENTARY_ENVIRONMENT_SEMANTICS: ElementSchema = ElementSchema::new(
    "SupplementaryEnvironmentSemantics",
    &[attribute("type", Kind::Words(&ENVIRONMENT_SEMANTICS_TYPE))
        .only(from(V1_8))
        .by_text(from(V1_8))],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));

pub(crate) static SUPPLEMENTARY_EXPLANATORY_SEMANTICS: ElementSchema = ElementSchema::new(
    "SupplementaryExplanatorySemantics",
    &[],
    &[],
)
.additional(from(V1_4), from(V1_4), from(V1_4));
