//! Reads the elements of `railroad`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/railroad.toml; change that file instead.

use super::railroad::*;
use super::schema_railroad::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for Railroad {
    fn schema() -> &'static ElementSchema {
        &RAILROAD
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.switch),
            _ => {}
        }
    }
}

impl Element for Switch {
    fn schema() -> &'static ElementSchema {
        &SWITCH
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.name = cursor.text(),
            1 => self.id = cursor.text(),
            2 => self.position = cursor.word::<super::words::SwitchPosition>(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.main_track),
            1 => cursor.put(&mut self.side_track),
            2 => cursor.put(&mut self.partner),
            _ => {}
        }
    }
}

impl Element for MainTrack {
    fn schema() -> &'static ElementSchema {
        &MAIN_TRACK
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
            1 => self.s = cursor.double(),
            2 => self.dir = cursor.word::<super::words::ElementDir>(),
            _ => {}
        }
    }
}

impl Element for SideTrack {
    fn schema() -> &'static ElementSchema {
        &SIDE_TRACK
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
            1 => self.s = cursor.double(),
            2 => self.dir = cursor.word::<super::words::ElementDir>(),
            _ => {}
        }
    }
}

impl Element for SwitchPartner {
    fn schema() -> &'static ElementSchema {
        &SWITCH_PARTNER
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.name = cursor.text(),
            1 => self.id = cursor.text(),
            _ => {}
        }
    }
}

impl Element for Station {
    fn schema() -> &'static ElementSchema {
        &STATION
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.name = cursor.text(),
            1 => self.id = cursor.text(),
            2 => self.r#type = cursor.word::<super::words::StationType>(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.platform),
            _ => {}
        }
    }
}

impl Element for Platform {
    fn schema() -> &'static ElementSchema {
        &PLATFORM
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.name = cursor.text(),
            1 => self.id = cursor.text(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.segment),
            _ => {}
        }
    }
}

impl Element for PlatformSegment {
    fn schema() -> &'static ElementSchema {
        &PLATFORM_SEGMENT
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
            1 => self.s_start = cursor.double(),
            2 => self.s_end = cursor.double(),
            3 => self.side = cursor.word::<super::words::PlatformSide>(),
            _ => {}
        }
    }
}
