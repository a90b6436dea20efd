//! Reads the elements of `junction`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/junction.toml; change that file instead.

use super::junction::*;
use super::schema_junction::*;
use crate::cursor::Cursor;
use crate::element::Element;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

impl Element for Junction {
    fn schema() -> &'static ElementSchema {
        &JUNCTION
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
            1 => self.id = cursor.text(),
            2 => self.r#type = cursor.word::<super::words::JunctionType>(),
            3 => self.main_road = cursor.text(),
            4 => self.s_start = cursor.double(),
            5 => self.s_end = cursor.double(),
            6 => self.orientation = cursor.word::<super::words::Orientation>(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.connection),
            1 => cursor.push(&mut self.road_section),
            2 => cursor.push(&mut self.cross_path),
            3 => cursor.push(&mut self.priority),
            4 => cursor.push(&mut self.controller),
            5 => cursor.put(&mut self.surface),
            6 => cursor.put(&mut self.plan_view),
            7 => cursor.put(&mut self.objects),
            8 => cursor.put(&mut self.boundary),
            9 => cursor.put(&mut self.elevation_grid),
            _ => {}
        }
    }
}

impl Element for Connection {
    fn schema() -> &'static ElementSchema {
        &CONNECTION
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
            1 => self.incoming_road = cursor.text(),
            2 => self.contact_point = cursor.word::<super::words::ContactPoint>(),
            3 => self.r#type = cursor.word::<super::words::ConnectionType>(),
            4 => self.connecting_road = cursor.text(),
            5 => self.linked_road = cursor.text(),
            6 => self.connection_master = cursor.text(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.lane_link),
            1 => cursor.put(&mut self.predecessor),
            2 => cursor.put(&mut self.successor),
            _ => {}
        }
    }
}

impl Element for JunctionLaneLink {
    fn schema() -> &'static ElementSchema {
        &JUNCTION_LANE_LINK
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.from = cursor.int(),
            1 => self.to = cursor.int(),
            2 => self.overlap_zone = cursor.double(),
            3 => self.from_layer = cursor.word::<super::words::LayerType>(),
            4 => self.to_layer = cursor.word::<super::words::LayerType>(),
            _ => {}
        }
    }
}

impl Element for ConnectionEnd {
    fn schema() -> &'static ElementSchema {
        &CONNECTION_END
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.element_type = cursor.text(),
            1 => self.element_id = cursor.text(),
            2 => self.element_s = cursor.double(),
            3 => self.element_dir = cursor.word::<super::words::ElementDir>(),
            _ => {}
        }
    }
}

impl Element for RoadSection {
    fn schema() -> &'static ElementSchema {
        &ROAD_SECTION
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
            1 => self.road_id = cursor.text(),
            2 => self.s_start = cursor.double(),
            3 => self.s_end = cursor.double(),
            _ => {}
        }
    }
}

impl Element for CrossPath {
    fn schema() -> &'static ElementSchema {
        &CROSS_PATH
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.crossing_road = cursor.text(),
            1 => self.id = cursor.text(),
            2 => self.road_at_end = cursor.text(),
            3 => self.road_at_start = cursor.text(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.put(&mut self.start_lane_link),
            1 => cursor.put(&mut self.end_lane_link),
            _ => {}
        }
    }
}

impl Element for CrossPathLaneLink {
    fn schema() -> &'static ElementSchema {
        &CROSS_PATH_LANE_LINK
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
            1 => self.from = cursor.int(),
            2 => self.to = cursor.int(),
            _ => {}
        }
    }
}

impl Element for Priority {
    fn schema() -> &'static ElementSchema {
        &PRIORITY
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.high = cursor.text(),
            1 => self.low = cursor.text(),
            _ => {}
        }
    }
}

impl Element for JunctionController {
    fn schema() -> &'static ElementSchema {
        &JUNCTION_CONTROLLER
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
            1 => self.r#type = cursor.text(),
            2 => self.sequence = cursor.uint(),
            _ => {}
        }
    }
}

impl Element for Boundary {
    fn schema() -> &'static ElementSchema {
        &BOUNDARY
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.segment),
            _ => {}
        }
    }
}

impl Element for BoundarySegment {
    fn schema() -> &'static ElementSchema {
        &BOUNDARY_SEGMENT
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.road_id = cursor.text(),
            1 => self.r#type = cursor.word::<super::words::SegmentType>(),
            2 => self.boundary_lane = cursor.int(),
            3 => self.s_start = cursor.position_or_end(),
            4 => self.s_end = cursor.position_or_end(),
            5 => self.contact_point = cursor.position_or_end(),
            6 => self.joint_lane_start = cursor.int(),
            7 => self.joint_lane_end = cursor.int(),
            8 => self.transition_length = cursor.double(),
            _ => {}
        }
    }
}

impl Element for ElevationGrid {
    fn schema() -> &'static ElementSchema {
        &ELEVATION_GRID
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.s_start = cursor.text(),
            1 => self.grid_spacing = cursor.text(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.elevation),
            _ => {}
        }
    }
}

impl Element for GridElevation {
    fn schema() -> &'static ElementSchema {
        &GRID_ELEVATION
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.left = cursor.text(),
            1 => self.center = cursor.text(),
            2 => self.right = cursor.text(),
            _ => {}
        }
    }
}

impl Element for JunctionGroup {
    fn schema() -> &'static ElementSchema {
        &JUNCTION_GROUP
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
            1 => self.id = cursor.text(),
            2 => self.r#type = cursor.word::<super::words::JunctionGroupType>(),
            _ => {}
        }
    }
    fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => cursor.push(&mut self.junction_reference),
            _ => {}
        }
    }
}

impl Element for JunctionReference {
    fn schema() -> &'static ElementSchema {
        &JUNCTION_REFERENCE
    }
    fn begin(&mut self, span: Span) {
        self.span = span;
    }
    fn extensions(&mut self) -> &mut Extensions {
        &mut self.extensions
    }
    fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {
        match slot {
            0 => self.junction = cursor.text(),
            _ => {}
        }
    }
}

impl Element for JunctionSurface {
    fn schema() -> &'static ElementSchema {
        &JUNCTION_SURFACE
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

impl Element for JunctionCrg {
    fn schema() -> &'static ElementSchema {
        &JUNCTION_CRG
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
