//! Reads the elements of `road`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/road.toml; change that file instead.

use super::road::*;
use super::schema_road::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for Road {
    fn schema() -> &'static ElementSchema {
        &ROAD
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
            1 => self.length = cursor.double(),
            2 => self.id = cursor.text(),
            3 => self.junction = cursor.text(),
            4 => self.rule = cursor.word::<super::words::TrafficRule>(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.link),
            1 => cursor.push(&mut self.r#type),
            2 => cursor.put(&mut self.plan_view),
            3 => cursor.put(&mut self.elevation_profile),
            4 => cursor.put(&mut self.lateral_profile),
            5 => cursor.push(&mut self.lanes),
            6 => cursor.put(&mut self.objects),
            7 => cursor.put(&mut self.signals),
            8 => cursor.put(&mut self.surface),
            9 => cursor.put(&mut self.railroad),
            _ => {}
        }
    }
}

impl Element for RoadLink {
    fn schema() -> &'static ElementSchema {
        &ROAD_LINK
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.predecessor),
            1 => cursor.put(&mut self.successor),
            2 => cursor.push(&mut self.neighbor),
            _ => {}
        }
    }
}

impl Element for LinkedElement {
    fn schema() -> &'static ElementSchema {
        &LINKED_ELEMENT
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.element_id = cursor.text(),
            1 => self.element_type = cursor.word::<super::words::ElementType>(),
            2 => self.contact_point = cursor.word::<super::words::ContactPoint>(),
            3 => self.element_s = cursor.double(),
            4 => self.element_dir = cursor.word::<super::words::ElementDir>(),
            _ => {}
        }
    }
}

impl Element for Neighbor {
    fn schema() -> &'static ElementSchema {
        &NEIGHBOR
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.side = cursor.word::<super::words::NeighborSide>(),
            1 => self.element_id = cursor.text(),
            2 => self.direction = cursor.word::<super::words::Direction>(),
            _ => {}
        }
    }
}

impl Element for RoadTypeRecord {
    fn schema() -> &'static ElementSchema {
        &ROAD_TYPE_RECORD
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
            1 => self.r#type = cursor.word::<super::words::RoadType>(),
            2 => self.country = cursor.country(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.speed),
            _ => {}
        }
    }
}

impl Element for RoadSpeed {
    fn schema() -> &'static ElementSchema {
        &ROAD_SPEED
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.max = cursor.speed_limit(),
            1 => self.unit = cursor.word::<super::words::UnitSpeed>(),
            _ => {}
        }
    }
}

impl Element for RoadSurface {
    fn schema() -> &'static ElementSchema {
        &ROAD_SURFACE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.crg),
            _ => {}
        }
    }
}

impl Element for RoadCrg {
    fn schema() -> &'static ElementSchema {
        &ROAD_CRG
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
            1 => self.s_start = cursor.double(),
            2 => self.s_end = cursor.double(),
            3 => self.orientation = cursor.word::<super::words::Direction>(),
            4 => self.mode = cursor.word::<super::words::CrgMode>(),
            5 => self.purpose = cursor.word::<super::words::CrgPurpose>(),
            6 => self.s_offset = cursor.double(),
            7 => self.t_offset = cursor.double(),
            8 => self.x_offset = cursor.double(),
            9 => self.y_offset = cursor.double(),
            10 => self.z_offset = cursor.double(),
            11 => self.z_scale = cursor.double(),
            12 => self.h_offset = cursor.double(),
            _ => {}
        }
    }
}
