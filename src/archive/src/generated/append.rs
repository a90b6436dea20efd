//! Appending the rows of a part of a map to the whole.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::rows::Rows;
use crate::moves::RowMapping;

/// Where the rows of a part of a map come to lie, of each table that something refers to.
pub struct RowMappings {
    /// `strings`.
    pub strings: RowMapping,
    /// `roads`.
    pub roads: RowMapping,
    /// `geometries`.
    pub geometries: RowMapping,
    /// `coefficients`.
    pub coefficients: RowMapping,
    /// `cubics`.
    pub cubics: RowMapping,
    /// `road_types`.
    pub road_types: RowMapping,
    /// `sections`.
    pub sections: RowMapping,
    /// `lanes`.
    pub lanes: RowMapping,
    /// `junctions`.
    pub junctions: RowMapping,
    /// `connections`.
    pub connections: RowMapping,
    /// `connection_lane_links`.
    pub connection_lane_links: RowMapping,
    /// `shape_stations`.
    pub shape_stations: RowMapping,
    /// `surface_strips`.
    pub surface_strips: RowMapping,
    /// `grid_rows`.
    pub grid_rows: RowMapping,
    /// `grid_heights`.
    pub grid_heights: RowMapping,
    /// `grid_transitions`.
    pub grid_transitions: RowMapping,
    /// `road_marks`.
    pub road_marks: RowMapping,
    /// `road_mark_styles`.
    pub road_mark_styles: RowMapping,
    /// `road_mark_lines`.
    pub road_mark_lines: RowMapping,
    /// `lane_nodes`.
    pub lane_nodes: RowMapping,
    /// `signals`.
    pub signals: RowMapping,
    /// `signal_places`.
    pub signal_places: RowMapping,
    /// `signal_lanes`.
    pub signal_lanes: RowMapping,
    /// `signal_dependencies`.
    pub signal_dependencies: RowMapping,
    /// `signal_links`.
    pub signal_links: RowMapping,
    /// `signal_semantics`.
    pub signal_semantics: RowMapping,
    /// `signal_boards`.
    pub signal_boards: RowMapping,
    /// `display_areas`.
    pub display_areas: RowMapping,
    /// `controllers`.
    pub controllers: RowMapping,
    /// `controls`.
    pub controls: RowMapping,
    /// `signal_controllers`.
    pub signal_controllers: RowMapping,
    /// `quarantined`.
    pub quarantined: RowMapping,
    /// `objects`.
    pub objects: RowMapping,
    /// `object_outlines`.
    pub object_outlines: RowMapping,
    /// `object_points`.
    pub object_points: RowMapping,
    /// `object_copies`.
    pub object_copies: RowMapping,
    /// `lane_ranges`.
    pub lane_ranges: RowMapping,
    /// `object_lanes`.
    pub object_lanes: RowMapping,
    /// `object_corners`.
    pub object_corners: RowMapping,
    /// `skeleton_vertices`.
    pub skeleton_vertices: RowMapping,
    /// `switches`.
    pub switches: RowMapping,
    /// `platforms`.
    pub platforms: RowMapping,
    /// `platform_segments`.
    pub platform_segments: RowMapping,
    /// `junction_groups`.
    pub junction_groups: RowMapping,
    /// `junction_group_members`.
    pub junction_group_members: RowMapping,
    /// `ring_lanes`.
    pub ring_lanes: RowMapping,
}

impl Rows {
    /// Rows of a part of a map, to be appended to the whole. Row 0 of each table is not used, so that 0 and empty ranges
    /// from 0 on refer to nothing.
    pub fn part() -> Self {
        fn unused<T: bytemuck::Zeroable>() -> crate::Table<T> {
            vec![T::zeroed()].into()
        }
        Self {
            string_bytes: unused(),
            string_offsets: unused(),
            map: unused(),
            file_frames: unused(),
            features: unused(),
            roads: unused(),
            geometries: unused(),
            coefficients: unused(),
            cubics: unused(),
            road_types: unused(),
            sections: unused(),
            lanes: unused(),
            lane_blocks: unused(),
            lane_lengths: unused(),
            lane_speeds: unused(),
            point_stations: unused(),
            points: unused(),
            junctions: unused(),
            connections: unused(),
            connection_lane_links: unused(),
            roads_by_id: unused(),
            junctions_by_id: unused(),
            index_levels: unused(),
            index_nodes: unused(),
            index_leaves: unused(),
            surfaces: unused(),
            shape_stations: unused(),
            surface_strips: unused(),
            lane_heights: unused(),
            lane_materials: unused(),
            elevation_grids: unused(),
            grid_rows: unused(),
            grid_heights: unused(),
            grid_transitions: unused(),
            road_marks: unused(),
            road_mark_styles: unused(),
            road_mark_lines: unused(),
            lane_layers: unused(),
            graph: unused(),
            lane_nodes: unused(),
            successor_offsets: unused(),
            successors: unused(),
            edges: unused(),
            predecessor_offsets: unused(),
            predecessors: unused(),
            conflicts: unused(),
            landmark_lengths: unused(),
            landmark_times: unused(),
            signals: unused(),
            signals_by_id: unused(),
            signal_places: unused(),
            signal_lanes: unused(),
            lane_signals: unused(),
            speed_signs_at_entry: unused(),
            signal_dependencies: unused(),
            signal_links: unused(),
            object_signals: unused(),
            signal_semantics: unused(),
            signal_boards: unused(),
            display_areas: unused(),
            board_groups: unused(),
            controllers: unused(),
            controls: unused(),
            signal_controllers: unused(),
            junction_controllers: unused(),
            junction_priorities: unused(),
            default_speeds: unused(),
            signal_index_levels: unused(),
            signal_index_nodes: unused(),
            signal_index_items: unused(),
            quarantined: unused(),
            quarantined_files: unused(),
            quarantined_contents: unused(),
            objects: unused(),
            object_outlines: unused(),
            object_points: unused(),
            object_copies: unused(),
            lane_ranges: unused(),
            object_lanes: unused(),
            lane_objects: unused(),
            objects_by_id: unused(),
            object_index_levels: unused(),
            object_index_nodes: unused(),
            object_index_items: unused(),
            object_markings: unused(),
            object_corners: unused(),
            object_borders: unused(),
            object_skeletons: unused(),
            skeleton_vertices: unused(),
            parking_spaces: unused(),
            object_materials: unused(),
            object_values: unused(),
            object_references: unused(),
            structures: unused(),
            switches: unused(),
            stations: unused(),
            platforms: unused(),
            platform_segments: unused(),
            annotations: unused(),
            annotation_numbers: unused(),
            annotation_blocks: unused(),
            included_files: unused(),
            lane_visibilities: unused(),
            lane_rules: unused(),
            junction_groups: unused(),
            junction_group_members: unused(),
            ring_lanes: unused(),
        }
    }

    /// Where the rows of a part would come to lie behind these; strings stay what they are.
    pub fn moves(&self) -> RowMappings {
        RowMappings {
            strings: RowMapping::appended_to(1),
            roads: RowMapping::appended_to(self.roads.len()),
            geometries: RowMapping::appended_to(self.geometries.len()),
            coefficients: RowMapping::appended_to(self.coefficients.len()),
            cubics: RowMapping::appended_to(self.cubics.len()),
            road_types: RowMapping::appended_to(self.road_types.len()),
            sections: RowMapping::appended_to(self.sections.len()),
            lanes: RowMapping::appended_to(self.lanes.len()),
            junctions: RowMapping::appended_to(self.junctions.len()),
            connections: RowMapping::appended_to(self.connections.len()),
            connection_lane_links: RowMapping::appended_to(self.connection_lane_links.len()),
            shape_stations: RowMapping::appended_to(self.shape_stations.len()),
            surface_strips: RowMapping::appended_to(self.surface_strips.len()),
            grid_rows: RowMapping::appended_to(self.grid_rows.len()),
            grid_heights: RowMapping::appended_to(self.grid_heights.len()),
            grid_transitions: RowMapping::appended_to(self.grid_transitions.len()),
            road_marks: RowMapping::appended_to(self.road_marks.len()),
            road_mark_styles: RowMapping::appended_to(self.road_mark_styles.len()),
            road_mark_lines: RowMapping::appended_to(self.road_mark_lines.len()),
            lane_nodes: RowMapping::appended_to(self.lane_nodes.len()),
            signals: RowMapping::appended_to(self.signals.len()),
            signal_places: RowMapping::appended_to(self.signal_places.len()),
            signal_lanes: RowMapping::appended_to(self.signal_lanes.len()),
            signal_dependencies: RowMapping::appended_to(self.signal_dependencies.len()),
            signal_links: RowMapping::appended_to(self.signal_links.len()),
            signal_semantics: RowMapping::appended_to(self.signal_semantics.len()),
            signal_boards: RowMapping::appended_to(self.signal_boards.len()),
            display_areas: RowMapping::appended_to(self.display_areas.len()),
            controllers: RowMapping::appended_to(self.controllers.len()),
            controls: RowMapping::appended_to(self.controls.len()),
            signal_controllers: RowMapping::appended_to(self.signal_controllers.len()),
            quarantined: RowMapping::appended_to(self.quarantined.len()),
            objects: RowMapping::appended_to(self.objects.len()),
            object_outlines: RowMapping::appended_to(self.object_outlines.len()),
            object_points: RowMapping::appended_to(self.object_points.len()),
            object_copies: RowMapping::appended_to(self.object_copies.len()),
            lane_ranges: RowMapping::appended_to(self.lane_ranges.len()),
            object_lanes: RowMapping::appended_to(self.object_lanes.len()),
            object_corners: RowMapping::appended_to(self.object_corners.len()),
            skeleton_vertices: RowMapping::appended_to(self.skeleton_vertices.len()),
            switches: RowMapping::appended_to(self.switches.len()),
            platforms: RowMapping::appended_to(self.platforms.len()),
            platform_segments: RowMapping::appended_to(self.platform_segments.len()),
            junction_groups: RowMapping::appended_to(self.junction_groups.len()),
            junction_group_members: RowMapping::appended_to(self.junction_group_members.len()),
            ring_lanes: RowMapping::appended_to(self.ring_lanes.len()),
        }
    }

    /// Appends the rows of a part that move behind those that are there.
    pub fn append(&mut self, part: &Self, moves: &RowMappings) {
        self.string_bytes.extend_from_slice(part.string_bytes.get(1..).unwrap_or_default());
        self.string_offsets.extend_from_slice(part.string_offsets.get(1..).unwrap_or_default());
        let before = self.map.len();
        self.map.extend_from_slice(part.map.get(1..).unwrap_or_default());
        self.map.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.file_frames.len();
        self.file_frames.extend_from_slice(part.file_frames.get(1..).unwrap_or_default());
        self.file_frames.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        self.features.extend_from_slice(part.features.get(1..).unwrap_or_default());
        if moves.roads.is_appended() {
            let before = self.roads.len();
            self.roads.extend_from_slice(part.roads.get(1..).unwrap_or_default());
            self.roads.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.geometries.is_appended() {
            let before = self.geometries.len();
            self.geometries.extend_from_slice(part.geometries.get(1..).unwrap_or_default());
            self.geometries.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.coefficients.is_appended() {
            self.coefficients.extend_from_slice(part.coefficients.get(1..).unwrap_or_default());
        }
        if moves.cubics.is_appended() {
            self.cubics.extend_from_slice(part.cubics.get(1..).unwrap_or_default());
        }
        if moves.road_types.is_appended() {
            let before = self.road_types.len();
            self.road_types.extend_from_slice(part.road_types.get(1..).unwrap_or_default());
            self.road_types.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.sections.is_appended() {
            let before = self.sections.len();
            self.sections.extend_from_slice(part.sections.get(1..).unwrap_or_default());
            self.sections.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.lanes.is_appended() {
            let before = self.lanes.len();
            self.lanes.extend_from_slice(part.lanes.get(1..).unwrap_or_default());
            self.lanes.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        let before = self.lane_blocks.len();
        self.lane_blocks.extend_from_slice(part.lane_blocks.get(1..).unwrap_or_default());
        self.lane_blocks.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.lane_lengths.len();
        self.lane_lengths.extend_from_slice(part.lane_lengths.get(1..).unwrap_or_default());
        self.lane_lengths.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.lane_speeds.len();
        self.lane_speeds.extend_from_slice(part.lane_speeds.get(1..).unwrap_or_default());
        self.lane_speeds.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        self.point_stations.extend_from_slice(part.point_stations.get(1..).unwrap_or_default());
        self.points.extend_from_slice(part.points.get(1..).unwrap_or_default());
        if moves.junctions.is_appended() {
            let before = self.junctions.len();
            self.junctions.extend_from_slice(part.junctions.get(1..).unwrap_or_default());
            self.junctions.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.connections.is_appended() {
            let before = self.connections.len();
            self.connections.extend_from_slice(part.connections.get(1..).unwrap_or_default());
            self.connections.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.connection_lane_links.is_appended() {
            self.connection_lane_links
                .extend_from_slice(part.connection_lane_links.get(1..).unwrap_or_default());
        }
        self.roads_by_id.extend(
            part.roads_by_id.get(1..).unwrap_or_default().iter().map(|row| moves.roads.row(*row)),
        );
        self.junctions_by_id.extend(
            part.junctions_by_id
                .get(1..)
                .unwrap_or_default()
                .iter()
                .map(|row| moves.junctions.row(*row)),
        );
        self.index_levels.extend_from_slice(part.index_levels.get(1..).unwrap_or_default());
        self.index_nodes.extend_from_slice(part.index_nodes.get(1..).unwrap_or_default());
        self.index_leaves.extend_from_slice(part.index_leaves.get(1..).unwrap_or_default());
        let before = self.surfaces.len();
        self.surfaces.extend_from_slice(part.surfaces.get(1..).unwrap_or_default());
        self.surfaces.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        if moves.shape_stations.is_appended() {
            let before = self.shape_stations.len();
            self.shape_stations.extend_from_slice(part.shape_stations.get(1..).unwrap_or_default());
            self.shape_stations.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.surface_strips.is_appended() {
            let before = self.surface_strips.len();
            self.surface_strips.extend_from_slice(part.surface_strips.get(1..).unwrap_or_default());
            self.surface_strips.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        let before = self.lane_heights.len();
        self.lane_heights.extend_from_slice(part.lane_heights.get(1..).unwrap_or_default());
        self.lane_heights.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.lane_materials.len();
        self.lane_materials.extend_from_slice(part.lane_materials.get(1..).unwrap_or_default());
        self.lane_materials.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.elevation_grids.len();
        self.elevation_grids.extend_from_slice(part.elevation_grids.get(1..).unwrap_or_default());
        self.elevation_grids.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        if moves.grid_rows.is_appended() {
            let before = self.grid_rows.len();
            self.grid_rows.extend_from_slice(part.grid_rows.get(1..).unwrap_or_default());
            self.grid_rows.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.grid_heights.is_appended() {
            self.grid_heights.extend_from_slice(part.grid_heights.get(1..).unwrap_or_default());
        }
        if moves.grid_transitions.is_appended() {
            self.grid_transitions
                .extend_from_slice(part.grid_transitions.get(1..).unwrap_or_default());
        }
        if moves.road_marks.is_appended() {
            let before = self.road_marks.len();
            self.road_marks.extend_from_slice(part.road_marks.get(1..).unwrap_or_default());
            self.road_marks.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.road_mark_styles.is_appended() {
            let before = self.road_mark_styles.len();
            self.road_mark_styles
                .extend_from_slice(part.road_mark_styles.get(1..).unwrap_or_default());
            self.road_mark_styles.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.road_mark_lines.is_appended() {
            self.road_mark_lines
                .extend_from_slice(part.road_mark_lines.get(1..).unwrap_or_default());
        }
        let before = self.lane_layers.len();
        self.lane_layers.extend_from_slice(part.lane_layers.get(1..).unwrap_or_default());
        self.lane_layers.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        self.graph.extend_from_slice(part.graph.get(1..).unwrap_or_default());
        if moves.lane_nodes.is_appended() {
            let before = self.lane_nodes.len();
            self.lane_nodes.extend_from_slice(part.lane_nodes.get(1..).unwrap_or_default());
            self.lane_nodes.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        self.successor_offsets
            .extend_from_slice(part.successor_offsets.get(1..).unwrap_or_default());
        self.successors.extend(
            part.successors
                .get(1..)
                .unwrap_or_default()
                .iter()
                .map(|row| moves.lane_nodes.row(*row)),
        );
        self.edges.extend_from_slice(part.edges.get(1..).unwrap_or_default());
        self.predecessor_offsets
            .extend_from_slice(part.predecessor_offsets.get(1..).unwrap_or_default());
        self.predecessors.extend(
            part.predecessors
                .get(1..)
                .unwrap_or_default()
                .iter()
                .map(|row| moves.lane_nodes.row(*row)),
        );
        let before = self.conflicts.len();
        self.conflicts.extend_from_slice(part.conflicts.get(1..).unwrap_or_default());
        self.conflicts.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        self.landmark_lengths.extend_from_slice(part.landmark_lengths.get(1..).unwrap_or_default());
        self.landmark_times.extend_from_slice(part.landmark_times.get(1..).unwrap_or_default());
        if moves.signals.is_appended() {
            let before = self.signals.len();
            self.signals.extend_from_slice(part.signals.get(1..).unwrap_or_default());
            self.signals.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        self.signals_by_id.extend(
            part.signals_by_id
                .get(1..)
                .unwrap_or_default()
                .iter()
                .map(|row| moves.signals.row(*row)),
        );
        if moves.signal_places.is_appended() {
            let before = self.signal_places.len();
            self.signal_places.extend_from_slice(part.signal_places.get(1..).unwrap_or_default());
            self.signal_places.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.signal_lanes.is_appended() {
            let before = self.signal_lanes.len();
            self.signal_lanes.extend_from_slice(part.signal_lanes.get(1..).unwrap_or_default());
            self.signal_lanes.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        self.lane_signals.extend(
            part.lane_signals
                .get(1..)
                .unwrap_or_default()
                .iter()
                .map(|row| moves.signal_lanes.row(*row)),
        );
        let before = self.speed_signs_at_entry.len();
        self.speed_signs_at_entry
            .extend_from_slice(part.speed_signs_at_entry.get(1..).unwrap_or_default());
        self.speed_signs_at_entry.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        if moves.signal_dependencies.is_appended() {
            let before = self.signal_dependencies.len();
            self.signal_dependencies
                .extend_from_slice(part.signal_dependencies.get(1..).unwrap_or_default());
            self.signal_dependencies.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.signal_links.is_appended() {
            let before = self.signal_links.len();
            self.signal_links.extend_from_slice(part.signal_links.get(1..).unwrap_or_default());
            self.signal_links.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        self.object_signals.extend(
            part.object_signals
                .get(1..)
                .unwrap_or_default()
                .iter()
                .map(|row| moves.signal_links.row(*row)),
        );
        if moves.signal_semantics.is_appended() {
            let before = self.signal_semantics.len();
            self.signal_semantics
                .extend_from_slice(part.signal_semantics.get(1..).unwrap_or_default());
            self.signal_semantics.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.signal_boards.is_appended() {
            let before = self.signal_boards.len();
            self.signal_boards.extend_from_slice(part.signal_boards.get(1..).unwrap_or_default());
            self.signal_boards.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.display_areas.is_appended() {
            let before = self.display_areas.len();
            self.display_areas.extend_from_slice(part.display_areas.get(1..).unwrap_or_default());
            self.display_areas.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        let before = self.board_groups.len();
        self.board_groups.extend_from_slice(part.board_groups.get(1..).unwrap_or_default());
        self.board_groups.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        if moves.controllers.is_appended() {
            let before = self.controllers.len();
            self.controllers.extend_from_slice(part.controllers.get(1..).unwrap_or_default());
            self.controllers.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.controls.is_appended() {
            let before = self.controls.len();
            self.controls.extend_from_slice(part.controls.get(1..).unwrap_or_default());
            self.controls.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.signal_controllers.is_appended() {
            self.signal_controllers.extend(
                part.signal_controllers
                    .get(1..)
                    .unwrap_or_default()
                    .iter()
                    .map(|row| moves.controllers.row(*row)),
            );
        }
        let before = self.junction_controllers.len();
        self.junction_controllers
            .extend_from_slice(part.junction_controllers.get(1..).unwrap_or_default());
        self.junction_controllers.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.junction_priorities.len();
        self.junction_priorities
            .extend_from_slice(part.junction_priorities.get(1..).unwrap_or_default());
        self.junction_priorities.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        self.default_speeds.extend_from_slice(part.default_speeds.get(1..).unwrap_or_default());
        self.signal_index_levels
            .extend_from_slice(part.signal_index_levels.get(1..).unwrap_or_default());
        self.signal_index_nodes
            .extend_from_slice(part.signal_index_nodes.get(1..).unwrap_or_default());
        self.signal_index_items.extend(
            part.signal_index_items
                .get(1..)
                .unwrap_or_default()
                .iter()
                .map(|row| moves.signals.row(*row)),
        );
        if moves.quarantined.is_appended() {
            let before = self.quarantined.len();
            self.quarantined.extend_from_slice(part.quarantined.get(1..).unwrap_or_default());
            self.quarantined.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        let before = self.quarantined_files.len();
        self.quarantined_files
            .extend_from_slice(part.quarantined_files.get(1..).unwrap_or_default());
        self.quarantined_files.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.quarantined_contents.len();
        self.quarantined_contents
            .extend_from_slice(part.quarantined_contents.get(1..).unwrap_or_default());
        self.quarantined_contents.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        if moves.objects.is_appended() {
            let before = self.objects.len();
            self.objects.extend_from_slice(part.objects.get(1..).unwrap_or_default());
            self.objects.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.object_outlines.is_appended() {
            let before = self.object_outlines.len();
            self.object_outlines
                .extend_from_slice(part.object_outlines.get(1..).unwrap_or_default());
            self.object_outlines.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.object_points.is_appended() {
            self.object_points.extend_from_slice(part.object_points.get(1..).unwrap_or_default());
        }
        if moves.object_copies.is_appended() {
            let before = self.object_copies.len();
            self.object_copies.extend_from_slice(part.object_copies.get(1..).unwrap_or_default());
            self.object_copies.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.lane_ranges.is_appended() {
            self.lane_ranges.extend_from_slice(part.lane_ranges.get(1..).unwrap_or_default());
        }
        if moves.object_lanes.is_appended() {
            let before = self.object_lanes.len();
            self.object_lanes.extend_from_slice(part.object_lanes.get(1..).unwrap_or_default());
            self.object_lanes.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        self.lane_objects.extend(
            part.lane_objects
                .get(1..)
                .unwrap_or_default()
                .iter()
                .map(|row| moves.object_lanes.row(*row)),
        );
        self.objects_by_id.extend(
            part.objects_by_id
                .get(1..)
                .unwrap_or_default()
                .iter()
                .map(|row| moves.objects.row(*row)),
        );
        self.object_index_levels
            .extend_from_slice(part.object_index_levels.get(1..).unwrap_or_default());
        self.object_index_nodes
            .extend_from_slice(part.object_index_nodes.get(1..).unwrap_or_default());
        self.object_index_items
            .extend_from_slice(part.object_index_items.get(1..).unwrap_or_default());
        let before = self.object_markings.len();
        self.object_markings.extend_from_slice(part.object_markings.get(1..).unwrap_or_default());
        self.object_markings.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        if moves.object_corners.is_appended() {
            self.object_corners.extend(
                part.object_corners
                    .get(1..)
                    .unwrap_or_default()
                    .iter()
                    .map(|row| moves.object_points.row(*row)),
            );
        }
        let before = self.object_borders.len();
        self.object_borders.extend_from_slice(part.object_borders.get(1..).unwrap_or_default());
        self.object_borders.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.object_skeletons.len();
        self.object_skeletons.extend_from_slice(part.object_skeletons.get(1..).unwrap_or_default());
        self.object_skeletons.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        if moves.skeleton_vertices.is_appended() {
            self.skeleton_vertices
                .extend_from_slice(part.skeleton_vertices.get(1..).unwrap_or_default());
        }
        let before = self.parking_spaces.len();
        self.parking_spaces.extend_from_slice(part.parking_spaces.get(1..).unwrap_or_default());
        self.parking_spaces.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.object_materials.len();
        self.object_materials.extend_from_slice(part.object_materials.get(1..).unwrap_or_default());
        self.object_materials.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.object_values.len();
        self.object_values.extend_from_slice(part.object_values.get(1..).unwrap_or_default());
        self.object_values.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.object_references.len();
        self.object_references
            .extend_from_slice(part.object_references.get(1..).unwrap_or_default());
        self.object_references.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.structures.len();
        self.structures.extend_from_slice(part.structures.get(1..).unwrap_or_default());
        self.structures.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        if moves.switches.is_appended() {
            let before = self.switches.len();
            self.switches.extend_from_slice(part.switches.get(1..).unwrap_or_default());
            self.switches.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        let before = self.stations.len();
        self.stations.extend_from_slice(part.stations.get(1..).unwrap_or_default());
        self.stations.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        if moves.platforms.is_appended() {
            let before = self.platforms.len();
            self.platforms.extend_from_slice(part.platforms.get(1..).unwrap_or_default());
            self.platforms.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.platform_segments.is_appended() {
            let before = self.platform_segments.len();
            self.platform_segments
                .extend_from_slice(part.platform_segments.get(1..).unwrap_or_default());
            self.platform_segments.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        let before = self.annotations.len();
        self.annotations.extend_from_slice(part.annotations.get(1..).unwrap_or_default());
        self.annotations.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        self.annotation_numbers
            .extend_from_slice(part.annotation_numbers.get(1..).unwrap_or_default());
        self.annotation_blocks
            .extend_from_slice(part.annotation_blocks.get(1..).unwrap_or_default());
        let before = self.included_files.len();
        self.included_files.extend_from_slice(part.included_files.get(1..).unwrap_or_default());
        self.included_files.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.lane_visibilities.len();
        self.lane_visibilities
            .extend_from_slice(part.lane_visibilities.get(1..).unwrap_or_default());
        self.lane_visibilities.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        let before = self.lane_rules.len();
        self.lane_rules.extend_from_slice(part.lane_rules.get(1..).unwrap_or_default());
        self.lane_rules.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        if moves.junction_groups.is_appended() {
            let before = self.junction_groups.len();
            self.junction_groups
                .extend_from_slice(part.junction_groups.get(1..).unwrap_or_default());
            self.junction_groups.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.junction_group_members.is_appended() {
            let before = self.junction_group_members.len();
            self.junction_group_members
                .extend_from_slice(part.junction_group_members.get(1..).unwrap_or_default());
            self.junction_group_members.iter_mut().skip(before).for_each(|row| row.move_by(moves));
        }
        if moves.ring_lanes.is_appended() {
            self.ring_lanes.extend(
                part.ring_lanes
                    .get(1..)
                    .unwrap_or_default()
                    .iter()
                    .map(|row| moves.lanes.row(*row)),
            );
        }
    }
}
