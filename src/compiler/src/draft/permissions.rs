//! Who may use a lane, and where lanes may be changed, as the file says it.

use crate::options::MarkReading;
use mapd_archive::{LaneType, RowMapping, VehicleClass};
use mapd_xodr::LaneChange;

/// A road mark on the outer border of a lane, as far as lane changes go.
#[derive(Clone, Copy)]
pub(crate) struct Mark {
    pub(crate) lane: u32,
    /// Start, from the section's start `[m]`.
    pub(crate) s: f64,
    pub(crate) change: LaneChange,
}

/// Who may use a lane from a place on.
#[derive(Clone, Copy)]
pub(crate) struct Access {
    pub(crate) lane: u32,
    /// Start, from the section's start `[m]`.
    pub(crate) s: f64,
    /// Bit i: vehicle class i may use it.
    pub(crate) classes: u16,
}

/// Road marks and access records of all lanes, by lane row.
#[derive(Default)]
pub(crate) struct Permissions {
    /// How marks are read that do not say whether lanes may be changed.
    pub(crate) reading: MarkReading,
    pub(crate) marks: Vec<Mark>,
    pub(crate) accesses: Vec<Access>,
}

impl Permissions {
    /// Appends those of a part of a map, whose lanes come to lie elsewhere.
    pub(crate) fn append(&mut self, part: Self, lanes: &RowMapping) {
        let marks = part.marks.into_iter();
        self.marks.extend(marks.map(|mark| Mark { lane: lanes.row(mark.lane), ..mark }));
        let accesses = part.accesses.into_iter();
        self.accesses.extend(accesses.map(|a| Access { lane: lanes.row(a.lane), ..a }));
    }

    pub(crate) fn marks(&self, lane: u32) -> &[Mark] {
        of_lane(&self.marks, lane, |mark| mark.lane)
    }

    pub(crate) fn accesses(&self, lane: u32) -> &[Access] {
        of_lane(&self.accesses, lane, |access| access.lane)
    }

    /// Classes that may use a lane at a place.
    pub(crate) fn classes(&self, lane: u32, kind: LaneType, s: f64) -> u16 {
        let records = self.accesses(lane);
        let at = records.partition_point(|record| record.s <= s);
        match at.checked_sub(1).and_then(|i| records.get(i)) {
            Some(record) => record.classes,
            None => VehicleClass::of_lane_type(kind),
        }
    }

    /// Whether the marks of a lane's outer border allow changes at a place: to higher and to lower lane numbers. Nothing
    /// forbids them where no mark lies.
    pub(crate) fn changes(&self, lane: u32, s: f64) -> (bool, bool) {
        let marks = self.marks(lane);
        let at = marks.partition_point(|mark| mark.s <= s);
        match at.checked_sub(1).and_then(|i| marks.get(i)).map(|mark| mark.change) {
            Some(LaneChange::Increase) => (true, false),
            Some(LaneChange::Decrease) => (false, true),
            Some(LaneChange::None) => (false, false),
            // A word that the standard does not list says nothing.
            _ => (true, true),
        }
    }

    /// Where a border's permission changes, from the section's start.
    pub(crate) fn mark_breaks(&self, lane: u32) -> impl Iterator<Item = f64> + '_ {
        let marks = self.marks(lane);
        let pairs = marks.windows(2);
        let first = marks.first().filter(|m| m.change != LaneChange::Both);
        first
            .map(|mark| mark.s)
            .into_iter()
            .chain(pairs.filter(|pair| pair[0].change != pair[1].change).map(|pair| pair[1].s))
    }
}

fn of_lane<T>(rows: &[T], lane: u32, key: impl Fn(&T) -> u32) -> &[T] {
    // Looked up, not counted: each of a lane's pieces asks for all of them.
    let from = rows.partition_point(|row| key(row) < lane);
    let to = rows.partition_point(|row| key(row) <= lane);
    rows.get(from..to).unwrap_or(&[])
}
