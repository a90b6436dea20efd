//! Reads the elements of `controller`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/controller.toml; change that file instead.

use super::controller::*;
use super::schema_controller::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for Controller {
    fn schema() -> &'static ElementSchema {
        &CONTROLLER
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
            2 => self.sequence = cursor.uint(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.control),
            _ => {}
        }
    }
}

impl Element for Control {
    fn schema() -> &'static ElementSchema {
        &CONTROL
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
            1 => self.r#type = cursor.text(),
            _ => {}
        }
    }
}
