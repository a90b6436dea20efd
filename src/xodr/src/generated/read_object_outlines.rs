//! Reads the elements of `object_outlines`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/object_outlines.toml; change that file instead.

use super::object_outlines::*;
use super::schema_object_outlines::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for Outline {
    fn schema() -> &'static ElementSchema {
        &OUTLINE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.id = cursor.uint(),
            1 => self.fill_type = cursor.word::<super::words::OutlineFillType>(),
            2 => self.outer = cursor.boolean(),
            3 => self.closed = cursor.boolean(),
            4 => self.lane_type = cursor.word::<super::words::LaneType>(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.corner_road),
            1 => cursor.push(&mut self.corner_local),
            2 => cursor.push(&mut self.curve_local),
            3 => cursor.put(&mut self.markings),
            _ => {}
        }
    }
}

impl Element for CornerRoad {
    fn schema() -> &'static ElementSchema {
        &CORNER_ROAD
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.id = cursor.uint(),
            1 => self.s = cursor.double(),
            2 => self.t = cursor.double(),
            3 => self.dz = cursor.double(),
            4 => self.height = cursor.double(),
            _ => {}
        }
    }
}

impl Element for CornerLocal {
    fn schema() -> &'static ElementSchema {
        &CORNER_LOCAL
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.id = cursor.uint(),
            1 => self.u = cursor.double(),
            2 => self.v = cursor.double(),
            3 => self.z = cursor.double(),
            4 => self.height = cursor.double(),
            _ => {}
        }
    }
}

impl Element for CurveLocal {
    fn schema() -> &'static ElementSchema {
        &CURVE_LOCAL
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.id = cursor.uint(),
            1 => self.u = cursor.double(),
            2 => self.v = cursor.double(),
            3 => self.z = cursor.double(),
            4 => self.height = cursor.double(),
            5 => self.length = cursor.double(),
            6 => self.hdg = cursor.double(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.arc),
            1 => cursor.put(&mut self.line),
            2 => cursor.put(&mut self.param_poly3),
            _ => {}
        }
    }
}

impl Element for CurveLocalArc {
    fn schema() -> &'static ElementSchema {
        &CURVE_LOCAL_ARC
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

impl Element for CurveLocalLine {
    fn schema() -> &'static ElementSchema {
        &CURVE_LOCAL_LINE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
}

impl Element for CurveLocalParamPoly3 {
    fn schema() -> &'static ElementSchema {
        &CURVE_LOCAL_PARAM_POLY3
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

impl Element for Markings {
    fn schema() -> &'static ElementSchema {
        &MARKINGS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.marking),
            _ => {}
        }
    }
}

impl Element for Marking {
    fn schema() -> &'static ElementSchema {
        &MARKING
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.side = cursor.word::<super::words::SideType>(),
            1 => self.weight = cursor.word::<super::words::RoadMarkWeight>(),
            2 => self.width = cursor.double(),
            3 => self.color = cursor.word::<super::words::RoadMarkColor>(),
            4 => self.z_offset = cursor.double(),
            5 => self.space_length = cursor.double(),
            6 => self.line_length = cursor.double(),
            7 => self.start_offset = cursor.double(),
            8 => self.stop_offset = cursor.double(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.corner_reference),
            _ => {}
        }
    }
}

impl Element for CornerReference {
    fn schema() -> &'static ElementSchema {
        &CORNER_REFERENCE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.id = cursor.uint(),
            _ => {}
        }
    }
}

impl Element for Outlines {
    fn schema() -> &'static ElementSchema {
        &OUTLINES
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.outline),
            _ => {}
        }
    }
}

impl Element for ObjectBorders {
    fn schema() -> &'static ElementSchema {
        &OBJECT_BORDERS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.border),
            _ => {}
        }
    }
}

impl Element for ObjectBorder {
    fn schema() -> &'static ElementSchema {
        &OBJECT_BORDER
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.width = cursor.double(),
            1 => self.r#type = cursor.word::<super::words::BorderType>(),
            2 => self.outline_id = cursor.uint(),
            3 => self.use_complete_outline = cursor.boolean(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.corner_reference),
            _ => {}
        }
    }
}

impl Element for Skeleton {
    fn schema() -> &'static ElementSchema {
        &SKELETON
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.polyline),
            _ => {}
        }
    }
}

impl Element for Polyline {
    fn schema() -> &'static ElementSchema {
        &POLYLINE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.id = cursor.uint(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.vertex_road),
            1 => cursor.push(&mut self.vertex_local),
            _ => {}
        }
    }
}

impl Element for VertexRoad {
    fn schema() -> &'static ElementSchema {
        &VERTEX_ROAD
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.dz = cursor.double(),
            1 => self.radius = cursor.double(),
            2 => self.intersection_point = cursor.boolean(),
            3 => self.id = cursor.uint(),
            4 => self.s = cursor.double(),
            5 => self.t = cursor.double(),
            _ => {}
        }
    }
}

impl Element for VertexLocal {
    fn schema() -> &'static ElementSchema {
        &VERTEX_LOCAL
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.radius = cursor.double(),
            1 => self.intersection_point = cursor.boolean(),
            2 => self.id = cursor.uint(),
            3 => self.u = cursor.double(),
            4 => self.v = cursor.double(),
            5 => self.z = cursor.double(),
            _ => {}
        }
    }
}
