//! A map under today's overlay: what is closed, slower or told of, at one moment.
//!
//! An overlay says of nodes of the lane graph which entries hold on which pieces of them. A [`View`] answers as the map does where nothing is said,
//! and applies the entries that hold at its moment elsewhere; each answer names the entry that decides. The moment is the caller's: nothing here reads a clock.
//! Without an overlay a view is the map.

mod along;
mod entry;
mod heed;
mod queries;

pub use along::{PathRestriction, PathSpeedToday};
pub use entry::{OverlayEntry, Restriction};
pub use mapd_archive::{Overlay, OverlayKind};
pub use queries::{OvertakingToday, Permission, SpeedToday};

use crate::graph::{LaneNode, NodePiece};
use crate::ids::SignalId;
use crate::lane::Lane;
use crate::map::Map;
use mapd_archive::{
    ArchivedOverlayEntryRow, ArchivedOverlayNodeRow, ArchivedPieceRow, ArchivedTouchedRow,
    OverlayTables, VehicleClass,
};
use std::time::{SystemTime, UNIX_EPOCH};
use thiserror::Error;

/// Seconds of a week.
const WEEK: i64 = 7 * 24 * 3600;
/// Seconds from the Monday before the Unix epoch, a Thursday, to the epoch.
const EPOCH_IN_WEEK: i64 = 3 * 24 * 3600;

/// An overlay that was resolved for another map.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("the overlay was made for another map content")]
pub struct ForeignOverlay;

/// A map under an overlay, at a moment. `Copy`, valid as long as both are borrowed.
#[derive(Clone, Copy)]
pub struct View<'a> {
    map: Map<'a>,
    overlay: Option<&'a Overlay<'a>>,
    /// Seconds since the Unix epoch.
    at: f64,
    /// Seconds since Monday 00:00 UTC.
    in_week: u32,
}

impl<'a> View<'a> {
    /// What holds on a map at a moment under an overlay; without one the map itself.
    ///
    /// Errors: the overlay was made for another map content.
    pub fn new(
        map: Map<'a>,
        overlay: Option<&'a Overlay<'a>>,
        at: SystemTime,
    ) -> Result<Self, ForeignOverlay> {
        if overlay.is_some_and(|over| over.header.provenance.input_hash != map.content_hash()) {
            return Err(ForeignOverlay);
        }
        Ok(Self::of(map, overlay, at))
    }

    /// As [`View::new`], of an overlay that is known to be this map's; with another's, answers mean nothing.
    #[doc(hidden)]
    pub fn of(map: Map<'a>, overlay: Option<&'a Overlay<'a>>, at: SystemTime) -> Self {
        let seconds = match at.duration_since(UNIX_EPOCH) {
            Ok(after) => after.as_secs_f64(),
            Err(before) => -before.duration().as_secs_f64(),
        };
        let in_week = (seconds.floor() as i64).wrapping_add(EPOCH_IN_WEEK).rem_euclid(WEEK);
        Self { map, overlay, at: seconds, in_week: in_week as u32 }
    }

    /// The map below.
    pub fn map(&self) -> Map<'a> {
        self.map
    }

    /// Everything that the overlay says, whether it holds now or not, in the order in which it was given.
    pub fn entries(&self) -> impl Iterator<Item = OverlayEntry<'a>> + use<'a> {
        let overlay = self.overlay;
        let count = overlay.map_or(0, |overlay| overlay.tables.entries.len());
        (0..count as u32).filter_map(move |row| OverlayEntry::new(overlay?, row))
    }

    /// Whether the overlay says of any signal that it is out of service, be it now or not.
    pub(crate) fn has_signals_out(&self) -> bool {
        self.tables().is_some_and(|tables| !tables.signal_entries.is_empty())
    }

    /// Whether no entry says now that a signal of the map is out of service.
    pub(crate) fn is_in_service(&self, signal: SignalId) -> bool {
        self.signal_out_of_service(signal).is_ok_and(|entry| entry.is_none())
    }

    /// Tells a node of the map, or its pieces with the permissions of the view's moment, in the order in which they are driven.
    pub(crate) fn each_piece(&self, node: &LaneNode<'a>, mut tell: impl FnMut(&LaneNode<'a>)) {
        let pieces = self.pieces_of(node.number);
        if pieces.is_empty() {
            return tell(node);
        }
        for piece in pieces {
            // Of whom the speeds are does not matter.
            self.piece(piece, VehicleClass::PassengerCar).iter().for_each(&mut tell);
        }
    }

    fn tables(&self) -> Option<&'a OverlayTables<'a>> {
        self.overlay.map(|overlay| &overlay.tables)
    }

    /// Whether an entry holds at the view's moment.
    pub fn holds(&self, entry: &OverlayEntry<'a>) -> bool {
        self.is_active(entry.tables, entry.row)
    }

    #[inline]
    fn is_active(&self, tables: &OverlayTables<'a>, row: &ArchivedOverlayEntryRow) -> bool {
        if !(self.at >= row.from() && self.at < row.until()) {
            return false;
        }
        row.weekly().count == 0 || self.is_in_week(tables, row)
    }

    /// Whether an entry holds at this time of the week.
    fn is_in_week(&self, tables: &OverlayTables<'a>, row: &ArchivedOverlayEntryRow) -> bool {
        let mut times = row.weekly().of(tables.weekly).iter();
        times.any(|time| self.in_week >= time.from() && self.in_week < time.until())
    }

    /// Whether the overlay has pieces of a lane.
    #[inline]
    fn touches(&self, lane: &Lane<'a>) -> bool {
        let Some(tables) = self.tables() else { return false };
        let mut nodes = lane.row.nodes().rows(self.map.tables().lane_nodes.len());
        nodes.any(|node| is_touched(tables.touched, node))
    }

    /// Where a node of the map is among the overlay's; none where the overlay says nothing of it.
    #[inline]
    fn overlaid(&self, node: u32) -> Option<(&'a OverlayTables<'a>, usize)> {
        let tables = self.tables()?;
        let word = tables.touched.get(node as usize / 64)?;
        let (bit, bits) = (node % 64, word.bits());
        if bits >> bit & 1 == 0 {
            return None;
        }
        let before = (bits & ((1 << bit) - 1)).count_ones();
        Some((tables, word.rank().wrapping_add(before) as usize))
    }

    /// Rows of the pieces of a node of the map; empty where the overlay says nothing of it.
    #[inline]
    fn pieces_of(&self, node: u32) -> std::ops::Range<u32> {
        let found = self.overlaid(node);
        let row = found.and_then(|(tables, row)| Some((tables, tables.nodes.get(row)?)));
        row.map_or(0..0, |(tables, row)| row.pieces().rows(tables.pieces.len()))
    }

    /// As [`View::pieces_of`]; empty, too, where nothing that is said changes the ways of a class of vehicles.
    #[inline]
    fn pieces_for(&self, node: u32, vehicle: VehicleClass) -> std::ops::Range<u32> {
        let Some((tables, row)) = self.overlaid(node) else { return 0..0 };
        if tables.node_vehicles.get(row).is_some_and(|classes| classes & vehicle.bit() == 0) {
            return 0..0;
        }
        let row = tables.nodes.get(row);
        row.map_or(0..0, |row| row.pieces().rows(tables.pieces.len()))
    }

    /// A piece as a node: with what it has at the view's moment for a class of vehicles. Not by [`View::active_on`]: searches ask this of every node that
    /// they meet, and whether an entry holds at the moment costs more than its kind and class, which rule most of them out.
    fn piece(&self, number: u32, vehicle: VehicleClass) -> Option<LaneNode<'a>> {
        let tables = self.tables()?;
        let row = tables.pieces.get(number as usize)?;
        let node = tables.nodes.get(row.node() as usize)?.node();
        let base = self.map.tables().lane_nodes.get(node as usize)?;
        let (mut closed, mut opened, mut speed) = (0, 0, f64::INFINITY);
        for entry in row.entries().of(tables.piece_entries) {
            let Some(entry) = tables.entries.get(*entry as usize) else { continue };
            let kind = OverlayKind::from_code(entry.kind());
            let own = match kind {
                OverlayKind::Closed => &mut closed,
                OverlayKind::Open => &mut opened,
                OverlayKind::Speed if entry.vehicles() & vehicle.bit() != 0 => {
                    if entry.value() < speed && self.is_active(tables, entry) {
                        speed = entry.value();
                    }
                    continue;
                }
                _ => continue,
            };
            if self.is_active(tables, entry) {
                *own |= entry.vehicles();
            }
        }
        let is_speed_stated = speed < f64::INFINITY;
        let time = match is_speed_stated {
            true => f64::from(row.length()) / crate::lane_length::travel_speed(speed),
            false => f64::from(row.time()),
        };
        let access = (base.access() | opened) & !closed;
        let piece = NodePiece { row, time, is_speed_stated, access };
        Some(LaneNode { map: self.map, number: node, row: base, piece: Some(piece) })
    }

    /// Entries that hold on a piece at the view's moment, by number.
    #[inline]
    fn active_on(
        &self,
        tables: &'a OverlayTables<'a>,
        piece: &'a ArchivedPieceRow,
    ) -> impl Iterator<Item = (u32, &'a ArchivedOverlayEntryRow)> + use<'a> {
        let view = *self;
        let numbers = piece.entries().of(tables.piece_entries).iter();
        numbers
            .filter_map(move |number| Some((*number, tables.entries.get(*number as usize)?)))
            .filter(move |(_, row)| view.is_active(tables, row))
    }

    /// The piece that holds s of a lane in a direction of travel, at a cut the later one; none where the overlay says nothing.
    fn piece_at(&self, lane: &Lane<'a>, s: f64, forward: bool) -> Option<u32> {
        self.tables()?;
        let node = lane.node_at(s, forward)?;
        self.piece_among(self.pieces_of(node.number), s, forward)
    }

    /// The one of a node's pieces that holds s, as [`View::piece_at`].
    fn piece_among(&self, pieces: std::ops::Range<u32>, s: f64, forward: bool) -> Option<u32> {
        let rows = self.tables()?.pieces.get(pieces.start as usize..pieces.end as usize)?;
        let reached = |row: &&ArchivedPieceRow| {
            if forward { s >= row.s_from() } else { s <= row.s_to() }
        };
        let at = rows.iter().take_while(reached).count().saturating_sub(1);
        (!rows.is_empty()).then_some(pieces.start + at as u32)
    }
}

/// The row of the node that an overlay's piece is of.
#[inline]
fn node_row<'a>(tables: &OverlayTables<'a>, piece: u32) -> Option<&'a ArchivedOverlayNodeRow> {
    tables.nodes.get(tables.pieces.get(piece as usize)?.node() as usize)
}

/// Whether a node of the map has pieces.
#[inline]
fn is_touched(touched: &[ArchivedTouchedRow], node: u32) -> bool {
    touched.get(node as usize / 64).is_some_and(|word| word.bits() >> (node % 64) & 1 != 0)
}
