//! Elements of `semantics`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/semantics.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// What a signal means (`t_signals_semantics`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Semantics {
    /// The start tag.
    pub span: Span,
    /// `speed`: Meaning for speed.
    pub speed: Vec<SpeedSemantics>,
    /// `lane`: Meaning for lanes.
    pub lane: Vec<LaneSemantics>,
    /// `priority`: Meaning for priority.
    pub priority: Vec<PrioritySemantics>,
    /// `prohibited`: Something is prohibited.
    pub prohibited: Vec<ProhibitedSemantics>,
    /// `warning`: A warning.
    pub warning: Vec<WarningSemantics>,
    /// `routing`: Meaning for routes.
    pub routing: Vec<RoutingSemantics>,
    /// `streetname`: A street name.
    pub streetname: Vec<StreetnameSemantics>,
    /// `parking`: Meaning for parking.
    pub parking: Vec<ParkingSemantics>,
    /// `tourist`: Meaning for tourists.
    pub tourist: Vec<TouristSemantics>,
    /// `supplementaryTime`: Restricts a sign: time.
    pub supplementary_time: Vec<SupplementaryTimeSemantics>,
    /// `supplementaryAllows`: Restricts a sign: who is allowed.
    pub supplementary_allows: Vec<SupplementaryAllowsSemantics>,
    /// `supplementaryProhibits`: Restricts a sign: who is not allowed.
    pub supplementary_prohibits: Vec<SupplementaryProhibitsSemantics>,
    /// `supplementaryDistance`: Restricts a sign: distance.
    pub supplementary_distance: Vec<SupplementaryDistanceSemantics>,
    /// `supplementaryEnvironment`: Restricts a sign: weather.
    pub supplementary_environment: Vec<SupplementaryEnvironmentSemantics>,
    /// `supplementaryExplanatory`: Explains a sign.
    pub supplementary_explanatory: Vec<SupplementaryExplanatorySemantics>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Meaning for speed (`t_signals_semantics_speed`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpeedSemantics {
    /// The start tag.
    pub span: Span,
    /// `@type`: Kind. Required by the text since 1.8. Since 1.8.1.
    pub r#type: Option<Attribute<SpeedSemanticsKind>>,
    /// `@value`: Value. Required by the text since 1.8. Since 1.8.1.
    pub value: Option<Attribute<f64>>,
    /// `@unit`: Unit of the value. Required by the text since 1.8. Since 1.8.1.
    pub unit: Option<Attribute<UnitSpeed>>,
    /// `type`: Kind of speed, as text. In 1.8.
    pub type_element: Option<Box<SpeedSemanticsType>>,
    /// `unit`: Unit of the speed, as text. In 1.8.
    pub unit_element: Option<Box<SpeedSemanticsUnit>>,
    /// `value`: Speed, as text. In 1.8.
    pub value_element: Option<Box<SpeedSemanticsValue>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Kind of speed, as text (`e_signals_semantics_speed`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpeedSemanticsType {
    /// The start tag.
    pub span: Span,
    /// The text inside.
    pub content: Option<Attribute<SpeedSemanticsKind>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Unit of the speed, as text (`e_unitSpeed`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpeedSemanticsUnit {
    /// The start tag.
    pub span: Span,
    /// The text inside.
    pub content: Option<Attribute<UnitSpeed>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Speed, as text (`xs:double`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpeedSemanticsValue {
    /// The start tag.
    pub span: Span,
    /// The text inside.
    pub content: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Meaning for lanes (`t_signals_semantics_lane`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneSemantics {
    /// The start tag.
    pub span: Span,
    /// `@type`: Kind. Required by the text since 1.8.
    pub r#type: Option<Attribute<LaneSemanticsType>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Meaning for priority (`t_signals_semantics_priority`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PrioritySemantics {
    /// The start tag.
    pub span: Span,
    /// `@type`: Kind. Required by the text since 1.8.
    pub r#type: Option<Attribute<PrioritySemanticsType>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Something is prohibited (`t_signals_semantics_prohibited`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ProhibitedSemantics {
    /// The start tag.
    pub span: Span,
    /// `animal`: Animals are meant. Since 1.9.
    pub animal: Vec<AnimalSemantics>,
    /// `person`: Persons are meant. Since 1.9.
    pub person: Vec<PersonSemantics>,
    /// `vehicle`: Vehicles are meant. Since 1.9.
    pub vehicle: Vec<VehicleSemantics>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Animals are meant (`t_signals_semantics_animal`; section 14; since 1.9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AnimalSemantics {
    /// The start tag.
    pub span: Span,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Persons are meant (`t_signals_semantics_person`; section 14; since 1.9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PersonSemantics {
    /// The start tag.
    pub span: Span,
    /// `type`: Category of persons, as text.
    pub r#type: Option<Box<PersonSemanticsType>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Category of persons, as text (`e_personCategory`; section 14; since 1.9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PersonSemanticsType {
    /// The start tag.
    pub span: Span,
    /// The text inside.
    pub content: Option<Attribute<PersonCategory>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Vehicles are meant (`t_signals_semantics_vehicle`; section 14; since 1.9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VehicleSemantics {
    /// The start tag.
    pub span: Span,
    /// `type`: Category of vehicles, as text.
    pub r#type: Option<Box<VehicleSemanticsType>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Category of vehicles, as text (`e_vehicleCategory`; section 14; since 1.9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VehicleSemanticsType {
    /// The start tag.
    pub span: Span,
    /// The text inside.
    pub content: Option<Attribute<VehicleCategory>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A warning (`t_signals_semantics_warning`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WarningSemantics {
    /// The start tag.
    pub span: Span,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Meaning for routes (`t_signals_semantics_routing`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoutingSemantics {
    /// The start tag.
    pub span: Span,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A street name (`t_signals_semantics_streetname`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StreetnameSemantics {
    /// The start tag.
    pub span: Span,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Meaning for parking (`t_signals_semantics_parking`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ParkingSemantics {
    /// The start tag.
    pub span: Span,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Meaning for tourists (`t_signals_semantics_tourist`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TouristSemantics {
    /// The start tag.
    pub span: Span,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Restricts a sign: time (`t_signals_semantics_supplementaryTime`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SupplementaryTimeSemantics {
    /// The start tag.
    pub span: Span,
    /// `@type`: Kind. Required by the text since 1.8.
    pub r#type: Option<Attribute<TimeSemanticsType>>,
    /// `@value`: Value. Required by the text since 1.8.
    pub value: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Restricts a sign: who is allowed (`t_signals_semantics_supplementaryAllows`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SupplementaryAllowsSemantics {
    /// The start tag.
    pub span: Span,
    /// `animal`: Animals are meant. Since 1.9.
    pub animal: Vec<AnimalSemantics>,
    /// `person`: Persons are meant. Since 1.9.
    pub person: Vec<PersonSemantics>,
    /// `vehicle`: Vehicles are meant. Since 1.9.
    pub vehicle: Vec<VehicleSemantics>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Restricts a sign: who is not allowed (`t_signals_semantics_supplementaryProhibits`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SupplementaryProhibitsSemantics {
    /// The start tag.
    pub span: Span,
    /// `animal`: Animals are meant. Since 1.9.
    pub animal: Vec<AnimalSemantics>,
    /// `person`: Persons are meant. Since 1.9.
    pub person: Vec<PersonSemantics>,
    /// `vehicle`: Vehicles are meant. Since 1.9.
    pub vehicle: Vec<VehicleSemantics>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Restricts a sign: distance (`t_signals_semantics_supplementaryDistance`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SupplementaryDistanceSemantics {
    /// The start tag.
    pub span: Span,
    /// `@type`: Kind. Required by the text since 1.8.
    pub r#type: Option<Attribute<DistanceSemanticsType>>,
    /// `@value`: Value. Required by the text since 1.8.
    pub value: Option<Attribute<f64>>,
    /// `@unit`: Unit of the value. Required by the text since 1.8.
    pub unit: Option<Attribute<UnitDistance>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Restricts a sign: weather (`t_signals_semantics_supplementaryEnvironment`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SupplementaryEnvironmentSemantics {
    /// The start tag.
    pub span: Span,
    /// `@type`: Kind. Required by the text since 1.8.
    pub r#type: Option<Attribute<EnvironmentSemanticsType>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Explains a sign (`t_signals_semantics_supplementaryExplanatory`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SupplementaryExplanatorySemantics {
    /// The start tag.
    pub span: Span,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
