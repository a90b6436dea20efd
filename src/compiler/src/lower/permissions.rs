//! Who may use a lane, and where lanes may be changed.

use crate::draft::{Access, Mark, Permissions};
use mapd_archive::{LaneType, VehicleClass};
use mapd_xodr::{
    AccessRestrictionType as Restriction, AccessRule, LaneAccess, LaneChange, RoadMark, Value as _,
};

impl Permissions {
    /// Adds what a lane says; its records ascend. Lanes come in the order of their rows; `shift` is how far the row's stretch begins behind the
    /// section that the lane is written in.
    pub(crate) fn lane(
        &mut self,
        row: u32,
        shift: f64,
        kind: LaneType,
        marks: &[RoadMark],
        accesses: &[LaneAccess],
    ) {
        self.marks.extend(marks.iter().map(|mark| Mark {
            lane: row,
            s: mark.s_offset.value().unwrap_or(0.0) - shift,
            change: mark.lane_change.value().unwrap_or(LaneChange::Both),
        }));
        let base = VehicleClass::of_lane_type(kind);
        let s_of = |record: &LaneAccess| record.s_offset.value().unwrap_or(0.0) - shift;
        for set in accesses.chunk_by(|a, b| s_of(a) == s_of(b)) {
            let Some(s) = set.first().map(s_of) else { continue };
            self.accesses.push(Access { lane: row, s, classes: classes(base, set) });
        }
    }
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
