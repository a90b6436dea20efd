//! Reads the elements of `semantics`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/semantics.toml; change that file instead.

use super::schema_semantics::*;
use super::semantics::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for Semantics {
    fn schema() -> &'static ElementSchema {
        &SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.speed),
            1 => cursor.push(&mut self.lane),
            2 => cursor.push(&mut self.priority),
            3 => cursor.push(&mut self.prohibited),
            4 => cursor.push(&mut self.warning),
            5 => cursor.push(&mut self.routing),
            6 => cursor.push(&mut self.streetname),
            7 => cursor.push(&mut self.parking),
            8 => cursor.push(&mut self.tourist),
            9 => cursor.push(&mut self.supplementary_time),
            10 => cursor.push(&mut self.supplementary_allows),
            11 => cursor.push(&mut self.supplementary_prohibits),
            12 => cursor.push(&mut self.supplementary_distance),
            13 => cursor.push(&mut self.supplementary_environment),
            14 => cursor.push(&mut self.supplementary_explanatory),
            _ => {}
        }
    }
}

impl Element for SpeedSemantics {
    fn schema() -> &'static ElementSchema {
        &SPEED_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.r#type = cursor.word::<super::words::SpeedSemanticsKind>(),
            1 => self.value = cursor.double(),
            2 => self.unit = cursor.word::<super::words::UnitSpeed>(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.type_element),
            1 => cursor.put(&mut self.unit_element),
            2 => cursor.put(&mut self.value_element),
            _ => {}
        }
    }
}

impl Element for SpeedSemanticsType {
    fn schema() -> &'static ElementSchema {
        &SPEED_SEMANTICS_TYPE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn content(&mut self, cursor: &mut Cursor<'_>) {
        self.content = cursor.word::<super::words::SpeedSemanticsKind>();
    }
}

impl Element for SpeedSemanticsUnit {
    fn schema() -> &'static ElementSchema {
        &SPEED_SEMANTICS_UNIT
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn content(&mut self, cursor: &mut Cursor<'_>) {
        self.content = cursor.word::<super::words::UnitSpeed>();
    }
}

impl Element for SpeedSemanticsValue {
    fn schema() -> &'static ElementSchema {
        &SPEED_SEMANTICS_VALUE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn content(&mut self, cursor: &mut Cursor<'_>) {
        self.content = cursor.double();
    }
}

impl Element for LaneSemantics {
    fn schema() -> &'static ElementSchema {
        &LANE_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.r#type = cursor.word::<super::words::LaneSemanticsType>(),
            _ => {}
        }
    }
}

impl Element for PrioritySemantics {
    fn schema() -> &'static ElementSchema {
        &PRIORITY_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.r#type = cursor.word::<super::words::PrioritySemanticsType>(),
            _ => {}
        }
    }
}

impl Element for ProhibitedSemantics {
    fn schema() -> &'static ElementSchema {
        &PROHIBITED_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.animal),
            1 => cursor.push(&mut self.person),
            2 => cursor.push(&mut self.vehicle),
            _ => {}
        }
    }
}

impl Element for AnimalSemantics {
    fn schema() -> &'static ElementSchema {
        &ANIMAL_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
}

impl Element for PersonSemantics {
    fn schema() -> &'static ElementSchema {
        &PERSON_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.r#type),
            _ => {}
        }
    }
}

impl Element for PersonSemanticsType {
    fn schema() -> &'static ElementSchema {
        &PERSON_SEMANTICS_TYPE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn content(&mut self, cursor: &mut Cursor<'_>) {
        self.content = cursor.word::<super::words::PersonCategory>();
    }
}

impl Element for VehicleSemantics {
    fn schema() -> &'static ElementSchema {
        &VEHICLE_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.r#type),
            _ => {}
        }
    }
}

impl Element for VehicleSemanticsType {
    fn schema() -> &'static ElementSchema {
        &VEHICLE_SEMANTICS_TYPE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn content(&mut self, cursor: &mut Cursor<'_>) {
        self.content = cursor.word::<super::words::VehicleCategory>();
    }
}

impl Element for WarningSemantics {
    fn schema() -> &'static ElementSchema {
        &WARNING_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
}

impl Element for RoutingSemantics {
    fn schema() -> &'static ElementSchema {
        &ROUTING_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
}

impl Element for StreetnameSemantics {
    fn schema() -> &'static ElementSchema {
        &STREETNAME_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
}

impl Element for ParkingSemantics {
    fn schema() -> &'static ElementSchema {
        &PARKING_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
}

impl Element for TouristSemantics {
    fn schema() -> &'static ElementSchema {
        &TOURIST_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
}

impl Element for SupplementaryTimeSemantics {
    fn schema() -> &'static ElementSchema {
        &SUPPLEMENTARY_TIME_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.r#type = cursor.word::<super::words::TimeSemanticsType>(),
            1 => self.value = cursor.double(),
            _ => {}
        }
    }
}

impl Element for SupplementaryAllowsSemantics {
    fn schema() -> &'static ElementSchema {
        &SUPPLEMENTARY_ALLOWS_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.animal),
            1 => cursor.push(&mut self.person),
            2 => cursor.push(&mut self.vehicle),
            _ => {}
        }
    }
}

impl Element for SupplementaryProhibitsSemantics {
    fn schema() -> &'static ElementSchema {
        &SUPPLEMENTARY_PROHIBITS_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.animal),
            1 => cursor.push(&mut self.person),
            2 => cursor.push(&mut self.vehicle),
            _ => {}
        }
    }
}

impl Element for SupplementaryDistanceSemantics {
    fn schema() -> &'static ElementSchema {
        &SUPPLEMENTARY_DISTANCE_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.r#type = cursor.word::<super::words::DistanceSemanticsType>(),
            1 => self.value = cursor.double(),
            2 => self.unit = cursor.word::<super::words::UnitDistance>(),
            _ => {}
        }
    }
}

impl Element for SupplementaryEnvironmentSemantics {
    fn schema() -> &'static ElementSchema {
        &SUPPLEMENTARY_ENVIRONMENT_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.r#type = cursor.word::<super::words::EnvironmentSemanticsType>(),
            _ => {}
        }
    }
}

impl Element for SupplementaryExplanatorySemantics {
    fn schema() -> &'static ElementSchema {
        &SUPPLEMENTARY_EXPLANATORY_SEMANTICS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
}
