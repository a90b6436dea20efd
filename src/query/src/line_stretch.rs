//! What a road's reference line is made of for a while: looked up once, for all places where it holds.

use crate::profile::Record;
use crate::road::{GeometryPiece, Road};
use mapd_archive::ArchivedCubicRow;

/// From which s on and up to which one the same records hold.
#[derive(Clone, Copy)]
pub(crate) struct ValidRange {
    from: f64,
    to: f64,
}

/// A geometry, a height and a superelevation, and where they hold.
pub(crate) struct LineStretch<'a> {
    pub(crate) held: ValidRange,
    pub(crate) piece: GeometryPiece<'a>,
    pub(crate) elevation: Record,
    pub(crate) superelevation: Record,
}

impl ValidRange {
    pub(crate) const ALWAYS: Self = Self { from: f64::NEG_INFINITY, to: f64::INFINITY };

    pub(crate) fn contains(self, hold: f64) -> bool {
        hold >= self.from && hold < self.to
    }

    pub(crate) fn covers(self, from: f64, to: f64) -> bool {
        from >= self.from && to <= self.to
    }

    /// The part in which another one holds as well.
    pub(crate) fn and(self, other: Self) -> Self {
        Self { from: self.from.max(other.from), to: self.to.min(other.to) }
    }

    /// Between the start of what holds, the one before `next`, and that of the next.
    fn narrow<T>(&mut self, rows: &[T], next: usize, start: impl Fn(&T) -> f64) {
        if let Some(row) = next.checked_sub(1).and_then(|i| rows.get(i)) {
            self.from = self.from.max(start(row));
        }
        if let Some(row) = rows.get(next) {
            self.to = self.to.min(start(row));
        }
    }

    /// The record that holds.
    pub(crate) fn record<'a>(
        &mut self,
        rows: &'a [ArchivedCubicRow],
        hold: f64,
    ) -> Option<&'a ArchivedCubicRow> {
        let next = rows.partition_point(|row| row.s() <= hold);
        self.narrow(rows, next, ArchivedCubicRow::s);
        next.checked_sub(1).and_then(|i| rows.get(i))
    }
}

impl<'a> LineStretch<'a> {
    /// What holds at s. None for a damaged archive.
    #[inline(always)]
    pub(crate) fn at(road: &Road<'a>, s: f64) -> Option<Self> {
        let mut held = ValidRange::ALWAYS;
        let rows = road.geometries();
        let next = rows.partition_point(|row| row.s() <= s);
        held.narrow(rows, next, |row| row.s());
        // Before the first geometry, that one holds.
        let piece = road.piece(rows.get(next.saturating_sub(1))?)?;
        let elevation = Record::of(held.record(road.elevations(), s));
        let superelevation = Record::of(held.record(road.superelevations(), s));
        Some(Self { held, piece, elevation, superelevation })
    }
}
