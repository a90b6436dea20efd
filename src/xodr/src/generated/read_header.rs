//! Reads the elements of `header`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/header.toml; change that file instead.

use super::header::*;
use super::schema_header::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for Header {
    fn schema() -> &'static ElementSchema {
        &HEADER
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.rev_major = cursor.int(),
            1 => self.rev_minor = cursor.int(),
            2 => self.name = cursor.text(),
            3 => self.version = cursor.text(),
            4 => self.date = cursor.text(),
            5 => self.north = cursor.double(),
            6 => self.south = cursor.double(),
            7 => self.east = cursor.double(),
            8 => self.west = cursor.double(),
            9 => self.vendor = cursor.text(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.geo_reference),
            1 => cursor.put(&mut self.offset),
            2 => cursor.put(&mut self.license),
            3 => cursor.put(&mut self.default_regulations),
            _ => {}
        }
    }
}

impl Element for GeoReference {
    fn schema() -> &'static ElementSchema {
        &GEO_REFERENCE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn content(&mut self, cursor: &mut Cursor<'_>) {
        self.content = cursor.text();
    }
}

impl Element for Offset {
    fn schema() -> &'static ElementSchema {
        &OFFSET
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
            _ => {}
        }
    }
}

impl Element for License {
    fn schema() -> &'static ElementSchema {
        &LICENSE
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
            1 => self.spdxid = cursor.text(),
            2 => self.text = cursor.text(),
            3 => self.resource = cursor.text(),
            _ => {}
        }
    }
}

impl Element for DefaultRegulations {
    fn schema() -> &'static ElementSchema {
        &DEFAULT_REGULATIONS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.road_regulations),
            1 => cursor.push(&mut self.signal_regulations),
            _ => {}
        }
    }
}

impl Element for RoadRegulation {
    fn schema() -> &'static ElementSchema {
        &ROAD_REGULATION
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.r#type = cursor.word::<super::words::RoadType>(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.semantics),
            _ => {}
        }
    }
}

impl Element for SignalRegulation {
    fn schema() -> &'static ElementSchema {
        &SIGNAL_REGULATION
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.r#type = cursor.text(),
            1 => self.subtype = cursor.text(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.semantics),
            _ => {}
        }
    }
}
