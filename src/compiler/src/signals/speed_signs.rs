//! Which signs of speed hold where lanes are entered.
//!
//! What leaves a lane follows from what enters it and from its own signs; what enters it, from all lanes that lead to it. That is
//! solved over the lanes until nothing changes. A ring that nobody enters keeps what its own signs say: unknown states agree with all.

use crate::findings::finding;
use crate::resolve::Resolved;
use crate::sample::view;
use mapd_archive::{NONE, Rows, SpeedSignsAtEntryRow};
use mapd_query::compiling::ByRow as _;
use mapd_query::compiling::{SpeedSigns, Zone, is_of_speed, signals_of_lanes};
use mapd_query::{Lane, Map};
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity};
use std::collections::{BTreeMap, HashMap, VecDeque};

/// What holds at a place, by rows of signals.
#[derive(Clone, Copy, PartialEq, Eq)]
struct State {
    limit: Option<u32>,
    zone: ZoneState,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum ZoneState {
    None,
    Of(u32),
    /// With the sign of the lowest of the zones.
    Depends(u32),
}

impl ZoneState {
    /// The sign of the zone, or of the lowest of several.
    fn sign(self) -> Option<u32> {
        match self {
            Self::None => None,
            Self::Of(sign) | Self::Depends(sign) => Some(sign),
        }
    }
}

impl State {
    const NONE: Self = Self { limit: None, zone: ZoneState::None };

    fn of(signs: &SpeedSigns<'_>) -> Self {
        let zone = match signs.zone {
            Zone::None => ZoneState::None,
            Zone::Of(sign) => ZoneState::Of(sign.signal_id().row()),
            Zone::Depends(Some(sign)) => ZoneState::Depends(sign.signal_id().row()),
            // The states here always name one.
            Zone::Depends(None) => ZoneState::None,
        };
        Self { limit: signs.limit.map(|sign| sign.signal_id().row()), zone }
    }

    fn signs<'a>(&self, map: Map<'a>) -> SpeedSigns<'a> {
        let signal = |row: u32| map.signal_by_row(row);
        let zone = match self.zone {
            ZoneState::None => Zone::None,
            ZoneState::Of(row) => signal(row).map_or(Zone::None, Zone::Of),
            ZoneState::Depends(row) => Zone::Depends(signal(row)),
        };
        SpeedSigns { limit: self.limit.and_then(signal), zone }
    }
}

/// Rows of `speed_signs_at_entry`, and what is wrong: a zone that leads on, without a sign that ends it, to where traffic comes
/// in that is not in it.
pub(super) fn find(rows: &Rows, resolved: &Resolved) -> (Vec<SpeedSignsAtEntryRow>, Vec<Finding>) {
    let archive = view(rows);
    let map = Map::new(&archive, 0);
    let (mut found, endless) = solve(map, rows.lanes.len());
    if found.is_empty() && !rows.signal_lanes.is_empty() {
        found.push(row(0, &State::NONE));
    }
    let mut places = HashMap::new();
    for place in resolved.places.iter().filter(|_| !endless.is_empty()) {
        places.entry(place.signal).or_insert(place);
    }
    let told = endless.into_iter().filter_map(|(sign, lane)| {
        let lane = map.lane_by_row(lane)?.key().to_string();
        let place = places.get(&sign)?;
        Some(finding(
            &building::ZONE_END,
            Severity::Warning,
            place.span,
            "OpenDRIVE/road/signals".to_owned(),
            format!(
                "the zone does not end before lane {lane}, where traffic comes in that is not in it"
            ),
            "end the zone with a sign on each way out of it",
        ))
    });
    let told = told.collect();
    (found, told)
}

fn row(lane: u32, state: &State) -> SpeedSignsAtEntryRow {
    let zone = state.zone.sign().unwrap_or(NONE);
    let zone_depends = u8::from(matches!(state.zone, ZoneState::Depends(_)));
    SpeedSignsAtEntryRow {
        lane,
        limit: state.limit.unwrap_or(NONE),
        zone,
        zone_depends,
        reserved: [0; 3],
    }
}

/// What holds where lanes are entered, and rows of zones' signs with the first lane that they lead to without an end.
fn solve(map: Map<'_>, lanes: usize) -> (Vec<SpeedSignsAtEntryRow>, BTreeMap<u32, u32>) {
    // Only what lies behind a sign can hold anything: the rest is never looked at.
    let signs = signals_of_lanes(map).filter(is_of_speed);
    let mut signed: Vec<u32> = signs.filter_map(|one| Some(one.lane()?.lane_id().row())).collect();
    signed.dedup();
    if signed.is_empty() {
        return (Vec::new(), BTreeMap::new());
    }
    let (mut entry, mut exit): (Vec<Option<State>>, Vec<Option<State>>) =
        (vec![None; lanes], vec![None; lanes]);
    let mut open = VecDeque::from(signed);
    let mut reached = vec![false; lanes];
    for first in open.clone() {
        mark(map, first, &mut reached);
    }
    while let Some(number) = open.pop_front() {
        let Some(lane) = map.lane_by_row(number) else { continue };
        let at_entry = meet(map, &lane, &exit, &reached);
        let signs = lane.speed_signs_after(at_entry.unwrap_or(State::NONE).signs(map), None);
        let at_exit = State::of(&signs);
        let own = number as usize;
        entry[own] = at_entry;
        if exit[own] == Some(at_exit) {
            continue;
        }
        exit[own] = Some(at_exit);
        open.extend(lane.successors().map(|next| next.row()));
    }
    let mut endless = BTreeMap::new();
    for (number, state) in (0u32..).zip(&entry) {
        if !matches!(state, Some(State { zone: ZoneState::Depends(_), .. })) {
            continue;
        }
        for before in map.lane_by_row(number).into_iter().flat_map(|lane| lane.predecessors()) {
            if let Some(State { zone: ZoneState::Of(sign), .. }) = exit[before.row() as usize] {
                endless.entry(sign).or_insert(number);
            }
        }
    }
    let held = (0u32..).zip(&entry).filter_map(|(lane, state)| Some((lane, state.as_ref()?)));
    let held =
        held.filter(|(_, state)| **state != State::NONE).map(|(lane, state)| row(lane, state));
    (held.collect(), endless)
}

/// Marks a lane and all that it leads to.
fn mark(map: Map<'_>, first: u32, reached: &mut [bool]) {
    let mut open = vec![first];
    while let Some(number) = open.pop() {
        if std::mem::replace(&mut reached[number as usize], true) {
            continue;
        }
        let next = map.lane_by_row(number).into_iter().flat_map(|lane| lane.successors());
        open.extend(next.map(|next| next.row()));
    }
}

/// What enters a lane; none where nothing that leads to it is known yet.
fn meet(map: Map<'_>, lane: &Lane<'_>, exit: &[Option<State>], reached: &[bool]) -> Option<State> {
    let in_junction = |lane: &Lane<'_>| lane.road().junction().is_some();
    let mut before = lane.predecessors();
    let sole = before.next().filter(|_| before.next().is_none());
    let limit = sole.and_then(|id| {
        let before = map.lane_by_row(id.row())?;
        let goes_on = !in_junction(&before) && !in_junction(lane);
        exit[id.row() as usize].filter(|_| goes_on)?.limit
    });
    let value = |row: u32| map.signal_by_row(row).and_then(|sign| sign.value());
    // Of equal ones the first in the file, whatever the order in which they are met.
    let lowest = |a: ZoneState, b: ZoneState| {
        let limit = |row: &u32| value(*row).unwrap_or(f64::INFINITY);
        let signs = a.sign().into_iter().chain(b.sign());
        let first = signs.min_by(|a, b| limit(a).total_cmp(&limit(b)).then(a.cmp(b)));
        first.map_or(ZoneState::None, ZoneState::Depends)
    };
    let mut zone: Option<ZoneState> = None;
    for id in lane.predecessors() {
        // What no sign leads to has no zone; what one leads to will be known.
        let own = match exit[id.row() as usize] {
            Some(state) => state.zone,
            None if reached[id.row() as usize] => continue,
            None => ZoneState::None,
        };
        zone = Some(match (zone, own) {
            (None, own) => own,
            (Some(ZoneState::Of(a)), ZoneState::Of(b)) if value(a) == value(b) => {
                ZoneState::Of(a.min(b))
            }
            (Some(known), own) if known == own => known,
            (Some(known), own) => lowest(known, own),
        });
    }
    zone.map(|zone| State { limit, zone })
}
