//! Reads the elements of `profiles`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/profiles.toml; change that file instead.

use super::profiles::*;
use super::schema_profiles::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for ElevationProfile {
    fn schema() -> &'static ElementSchema {
        &ELEVATION_PROFILE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.elevation),
            _ => {}
        }
    }
}

impl Element for Elevation {
    fn schema() -> &'static ElementSchema {
        &ELEVATION
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
            1 => self.a = cursor.double(),
            2 => self.b = cursor.double(),
            3 => self.c = cursor.double(),
            4 => self.d = cursor.double(),
            _ => {}
        }
    }
}

impl Element for LateralProfile {
    fn schema() -> &'static ElementSchema {
        &LATERAL_PROFILE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.superelevation),
            1 => cursor.push(&mut self.crossfall),
            2 => cursor.push(&mut self.shape),
            3 => cursor.put(&mut self.cross_section_surface),
            _ => {}
        }
    }
}

impl Element for Superelevation {
    fn schema() -> &'static ElementSchema {
        &SUPERELEVATION
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
            1 => self.a = cursor.double(),
            2 => self.b = cursor.double(),
            3 => self.c = cursor.double(),
            4 => self.d = cursor.double(),
            _ => {}
        }
    }
}

impl Element for Crossfall {
    fn schema() -> &'static ElementSchema {
        &CROSSFALL
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.side = cursor.word::<super::words::CrossfallSide>(),
            1 => self.s = cursor.double(),
            2 => self.a = cursor.double(),
            3 => self.b = cursor.double(),
            4 => self.c = cursor.double(),
            5 => self.d = cursor.double(),
            _ => {}
        }
    }
}

impl Element for Shape {
    fn schema() -> &'static ElementSchema {
        &SHAPE
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
            2 => self.a = cursor.double(),
            3 => self.b = cursor.double(),
            4 => self.c = cursor.double(),
            5 => self.d = cursor.double(),
            _ => {}
        }
    }
}

impl Element for CrossSectionSurface {
    fn schema() -> &'static ElementSchema {
        &CROSS_SECTION_SURFACE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.t_offset),
            1 => cursor.put(&mut self.surface_strips),
            _ => {}
        }
    }
}

impl Element for SurfaceOffset {
    fn schema() -> &'static ElementSchema {
        &SURFACE_OFFSET
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.coefficients),
            _ => {}
        }
    }
}

impl Element for Coefficients {
    fn schema() -> &'static ElementSchema {
        &COEFFICIENTS
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
            4 => self.s = cursor.double(),
            _ => {}
        }
    }
}

impl Element for SurfaceStrips {
    fn schema() -> &'static ElementSchema {
        &SURFACE_STRIPS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.strip),
            _ => {}
        }
    }
}

impl Element for Strip {
    fn schema() -> &'static ElementSchema {
        &STRIP
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.id = cursor.int(),
            1 => self.mode = cursor.word::<super::words::StripMode>(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.width),
            1 => cursor.put(&mut self.constant),
            2 => cursor.put(&mut self.linear),
            3 => cursor.put(&mut self.quadratic),
            4 => cursor.put(&mut self.cubic),
            _ => {}
        }
    }
}

impl Element for StripWidth {
    fn schema() -> &'static ElementSchema {
        &STRIP_WIDTH
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.coefficients),
            _ => {}
        }
    }
}

impl Element for StripConstant {
    fn schema() -> &'static ElementSchema {
        &STRIP_CONSTANT
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.coefficients),
            _ => {}
        }
    }
}

impl Element for StripLinear {
    fn schema() -> &'static ElementSchema {
        &STRIP_LINEAR
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.coefficients),
            _ => {}
        }
    }
}

impl Element for StripQuadratic {
    fn schema() -> &'static ElementSchema {
        &STRIP_QUADRATIC
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.coefficients),
            _ => {}
        }
    }
}

impl Element for StripCubic {
    fn schema() -> &'static ElementSchema {
        &STRIP_CUBIC
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.coefficients),
            _ => {}
        }
    }
}
