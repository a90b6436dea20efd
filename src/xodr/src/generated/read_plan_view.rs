//! Reads the elements of `plan_view`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/plan_view.toml; change that file instead.

use super::plan_view::*;
use super::schema_plan_view::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for PlanView {
    fn schema() -> &'static ElementSchema {
        &PLAN_VIEW
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.geometry),
            _ => {}
        }
    }
}

impl Element for Geometry {
    fn schema() -> &'static ElementSchema {
        &GEOMETRY
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
            1 => self.x = cursor.double(),
            2 => self.y = cursor.double(),
            3 => self.hdg = cursor.double(),
            4 => self.length = cursor.double(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.line),
            1 => cursor.put(&mut self.spiral),
            2 => cursor.put(&mut self.arc),
            3 => cursor.put(&mut self.poly3),
            4 => cursor.put(&mut self.param_poly3),
            _ => {}
        }
    }
}

impl Element for Line {
    fn schema() -> &'static ElementSchema {
        &LINE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
}

impl Element for Spiral {
    fn schema() -> &'static ElementSchema {
        &SPIRAL
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.curv_start = cursor.double(),
            1 => self.curv_end = cursor.double(),
            _ => {}
        }
    }
}

impl Element for Arc {
    fn schema() -> &'static ElementSchema {
        &ARC
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.curvature = cursor.double(),
            _ => {}
        }
    }
}

impl Element for Poly3 {
    fn schema() -> &'static ElementSchema {
        &POLY3
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.a = cursor.double(),
            1 => self.b = cursor.double(),
            2 => self.c = cursor.double(),
            3 => self.d = cursor.double(),
            _ => {}
        }
    }
}

impl Element for ParamPoly3 {
    fn schema() -> &'static ElementSchema {
        &PARAM_POLY3
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.a_u = cursor.double(),
            1 => self.b_u = cursor.double(),
            2 => self.c_u = cursor.double(),
            3 => self.d_u = cursor.double(),
            4 => self.a_v = cursor.double(),
            5 => self.b_v = cursor.double(),
            6 => self.c_v = cursor.double(),
            7 => self.d_v = cursor.double(),
            8 => self.p_range = cursor.word::<super::words::ParamPoly3Range>(),
            _ => {}
        }
    }
}
