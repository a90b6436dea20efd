//! The archive's tables in the order in which they lie.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::rows::*;
use crate::error::{OpenError, VerifyError};
use crate::table::{Table, TableInfo};
use crate::verify::Check;
use rkyv::{Archive, Serialize, rend};

/// Number of the format, raised by hand when old archives can no longer be read.
pub const FORMAT: u32 = 1;
/// Identifies the layout: tables, fields, types, references and rkyv's format flags.
pub const LAYOUT_ID: [u8; 16] =
    [183, 45, 137, 68, 124, 74, 140, 220, 54, 184, 121, 12, 102, 238, 186, 236];

/// All tables of a map as the compiler fills them: the archive's root.
#[derive(Archive, Serialize, Default)]
pub struct Rows {
    /// UTF-8 text of all strings, one after the other, each once. String 0 is empty.
    pub string_bytes: Table<u8>,
    /// Start of each string in `string_bytes`; one more entry than strings.
    pub string_offsets: Table<u32>,
    /// Exactly one row: what concerns the whole map.
    pub map: Table<MapRow>,
    /// One row per road, in file order. The row number is the RoadId.
    pub roads: Table<RoadRow>,
    /// Plan-view geometries as written, with what their evaluation needs (OpenDRIVE 1.8.1, 9.2).
    pub geometries: Table<GeometryRow>,
    /// Numbers of the geometries. Line: none. Arc: curvature. Spiral: start and end curvature, then pieces of 20 (x and y as polynomials of degree 9 over −1 to 1). poly3: 4, paramPoly3: 8, then pieces of 10 (the curve parameter as a polynomial of true arc length).
    pub coefficients: Table<f64>,
    /// Cubic records a + b·ds + c·ds² + d·ds³ with ds = s − `s`; each holds until the next of its range.
    pub cubics: Table<CubicRow>,
    /// road/type records.
    pub road_types: Table<RoadTypeRow>,
    /// Lane sections, road by road, ascending in s.
    pub sections: Table<SectionRow>,
    /// Lanes, section by section, from left to right. The row number is the LaneId. Lane 0 has no width; its border is the shifted reference line.
    pub lanes: Table<LaneRow>,
    /// lane/speed records.
    pub lane_speeds: Table<LaneSpeedRow>,
    /// Points of polylines, relative to the origin of the lane that owns them.
    pub points: Table<PointRow>,
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
    /// Sixteen segments of lanes' centre lines each. A lane's area between a segment's ends lies in a rectangle around the segment: `reach` to both sides, `overshoot` beyond both ends; in height between `z_low` and `z_high`. All four are rounded outwards; 65535 in `reach`, `overshoot` or `z_high` stands for any distance. Unused places have lane u32::MAX.
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
    /// Parts of the document that have errors and are not in the map as written, in the order of the document.
    pub quarantined: Table<QuarantinedRow>,
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
    pub object_index_nodes: Table<ObjectIndexNodeRow>,
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
            roads: bytemuck::cast_slice(self.roads.as_slice()),
            geometries: bytemuck::cast_slice(self.geometries.as_slice()),
            coefficients: (self.coefficients.as_slice()),
            cubics: bytemuck::cast_slice(self.cubics.as_slice()),
            road_types: bytemuck::cast_slice(self.road_types.as_slice()),
            sections: bytemuck::cast_slice(self.sections.as_slice()),
            lanes: bytemuck::cast_slice(self.lanes.as_slice()),
            lane_speeds: bytemuck::cast_slice(self.lane_speeds.as_slice()),
            points: bytemuck::cast_slice(self.points.as_slice()),
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
    /// One row per road, in file order. The row number is the RoadId.
    pub roads: &'a [ArchivedRoadRow],
    /// Plan-view geometries as written, with what their evaluation needs (OpenDRIVE 1.8.1, 9.2).
    pub geometries: &'a [ArchivedGeometryRow],
    /// Numbers of the geometries. Line: none. Arc: curvature. Spiral: start and end curvature, then pieces of 20 (x and y as polynomials of degree 9 over −1 to 1). poly3: 4, paramPoly3: 8, then pieces of 10 (the curve parameter as a polynomial of true arc length).
    pub coefficients: &'a [f64],
    /// Cubic records a + b·ds + c·ds² + d·ds³ with ds = s − `s`; each holds until the next of its range.
    pub cubics: &'a [ArchivedCubicRow],
    /// road/type records.
    pub road_types: &'a [ArchivedRoadTypeRow],
    /// Lane sections, road by road, ascending in s.
    pub sections: &'a [ArchivedSectionRow],
    /// Lanes, section by section, from left to right. The row number is the LaneId. Lane 0 has no width; its border is the shifted reference line.
    pub lanes: &'a [ArchivedLaneRow],
    /// lane/speed records.
    pub lane_speeds: &'a [ArchivedLaneSpeedRow],
    /// Points of polylines, relative to the origin of the lane that owns them.
    pub points: &'a [ArchivedPointRow],
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
    /// Sixteen segments of lanes' centre lines each. A lane's area between a segment's ends lies in a rectangle around the segment: `reach` to both sides, `overshoot` beyond both ends; in height between `z_low` and `z_high`. All four are rounded outwards; 65535 in `reach`, `overshoot` or `z_high` stands for any distance. Unused places have lane u32::MAX.
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
    /// Parts of the document that have errors and are not in the map as written, in the order of the document.
    pub quarantined: &'a [ArchivedQuarantinedRow],
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
    pub object_index_nodes: &'a [ArchivedObjectIndexNodeRow],
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
            roads: root.roads.view(body, "roads")?,
            geometries: root.geometries.view(body, "geometries")?,
            coefficients: root.coefficients.view_numbers(body, "coefficients")?,
            cubics: root.cubics.view(body, "cubics")?,
            road_types: root.road_types.view(body, "road_types")?,
            sections: root.sections.view(body, "sections")?,
            lanes: root.lanes.view(body, "lanes")?,
            lane_speeds: root.lane_speeds.view(body, "lane_speeds")?,
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
            quarantined: root.quarantined.view(body, "quarantined")?,
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
    pub fn infos(&self) -> [TableInfo; 64] {
        [
            TableInfo::of("string_bytes", self.string_bytes),
            TableInfo::of("string_offsets", self.string_offsets),
            TableInfo::of("map", self.map),
            TableInfo::of("roads", self.roads),
            TableInfo::of("geometries", self.geometries),
            TableInfo::of("coefficients", self.coefficients),
            TableInfo::of("cubics", self.cubics),
            TableInfo::of("road_types", self.road_types),
            TableInfo::of("sections", self.sections),
            TableInfo::of("lanes", self.lanes),
            TableInfo::of("lane_speeds", self.lane_speeds),
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
            TableInfo::of("quarantined", self.quarantined),
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

    /// Proves every row: finite numbers, known codes, references and ranges inside their tables.
    pub(crate) fn verify_rows(&self) -> Result<(), VerifyError> {
        let strings = self.string_offsets.len().saturating_sub(1);
        for (i, row) in self.map.iter().enumerate() {
            let check = Check { table: "map", row: i };
            check.finite("origin_x", row.origin_x())?;
            check.finite("origin_y", row.origin_y())?;
            check.finite("min_x", row.min_x())?;
            check.finite("min_y", row.min_y())?;
            check.finite("min_z", row.min_z())?;
            check.finite("max_x", row.max_x())?;
            check.finite("max_y", row.max_y())?;
            check.finite("max_z", row.max_z())?;
            check.finite("stated_north", row.stated_north())?;
            check.finite("stated_south", row.stated_south())?;
            check.finite("stated_east", row.stated_east())?;
            check.finite("stated_west", row.stated_west())?;
            check.finite("road_length", row.road_length())?;
            check.finite("index_tolerance", row.index_tolerance())?;
            check.finite("bound_tolerance", row.bound_tolerance())?;
            check.reference("name", row.name(), strings, false)?;
            check.reference("version", row.version(), strings, false)?;
            check.reference("date", row.date(), strings, false)?;
            check.reference("vendor", row.vendor(), strings, false)?;
            check.reference("geo_reference", row.geo_reference(), strings, false)?;
        }
        for (i, row) in self.roads.iter().enumerate() {
            let check = Check { table: "roads", row: i };
            check.finite("length", row.length())?;
            check.reference("id", row.id(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.reference("junction", row.junction(), self.junctions.len(), true)?;
            check.range("geometries", row.geometries(), self.geometries.len())?;
            check.range("elevations", row.elevations(), self.cubics.len())?;
            check.range("superelevations", row.superelevations(), self.cubics.len())?;
            check.range("lane_offsets", row.lane_offsets(), self.cubics.len())?;
            check.range("sections", row.sections(), self.sections.len())?;
            check.range("types", row.types(), self.road_types.len())?;
            check.code("predecessor_kind", row.predecessor_kind(), 5)?;
            check.code("successor_kind", row.successor_kind(), 5)?;
            check.code("predecessor_contact", row.predecessor_contact(), 3)?;
            check.code("successor_contact", row.successor_contact(), 3)?;
            check.code("rule", row.rule(), 2)?;
        }
        for (i, row) in self.geometries.iter().enumerate() {
            let check = Check { table: "geometries", row: i };
            check.finite("s", row.s())?;
            check.finite("x", row.x())?;
            check.finite("y", row.y())?;
            check.finite("hdg", row.hdg())?;
            check.finite("cos", row.cos())?;
            check.finite("sin", row.sin())?;
            check.finite("length", row.length())?;
            check.range("coefficients", row.coefficients(), self.coefficients.len())?;
            check.finite("error", f64::from(row.error()))?;
            check.code("kind", row.kind(), 5)?;
            check.code("parameter_range", row.parameter_range(), 3)?;
        }
        for (i, row) in self.coefficients.iter().enumerate() {
            let check = Check { table: "coefficients", row: i };
            check.finite("", *row)?;
        }
        for (i, row) in self.cubics.iter().enumerate() {
            let check = Check { table: "cubics", row: i };
            check.finite("s", row.s())?;
            check.finite("a", row.a())?;
            check.finite("b", row.b())?;
            check.finite("c", row.c())?;
            check.finite("d", row.d())?;
        }
        for (i, row) in self.road_types.iter().enumerate() {
            let check = Check { table: "road_types", row: i };
            check.finite("s", row.s())?;
            check.finite("speed", row.speed())?;
            check.reference("country", row.country(), strings, false)?;
            check.code("speed_kind", row.speed_kind(), 4)?;
        }
        for (i, row) in self.sections.iter().enumerate() {
            let check = Check { table: "sections", row: i };
            check.finite("s_start", row.s_start())?;
            check.finite("s_end", row.s_end())?;
            check.reference("road", row.road(), self.roads.len(), false)?;
            check.range("lanes", row.lanes(), self.lanes.len())?;
        }
        for (i, row) in self.lanes.iter().enumerate() {
            let check = Check { table: "lanes", row: i };
            check.finite("x", row.x())?;
            check.finite("y", row.y())?;
            check.finite("z", row.z())?;
            check.reference("section", row.section(), self.sections.len(), false)?;
            check.range("widths", row.widths(), self.cubics.len())?;
            check.range("speeds", row.speeds(), self.lane_speeds.len())?;
            check.range("nodes", row.nodes(), self.lane_nodes.len())?;
            check.range("center", row.center(), self.points.len())?;
            check.range("border", row.border(), self.points.len())?;
        }
        for (i, row) in self.lane_speeds.iter().enumerate() {
            let check = Check { table: "lane_speeds", row: i };
            check.finite("s", row.s())?;
            check.finite("max", row.max())?;
        }
        for (i, row) in self.points.iter().enumerate() {
            let check = Check { table: "points", row: i };
            check.finite("x", f64::from(row.x()))?;
            check.finite("y", f64::from(row.y()))?;
            check.finite("z", f64::from(row.z()))?;
            check.finite("s", f64::from(row.s()))?;
        }
        for (i, row) in self.junctions.iter().enumerate() {
            let check = Check { table: "junctions", row: i };
            check.reference("id", row.id(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.range("connections", row.connections(), self.connections.len())?;
            check.code("kind", row.kind(), 4)?;
        }
        for (i, row) in self.connections.iter().enumerate() {
            let check = Check { table: "connections", row: i };
            check.reference("id", row.id(), strings, false)?;
            check.reference("incoming_road", row.incoming_road(), self.roads.len(), true)?;
            check.reference("connecting_road", row.connecting_road(), self.roads.len(), true)?;
            check.range("lane_links", row.lane_links(), self.connection_lane_links.len())?;
            check.code("contact", row.contact(), 3)?;
        }
        for (i, row) in self.roads_by_id.iter().enumerate() {
            let check = Check { table: "roads_by_id", row: i };
            check.reference("", *row, self.roads.len(), false)?;
        }
        for (i, row) in self.junctions_by_id.iter().enumerate() {
            let check = Check { table: "junctions_by_id", row: i };
            check.reference("", *row, self.junctions.len(), false)?;
        }
        for (i, row) in self.index_nodes.iter().enumerate() {
            let check = Check { table: "index_nodes", row: i };
            for value in row.min_x() {
                check.finite("min_x", f64::from(*value))?;
            }
            for value in row.min_y() {
                check.finite("min_y", f64::from(*value))?;
            }
            for value in row.max_x() {
                check.finite("max_x", f64::from(*value))?;
            }
            for value in row.max_y() {
                check.finite("max_y", f64::from(*value))?;
            }
            for value in row.min_z() {
                check.finite("min_z", f64::from(*value))?;
            }
            for value in row.max_z() {
                check.finite("max_z", f64::from(*value))?;
            }
        }
        for (i, row) in self.index_leaves.iter().enumerate() {
            let check = Check { table: "index_leaves", row: i };
            check.finite("x", row.x())?;
            check.finite("y", row.y())?;
            check.finite("z", row.z())?;
            for value in row.start_x() {
                check.finite("start_x", f64::from(*value))?;
            }
            for value in row.start_y() {
                check.finite("start_y", f64::from(*value))?;
            }
            for value in row.delta_x() {
                check.finite("delta_x", f64::from(*value))?;
            }
            for value in row.delta_y() {
                check.finite("delta_y", f64::from(*value))?;
            }
        }
        for (i, row) in self.surfaces.iter().enumerate() {
            let check = Check { table: "surfaces", row: i };
            check.reference("road", row.road(), self.roads.len(), false)?;
            check.range("shapes", row.shapes(), self.shape_stations.len())?;
            check.range("crossfall_left", row.crossfall_left(), self.cubics.len())?;
            check.range("crossfall_right", row.crossfall_right(), self.cubics.len())?;
            check.range("strip_offset", row.strip_offset(), self.cubics.len())?;
            check.range("strips", row.strips(), self.surface_strips.len())?;
        }
        for (i, row) in self.shape_stations.iter().enumerate() {
            let check = Check { table: "shape_stations", row: i };
            check.finite("s", row.s())?;
            check.range("records", row.records(), self.cubics.len())?;
        }
        for (i, row) in self.surface_strips.iter().enumerate() {
            let check = Check { table: "surface_strips", row: i };
            check.range("width", row.width(), self.cubics.len())?;
            check.range("constant", row.constant(), self.cubics.len())?;
            check.range("linear", row.linear(), self.cubics.len())?;
            check.range("quadratic", row.quadratic(), self.cubics.len())?;
            check.range("cubic", row.cubic(), self.cubics.len())?;
        }
        for (i, row) in self.lane_heights.iter().enumerate() {
            let check = Check { table: "lane_heights", row: i };
            check.finite("s", row.s())?;
            check.finite("inner", row.inner())?;
            check.finite("outer", row.outer())?;
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
        }
        for (i, row) in self.lane_materials.iter().enumerate() {
            let check = Check { table: "lane_materials", row: i };
            check.finite("s", row.s())?;
            check.finite("friction", row.friction())?;
            check.finite("roughness", row.roughness())?;
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
            check.reference("surface", row.surface(), strings, false)?;
        }
        for (i, row) in self.elevation_grids.iter().enumerate() {
            let check = Check { table: "elevation_grids", row: i };
            check.finite("x", row.x())?;
            check.finite("y", row.y())?;
            check.finite("cos", row.cos())?;
            check.finite("sin", row.sin())?;
            check.finite("s_start", row.s_start())?;
            check.finite("spacing", row.spacing())?;
            check.reference("junction", row.junction(), self.junctions.len(), false)?;
            check.range("rows", row.rows(), self.grid_rows.len())?;
            check.range("transitions", row.transitions(), self.grid_transitions.len())?;
        }
        for (i, row) in self.grid_rows.iter().enumerate() {
            let check = Check { table: "grid_rows", row: i };
            check.finite("center", row.center())?;
            check.range("left", row.left(), self.grid_heights.len())?;
            check.range("right", row.right(), self.grid_heights.len())?;
        }
        for (i, row) in self.grid_heights.iter().enumerate() {
            let check = Check { table: "grid_heights", row: i };
            check.finite("", *row)?;
        }
        for (i, row) in self.grid_transitions.iter().enumerate() {
            let check = Check { table: "grid_transitions", row: i };
            check.finite("start_x", row.start_x())?;
            check.finite("start_y", row.start_y())?;
            check.finite("end_x", row.end_x())?;
            check.finite("end_y", row.end_y())?;
            check.finite("length", row.length())?;
        }
        for (i, row) in self.graph.iter().enumerate() {
            let check = Check { table: "graph", row: i };
            check.finite("length_step", row.length_step())?;
            check.finite("time_step", row.time_step())?;
            check.finite("change_length", row.change_length())?;
            check.finite("change_time", row.change_time())?;
        }
        for (i, row) in self.lane_nodes.iter().enumerate() {
            let check = Check { table: "lane_nodes", row: i };
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
            check.reference("left", row.left(), self.lane_nodes.len(), true)?;
            check.reference("right", row.right(), self.lane_nodes.len(), true)?;
            check.finite("s_from", f64::from(row.s_from()))?;
            check.finite("length", f64::from(row.length()))?;
            check.finite("time", f64::from(row.time()))?;
        }
        for (i, row) in self.successors.iter().enumerate() {
            let check = Check { table: "successors", row: i };
            check.reference("", *row, self.lane_nodes.len(), false)?;
        }
        for (i, row) in self.edges.iter().enumerate() {
            let check = Check { table: "edges", row: i };
            check.code("kind", row.kind(), 6)?;
        }
        for (i, row) in self.predecessors.iter().enumerate() {
            let check = Check { table: "predecessors", row: i };
            check.reference("", *row, self.lane_nodes.len(), false)?;
        }
        for (i, row) in self.conflicts.iter().enumerate() {
            let check = Check { table: "conflicts", row: i };
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
            check.reference("other", row.other(), self.lanes.len(), false)?;
            check.finite("s_from", f64::from(row.s_from()))?;
            check.finite("s_to", f64::from(row.s_to()))?;
            check.finite("other_from", f64::from(row.other_from()))?;
            check.finite("other_to", f64::from(row.other_to()))?;
            check.code("kind", row.kind(), 4)?;
        }
        for (i, row) in self.quarantined.iter().enumerate() {
            let check = Check { table: "quarantined", row: i };
            check.finite("min_x", row.min_x())?;
            check.finite("min_y", row.min_y())?;
            check.finite("max_x", row.max_x())?;
            check.finite("max_y", row.max_y())?;
            check.finite("length", row.length())?;
            check.reference("id", row.id(), strings, false)?;
            check.reference("owner", row.owner(), strings, false)?;
            check.reference("rule", row.rule(), strings, false)?;
            check.reference("message", row.message(), strings, false)?;
            check.code("kind", row.kind(), 7)?;
            check.code("treatment", row.treatment(), 2)?;
            check.code("has_extent", row.has_extent(), 2)?;
        }
        for (i, row) in self.objects.iter().enumerate() {
            let check = Check { table: "objects", row: i };
            check.finite("x", row.x())?;
            check.finite("y", row.y())?;
            check.finite("z", row.z())?;
            check.finite("s", row.s())?;
            check.finite("t", row.t())?;
            check.finite("heading", row.heading())?;
            check.finite("pitch", f64::from(row.pitch()))?;
            check.finite("roll", f64::from(row.roll()))?;
            check.finite("z_offset", f64::from(row.z_offset()))?;
            check.finite("length", f64::from(row.length()))?;
            check.finite("width", f64::from(row.width()))?;
            check.finite("height", f64::from(row.height()))?;
            check.finite("radius", f64::from(row.radius()))?;
            check.finite("valid_length", f64::from(row.valid_length()))?;
            check.reference("id", row.id(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.reference("kind", row.kind(), strings, false)?;
            check.reference("subtype", row.subtype(), strings, false)?;
            check.reference("road", row.road(), self.roads.len(), true)?;
            check.reference("junction", row.junction(), self.junctions.len(), true)?;
            check.range("outlines", row.outlines(), self.object_outlines.len())?;
            check.range("copies", row.copies(), self.object_copies.len())?;
            check.range("lanes", row.lanes(), self.object_lanes.len())?;
            check.range("validities", row.validities(), self.lane_ranges.len())?;
            check.code("shape", row.shape(), 4)?;
            check.code("orientation", row.orientation(), 3)?;
        }
        for (i, row) in self.object_outlines.iter().enumerate() {
            let check = Check { table: "object_outlines", row: i };
            check.range("points", row.points(), self.object_points.len())?;
            check.code("fill", row.fill(), 9)?;
        }
        for (i, row) in self.object_points.iter().enumerate() {
            let check = Check { table: "object_points", row: i };
            check.finite("u", f64::from(row.u()))?;
            check.finite("v", f64::from(row.v()))?;
            check.finite("z", f64::from(row.z()))?;
            check.finite("height", f64::from(row.height()))?;
        }
        for (i, row) in self.object_copies.iter().enumerate() {
            let check = Check { table: "object_copies", row: i };
            check.finite("x", row.x())?;
            check.finite("y", row.y())?;
            check.finite("z", row.z())?;
            check.finite("s", row.s())?;
            check.finite("t", row.t())?;
            check.finite("heading", row.heading())?;
            check.finite("pitch", f64::from(row.pitch()))?;
            check.finite("roll", f64::from(row.roll()))?;
            check.finite("length", f64::from(row.length()))?;
            check.finite("width", f64::from(row.width()))?;
            check.finite("height", f64::from(row.height()))?;
            check.finite("radius", f64::from(row.radius()))?;
            check.reference("object", row.object(), self.objects.len(), false)?;
            check.range("outlines", row.outlines(), self.object_outlines.len())?;
            check.code("shape", row.shape(), 4)?;
        }
        for (i, row) in self.object_lanes.iter().enumerate() {
            let check = Check { table: "object_lanes", row: i };
            check.reference("object", row.object(), self.objects.len(), false)?;
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
            check.finite("s_from", f64::from(row.s_from()))?;
            check.finite("s_to", f64::from(row.s_to()))?;
            check.finite("distance", f64::from(row.distance()))?;
            check.code("method", row.method(), 3)?;
        }
        for (i, row) in self.lane_objects.iter().enumerate() {
            let check = Check { table: "lane_objects", row: i };
            check.reference("", *row, self.object_lanes.len(), false)?;
        }
        for (i, row) in self.objects_by_id.iter().enumerate() {
            let check = Check { table: "objects_by_id", row: i };
            check.reference("", *row, self.objects.len(), false)?;
        }
        for (i, row) in self.object_index_nodes.iter().enumerate() {
            let check = Check { table: "object_index_nodes", row: i };
            for value in row.min_x() {
                check.finite("min_x", f64::from(*value))?;
            }
            for value in row.min_y() {
                check.finite("min_y", f64::from(*value))?;
            }
            for value in row.max_x() {
                check.finite("max_x", f64::from(*value))?;
            }
            for value in row.max_y() {
                check.finite("max_y", f64::from(*value))?;
            }
        }
        for (i, row) in self.object_markings.iter().enumerate() {
            let check = Check { table: "object_markings", row: i };
            check.reference("object", row.object(), self.objects.len(), false)?;
            check.reference("outline", row.outline(), self.object_outlines.len(), true)?;
            check.range("corners", row.corners(), self.object_corners.len())?;
            check.reference("color", row.color(), strings, false)?;
            check.reference("weight", row.weight(), strings, false)?;
            check.reference("kind", row.kind(), strings, false)?;
            check.finite("width", f64::from(row.width()))?;
            check.finite("z_offset", f64::from(row.z_offset()))?;
            check.finite("line_length", f64::from(row.line_length()))?;
            check.finite("space_length", f64::from(row.space_length()))?;
            check.finite("start_offset", f64::from(row.start_offset()))?;
            check.finite("stop_offset", f64::from(row.stop_offset()))?;
            check.code("side", row.side(), 5)?;
        }
        for (i, row) in self.object_corners.iter().enumerate() {
            let check = Check { table: "object_corners", row: i };
            check.reference("", *row, self.object_points.len(), false)?;
        }
        for (i, row) in self.object_borders.iter().enumerate() {
            let check = Check { table: "object_borders", row: i };
            check.reference("object", row.object(), self.objects.len(), false)?;
            check.reference("outline", row.outline(), self.object_outlines.len(), true)?;
            check.range("corners", row.corners(), self.object_corners.len())?;
            check.reference("kind", row.kind(), strings, false)?;
            check.finite("width", f64::from(row.width()))?;
        }
        for (i, row) in self.object_skeletons.iter().enumerate() {
            let check = Check { table: "object_skeletons", row: i };
            check.reference("object", row.object(), self.objects.len(), false)?;
            check.range("vertices", row.vertices(), self.skeleton_vertices.len())?;
        }
        for (i, row) in self.skeleton_vertices.iter().enumerate() {
            let check = Check { table: "skeleton_vertices", row: i };
            check.finite("u", f64::from(row.u()))?;
            check.finite("v", f64::from(row.v()))?;
            check.finite("z", f64::from(row.z()))?;
            check.finite("radius", f64::from(row.radius()))?;
        }
        for (i, row) in self.parking_spaces.iter().enumerate() {
            let check = Check { table: "parking_spaces", row: i };
            check.reference("object", row.object(), self.objects.len(), false)?;
            check.reference("restrictions", row.restrictions(), strings, false)?;
            check.reference("access", row.access(), strings, false)?;
        }
        for (i, row) in self.object_materials.iter().enumerate() {
            let check = Check { table: "object_materials", row: i };
            check.reference("object", row.object(), self.objects.len(), false)?;
            check.reference("surface", row.surface(), strings, false)?;
            check.reference("color", row.color(), strings, false)?;
            check.finite("friction", f64::from(row.friction()))?;
            check.finite("roughness", f64::from(row.roughness()))?;
        }
        for (i, row) in self.object_references.iter().enumerate() {
            let check = Check { table: "object_references", row: i };
            check.finite("s", row.s())?;
            check.finite("t", row.t())?;
            check.reference("road", row.road(), self.roads.len(), false)?;
            check.reference("object", row.object(), self.objects.len(), true)?;
            check.reference("id", row.id(), strings, false)?;
            check.range("validities", row.validities(), self.lane_ranges.len())?;
            check.finite("z_offset", f64::from(row.z_offset()))?;
            check.finite("valid_length", f64::from(row.valid_length()))?;
            check.code("orientation", row.orientation(), 3)?;
        }
        for (i, row) in self.structures.iter().enumerate() {
            let check = Check { table: "structures", row: i };
            check.finite("s", row.s())?;
            check.finite("length", row.length())?;
            check.reference("road", row.road(), self.roads.len(), false)?;
            check.reference("id", row.id(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.reference("material", row.material(), strings, false)?;
            check.range("validities", row.validities(), self.lane_ranges.len())?;
            check.finite("lighting", f64::from(row.lighting()))?;
            check.finite("daylight", f64::from(row.daylight()))?;
            check.code("kind", row.kind(), 2)?;
        }
        for (i, row) in self.switches.iter().enumerate() {
            let check = Check { table: "switches", row: i };
            check.finite("main_s", row.main_s())?;
            check.finite("side_s", row.side_s())?;
            check.reference("road", row.road(), self.roads.len(), false)?;
            check.reference("id", row.id(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.reference("main", row.main(), self.roads.len(), true)?;
            check.reference("side", row.side(), self.roads.len(), true)?;
            check.reference("partner", row.partner(), self.switches.len(), true)?;
            check.code("position", row.position(), 4)?;
            check.code("main_direction", row.main_direction(), 3)?;
            check.code("side_direction", row.side_direction(), 3)?;
        }
        for (i, row) in self.stations.iter().enumerate() {
            let check = Check { table: "stations", row: i };
            check.reference("id", row.id(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.reference("kind", row.kind(), strings, false)?;
            check.range("platforms", row.platforms(), self.platforms.len())?;
        }
        for (i, row) in self.platforms.iter().enumerate() {
            let check = Check { table: "platforms", row: i };
            check.reference("id", row.id(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.range("segments", row.segments(), self.platform_segments.len())?;
        }
        for (i, row) in self.platform_segments.iter().enumerate() {
            let check = Check { table: "platform_segments", row: i };
            check.finite("s_start", row.s_start())?;
            check.finite("s_end", row.s_end())?;
            check.reference("road", row.road(), self.roads.len(), true)?;
            check.code("side", row.side(), 3)?;
        }
        Ok(())
    }
}

// The element types as they lie in the bytes.
const _: () = assert!(size_of::<rend::u32_le>() == size_of::<u32>());
const _: () = assert!(size_of::<rend::f64_le>() == size_of::<f64>());
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
