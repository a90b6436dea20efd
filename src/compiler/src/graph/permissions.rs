//! Who may use a lane, and where lanes may be changed, as the file says it.

use mapd_archive::{LaneType, VehicleClass};
use mapd_xodr::{Lane, LaneAccess, LaneChange};

/// A road mark on the outer border of a lane, as far as lane changes go.
#[derive(Clone, Copy)]
pub(crate) struct Mark {
    lane: u32,
    /// Start, from the section's start `[m]`.
    pub(crate) s: f64,
    change: LaneChange,
}

/// Who may use a lane from a place on.
#[derive(Clone, Copy)]
pub(crate) struct Access {
    lane: u32,
    /// Start, from the section's start `[m]`.
    pub(crate) s: f64,
    /// Bit i: vehicle class i may use it.
    classes: u16,
}

/// Road marks and access records of all lanes, by lane row.
#[derive(Default)]
pub(crate) struct Permissions {
    marks: Vec<Mark>,
    accesses: Vec<Access>,
}

impl Permissions {
    /// Adds what a lane says. Lanes come in the order of their rows.
    pub(crate) fn lane(&mut self, row: u32, kind: LaneType, lane: &Lane) {
        let before = self.marks.len();
        self.marks.extend(lane.road_marks.iter().map(|mark| Mark {
            lane: row,
            s: mark.s,
            change: mark.lane_change,
        }));
        let marks = &mut self.marks[before..];
        marks.sort_by(|a, b| a.s.total_cmp(&b.s));
        let base = VehicleClass::of_lane_type(kind);
        let mut records: Vec<&LaneAccess> = lane.accesses.iter().collect();
        records.sort_by(|a, b| a.s.total_cmp(&b.s));
        for set in records.chunk_by(|a, b| a.s == b.s) {
            let Some(first) = set.first() else { continue };
            self.accesses.push(Access { lane: row, s: first.s, classes: classes(base, set) });
        }
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
    /// forbids them where no mark lies (OpenDRIVE 1.8.1, 11.9: `laneChange` is `both` where absent).
    pub(crate) fn changes(&self, lane: u32, s: f64) -> (bool, bool) {
        let marks = self.marks(lane);
        let at = marks.partition_point(|mark| mark.s <= s);
        match at.checked_sub(1).and_then(|i| marks.get(i)).map(|mark| mark.change) {
            None | Some(LaneChange::Both) => (true, true),
            Some(LaneChange::Increase) => (true, false),
            Some(LaneChange::Decrease) => (false, true),
            Some(LaneChange::None) => (false, false),
        }
    }

    /// Where a border's permission changes, from the section's start.
    pub(crate) fn mark_breaks(&self, lane: u32) -> impl Iterator<Item = f64> + '_ {
        let pairs = self.marks(lane).windows(2);
        let first = self.marks(lane).first().filter(|m| m.change != LaneChange::Both);
        first
            .map(|mark| mark.s)
            .into_iter()
            .chain(pairs.filter(|pair| pair[0].change != pair[1].change).map(|pair| pair[1].s))
    }
}

fn of_lane<T>(rows: &[T], lane: u32, key: impl Fn(&T) -> u32) -> &[T] {
    let from = rows.partition_point(|row| key(row) < lane);
    let rows = rows.get(from..).unwrap_or(&[]);
    let count = rows.iter().take_while(|row| key(row) == lane).count();
    rows.get(..count).unwrap_or(&[])
}

/// Classes that a set of records at one place leaves (OpenDRIVE 1.8.1, 11.8.1): where one allows, all others are banned;
/// `none` resets to what the lane's type says. A record without `rule` denies, which is what a restriction does.
fn classes(base: u16, set: &[&LaneAccess]) -> u16 {
    let bits = |allow: bool| {
        let named = set.iter().filter(|record| record.allow == allow);
        named.flat_map(|record| &record.restrictions).fold(0, |all, name| all | class_bits(name))
    };
    let (allowed, denied) = (bits(true), bits(false));
    let granted = if allowed == 0 { base } else { allowed };
    granted & !denied
}

/// Classes that a restriction names, in the words of 1.4 to 1.9; 0 for `none` and unknown words.
fn class_bits(name: &str) -> u16 {
    match name {
        "autonomous traffic" => VehicleClass::Autonomous.bit(),
        "trucks" => VehicleClass::Truck.bit(),
        name => VehicleClass::from_name(name).bit(),
    }
}
