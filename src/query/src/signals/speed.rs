//! Which speed limit holds on a lane, and who says so.

use super::lane::LaneSignal;
use crate::ids::SignalId;
use crate::lane::Lane;
use mapd_archive::{Class, SpeedKind};

/// Lanes that are followed back at most to find a sign; a damaged archive might lead round in a circle.
const MOST_LANES: usize = 4096;

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
        if let Some(sign) = self.speed_sign_before(s) {
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

    /// The sign whose limit holds at s; none if the last one ended it.
    fn speed_sign_before(&self, s: f64) -> Option<LaneSignal<'a>> {
        let (mut lane, mut until) = (*self, Some(s));
        for _ in 0..MOST_LANES {
            let forward = lane.is_forward();
            let passed = |one: &LaneSignal<'a>| match until {
                None => true,
                Some(s) if forward => one.s_on(&lane) <= s,
                Some(s) => one.s_on(&lane) >= s,
            };
            let speaks = lane
                .signals()
                .filter(|one| one.is_for(forward) && is_about_speed(one) && passed(one));
            // In ascending s: the last one passed is the last or the first.
            let last = if forward { speaks.last() } else { first(speaks) };
            if let Some(last) = last {
                return Some(last).filter(|one| begins(one));
            }
            let map = lane.map;
            let mut before = lane.predecessors().filter_map(|id| Lane::new(map, id.row()));
            let next = before.next().filter(|_| before.next().is_none())?;
            // A lane of a junction leads on from many; a sign before it does not reach beyond it.
            let in_junction = |lane: &Lane<'a>| lane.road().junction_row().is_some();
            if in_junction(&next) || in_junction(&lane) {
                return None;
            }
            (lane, until) = (next, None);
        }
        None
    }
}

/// Of signs at one place, the one that begins a limit.
fn first<'a>(mut signs: impl Iterator<Item = LaneSignal<'a>>) -> Option<LaneSignal<'a>> {
    let found = signs.next()?;
    let same = signs.take_while(|one| one.place().s() == found.place().s());
    Some(same.fold(found, |best, one| if begins(&best) { best } else { one }))
}

fn begins(one: &LaneSignal<'_>) -> bool {
    let signal = one.signal();
    let limits = matches!(signal.class(), Class::SpeedLimit | Class::SpeedLimitZone);
    limits && signal.value().is_some()
}

fn is_about_speed(one: &LaneSignal<'_>) -> bool {
    let ends = matches!(
        one.signal().class(),
        Class::EndOfSpeedLimit | Class::EndOfSpeedLimitZone | Class::EndOfRestrictions
    );
    !one.signal().is_invalidated() && (ends || begins(one))
}
