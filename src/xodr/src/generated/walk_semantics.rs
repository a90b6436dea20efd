//! Walks over the elements of `semantics`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/semantics.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Visit, Written, child, children};

impl Written for Semantics {
    fn kind(&self) -> &'static str {
        "Semantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("speed", &self.speed, visit);
        children("lane", &self.lane, visit);
        children("priority", &self.priority, visit);
        children("prohibited", &self.prohibited, visit);
        children("warning", &self.warning, visit);
        children("routing", &self.routing, visit);
        children("streetname", &self.streetname, visit);
        children("parking", &self.parking, visit);
        children("tourist", &self.tourist, visit);
        children("supplementaryTime", &self.supplementary_time, visit);
        children("supplementaryAllows", &self.supplementary_allows, visit);
        children("supplementaryProhibits", &self.supplementary_prohibits, visit);
        children("supplementaryDistance", &self.supplementary_distance, visit);
        children("supplementaryEnvironment", &self.supplementary_environment, visit);
        children("supplementaryExplanatory", &self.supplementary_explanatory, visit);
    }
}

impl Written for SpeedSemantics {
    fn kind(&self) -> &'static str {
        "SpeedSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        child("type", &self.type_element, visit);
        child("unit", &self.unit_element, visit);
        child("value", &self.value_element, visit);
    }
}

impl Written for SpeedSemanticsType {
    fn kind(&self) -> &'static str {
        "SpeedSemanticsType"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for SpeedSemanticsUnit {
    fn kind(&self) -> &'static str {
        "SpeedSemanticsUnit"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for SpeedSemanticsValue {
    fn kind(&self) -> &'static str {
        "SpeedSemanticsValue"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for LaneSemantics {
    fn kind(&self) -> &'static str {
        "LaneSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for PrioritySemantics {
    fn kind(&self) -> &'static str {
        "PrioritySemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for ProhibitedSemantics {
    fn kind(&self) -> &'static str {
        "ProhibitedSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("animal", &self.animal, visit);
        children("person", &self.person, visit);
        children("vehicle", &self.vehicle, visit);
    }
}

impl Written for AnimalSemantics {
    fn kind(&self) -> &'static str {
        "AnimalSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for PersonSemantics {
    fn kind(&self) -> &'static str {
        "PersonSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        child("type", &self.r#type, visit);
    }
}

impl Written for PersonSemanticsType {
    fn kind(&self) -> &'static str {
        "PersonSemanticsType"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for VehicleSemantics {
    fn kind(&self) -> &'static str {
        "VehicleSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        child("type", &self.r#type, visit);
    }
}

impl Written for VehicleSemanticsType {
    fn kind(&self) -> &'static str {
        "VehicleSemanticsType"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for WarningSemantics {
    fn kind(&self) -> &'static str {
        "WarningSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for RoutingSemantics {
    fn kind(&self) -> &'static str {
        "RoutingSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for StreetnameSemantics {
    fn kind(&self) -> &'static str {
        "StreetnameSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for ParkingSemantics {
    fn kind(&self) -> &'static str {
        "ParkingSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for TouristSemantics {
    fn kind(&self) -> &'static str {
        "TouristSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for SupplementaryTimeSemantics {
    fn kind(&self) -> &'static str {
        "SupplementaryTimeSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for SupplementaryAllowsSemantics {
    fn kind(&self) -> &'static str {
        "SupplementaryAllowsSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("animal", &self.animal, visit);
        children("person", &self.person, visit);
        children("vehicle", &self.vehicle, visit);
    }
}

impl Written for SupplementaryProhibitsSemantics {
    fn kind(&self) -> &'static str {
        "SupplementaryProhibitsSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("animal", &self.animal, visit);
        children("person", &self.person, visit);
        children("vehicle", &self.vehicle, visit);
    }
}

impl Written for SupplementaryDistanceSemantics {
    fn kind(&self) -> &'static str {
        "SupplementaryDistanceSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for SupplementaryEnvironmentSemantics {
    fn kind(&self) -> &'static str {
        "SupplementaryEnvironmentSemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for SupplementaryExplanatorySemantics {
    fn kind(&self) -> &'static str {
        "SupplementaryExplanatorySemantics"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}
