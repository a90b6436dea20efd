//! Controllers: which signals switch together, and which controllers a junction ties together.

use super::Signal;
use crate::ids::ControllerId;
use crate::junction::Junction;
use crate::map::Map;
use mapd_archive::{ArchivedControllerRow, ArchivedJunctionControllerRow, string};

/// A controller: a group of signals that switch together (OpenDRIVE 1.8.1, 14.6).
#[derive(Clone, Copy)]
pub struct Controller<'a> {
    pub(crate) map: Map<'a>,
    number: u32,
    row: &'a ArchivedControllerRow,
}

/// A controller's part in a junction: all controllers of a junction are one synchronisation group.
#[derive(Clone, Copy)]
pub struct JunctionController<'a> {
    map: Map<'a>,
    row: &'a ArchivedJunctionControllerRow,
}

impl<'a> Controller<'a> {
    pub(crate) fn new(map: Map<'a>, number: u32) -> Option<Self> {
        Some(Self { map, number, row: map.tables().controllers.get(number as usize)? })
    }

    /// Dense id.
    pub fn controller_id(&self) -> ControllerId {
        ControllerId::new(self.number, self.map.content())
    }

    /// OpenDRIVE's id, verbatim.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// OpenDRIVE's name.
    pub fn name(&self) -> &'a str {
        string(self.map.tables(), self.row.name())
    }

    /// Its rank, where given.
    pub fn sequence(&self) -> Option<i32> {
        Some(self.row.sequence()).filter(|rank| *rank >= 0)
    }

    /// Signals of the group that the map has, in file order.
    pub fn signals(&self) -> impl Iterator<Item = Signal<'a>> + use<'a> {
        let map = self.map;
        let controls = self.row.controls().of(map.tables().controls);
        controls.iter().filter_map(move |control| Signal::new(map, control.signal()))
    }

    /// Junctions in whose synchronisation group it is.
    pub fn junctions(&self) -> impl Iterator<Item = Junction<'a>> + use<'a> {
        let (map, own) = (self.map, self.number);
        let rows = map.tables().junction_controllers.iter();
        let own_rows = rows.filter(move |row| row.controller() == own);
        own_rows.filter_map(move |row| Junction::new(map, row.junction()))
    }
}

impl<'a> JunctionController<'a> {
    /// The controller, where the map has it.
    pub fn controller(&self) -> Option<Controller<'a>> {
        Controller::new(self.map, self.row.controller())
    }

    /// Id as written.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// Rank in the junction's sequence, where given.
    pub fn sequence(&self) -> Option<i32> {
        Some(self.row.sequence()).filter(|rank| *rank >= 0)
    }
}

impl<'a> Signal<'a> {
    /// Controllers that switch it.
    pub fn controllers(&self) -> impl Iterator<Item = Controller<'a>> + use<'a> {
        let map = self.map;
        let rows = self.row.controllers().of(map.tables().signal_controllers);
        rows.iter().filter_map(move |row| Controller::new(map, *row))
    }
}

impl<'a> Map<'a> {
    /// All controllers in file order.
    pub fn controllers(&self) -> impl ExactSizeIterator<Item = Controller<'a>> + use<'a> {
        let map = *self;
        let rows = map.tables().controllers.iter().enumerate();
        rows.map(move |(number, row)| Controller { map, number: number as u32, row })
    }
}

impl<'a> Junction<'a> {
    /// The junction's synchronisation group, in file order.
    pub fn controllers(&self) -> impl Iterator<Item = JunctionController<'a>> + use<'a> {
        let (map, own) = (self.map, self.junction_id().row());
        let rows = map.tables().junction_controllers;
        let from = rows.partition_point(|row| row.junction() < own);
        let rest = rows.get(from..).unwrap_or(&[]).iter();
        let own_rows = rest.take_while(move |row| row.junction() == own);
        own_rows.map(move |row| JunctionController { map, row })
    }
}
