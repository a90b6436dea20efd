//! What an overlay says.

use crate::ids::LaneId;
use mapd_archive::{
    ArchivedOverlayEntryRow, Overlay, OverlayKind, OverlayTables, VehicleClass, overlay_string,
};
use std::fmt;

/// Something that an overlay says.
#[derive(Clone, Copy)]
pub struct OverlayEntry<'a> {
    pub(super) tables: &'a OverlayTables<'a>,
    pub(super) row: &'a ArchivedOverlayEntryRow,
    number: u32,
}

/// An entry that holds on a stretch of a lane.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Restriction<'a> {
    /// What is said.
    pub entry: OverlayEntry<'a>,
    /// The lane.
    pub lane: LaneId,
    /// Smaller end of the stretch on the road `[m]`: at least the part of it on which the same entries hold.
    pub s_from: f64,
    /// Larger end `[m]`.
    pub s_to: f64,
}

impl<'a> OverlayEntry<'a> {
    pub(super) fn new(overlay: &'a Overlay<'a>, number: u32) -> Option<Self> {
        let tables = &overlay.tables;
        Some(Self { tables, row: tables.entries.get(number as usize)?, number })
    }

    /// Its place among the overlay's entries, from 0.
    pub fn number(&self) -> u32 {
        self.number
    }

    /// Its name, which no other entry has.
    pub fn id(&self) -> &'a str {
        overlay_string(self.tables, self.row.id())
    }

    /// Who says so; empty where that is not said.
    pub fn source(&self) -> &'a str {
        overlay_string(self.tables, self.row.source())
    }

    /// What is said, for people; may be empty.
    pub fn text(&self) -> &'a str {
        overlay_string(self.tables, self.row.text())
    }

    /// What it says.
    pub fn kind(&self) -> OverlayKind {
        OverlayKind::from_code(self.row.kind())
    }

    /// Of a speed, the limit `[m/s]`; none of other kinds.
    pub fn value(&self) -> Option<f64> {
        (self.kind() == OverlayKind::Speed).then(|| self.row.value())
    }

    /// How sure the source is, from 0 to 1.
    pub fn confidence(&self) -> f64 {
        self.row.confidence().into()
    }

    /// Whether a class of vehicles is concerned.
    pub fn concerns(&self, vehicle: VehicleClass) -> bool {
        self.row.vehicles() & vehicle.bit() != 0
    }
}

impl fmt::Debug for OverlayEntry<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("OverlayEntry").field("id", &self.id()).field("kind", &self.kind()).finish()
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for OverlayEntry<'_> {
    /// What its functions tell, but whom it concerns.
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeStruct;
        let mut out = to.serialize_struct("OverlayEntry", 7)?;
        out.serialize_field("number", &self.number)?;
        out.serialize_field("id", self.id())?;
        out.serialize_field("source", self.source())?;
        out.serialize_field("text", self.text())?;
        out.serialize_field("kind", &self.kind())?;
        out.serialize_field("value", &self.value())?;
        out.serialize_field("confidence", &self.confidence())?;
        out.end()
    }
}
