//! Codes of the archive's rows that this release does not know.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::tables::Tables;
use crate::unknown::UnknownCodes;

impl Tables<'_> {
    /// Notes codes that this release does not know where nothing else depends on them.
    pub(crate) fn note_unknown_codes(&self, found: &mut UnknownCodes) {
        for (i, row) in self.map.iter().enumerate() {
            found.note("map", "geo_reference_form", i, row.geo_reference_form(), 7);
        }
        for (i, row) in self.road_types.iter().enumerate() {
            found.note("road_types", "speed_kind", i, row.speed_kind(), 5);
        }
        for (i, row) in self.junctions.iter().enumerate() {
            found.note("junctions", "kind", i, row.kind(), 4);
        }
        for (i, row) in self.road_mark_styles.iter().enumerate() {
            found.note("road_mark_styles", "kind", i, row.kind(), 13);
            found.note("road_mark_styles", "weight", i, row.weight(), 3);
            found.note("road_mark_styles", "color", i, row.color(), 10);
            found.note("road_mark_styles", "lane_change", i, row.lane_change(), 5);
        }
        for (i, row) in self.road_mark_lines.iter().enumerate() {
            found.note("road_mark_lines", "rule", i, row.rule(), 4);
            found.note("road_mark_lines", "color", i, row.color(), 10);
        }
        for (i, row) in self.conflicts.iter().enumerate() {
            found.note("conflicts", "reason", i, row.reason(), 8);
        }
        for (i, row) in self.signals.iter().enumerate() {
            found.note("signals", "orientation", i, row.orientation(), 3);
            found.note("signals", "dynamic", i, row.dynamic(), 2);
            found.note("signals", "position", i, row.position(), 3);
        }
        for (i, row) in self.signal_places.iter().enumerate() {
            found.note("signal_places", "orientation", i, row.orientation(), 3);
        }
        for (i, row) in self.signal_lanes.iter().enumerate() {
            found.note("signal_lanes", "method", i, row.method(), 5);
        }
        for (i, row) in self.quarantined.iter().enumerate() {
            found.note("quarantined", "kind", i, row.kind(), 8);
            found.note("quarantined", "owner_kind", i, row.owner_kind(), 8);
        }
        for (i, row) in self.quarantined_contents.iter().enumerate() {
            found.note("quarantined_contents", "kind", i, row.kind(), 7);
        }
        for (i, row) in self.objects.iter().enumerate() {
            found.note("objects", "shape", i, row.shape(), 4);
            found.note("objects", "orientation", i, row.orientation(), 3);
        }
        for (i, row) in self.object_outlines.iter().enumerate() {
            found.note("object_outlines", "fill", i, row.fill(), 9);
        }
        for (i, row) in self.object_copies.iter().enumerate() {
            found.note("object_copies", "shape", i, row.shape(), 4);
        }
        for (i, row) in self.object_lanes.iter().enumerate() {
            found.note("object_lanes", "method", i, row.method(), 4);
        }
        for (i, row) in self.object_markings.iter().enumerate() {
            found.note("object_markings", "side", i, row.side(), 5);
        }
        for (i, row) in self.object_references.iter().enumerate() {
            found.note("object_references", "orientation", i, row.orientation(), 3);
        }
        for (i, row) in self.structures.iter().enumerate() {
            found.note("structures", "kind", i, row.kind(), 2);
        }
        for (i, row) in self.switches.iter().enumerate() {
            found.note("switches", "position", i, row.position(), 4);
            found.note("switches", "main_direction", i, row.main_direction(), 3);
            found.note("switches", "side_direction", i, row.side_direction(), 3);
        }
        for (i, row) in self.platform_segments.iter().enumerate() {
            found.note("platform_segments", "side", i, row.side(), 3);
        }
        for (i, row) in self.annotations.iter().enumerate() {
            found.note("annotations", "kind", i, row.kind(), 7);
            found.note("annotations", "owner_kind", i, row.owner_kind(), 11);
        }
        for (i, row) in self.annotation_blocks.iter().enumerate() {
            found.note("annotation_blocks", "owner_kind", i, row.owner_kind(), 11);
        }
        for (i, row) in self.junction_groups.iter().enumerate() {
            found.note("junction_groups", "kind", i, row.kind(), 5);
        }
    }
}
