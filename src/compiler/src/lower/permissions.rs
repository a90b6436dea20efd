//! Who may use a lane, and where lanes may be changed.

use crate::draft::{Access, Mark, Permissions};
use crate::options::MarkReading;
use mapd_archive::{LaneType, VehicleClass};
use mapd_xodr::{
    AccessRestrictionType as Restriction, AccessRule, LaneAccess, LaneChange, RoadMark,
    RoadMarkType, Value as _,
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

/// Classes that a set of records at one place leaves (OpenDRIVE 1.8.1, 11.8.1): where one allows, all others are banned;
/// `none` resets to what the lane's type says. A record without `rule` denies, which is what a restriction does.
fn classes(base: u16, set: &[LaneAccess]) -> u16 {
    let bits = |allow: bool| {
        let of_rule =
            |record: &&LaneAccess| (record.rule.value() == Some(AccessRule::Allow)) == allow;
        let named = set.iter().filter(of_rule).flat_map(|record| {
            let nested = record.restriction_element.iter().filter_map(|r| r.r#type.value());
            record.restriction.value().into_iter().chain(nested)
        });
        named.fold(0, |all, restriction| all | class_bits(restriction))
    };
    let (allowed, denied) = (bits(true), bits(false));
    let granted = if allowed == 0 { base } else { allowed };
    granted & !denied
}

/// Classes that a restriction names; 0 for `none` and unknown words.
fn class_bits(restriction: Restriction) -> u16 {
    match restriction {
        Restriction::Trucks => VehicleClass::Truck.bit(),
        named => VehicleClass::from_name(named.name()).bit(),
    }
}
