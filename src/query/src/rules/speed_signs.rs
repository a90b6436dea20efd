//! Which signs of speed hold where: what comes in with the traffic, and what the lane's own signs make of it.

use super::last_sign::sign_before;
use crate::lane::Lane;
use crate::signals::{LaneSignal, Signal};
use mapd_archive::Class;

/// A zone that holds.
#[derive(Clone, Copy)]
pub enum Zone<'a> {
    /// None.
    None,
    /// The one that a sign begins.
    Of(Signal<'a>),
    /// It depends on the way that one has come. The sign of the lowest of those that may hold; none where nobody knows which.
    Depends(Option<Signal<'a>>),
}

/// Signs of speed that hold at a place. A limit goes before a zone, and holds as far as lanes lead on alone and not beyond a junction;
/// a zone until a sign ends it.
#[derive(Clone, Copy)]
pub struct SpeedSigns<'a> {
    /// The sign of a limit.
    pub limit: Option<Signal<'a>>,
    /// The zone.
    pub zone: Zone<'a>,
}

impl SpeedSigns<'_> {
    /// None at all.
    pub const NONE: Self = Self { limit: None, zone: Zone::None };
}

/// The last sign about something that is passed, and whether it begins something.
#[derive(Clone, Copy)]
struct Last<'a> {
    /// How far along the lane's traffic `[m]`.
    along: f64,
    begins: Option<Signal<'a>>,
}

impl<'a> Last<'a> {
    /// Notes a sign: what stands farther on counts, at one place what begins something.
    fn note(last: &mut Option<Self>, along: f64, begins: Option<Signal<'a>>) {
        let wins = last.is_none_or(|last| {
            along > last.along || (along == last.along && last.begins.is_none())
        });
        if wins {
            *last = Some(Self { along, begins });
        }
    }
}

impl<'a> Lane<'a> {
    /// The signs that hold where the lane's traffic enters it, as the archive has them.
    pub(crate) fn speed_signs_at_entry(&self) -> SpeedSigns<'a> {
        let rows = self.map.tables().speed_signs_at_entry;
        if rows.is_empty() && !self.map.tables().signal_lanes.is_empty() {
            return self.signs_of_lanes_before();
        }
        let own = self.row_number();
        let row =
            rows.binary_search_by_key(&own, |row| row.lane()).ok().and_then(|at| rows.get(at));
        let Some(row) = row else { return SpeedSigns::NONE };
        let zone = match Signal::new(self.map, row.zone()) {
            lowest if row.zone_depends() != 0 => Zone::Depends(lowest),
            Some(sign) => Zone::Of(sign),
            None => Zone::None,
        };
        SpeedSigns { limit: Signal::new(self.map, row.limit()), zone }
    }

    /// Where a sign on the lane may change the speed limit, in ascending s.
    pub(crate) fn speed_signs(&self) -> impl Iterator<Item = f64> + use<'a> {
        let lane = *self;
        self.signals().filter(is_of_speed).map(move |one| one.s_on(&lane))
    }

    /// As above, for archives of releases that did not have that table: what signs on the lanes before say, zones as limits.
    fn signs_of_lanes_before(&self) -> SpeedSigns<'a> {
        let section = self.section();
        let s = if self.is_forward() { section.s_start() } else { section.s_end() };
        let begins = |one: &LaneSignal<'_>| {
            let class = one.signal().class();
            let limits = matches!(class, Class::SpeedLimit | Class::SpeedLimitZone);
            limits && one.signal().value().is_some()
        };
        let sign = sign_before(self, s, begins, is_of_speed);
        SpeedSigns { limit: sign.map(|sign| sign.signal()), zone: Zone::None }
    }

    /// The signs that hold at s, or at the lane's end for none, for a vehicle that has entered the lane with these.
    pub fn speed_signs_after(&self, entry: SpeedSigns<'a>, s: Option<f64>) -> SpeedSigns<'a> {
        let forward = self.is_forward();
        let along = |s: f64| if forward { s } else { -s };
        let until = s.map_or(f64::INFINITY, along);
        let (mut limit, mut zone): (Option<Last<'a>>, Option<Last<'a>>) = (None, None);
        for one in self.signals().filter(|one| one.is_for(forward)) {
            let (at, signal) = (along(one.s_on(self)), one.signal());
            if at > until || signal.is_invalidated() {
                continue;
            }
            let known = Some(signal).filter(|signal| signal.states_value());
            match signal.class() {
                Class::SpeedLimit if known.is_some() => Last::note(&mut limit, at, known),
                Class::EndOfSpeedLimit | Class::EndOfRestrictions => {
                    Last::note(&mut limit, at, None)
                }
                // Where a zone begins or ends, a limit from before does so, too.
                Class::SpeedLimitZone if known.is_some() => {
                    Last::note(&mut zone, at, known);
                    Last::note(&mut limit, at, None);
                }
                Class::EndOfSpeedLimitZone => {
                    Last::note(&mut zone, at, None);
                    Last::note(&mut limit, at, None);
                }
                _ => {}
            }
        }
        let held =
            |last: Option<Last<'a>>| last.map(|last| last.begins.map_or(Zone::None, Zone::Of));
        SpeedSigns {
            limit: limit.map_or(entry.limit, |last| last.begins),
            zone: held(zone).unwrap_or(entry.zone),
        }
    }
}

/// Whether a sign has to do with speed limits that hold on from it.
pub fn is_of_speed(one: &LaneSignal<'_>) -> bool {
    matches!(
        one.signal().class(),
        Class::SpeedLimit
            | Class::SpeedLimitZone
            | Class::EndOfSpeedLimit
            | Class::EndOfSpeedLimitZone
            | Class::EndOfRestrictions
    )
}
