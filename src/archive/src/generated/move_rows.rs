//! Letting rows refer to where what they refer to comes to lie.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::annotation_rows::*;
use super::append::RowMappings;
use super::beside_rows::*;
use super::network_rows::*;
use super::object_rows::*;
use super::signal_rows::*;

impl MapRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.name = moves.strings.row(self.name);
        self.version = moves.strings.row(self.version);
        self.date = moves.strings.row(self.date);
        self.vendor = moves.strings.row(self.vendor);
        self.geo_reference = moves.strings.row(self.geo_reference);
        self.projection = moves.strings.row(self.projection);
    }
}

impl FileFrameRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.projection = moves.strings.row(self.projection);
        self.target = moves.strings.row(self.target);
    }
}

impl RoadRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.id = moves.strings.row(self.id);
        self.name = moves.strings.row(self.name);
        self.junction = moves.junctions.row(self.junction);
        self.geometries = moves.geometries.range(self.geometries);
        self.elevations = moves.cubics.range(self.elevations);
        self.superelevations = moves.cubics.range(self.superelevations);
        self.lane_offsets = moves.cubics.range(self.lane_offsets);
        self.sections = moves.sections.range(self.sections);
        self.types = moves.road_types.range(self.types);
    }
}

impl GeometryRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.coefficients = moves.coefficients.range(self.coefficients);
    }
}

impl RoadTypeRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.country = moves.strings.row(self.country);
    }
}

impl SectionRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.road = moves.roads.row(self.road);
        self.lanes = moves.lanes.range(self.lanes);
    }
}

impl LaneRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.section = moves.sections.row(self.section);
        self.first_width = moves
            .cubics
            .range(crate::Range { first: self.first_width, count: self.width_count.into() })
            .first;
        self.first_node = moves
            .lane_nodes
            .range(crate::Range { first: self.first_node, count: self.node_count.into() })
            .first;
        self.first_mark = moves.road_marks.row(self.first_mark);
    }
}

impl LaneBlockRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.section = moves.sections.row(self.section);
        self.road = moves.roads.row(self.road);
    }
}

impl LaneLengthRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.lane = moves.lanes.row(self.lane);
    }
}

impl LaneSpeedRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.lane = moves.lanes.row(self.lane);
    }
}

impl JunctionRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.id = moves.strings.row(self.id);
        self.name = moves.strings.row(self.name);
        self.connections = moves.connections.range(self.connections);
    }
}

impl ConnectionRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.id = moves.strings.row(self.id);
        self.incoming_road = moves.roads.row(self.incoming_road);
        self.connecting_road = moves.roads.row(self.connecting_road);
        self.lane_links = moves.connection_lane_links.range(self.lane_links);
    }
}

impl SurfaceRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.road = moves.roads.row(self.road);
        self.shapes = moves.shape_stations.range(self.shapes);
        self.crossfall_left = moves.cubics.range(self.crossfall_left);
        self.crossfall_right = moves.cubics.range(self.crossfall_right);
        self.strip_offset = moves.cubics.range(self.strip_offset);
        self.strips = moves.surface_strips.range(self.strips);
    }
}

impl ShapeStationRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.records = moves.cubics.range(self.records);
    }
}

impl SurfaceStripRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.width = moves.cubics.range(self.width);
        self.constant = moves.cubics.range(self.constant);
        self.linear = moves.cubics.range(self.linear);
        self.quadratic = moves.cubics.range(self.quadratic);
        self.cubic = moves.cubics.range(self.cubic);
    }
}

impl LaneHeightRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.lane = moves.lanes.row(self.lane);
    }
}

impl LaneMaterialRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.lane = moves.lanes.row(self.lane);
        self.surface = moves.strings.row(self.surface);
    }
}

impl ElevationGridRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.junction = moves.junctions.row(self.junction);
        self.rows = moves.grid_rows.range(self.rows);
        self.transitions = moves.grid_transitions.range(self.transitions);
    }
}

impl GridRowRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.left = moves.grid_heights.range(self.left);
        self.right = moves.grid_heights.range(self.right);
    }
}

impl RoadMarkRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.style = moves.road_mark_styles.row(self.style);
    }
}

impl RoadMarkStyleRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.material = moves.strings.row(self.material);
        self.name = moves.strings.row(self.name);
        self.lines = moves.road_mark_lines.range(self.lines);
        self.sway = moves.cubics.range(self.sway);
    }
}

impl LaneLayerRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.road = moves.roads.row(self.road);
        self.sections = moves.sections.range(self.sections);
        self.lane_offsets = moves.cubics.range(self.lane_offsets);
    }
}

impl LaneNodeRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.lane = moves.lanes.row(self.lane);
    }
}

impl ConflictRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.lane = moves.lanes.row(self.lane);
        self.other = moves.lanes.row(self.other);
    }
}

impl SignalRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.id = moves.strings.row(self.id);
        self.name = moves.strings.row(self.name);
        self.r#type = moves.strings.row(self.r#type);
        self.subtype = moves.strings.row(self.subtype);
        self.country = moves.strings.row(self.country);
        self.country_revision = moves.strings.row(self.country_revision);
        self.text = moves.strings.row(self.text);
        self.unit = moves.strings.row(self.unit);
        self.road = moves.roads.row(self.road);
        self.carrier = moves.signals.row(self.carrier);
        self.dependencies = moves.signal_dependencies.range(self.dependencies);
        self.links = moves.signal_links.range(self.links);
        self.semantics = moves.signal_semantics.range(self.semantics);
        self.boards = moves.signal_boards.range(self.boards);
        self.controllers = moves.signal_controllers.range(self.controllers);
    }
}

impl SignalPlaceRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.signal = moves.signals.row(self.signal);
        self.road = moves.roads.row(self.road);
        self.lanes = moves.signal_lanes.range(self.lanes);
    }
}

impl SignalLaneRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.place = moves.signal_places.row(self.place);
        self.lane = moves.lanes.row(self.lane);
    }
}

impl SpeedSignsAtEntryRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.lane = moves.lanes.row(self.lane);
        self.limit = moves.signals.row(self.limit);
        self.zone = moves.signals.row(self.zone);
    }
}

impl SignalDependencyRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.signal = moves.signals.row(self.signal);
        self.id = moves.strings.row(self.id);
        self.r#type = moves.strings.row(self.r#type);
    }
}

impl SignalLinkRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.signal = moves.signals.row(self.signal);
        self.object = moves.objects.row(self.object);
        self.owner = moves.signals.row(self.owner);
        self.id = moves.strings.row(self.id);
        self.r#type = moves.strings.row(self.r#type);
    }
}

impl SignalSemanticsRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.element = moves.strings.row(self.element);
        self.kind = moves.strings.row(self.kind);
        self.unit = moves.strings.row(self.unit);
    }
}

impl SignalBoardRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.signal = moves.signals.row(self.signal);
        self.display = moves.strings.row(self.display);
        self.areas = moves.display_areas.range(self.areas);
        self.validities = moves.lane_ranges.range(self.validities);
        self.dependencies = moves.signal_dependencies.range(self.dependencies);
        self.links = moves.signal_links.range(self.links);
    }
}

impl DisplayAreaRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.board = moves.signal_boards.row(self.board);
    }
}

impl BoardGroupRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.group = moves.strings.row(self.group);
        self.signal = moves.signals.row(self.signal);
        self.id = moves.strings.row(self.id);
    }
}

impl ControllerRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.id = moves.strings.row(self.id);
        self.name = moves.strings.row(self.name);
        self.controls = moves.controls.range(self.controls);
    }
}

impl ControlRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.signal = moves.signals.row(self.signal);
        self.id = moves.strings.row(self.id);
        self.r#type = moves.strings.row(self.r#type);
    }
}

impl JunctionControllerRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.junction = moves.junctions.row(self.junction);
        self.controller = moves.controllers.row(self.controller);
        self.id = moves.strings.row(self.id);
        self.r#type = moves.strings.row(self.r#type);
    }
}

impl JunctionPriorityRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.junction = moves.junctions.row(self.junction);
        self.high = moves.roads.row(self.high);
        self.low = moves.roads.row(self.low);
    }
}

impl QuarantinedRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.id = moves.strings.row(self.id);
        self.owner = moves.strings.row(self.owner);
        self.rule = moves.strings.row(self.rule);
        self.message = moves.strings.row(self.message);
    }
}

impl QuarantinedFileRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.part = moves.quarantined.row(self.part);
        self.file = moves.strings.row(self.file);
    }
}

impl QuarantinedContentRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.id = moves.strings.row(self.id);
        self.part = moves.quarantined.row(self.part);
    }
}

impl ObjectRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.id = moves.strings.row(self.id);
        self.name = moves.strings.row(self.name);
        self.kind = moves.strings.row(self.kind);
        self.subtype = moves.strings.row(self.subtype);
        self.road = moves.roads.row(self.road);
        self.junction = moves.junctions.row(self.junction);
        self.outlines = moves.object_outlines.range(self.outlines);
        self.copies = moves.object_copies.range(self.copies);
        self.lanes = moves.object_lanes.range(self.lanes);
        self.validities = moves.lane_ranges.range(self.validities);
    }
}

impl ObjectOutlineRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.points = moves.object_points.range(self.points);
    }
}

impl ObjectCopyRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.object = moves.objects.row(self.object);
        self.outlines = moves.object_outlines.range(self.outlines);
    }
}

impl ObjectLaneRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.object = moves.objects.row(self.object);
        self.lane = moves.lanes.row(self.lane);
    }
}

impl ObjectMarkingRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.object = moves.objects.row(self.object);
        self.outline = moves.object_outlines.row(self.outline);
        self.corners = moves.object_corners.range(self.corners);
        self.color = moves.strings.row(self.color);
        self.weight = moves.strings.row(self.weight);
        self.kind = moves.strings.row(self.kind);
    }
}

impl ObjectBorderRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.object = moves.objects.row(self.object);
        self.outline = moves.object_outlines.row(self.outline);
        self.corners = moves.object_corners.range(self.corners);
        self.kind = moves.strings.row(self.kind);
    }
}

impl ObjectSkeletonRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.object = moves.objects.row(self.object);
        self.vertices = moves.skeleton_vertices.range(self.vertices);
    }
}

impl ParkingSpaceRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.object = moves.objects.row(self.object);
        self.restrictions = moves.strings.row(self.restrictions);
        self.access = moves.strings.row(self.access);
    }
}

impl ObjectMaterialRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.object = moves.objects.row(self.object);
        self.surface = moves.strings.row(self.surface);
        self.color = moves.strings.row(self.color);
    }
}

impl ObjectValueRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.object = moves.objects.row(self.object);
        self.unit = moves.strings.row(self.unit);
    }
}

impl ObjectReferenceRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.road = moves.roads.row(self.road);
        self.object = moves.objects.row(self.object);
        self.id = moves.strings.row(self.id);
        self.validities = moves.lane_ranges.range(self.validities);
    }
}

impl StructureRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.road = moves.roads.row(self.road);
        self.id = moves.strings.row(self.id);
        self.name = moves.strings.row(self.name);
        self.material = moves.strings.row(self.material);
        self.validities = moves.lane_ranges.range(self.validities);
    }
}

impl SwitchRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.road = moves.roads.row(self.road);
        self.id = moves.strings.row(self.id);
        self.name = moves.strings.row(self.name);
        self.main = moves.roads.row(self.main);
        self.side = moves.roads.row(self.side);
        self.partner = moves.switches.row(self.partner);
    }
}

impl StationRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.id = moves.strings.row(self.id);
        self.name = moves.strings.row(self.name);
        self.kind = moves.strings.row(self.kind);
        self.platforms = moves.platforms.range(self.platforms);
    }
}

impl PlatformRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.id = moves.strings.row(self.id);
        self.name = moves.strings.row(self.name);
        self.segments = moves.platform_segments.range(self.segments);
    }
}

impl PlatformSegmentRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.road = moves.roads.row(self.road);
    }
}

impl AnnotationRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.path = moves.strings.row(self.path);
        self.name = moves.strings.row(self.name);
        self.value = moves.strings.row(self.value);
        self.text = moves.strings.row(self.text);
    }
}

impl IncludedFileRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.name = moves.strings.row(self.name);
    }
}

impl LaneVisibilityRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.lane = moves.lanes.row(self.lane);
    }
}

impl LaneRuleRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.lane = moves.lanes.row(self.lane);
        self.value = moves.strings.row(self.value);
    }
}

impl JunctionGroupRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.id = moves.strings.row(self.id);
        self.name = moves.strings.row(self.name);
        self.members = moves.junction_group_members.range(self.members);
        self.ring = moves.ring_lanes.range(self.ring);
    }
}

impl JunctionGroupMemberRow {
    /// Lets the row refer to where what it refers to comes to lie.
    pub fn move_by(&mut self, moves: &RowMappings) {
        self.group = moves.junction_groups.row(self.group);
        self.junction = moves.junctions.row(self.junction);
        self.id = moves.strings.row(self.id);
    }
}
