//! Reading the rows of the network.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::network_rows::*;
use crate::table::Range;
use rkyv::rend;

impl ArchivedMapRow {
    /// `[m]` x of the local origin: geometry lies relative to it. 0 unless coordinates are large.
    #[inline]
    pub fn origin_x(&self) -> f64 {
        self.origin_x.to_native()
    }
    /// `[m]` y of the local origin.
    #[inline]
    pub fn origin_y(&self) -> f64 {
        self.origin_y.to_native()
    }
    /// `[m]` Smallest x of any lane, inertial.
    #[inline]
    pub fn min_x(&self) -> f64 {
        self.min_x.to_native()
    }
    /// `[m]` Smallest y of any lane, inertial.
    #[inline]
    pub fn min_y(&self) -> f64 {
        self.min_y.to_native()
    }
    /// `[m]` Smallest z of any lane, inertial.
    #[inline]
    pub fn min_z(&self) -> f64 {
        self.min_z.to_native()
    }
    /// `[m]` Largest x of any lane, inertial.
    #[inline]
    pub fn max_x(&self) -> f64 {
        self.max_x.to_native()
    }
    /// `[m]` Largest y of any lane, inertial.
    #[inline]
    pub fn max_y(&self) -> f64 {
        self.max_y.to_native()
    }
    /// `[m]` Largest z of any lane, inertial.
    #[inline]
    pub fn max_z(&self) -> f64 {
        self.max_z.to_native()
    }
    /// `[m]` header/@north as written; 0 if absent.
    #[inline]
    pub fn stated_north(&self) -> f64 {
        self.stated_north.to_native()
    }
    /// `[m]` header/@south as written; 0 if absent.
    #[inline]
    pub fn stated_south(&self) -> f64 {
        self.stated_south.to_native()
    }
    /// `[m]` header/@east as written; 0 if absent.
    #[inline]
    pub fn stated_east(&self) -> f64 {
        self.stated_east.to_native()
    }
    /// `[m]` header/@west as written; 0 if absent.
    #[inline]
    pub fn stated_west(&self) -> f64 {
        self.stated_west.to_native()
    }
    /// `[m]` Sum of the roads' lengths.
    #[inline]
    pub fn road_length(&self) -> f64 {
        self.road_length.to_native()
    }
    /// `[m]` Largest distance of a lane's centre line from its polyline.
    #[inline]
    pub fn index_tolerance(&self) -> f64 {
        self.index_tolerance.to_native()
    }
    /// `[m]` Largest distance of a lane's border from its polyline.
    #[inline]
    pub fn bound_tolerance(&self) -> f64 {
        self.bound_tolerance.to_native()
    }
    /// `[m]` header/offset/@x as it is applied: a point of the map lies at R(`offset_hdg`)·(x, y) + offset in the plane of the projection. 0 if absent.
    #[inline]
    pub fn offset_x(&self) -> f64 {
        self.offset_x.to_native()
    }
    /// `[m]` header/offset/@y as it is applied.
    #[inline]
    pub fn offset_y(&self) -> f64 {
        self.offset_y.to_native()
    }
    /// `[m]` header/offset/@z as it is applied.
    #[inline]
    pub fn offset_z(&self) -> f64 {
        self.offset_z.to_native()
    }
    /// `[rad]` header/offset/@hdg.
    #[inline]
    pub fn offset_hdg(&self) -> f64 {
        self.offset_hdg.to_native()
    }
    /// `[deg]` Smallest latitude of any lane on WGS 84, rounded to 1e-9 degrees; 0 unless `has_geodetic_bounds`.
    #[inline]
    pub fn south(&self) -> f64 {
        self.south.to_native()
    }
    /// `[deg]` Largest latitude.
    #[inline]
    pub fn north(&self) -> f64 {
        self.north.to_native()
    }
    /// `[deg]` Longitude of the western edge, −180 to 180.
    #[inline]
    pub fn west(&self) -> f64 {
        self.west.to_native()
    }
    /// `[deg]` Longitude of the eastern edge; beyond 180 where the map crosses the antimeridian.
    #[inline]
    pub fn east(&self) -> f64 {
        self.east.to_native()
    }
    /// header/@name.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// header/@version.
    #[inline]
    pub fn version(&self) -> u32 {
        self.version.to_native()
    }
    /// header/@date.
    #[inline]
    pub fn date(&self) -> u32 {
        self.date.to_native()
    }
    /// header/@vendor.
    #[inline]
    pub fn vendor(&self) -> u32 {
        self.vendor.to_native()
    }
    /// header/geoReference verbatim.
    #[inline]
    pub fn geo_reference(&self) -> u32 {
        self.geo_reference.to_native()
    }
    /// The georeference as PROJ parameters, only such as are understood; empty if there is none that can be used.
    #[inline]
    pub fn projection(&self) -> u32 {
        self.projection.to_native()
    }
    /// header/@revMajor; 0 if absent.
    #[inline]
    pub fn rev_major(&self) -> u16 {
        self.rev_major.to_native()
    }
    /// header/@revMinor; 0 if absent.
    #[inline]
    pub fn rev_minor(&self) -> u16 {
        self.rev_minor.to_native()
    }
    /// How the georeference is written: 0 absent or empty, 1 PROJ, 2 PROJ parameters without projection, 3 EPSG code, 4 WKT 1, 5 WKT 2, 6 other.
    #[inline]
    pub fn geo_reference_form(&self) -> u8 {
        self.geo_reference_form
    }
    /// Sign of header/offset as it is applied: 0 as written, 1 turned (offset fields hold the turned values).
    #[inline]
    pub fn offset_sign(&self) -> u8 {
        self.offset_sign
    }
    /// 1 where the map's place on Earth is known.
    #[inline]
    pub fn has_geodetic_bounds(&self) -> u8 {
        self.has_geodetic_bounds
    }
}

impl ArchivedFileFrameRow {
    /// `[m]` header/offset/@x as it was applied before the transformation: as `offset_x` of the map.
    #[inline]
    pub fn offset_x(&self) -> f64 {
        self.offset_x.to_native()
    }
    /// `[m]` header/offset/@y as it was applied.
    #[inline]
    pub fn offset_y(&self) -> f64 {
        self.offset_y.to_native()
    }
    /// `[m]` header/offset/@z as it was applied.
    #[inline]
    pub fn offset_z(&self) -> f64 {
        self.offset_z.to_native()
    }
    /// `[rad]` header/offset/@hdg.
    #[inline]
    pub fn offset_hdg(&self) -> f64 {
        self.offset_hdg.to_native()
    }
    /// `[m]` Smallest x of any lane in the file's frame.
    #[inline]
    pub fn min_x(&self) -> f64 {
        self.min_x.to_native()
    }
    /// `[m]` Smallest y of any lane in the file's frame.
    #[inline]
    pub fn min_y(&self) -> f64 {
        self.min_y.to_native()
    }
    /// `[m]` Smallest z of any lane in the file's frame.
    #[inline]
    pub fn min_z(&self) -> f64 {
        self.min_z.to_native()
    }
    /// `[m]` Largest x of any lane in the file's frame.
    #[inline]
    pub fn max_x(&self) -> f64 {
        self.max_x.to_native()
    }
    /// `[m]` Largest y of any lane in the file's frame.
    #[inline]
    pub fn max_y(&self) -> f64 {
        self.max_y.to_native()
    }
    /// `[m]` Largest z of any lane in the file's frame.
    #[inline]
    pub fn max_z(&self) -> f64 {
        self.max_z.to_native()
    }
    /// `[m]` z of the map minus z as written.
    #[inline]
    pub fn height_shift(&self) -> f64 {
        self.height_shift.to_native()
    }
    /// `[m]` Bound on the distance of a point of a reference line from the exact image of that point of the file.
    #[inline]
    pub fn error(&self) -> f64 {
        self.error.to_native()
    }
    /// `[m]` Bound on the difference between `height_shift` and the shift at any place of the map.
    #[inline]
    pub fn height_error(&self) -> f64 {
        self.height_error.to_native()
    }
    /// Smallest distance in the map per distance in the file, along any direction at any reference line.
    #[inline]
    pub fn scale_min(&self) -> f64 {
        self.scale_min.to_native()
    }
    /// Largest distance in the map per distance in the file.
    #[inline]
    pub fn scale_max(&self) -> f64 {
        self.scale_max.to_native()
    }
    /// The file's georeference as PROJ parameters, only such as are understood.
    #[inline]
    pub fn projection(&self) -> u32 {
        self.projection.to_native()
    }
    /// The target frame as it was asked for.
    #[inline]
    pub fn target(&self) -> u32 {
        self.target.to_native()
    }
}

impl ArchivedFeatureRow {
    /// Number of the bit, from 0.
    #[inline]
    pub fn bit(&self) -> u32 {
        self.bit.to_native()
    }
    /// First release of mapd that reads it: major, minor, patch.
    #[inline]
    pub fn release(&self) -> &[u16; 3] {
        bytemuck::cast_ref::<[rend::u16_le; 3], _>(&self.release)
    }
    /// Name in UTF-8, then zeros.
    #[inline]
    pub fn name(&self) -> &[u8; 32] {
        &self.name
    }
}

impl ArchivedRoadRow {
    /// `[m]` Length of the reference line as written.
    #[inline]
    pub fn length(&self) -> f64 {
        self.length.to_native()
    }
    /// road/@id verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// road/@name.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// Junction that the road belongs to as a connecting road.
    #[inline]
    pub fn junction(&self) -> u32 {
        self.junction.to_native()
    }
    /// Row of the road or junction at s = 0, by `predecessor_kind`; u32::MAX if none.
    #[inline]
    pub fn predecessor(&self) -> u32 {
        self.predecessor.to_native()
    }
    /// Row of the road or junction at s = length, by `successor_kind`; u32::MAX if none.
    #[inline]
    pub fn successor(&self) -> u32 {
        self.successor.to_native()
    }
    /// Plan view, ascending in s.
    #[inline]
    pub fn geometries(&self) -> Range {
        self.geometries.to_native()
    }
    /// Elevation `[m]` over s.
    #[inline]
    pub fn elevations(&self) -> Range {
        self.elevations.to_native()
    }
    /// Superelevation `[rad]` over s; positive lifts the left side.
    #[inline]
    pub fn superelevations(&self) -> Range {
        self.superelevations.to_native()
    }
    /// Lane offset `[m]` over s; positive to the left.
    #[inline]
    pub fn lane_offsets(&self) -> Range {
        self.lane_offsets.to_native()
    }
    /// Lane sections, ascending in s.
    #[inline]
    pub fn sections(&self) -> Range {
        self.sections.to_native()
    }
    /// Road types, ascending in s.
    #[inline]
    pub fn types(&self) -> Range {
        self.types.to_native()
    }
    /// Line of the road's start tag, from 1.
    #[inline]
    pub fn line(&self) -> u32 {
        self.line.to_native()
    }
    /// Column of the road's start tag in bytes, from 1.
    #[inline]
    pub fn column(&self) -> u32 {
        self.column.to_native()
    }
    /// 0 none, 1 road, 2 junction, 3 unresolved road, 4 unresolved junction.
    #[inline]
    pub fn predecessor_kind(&self) -> u8 {
        self.predecessor_kind
    }
    /// As `predecessor_kind`.
    #[inline]
    pub fn successor_kind(&self) -> u8 {
        self.successor_kind
    }
    /// End of the linked road: 0 none, 1 start, 2 end.
    #[inline]
    pub fn predecessor_contact(&self) -> u8 {
        self.predecessor_contact
    }
    /// As `predecessor_contact`.
    #[inline]
    pub fn successor_contact(&self) -> u8 {
        self.successor_contact
    }
    /// 0 right-hand traffic, 1 left-hand traffic.
    #[inline]
    pub fn rule(&self) -> u8 {
        self.rule
    }
}

impl ArchivedGeometryRow {
    /// `[m]` Start on the road.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// `[m]` Start point relative to the local origin.
    #[inline]
    pub fn x(&self) -> f64 {
        self.x.to_native()
    }
    /// `[m]` Start point relative to the local origin.
    #[inline]
    pub fn y(&self) -> f64 {
        self.y.to_native()
    }
    /// `[rad]` Start heading as written.
    #[inline]
    pub fn hdg(&self) -> f64 {
        self.hdg.to_native()
    }
    /// Cosine of `hdg`.
    #[inline]
    pub fn cos(&self) -> f64 {
        self.cos.to_native()
    }
    /// Sine of `hdg`.
    #[inline]
    pub fn sin(&self) -> f64 {
        self.sin.to_native()
    }
    /// `[m]` Length as written.
    #[inline]
    pub fn length(&self) -> f64 {
        self.length.to_native()
    }
    /// The primitive's own numbers, then its pieces.
    #[inline]
    pub fn coefficients(&self) -> Range {
        self.coefficients.to_native()
    }
    /// `[m]` Bound on the distance of an evaluated point from the exact curve.
    #[inline]
    pub fn error(&self) -> f32 {
        self.error.to_native()
    }
    /// 0 line, 1 arc, 2 spiral, 3 poly3, 4 paramPoly3, 5 transformed into another plane.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
    /// paramPoly3/@pRange: 0 not given, 1 arcLength, 2 normalized.
    #[inline]
    pub fn parameter_range(&self) -> u8 {
        self.parameter_range
    }
}

impl ArchivedCubicRow {
    /// `[m]` Start on the road (lane records too).
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// Constant part.
    #[inline]
    pub fn a(&self) -> f64 {
        self.a.to_native()
    }
    /// Linear part.
    #[inline]
    pub fn b(&self) -> f64 {
        self.b.to_native()
    }
    /// Quadratic part.
    #[inline]
    pub fn c(&self) -> f64 {
        self.c.to_native()
    }
    /// Cubic part.
    #[inline]
    pub fn d(&self) -> f64 {
        self.d.to_native()
    }
}

impl ArchivedRoadTypeRow {
    /// `[m]` Start on the road.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// `[m/s]` Speed limit, if `speed_kind` is 1; else 0.
    #[inline]
    pub fn speed(&self) -> f64 {
        self.speed.to_native()
    }
    /// type/@country.
    #[inline]
    pub fn country(&self) -> u32 {
        self.country.to_native()
    }
    /// Road type code.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
    /// 0 none, 1 value, 2 no limit, 3 undefined, 4 stated and unknown.
    #[inline]
    pub fn speed_kind(&self) -> u8 {
        self.speed_kind
    }
}

impl ArchivedSectionRow {
    /// `[m]` Start on the road.
    #[inline]
    pub fn s_start(&self) -> f64 {
        self.s_start.to_native()
    }
    /// `[m]` End: start of the next section, or the road's length.
    #[inline]
    pub fn s_end(&self) -> f64 {
        self.s_end.to_native()
    }
    /// `[m]` x from which points count, relative to the local origin: none of them is smaller.
    #[inline]
    pub fn x(&self) -> f32 {
        self.x.to_native()
    }
    /// `[m]` y from which points count, relative to the local origin.
    #[inline]
    pub fn y(&self) -> f32 {
        self.y.to_native()
    }
    /// `[m]` z from which points count.
    #[inline]
    pub fn z(&self) -> f32 {
        self.z.to_native()
    }
    /// The road.
    #[inline]
    pub fn road(&self) -> u32 {
        self.road.to_native()
    }
    /// Lanes from left to right: falling lane numbers, lane 0 among them.
    #[inline]
    pub fn lanes(&self) -> Range {
        self.lanes.to_native()
    }
    /// Number of the section in its road, from 0.
    #[inline]
    pub fn number(&self) -> u32 {
        self.number.to_native()
    }
    /// Its first element of `point_stations`.
    #[inline]
    pub fn first_station(&self) -> u32 {
        self.first_station.to_native()
    }
    /// Bytes of `points` that a point takes: as many as its bits need, at least 1.
    #[inline]
    pub fn point_bytes(&self) -> u8 {
        self.point_bytes
    }
    /// Bits of a point's station.
    #[inline]
    pub fn station_bits(&self) -> u8 {
        self.station_bits
    }
    /// Bits of a point's x.
    #[inline]
    pub fn x_bits(&self) -> u8 {
        self.x_bits
    }
    /// Bits of a point's y.
    #[inline]
    pub fn y_bits(&self) -> u8 {
        self.y_bits
    }
    /// Bits of a point's z.
    #[inline]
    pub fn z_bits(&self) -> u8 {
        self.z_bits
    }
    /// Step of x and y: 2 to the power of this less 128, in metres.
    #[inline]
    pub fn xy_step(&self) -> u8 {
        self.xy_step
    }
    /// Step of z in the same way.
    #[inline]
    pub fn z_step(&self) -> u8 {
        self.z_step
    }
}

impl ArchivedLaneRow {
    /// The lane's section.
    #[inline]
    pub fn section(&self) -> u32 {
        self.section.to_native()
    }
    /// First row of `cubics` with its width `[m]` over s, or the outer border's t `[m]` where flag 4 is set.
    #[inline]
    pub fn first_width(&self) -> u32 {
        self.first_width.to_native()
    }
    /// First of its nodes in `lane_nodes`: pieces in driving order, then, if the lane is travelled the other way too, those of the other way. None for lane 0.
    #[inline]
    pub fn first_node(&self) -> u32 {
        self.first_node.to_native()
    }
    /// First byte in `points` of its centre line, then of its outer border; for lane 0 of the shifted reference line.
    #[inline]
    pub fn first_byte(&self) -> u32 {
        self.first_byte.to_native()
    }
    /// First of its road marks in `road_marks`, which many lanes share.
    #[inline]
    pub fn first_mark(&self) -> u32 {
        self.first_mark.to_native()
    }
    /// OpenDRIVE's lane number: positive left, negative right.
    #[inline]
    pub fn number(&self) -> i32 {
        self.number.to_native()
    }
    /// Number of width records.
    #[inline]
    pub fn width_count(&self) -> u16 {
        self.width_count.to_native()
    }
    /// Number of nodes.
    #[inline]
    pub fn node_count(&self) -> u16 {
        self.node_count.to_native()
    }
    /// Number of points of the centre line, which ascend in s; 0 for lane 0.
    #[inline]
    pub fn center_count(&self) -> u16 {
        self.center_count.to_native()
    }
    /// Number of points of the border, which follow.
    #[inline]
    pub fn border_count(&self) -> u16 {
        self.border_count.to_native()
    }
    /// Sections of the road since the one that the lane is written in: not 0 where it goes on beside a section of the other side alone.
    #[inline]
    pub fn continues(&self) -> u16 {
        self.continues.to_native()
    }
    /// Lane type code.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
    /// 1 travels towards +s, 2 level, 4 widths hold borders, 8 also travels the other way, 16 for walking alone: walked both ways, 32 is of a temporary layer.
    #[inline]
    pub fn flags(&self) -> u8 {
        self.flags
    }
}

impl ArchivedLaneBlockRow {
    /// Bit i: the block's lane i has another section than the lane before it, the next one. The lowest bit is 0.
    #[inline]
    pub fn section_starts(&self) -> u64 {
        self.section_starts.to_native()
    }
    /// Bit i: that section has another road than the section before it, the next one. The lowest bit is 0.
    #[inline]
    pub fn road_starts(&self) -> u64 {
        self.road_starts.to_native()
    }
    /// Section of the block's first lane.
    #[inline]
    pub fn section(&self) -> u32 {
        self.section.to_native()
    }
    /// Road of that section.
    #[inline]
    pub fn road(&self) -> u32 {
        self.road.to_native()
    }
}

impl ArchivedLaneLengthRow {
    /// `[m]` Where a record begins, on the road.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// `[m]` Length of the centre line in plan view from the lane's start to there.
    #[inline]
    pub fn length(&self) -> f64 {
        self.length.to_native()
    }
    /// The lane.
    #[inline]
    pub fn lane(&self) -> u32 {
        self.lane.to_native()
    }
}

impl ArchivedLaneSpeedRow {
    /// `[m]` Start on the road.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// `[m/s]` Speed limit, if `kind` is 1; else 0.
    #[inline]
    pub fn max(&self) -> f64 {
        self.max.to_native()
    }
    /// The lane.
    #[inline]
    pub fn lane(&self) -> u32 {
        self.lane.to_native()
    }
    /// 1 value, 2 no limit, 3 undefined, 4 stated and unknown.
    #[inline]
    pub fn kind(&self) -> u32 {
        self.kind.to_native()
    }
}

impl ArchivedJunctionRow {
    /// junction/@id verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// junction/@name.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// Connections in file order.
    #[inline]
    pub fn connections(&self) -> Range {
        self.connections.to_native()
    }
    /// Line of the start tag, from 1.
    #[inline]
    pub fn line(&self) -> u32 {
        self.line.to_native()
    }
    /// Column of the start tag in bytes, from 1.
    #[inline]
    pub fn column(&self) -> u32 {
        self.column.to_native()
    }
    /// 0 default, 1 direct, 2 virtual, 3 crossing.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
}

impl ArchivedConnectionRow {
    /// connection/@id verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// Road that leads in.
    #[inline]
    pub fn incoming_road(&self) -> u32 {
        self.incoming_road.to_native()
    }
    /// Connecting road, or the linked road of a direct junction.
    #[inline]
    pub fn connecting_road(&self) -> u32 {
        self.connecting_road.to_native()
    }
    /// Lane links as written.
    #[inline]
    pub fn lane_links(&self) -> Range {
        self.lane_links.to_native()
    }
    /// End of the connecting road that touches the incoming one: 0 none, 1 start, 2 end.
    #[inline]
    pub fn contact(&self) -> u8 {
        self.contact
    }
}

impl ArchivedConnectionLaneLinkRow {
    /// Lane number on the incoming road.
    #[inline]
    pub fn from(&self) -> i32 {
        self.from.to_native()
    }
    /// Lane number on the connecting or linked road.
    #[inline]
    pub fn to(&self) -> i32 {
        self.to.to_native()
    }
}
