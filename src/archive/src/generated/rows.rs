//! The archive's tables as they are filled.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::annotation_rows::*;
use super::beside_rows::*;
use super::index_rows::*;
use super::network_rows::*;
use super::object_rows::*;
use super::signal_rows::*;
use super::tables::Tables;
use crate::table::Table;

/// All tables of a map as the compiler fills them.
#[derive(Default)]
pub struct Rows {
    /// UTF-8 text of all strings, one after the other, each once. String 0 is empty.
    pub string_bytes: Table<u8>,
    /// Start of each string in `string_bytes`; one more entry than strings.
    pub string_offsets: Table<u32>,
    /// Exactly one row: facts about the whole map.
    pub map: Table<MapRow>,
    /// One row for a map that was compiled into another frame than its file's (`--crs`), else none. `projection` of the map is then the target, its offset 0.
    pub file_frames: Table<FileFrameRow>,
    /// One row per road, in file order. The row number is the RoadId.
    pub roads: Table<RoadRow>,
    /// Plan-view geometries, as written or transformed into the target frame, with the values that their evaluation needs (OpenDRIVE 1.8.1, 9.2).
    pub geometries: Table<GeometryRow>,
    /// Numbers of the geometries. Line: none. Arc: curvature. Spiral: start and end curvature, then pieces of 20 (x and y as polynomials of degree 9 over −1 to 1). poly3: 4, paramPoly3: 8, then pieces of 10 (the curve parameter as a polynomial of true arc length). Transformed: pieces of 21 (heading of the middle relative to the start, then x and y as polynomials of degree 9). Equal sequences are stored once.
    pub coefficients: Table<f64>,
    /// Cubic records a + b·ds + c·ds² + d·ds³ with ds = s − `s`; each holds until the next of its range.
    pub cubics: Table<CubicRow>,
    /// road/type records.
    pub road_types: Table<RoadTypeRow>,
    /// Lane sections, road by road, ascending in s, with the frame of their lanes' points (`points`).
    pub sections: Table<SectionRow>,
    /// Lanes, section by section, from left to right. The row number is the LaneId. Lane 0 has no width; its border is the shifted reference line.
    pub lanes: Table<LaneRow>,
    /// lane/speed records, by lane and s.
    pub lane_speeds: Table<LaneSpeedRow>,
    /// s of points minus their section's start `[m]`: the values of a section ascend without duplicates, and all its lines share them. Equal sequences are stored once.
    pub point_stations: Table<f32>,
    /// Points of polylines, `point_bytes` each, the lowest first, lane by lane. From the lowest bit on: number of the point's station among the section's, then x, y and z in steps from the section's frame, each with as many bits as the section says.
    pub points: Table<u8>,
    /// One row per junction, in file order. The row number is the JunctionId.
    pub junctions: Table<JunctionRow>,
    /// junction/connection.
    pub connections: Table<ConnectionRow>,
    /// junction/connection/laneLink as written.
    pub connection_lane_links: Table<ConnectionLaneLinkRow>,
    /// Rows of `roads` in byte order of their ids.
    pub roads_by_id: Table<u32>,
    /// Rows of `junctions` in byte order of their ids.
    pub junctions_by_id: Table<u32>,
    /// First node of each level of the spatial index, root first, then the number of nodes. Empty if the map has no lanes.
    pub index_levels: Table<u32>,
    /// Packed R-tree: node i of a level has children 16·i … 16·i + 15 on the next one; below the last level lie the leaves. Boxes are relative to the local origin and rounded outwards; unused places are empty boxes.
    pub index_nodes: Table<IndexNodeRow>,
    /// Sixteen segments of lanes' centre lines each, their ends in steps from the leaf's corner. A lane's area between a segment's ends lies in a rectangle around the segment as it stands here: `reach` to both sides, `overshoot` beyond both ends; in height between `z_low` and `z_high`. All four are rounded outwards; 65535 in `reach`, `overshoot` or `z_high` stands for any distance. Unused places have lane u32::MAX.
    pub index_leaves: Table<IndexLeafRow>,
    /// Lateral profiles of the roads that have any besides superelevation, by road.
    pub surfaces: Table<SurfaceRow>,
    /// Stations of lateral shapes.
    pub shape_stations: Table<ShapeStationRow>,
    /// Strips of cross-section surfaces; coefficients count from the strip's inner edge, signed as t is.
    pub surface_strips: Table<SurfaceStripRow>,
    /// lane/height records, by lane and s: the lane's height above the road's surface, linear between its edges.
    pub lane_heights: Table<LaneHeightRow>,
    /// lane/material records, by lane and s.
    pub lane_materials: Table<LaneMaterialRow>,
    /// Elevation grids of junctions, by junction (OpenDRIVE 1.8.1, 12.8): inside, their heights replace those of the connecting roads.
    pub elevation_grids: Table<ElevationGridRow>,
    /// A row of an elevation grid: heights from its point on the reference line outwards.
    pub grid_rows: Table<GridRowRow>,
    /// Heights of elevation grids `[m]`.
    pub grid_heights: Table<f64>,
    /// Joints of junctions with an elevation grid, in the direction that has the junction on the left.
    pub grid_transitions: Table<GridTransitionRow>,
    /// lane/roadMark records, each sequence once. A record describes the mark on a lane's outer border, or on lane 0's own line for lane 0, up to the next record of the sequence.
    pub road_marks: Table<RoadMarkRow>,
    /// Styles of road marks, each once, in the order of their first use.
    pub road_mark_styles: Table<RoadMarkStyleRow>,
    /// Lines of road marks: of a pattern (roadMark/type/line), repeated every `length` + `space`, or explicit (roadMark/explicit/line), once.
    pub road_mark_lines: Table<RoadMarkLineRow>,
    /// Temporary lanes of roads (OpenDRIVE 1.9), by road. Their sections and lanes are rows like others, which no road's own sections, no node of the lane graph and no leaf of the index names.
    pub lane_layers: Table<LaneLayerRow>,
    /// Exactly one row: facts about the whole lane graph.
    pub graph: Table<GraphRow>,
    /// Nodes of the lane graph: a lane, or a piece of one, travelled in one direction. Lane by lane.
    pub lane_nodes: Table<LaneNodeRow>,
    /// First edge of each node in `successors`; one more entry than nodes.
    pub successor_offsets: Table<u32>,
    /// Nodes entered from each node, in order of road id, section, lane (compressed sparse rows).
    pub successors: Table<u32>,
    /// Facts about each entry of `successors`, and the element of the file that states it. Length, time and access are those of the node that the edge leaves.
    pub edges: Table<EdgeRow>,
    /// First entry of each node in `predecessors`; one more entry than nodes.
    pub predecessor_offsets: Table<u32>,
    /// Nodes from which each node is entered: the inverse of `successors`.
    pub predecessors: Table<u32>,
    /// Lanes of one junction whose areas meet, by `lane`; each pair is stored twice, once for each lane.
    pub conflicts: Table<ConflictRow>,
    /// Per place: distances from each landmark, then to each, in `length_step`, rounded down; 65535 if there is no way.
    pub landmark_lengths: Table<u16>,
    /// As `landmark_lengths`, in `time_step`.
    pub landmark_times: Table<u16>,
    /// One row per signal, in file order, signs on boards behind the signal that carries them. The row number is the SignalId.
    pub signals: Table<SignalRow>,
    /// Rows of `signals` in byte order of their ids.
    pub signals_by_id: Table<u32>,
    /// Places where signals apply: on their own road and on roads that refer to them, by road and s.
    pub signal_places: Table<SignalPlaceRow>,
    /// Lanes of the signals' places, by place; lanes from left to right.
    pub signal_lanes: Table<SignalLaneRow>,
    /// Rows of `signal_lanes` by lane, then by place.
    pub lane_signals: Table<u32>,
    /// signal/dependency, and those of boards.
    pub signal_dependencies: Table<SignalDependencyRow>,
    /// signal/reference, and those of boards.
    pub signal_links: Table<SignalLinkRow>,
    /// Rows of `signal_links` that name objects of the map, by object, then by row.
    pub object_signals: Table<u32>,
    /// Children of signal/semantics, and of the header's default regulations.
    pub signal_semantics: Table<SignalSemanticsRow>,
    /// signal/vmsBoard, by signal: variable message boards (OpenDRIVE 1.8).
    pub signal_boards: Table<SignalBoardRow>,
    /// vmsBoard/displayArea, by board: parts of variable message boards (OpenDRIVE 1.8).
    pub display_areas: Table<DisplayAreaRow>,
    /// vmsGroup/vmsBoardReference, by group: variable message boards that work together (OpenDRIVE 1.8).
    pub board_groups: Table<BoardGroupRow>,
    /// One row per controller, in file order: a signal group, whose signals switch together.
    pub controllers: Table<ControllerRow>,
    /// controller/control, by controller.
    pub controls: Table<ControlRow>,
    /// Controllers by signal: the inverse of `controls`.
    pub signal_controllers: Table<u32>,
    /// junction/controller, by junction: the controllers of a junction are its synchronisation group.
    pub junction_controllers: Table<JunctionControllerRow>,
    /// junction/priority, by junction.
    pub junction_priorities: Table<JunctionPriorityRow>,
    /// header/defaultRegulations: speeds by type of road (OpenDRIVE 1.8.1, 6.4).
    pub default_speeds: Table<DefaultSpeedRow>,
    /// First node of each level of the signals' index, root first, then the number of nodes. Empty if the map has no signals.
    pub signal_index_levels: Table<u32>,
    /// Packed R-tree over the positions of signals, with the layout of the objects' tree.
    pub signal_index_nodes: Table<BoxNodeRow>,
    /// Entries below the last level: each signal once.
    pub signal_index_items: Table<u32>,
    /// Parts of the document that have errors and are not in the map as written, in the order of the document.
    pub quarantined: Table<QuarantinedRow>,
    /// Objects by road, in file order; those of junctions after those of roads. The row number is the ObjectId.
    pub objects: Table<ObjectRow>,
    /// Outlines of objects, and of the areas that continuous repetitions sweep over.
    pub object_outlines: Table<ObjectOutlineRow>,
    /// Corners in the frame of the object or copy that they belong to: u ahead, v to the left, z upwards.
    pub object_points: Table<ObjectPointRow>,
    /// Places of repeated objects, object by object, in the order of the repetitions and of s.
    pub object_copies: Table<ObjectCopyRow>,
    /// validity elements: lane numbers from the lower to the higher one.
    pub lane_ranges: Table<LaneRangeRow>,
    /// Which lanes objects belong to, object by object, nearer lanes first.
    pub object_lanes: Table<ObjectLaneRow>,
    /// Rows of `object_lanes` by lane, then by their start: the objects of a lane.
    pub lane_objects: Table<u32>,
    /// Rows of `objects` in byte order of their ids.
    pub objects_by_id: Table<u32>,
    /// First node of each level of the objects' index, root first, then the number of nodes. Empty if the map has no objects.
    pub object_index_levels: Table<u32>,
    /// Packed R-tree: node i of a level has children 16·i … 16·i + 15 on the next one; below the last level lie `object_index_items`. Boxes contain the objects' areas in plan view, are relative to the local origin and rounded outwards; unused places are empty boxes.
    pub object_index_nodes: Table<BoxNodeRow>,
    /// Entries below the last level: a value below the number of objects is an object's row; any other value is that number plus the row of a copy. Each place of an object once.
    pub object_index_items: Table<u32>,
    /// Painted lines along objects, by object: along corners of an outline, or along a side.
    pub object_markings: Table<ObjectMarkingRow>,
    /// Corners that markings and borders name.
    pub object_corners: Table<u32>,
    /// Frames along outlines of objects, by object.
    pub object_borders: Table<ObjectBorderRow>,
    /// Lines that describe objects from inside, by object (OpenDRIVE 1.8.1, 13.8).
    pub object_skeletons: Table<ObjectSkeletonRow>,
    /// Vertices of skeletons in the object's frame.
    pub skeleton_vertices: Table<SkeletonVertexRow>,
    /// Objects that are parking spaces, by object.
    pub parking_spaces: Table<ParkingSpaceRow>,
    /// Materials of objects, by object.
    pub object_materials: Table<ObjectMaterialRow>,
    /// Objects of one road that concern another, by road, in file order.
    pub object_references: Table<ObjectReferenceRow>,
    /// Bridges and tunnels, by road, in file order.
    pub structures: Table<StructureRow>,
    /// Railway switches, by road, in file order.
    pub switches: Table<SwitchRow>,
    /// Stations in file order.
    pub stations: Table<StationRow>,
    /// Platforms of stations.
    pub platforms: Table<PlatformRow>,
    /// Stretches of track beside platforms.
    pub platform_segments: Table<PlatformSegmentRow>,
    /// Features that a reader must know to read this map: one row for each bit of the header's `must_understand`. A reader that does not know a feature can name it.
    pub features: Table<FeatureRow>,
    /// Parts in quarantine whose finding is in an included file, by part. The findings of all other parts are in the document itself.
    pub quarantined_files: Table<QuarantinedFileRow>,
    /// Objects and signals that are missing because the road or junction that they belong to is in quarantine, by that part.
    pub quarantined_contents: Table<QuarantinedContentRow>,
    /// Data of the file that has no table of its own: data of applications, quality of data, elements that the standard does not have, and attributes that are not used otherwise. A row is the difference of an annotation from the one before, and equal rows are stored once; `annotation_numbers` has their order.
    pub annotations: Table<AnnotationRow>,
    /// Files that the document includes, in that order.
    pub included_files: Table<IncludedFileRow>,
    /// lane/visibility records, by lane and s (OpenDRIVE 1.4, 1.5).
    pub lane_visibilities: Table<LaneVisibilityRow>,
    /// lane/rule records, by lane and s.
    pub lane_rules: Table<LaneRuleRow>,
    /// Groups of junctions in file order: roundabouts and interchanges.
    pub junction_groups: Table<JunctionGroupRow>,
    /// junctionGroup/junctionReference, by group.
    pub junction_group_members: Table<JunctionGroupMemberRow>,
    /// Lanes of the rings of roundabouts, by group: lanes from which a way within the group leads back to them.
    pub ring_lanes: Table<u32>,
    /// Values that objects mean, by object: the limit that the name of a sign states.
    pub object_values: Table<ObjectValueRow>,
    /// Speed signs in force where a lane's traffic enters it, by lane; a lane without such a sign has no row. A map with signals of lanes has at least one row, which may be empty.
    pub speed_signs_at_entry: Table<SpeedSignsAtEntryRow>,
    /// All annotations by owner (kind, then row), those of one owner in file order: rows of `annotations`, each in as many bits as the greatest row number there needs, without gaps, the lowest bit of the lowest byte first.
    pub annotation_numbers: Table<u8>,
    /// A row for each 256 annotations: the values that the first of them is relative to, so that the annotations of an owner are found without reading all.
    pub annotation_blocks: Table<AnnotationBlockRow>,
    /// A row for each 64 lanes: the sections and roads that their rows lead to, so that queries can read all of these rows ahead at once. It decides nothing. Where roads of neighbouring sections do not follow each other, as behind temporary layers, it is wrong.
    pub lane_blocks: Table<LaneBlockRow>,
    /// How long lanes of very many records are up to some of these, by lane and s: a length along one is a difference, and what lies before and behind. It decides nothing.
    pub lane_lengths: Table<LaneLengthRow>,
}

impl Rows {
    /// The rows as the tables that an archive of them would have, so that queries run while it is being built.
    pub fn as_tables(&self) -> Tables<'_> {
        Tables {
            string_bytes: (self.string_bytes.as_slice()),
            string_offsets: (self.string_offsets.as_slice()),
            map: bytemuck::cast_slice(self.map.as_slice()),
            file_frames: bytemuck::cast_slice(self.file_frames.as_slice()),
            roads: bytemuck::cast_slice(self.roads.as_slice()),
            geometries: bytemuck::cast_slice(self.geometries.as_slice()),
            coefficients: (self.coefficients.as_slice()),
            cubics: bytemuck::cast_slice(self.cubics.as_slice()),
            road_types: bytemuck::cast_slice(self.road_types.as_slice()),
            sections: bytemuck::cast_slice(self.sections.as_slice()),
            lanes: bytemuck::cast_slice(self.lanes.as_slice()),
            lane_speeds: bytemuck::cast_slice(self.lane_speeds.as_slice()),
            point_stations: (self.point_stations.as_slice()),
            points: (self.points.as_slice()),
            junctions: bytemuck::cast_slice(self.junctions.as_slice()),
            connections: bytemuck::cast_slice(self.connections.as_slice()),
            connection_lane_links: bytemuck::cast_slice(self.connection_lane_links.as_slice()),
            roads_by_id: (self.roads_by_id.as_slice()),
            junctions_by_id: (self.junctions_by_id.as_slice()),
            index_levels: (self.index_levels.as_slice()),
            index_nodes: bytemuck::cast_slice(self.index_nodes.as_slice()),
            index_leaves: bytemuck::cast_slice(self.index_leaves.as_slice()),
            surfaces: bytemuck::cast_slice(self.surfaces.as_slice()),
            shape_stations: bytemuck::cast_slice(self.shape_stations.as_slice()),
            surface_strips: bytemuck::cast_slice(self.surface_strips.as_slice()),
            lane_heights: bytemuck::cast_slice(self.lane_heights.as_slice()),
            lane_materials: bytemuck::cast_slice(self.lane_materials.as_slice()),
            elevation_grids: bytemuck::cast_slice(self.elevation_grids.as_slice()),
            grid_rows: bytemuck::cast_slice(self.grid_rows.as_slice()),
            grid_heights: (self.grid_heights.as_slice()),
            grid_transitions: bytemuck::cast_slice(self.grid_transitions.as_slice()),
            road_marks: bytemuck::cast_slice(self.road_marks.as_slice()),
            road_mark_styles: bytemuck::cast_slice(self.road_mark_styles.as_slice()),
            road_mark_lines: bytemuck::cast_slice(self.road_mark_lines.as_slice()),
            lane_layers: bytemuck::cast_slice(self.lane_layers.as_slice()),
            graph: bytemuck::cast_slice(self.graph.as_slice()),
            lane_nodes: bytemuck::cast_slice(self.lane_nodes.as_slice()),
            successor_offsets: (self.successor_offsets.as_slice()),
            successors: (self.successors.as_slice()),
            edges: bytemuck::cast_slice(self.edges.as_slice()),
            predecessor_offsets: (self.predecessor_offsets.as_slice()),
            predecessors: (self.predecessors.as_slice()),
            conflicts: bytemuck::cast_slice(self.conflicts.as_slice()),
            landmark_lengths: (self.landmark_lengths.as_slice()),
            landmark_times: (self.landmark_times.as_slice()),
            signals: bytemuck::cast_slice(self.signals.as_slice()),
            signals_by_id: (self.signals_by_id.as_slice()),
            signal_places: bytemuck::cast_slice(self.signal_places.as_slice()),
            signal_lanes: bytemuck::cast_slice(self.signal_lanes.as_slice()),
            lane_signals: (self.lane_signals.as_slice()),
            signal_dependencies: bytemuck::cast_slice(self.signal_dependencies.as_slice()),
            signal_links: bytemuck::cast_slice(self.signal_links.as_slice()),
            object_signals: (self.object_signals.as_slice()),
            signal_semantics: bytemuck::cast_slice(self.signal_semantics.as_slice()),
            signal_boards: bytemuck::cast_slice(self.signal_boards.as_slice()),
            display_areas: bytemuck::cast_slice(self.display_areas.as_slice()),
            board_groups: bytemuck::cast_slice(self.board_groups.as_slice()),
            controllers: bytemuck::cast_slice(self.controllers.as_slice()),
            controls: bytemuck::cast_slice(self.controls.as_slice()),
            signal_controllers: (self.signal_controllers.as_slice()),
            junction_controllers: bytemuck::cast_slice(self.junction_controllers.as_slice()),
            junction_priorities: bytemuck::cast_slice(self.junction_priorities.as_slice()),
            default_speeds: bytemuck::cast_slice(self.default_speeds.as_slice()),
            signal_index_levels: (self.signal_index_levels.as_slice()),
            signal_index_nodes: bytemuck::cast_slice(self.signal_index_nodes.as_slice()),
            signal_index_items: (self.signal_index_items.as_slice()),
            quarantined: bytemuck::cast_slice(self.quarantined.as_slice()),
            objects: bytemuck::cast_slice(self.objects.as_slice()),
            object_outlines: bytemuck::cast_slice(self.object_outlines.as_slice()),
            object_points: bytemuck::cast_slice(self.object_points.as_slice()),
            object_copies: bytemuck::cast_slice(self.object_copies.as_slice()),
            lane_ranges: bytemuck::cast_slice(self.lane_ranges.as_slice()),
            object_lanes: bytemuck::cast_slice(self.object_lanes.as_slice()),
            lane_objects: (self.lane_objects.as_slice()),
            objects_by_id: (self.objects_by_id.as_slice()),
            object_index_levels: (self.object_index_levels.as_slice()),
            object_index_nodes: bytemuck::cast_slice(self.object_index_nodes.as_slice()),
            object_index_items: (self.object_index_items.as_slice()),
            object_markings: bytemuck::cast_slice(self.object_markings.as_slice()),
            object_corners: (self.object_corners.as_slice()),
            object_borders: bytemuck::cast_slice(self.object_borders.as_slice()),
            object_skeletons: bytemuck::cast_slice(self.object_skeletons.as_slice()),
            skeleton_vertices: bytemuck::cast_slice(self.skeleton_vertices.as_slice()),
            parking_spaces: bytemuck::cast_slice(self.parking_spaces.as_slice()),
            object_materials: bytemuck::cast_slice(self.object_materials.as_slice()),
            object_references: bytemuck::cast_slice(self.object_references.as_slice()),
            structures: bytemuck::cast_slice(self.structures.as_slice()),
            switches: bytemuck::cast_slice(self.switches.as_slice()),
            stations: bytemuck::cast_slice(self.stations.as_slice()),
            platforms: bytemuck::cast_slice(self.platforms.as_slice()),
            platform_segments: bytemuck::cast_slice(self.platform_segments.as_slice()),
            features: bytemuck::cast_slice(self.features.as_slice()),
            quarantined_files: bytemuck::cast_slice(self.quarantined_files.as_slice()),
            quarantined_contents: bytemuck::cast_slice(self.quarantined_contents.as_slice()),
            annotations: bytemuck::cast_slice(self.annotations.as_slice()),
            included_files: bytemuck::cast_slice(self.included_files.as_slice()),
            lane_visibilities: bytemuck::cast_slice(self.lane_visibilities.as_slice()),
            lane_rules: bytemuck::cast_slice(self.lane_rules.as_slice()),
            junction_groups: bytemuck::cast_slice(self.junction_groups.as_slice()),
            junction_group_members: bytemuck::cast_slice(self.junction_group_members.as_slice()),
            ring_lanes: (self.ring_lanes.as_slice()),
            object_values: bytemuck::cast_slice(self.object_values.as_slice()),
            speed_signs_at_entry: bytemuck::cast_slice(self.speed_signs_at_entry.as_slice()),
            annotation_numbers: (self.annotation_numbers.as_slice()),
            annotation_blocks: bytemuck::cast_slice(self.annotation_blocks.as_slice()),
            lane_blocks: bytemuck::cast_slice(self.lane_blocks.as_slice()),
            lane_lengths: bytemuck::cast_slice(self.lane_lengths.as_slice()),
        }
    }

    /// The bytes of all tables, as they lie in an archive, in the order of `TABLES`.
    pub(crate) fn bytes(&self) -> [&[u8]; 107] {
        [
            bytemuck::cast_slice(self.string_bytes.as_slice()),
            bytemuck::cast_slice(self.string_offsets.as_slice()),
            bytemuck::cast_slice(self.map.as_slice()),
            bytemuck::cast_slice(self.file_frames.as_slice()),
            bytemuck::cast_slice(self.roads.as_slice()),
            bytemuck::cast_slice(self.geometries.as_slice()),
            bytemuck::cast_slice(self.coefficients.as_slice()),
            bytemuck::cast_slice(self.cubics.as_slice()),
            bytemuck::cast_slice(self.road_types.as_slice()),
            bytemuck::cast_slice(self.sections.as_slice()),
            bytemuck::cast_slice(self.lanes.as_slice()),
            bytemuck::cast_slice(self.lane_speeds.as_slice()),
            bytemuck::cast_slice(self.point_stations.as_slice()),
            bytemuck::cast_slice(self.points.as_slice()),
            bytemuck::cast_slice(self.junctions.as_slice()),
            bytemuck::cast_slice(self.connections.as_slice()),
            bytemuck::cast_slice(self.connection_lane_links.as_slice()),
            bytemuck::cast_slice(self.roads_by_id.as_slice()),
            bytemuck::cast_slice(self.junctions_by_id.as_slice()),
            bytemuck::cast_slice(self.index_levels.as_slice()),
            bytemuck::cast_slice(self.index_nodes.as_slice()),
            bytemuck::cast_slice(self.index_leaves.as_slice()),
            bytemuck::cast_slice(self.surfaces.as_slice()),
            bytemuck::cast_slice(self.shape_stations.as_slice()),
            bytemuck::cast_slice(self.surface_strips.as_slice()),
            bytemuck::cast_slice(self.lane_heights.as_slice()),
            bytemuck::cast_slice(self.lane_materials.as_slice()),
            bytemuck::cast_slice(self.elevation_grids.as_slice()),
            bytemuck::cast_slice(self.grid_rows.as_slice()),
            bytemuck::cast_slice(self.grid_heights.as_slice()),
            bytemuck::cast_slice(self.grid_transitions.as_slice()),
            bytemuck::cast_slice(self.road_marks.as_slice()),
            bytemuck::cast_slice(self.road_mark_styles.as_slice()),
            bytemuck::cast_slice(self.road_mark_lines.as_slice()),
            bytemuck::cast_slice(self.lane_layers.as_slice()),
            bytemuck::cast_slice(self.graph.as_slice()),
            bytemuck::cast_slice(self.lane_nodes.as_slice()),
            bytemuck::cast_slice(self.successor_offsets.as_slice()),
            bytemuck::cast_slice(self.successors.as_slice()),
            bytemuck::cast_slice(self.edges.as_slice()),
            bytemuck::cast_slice(self.predecessor_offsets.as_slice()),
            bytemuck::cast_slice(self.predecessors.as_slice()),
            bytemuck::cast_slice(self.conflicts.as_slice()),
            bytemuck::cast_slice(self.landmark_lengths.as_slice()),
            bytemuck::cast_slice(self.landmark_times.as_slice()),
            bytemuck::cast_slice(self.signals.as_slice()),
            bytemuck::cast_slice(self.signals_by_id.as_slice()),
            bytemuck::cast_slice(self.signal_places.as_slice()),
            bytemuck::cast_slice(self.signal_lanes.as_slice()),
            bytemuck::cast_slice(self.lane_signals.as_slice()),
            bytemuck::cast_slice(self.signal_dependencies.as_slice()),
            bytemuck::cast_slice(self.signal_links.as_slice()),
            bytemuck::cast_slice(self.object_signals.as_slice()),
            bytemuck::cast_slice(self.signal_semantics.as_slice()),
            bytemuck::cast_slice(self.signal_boards.as_slice()),
            bytemuck::cast_slice(self.display_areas.as_slice()),
            bytemuck::cast_slice(self.board_groups.as_slice()),
            bytemuck::cast_slice(self.controllers.as_slice()),
            bytemuck::cast_slice(self.controls.as_slice()),
            bytemuck::cast_slice(self.signal_controllers.as_slice()),
            bytemuck::cast_slice(self.junction_controllers.as_slice()),
            bytemuck::cast_slice(self.junction_priorities.as_slice()),
            bytemuck::cast_slice(self.default_speeds.as_slice()),
            bytemuck::cast_slice(self.signal_index_levels.as_slice()),
            bytemuck::cast_slice(self.signal_index_nodes.as_slice()),
            bytemuck::cast_slice(self.signal_index_items.as_slice()),
            bytemuck::cast_slice(self.quarantined.as_slice()),
            bytemuck::cast_slice(self.objects.as_slice()),
            bytemuck::cast_slice(self.object_outlines.as_slice()),
            bytemuck::cast_slice(self.object_points.as_slice()),
            bytemuck::cast_slice(self.object_copies.as_slice()),
            bytemuck::cast_slice(self.lane_ranges.as_slice()),
            bytemuck::cast_slice(self.object_lanes.as_slice()),
            bytemuck::cast_slice(self.lane_objects.as_slice()),
            bytemuck::cast_slice(self.objects_by_id.as_slice()),
            bytemuck::cast_slice(self.object_index_levels.as_slice()),
            bytemuck::cast_slice(self.object_index_nodes.as_slice()),
            bytemuck::cast_slice(self.object_index_items.as_slice()),
            bytemuck::cast_slice(self.object_markings.as_slice()),
            bytemuck::cast_slice(self.object_corners.as_slice()),
            bytemuck::cast_slice(self.object_borders.as_slice()),
            bytemuck::cast_slice(self.object_skeletons.as_slice()),
            bytemuck::cast_slice(self.skeleton_vertices.as_slice()),
            bytemuck::cast_slice(self.parking_spaces.as_slice()),
            bytemuck::cast_slice(self.object_materials.as_slice()),
            bytemuck::cast_slice(self.object_references.as_slice()),
            bytemuck::cast_slice(self.structures.as_slice()),
            bytemuck::cast_slice(self.switches.as_slice()),
            bytemuck::cast_slice(self.stations.as_slice()),
            bytemuck::cast_slice(self.platforms.as_slice()),
            bytemuck::cast_slice(self.platform_segments.as_slice()),
            bytemuck::cast_slice(self.features.as_slice()),
            bytemuck::cast_slice(self.quarantined_files.as_slice()),
            bytemuck::cast_slice(self.quarantined_contents.as_slice()),
            bytemuck::cast_slice(self.annotations.as_slice()),
            bytemuck::cast_slice(self.included_files.as_slice()),
            bytemuck::cast_slice(self.lane_visibilities.as_slice()),
            bytemuck::cast_slice(self.lane_rules.as_slice()),
            bytemuck::cast_slice(self.junction_groups.as_slice()),
            bytemuck::cast_slice(self.junction_group_members.as_slice()),
            bytemuck::cast_slice(self.ring_lanes.as_slice()),
            bytemuck::cast_slice(self.object_values.as_slice()),
            bytemuck::cast_slice(self.speed_signs_at_entry.as_slice()),
            bytemuck::cast_slice(self.annotation_numbers.as_slice()),
            bytemuck::cast_slice(self.annotation_blocks.as_slice()),
            bytemuck::cast_slice(self.lane_blocks.as_slice()),
            bytemuck::cast_slice(self.lane_lengths.as_slice()),
        ]
    }
}
