//! The archive's tables in the order in which they lie.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::beside_rows::*;
use super::index_rows::*;
use super::network_rows::*;
use super::object_rows::*;
use super::signal_rows::*;
use crate::error::OpenError;
use crate::table::{Table, TableInfo};
use rkyv::{Archive, Serialize, rend};

/// Number of the format, raised by hand when old archives can no longer be read.
pub const FORMAT: u32 = 1;
/// Identifies the layout: tables, fields, types, references and rkyv's format flags.
pub const LAYOUT_ID: [u8; 16] =
    [42, 229, 217, 4, 129, 131, 151, 228, 69, 117, 52, 35, 121, 171, 111, 84];

/// All tables of a map as the compiler fills them: the archive's root.
#[derive(Archive, Serialize, Default)]
pub struct Rows {
    /// UTF-8 text of all strings, one after the other, each once. String 0 is empty.
    pub string_bytes: Table<u8>,
    /// Start of each string in `string_bytes`; one more entry than strings.
    pub string_offsets: Table<u32>,
    /// Exactly one row: what concerns the whole map.
    pub map: Table<MapRow>,
    /// One row for a map that was compiled into another frame than its file's (`--crs`), else none. `projection` of the map is then the target, its offset 0.
    pub file_frames: Table<FileFrameRow>,
    /// One row per road, in file order. The row number is the RoadId.
    pub roads: Table<RoadRow>,
    /// Plan-view geometries as written or, in a target frame, moved into it, with what their evaluation needs (OpenDRIVE 1.8.1, 9.2).
    pub geometries: Table<GeometryRow>,
    /// Numbers of the geometries. Line: none. Arc: curvature. Spiral: start and end curvature, then pieces of 20 (x and y as polynomials of degree 9 over −1 to 1). poly3: 4, paramPoly3: 8, then pieces of 10 (the curve parameter as a polynomial of true arc length). Transformed: pieces of 21 (heading of the middle relative to the start, then x and y as polynomials of degree 9).
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
    /// s of points minus their section's start `[m]`: those of a section ascend, each once, and all its lines share them; equal sequences are there once.
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
    /// lane/height records, by lane and s: what the lane lies above the road's surface, linear between its edges.
    pub lane_heights: Table<LaneHeightRow>,
    /// lane/material records, by lane and s.
    pub lane_materials: Table<LaneMaterialRow>,
    /// Elevation grids of junctions, by junction (OpenDRIVE 1.8.1, 12.8): inside, their heights replace those of the connecting roads.
    pub elevation_grids: Table<ElevationGridRow>,
    /// A row of an elevation grid: heights from its point on the reference line outwards.
    pub grid_rows: Table<GridRowRow>,
    /// Heights of elevation grids `[m]`.
    pub grid_heights: Table<f64>,
    /// Joints of junctions with an elevation grid, seen so that the junction lies to the left.
    pub grid_transitions: Table<GridTransitionRow>,
    /// lane/roadMark records, each sequence of them once: what lies on a lane's outer border, on lane 0's own line for lane 0, until the next record of the sequence.
    pub road_marks: Table<RoadMarkRow>,
    /// How road marks look, each once, in the order of their first use.
    pub road_mark_styles: Table<RoadMarkStyleRow>,
    /// Lines of road marks: of a pattern (roadMark/type/line), repeated every `length` + `space`, or explicit (roadMark/explicit/line), once.
    pub road_mark_lines: Table<RoadMarkLineRow>,
    /// Temporary lanes of roads (OpenDRIVE 1.9), by road. Their sections and lanes are rows like others, which no road's own sections, no node of the lane graph and no leaf of the index names.
    pub lane_layers: Table<LaneLayerRow>,
    /// Exactly one row: what concerns the whole lane graph.
    pub graph: Table<GraphRow>,
    /// Nodes of the lane graph: a lane, or a piece of one, travelled in one direction. Lane by lane.
    pub lane_nodes: Table<LaneNodeRow>,
    /// First edge of each node in `successors`; one more entry than nodes.
    pub successor_offsets: Table<u32>,
    /// Nodes entered from each node, in order of road id, section, lane (compressed sparse rows).
    pub successors: Table<u32>,
    /// What is known of each entry of `successors`: where the file says so. Length, time and access are those of the node that is left.
    pub edges: Table<EdgeRow>,
    /// First entry of each node in `predecessors`; one more entry than nodes.
    pub predecessor_offsets: Table<u32>,
    /// Nodes from which each node is entered: `successors` turned round.
    pub predecessors: Table<u32>,
    /// Lanes of one junction whose areas meet, by `lane`; each pair stands twice, once from either side.
    pub conflicts: Table<ConflictRow>,
    /// Per place: distances from each landmark, then to each, in `length_step`, rounded down; 65535 where there is no way.
    pub landmark_lengths: Table<u16>,
    /// As `landmark_lengths`, in `time_step`.
    pub landmark_times: Table<u16>,
    /// One row per signal, in file order, signs on boards behind the signal that carries them. The row number is the SignalId.
    pub signals: Table<SignalRow>,
    /// Rows of `signals` in byte order of their ids.
    pub signals_by_id: Table<u32>,
    /// Where signals count: on their own road and on those that refer to them, by road and s.
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
    /// Controllers by signal: `controls` turned round.
    pub signal_controllers: Table<u32>,
    /// junction/controller, by junction: the controllers of a junction are its synchronisation group.
    pub junction_controllers: Table<JunctionControllerRow>,
    /// junction/priority, by junction.
    pub junction_priorities: Table<JunctionPriorityRow>,
    /// header/defaultRegulations: speeds by type of road (OpenDRIVE 1.8.1, 6.4).
    pub default_speeds: Table<DefaultSpeedRow>,
    /// First node of each level of the signals' index, root first, then the number of nodes. Empty if the map has no signals.
    pub signal_index_levels: Table<u32>,
    /// Packed R-tree over the places where signals stand, as that of objects.
    pub signal_index_nodes: Table<BoxNodeRow>,
    /// What lies below the last level: each signal once.
    pub signal_index_items: Table<u32>,
    /// Parts of the document that have errors and are not in the map as written, in the order of the document.
    pub quarantined: Table<QuarantinedRow>,
    /// Parts in quarantine whose finding stands in an included file, by part; of the others it stands in the document itself.
    pub quarantined_files: Table<QuarantinedFileRow>,
    /// Objects and signals that are missing because the road or junction that they belong to is in quarantine, by that part.
    pub quarantined_contents: Table<QuarantinedContentRow>,
    /// Objects by road, in file order; those of junctions after those of roads. The row number is the ObjectId.
    pub objects: Table<ObjectRow>,
    /// Outlines of objects, and of what a continuous repetition sweeps over.
    pub object_outlines: Table<ObjectOutlineRow>,
    /// Corners in the frame of the object or copy that they belong to: u ahead, v to the left, z upwards.
    pub object_points: Table<ObjectPointRow>,
    /// Places of repeated objects, object by object, in the order of the repetitions and of s.
    pub object_copies: Table<ObjectCopyRow>,
    /// validity elements: lane numbers from the lower to the higher one.
    pub lane_ranges: Table<LaneRangeRow>,
    /// Which lanes objects belong to, object by object, nearer lanes first.
    pub object_lanes: Table<ObjectLaneRow>,
    /// Rows of `object_lanes` by lane, then by where they begin: what belongs to a lane.
    pub lane_objects: Table<u32>,
    /// Rows of `objects` in byte order of their ids.
    pub objects_by_id: Table<u32>,
    /// First node of each level of the objects' index, root first, then the number of nodes. Empty if the map has no objects.
    pub object_index_levels: Table<u32>,
    /// Packed R-tree: node i of a level has children 16·i … 16·i + 15 on the next one; below the last level lie `object_index_items`. Boxes hold what objects cover in plan view, are relative to the local origin and rounded outwards; unused places are empty boxes.
    pub object_index_nodes: Table<BoxNodeRow>,
    /// What lies below the last level: below the number of objects an object's row, above it that number plus the row of a copy. Each place of an object once.
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
    /// What objects are made of, by object.
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
            quarantined_files: bytemuck::cast_slice(self.quarantined_files.as_slice()),
            quarantined_contents: bytemuck::cast_slice(self.quarantined_contents.as_slice()),
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
        }
    }
}

/// All tables of an opened archive. Lengths and places were read once and checked; they stay what they are
/// whatever happens to the bytes later.
#[derive(Clone, Copy)]
pub struct Tables<'a> {
    /// UTF-8 text of all strings, one after the other, each once. String 0 is empty.
    pub string_bytes: &'a [u8],
    /// Start of each string in `string_bytes`; one more entry than strings.
    pub string_offsets: &'a [u32],
    /// Exactly one row: what concerns the whole map.
    pub map: &'a [ArchivedMapRow],
    /// One row for a map that was compiled into another frame than its file's (`--crs`), else none. `projection` of the map is then the target, its offset 0.
    pub file_frames: &'a [ArchivedFileFrameRow],
    /// One row per road, in file order. The row number is the RoadId.
    pub roads: &'a [ArchivedRoadRow],
    /// Plan-view geometries as written or, in a target frame, moved into it, with what their evaluation needs (OpenDRIVE 1.8.1, 9.2).
    pub geometries: &'a [ArchivedGeometryRow],
    /// Numbers of the geometries. Line: none. Arc: curvature. Spiral: start and end curvature, then pieces of 20 (x and y as polynomials of degree 9 over −1 to 1). poly3: 4, paramPoly3: 8, then pieces of 10 (the curve parameter as a polynomial of true arc length). Transformed: pieces of 21 (heading of the middle relative to the start, then x and y as polynomials of degree 9).
    pub coefficients: &'a [f64],
    /// Cubic records a + b·ds + c·ds² + d·ds³ with ds = s − `s`; each holds until the next of its range.
    pub cubics: &'a [ArchivedCubicRow],
    /// road/type records.
    pub road_types: &'a [ArchivedRoadTypeRow],
    /// Lane sections, road by road, ascending in s, with the frame of their lanes' points (`points`).
    pub sections: &'a [ArchivedSectionRow],
    /// Lanes, section by section, from left to right. The row number is the LaneId. Lane 0 has no width; its border is the shifted reference line.
    pub lanes: &'a [ArchivedLaneRow],
    /// lane/speed records, by lane and s.
    pub lane_speeds: &'a [ArchivedLaneSpeedRow],
    /// s of points minus their section's start `[m]`: those of a section ascend, each once, and all its lines share them; equal sequences are there once.
    pub point_stations: &'a [f32],
    /// Points of polylines, `point_bytes` each, the lowest first, lane by lane. From the lowest bit on: number of the point's station among the section's, then x, y and z in steps from the section's frame, each with as many bits as the section says.
    pub points: &'a [u8],
    /// One row per junction, in file order. The row number is the JunctionId.
    pub junctions: &'a [ArchivedJunctionRow],
    /// junction/connection.
    pub connections: &'a [ArchivedConnectionRow],
    /// junction/connection/laneLink as written.
    pub connection_lane_links: &'a [ArchivedConnectionLaneLinkRow],
    /// Rows of `roads` in byte order of their ids.
    pub roads_by_id: &'a [u32],
    /// Rows of `junctions` in byte order of their ids.
    pub junctions_by_id: &'a [u32],
    /// First node of each level of the spatial index, root first, then the number of nodes. Empty if the map has no lanes.
    pub index_levels: &'a [u32],
    /// Packed R-tree: node i of a level has children 16·i … 16·i + 15 on the next one; below the last level lie the leaves. Boxes are relative to the local origin and rounded outwards; unused places are empty boxes.
    pub index_nodes: &'a [ArchivedIndexNodeRow],
    /// Sixteen segments of lanes' centre lines each, their ends in steps from the leaf's corner. A lane's area between a segment's ends lies in a rectangle around the segment as it stands here: `reach` to both sides, `overshoot` beyond both ends; in height between `z_low` and `z_high`. All four are rounded outwards; 65535 in `reach`, `overshoot` or `z_high` stands for any distance. Unused places have lane u32::MAX.
    pub index_leaves: &'a [ArchivedIndexLeafRow],
    /// Lateral profiles of the roads that have any besides superelevation, by road.
    pub surfaces: &'a [ArchivedSurfaceRow],
    /// Stations of lateral shapes.
    pub shape_stations: &'a [ArchivedShapeStationRow],
    /// Strips of cross-section surfaces; coefficients count from the strip's inner edge, signed as t is.
    pub surface_strips: &'a [ArchivedSurfaceStripRow],
    /// lane/height records, by lane and s: what the lane lies above the road's surface, linear between its edges.
    pub lane_heights: &'a [ArchivedLaneHeightRow],
    /// lane/material records, by lane and s.
    pub lane_materials: &'a [ArchivedLaneMaterialRow],
    /// Elevation grids of junctions, by junction (OpenDRIVE 1.8.1, 12.8): inside, their heights replace those of the connecting roads.
    pub elevation_grids: &'a [ArchivedElevationGridRow],
    /// A row of an elevation grid: heights from its point on the reference line outwards.
    pub grid_rows: &'a [ArchivedGridRowRow],
    /// Heights of elevation grids `[m]`.
    pub grid_heights: &'a [f64],
    /// Joints of junctions with an elevation grid, seen so that the junction lies to the left.
    pub grid_transitions: &'a [ArchivedGridTransitionRow],
    /// lane/roadMark records, each sequence of them once: what lies on a lane's outer border, on lane 0's own line for lane 0, until the next record of the sequence.
    pub road_marks: &'a [ArchivedRoadMarkRow],
    /// How road marks look, each once, in the order of their first use.
    pub road_mark_styles: &'a [ArchivedRoadMarkStyleRow],
    /// Lines of road marks: of a pattern (roadMark/type/line), repeated every `length` + `space`, or explicit (roadMark/explicit/line), once.
    pub road_mark_lines: &'a [ArchivedRoadMarkLineRow],
    /// Temporary lanes of roads (OpenDRIVE 1.9), by road. Their sections and lanes are rows like others, which no road's own sections, no node of the lane graph and no leaf of the index names.
    pub lane_layers: &'a [ArchivedLaneLayerRow],
    /// Exactly one row: what concerns the whole lane graph.
    pub graph: &'a [ArchivedGraphRow],
    /// Nodes of the lane graph: a lane, or a piece of one, travelled in one direction. Lane by lane.
    pub lane_nodes: &'a [ArchivedLaneNodeRow],
    /// First edge of each node in `successors`; one more entry than nodes.
    pub successor_offsets: &'a [u32],
    /// Nodes entered from each node, in order of road id, section, lane (compressed sparse rows).
    pub successors: &'a [u32],
    /// What is known of each entry of `successors`: where the file says so. Length, time and access are those of the node that is left.
    pub edges: &'a [ArchivedEdgeRow],
    /// First entry of each node in `predecessors`; one more entry than nodes.
    pub predecessor_offsets: &'a [u32],
    /// Nodes from which each node is entered: `successors` turned round.
    pub predecessors: &'a [u32],
    /// Lanes of one junction whose areas meet, by `lane`; each pair stands twice, once from either side.
    pub conflicts: &'a [ArchivedConflictRow],
    /// Per place: distances from each landmark, then to each, in `length_step`, rounded down; 65535 where there is no way.
    pub landmark_lengths: &'a [u16],
    /// As `landmark_lengths`, in `time_step`.
    pub landmark_times: &'a [u16],
    /// One row per signal, in file order, signs on boards behind the signal that carries them. The row number is the SignalId.
    pub signals: &'a [ArchivedSignalRow],
    /// Rows of `signals` in byte order of their ids.
    pub signals_by_id: &'a [u32],
    /// Where signals count: on their own road and on those that refer to them, by road and s.
    pub signal_places: &'a [ArchivedSignalPlaceRow],
    /// Lanes of the signals' places, by place; lanes from left to right.
    pub signal_lanes: &'a [ArchivedSignalLaneRow],
    /// Rows of `signal_lanes` by lane, then by place.
    pub lane_signals: &'a [u32],
    /// signal/dependency, and those of boards.
    pub signal_dependencies: &'a [ArchivedSignalDependencyRow],
    /// signal/reference, and those of boards.
    pub signal_links: &'a [ArchivedSignalLinkRow],
    /// Rows of `signal_links` that name objects of the map, by object, then by row.
    pub object_signals: &'a [u32],
    /// Children of signal/semantics, and of the header's default regulations.
    pub signal_semantics: &'a [ArchivedSignalSemanticsRow],
    /// signal/vmsBoard, by signal: variable message boards (OpenDRIVE 1.8).
    pub signal_boards: &'a [ArchivedSignalBoardRow],
    /// vmsBoard/displayArea, by board: parts of variable message boards (OpenDRIVE 1.8).
    pub display_areas: &'a [ArchivedDisplayAreaRow],
    /// vmsGroup/vmsBoardReference, by group: variable message boards that work together (OpenDRIVE 1.8).
    pub board_groups: &'a [ArchivedBoardGroupRow],
    /// One row per controller, in file order: a signal group, whose signals switch together.
    pub controllers: &'a [ArchivedControllerRow],
    /// controller/control, by controller.
    pub controls: &'a [ArchivedControlRow],
    /// Controllers by signal: `controls` turned round.
    pub signal_controllers: &'a [u32],
    /// junction/controller, by junction: the controllers of a junction are its synchronisation group.
    pub junction_controllers: &'a [ArchivedJunctionControllerRow],
    /// junction/priority, by junction.
    pub junction_priorities: &'a [ArchivedJunctionPriorityRow],
    /// header/defaultRegulations: speeds by type of road (OpenDRIVE 1.8.1, 6.4).
    pub default_speeds: &'a [ArchivedDefaultSpeedRow],
    /// First node of each level of the signals' index, root first, then the number of nodes. Empty if the map has no signals.
    pub signal_index_levels: &'a [u32],
    /// Packed R-tree over the places where signals stand, as that of objects.
    pub signal_index_nodes: &'a [ArchivedBoxNodeRow],
    /// What lies below the last level: each signal once.
    pub signal_index_items: &'a [u32],
    /// Parts of the document that have errors and are not in the map as written, in the order of the document.
    pub quarantined: &'a [ArchivedQuarantinedRow],
    /// Parts in quarantine whose finding stands in an included file, by part; of the others it stands in the document itself.
    pub quarantined_files: &'a [ArchivedQuarantinedFileRow],
    /// Objects and signals that are missing because the road or junction that they belong to is in quarantine, by that part.
    pub quarantined_contents: &'a [ArchivedQuarantinedContentRow],
    /// Objects by road, in file order; those of junctions after those of roads. The row number is the ObjectId.
    pub objects: &'a [ArchivedObjectRow],
    /// Outlines of objects, and of what a continuous repetition sweeps over.
    pub object_outlines: &'a [ArchivedObjectOutlineRow],
    /// Corners in the frame of the object or copy that they belong to: u ahead, v to the left, z upwards.
    pub object_points: &'a [ArchivedObjectPointRow],
    /// Places of repeated objects, object by object, in the order of the repetitions and of s.
    pub object_copies: &'a [ArchivedObjectCopyRow],
    /// validity elements: lane numbers from the lower to the higher one.
    pub lane_ranges: &'a [ArchivedLaneRangeRow],
    /// Which lanes objects belong to, object by object, nearer lanes first.
    pub object_lanes: &'a [ArchivedObjectLaneRow],
    /// Rows of `object_lanes` by lane, then by where they begin: what belongs to a lane.
    pub lane_objects: &'a [u32],
    /// Rows of `objects` in byte order of their ids.
    pub objects_by_id: &'a [u32],
    /// First node of each level of the objects' index, root first, then the number of nodes. Empty if the map has no objects.
    pub object_index_levels: &'a [u32],
    /// Packed R-tree: node i of a level has children 16·i … 16·i + 15 on the next one; below the last level lie `object_index_items`. Boxes hold what objects cover in plan view, are relative to the local origin and rounded outwards; unused places are empty boxes.
    pub object_index_nodes: &'a [ArchivedBoxNodeRow],
    /// What lies below the last level: below the number of objects an object's row, above it that number plus the row of a copy. Each place of an object once.
    pub object_index_items: &'a [u32],
    /// Painted lines along objects, by object: along corners of an outline, or along a side.
    pub object_markings: &'a [ArchivedObjectMarkingRow],
    /// Corners that markings and borders name.
    pub object_corners: &'a [u32],
    /// Frames along outlines of objects, by object.
    pub object_borders: &'a [ArchivedObjectBorderRow],
    /// Lines that describe objects from inside, by object (OpenDRIVE 1.8.1, 13.8).
    pub object_skeletons: &'a [ArchivedObjectSkeletonRow],
    /// Vertices of skeletons in the object's frame.
    pub skeleton_vertices: &'a [ArchivedSkeletonVertexRow],
    /// Objects that are parking spaces, by object.
    pub parking_spaces: &'a [ArchivedParkingSpaceRow],
    /// What objects are made of, by object.
    pub object_materials: &'a [ArchivedObjectMaterialRow],
    /// Objects of one road that concern another, by road, in file order.
    pub object_references: &'a [ArchivedObjectReferenceRow],
    /// Bridges and tunnels, by road, in file order.
    pub structures: &'a [ArchivedStructureRow],
    /// Railway switches, by road, in file order.
    pub switches: &'a [ArchivedSwitchRow],
    /// Stations in file order.
    pub stations: &'a [ArchivedStationRow],
    /// Platforms of stations.
    pub platforms: &'a [ArchivedPlatformRow],
    /// Stretches of track beside platforms.
    pub platform_segments: &'a [ArchivedPlatformSegmentRow],
}

impl<'a> Tables<'a> {
    /// Reads place and length of every table once and checks them against the body.
    pub(crate) fn new(root: &ArchivedRows, body: &'a [u8]) -> Result<Self, OpenError> {
        Ok(Self {
            string_bytes: root.string_bytes.view(body, "string_bytes")?,
            string_offsets: root.string_offsets.view_numbers(body, "string_offsets")?,
            map: root.map.view(body, "map")?,
            file_frames: root.file_frames.view(body, "file_frames")?,
            roads: root.roads.view(body, "roads")?,
            geometries: root.geometries.view(body, "geometries")?,
            coefficients: root.coefficients.view_numbers(body, "coefficients")?,
            cubics: root.cubics.view(body, "cubics")?,
            road_types: root.road_types.view(body, "road_types")?,
            sections: root.sections.view(body, "sections")?,
            lanes: root.lanes.view(body, "lanes")?,
            lane_speeds: root.lane_speeds.view(body, "lane_speeds")?,
            point_stations: root.point_stations.view_numbers(body, "point_stations")?,
            points: root.points.view(body, "points")?,
            junctions: root.junctions.view(body, "junctions")?,
            connections: root.connections.view(body, "connections")?,
            connection_lane_links: root
                .connection_lane_links
                .view(body, "connection_lane_links")?,
            roads_by_id: root.roads_by_id.view_numbers(body, "roads_by_id")?,
            junctions_by_id: root.junctions_by_id.view_numbers(body, "junctions_by_id")?,
            index_levels: root.index_levels.view_numbers(body, "index_levels")?,
            index_nodes: root.index_nodes.view(body, "index_nodes")?,
            index_leaves: root.index_leaves.view(body, "index_leaves")?,
            surfaces: root.surfaces.view(body, "surfaces")?,
            shape_stations: root.shape_stations.view(body, "shape_stations")?,
            surface_strips: root.surface_strips.view(body, "surface_strips")?,
            lane_heights: root.lane_heights.view(body, "lane_heights")?,
            lane_materials: root.lane_materials.view(body, "lane_materials")?,
            elevation_grids: root.elevation_grids.view(body, "elevation_grids")?,
            grid_rows: root.grid_rows.view(body, "grid_rows")?,
            grid_heights: root.grid_heights.view_numbers(body, "grid_heights")?,
            grid_transitions: root.grid_transitions.view(body, "grid_transitions")?,
            road_marks: root.road_marks.view(body, "road_marks")?,
            road_mark_styles: root.road_mark_styles.view(body, "road_mark_styles")?,
            road_mark_lines: root.road_mark_lines.view(body, "road_mark_lines")?,
            lane_layers: root.lane_layers.view(body, "lane_layers")?,
            graph: root.graph.view(body, "graph")?,
            lane_nodes: root.lane_nodes.view(body, "lane_nodes")?,
            successor_offsets: root.successor_offsets.view_numbers(body, "successor_offsets")?,
            successors: root.successors.view_numbers(body, "successors")?,
            edges: root.edges.view(body, "edges")?,
            predecessor_offsets: root
                .predecessor_offsets
                .view_numbers(body, "predecessor_offsets")?,
            predecessors: root.predecessors.view_numbers(body, "predecessors")?,
            conflicts: root.conflicts.view(body, "conflicts")?,
            landmark_lengths: root.landmark_lengths.view_numbers(body, "landmark_lengths")?,
            landmark_times: root.landmark_times.view_numbers(body, "landmark_times")?,
            signals: root.signals.view(body, "signals")?,
            signals_by_id: root.signals_by_id.view_numbers(body, "signals_by_id")?,
            signal_places: root.signal_places.view(body, "signal_places")?,
            signal_lanes: root.signal_lanes.view(body, "signal_lanes")?,
            lane_signals: root.lane_signals.view_numbers(body, "lane_signals")?,
            signal_dependencies: root.signal_dependencies.view(body, "signal_dependencies")?,
            signal_links: root.signal_links.view(body, "signal_links")?,
            object_signals: root.object_signals.view_numbers(body, "object_signals")?,
            signal_semantics: root.signal_semantics.view(body, "signal_semantics")?,
            signal_boards: root.signal_boards.view(body, "signal_boards")?,
            display_areas: root.display_areas.view(body, "display_areas")?,
            board_groups: root.board_groups.view(body, "board_groups")?,
            controllers: root.controllers.view(body, "controllers")?,
            controls: root.controls.view(body, "controls")?,
            signal_controllers: root.signal_controllers.view_numbers(body, "signal_controllers")?,
            junction_controllers: root.junction_controllers.view(body, "junction_controllers")?,
            junction_priorities: root.junction_priorities.view(body, "junction_priorities")?,
            default_speeds: root.default_speeds.view(body, "default_speeds")?,
            signal_index_levels: root
                .signal_index_levels
                .view_numbers(body, "signal_index_levels")?,
            signal_index_nodes: root.signal_index_nodes.view(body, "signal_index_nodes")?,
            signal_index_items: root.signal_index_items.view_numbers(body, "signal_index_items")?,
            quarantined: root.quarantined.view(body, "quarantined")?,
            quarantined_files: root.quarantined_files.view(body, "quarantined_files")?,
            quarantined_contents: root.quarantined_contents.view(body, "quarantined_contents")?,
            objects: root.objects.view(body, "objects")?,
            object_outlines: root.object_outlines.view(body, "object_outlines")?,
            object_points: root.object_points.view(body, "object_points")?,
            object_copies: root.object_copies.view(body, "object_copies")?,
            lane_ranges: root.lane_ranges.view(body, "lane_ranges")?,
            object_lanes: root.object_lanes.view(body, "object_lanes")?,
            lane_objects: root.lane_objects.view_numbers(body, "lane_objects")?,
            objects_by_id: root.objects_by_id.view_numbers(body, "objects_by_id")?,
            object_index_levels: root
                .object_index_levels
                .view_numbers(body, "object_index_levels")?,
            object_index_nodes: root.object_index_nodes.view(body, "object_index_nodes")?,
            object_index_items: root.object_index_items.view_numbers(body, "object_index_items")?,
            object_markings: root.object_markings.view(body, "object_markings")?,
            object_corners: root.object_corners.view_numbers(body, "object_corners")?,
            object_borders: root.object_borders.view(body, "object_borders")?,
            object_skeletons: root.object_skeletons.view(body, "object_skeletons")?,
            skeleton_vertices: root.skeleton_vertices.view(body, "skeleton_vertices")?,
            parking_spaces: root.parking_spaces.view(body, "parking_spaces")?,
            object_materials: root.object_materials.view(body, "object_materials")?,
            object_references: root.object_references.view(body, "object_references")?,
            structures: root.structures.view(body, "structures")?,
            switches: root.switches.view(body, "switches")?,
            stations: root.stations.view(body, "stations")?,
            platforms: root.platforms.view(body, "platforms")?,
            platform_segments: root.platform_segments.view(body, "platform_segments")?,
        })
    }

    /// Name, element size and length of every table, in the order in which they lie.
    pub fn infos(&self) -> [TableInfo; 93] {
        [
            TableInfo::of("string_bytes", self.string_bytes),
            TableInfo::of("string_offsets", self.string_offsets),
            TableInfo::of("map", self.map),
            TableInfo::of("file_frames", self.file_frames),
            TableInfo::of("roads", self.roads),
            TableInfo::of("geometries", self.geometries),
            TableInfo::of("coefficients", self.coefficients),
            TableInfo::of("cubics", self.cubics),
            TableInfo::of("road_types", self.road_types),
            TableInfo::of("sections", self.sections),
            TableInfo::of("lanes", self.lanes),
            TableInfo::of("lane_speeds", self.lane_speeds),
            TableInfo::of("point_stations", self.point_stations),
            TableInfo::of("points", self.points),
            TableInfo::of("junctions", self.junctions),
            TableInfo::of("connections", self.connections),
            TableInfo::of("connection_lane_links", self.connection_lane_links),
            TableInfo::of("roads_by_id", self.roads_by_id),
            TableInfo::of("junctions_by_id", self.junctions_by_id),
            TableInfo::of("index_levels", self.index_levels),
            TableInfo::of("index_nodes", self.index_nodes),
            TableInfo::of("index_leaves", self.index_leaves),
            TableInfo::of("surfaces", self.surfaces),
            TableInfo::of("shape_stations", self.shape_stations),
            TableInfo::of("surface_strips", self.surface_strips),
            TableInfo::of("lane_heights", self.lane_heights),
            TableInfo::of("lane_materials", self.lane_materials),
            TableInfo::of("elevation_grids", self.elevation_grids),
            TableInfo::of("grid_rows", self.grid_rows),
            TableInfo::of("grid_heights", self.grid_heights),
            TableInfo::of("grid_transitions", self.grid_transitions),
            TableInfo::of("road_marks", self.road_marks),
            TableInfo::of("road_mark_styles", self.road_mark_styles),
            TableInfo::of("road_mark_lines", self.road_mark_lines),
            TableInfo::of("lane_layers", self.lane_layers),
            TableInfo::of("graph", self.graph),
            TableInfo::of("lane_nodes", self.lane_nodes),
            TableInfo::of("successor_offsets", self.successor_offsets),
            TableInfo::of("successors", self.successors),
            TableInfo::of("edges", self.edges),
            TableInfo::of("predecessor_offsets", self.predecessor_offsets),
            TableInfo::of("predecessors", self.predecessors),
            TableInfo::of("conflicts", self.conflicts),
            TableInfo::of("landmark_lengths", self.landmark_lengths),
            TableInfo::of("landmark_times", self.landmark_times),
            TableInfo::of("signals", self.signals),
            TableInfo::of("signals_by_id", self.signals_by_id),
            TableInfo::of("signal_places", self.signal_places),
            TableInfo::of("signal_lanes", self.signal_lanes),
            TableInfo::of("lane_signals", self.lane_signals),
            TableInfo::of("signal_dependencies", self.signal_dependencies),
            TableInfo::of("signal_links", self.signal_links),
            TableInfo::of("object_signals", self.object_signals),
            TableInfo::of("signal_semantics", self.signal_semantics),
            TableInfo::of("signal_boards", self.signal_boards),
            TableInfo::of("display_areas", self.display_areas),
            TableInfo::of("board_groups", self.board_groups),
            TableInfo::of("controllers", self.controllers),
            TableInfo::of("controls", self.controls),
            TableInfo::of("signal_controllers", self.signal_controllers),
            TableInfo::of("junction_controllers", self.junction_controllers),
            TableInfo::of("junction_priorities", self.junction_priorities),
            TableInfo::of("default_speeds", self.default_speeds),
            TableInfo::of("signal_index_levels", self.signal_index_levels),
            TableInfo::of("signal_index_nodes", self.signal_index_nodes),
            TableInfo::of("signal_index_items", self.signal_index_items),
            TableInfo::of("quarantined", self.quarantined),
            TableInfo::of("quarantined_files", self.quarantined_files),
            TableInfo::of("quarantined_contents", self.quarantined_contents),
            TableInfo::of("objects", self.objects),
            TableInfo::of("object_outlines", self.object_outlines),
            TableInfo::of("object_points", self.object_points),
            TableInfo::of("object_copies", self.object_copies),
            TableInfo::of("lane_ranges", self.lane_ranges),
            TableInfo::of("object_lanes", self.object_lanes),
            TableInfo::of("lane_objects", self.lane_objects),
            TableInfo::of("objects_by_id", self.objects_by_id),
            TableInfo::of("object_index_levels", self.object_index_levels),
            TableInfo::of("object_index_nodes", self.object_index_nodes),
            TableInfo::of("object_index_items", self.object_index_items),
            TableInfo::of("object_markings", self.object_markings),
            TableInfo::of("object_corners", self.object_corners),
            TableInfo::of("object_borders", self.object_borders),
            TableInfo::of("object_skeletons", self.object_skeletons),
            TableInfo::of("skeleton_vertices", self.skeleton_vertices),
            TableInfo::of("parking_spaces", self.parking_spaces),
            TableInfo::of("object_materials", self.object_materials),
            TableInfo::of("object_references", self.object_references),
            TableInfo::of("structures", self.structures),
            TableInfo::of("switches", self.switches),
            TableInfo::of("stations", self.stations),
            TableInfo::of("platforms", self.platforms),
            TableInfo::of("platform_segments", self.platform_segments),
        ]
    }
}

// The element types as they lie in the bytes.
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::f64_le>() == size_of::<f64>());
const _: () = assert!(size_of::<rend::f32_le>() == size_of::<f32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::f64_le>() == size_of::<f64>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u16_le>() == size_of::<u16>());
const _: () = assert!(size_of::<rend::u16_le>() == size_of::<u16>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
