//! Reads the elements of `objects`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/objects.toml; change that file instead.

use super::objects::*;
use super::schema_objects::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for Objects {
    fn schema() -> &'static ElementSchema {
        &OBJECTS
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.object),
            1 => cursor.push(&mut self.object_reference),
            2 => cursor.push(&mut self.tunnel),
            3 => cursor.push(&mut self.bridge),
            _ => {}
        }
    }
}

impl Element for Object {
    fn schema() -> &'static ElementSchema {
        &OBJECT
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.t = cursor.double(),
            1 => self.z_offset = cursor.double(),
            2 => self.r#type = cursor.word_as_text::<super::words::ObjectType>(),
            3 => self.valid_length = cursor.double(),
            4 => self.orientation = cursor.word::<super::words::Orientation>(),
            5 => self.subtype = cursor.text(),
            6 => self.dynamic = cursor.boolean(),
            7 => self.hdg = cursor.double(),
            8 => self.name = cursor.text(),
            9 => self.pitch = cursor.double(),
            10 => self.id = cursor.text(),
            11 => self.roll = cursor.double(),
            12 => self.height = cursor.double(),
            13 => self.s = cursor.double(),
            14 => self.length = cursor.double(),
            15 => self.width = cursor.double(),
            16 => self.radius = cursor.double(),
            17 => self.perp_to_road = cursor.boolean(),
            18 => self.invalidated = cursor.boolean(),
            19 => self.temporary = cursor.boolean(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.repeat),
            1 => cursor.put(&mut self.outline),
            2 => cursor.put(&mut self.outlines),
            3 => cursor.push(&mut self.material),
            4 => cursor.push(&mut self.validity),
            5 => cursor.put(&mut self.parking_space),
            6 => cursor.put(&mut self.markings),
            7 => cursor.put(&mut self.borders),
            8 => cursor.put(&mut self.surface),
            9 => cursor.put(&mut self.skeleton),
            _ => {}
        }
    }
}

impl Element for ObjectRepeat {
    fn schema() -> &'static ElementSchema {
        &OBJECT_REPEAT
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
            1 => self.length = cursor.double(),
            2 => self.distance = cursor.double(),
            3 => self.t_start = cursor.double(),
            4 => self.t_end = cursor.double(),
            5 => self.height_start = cursor.double(),
            6 => self.height_end = cursor.double(),
            7 => self.z_offset_start = cursor.double(),
            8 => self.z_offset_end = cursor.double(),
            9 => self.width_start = cursor.double(),
            10 => self.width_end = cursor.double(),
            11 => self.length_start = cursor.double(),
            12 => self.length_end = cursor.double(),
            13 => self.radius_start = cursor.double(),
            14 => self.radius_end = cursor.double(),
            15 => self.detach_from_reference_line = cursor.boolean(),
            16 => self.b_t = cursor.double(),
            17 => self.c_t = cursor.double(),
            18 => self.d_t = cursor.double(),
            _ => {}
        }
    }
}

impl Element for ObjectMaterial {
    fn schema() -> &'static ElementSchema {
        &OBJECT_MATERIAL
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.surface = cursor.text(),
            1 => self.friction = cursor.double(),
            2 => self.roughness = cursor.double(),
            3 => self.road_mark_color = cursor.word::<super::words::RoadMarkColor>(),
            _ => {}
        }
    }
}

impl Element for LaneValidity {
    fn schema() -> &'static ElementSchema {
        &LANE_VALIDITY
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.from_lane = cursor.int(),
            1 => self.to_lane = cursor.int(),
            2 => self.layer = cursor.word::<super::words::LayerType>(),
            _ => {}
        }
    }
}

impl Element for ParkingSpace {
    fn schema() -> &'static ElementSchema {
        &PARKING_SPACE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.access = cursor.word::<super::words::ParkingSpaceAccess>(),
            1 => self.restrictions = cursor.text(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.marking),
            _ => {}
        }
    }
}

impl Element for ParkingSpaceMarking {
    fn schema() -> &'static ElementSchema {
        &PARKING_SPACE_MARKING
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.side = cursor.word::<super::words::ParkingSpaceMarkingSide>(),
            1 => self.r#type = cursor.word::<super::words::RoadMarkType>(),
            2 => self.width = cursor.double(),
            3 => self.color = cursor.word::<super::words::RoadMarkColor>(),
            _ => {}
        }
    }
}

impl Element for ObjectSurface {
    fn schema() -> &'static ElementSchema {
        &OBJECT_SURFACE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.crg),
            _ => {}
        }
    }
}

impl Element for ObjectCrg {
    fn schema() -> &'static ElementSchema {
        &OBJECT_CRG
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
            1 => self.hide_road_surface_crg = cursor.boolean(),
            2 => self.z_scale = cursor.double(),
            _ => {}
        }
    }
}

impl Element for ObjectReference {
    fn schema() -> &'static ElementSchema {
        &OBJECT_REFERENCE
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
            3 => self.z_offset = cursor.double(),
            4 => self.valid_length = cursor.double(),
            5 => self.orientation = cursor.word::<super::words::Orientation>(),
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

impl Element for Tunnel {
    fn schema() -> &'static ElementSchema {
        &TUNNEL
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
            1 => self.length = cursor.double(),
            2 => self.name = cursor.text(),
            3 => self.id = cursor.text(),
            4 => self.r#type = cursor.word::<super::words::TunnelType>(),
            5 => self.lighting = cursor.double(),
            6 => self.daylight = cursor.double(),
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

impl Element for Bridge {
    fn schema() -> &'static ElementSchema {
        &BRIDGE
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
            1 => self.length = cursor.double(),
            2 => self.name = cursor.text(),
            3 => self.id = cursor.text(),
            4 => self.r#type = cursor.word::<super::words::BridgeType>(),
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
