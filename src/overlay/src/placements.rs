//! Where entries hold on a map, kept: an entry that did not change is not placed again.

use crate::depth::{Depths, MOST_AT_A_PLACE};
use crate::document::Document;
use crate::entry::Entry;
use crate::pieces::{self, Mark, Marks, SHORTEST_PIECE};
use crate::places::{PlaceError, PlaceResolver, Stretch, field};
use crate::resolve::{Policy, Resolved, Unplaced, add, raised, resolve_entry};
use mapd_archive::{OverlayRows, SignalEntryRow, StringTable};
use mapd_query::{Lane, LaneId, Map, SRange};
use std::collections::{BTreeMap, BTreeSet};

/// How often a document is put together at most, so that entries which make each other too short take bounded time. What the last time has nothing left of is told, and cuts
/// lanes all the same.
const ROUNDS: usize = 8;

/// Most that all lines of a document measure within the map `[m]`: what is placed takes time for each step of it.
pub(crate) const LINES_TOGETHER: f64 = 1e7;

/// Entries that are kept beyond those of the document: others may have been placed for what comes next.
const MORE: usize = 1024;

/// Where entries hold on one map.
#[derive(Debug)]
pub struct Placements {
    content: [u8; 32],
    policy: Policy,
    known: BTreeMap<String, Known>,
}

/// An entry, and where it holds.
#[derive(Debug)]
struct Known {
    entry: Entry,
    location: Result<KnownLocation, PlaceError>,
    /// What its lines measure within the map `[m]`.
    lines: f64,
}

#[derive(Debug)]
struct KnownLocation {
    location: EntryLocation,
    /// Where the stretches of each place end, in the order of [`field`].
    ends: Vec<u32>,
    /// What could not be placed.
    unplaced: Vec<PlaceError>,
}

/// A stretch of a lane on which an entry holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocatedStretch {
    /// The lane.
    pub lane: LaneId,
    /// The lower s on the lane's road `[m]`.
    pub s_from: f64,
    /// The higher s on the lane's road `[m]`.
    pub s_to: f64,
}

impl LocatedStretch {
    /// Whether both have a place in common.
    fn overlaps(&self, other: &Self) -> bool {
        self.lane == other.lane && self.s_from <= other.s_to && other.s_from <= self.s_to
    }
}

/// Where an entry holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EntryLocation {
    /// Stretches of lanes.
    pub stretches: Vec<LocatedStretch>,
    /// Rows of signals.
    pub signals: Vec<u32>,
}

impl EntryLocation {
    /// Whether both hold somewhere on the same lane, or of the same signal.
    pub fn overlaps(&self, other: &Self) -> bool {
        let on_one = |a: &LocatedStretch| other.stretches.iter().any(|b| a.overlaps(b));
        self.stretches.iter().any(on_one)
            || self.signals.iter().any(|signal| other.signals.contains(signal))
    }
}

impl Placements {
    /// None yet, on this map.
    pub fn new(map: Map<'_>, policy: Policy) -> Self {
        Self { content: map.content_hash(), policy, known: BTreeMap::new() }
    }

    /// Whether they are of this map.
    pub fn is_of(&self, map: Map<'_>) -> bool {
        self.content == map.content_hash()
    }

    /// Entries of a document that are not placed yet.
    pub fn missing(&self, document: &Document) -> Document {
        let is_missing = |entry: &&Entry| !self.has(entry);
        Document { entries: document.entries.iter().filter(is_missing).cloned().collect() }
    }

    fn has(&self, entry: &Entry) -> bool {
        self.known.get(&entry.id).is_some_and(|known| known.entry == *entry)
    }

    /// Places what is missing of a document. Another map than theirs: nothing is placed.
    pub fn place(&mut self, map: Map<'_>, document: &Document) {
        if !self.is_of(map) {
            return;
        }
        let resolver = PlaceResolver::new(map);
        for entry in &document.entries {
            let is_over = resolver.left() < 0.0 && !entry.places.is_empty();
            if is_over || self.has(entry) {
                continue;
            }
            let before = resolver.left();
            let location = resolve_entry(&resolver, entry, self.policy).map(|found| {
                let stretch = |one: &Stretch<'_>| LocatedStretch {
                    lane: one.lane.lane_id(),
                    s_from: one.s_from,
                    s_to: one.s_to,
                };
                let stretches = found.places.stretches.iter().map(stretch).collect();
                let location = EntryLocation { stretches, signals: found.signals };
                let (ends, unplaced) = (found.places.ends, found.places.unplaced);
                KnownLocation { location, ends, unplaced }
            });
            if resolver.left() < 0.0 && !entry.places.is_empty() {
                // What is over may have a place once there is less.
                continue;
            }
            let known = Known { entry: entry.clone(), location, lines: before - resolver.left() };
            self.known.insert(entry.id.clone(), known);
        }
    }

    /// Where an entry of this name holds; none if it is not placed.
    ///
    /// Errors: it does not fit the map.
    pub fn location(&self, id: &str) -> Option<Result<&EntryLocation, &PlaceError>> {
        let known = self.known.get(id)?;
        Some(known.location.as_ref().map(|known| &known.location))
    }

    /// Takes over what others have, if they are of the same map.
    pub fn absorb(&mut self, others: Self) {
        if others.content == self.content && others.policy == self.policy {
            self.known.extend(others.known);
        }
    }

    /// Resolves a document: places what is missing, and puts together what is published. An entry that does not fit is left out whole; only of a
    /// line the part that is on the map's lanes holds, and of several places those that are not too short to be cut out of a lane.
    pub fn resolve(&mut self, map: Map<'_>, document: &Document) -> Resolved {
        self.place(map, document);
        self.forget(document);
        // Entries that nothing is left of. Without one, lanes are cut elsewhere: so all is put together anew, rarely.
        let mut gone = BTreeMap::new();
        for _ in 1..ROUNDS {
            let (resolved, more) = self.put_together(map, document, &gone);
            if more.is_empty() {
                return resolved;
            }
            gone.extend(more);
        }
        let (mut resolved, more) = self.put_together(map, document, &gone);
        let more = more.into_iter().map(|(at, why)| unplaced_entry(document, at, why, false));
        resolved.unplaced.extend(more);
        resolved.unplaced.sort_by_key(|unfit| unfit.number);
        resolved
    }

    /// Puts together what is published, without entries that are gone, by number; and those of which nothing is left where lanes are cut, with the first of their places.
    fn put_together(
        &self,
        map: Map<'_>,
        document: &Document,
        gone: &BTreeMap<usize, PlaceError>,
    ) -> (Resolved, BTreeMap<usize, PlaceError>) {
        let mut rows = OverlayRows::default();
        let mut strings = StringTable::default();
        let (mut marks, mut unplaced) = (Marks::new(), Vec::new());
        // Of each entry that holds, the first of its places among all, and how many it has.
        let (mut own_places, mut places_in_all) = (Vec::new(), 0_u32);
        let (mut lines, mut depths) = (0.0, Depths::default());
        for (number, entry) in document.entries.iter().enumerate() {
            let unfit = |why, is_part| unplaced_entry(document, number, why, is_part);
            let known = self.known.get(&entry.id).filter(|known| known.entry == *entry);
            lines += known.map_or(f64::INFINITY, |known| known.lines);
            match known.map(|known| &known.location) {
                _ if gone.contains_key(&number) => {
                    unplaced.extend(gone.get(&number).map(|why| unfit(why.clone(), false)));
                }
                Some(Err(why)) => unplaced.push(unfit(why.clone(), false)),
                Some(Ok(known)) if lines <= LINES_TOGETHER || entry.places.is_empty() => {
                    let mut own_marks = Vec::new();
                    for (i, stretch) in known.location.stretches.iter().enumerate() {
                        let LocatedStretch { lane, s_from, s_to } = *stretch;
                        let Ok(lane) = map.lane(lane) else { continue };
                        let before = known.ends.partition_point(|end| *end as usize <= i);
                        let place = places_in_all + before as u32;
                        let own = rows.entries.len() as u32;
                        mark(&lane, Mark { s_from, s_to, entry: own, place }, &mut own_marks);
                    }
                    if !depths.have_room(&own_marks) {
                        unplaced.push(unfit(too_many(), false));
                        continue;
                    }
                    depths.add(&own_marks);
                    for (node, mark) in own_marks {
                        marks.entry(node).or_default().push(mark);
                    }
                    unplaced.extend(known.unplaced.iter().map(|part| unfit(part.clone(), true)));
                    let own = add(entry, &mut strings, &mut rows);
                    own_places.push((number, places_in_all as usize, known.ends.len()));
                    places_in_all += known.ends.len() as u32;
                    let of_signal = |signal: &u32| SignalEntryRow { signal: *signal, entry: own };
                    rows.signal_entries.extend(known.location.signals.iter().map(of_signal));
                }
                _ => {
                    let why = format!(
                        "all lines together are longer than {} km within the map",
                        LINES_TOGETHER / 1e3
                    );
                    unplaced.push(unfit(PlaceError::new("places", why), false));
                }
            }
        }
        rows.signal_entries.sort_by_key(|row| (row.signal, row.entry));
        let mut held = vec![false; places_in_all as usize];
        pieces::fill(map, &marks, &mut rows, &mut held);
        let mut more = BTreeMap::new();
        for (number, first, count) in own_places {
            let own = held.get(first..first + count).unwrap_or_default();
            let lost = own.iter().enumerate().filter(|(_, is_held)| !**is_held);
            let mut lost = lost.map(|(place, _)| too_short(document, number, place));
            if own.iter().any(|is_held| *is_held) {
                unplaced.extend(lost.map(|why| unplaced_entry(document, number, why, true)));
            } else if let Some(first) = lost.next() {
                more.insert(number, first);
            }
        }
        unplaced.sort_by_key(|unfit| unfit.number);
        let row = raised(map, &rows);
        rows.overlay.push(row);
        let strings = strings.into_tables();
        rows.string_bytes = strings.bytes.into();
        rows.string_offsets = strings.offsets.into();
        (Resolved { rows, unplaced }, more)
    }

    /// Forgets what a document does not have, once that is much.
    fn forget(&mut self, document: &Document) {
        if self.known.len() > 2 * document.entries.len() + MORE {
            let ids: BTreeSet<&str> = document.entries.iter().map(|e| e.id.as_str()).collect();
            self.known.retain(|id, _| ids.contains(id.as_str()));
        }
    }
}

/// An entry of a document that does not fit, or a part of it.
fn unplaced_entry(
    document: &Document,
    number: usize,
    error: PlaceError,
    is_part: bool,
) -> Unplaced {
    let PlaceError { field, why } = error;
    let id = document.entries.get(number).map(|entry| entry.id.clone()).unwrap_or_default();
    Unplaced { id, number, field, why, is_part }
}

/// A place of an entry of which nothing is left where lanes are cut.
fn too_short(document: &Document, number: usize, place: usize) -> PlaceError {
    let field = document.entries.get(number).map(|entry| field(entry, place));
    let why = format!(
        "too short to be cut out of a lane: within {SHORTEST_PIECE} m there is a section's end or that of another entry"
    );
    PlaceError::new(field.unwrap_or_default(), why)
}

/// An entry that holds where as many hold as may.
fn too_many() -> PlaceError {
    let why = format!(
        "{MOST_AT_A_PLACE} entries before it hold at one place of its lanes; no more are taken"
    );
    PlaceError::new("lanes", why)
}

/// Lists the nodes that a stretch of a lane touches.
fn mark(lane: &Lane<'_>, mark: Mark, marks: &mut Vec<(u32, Mark)>) {
    for node in lane.nodes() {
        let SRange { low: start, high: end } = node.s_range();
        if start.max(mark.s_from) < end.min(mark.s_to) {
            marks.push((node.node_id().row(), mark));
        }
    }
}
