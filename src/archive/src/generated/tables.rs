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
    [191, 100, 15, 223, 54, 121, 229, 105, 123, 24, 177, 247, 34, 169, 57, 55];

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
    /// lane/roadMark records, by lane and s: what lies on the lane's outer border, on lane 0's own line for lane 0, until the next record of the lane.
    pub road_marks: Table<RoadMarkRow>,
    /// How road marks look, each once, in the order of their first use.
    pub road_mark_styles: Table<RoadMarkStyleRow>,
    /// Lines of road marks: of a pattern (roadMark/type/line), repeated every `length` + `space`, or explicit (roadMark/explicit/line), once.
    pub road_mark_lines: Table<RoadMarkLineRow>,
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
            road_marks: bytemuck::cast_slice(self.road_marks.as_slice()),
            road_mark_styles: bytemuck::cast_slice(self.road_mark_styles.as_slice()),
            road_mark_lines: bytemuck::cast_slice(self.road_mark_lines.as_slice()),
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
    /// lane/roadMark records, by lane and s: what lies on the lane's outer border, on lane 0's own line for lane 0, until the next record of the lane.
    pub road_marks: &'a [ArchivedRoadMarkRow],
    /// How road marks look, each once, in the order of their first use.
    pub road_mark_styles: &'a [ArchivedRoadMarkStyleRow],
    /// Lines of road marks: of a pattern (roadMark/type/line), repeated every `length` + `space`, or explicit (roadMark/explicit/line), once.
    pub road_mark_lines: &'a [ArchivedRoadMarkLineRow],
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
            road_marks: root.road_marks.view(body, "road_marks")?,
            road_mark_styles: root.road_mark_styles.view(body, "road_mark_styles")?,
            road_mark_lines: root.road_mark_lines.view(body, "road_mark_lines")?,
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
        })
    }

    /// Name, element size and length of every table, in the order in which they lie.
    pub fn infos(&self) -> [TableInfo; 43] {
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
            TableInfo::of("road_marks", self.road_marks),
            TableInfo::of("road_mark_styles", self.road_mark_styles),
            TableInfo::of("road_mark_lines", self.road_mark_lines),
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
            check.finite("offset_x", row.offset_x())?;
            check.finite("offset_y", row.offset_y())?;
            check.finite("offset_z", row.offset_z())?;
            check.finite("offset_hdg", row.offset_hdg())?;
            check.reference("name", row.name(), strings, false)?;
            check.reference("version", row.version(), strings, false)?;
            check.reference("date", row.date(), strings, false)?;
            check.reference("vendor", row.vendor(), strings, false)?;
            check.reference("geo_reference", row.geo_reference(), strings, false)?;
            check.reference("projection", row.projection(), strings, false)?;
            check.code("geo_reference_form", row.geo_reference_form(), 7)?;
            check.code("offset_sign", row.offset_sign(), 2)?;
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
        for (i, row) in self.road_marks.iter().enumerate() {
            let check = Check { table: "road_marks", row: i };
            check.finite("s", row.s())?;
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
            check.reference("style", row.style(), self.road_mark_styles.len(), false)?;
        }
        for (i, row) in self.road_mark_styles.iter().enumerate() {
            let check = Check { table: "road_mark_styles", row: i };
            check.finite("width", row.width())?;
            check.finite("height", row.height())?;
            check.reference("material", row.material(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.range("lines", row.lines(), self.road_mark_lines.len())?;
            check.range("sway", row.sway(), self.cubics.len())?;
            check.code("kind", row.kind(), 13)?;
            check.code("weight", row.weight(), 3)?;
            check.code("color", row.color(), 10)?;
            check.code("lane_change", row.lane_change(), 5)?;
        }
        for (i, row) in self.road_mark_lines.iter().enumerate() {
            let check = Check { table: "road_mark_lines", row: i };
            check.finite("length", row.length())?;
            check.finite("space", row.space())?;
            check.finite("t_offset", row.t_offset())?;
            check.finite("s_offset", row.s_offset())?;
            check.finite("width", row.width())?;
            check.code("rule", row.rule(), 4)?;
            check.code("color", row.color(), 10)?;
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
            check.code("owner_kind", row.owner_kind(), 7)?;
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
