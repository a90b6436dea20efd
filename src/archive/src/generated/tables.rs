//! The archive's tables as they lie.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::annotation_rows::*;
use super::beside_rows::*;
use super::index_rows::*;
use super::known_tables::TABLES;
use super::network_rows::*;
use super::object_rows::*;
use super::signal_rows::*;
use crate::directory::Reader;
use crate::error::OpenError;
use crate::table::TableInfo;
use rkyv::rend;

/// All tables of an opened archive; those that it does not have are empty. Lengths and places were read once and
/// checked; they stay what they are whatever happens to the bytes later.
#[derive(Clone, Copy)]
pub struct Tables<'a> {
    /// UTF-8 text of all strings, one after the other, each once. String 0 is empty.
    pub string_bytes: &'a [u8],
    /// Start of each string in `string_bytes`; one more entry than strings.
    pub string_offsets: &'a [u32],
    /// Exactly one row: facts about the whole map.
    pub map: &'a [ArchivedMapRow],
    /// One row for a map that was compiled into another frame than its file's (`--crs`), else none. `projection` of the map is then the target, its offset 0.
    pub file_frames: &'a [ArchivedFileFrameRow],
    /// One row per road, in file order. The row number is the RoadId.
    pub roads: &'a [ArchivedRoadRow],
    /// Plan-view geometries, as written or transformed into the target frame, with the values that their evaluation needs (OpenDRIVE 1.8.1, 9.2).
    pub geometries: &'a [ArchivedGeometryRow],
    /// Numbers of the geometries. Line: none. Arc: curvature. Spiral: start and end curvature, then pieces of 20 (x and y as polynomials of degree 9 over −1 to 1). poly3: 4, paramPoly3: 8, then pieces of 10 (the curve parameter as a polynomial of true arc length). Transformed: pieces of 21 (heading of the middle relative to the start, then x and y as polynomials of degree 9). Equal sequences are stored once.
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
    /// s of points minus their section's start `[m]`: the values of a section ascend without duplicates, and all its lines share them. Equal sequences are stored once.
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
    /// lane/height records, by lane and s: the lane's height above the road's surface, linear between its edges.
    pub lane_heights: &'a [ArchivedLaneHeightRow],
    /// lane/material records, by lane and s.
    pub lane_materials: &'a [ArchivedLaneMaterialRow],
    /// Elevation grids of junctions, by junction (OpenDRIVE 1.8.1, 12.8): inside, their heights replace those of the connecting roads.
    pub elevation_grids: &'a [ArchivedElevationGridRow],
    /// A row of an elevation grid: heights from its point on the reference line outwards.
    pub grid_rows: &'a [ArchivedGridRowRow],
    /// Heights of elevation grids `[m]`.
    pub grid_heights: &'a [f64],
    /// Joints of junctions with an elevation grid, in the direction that has the junction on the left.
    pub grid_transitions: &'a [ArchivedGridTransitionRow],
    /// lane/roadMark records, each sequence once. A record describes the mark on a lane's outer border, or on lane 0's own line for lane 0, up to the next record of the sequence.
    pub road_marks: &'a [ArchivedRoadMarkRow],
    /// Styles of road marks, each once, in the order of their first use.
    pub road_mark_styles: &'a [ArchivedRoadMarkStyleRow],
    /// Lines of road marks: of a pattern (roadMark/type/line), repeated every `length` + `space`, or explicit (roadMark/explicit/line), once.
    pub road_mark_lines: &'a [ArchivedRoadMarkLineRow],
    /// Temporary lanes of roads (OpenDRIVE 1.9), by road. Their sections and lanes are rows like others, which no road's own sections, no node of the lane graph and no leaf of the index names.
    pub lane_layers: &'a [ArchivedLaneLayerRow],
    /// Exactly one row: facts about the whole lane graph.
    pub graph: &'a [ArchivedGraphRow],
    /// Nodes of the lane graph: a lane, or a piece of one, travelled in one direction. Lane by lane.
    pub lane_nodes: &'a [ArchivedLaneNodeRow],
    /// First edge of each node in `successors`; one more entry than nodes.
    pub successor_offsets: &'a [u32],
    /// Nodes entered from each node, in order of road id, section, lane (compressed sparse rows).
    pub successors: &'a [u32],
    /// Facts about each entry of `successors`, and the element of the file that states it. Length, time and access are those of the node that the edge leaves.
    pub edges: &'a [ArchivedEdgeRow],
    /// First entry of each node in `predecessors`; one more entry than nodes.
    pub predecessor_offsets: &'a [u32],
    /// Nodes from which each node is entered: the inverse of `successors`.
    pub predecessors: &'a [u32],
    /// Lanes of one junction whose areas meet, by `lane`; each pair is stored twice, once for each lane.
    pub conflicts: &'a [ArchivedConflictRow],
    /// Per place: distances from each landmark, then to each, in `length_step`, rounded down; 65535 if there is no way.
    pub landmark_lengths: &'a [u16],
    /// As `landmark_lengths`, in `time_step`.
    pub landmark_times: &'a [u16],
    /// One row per signal, in file order, signs on boards behind the signal that carries them. The row number is the SignalId.
    pub signals: &'a [ArchivedSignalRow],
    /// Rows of `signals` in byte order of their ids.
    pub signals_by_id: &'a [u32],
    /// Places where signals apply: on their own road and on roads that refer to them, by road and s.
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
    /// Controllers by signal: the inverse of `controls`.
    pub signal_controllers: &'a [u32],
    /// junction/controller, by junction: the controllers of a junction are its synchronisation group.
    pub junction_controllers: &'a [ArchivedJunctionControllerRow],
    /// junction/priority, by junction.
    pub junction_priorities: &'a [ArchivedJunctionPriorityRow],
    /// header/defaultRegulations: speeds by type of road (OpenDRIVE 1.8.1, 6.4).
    pub default_speeds: &'a [ArchivedDefaultSpeedRow],
    /// First node of each level of the signals' index, root first, then the number of nodes. Empty if the map has no signals.
    pub signal_index_levels: &'a [u32],
    /// Packed R-tree over the positions of signals, with the layout of the objects' tree.
    pub signal_index_nodes: &'a [ArchivedBoxNodeRow],
    /// Entries below the last level: each signal once.
    pub signal_index_items: &'a [u32],
    /// Parts of the document that have errors and are not in the map as written, in the order of the document.
    pub quarantined: &'a [ArchivedQuarantinedRow],
    /// Objects by road, in file order; those of junctions after those of roads. The row number is the ObjectId.
    pub objects: &'a [ArchivedObjectRow],
    /// Outlines of objects, and of the areas that continuous repetitions sweep over.
    pub object_outlines: &'a [ArchivedObjectOutlineRow],
    /// Corners in the frame of the object or copy that they belong to: u ahead, v to the left, z upwards.
    pub object_points: &'a [ArchivedObjectPointRow],
    /// Places of repeated objects, object by object, in the order of the repetitions and of s.
    pub object_copies: &'a [ArchivedObjectCopyRow],
    /// validity elements: lane numbers from the lower to the higher one.
    pub lane_ranges: &'a [ArchivedLaneRangeRow],
    /// Which lanes objects belong to, object by object, nearer lanes first.
    pub object_lanes: &'a [ArchivedObjectLaneRow],
    /// Rows of `object_lanes` by lane, then by their start: the objects of a lane.
    pub lane_objects: &'a [u32],
    /// Rows of `objects` in byte order of their ids.
    pub objects_by_id: &'a [u32],
    /// First node of each level of the objects' index, root first, then the number of nodes. Empty if the map has no objects.
    pub object_index_levels: &'a [u32],
    /// Packed R-tree: node i of a level has children 16·i … 16·i + 15 on the next one; below the last level lie `object_index_items`. Boxes contain the objects' areas in plan view, are relative to the local origin and rounded outwards; unused places are empty boxes.
    pub object_index_nodes: &'a [ArchivedBoxNodeRow],
    /// Entries below the last level: a value below the number of objects is an object's row; any other value is that number plus the row of a copy. Each place of an object once.
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
    /// Materials of objects, by object.
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
    /// Features that a reader must know to read this map: one row for each bit of the header's `must_understand`. A reader that does not know a feature can name it.
    pub features: &'a [ArchivedFeatureRow],
    /// Parts in quarantine whose finding is in an included file, by part. The findings of all other parts are in the document itself.
    pub quarantined_files: &'a [ArchivedQuarantinedFileRow],
    /// Objects and signals that are missing because the road or junction that they belong to is in quarantine, by that part.
    pub quarantined_contents: &'a [ArchivedQuarantinedContentRow],
    /// Data of the file that has no table of its own: data of applications, quality of data, elements that the standard does not have, and attributes that are not used otherwise. A row is the difference of an annotation from the one before, and equal rows are stored once; `annotation_numbers` has their order.
    pub annotations: &'a [ArchivedAnnotationRow],
    /// Files that the document includes, in that order.
    pub included_files: &'a [ArchivedIncludedFileRow],
    /// lane/visibility records, by lane and s (OpenDRIVE 1.4, 1.5).
    pub lane_visibilities: &'a [ArchivedLaneVisibilityRow],
    /// lane/rule records, by lane and s.
    pub lane_rules: &'a [ArchivedLaneRuleRow],
    /// Groups of junctions in file order: roundabouts and interchanges.
    pub junction_groups: &'a [ArchivedJunctionGroupRow],
    /// junctionGroup/junctionReference, by group.
    pub junction_group_members: &'a [ArchivedJunctionGroupMemberRow],
    /// Lanes of the rings of roundabouts, by group: lanes from which a way within the group leads back to them.
    pub ring_lanes: &'a [u32],
    /// Values that objects mean, by object: the limit that the name of a sign states.
    pub object_values: &'a [ArchivedObjectValueRow],
    /// Speed signs in force where a lane's traffic enters it, by lane; a lane without such a sign has no row. A map with signals of lanes has at least one row, which may be empty.
    pub speed_signs_at_entry: &'a [ArchivedSpeedSignsAtEntryRow],
    /// All annotations by owner (kind, then row), those of one owner in file order: rows of `annotations`, each in as many bits as the greatest row number there needs, without gaps, the lowest bit of the lowest byte first.
    pub annotation_numbers: &'a [u8],
    /// A row for each 256 annotations: the values that the first of them is relative to, so that the annotations of an owner are found without reading all.
    pub annotation_blocks: &'a [ArchivedAnnotationBlockRow],
    /// A row for each 64 lanes: the sections and roads that their rows lead to, so that queries can read all of these rows ahead at once. It decides nothing. Where roads of neighbouring sections do not follow each other, as behind temporary layers, it is wrong.
    pub lane_blocks: &'a [ArchivedLaneBlockRow],
    /// How long lanes of very many records are up to some of these, by lane and s: a length along one is a difference, and what lies before and behind. It decides nothing.
    pub lane_lengths: &'a [ArchivedLaneLengthRow],
}

impl<'a> Tables<'a> {
    /// Takes the tables that this release knows from the directory.
    pub(crate) fn read(directory: &mut Reader<'a>) -> Result<Self, OpenError> {
        Ok(Self {
            string_bytes: directory.take(&TABLES[0])?,
            string_offsets: directory.take(&TABLES[1])?,
            map: directory.take(&TABLES[2])?,
            file_frames: directory.take(&TABLES[3])?,
            roads: directory.take(&TABLES[4])?,
            geometries: directory.take(&TABLES[5])?,
            coefficients: directory.take(&TABLES[6])?,
            cubics: directory.take(&TABLES[7])?,
            road_types: directory.take(&TABLES[8])?,
            sections: directory.take(&TABLES[9])?,
            lanes: directory.take(&TABLES[10])?,
            lane_speeds: directory.take(&TABLES[11])?,
            point_stations: directory.take(&TABLES[12])?,
            points: directory.take(&TABLES[13])?,
            junctions: directory.take(&TABLES[14])?,
            connections: directory.take(&TABLES[15])?,
            connection_lane_links: directory.take(&TABLES[16])?,
            roads_by_id: directory.take(&TABLES[17])?,
            junctions_by_id: directory.take(&TABLES[18])?,
            index_levels: directory.take(&TABLES[19])?,
            index_nodes: directory.take(&TABLES[20])?,
            index_leaves: directory.take(&TABLES[21])?,
            surfaces: directory.take(&TABLES[22])?,
            shape_stations: directory.take(&TABLES[23])?,
            surface_strips: directory.take(&TABLES[24])?,
            lane_heights: directory.take(&TABLES[25])?,
            lane_materials: directory.take(&TABLES[26])?,
            elevation_grids: directory.take(&TABLES[27])?,
            grid_rows: directory.take(&TABLES[28])?,
            grid_heights: directory.take(&TABLES[29])?,
            grid_transitions: directory.take(&TABLES[30])?,
            road_marks: directory.take(&TABLES[31])?,
            road_mark_styles: directory.take(&TABLES[32])?,
            road_mark_lines: directory.take(&TABLES[33])?,
            lane_layers: directory.take(&TABLES[34])?,
            graph: directory.take(&TABLES[35])?,
            lane_nodes: directory.take(&TABLES[36])?,
            successor_offsets: directory.take(&TABLES[37])?,
            successors: directory.take(&TABLES[38])?,
            edges: directory.take(&TABLES[39])?,
            predecessor_offsets: directory.take(&TABLES[40])?,
            predecessors: directory.take(&TABLES[41])?,
            conflicts: directory.take(&TABLES[42])?,
            landmark_lengths: directory.take(&TABLES[43])?,
            landmark_times: directory.take(&TABLES[44])?,
            signals: directory.take(&TABLES[45])?,
            signals_by_id: directory.take(&TABLES[46])?,
            signal_places: directory.take(&TABLES[47])?,
            signal_lanes: directory.take(&TABLES[48])?,
            lane_signals: directory.take(&TABLES[49])?,
            signal_dependencies: directory.take(&TABLES[50])?,
            signal_links: directory.take(&TABLES[51])?,
            object_signals: directory.take(&TABLES[52])?,
            signal_semantics: directory.take(&TABLES[53])?,
            signal_boards: directory.take(&TABLES[54])?,
            display_areas: directory.take(&TABLES[55])?,
            board_groups: directory.take(&TABLES[56])?,
            controllers: directory.take(&TABLES[57])?,
            controls: directory.take(&TABLES[58])?,
            signal_controllers: directory.take(&TABLES[59])?,
            junction_controllers: directory.take(&TABLES[60])?,
            junction_priorities: directory.take(&TABLES[61])?,
            default_speeds: directory.take(&TABLES[62])?,
            signal_index_levels: directory.take(&TABLES[63])?,
            signal_index_nodes: directory.take(&TABLES[64])?,
            signal_index_items: directory.take(&TABLES[65])?,
            quarantined: directory.take(&TABLES[66])?,
            objects: directory.take(&TABLES[67])?,
            object_outlines: directory.take(&TABLES[68])?,
            object_points: directory.take(&TABLES[69])?,
            object_copies: directory.take(&TABLES[70])?,
            lane_ranges: directory.take(&TABLES[71])?,
            object_lanes: directory.take(&TABLES[72])?,
            lane_objects: directory.take(&TABLES[73])?,
            objects_by_id: directory.take(&TABLES[74])?,
            object_index_levels: directory.take(&TABLES[75])?,
            object_index_nodes: directory.take(&TABLES[76])?,
            object_index_items: directory.take(&TABLES[77])?,
            object_markings: directory.take(&TABLES[78])?,
            object_corners: directory.take(&TABLES[79])?,
            object_borders: directory.take(&TABLES[80])?,
            object_skeletons: directory.take(&TABLES[81])?,
            skeleton_vertices: directory.take(&TABLES[82])?,
            parking_spaces: directory.take(&TABLES[83])?,
            object_materials: directory.take(&TABLES[84])?,
            object_references: directory.take(&TABLES[85])?,
            structures: directory.take(&TABLES[86])?,
            switches: directory.take(&TABLES[87])?,
            stations: directory.take(&TABLES[88])?,
            platforms: directory.take(&TABLES[89])?,
            platform_segments: directory.take(&TABLES[90])?,
            features: directory.take(&TABLES[91])?,
            quarantined_files: directory.take(&TABLES[92])?,
            quarantined_contents: directory.take(&TABLES[93])?,
            annotations: directory.take(&TABLES[94])?,
            included_files: directory.take(&TABLES[95])?,
            lane_visibilities: directory.take(&TABLES[96])?,
            lane_rules: directory.take(&TABLES[97])?,
            junction_groups: directory.take(&TABLES[98])?,
            junction_group_members: directory.take(&TABLES[99])?,
            ring_lanes: directory.take(&TABLES[100])?,
            object_values: directory.take(&TABLES[101])?,
            speed_signs_at_entry: directory.take(&TABLES[102])?,
            annotation_numbers: directory.take(&TABLES[103])?,
            annotation_blocks: directory.take(&TABLES[104])?,
            lane_blocks: directory.take(&TABLES[105])?,
            lane_lengths: directory.take(&TABLES[106])?,
        })
    }

    /// Name, element size and length of every table, in the order in which they lie.
    pub fn infos(&self) -> [TableInfo; 107] {
        [
            TableInfo::of(1, "string_bytes", self.string_bytes),
            TableInfo::of(2, "string_offsets", self.string_offsets),
            TableInfo::of(3, "map", self.map),
            TableInfo::of(4, "file_frames", self.file_frames),
            TableInfo::of(5, "roads", self.roads),
            TableInfo::of(6, "geometries", self.geometries),
            TableInfo::of(7, "coefficients", self.coefficients),
            TableInfo::of(8, "cubics", self.cubics),
            TableInfo::of(9, "road_types", self.road_types),
            TableInfo::of(10, "sections", self.sections),
            TableInfo::of(11, "lanes", self.lanes),
            TableInfo::of(12, "lane_speeds", self.lane_speeds),
            TableInfo::of(13, "point_stations", self.point_stations),
            TableInfo::of(14, "points", self.points),
            TableInfo::of(15, "junctions", self.junctions),
            TableInfo::of(16, "connections", self.connections),
            TableInfo::of(17, "connection_lane_links", self.connection_lane_links),
            TableInfo::of(18, "roads_by_id", self.roads_by_id),
            TableInfo::of(19, "junctions_by_id", self.junctions_by_id),
            TableInfo::of(20, "index_levels", self.index_levels),
            TableInfo::of(21, "index_nodes", self.index_nodes),
            TableInfo::of(22, "index_leaves", self.index_leaves),
            TableInfo::of(23, "surfaces", self.surfaces),
            TableInfo::of(24, "shape_stations", self.shape_stations),
            TableInfo::of(25, "surface_strips", self.surface_strips),
            TableInfo::of(26, "lane_heights", self.lane_heights),
            TableInfo::of(27, "lane_materials", self.lane_materials),
            TableInfo::of(28, "elevation_grids", self.elevation_grids),
            TableInfo::of(29, "grid_rows", self.grid_rows),
            TableInfo::of(30, "grid_heights", self.grid_heights),
            TableInfo::of(31, "grid_transitions", self.grid_transitions),
            TableInfo::of(32, "road_marks", self.road_marks),
            TableInfo::of(33, "road_mark_styles", self.road_mark_styles),
            TableInfo::of(34, "road_mark_lines", self.road_mark_lines),
            TableInfo::of(35, "lane_layers", self.lane_layers),
            TableInfo::of(36, "graph", self.graph),
            TableInfo::of(37, "lane_nodes", self.lane_nodes),
            TableInfo::of(38, "successor_offsets", self.successor_offsets),
            TableInfo::of(39, "successors", self.successors),
            TableInfo::of(40, "edges", self.edges),
            TableInfo::of(41, "predecessor_offsets", self.predecessor_offsets),
            TableInfo::of(42, "predecessors", self.predecessors),
            TableInfo::of(43, "conflicts", self.conflicts),
            TableInfo::of(44, "landmark_lengths", self.landmark_lengths),
            TableInfo::of(45, "landmark_times", self.landmark_times),
            TableInfo::of(46, "signals", self.signals),
            TableInfo::of(47, "signals_by_id", self.signals_by_id),
            TableInfo::of(48, "signal_places", self.signal_places),
            TableInfo::of(49, "signal_lanes", self.signal_lanes),
            TableInfo::of(50, "lane_signals", self.lane_signals),
            TableInfo::of(51, "signal_dependencies", self.signal_dependencies),
            TableInfo::of(52, "signal_links", self.signal_links),
            TableInfo::of(53, "object_signals", self.object_signals),
            TableInfo::of(54, "signal_semantics", self.signal_semantics),
            TableInfo::of(55, "signal_boards", self.signal_boards),
            TableInfo::of(56, "display_areas", self.display_areas),
            TableInfo::of(57, "board_groups", self.board_groups),
            TableInfo::of(58, "controllers", self.controllers),
            TableInfo::of(59, "controls", self.controls),
            TableInfo::of(60, "signal_controllers", self.signal_controllers),
            TableInfo::of(61, "junction_controllers", self.junction_controllers),
            TableInfo::of(62, "junction_priorities", self.junction_priorities),
            TableInfo::of(63, "default_speeds", self.default_speeds),
            TableInfo::of(64, "signal_index_levels", self.signal_index_levels),
            TableInfo::of(65, "signal_index_nodes", self.signal_index_nodes),
            TableInfo::of(66, "signal_index_items", self.signal_index_items),
            TableInfo::of(67, "quarantined", self.quarantined),
            TableInfo::of(68, "objects", self.objects),
            TableInfo::of(69, "object_outlines", self.object_outlines),
            TableInfo::of(70, "object_points", self.object_points),
            TableInfo::of(71, "object_copies", self.object_copies),
            TableInfo::of(72, "lane_ranges", self.lane_ranges),
            TableInfo::of(73, "object_lanes", self.object_lanes),
            TableInfo::of(74, "lane_objects", self.lane_objects),
            TableInfo::of(75, "objects_by_id", self.objects_by_id),
            TableInfo::of(76, "object_index_levels", self.object_index_levels),
            TableInfo::of(77, "object_index_nodes", self.object_index_nodes),
            TableInfo::of(78, "object_index_items", self.object_index_items),
            TableInfo::of(79, "object_markings", self.object_markings),
            TableInfo::of(80, "object_corners", self.object_corners),
            TableInfo::of(81, "object_borders", self.object_borders),
            TableInfo::of(82, "object_skeletons", self.object_skeletons),
            TableInfo::of(83, "skeleton_vertices", self.skeleton_vertices),
            TableInfo::of(84, "parking_spaces", self.parking_spaces),
            TableInfo::of(85, "object_materials", self.object_materials),
            TableInfo::of(86, "object_references", self.object_references),
            TableInfo::of(87, "structures", self.structures),
            TableInfo::of(88, "switches", self.switches),
            TableInfo::of(89, "stations", self.stations),
            TableInfo::of(90, "platforms", self.platforms),
            TableInfo::of(91, "platform_segments", self.platform_segments),
            TableInfo::of(92, "features", self.features),
            TableInfo::of(93, "quarantined_files", self.quarantined_files),
            TableInfo::of(94, "quarantined_contents", self.quarantined_contents),
            TableInfo::of(95, "annotations", self.annotations),
            TableInfo::of(96, "included_files", self.included_files),
            TableInfo::of(97, "lane_visibilities", self.lane_visibilities),
            TableInfo::of(98, "lane_rules", self.lane_rules),
            TableInfo::of(99, "junction_groups", self.junction_groups),
            TableInfo::of(100, "junction_group_members", self.junction_group_members),
            TableInfo::of(101, "ring_lanes", self.ring_lanes),
            TableInfo::of(102, "object_values", self.object_values),
            TableInfo::of(103, "speed_signs_at_entry", self.speed_signs_at_entry),
            TableInfo::of(104, "annotation_numbers", self.annotation_numbers),
            TableInfo::of(105, "annotation_blocks", self.annotation_blocks),
            TableInfo::of(106, "lane_blocks", self.lane_blocks),
            TableInfo::of(107, "lane_lengths", self.lane_lengths),
        ]
    }
}

// The element types as they lie in the bytes.
const _: () = assert!(size_of::<rend::f32_le>() == size_of::<f32>());
const _: () = assert!(size_of::<rend::f64_le>() == size_of::<f64>());
const _: () = assert!(size_of::<rend::u16_le>() == size_of::<u16>());
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
