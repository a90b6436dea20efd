//! What a signal says itself that it means (OpenDRIVE 1.8.1, 14.5).

use super::speeds::is_of_speed;
use mapd_ontology::{Meaning, Ontology};
use mapd_xodr::{self as xodr, Semantics, Value as _};

/// A child of `semantics`.
#[derive(Clone, Copy, Default)]
pub(super) struct SemanticsEntry {
    /// The element's name.
    pub(super) element: &'static str,
    /// Its type.
    pub(super) kind: &'static str,
    pub(super) value: Option<f64>,
    pub(super) unit: &'static str,
    /// Whether it states a speed in what is no unit of speed.
    pub(super) is_unreadable: bool,
}

impl SemanticsEntry {
    pub(super) fn meaning(&self, ontology: &Ontology) -> Meaning {
        let value = self.value.filter(|_| !self.is_unreadable);
        ontology.semantics(self.element, self.kind, value, self.unit)
    }
}

/// Everything that `semantics` says, in the order of the schema.
pub(super) fn meant(semantics: &Semantics) -> Vec<SemanticsEntry> {
    let mut out = Vec::new();
    // 1.8.0 writes type, unit and value as elements.
    out.extend(semantics.speed.iter().map(|speed| {
        let old_kind = speed.type_element.as_ref().and_then(|e| e.content.value());
        let old_unit = speed.unit_element.as_ref().and_then(|e| e.content.value());
        let old_value = speed.value_element.as_ref().and_then(|e| e.content.value());
        let unit = speed.unit.value().or(old_unit).map(xodr::UnitSpeed::name);
        SemanticsEntry {
            element: "speed",
            kind: speed.r#type.value().or(old_kind).map_or("", xodr::SpeedSemanticsKind::name),
            value: speed.value.value().or(old_value),
            unit: unit.unwrap_or_default(),
            is_unreadable: !is_of_speed(unit),
        }
    }));
    let kind = |element, kind| SemanticsEntry { element, kind, ..SemanticsEntry::default() };
    out.extend(
        semantics
            .lane
            .iter()
            .map(|one| kind("lane", one.r#type.value().map_or("", xodr::LaneSemanticsType::name))),
    );
    out.extend(semantics.priority.iter().map(|one| {
        kind("priority", one.r#type.value().map_or("", xodr::PrioritySemanticsType::name))
    }));
    for one in &semantics.prohibited {
        concerned(PROHIBITED, &one.person, &one.vehicle, &one.animal, &mut out);
    }
    let plain = [
        ("warning", semantics.warning.len()),
        ("routing", semantics.routing.len()),
        ("streetname", semantics.streetname.len()),
        ("parking", semantics.parking.len()),
        ("tourist", semantics.tourist.len()),
    ];
    for (element, count) in plain {
        out.extend(std::iter::repeat_n(kind(element, ""), count));
    }
    out.extend(semantics.supplementary_time.iter().map(|one| SemanticsEntry {
        element: "supplementaryTime",
        kind: one.r#type.value().map_or("", xodr::TimeSemanticsType::name),
        value: one.value.value(),
        ..SemanticsEntry::default()
    }));
    out.extend(semantics.supplementary_distance.iter().map(|one| SemanticsEntry {
        element: "supplementaryDistance",
        kind: one.r#type.value().map_or("", xodr::DistanceSemanticsType::name),
        value: one.value.value(),
        unit: one.unit.value().map_or("", xodr::UnitDistance::name),
        is_unreadable: false,
    }));
    out.extend(semantics.supplementary_environment.iter().map(|one| {
        let name = one.r#type.value().map_or("", xodr::EnvironmentSemanticsType::name);
        kind("supplementaryEnvironment", name)
    }));
    for one in &semantics.supplementary_allows {
        concerned(ALLOWS, &one.person, &one.vehicle, &one.animal, &mut out);
    }
    for one in &semantics.supplementary_prohibits {
        concerned(PROHIBITS, &one.person, &one.vehicle, &one.animal, &mut out);
    }
    let explained = semantics.supplementary_explanatory.len();
    out.extend(std::iter::repeat_n(kind("supplementaryExplanatory", ""), explained));
    out
}

/// Names of an element that says who is meant: its own, and with its person, vehicle and animal (1.9).
type Names = [&'static str; 4];

const PROHIBITED: Names =
    ["prohibited", "prohibited/person", "prohibited/vehicle", "prohibited/animal"];
const ALLOWS: Names = [
    "supplementaryAllows",
    "supplementaryAllows/person",
    "supplementaryAllows/vehicle",
    "supplementaryAllows/animal",
];
const PROHIBITS: Names = [
    "supplementaryProhibits",
    "supplementaryProhibits/person",
    "supplementaryProhibits/vehicle",
    "supplementaryProhibits/animal",
];

/// The element itself, then whom it concerns: a row for each person, vehicle and animal that is named.
fn concerned(
    [own, person, vehicle, animal]: Names,
    persons: &[xodr::PersonSemantics],
    vehicles: &[xodr::VehicleSemantics],
    animals: &[xodr::AnimalSemantics],
    out: &mut Vec<SemanticsEntry>,
) {
    let kind = |element, kind| SemanticsEntry { element, kind, ..SemanticsEntry::default() };
    out.push(kind(own, ""));
    out.extend(persons.iter().map(|one| {
        let category = one.r#type.as_ref().and_then(|category| category.content.value());
        kind(person, category.map_or("", xodr::PersonCategory::name))
    }));
    out.extend(vehicles.iter().map(|one| {
        let category = one.r#type.as_ref().and_then(|category| category.content.value());
        kind(vehicle, category.map_or("", xodr::VehicleCategory::name))
    }));
    out.extend(animals.iter().map(|_| kind(animal, "")));
}
