//! Who may use a lane, and where lanes may be changed.

use crate::draft::{Access, Mark, Permissions};
use crate::options::MarkReading;
use mapd_archive::{LaneType, VehicleClass};
use mapd_xodr::{
    AccessRule, LaneAccess, LaneChange, RoadMark, RoadMarkType, Text as _, Value as _,
};

impl Permissions {
    /// Adds what a lane says; its records ascend. Lanes come in the order of their rows; `shift` is how far the row's stretch begins behind the
    /// section that the lane is written in.
    pub(crate) fn lane(
        &mut self,
        row: u32,
        shift: f64,
        (number, kind): (i32, LaneType),
        marks: &[RoadMark],
        accesses: &[LaneAccess],
    ) {
        let unsaid = |mark: &RoadMark| match self.reading {
            // OpenDRIVE 1.8.1, 11.9.
            MarkReading::Standard => LaneChange::Both,
            MarkReading::Type => by_type(mark.r#type.value(), number),
        };
        let marks = marks.iter().map(|mark| Mark {
            lane: row,
            s: mark.s_offset.value().unwrap_or(0.0) - shift,
            change: mark.lane_change.value().unwrap_or_else(|| unsaid(mark)),
        });
        self.marks.extend(marks);
        let base = VehicleClass::of_lane_type(kind);
        let s_of = |record: &LaneAccess| record.s_offset.value().unwrap_or(0.0) - shift;
        for set in accesses.chunk_by(|a, b| s_of(a) == s_of(b)) {
            let Some(s) = set.first().map(s_of) else { continue };
            self.accesses.push(Access { lane: row, s, classes: classes(base, set) });
        }
    }
}

/// Which changes a mark's type allows, on the outer border of the lane of a number. The two lines of a mark are named from lane 0 outwards, and those of lane 0
/// from left to right (OpenDRIVE 1.8.1, 11.9); nobody crosses a solid line from its own side.
fn by_type(kind: Option<RoadMarkType>, number: i32) -> LaneChange {
    use RoadMarkType as T;
    let first_is_solid = match kind {
        Some(T::Solid | T::SolidSolid | T::Curb | T::Grass | T::Edge) => return LaneChange::None,
        Some(T::SolidBroken) => true,
        Some(T::BrokenSolid) => false,
        _ => return LaneChange::Both,
    };
    // The first line is the one beside the higher number, but to the left of lane 0.
    let higher_is_solid = first_is_solid != (number > 0);
    if higher_is_solid { LaneChange::Increase } else { LaneChange::Decrease }
}

/// Other words for a class than its own: older ones of the standard, and such as files have.
const SYNONYMS: [(&str, VehicleClass); 3] = [
    ("trucks", VehicleClass::Truck),
    ("lorry", VehicleClass::Truck),
    ("autonomous traffic", VehicleClass::Autonomous),
];

/// Whom a restriction names.
#[derive(Clone, Copy)]
enum Named {
    /// No restriction.
    None,
    Class(VehicleClass),
    /// Nobody that is known: there is no word, or one that the standard does not have.
    Open,
}

/// Whom a record names: by its own attribute, and by its elements of 1.8.
fn named(record: &LaneAccess) -> impl Iterator<Item = Named> {
    let own = record.restriction.as_ref().map(|word| &*word.value);
    let nested = record.restriction_element.iter().map(|one| one.r#type.text());
    // A record that names nobody at all has one word that is missing.
    let missing = (own.is_none() && record.restriction_element.is_empty()).then_some("");
    own.into_iter().chain(nested).chain(missing).map(|word| match word {
        "none" => Named::None,
        word => {
            let synonym = SYNONYMS.iter().find(|(other, _)| *other == word);
            match synonym.map_or_else(|| VehicleClass::from_name(word), |(_, class)| *class) {
                VehicleClass::Unknown => Named::Open,
                class => Named::Class(class),
            }
        }
    })
}

/// Whether a record does not say whom it is about.
pub(super) fn is_open(record: &LaneAccess) -> bool {
    named(record).any(|one| matches!(one, Named::Open))
}

/// Classes that a set of records at one place leaves (OpenDRIVE 1.8.1, 11.8.1): where one allows, all others are banned;
/// `none` resets to what the lane's type says. A record without `rule` denies, which is what a restriction does. One that does not say who is meant leaves
/// nothing open that it might close: it denies all motor vehicles, or allows nobody.
fn classes(base: u16, set: &[LaneAccess]) -> u16 {
    let (mut allowed, mut denied, mut allows) = (0, 0, false);
    for record in set {
        let is_allow = record.rule.value() == Some(AccessRule::Allow);
        for one in named(record) {
            match one {
                Named::None => {}
                Named::Class(class) if is_allow => allowed |= class.bit(),
                Named::Class(class) => denied |= class.bit(),
                Named::Open if is_allow => {}
                Named::Open => denied |= VehicleClass::MOTOR,
            }
            allows |= is_allow && !matches!(one, Named::None);
        }
    }
    let granted = if allows { allowed } else { base };
    granted & !denied
}
