//! Variable message boards and what is shown on them (OpenDRIVE 1.8).

use super::Signal;
use super::link::{SignalLink, dependencies, links};
use crate::extents::LaneRange;
use crate::map::Map;
use crate::structures::validities;
use glam::DVec3;
use mapd_archive::{ArchivedBoardGroupRow, ArchivedDisplayAreaRow, ArchivedSignalBoardRow, string};

/// A variable message board that a signal carries.
#[derive(Clone, Copy)]
pub struct SignalBoard<'a> {
    map: Map<'a>,
    row: &'a ArchivedSignalBoardRow,
}

/// A part of a variable message board.
#[derive(Clone, Copy)]
pub struct DisplayArea<'a> {
    map: Map<'a>,
    row: &'a ArchivedDisplayAreaRow,
}

/// A board's part in a group of boards that work together (`vmsGroup`).
#[derive(Clone, Copy)]
pub struct BoardGroupMember<'a> {
    map: Map<'a>,
    row: &'a ArchivedBoardGroupRow,
}

/// A size that is given `[m]`.
fn given(size: f64) -> Option<f64> {
    (size >= 0.0).then_some(size)
}

impl<'a> Signal<'a> {
    /// Variable message boards that it carries (1.8), in file order.
    pub fn boards(&self) -> impl ExactSizeIterator<Item = SignalBoard<'a>> + use<'a> {
        let map = self.map;
        let rows = self.row.boards().of(map.tables().signal_boards).iter();
        rows.map(move |row| SignalBoard { map, row })
    }

    /// A place on what it carries, inertial `[m]`: v to the left as its face looks, z upwards.
    pub fn on_carrier(&self, v: f64, z: f64) -> DVec3 {
        mapd_geometry::beside(self.position(), self.facing(), v, z)
    }
}

impl<'a> SignalBoard<'a> {
    /// The signal that carries it; none in a damaged archive.
    pub fn carrier(&self) -> Option<Signal<'a>> {
        Signal::new(self.map, self.row.signal())
    }

    /// Technology of the display as written, such as `LED`; empty if not given.
    pub fn display_type(&self) -> &'a str {
        string(self.map.tables(), self.row.display())
    }

    /// Width and height of the display `[m]`, where given.
    pub fn size(&self) -> [Option<f64>; 2] {
        [self.row.width(), self.row.height()].map(given)
    }

    /// Place on the carrier as written `[m]`: v and z.
    pub fn offset(&self) -> [f64; 2] {
        [self.row.v(), self.row.z()]
    }

    /// Inertial place `[m]`.
    pub fn position(&self) -> Option<DVec3> {
        Some(self.carrier()?.on_carrier(self.row.v(), self.row.z()))
    }

    /// Its display areas in file order.
    pub fn areas(&self) -> impl ExactSizeIterator<Item = DisplayArea<'a>> + use<'a> {
        let map = self.map;
        let rows = self.row.areas().of(map.tables().display_areas).iter();
        rows.map(move |row| DisplayArea { map, row })
    }

    /// Lane numbers that it is written to hold for, from the lower to the higher one; none: those of its carrier.
    pub fn validities(&self) -> impl ExactSizeIterator<Item = LaneRange> + use<'a> {
        validities(self.map, self.row.validities())
    }

    /// Signals that it controls or depends on.
    pub fn dependencies(&self) -> impl ExactSizeIterator<Item = SignalLink<'a>> + use<'a> {
        dependencies(self.map, self.row.dependencies())
    }

    /// Objects and signals that belong to it.
    pub fn links(&self) -> impl ExactSizeIterator<Item = SignalLink<'a>> + use<'a> {
        links(self.map, self.row.links())
    }
}

impl<'a> DisplayArea<'a> {
    /// The board that it is a part of; none in a damaged archive.
    pub fn board(&self) -> Option<SignalBoard<'a>> {
        let row = self.map.tables().signal_boards.get(self.row.board() as usize)?;
        Some(SignalBoard { map: self.map, row })
    }

    /// Its number on the board, where given.
    pub fn index(&self) -> Option<i32> {
        (self.row.index() >= 0).then(|| self.row.index())
    }

    /// Width and height `[m]`, where given as numbers.
    pub fn size(&self) -> [Option<f64>; 2] {
        [self.row.width(), self.row.height()].map(given)
    }

    /// Place on the carrier as written `[m]`: v and z.
    pub fn offset(&self) -> [f64; 2] {
        [self.row.v(), self.row.z()]
    }

    /// Inertial place `[m]`, in the frame that the board's own place counts in; none in a damaged archive.
    pub fn position(&self) -> Option<DVec3> {
        Some(self.board()?.carrier()?.on_carrier(self.row.v(), self.row.z()))
    }
}

impl<'a> BoardGroupMember<'a> {
    /// Id of the group, verbatim.
    pub fn group(&self) -> &'a str {
        string(self.map.tables(), self.row.group())
    }

    /// Id of the signal as written.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// The signal that carries the board; none where the map has none of this id.
    pub fn signal(&self) -> Option<Signal<'a>> {
        Signal::new(self.map, self.row.signal())
    }

    /// The board, by its number at the signal; none where the signal has no such board.
    pub fn board(&self) -> Option<SignalBoard<'a>> {
        let number = usize::try_from(self.row.board()).ok()?;
        self.signal()?.boards().nth(number)
    }

    /// Rank in the group, where given.
    pub fn rank(&self) -> Option<i32> {
        (self.row.rank() >= 0).then(|| self.row.rank())
    }
}

impl<'a> Map<'a> {
    /// Members of all groups of variable message boards (1.8), group by group in file order.
    pub fn board_groups(&self) -> impl ExactSizeIterator<Item = BoardGroupMember<'a>> + use<'a> {
        let map = *self;
        map.tables().board_groups.iter().map(move |row| BoardGroupMember { map, row })
    }
}
