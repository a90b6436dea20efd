//! Reads the elements of `road_mark`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/road_mark.toml; change that file instead.

use super::road_mark::*;
use super::schema_road_mark::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for RoadMark {
    fn schema() -> &'static ElementSchema {
        &ROAD_MARK
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.s_offset = cursor.double(),
            1 => self.r#type = cursor.word::<super::words::RoadMarkType>(),
            2 => self.weight = cursor.word::<super::words::RoadMarkWeight>(),
            3 => self.color = cursor.word::<super::words::RoadMarkColor>(),
            4 => self.material = cursor.text(),
            5 => self.width = cursor.double(),
            6 => self.lane_change = cursor.word::<super::words::LaneChange>(),
            7 => self.height = cursor.double(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.sway),
            1 => cursor.put(&mut self.type_element),
            2 => cursor.put(&mut self.explicit),
            _ => {}
        }
    }
}

impl Element for Sway {
    fn schema() -> &'static ElementSchema {
        &SWAY
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.ds = cursor.double(),
            1 => self.a = cursor.double(),
            2 => self.b = cursor.double(),
            3 => self.c = cursor.double(),
            4 => self.d = cursor.double(),
            _ => {}
        }
    }
}

impl Element for RoadMarkPattern {
    fn schema() -> &'static ElementSchema {
        &ROAD_MARK_PATTERN
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
            1 => self.width = cursor.double(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.line),
            _ => {}
        }
    }
}

impl Element for RoadMarkLine {
    fn schema() -> &'static ElementSchema {
        &ROAD_MARK_LINE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.length = cursor.double(),
            1 => self.space = cursor.double(),
            2 => self.t_offset = cursor.double(),
            3 => self.s_offset = cursor.double(),
            4 => self.rule = cursor.word::<super::words::RoadMarkRule>(),
            5 => self.width = cursor.double(),
            6 => self.color = cursor.word::<super::words::RoadMarkColor>(),
            _ => {}
        }
    }
}

impl Element for ExplicitRoadMark {
    fn schema() -> &'static ElementSchema {
        &EXPLICIT_ROAD_MARK
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.line),
            _ => {}
        }
    }
}

impl Element for ExplicitLine {
    fn schema() -> &'static ElementSchema {
        &EXPLICIT_LINE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.length = cursor.double(),
            1 => self.t_offset = cursor.double(),
            2 => self.s_offset = cursor.double(),
            3 => self.rule = cursor.word::<super::words::RoadMarkRule>(),
            4 => self.width = cursor.double(),
            _ => {}
        }
    }
}
