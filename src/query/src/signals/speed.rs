//! Which speed limit holds on a lane, and who says so.

use super::lane::LaneSignal;
use super::last_sign::sign_before;
use crate::ids::SignalId;
use crate::lane::Lane;
use mapd_archive::{Class, SpeedKind};

/// Where a speed limit comes from, the strongest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SpeedOrigin {
    /// A sign.
    Signal,
    /// The lane's own record.
    Lane,
    /// The road's type.
    RoadType,
    /// The header's regulations for the road's type (1.8).
    Default,
    /// Nothing in the map.
    None,
}

/// The speed limit at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedRule {
    /// Limit `[m/s]`; infinite where there is none; `None` where the map says nothing.
    pub max: Option<f64>,
    /// Who says so.
    pub origin: SpeedOrigin,
    /// The sign, if one does.
    pub signal: Option<SignalId>,
}

impl<'a> Lane<'a> {
    /// The speed limit at s: sign before lane before road type before the header's regulations.
    ///
    /// A sign holds from its place on, in driving direction, until another sign ends or replaces it, over lanes that lead
    /// on alone, and not beyond a junction.
    pub fn speed_rule_at(&self, s: f64) -> SpeedRule {
        if !s.is_finite() {
            return SpeedRule { max: None, origin: SpeedOrigin::None, signal: None };
        }
        if let Some(sign) = sign_before(self, s, begins, ends) {
            let signal = sign.signal();
            let (max, signal) = (signal.value(), Some(signal.signal_id()));
            return SpeedRule { max, origin: SpeedOrigin::Signal, signal };
        }
        let limit = |kind: SpeedKind, value: f64| match kind {
            SpeedKind::Value => Some(value),
            SpeedKind::NoLimit => Some(f64::INFINITY),
            _ => None,
        };
        let rule = |max, origin| SpeedRule { max: Some(max), origin, signal: None };
        let own = self.speeds().take_while(|record| record.s <= s).last();
        if let Some(max) = own.and_then(|record| limit(record.kind, record.max)) {
            return rule(max, SpeedOrigin::Lane);
        }
        let of_road = self.road().types().take_while(|record| record.s <= s).last();
        if let Some(max) = of_road.and_then(|record| limit(record.speed_kind, record.speed)) {
            return rule(max, SpeedOrigin::RoadType);
        }
        let kind = of_road.map(|record| record.kind.code());
        let mut defaults = self.map.tables().default_speeds.iter();
        match kind.and_then(|kind| defaults.find(|row| row.kind() == kind)) {
            Some(row) => rule(row.max(), SpeedOrigin::Default),
            None => SpeedRule { max: None, origin: SpeedOrigin::None, signal: None },
        }
    }
}

fn begins(one: &LaneSignal<'_>) -> bool {
    let signal = one.signal();
    let limits = matches!(signal.class(), Class::SpeedLimit | Class::SpeedLimitZone);
    limits && signal.value().is_some()
}

fn ends(one: &LaneSignal<'_>) -> bool {
    matches!(
        one.signal().class(),
        Class::EndOfSpeedLimit | Class::EndOfSpeedLimitZone | Class::EndOfRestrictions
    )
}
