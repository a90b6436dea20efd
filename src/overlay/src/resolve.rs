//! Entries on a map: which lanes, cut where.

use crate::document::Document;
use crate::entry::{Entry, Kind};
use crate::placements::Placements;
use crate::places::{PlaceError, PlaceResolver, ResolvedPlaces, Stretch, resolve_places};
use mapd_archive::{
    OverlayEntryRow, OverlayKind, OverlayRow, OverlayRows, Range, StringTable, VehicleClass,
    WeeklyRow,
};
use mapd_query::Map;
use mapd_query::compiling::ByRow as _;
use mapd_query::roads::travel_speed;

/// What is taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Policy {
    /// Whether entries may allow more than the map: open lanes, raise speed limits.
    pub may_loosen: bool,
}

/// An entry that does not fit the map, or not all of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unplaced {
    /// Its name.
    pub id: String,
    /// Its place in the document, from 0.
    pub number: usize,
    /// The field that does not fit, such as `lanes[0].road`.
    pub field: String,
    /// Why.
    pub why: String,
    /// Whether this is so of a part of a line, or of one of several places, only; the rest of the entry holds.
    pub is_part: bool,
}

/// Entries, resolved.
pub struct Resolved {
    /// What can be published for this map.
    pub rows: OverlayRows,
    /// Entries that are left out, and parts that are, in their order.
    pub unplaced: Vec<Unplaced>,
}

/// Resolves a document against a map, once ([`Placements`] does so again and again).
pub fn resolve(map: Map<'_>, document: &Document, policy: Policy) -> Resolved {
    Placements::new(map, policy).resolve(map, document)
}

/// Where an entry holds.
pub(crate) struct ResolvedEntry<'a> {
    pub(crate) places: ResolvedPlaces<'a>,
    /// Rows of signals.
    pub(crate) signals: Vec<u32>,
}

/// Where an entry holds.
///
/// Errors: it does not fit the map, or allows more than is taken.
pub(crate) fn resolve_entry<'a>(
    resolver: &PlaceResolver<'a>,
    entry: &Entry,
    policy: Policy,
) -> Result<ResolvedEntry<'a>, PlaceError> {
    let places = resolve_places(resolver, entry)?;
    let mut signals = Vec::new();
    for (i, id) in entry.signals.iter().enumerate() {
        let known = resolver.map.signal_by_id(id);
        let unfit = || PlaceError::new(format!("signals[{i}]"), "the map has no such signal");
        signals.push(known.ok_or_else(unfit)?.signal_id().row());
    }
    if !policy.may_loosen {
        loosens(entry, &places.stretches).map_or(Ok(()), Err)?;
    }
    Ok(ResolvedEntry { places, signals })
}

/// What an entry allows that the map does not.
fn loosens(entry: &Entry, stretches: &[Stretch<'_>]) -> Option<PlaceError> {
    const OPERATOR: &str = "; the daemon takes only what restricts (--overlay-may-loosen)";
    if entry.kind == Kind::Open {
        return Some(PlaceError::new("kind", format!("opens lanes{OPERATOR}")));
    }
    let value = entry.value.filter(|_| entry.kind == Kind::Speed)?;
    stretches.iter().find_map(|Stretch { lane, s_from, s_to }| {
        let mut met = lane.speed_rules().filter(|own| own.s.low < *s_to && own.s.high > *s_from);
        let (limit, s) = met.find_map(|own| {
            let limit = own.lowest.filter(|limit| value > limit + ROUNDED)?;
            Some((limit, own.s.low.max(*s_from)))
        })?;
        let key = lane.key();
        let why = format!("raises the limit of {limit:.2} m/s on {key} at {s:.1} m{OPERATOR}");
        Some(PlaceError::new("value", why))
    })
}

/// A limit above the map's by no more than this `[m/s]` is the same, written in other units.
const ROUNDED: f64 = 0.01;

/// Adds an entry to the tables; its number.
pub(crate) fn add(entry: &Entry, strings: &mut StringTable, rows: &mut OverlayRows) -> u32 {
    let first = rows.weekly.len() as u32;
    let ranges = entry.weekly.iter().flat_map(|weekly| weekly.ranges());
    rows.weekly.extend(ranges.map(|[from, until]| WeeklyRow { from, until }));
    let weekly = Range { first, count: rows.weekly.len() as u32 - first };
    rows.entries.push(OverlayEntryRow {
        from: entry.from.map_or(f64::MIN, |moment| moment.unix_seconds),
        until: entry.until.map_or(f64::MAX, |moment| moment.unix_seconds),
        value: entry.value.unwrap_or(0.0),
        weekly,
        id: strings.add(&entry.id),
        source: strings.add(&entry.source),
        text: strings.add(&entry.text),
        confidence: entry.confidence as f32,
        vehicles: entry.concerned(),
        kind: entry.kind.stored().code(),
        reserved: [0; 5],
    });
    rows.entries.len() as u32 - 1
}

/// What raised speeds and opened lanes do to the map's bounds, whenever they hold.
pub(crate) fn raised(map: Map<'_>, rows: &OverlayRows) -> OverlayRow {
    let mut row = OverlayRow { time_saved: 0.0, time_factor: 1.0, opens: 0, reserved: 0 };
    for piece in rows.pieces.iter() {
        let numbers = piece.entries.of(&rows.piece_entries);
        let entries = numbers.iter().filter_map(|number| rows.entries.get(*number as usize));
        let (time, length) = (f64::from(piece.time), f64::from(piece.length));
        for entry in entries {
            match OverlayKind::from_code(entry.kind) {
                OverlayKind::Speed => {
                    let today = length / travel_speed(entry.value);
                    if today < time {
                        row.time_saved += time - today;
                        row.time_factor = row.time_factor.min(today / time);
                    }
                }
                OverlayKind::Open if entry.vehicles & VehicleClass::MOTOR != 0 => {
                    let node = rows.nodes.get(piece.node as usize);
                    let node = node.and_then(|row| map.lane_node_by_row(row.node));
                    let motor = |class: &&VehicleClass| class.bit() & VehicleClass::MOTOR != 0;
                    let driven = |class: &VehicleClass| node.is_some_and(|n| n.allows(*class));
                    if !VehicleClass::ALL.iter().filter(motor).any(driven) {
                        row.opens = 1;
                    }
                }
                _ => {}
            }
        }
    }
    row
}
