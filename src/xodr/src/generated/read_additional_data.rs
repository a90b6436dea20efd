//! Reads the elements of `additional_data`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/additional_data.toml; change that file instead.

use super::additional_data::*;
use super::schema_additional_data::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for DataQuality {
    fn schema() -> &'static ElementSchema {
        &DATA_QUALITY
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.error),
            1 => cursor.put(&mut self.raw_data),
            _ => {}
        }
    }
}

impl Element for DataError {
    fn schema() -> &'static ElementSchema {
        &DATA_ERROR
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.xy_absolute = cursor.double(),
            1 => self.z_absolute = cursor.double(),
            2 => self.xy_relative = cursor.double(),
            3 => self.z_relative = cursor.double(),
            _ => {}
        }
    }
}

impl Element for RawData {
    fn schema() -> &'static ElementSchema {
        &RAW_DATA
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.date = cursor.text(),
            1 => self.source = cursor.word::<super::words::RawDataSource>(),
            2 => self.source_comment = cursor.text(),
            3 => self.post_processing = cursor.word::<super::words::PostProcessing>(),
            4 => self.post_processing_comment = cursor.text(),
            _ => {}
        }
    }
}

impl Element for Include {
    fn schema() -> &'static ElementSchema {
        &INCLUDE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.file = cursor.text(),
            _ => {}
        }
    }
}

impl Element for UserData {
    fn schema() -> &'static ElementSchema {
        &USER_DATA
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.code = cursor.text(),
            1 => self.value = cursor.text(),
            _ => {}
        }
    }
}
