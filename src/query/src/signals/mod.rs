//! Signals, their controllers and boards: what they are, and where they count. What follows for a lane is among
//! [`rules`](crate::rules).

mod ahead;
mod board;
mod controller;
pub(crate) mod lane;
mod link;
mod near;

pub use ahead::{SignalAhead, SignalsAhead};
pub(crate) use ahead::{ahead, met};
pub use board::{BoardGroupMember, DisplayArea, SignalBoard};
pub use controller::{Controller, JunctionController};
pub use lane::LaneSignal;
pub use link::SignalLink;
pub use near::NearSignal;

use crate::error::QueryError;
use crate::extents::SourcePosition;
use crate::ids::SignalId;
use crate::map::{Map, find};
use crate::road::Road;
use glam::DVec3;
use mapd_archive::{
    ArchivedSignalPlaceRow, ArchivedSignalRow, Class, Orientation, SignalPosition, signal_flags,
    signal_values, string,
};

/// A value as a file has it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct WrittenValue<'a> {
    /// The number.
    pub value: f64,
    /// Its unit; empty where none is written.
    pub unit: &'a str,
}

/// A traffic sign, light or marking of OpenDRIVE's `signals` (OpenDRIVE 1.8.1, 14).
#[derive(Clone, Copy)]
pub struct Signal<'a> {
    pub(crate) map: Map<'a>,
    number: u32,
    row: &'a ArchivedSignalRow,
}

/// What a traffic light can show.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LightStates {
    /// Lamps: 1 red, 2 yellow, 4 green.
    pub bulbs: u8,
    /// Phases: 1 red, 2 red and yellow, 4 yellow, 8 green, 16 flashing red, 32 flashing yellow, 64 flashing green, 128 off.
    pub phases: u8,
    /// Movements that it is for, 0 all: 1 left, 2 straight on, 4 right, 8 back.
    pub arrows: u8,
}

impl LightStates {
    /// Names of the phases' bits, from the lowest.
    pub const PHASES: [&'static str; 8] = [
        "red",
        "red_yellow",
        "yellow",
        "green",
        "flashing_red",
        "flashing_yellow",
        "flashing_green",
        "off",
    ];
    /// Names of the lamps' bits, from the lowest.
    pub const BULBS: [&'static str; 3] = ["red", "yellow", "green"];
    /// Names of the movements' bits, from the lowest.
    pub const ARROWS: [&'static str; 4] = ["left", "straight", "right", "u_turn"];
}

/// A child of `signal/semantics`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SignalSemantics<'a> {
    /// Name of the element, such as `speed`.
    pub element: &'a str,
    /// Its type, such as `maximum`; may be empty.
    pub kind: &'a str,
    /// Value as written; 0 if none.
    pub value: f64,
    /// Unit as written; may be empty.
    pub unit: &'a str,
    /// What it means.
    pub class: Class,
}

/// A place where a signal counts: on its own road, or on one that refers to it.
#[derive(Clone, Copy)]
pub struct SignalPlace<'a> {
    map: Map<'a>,
    number: u32,
    row: &'a ArchivedSignalPlaceRow,
}

impl<'a> Signal<'a> {
    pub(crate) fn new(map: Map<'a>, number: u32) -> Option<Self> {
        Some(Self { map, number, row: map.tables().signals.get(number as usize)? })
    }

    fn text(&self, number: u32) -> &'a str {
        string(self.map.tables(), number)
    }

    /// Dense id.
    pub fn signal_id(&self) -> SignalId {
        SignalId::new(self.number, self.map.content())
    }

    /// OpenDRIVE's id, verbatim.
    pub fn id(&self) -> &'a str {
        self.text(self.row.id())
    }

    /// OpenDRIVE's name.
    pub fn name(&self) -> &'a str {
        self.text(self.row.name())
    }

    /// What it means; `Unknown` where no table maps its code.
    #[inline]
    pub fn class(&self) -> Class {
        Class::from_code(self.row.class())
    }

    /// Code as written: country, its revision, type, subtype.
    pub fn code(&self) -> [&'a str; 4] {
        let row = self.row;
        [row.country(), row.country_revision(), row.r#type(), row.subtype()].map(|n| self.text(n))
    }

    /// Text shown.
    pub fn shown_text(&self) -> &'a str {
        self.text(self.row.text())
    }

    /// Value and unit as written.
    pub fn written_value(&self) -> Option<WrittenValue<'a>> {
        let is_there = self.row.has_value() & signal_values::WRITTEN != 0;
        let unit = || self.text(self.row.unit());
        is_there.then(|| WrittenValue { value: self.row.written_value(), unit: unit() })
    }

    /// What the class means by its value: `[m/s]`, `[m]` or `[kg]`.
    pub fn value(&self) -> Option<f64> {
        let is_there = self.row.has_value() & signal_values::MEANT != 0;
        is_there.then(|| self.row.value())
    }

    /// Whether it has a value, or states a speed that cannot be read.
    pub(crate) fn states_value(&self) -> bool {
        self.row.has_value() & (signal_values::MEANT | signal_values::UNREADABLE) != 0
    }

    /// Whether the file does not write that value's unit: it is read in the unit of its country's table, or in SI units.
    pub fn is_unit_assumed(&self) -> bool {
        self.row.has_value() & signal_values::UNIT_ASSUMED != 0
    }

    /// Whether its state changes.
    pub fn is_dynamic(&self) -> bool {
        self.row.dynamic() != 0
    }

    /// Whether it stands for a limited time (1.9).
    pub fn is_temporary(&self) -> bool {
        self.row.flags() & signal_flags::TEMPORARY != 0
    }

    /// Whether it no longer holds (1.9).
    pub fn is_invalidated(&self) -> bool {
        self.row.flags() & signal_flags::INVALIDATED != 0
    }

    /// Where it stands, inertial `[m]`.
    pub fn position(&self) -> DVec3 {
        DVec3::new(self.row.x(), self.row.y(), self.row.z())
    }

    /// Where the place in space comes from.
    pub fn position_source(&self) -> SignalPosition {
        SignalPosition::from_code(self.row.position())
    }

    /// Direction of the face's normal in plan view `[rad]`, in (−π, π].
    pub fn facing(&self) -> f64 {
        self.row.facing()
    }

    /// Pitch of what stands there `[rad]`.
    pub fn pitch(&self) -> f64 {
        self.row.pitch()
    }

    /// Roll of what stands there `[rad]`.
    pub fn roll(&self) -> f64 {
        self.row.roll()
    }

    /// s, t and zOffset as written `[m]`, and hOffset `[rad]`.
    pub fn track(&self) -> [f64; 4] {
        [self.row.s(), self.row.t(), self.row.z_offset(), self.row.h_offset()]
    }

    /// Width, height and length `[m]`, where given.
    pub fn size(&self) -> [Option<f64>; 3] {
        [self.row.width(), self.row.height(), self.row.length()].map(|x| (x >= 0.0).then_some(x))
    }

    /// Direction of travel that it is for, on its own road.
    pub fn orientation(&self) -> Orientation {
        Orientation::from_code(self.row.orientation())
    }

    /// The road that it is written in.
    pub fn road(&self) -> Option<Road<'a>> {
        Road::new(self.map, self.row.road())
    }

    /// Of a sign on a board: the signal that carries the board.
    pub fn carrier(&self) -> Option<Signal<'a>> {
        Self::new(self.map, self.row.carrier())
    }

    /// What a traffic light can show; none for what is no light.
    pub fn light(&self) -> Option<LightStates> {
        let (bulbs, phases, arrows) = (self.row.bulbs(), self.row.phases(), self.row.arrows());
        (bulbs != 0).then_some(LightStates { bulbs, phases, arrows })
    }

    /// What it says itself that it means (1.8, 1.9).
    pub fn semantics(&self) -> impl ExactSizeIterator<Item = SignalSemantics<'a>> + use<'a> {
        let tables = self.map.tables();
        self.row.semantics().of(tables.signal_semantics).iter().map(move |row| SignalSemantics {
            element: string(tables, row.element()),
            kind: string(tables, row.kind()),
            value: row.written_value(),
            unit: string(tables, row.unit()),
            class: Class::from_code(row.class()),
        })
    }

    /// Places where it counts, by road and s. Looks at all places of the map.
    pub fn places(&self) -> impl Iterator<Item = SignalPlace<'a>> + use<'a> {
        let own = self.number;
        self.map.signal_places().filter(move |place| place.row.signal() == own)
    }

    /// Line and column of its start tag, from 1.
    pub fn source_position(&self) -> SourcePosition {
        SourcePosition { line: self.row.line(), column: self.row.column() }
    }
}

impl<'a> SignalPlace<'a> {
    pub(crate) fn new(map: Map<'a>, number: u32) -> Option<Self> {
        Some(Self { map, number, row: map.tables().signal_places.get(number as usize)? })
    }

    /// The signal.
    pub fn signal(&self) -> Option<Signal<'a>> {
        Signal::new(self.map, self.row.signal())
    }

    /// The road.
    pub fn road(&self) -> Option<Road<'a>> {
        Road::new(self.map, self.row.road())
    }

    /// Place along the road `[m]`.
    #[inline]
    pub fn s(&self) -> f64 {
        self.row.s()
    }

    /// Lateral place on the road `[m]`.
    pub fn t(&self) -> f64 {
        self.row.t()
    }

    /// Direction of travel that the signal is for here.
    pub fn orientation(&self) -> Orientation {
        Orientation::from_code(self.row.orientation())
    }

    /// Whether the road only refers to the signal.
    pub fn is_reference(&self) -> bool {
        self.row.kind() == 1
    }

    /// Lanes that the signal is for here.
    pub fn lanes(&self) -> impl Iterator<Item = LaneSignal<'a>> + use<'a> {
        let map = self.map;
        let rows = self.row.lanes().rows(map.tables().signal_lanes.len());
        rows.filter_map(move |row| LaneSignal::new(map, row))
    }
}

impl<'a> Map<'a> {
    /// All signals in file order, signs on boards behind what carries them.
    pub fn signals(&self) -> impl ExactSizeIterator<Item = Signal<'a>> + use<'a> {
        let map = *self;
        let rows = map.tables().signals.iter().enumerate();
        rows.map(move |(number, row)| Signal { map, number: number as u32, row })
    }

    /// The signal of an id.
    ///
    /// Errors: an id of another map content, or that names nothing; a damaged archive.
    pub fn signal(&self, id: SignalId) -> Result<Signal<'a>, QueryError> {
        self.known_id(id.row, id.content, id.tile)?;
        Signal::new(*self, id.row).ok_or_else(|| QueryError::Corrupt.of_row(id.row))
    }

    /// A signal with OpenDRIVE's id, compared byte by byte; of several with one id any.
    pub fn signal_by_id(&self, id: &str) -> Option<Signal<'a>> {
        let name = |row: u32| Signal::new(*self, row).map(|signal| signal.id());
        Signal::new(*self, find(self.tables().signals_by_id, id, name)?)
    }

    /// All places of signals, by road and s.
    pub fn signal_places(&self) -> impl ExactSizeIterator<Item = SignalPlace<'a>> + use<'a> {
        let map = *self;
        let rows = map.tables().signal_places.iter().enumerate();
        rows.map(move |(number, row)| SignalPlace { map, number: number as u32, row })
    }
}

impl<'a> Road<'a> {
    /// Places of signals on the road, ascending in s.
    pub fn signal_places(&self) -> impl Iterator<Item = SignalPlace<'a>> + use<'a> {
        let (map, own) = (self.map, self.road_id().row());
        let rows = map.tables().signal_places;
        let from = rows.partition_point(|row| row.road() < own);
        let to = rows.partition_point(|row| row.road() <= own);
        (from..to.max(from)).filter_map(move |row| SignalPlace::new(map, row as u32))
    }
}
