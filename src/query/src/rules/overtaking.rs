//! Where signs forbid overtaking.

use super::last_sign::sign_before;
use crate::ids::SignalId;
use crate::lane::Lane;
use crate::signals::LaneSignal;
use mapd_archive::Class;

/// Which signs forbid overtaking at a place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct OvertakingRule {
    /// The sign that forbids it to all motor vehicles.
    pub all: Option<SignalId>,
    /// The sign that forbids it to trucks.
    pub trucks: Option<SignalId>,
}

impl Lane<'_> {
    /// The signs that forbid overtaking at s. A sign holds as one of speed does: from its place on, in driving direction,
    /// until another one ends it, over lanes that lead on alone, and not beyond a junction. What road marks forbid is with
    /// the lane graph's lane changes.
    pub fn overtaking_rule_at(&self, s: f64) -> OvertakingRule {
        let ban = |begin: Class, end: Class| {
            let is = |one: &LaneSignal<'_>, class: Class| one.signal().class() == class;
            let ends = |one: &LaneSignal<'_>| is(one, end) || is(one, Class::EndOfRestrictions);
            let sign = sign_before(self, s, |one| is(one, begin), ends)?;
            Some(sign.signal().signal_id())
        };
        OvertakingRule {
            all: ban(Class::NoOvertaking, Class::EndOfNoOvertaking),
            trucks: ban(Class::NoOvertakingByTrucks, Class::EndOfNoOvertakingByTrucks),
        }
    }
}
