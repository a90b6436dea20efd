//! Proving the archive's rows.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::tables::Tables;
use crate::error::VerifyError;
use crate::verify::Check;

impl Tables<'_> {
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
            check.finite("south", row.south())?;
            check.finite("north", row.north())?;
            check.finite("west", row.west())?;
            check.finite("east", row.east())?;
            check.reference("name", row.name(), strings, false)?;
            check.reference("version", row.version(), strings, false)?;
            check.reference("date", row.date(), strings, false)?;
            check.reference("vendor", row.vendor(), strings, false)?;
            check.reference("geo_reference", row.geo_reference(), strings, false)?;
            check.reference("projection", row.projection(), strings, false)?;
            check.code("offset_sign", row.offset_sign(), 2)?;
            check.code("has_geodetic_bounds", row.has_geodetic_bounds(), 2)?;
        }
        for (i, row) in self.file_frames.iter().enumerate() {
            let check = Check { table: "file_frames", row: i };
            check.finite("offset_x", row.offset_x())?;
            check.finite("offset_y", row.offset_y())?;
            check.finite("offset_z", row.offset_z())?;
            check.finite("offset_hdg", row.offset_hdg())?;
            check.finite("min_x", row.min_x())?;
            check.finite("min_y", row.min_y())?;
            check.finite("min_z", row.min_z())?;
            check.finite("max_x", row.max_x())?;
            check.finite("max_y", row.max_y())?;
            check.finite("max_z", row.max_z())?;
            check.finite("height_shift", row.height_shift())?;
            check.finite("error", row.error())?;
            check.finite("height_error", row.height_error())?;
            check.finite("scale_min", row.scale_min())?;
            check.finite("scale_max", row.scale_max())?;
            check.reference("projection", row.projection(), strings, false)?;
            check.reference("target", row.target(), strings, false)?;
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
            check.code("kind", row.kind(), 6)?;
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
        }
        for (i, row) in self.sections.iter().enumerate() {
            let check = Check { table: "sections", row: i };
            check.finite("s_start", row.s_start())?;
            check.finite("s_end", row.s_end())?;
            check.finite("x", f64::from(row.x()))?;
            check.finite("y", f64::from(row.y()))?;
            check.finite("z", f64::from(row.z()))?;
            check.reference("road", row.road(), self.roads.len(), false)?;
            check.range("lanes", row.lanes(), self.lanes.len())?;
        }
        for (i, row) in self.lanes.iter().enumerate() {
            let check = Check { table: "lanes", row: i };
            check.reference("section", row.section(), self.sections.len(), false)?;
            check.range(
                "first_width",
                crate::Range { first: row.first_width(), count: row.width_count().into() },
                self.cubics.len(),
            )?;
            check.range(
                "first_node",
                crate::Range { first: row.first_node(), count: row.node_count().into() },
                self.lane_nodes.len(),
            )?;
            check.reference("first_mark", row.first_mark(), self.road_marks.len(), true)?;
        }
        for (i, row) in self.lane_blocks.iter().enumerate() {
            let check = Check { table: "lane_blocks", row: i };
            check.reference("section", row.section(), self.sections.len(), false)?;
            check.reference("road", row.road(), self.roads.len(), false)?;
        }
        for (i, row) in self.lane_lengths.iter().enumerate() {
            let check = Check { table: "lane_lengths", row: i };
            check.finite("s", row.s())?;
            check.finite("length", row.length())?;
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
        }
        for (i, row) in self.lane_speeds.iter().enumerate() {
            let check = Check { table: "lane_speeds", row: i };
            check.finite("s", row.s())?;
            check.finite("max", row.max())?;
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
        }
        for (i, row) in self.point_stations.iter().enumerate() {
            let check = Check { table: "point_stations", row: i };
            check.finite("", f64::from(*row))?;
        }
        for (i, row) in self.junctions.iter().enumerate() {
            let check = Check { table: "junctions", row: i };
            check.reference("id", row.id(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.range("connections", row.connections(), self.connections.len())?;
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
            check.finite("x", f64::from(row.x()))?;
            check.finite("y", f64::from(row.y()))?;
            check.finite("z", f64::from(row.z()))?;
            check.finite("step", f64::from(row.step()))?;
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
            check.finite("s_offset", row.s_offset())?;
            check.reference("style", row.style(), self.road_mark_styles.len(), false)?;
            check.code("last", row.last(), 2)?;
        }
        for (i, row) in self.road_mark_styles.iter().enumerate() {
            let check = Check { table: "road_mark_styles", row: i };
            check.finite("width", row.width())?;
            check.finite("height", row.height())?;
            check.reference("material", row.material(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.range("lines", row.lines(), self.road_mark_lines.len())?;
            check.range("sway", row.sway(), self.cubics.len())?;
        }
        for (i, row) in self.road_mark_lines.iter().enumerate() {
            let check = Check { table: "road_mark_lines", row: i };
            check.finite("length", row.length())?;
            check.finite("space", row.space())?;
            check.finite("t_offset", row.t_offset())?;
            check.finite("s_offset", row.s_offset())?;
            check.finite("width", row.width())?;
        }
        for (i, row) in self.lane_layers.iter().enumerate() {
            let check = Check { table: "lane_layers", row: i };
            check.reference("road", row.road(), self.roads.len(), false)?;
            check.range("sections", row.sections(), self.sections.len())?;
            check.range("lane_offsets", row.lane_offsets(), self.cubics.len())?;
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
            check.finite("s_from", f64::from(row.s_from()))?;
            check.finite("length", f64::from(row.length()))?;
            check.finite("time", f64::from(row.time()))?;
        }
        for (i, row) in self.successors.iter().enumerate() {
            let check = Check { table: "successors", row: i };
            check.reference("", *row, self.lane_nodes.len(), false)?;
        }
        Check { table: "edges", row: 0 }.parallel(self.edges.len(), self.successors.len())?;
        for (i, row) in self.edges.iter().enumerate() {
            let check = Check { table: "edges", row: i };
            check.code("kind", row.kind(), 7)?;
        }
        for (i, row) in self.predecessors.iter().enumerate() {
            let check = Check { table: "predecessors", row: i };
            check.reference("", *row, self.lane_nodes.len(), false)?;
        }
        for (i, row) in self.conflicts.iter().enumerate() {
            let check = Check { table: "conflicts", row: i };
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
            check.reference("other", row.other(), self.lanes.len(), false)?;
            check.code("kind", row.kind(), 4)?;
            check.code("relation", row.relation(), 5)?;
        }
        Check { table: "landmark_times", row: 0 }
            .parallel(self.landmark_times.len(), self.landmark_lengths.len())?;
        for (i, row) in self.signals.iter().enumerate() {
            let check = Check { table: "signals", row: i };
            check.finite("x", row.x())?;
            check.finite("y", row.y())?;
            check.finite("z", row.z())?;
            check.finite("facing", row.facing())?;
            check.finite("s", row.s())?;
            check.finite("t", row.t())?;
            check.finite("z_offset", row.z_offset())?;
            check.finite("h_offset", row.h_offset())?;
            check.finite("pitch", row.pitch())?;
            check.finite("roll", row.roll())?;
            check.finite("width", row.width())?;
            check.finite("height", row.height())?;
            check.finite("length", row.length())?;
            check.finite("written_value", row.written_value())?;
            check.finite("value", row.value())?;
            check.reference("id", row.id(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.reference("type", row.r#type(), strings, false)?;
            check.reference("subtype", row.subtype(), strings, false)?;
            check.reference("country", row.country(), strings, false)?;
            check.reference("country_revision", row.country_revision(), strings, false)?;
            check.reference("text", row.text(), strings, false)?;
            check.reference("unit", row.unit(), strings, false)?;
            check.reference("road", row.road(), self.roads.len(), false)?;
            check.reference("carrier", row.carrier(), self.signals.len(), true)?;
            check.range("dependencies", row.dependencies(), self.signal_dependencies.len())?;
            check.range("links", row.links(), self.signal_links.len())?;
            check.range("semantics", row.semantics(), self.signal_semantics.len())?;
            check.range("boards", row.boards(), self.signal_boards.len())?;
            check.range("controllers", row.controllers(), self.signal_controllers.len())?;
        }
        for (i, row) in self.signals_by_id.iter().enumerate() {
            let check = Check { table: "signals_by_id", row: i };
            check.reference("", *row, self.signals.len(), false)?;
        }
        for (i, row) in self.signal_places.iter().enumerate() {
            let check = Check { table: "signal_places", row: i };
            check.finite("s", row.s())?;
            check.finite("t", row.t())?;
            check.reference("signal", row.signal(), self.signals.len(), false)?;
            check.reference("road", row.road(), self.roads.len(), false)?;
            check.range("lanes", row.lanes(), self.signal_lanes.len())?;
            check.code("kind", row.kind(), 2)?;
        }
        for (i, row) in self.signal_lanes.iter().enumerate() {
            let check = Check { table: "signal_lanes", row: i };
            check.reference("place", row.place(), self.signal_places.len(), false)?;
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
            check.finite("distance", f64::from(row.distance()))?;
        }
        for (i, row) in self.lane_signals.iter().enumerate() {
            let check = Check { table: "lane_signals", row: i };
            check.reference("", *row, self.signal_lanes.len(), false)?;
        }
        for (i, row) in self.speed_signs_at_entry.iter().enumerate() {
            let check = Check { table: "speed_signs_at_entry", row: i };
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
            check.reference("limit", row.limit(), self.signals.len(), true)?;
            check.reference("zone", row.zone(), self.signals.len(), true)?;
            check.code("zone_depends", row.zone_depends(), 2)?;
        }
        for (i, row) in self.signal_dependencies.iter().enumerate() {
            let check = Check { table: "signal_dependencies", row: i };
            check.reference("signal", row.signal(), self.signals.len(), true)?;
            check.reference("id", row.id(), strings, false)?;
            check.reference("type", row.r#type(), strings, false)?;
        }
        for (i, row) in self.signal_links.iter().enumerate() {
            let check = Check { table: "signal_links", row: i };
            check.reference("signal", row.signal(), self.signals.len(), true)?;
            check.reference("object", row.object(), self.objects.len(), true)?;
            check.reference("owner", row.owner(), self.signals.len(), false)?;
            check.reference("id", row.id(), strings, false)?;
            check.reference("type", row.r#type(), strings, false)?;
            check.code("kind", row.kind(), 2)?;
        }
        for (i, row) in self.object_signals.iter().enumerate() {
            let check = Check { table: "object_signals", row: i };
            check.reference("", *row, self.signal_links.len(), false)?;
        }
        for (i, row) in self.signal_semantics.iter().enumerate() {
            let check = Check { table: "signal_semantics", row: i };
            check.finite("written_value", row.written_value())?;
            check.reference("element", row.element(), strings, false)?;
            check.reference("kind", row.kind(), strings, false)?;
            check.reference("unit", row.unit(), strings, false)?;
        }
        for (i, row) in self.signal_boards.iter().enumerate() {
            let check = Check { table: "signal_boards", row: i };
            check.finite("width", row.width())?;
            check.finite("height", row.height())?;
            check.finite("v", row.v())?;
            check.finite("z", row.z())?;
            check.reference("signal", row.signal(), self.signals.len(), false)?;
            check.reference("display", row.display(), strings, false)?;
            check.range("areas", row.areas(), self.display_areas.len())?;
            check.range("validities", row.validities(), self.lane_ranges.len())?;
            check.range("dependencies", row.dependencies(), self.signal_dependencies.len())?;
            check.range("links", row.links(), self.signal_links.len())?;
        }
        for (i, row) in self.display_areas.iter().enumerate() {
            let check = Check { table: "display_areas", row: i };
            check.finite("width", row.width())?;
            check.finite("height", row.height())?;
            check.finite("v", row.v())?;
            check.finite("z", row.z())?;
            check.reference("board", row.board(), self.signal_boards.len(), false)?;
        }
        for (i, row) in self.board_groups.iter().enumerate() {
            let check = Check { table: "board_groups", row: i };
            check.reference("group", row.group(), strings, false)?;
            check.reference("signal", row.signal(), self.signals.len(), true)?;
            check.reference("id", row.id(), strings, false)?;
        }
        for (i, row) in self.controllers.iter().enumerate() {
            let check = Check { table: "controllers", row: i };
            check.reference("id", row.id(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.range("controls", row.controls(), self.controls.len())?;
        }
        for (i, row) in self.controls.iter().enumerate() {
            let check = Check { table: "controls", row: i };
            check.reference("signal", row.signal(), self.signals.len(), true)?;
            check.reference("id", row.id(), strings, false)?;
            check.reference("type", row.r#type(), strings, false)?;
        }
        for (i, row) in self.signal_controllers.iter().enumerate() {
            let check = Check { table: "signal_controllers", row: i };
            check.reference("", *row, self.controllers.len(), false)?;
        }
        for (i, row) in self.junction_controllers.iter().enumerate() {
            let check = Check { table: "junction_controllers", row: i };
            check.reference("junction", row.junction(), self.junctions.len(), false)?;
            check.reference("controller", row.controller(), self.controllers.len(), true)?;
            check.reference("id", row.id(), strings, false)?;
            check.reference("type", row.r#type(), strings, false)?;
        }
        for (i, row) in self.junction_priorities.iter().enumerate() {
            let check = Check { table: "junction_priorities", row: i };
            check.reference("junction", row.junction(), self.junctions.len(), false)?;
            check.reference("high", row.high(), self.roads.len(), true)?;
            check.reference("low", row.low(), self.roads.len(), true)?;
        }
        for (i, row) in self.default_speeds.iter().enumerate() {
            let check = Check { table: "default_speeds", row: i };
            check.finite("max", row.max())?;
        }
        for (i, row) in self.signal_index_nodes.iter().enumerate() {
            let check = Check { table: "signal_index_nodes", row: i };
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
        for (i, row) in self.signal_index_items.iter().enumerate() {
            let check = Check { table: "signal_index_items", row: i };
            check.reference("", *row, self.signals.len(), false)?;
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
            check.code("treatment", row.treatment(), 2)?;
            check.code("has_extent", row.has_extent(), 2)?;
        }
        for (i, row) in self.quarantined_files.iter().enumerate() {
            let check = Check { table: "quarantined_files", row: i };
            check.reference("part", row.part(), self.quarantined.len(), false)?;
            check.reference("file", row.file(), strings, false)?;
        }
        for (i, row) in self.quarantined_contents.iter().enumerate() {
            let check = Check { table: "quarantined_contents", row: i };
            check.reference("id", row.id(), strings, false)?;
            check.reference("part", row.part(), self.quarantined.len(), false)?;
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
        }
        for (i, row) in self.object_outlines.iter().enumerate() {
            let check = Check { table: "object_outlines", row: i };
            check.range("points", row.points(), self.object_points.len())?;
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
        }
        for (i, row) in self.object_lanes.iter().enumerate() {
            let check = Check { table: "object_lanes", row: i };
            check.reference("object", row.object(), self.objects.len(), false)?;
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
            check.finite("s_from", f64::from(row.s_from()))?;
            check.finite("s_to", f64::from(row.s_to()))?;
            check.finite("distance", f64::from(row.distance()))?;
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
        for (i, row) in self.object_values.iter().enumerate() {
            let check = Check { table: "object_values", row: i };
            check.finite("value", row.value())?;
            check.reference("object", row.object(), self.objects.len(), false)?;
            check.reference("unit", row.unit(), strings, false)?;
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
        }
        for (i, row) in self.annotations.iter().enumerate() {
            let check = Check { table: "annotations", row: i };
            check.reference("path", row.path(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.reference("value", row.value(), strings, false)?;
            check.reference("text", row.text(), strings, false)?;
        }
        for (i, row) in self.included_files.iter().enumerate() {
            let check = Check { table: "included_files", row: i };
            check.reference("name", row.name(), strings, false)?;
        }
        for (i, row) in self.lane_visibilities.iter().enumerate() {
            let check = Check { table: "lane_visibilities", row: i };
            check.finite("s", row.s())?;
            check.finite("forward", row.forward())?;
            check.finite("back", row.back())?;
            check.finite("left", row.left())?;
            check.finite("right", row.right())?;
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
        }
        for (i, row) in self.lane_rules.iter().enumerate() {
            let check = Check { table: "lane_rules", row: i };
            check.finite("s", row.s())?;
            check.reference("lane", row.lane(), self.lanes.len(), false)?;
            check.reference("value", row.value(), strings, false)?;
        }
        for (i, row) in self.junction_groups.iter().enumerate() {
            let check = Check { table: "junction_groups", row: i };
            check.reference("id", row.id(), strings, false)?;
            check.reference("name", row.name(), strings, false)?;
            check.range("members", row.members(), self.junction_group_members.len())?;
            check.range("ring", row.ring(), self.ring_lanes.len())?;
        }
        for (i, row) in self.junction_group_members.iter().enumerate() {
            let check = Check { table: "junction_group_members", row: i };
            check.reference("group", row.group(), self.junction_groups.len(), false)?;
            check.reference("junction", row.junction(), self.junctions.len(), true)?;
            check.reference("id", row.id(), strings, false)?;
        }
        for (i, row) in self.ring_lanes.iter().enumerate() {
            let check = Check { table: "ring_lanes", row: i };
            check.reference("", *row, self.lanes.len(), false)?;
        }
        Ok(())
    }
}
