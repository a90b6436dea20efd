//! Reads the elements of `lanes`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/lanes.toml; change that file instead.

use super::lanes::*;
use super::schema_lanes::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for Lanes {
    fn schema() -> &'static ElementSchema {
        &LANES
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.layer = cursor.word::<super::words::LayerType>(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.lane_offset),
            1 => cursor.push(&mut self.lane_section),
            _ => {}
        }
    }
}

impl Element for LaneOffset {
    fn schema() -> &'static ElementSchema {
        &LANE_OFFSET
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

impl Element for LaneSection {
    fn schema() -> &'static ElementSchema {
        &LANE_SECTION
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
            1 => self.s = cursor.double(),
            2 => self.single_side = cursor.boolean(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.left),
            1 => cursor.put(&mut self.center),
            2 => cursor.put(&mut self.right),
            _ => {}
        }
    }
}

impl Element for LaneSectionSide {
    fn schema() -> &'static ElementSchema {
        &LANE_SECTION_SIDE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.lane),
            _ => {}
        }
    }
}

impl Element for Lane {
    fn schema() -> &'static ElementSchema {
        &LANE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.r#type = cursor.word::<super::words::LaneType>(),
            1 => self.advisory = cursor.word::<super::words::LaneAdvisory>(),
            2 => self.direction = cursor.word::<super::words::LaneDirection>(),
            3 => self.dynamic_lane_type = cursor.boolean(),
            4 => self.dynamic_lane_direction = cursor.boolean(),
            5 => self.level = cursor.boolean(),
            6 => self.road_works = cursor.boolean(),
            7 => self.id = cursor.int(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.link),
            1 => cursor.push(&mut self.border),
            2 => cursor.push(&mut self.width),
            3 => cursor.push(&mut self.road_mark),
            4 => cursor.push(&mut self.material),
            5 => cursor.push(&mut self.visibility),
            6 => cursor.push(&mut self.speed),
            7 => cursor.push(&mut self.access),
            8 => cursor.push(&mut self.height),
            9 => cursor.push(&mut self.rule),
            _ => {}
        }
    }
}

impl Element for LaneLink {
    fn schema() -> &'static ElementSchema {
        &LANE_LINK
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.predecessor),
            1 => cursor.push(&mut self.successor),
            _ => {}
        }
    }
}

impl Element for LinkedLane {
    fn schema() -> &'static ElementSchema {
        &LINKED_LANE
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
            1 => self.layer = cursor.text(),
            _ => {}
        }
    }
}

impl Element for LaneBorder {
    fn schema() -> &'static ElementSchema {
        &LANE_BORDER
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
            1 => self.a = cursor.double(),
            2 => self.b = cursor.double(),
            3 => self.c = cursor.double(),
            4 => self.d = cursor.double(),
            _ => {}
        }
    }
}

impl Element for LaneWidth {
    fn schema() -> &'static ElementSchema {
        &LANE_WIDTH
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
            1 => self.a = cursor.double(),
            2 => self.b = cursor.double(),
            3 => self.c = cursor.double(),
            4 => self.d = cursor.double(),
            _ => {}
        }
    }
}

impl Element for LaneMaterial {
    fn schema() -> &'static ElementSchema {
        &LANE_MATERIAL
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
            1 => self.surface = cursor.text(),
            2 => self.friction = cursor.double(),
            3 => self.roughness = cursor.double(),
            _ => {}
        }
    }
}

impl Element for LaneSpeed {
    fn schema() -> &'static ElementSchema {
        &LANE_SPEED
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
            1 => self.max = cursor.speed_limit(),
            2 => self.unit = cursor.word::<super::words::UnitSpeed>(),
            _ => {}
        }
    }
}

impl Element for LaneVisibility {
    fn schema() -> &'static ElementSchema {
        &LANE_VISIBILITY
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
            1 => self.forward = cursor.double(),
            2 => self.back = cursor.double(),
            3 => self.left = cursor.double(),
            4 => self.right = cursor.double(),
            _ => {}
        }
    }
}

impl Element for LaneAccess {
    fn schema() -> &'static ElementSchema {
        &LANE_ACCESS
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
            1 => self.rule = cursor.word::<super::words::AccessRule>(),
            2 => self.restriction = cursor.word_as_text::<super::words::AccessRestrictionType>(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.restriction_element),
            _ => {}
        }
    }
}

impl Element for AccessRestriction {
    fn schema() -> &'static ElementSchema {
        &ACCESS_RESTRICTION
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.r#type = cursor.word_as_text::<super::words::AccessRestrictionType>(),
            _ => {}
        }
    }
}

impl Element for LaneHeight {
    fn schema() -> &'static ElementSchema {
        &LANE_HEIGHT
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
            1 => self.inner = cursor.double(),
            2 => self.outer = cursor.double(),
            _ => {}
        }
    }
}

impl Element for LaneRule {
    fn schema() -> &'static ElementSchema {
        &LANE_RULE
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
            1 => self.value = cursor.text(),
            _ => {}
        }
    }
}

impl Element for LaneSectionCenter {
    fn schema() -> &'static ElementSchema {
        &LANE_SECTION_CENTER
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.lane),
            _ => {}
        }
    }
}

impl Element for CenterLane {
    fn schema() -> &'static ElementSchema {
        &CENTER_LANE
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
            1 => self.r#type = cursor.word::<super::words::LaneType>(),
            2 => self.level = cursor.boolean(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.link),
            1 => cursor.push(&mut self.border),
            2 => cursor.push(&mut self.width),
            3 => cursor.push(&mut self.road_mark),
            4 => cursor.push(&mut self.material),
            5 => cursor.push(&mut self.speed),
            6 => cursor.push(&mut self.access),
            7 => cursor.push(&mut self.height),
            8 => cursor.push(&mut self.rule),
            _ => {}
        }
    }
}
