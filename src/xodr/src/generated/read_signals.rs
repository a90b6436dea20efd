//! Reads the elements of `signals`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/signals.toml; change that file instead.

use super::schema_signals::*;
use super::signals::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for Signals {
    fn schema() -> &'static ElementSchema {
        &SIGNALS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.signal),
            1 => cursor.push(&mut self.signal_reference),
            _ => {}
        }
    }
}

impl Element for Signal {
    fn schema() -> &'static ElementSchema {
        &SIGNAL
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.id = cursor.text(),
            1 => self.name = cursor.text(),
            2 => self.dynamic = cursor.boolean(),
            3 => self.orientation = cursor.word::<super::words::Orientation>(),
            4 => self.country = cursor.country(),
            5 => self.country_revision = cursor.text(),
            6 => self.r#type = cursor.text(),
            7 => self.subtype = cursor.text(),
            8 => self.value = cursor.double(),
            9 => self.text = cursor.text(),
            10 => self.unit = cursor.word::<super::words::Unit>(),
            11 => self.height = cursor.double(),
            12 => self.length = cursor.double(),
            13 => self.h_offset = cursor.double(),
            14 => self.width = cursor.double(),
            15 => self.roll = cursor.double(),
            16 => self.pitch = cursor.double(),
            17 => self.invalidated = cursor.boolean(),
            18 => self.temporary = cursor.boolean(),
            19 => self.s = cursor.double(),
            20 => self.t = cursor.double(),
            21 => self.z_offset = cursor.double(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.validity),
            1 => cursor.push(&mut self.dependency),
            2 => cursor.push(&mut self.reference),
            3 => cursor.put(&mut self.position_inertial),
            4 => cursor.put(&mut self.position_road),
            5 => cursor.put(&mut self.semantics),
            6 => cursor.push(&mut self.static_board),
            7 => cursor.push(&mut self.vms_board),
            _ => {}
        }
    }
}

impl Element for SignalDependency {
    fn schema() -> &'static ElementSchema {
        &SIGNAL_DEPENDENCY
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.id = cursor.text(),
            1 => self.r#type = cursor.text(),
            _ => {}
        }
    }
}

impl Element for SignalLink {
    fn schema() -> &'static ElementSchema {
        &SIGNAL_LINK
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.element_type = cursor.word::<super::words::ReferenceElementType>(),
            1 => self.element_id = cursor.text(),
            2 => self.r#type = cursor.text(),
            _ => {}
        }
    }
}

impl Element for PositionInertial {
    fn schema() -> &'static ElementSchema {
        &POSITION_INERTIAL
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.x = cursor.double(),
            1 => self.y = cursor.double(),
            2 => self.z = cursor.double(),
            3 => self.hdg = cursor.double(),
            4 => self.pitch = cursor.double(),
            5 => self.roll = cursor.double(),
            _ => {}
        }
    }
}

impl Element for PositionRoad {
    fn schema() -> &'static ElementSchema {
        &POSITION_ROAD
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.road_id = cursor.text(),
            1 => self.s = cursor.double(),
            2 => self.t = cursor.double(),
            3 => self.z_offset = cursor.double(),
            4 => self.h_offset = cursor.double(),
            5 => self.pitch = cursor.double(),
            6 => self.roll = cursor.double(),
            _ => {}
        }
    }
}

impl Element for StaticBoard {
    fn schema() -> &'static ElementSchema {
        &STATIC_BOARD
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.validity),
            1 => cursor.push(&mut self.dependency),
            2 => cursor.push(&mut self.reference),
            3 => cursor.push(&mut self.sign),
            _ => {}
        }
    }
}

impl Element for BoardSign {
    fn schema() -> &'static ElementSchema {
        &BOARD_SIGN
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.id = cursor.text(),
            1 => self.name = cursor.text(),
            2 => self.dynamic = cursor.boolean(),
            3 => self.orientation = cursor.word::<super::words::Orientation>(),
            4 => self.country = cursor.country(),
            5 => self.country_revision = cursor.text(),
            6 => self.r#type = cursor.text(),
            7 => self.subtype = cursor.text(),
            8 => self.value = cursor.double(),
            9 => self.text = cursor.text(),
            10 => self.unit = cursor.word::<super::words::Unit>(),
            11 => self.height = cursor.double(),
            12 => self.length = cursor.double(),
            13 => self.h_offset = cursor.double(),
            14 => self.width = cursor.double(),
            15 => self.roll = cursor.double(),
            16 => self.pitch = cursor.double(),
            17 => self.invalidated = cursor.boolean(),
            18 => self.temporary = cursor.boolean(),
            19 => self.v = cursor.double(),
            20 => self.z = cursor.double(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.validity),
            1 => cursor.push(&mut self.dependency),
            2 => cursor.push(&mut self.reference),
            3 => cursor.put(&mut self.position_inertial),
            4 => cursor.put(&mut self.position_road),
            5 => cursor.put(&mut self.semantics),
            6 => cursor.push(&mut self.static_board),
            7 => cursor.push(&mut self.vms_board),
            _ => {}
        }
    }
}

impl Element for VmsBoard {
    fn schema() -> &'static ElementSchema {
        &VMS_BOARD
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.display_height = cursor.double(),
            1 => self.display_type = cursor.word::<super::words::DisplayType>(),
            2 => self.display_width = cursor.double(),
            3 => self.v = cursor.double(),
            4 => self.z = cursor.double(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.validity),
            1 => cursor.push(&mut self.dependency),
            2 => cursor.push(&mut self.reference),
            3 => cursor.push(&mut self.display_area),
            _ => {}
        }
    }
}

impl Element for DisplayArea {
    fn schema() -> &'static ElementSchema {
        &DISPLAY_AREA
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.height = cursor.text(),
            1 => self.index = cursor.int(),
            2 => self.v = cursor.double(),
            3 => self.width = cursor.text(),
            4 => self.z = cursor.double(),
            _ => {}
        }
    }
}

impl Element for SignalReference {
    fn schema() -> &'static ElementSchema {
        &SIGNAL_REFERENCE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.s = cursor.double(),
            1 => self.t = cursor.double(),
            2 => self.id = cursor.text(),
            3 => self.orientation = cursor.word::<super::words::Orientation>(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.validity),
            _ => {}
        }
    }
}

impl Element for VmsGroup {
    fn schema() -> &'static ElementSchema {
        &VMS_GROUP
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.id = cursor.text(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.vms_board_reference),
            _ => {}
        }
    }
}

impl Element for VmsBoardReference {
    fn schema() -> &'static ElementSchema {
        &VMS_BOARD_REFERENCE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.signal_id = cursor.text(),
            1 => self.vms_index = cursor.int(),
            2 => self.group_index = cursor.int(),
            _ => {}
        }
    }
}
