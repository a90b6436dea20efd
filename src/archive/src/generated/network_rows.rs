//! Row types of the tables of the network.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use crate::table::Range;
use bytemuck::{Pod, Zeroable};
use rkyv::Archive;

/// Exactly one row: facts about the whole map.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct MapRow {
    /// `[m]` x of the local origin: geometry lies relative to it. 0 unless coordinates are large.
    pub origin_x: f64,
    /// `[m]` y of the local origin.
    pub origin_y: f64,
    /// `[m]` Smallest x of any lane, inertial.
    pub min_x: f64,
    /// `[m]` Smallest y of any lane, inertial.
    pub min_y: f64,
    /// `[m]` Smallest z of any lane, inertial.
    pub min_z: f64,
    /// `[m]` Largest x of any lane, inertial.
    pub max_x: f64,
    /// `[m]` Largest y of any lane, inertial.
    pub max_y: f64,
    /// `[m]` Largest z of any lane, inertial.
    pub max_z: f64,
    /// `[m]` header/@north as written; 0 if absent.
    pub stated_north: f64,
    /// `[m]` header/@south as written; 0 if absent.
    pub stated_south: f64,
    /// `[m]` header/@east as written; 0 if absent.
    pub stated_east: f64,
    /// `[m]` header/@west as written; 0 if absent.
    pub stated_west: f64,
    /// `[m]` Sum of the roads' lengths.
    pub road_length: f64,
    /// `[m]` Largest distance of a lane's centre line from its polyline.
    pub index_tolerance: f64,
    /// `[m]` Largest distance of a lane's border from its polyline.
    pub bound_tolerance: f64,
    /// `[m]` header/offset/@x as it is applied: a point of the map lies at R(`offset_hdg`)·(x, y) + offset in the plane of the projection. 0 if absent.
    pub offset_x: f64,
    /// `[m]` header/offset/@y as it is applied.
    pub offset_y: f64,
    /// `[m]` header/offset/@z as it is applied.
    pub offset_z: f64,
    /// `[rad]` header/offset/@hdg.
    pub offset_hdg: f64,
    /// `[deg]` Smallest latitude of any lane on WGS 84, rounded to 1e-9 degrees; 0 unless `has_geodetic_bounds`.
    pub south: f64,
    /// `[deg]` Largest latitude.
    pub north: f64,
    /// `[deg]` Longitude of the western edge, −180 to 180.
    pub west: f64,
    /// `[deg]` Longitude of the eastern edge; beyond 180 where the map crosses the antimeridian.
    pub east: f64,
    /// header/@name.
    pub name: u32,
    /// header/@version.
    pub version: u32,
    /// header/@date.
    pub date: u32,
    /// header/@vendor.
    pub vendor: u32,
    /// header/geoReference verbatim.
    pub geo_reference: u32,
    /// The georeference as PROJ parameters, only such as are understood; empty if there is none that can be used.
    pub projection: u32,
    /// header/@revMajor; 0 if absent.
    pub rev_major: u16,
    /// header/@revMinor; 0 if absent.
    pub rev_minor: u16,
    /// How the georeference is written: 0 absent or empty, 1 PROJ, 2 PROJ parameters without projection, 3 EPSG code, 4 WKT 1, 5 WKT 2, 6 other.
    pub geo_reference_form: u8,
    /// Sign of header/offset as it is applied: 0 as written, 1 turned (offset fields hold the turned values).
    pub offset_sign: u8,
    /// 1 where the map's place on Earth is known.
    pub has_geodetic_bounds: u8,
    /// 0.
    pub reserved: u8,
}
const _: () = assert!(size_of::<MapRow>() == 216 && size_of::<ArchivedMapRow>() == 216);

/// One row for a map that was compiled into another frame than its file's (`--crs`), else none. `projection` of the map is then the target, its offset 0.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct FileFrameRow {
    /// `[m]` header/offset/@x as it was applied before the transformation: as `offset_x` of the map.
    pub offset_x: f64,
    /// `[m]` header/offset/@y as it was applied.
    pub offset_y: f64,
    /// `[m]` header/offset/@z as it was applied.
    pub offset_z: f64,
    /// `[rad]` header/offset/@hdg.
    pub offset_hdg: f64,
    /// `[m]` Smallest x of any lane in the file's frame.
    pub min_x: f64,
    /// `[m]` Smallest y of any lane in the file's frame.
    pub min_y: f64,
    /// `[m]` Smallest z of any lane in the file's frame.
    pub min_z: f64,
    /// `[m]` Largest x of any lane in the file's frame.
    pub max_x: f64,
    /// `[m]` Largest y of any lane in the file's frame.
    pub max_y: f64,
    /// `[m]` Largest z of any lane in the file's frame.
    pub max_z: f64,
    /// `[m]` z of the map minus z as written.
    pub height_shift: f64,
    /// `[m]` Bound on the distance of a point of a reference line from the exact image of that point of the file.
    pub error: f64,
    /// `[m]` Bound on the difference between `height_shift` and the shift at any place of the map.
    pub height_error: f64,
    /// Smallest distance in the map per distance in the file, along any direction at any reference line.
    pub scale_min: f64,
    /// Largest distance in the map per distance in the file.
    pub scale_max: f64,
    /// The file's georeference as PROJ parameters, only such as are understood.
    pub projection: u32,
    /// The target frame as it was asked for.
    pub target: u32,
}
const _: () = assert!(size_of::<FileFrameRow>() == 128 && size_of::<ArchivedFileFrameRow>() == 128);

/// Features that a reader must know to read this map: one row for each bit of the header's `must_understand`. A reader that does not know a feature can name it.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct FeatureRow {
    /// Number of the bit, from 0.
    pub bit: u32,
    /// First release of mapd that reads it: major, minor, patch.
    pub release: [u16; 3],
    /// 0.
    pub reserved: u16,
    /// Name in UTF-8, then zeros.
    pub name: [u8; 32],
}
const _: () = assert!(size_of::<FeatureRow>() == 44 && size_of::<ArchivedFeatureRow>() == 44);

/// One row per road, in file order. The row number is the RoadId.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct RoadRow {
    /// `[m]` Length of the reference line as written.
    pub length: f64,
    /// road/@id verbatim.
    pub id: u32,
    /// road/@name.
    pub name: u32,
    /// Junction that the road belongs to as a connecting road.
    pub junction: u32,
    /// Row of the road or junction at s = 0, by `predecessor_kind`; u32::MAX if none.
    pub predecessor: u32,
    /// Row of the road or junction at s = length, by `successor_kind`; u32::MAX if none.
    pub successor: u32,
    /// Plan view, ascending in s.
    pub geometries: Range,
    /// Elevation `[m]` over s.
    pub elevations: Range,
    /// Superelevation `[rad]` over s; positive lifts the left side.
    pub superelevations: Range,
    /// Lane offset `[m]` over s; positive to the left.
    pub lane_offsets: Range,
    /// Lane sections, ascending in s.
    pub sections: Range,
    /// Road types, ascending in s.
    pub types: Range,
    /// Line of the road's start tag, from 1.
    pub line: u32,
    /// Column of the road's start tag in bytes, from 1.
    pub column: u32,
    /// 0 none, 1 road, 2 junction, 3 unresolved road, 4 unresolved junction.
    pub predecessor_kind: u8,
    /// As `predecessor_kind`.
    pub successor_kind: u8,
    /// End of the linked road: 0 none, 1 start, 2 end.
    pub predecessor_contact: u8,
    /// As `predecessor_contact`.
    pub successor_contact: u8,
    /// 0 right-hand traffic, 1 left-hand traffic.
    pub rule: u8,
    /// 0.
    pub reserved: [u8; 7],
}
const _: () = assert!(size_of::<RoadRow>() == 96 && size_of::<ArchivedRoadRow>() == 96);

/// Plan-view geometries, as written or transformed into the target frame, with the values that their evaluation needs (OpenDRIVE 1.8.1, 9.2).
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct GeometryRow {
    /// `[m]` Start on the road.
    pub s: f64,
    /// `[m]` Start point relative to the local origin.
    pub x: f64,
    /// `[m]` Start point relative to the local origin.
    pub y: f64,
    /// `[rad]` Start heading as written.
    pub hdg: f64,
    /// Cosine of `hdg`.
    pub cos: f64,
    /// Sine of `hdg`.
    pub sin: f64,
    /// `[m]` Length as written.
    pub length: f64,
    /// The primitive's own numbers, then its pieces.
    pub coefficients: Range,
    /// `[m]` Bound on the distance of an evaluated point from the exact curve.
    pub error: f32,
    /// 0 line, 1 arc, 2 spiral, 3 poly3, 4 paramPoly3, 5 transformed into another plane.
    pub kind: u8,
    /// paramPoly3/@pRange: 0 not given, 1 arcLength, 2 normalized.
    pub parameter_range: u8,
    /// 0.
    pub reserved: [u8; 2],
}
const _: () = assert!(size_of::<GeometryRow>() == 72 && size_of::<ArchivedGeometryRow>() == 72);

/// Cubic records a + b·ds + c·ds² + d·ds³ with ds = s − `s`; each holds until the next of its range.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct CubicRow {
    /// `[m]` Start on the road (lane records too).
    pub s: f64,
    /// Constant part.
    pub a: f64,
    /// Linear part.
    pub b: f64,
    /// Quadratic part.
    pub c: f64,
    /// Cubic part.
    pub d: f64,
}
const _: () = assert!(size_of::<CubicRow>() == 40 && size_of::<ArchivedCubicRow>() == 40);

/// road/type records.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct RoadTypeRow {
    /// `[m]` Start on the road.
    pub s: f64,
    /// `[m/s]` Speed limit, if `speed_kind` is 1; else 0.
    pub speed: f64,
    /// type/@country.
    pub country: u32,
    /// Road type code.
    pub kind: u8,
    /// 0 none, 1 value, 2 no limit, 3 undefined, 4 stated and unknown.
    pub speed_kind: u8,
    /// 0.
    pub reserved: [u8; 2],
}
const _: () = assert!(size_of::<RoadTypeRow>() == 24 && size_of::<ArchivedRoadTypeRow>() == 24);

/// Lane sections, road by road, ascending in s, with the frame of their lanes' points (`points`).
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SectionRow {
    /// `[m]` Start on the road.
    pub s_start: f64,
    /// `[m]` End: start of the next section, or the road's length.
    pub s_end: f64,
    /// `[m]` x from which points count, relative to the local origin: none of them is smaller.
    pub x: f32,
    /// `[m]` y from which points count, relative to the local origin.
    pub y: f32,
    /// `[m]` z from which points count.
    pub z: f32,
    /// The road.
    pub road: u32,
    /// Lanes from left to right: falling lane numbers, lane 0 among them.
    pub lanes: Range,
    /// Number of the section in its road, from 0.
    pub number: u32,
    /// Its first element of `point_stations`.
    pub first_station: u32,
    /// Bytes of `points` that a point takes: as many as its bits need, at least 1.
    pub point_bytes: u8,
    /// Bits of a point's station.
    pub station_bits: u8,
    /// Bits of a point's x.
    pub x_bits: u8,
    /// Bits of a point's y.
    pub y_bits: u8,
    /// Bits of a point's z.
    pub z_bits: u8,
    /// Step of x and y: 2 to the power of this less 128, in metres.
    pub xy_step: u8,
    /// Step of z in the same way.
    pub z_step: u8,
    /// 0.
    pub reserved: u8,
}
const _: () = assert!(size_of::<SectionRow>() == 56 && size_of::<ArchivedSectionRow>() == 56);

/// Lanes, section by section, from left to right. The row number is the LaneId. Lane 0 has no width; its border is the shifted reference line.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct LaneRow {
    /// The lane's section.
    pub section: u32,
    /// First row of `cubics` with its width `[m]` over s, or the outer border's t `[m]` where flag 4 is set.
    pub first_width: u32,
    /// First of its nodes in `lane_nodes`: pieces in driving order, then, if the lane is travelled the other way too, those of the other way. None for lane 0.
    pub first_node: u32,
    /// First byte in `points` of its centre line, then of its outer border; for lane 0 of the shifted reference line.
    pub first_byte: u32,
    /// First of its road marks in `road_marks`, which many lanes share.
    pub first_mark: u32,
    /// OpenDRIVE's lane number: positive left, negative right.
    pub number: i32,
    /// Number of width records.
    pub width_count: u16,
    /// Number of nodes.
    pub node_count: u16,
    /// Number of points of the centre line, which ascend in s; 0 for lane 0.
    pub center_count: u16,
    /// Number of points of the border, which follow.
    pub border_count: u16,
    /// Sections of the road since the one that the lane is written in: not 0 where it goes on beside a section of the other side alone.
    pub continues: u16,
    /// Lane type code.
    pub kind: u8,
    /// 1 travels towards +s, 2 level, 4 widths hold borders, 8 also travels the other way, 16 for walking alone: walked both ways, 32 is of a temporary layer.
    pub flags: u8,
}
const _: () = assert!(size_of::<LaneRow>() == 36 && size_of::<ArchivedLaneRow>() == 36);

/// A row for each 64 lanes: the sections and roads that their rows lead to, so that queries can read all of these rows ahead at once. It decides nothing. Where roads of neighbouring sections do not follow each other, as behind temporary layers, it is wrong.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct LaneBlockRow {
    /// Bit i: the block's lane i has another section than the lane before it, the next one. The lowest bit is 0.
    pub section_starts: u64,
    /// Bit i: that section has another road than the section before it, the next one. The lowest bit is 0.
    pub road_starts: u64,
    /// Section of the block's first lane.
    pub section: u32,
    /// Road of that section.
    pub road: u32,
}
const _: () = assert!(size_of::<LaneBlockRow>() == 24 && size_of::<ArchivedLaneBlockRow>() == 24);

/// How long lanes of very many records are up to some of these, by lane and s: a length along one is a difference, and what lies before and behind. It decides nothing.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct LaneLengthRow {
    /// `[m]` Where a record begins, on the road.
    pub s: f64,
    /// `[m]` Length of the centre line in plan view from the lane's start to there.
    pub length: f64,
    /// The lane.
    pub lane: u32,
    /// 0.
    pub reserved: u32,
}
const _: () = assert!(size_of::<LaneLengthRow>() == 24 && size_of::<ArchivedLaneLengthRow>() == 24);

/// lane/speed records, by lane and s.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct LaneSpeedRow {
    /// `[m]` Start on the road.
    pub s: f64,
    /// `[m/s]` Speed limit, if `kind` is 1; else 0.
    pub max: f64,
    /// The lane.
    pub lane: u32,
    /// 1 value, 2 no limit, 3 undefined, 4 stated and unknown.
    pub kind: u32,
}
const _: () = assert!(size_of::<LaneSpeedRow>() == 24 && size_of::<ArchivedLaneSpeedRow>() == 24);

/// One row per junction, in file order. The row number is the JunctionId.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct JunctionRow {
    /// junction/@id verbatim.
    pub id: u32,
    /// junction/@name.
    pub name: u32,
    /// Connections in file order.
    pub connections: Range,
    /// Line of the start tag, from 1.
    pub line: u32,
    /// Column of the start tag in bytes, from 1.
    pub column: u32,
    /// 0 default, 1 direct, 2 virtual, 3 crossing.
    pub kind: u8,
    /// 0.
    pub reserved: [u8; 3],
}
const _: () = assert!(size_of::<JunctionRow>() == 28 && size_of::<ArchivedJunctionRow>() == 28);

/// junction/connection.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ConnectionRow {
    /// connection/@id verbatim.
    pub id: u32,
    /// Road that leads in.
    pub incoming_road: u32,
    /// Connecting road, or the linked road of a direct junction.
    pub connecting_road: u32,
    /// Lane links as written.
    pub lane_links: Range,
    /// End of the connecting road that touches the incoming one: 0 none, 1 start, 2 end.
    pub contact: u8,
    /// 0.
    pub reserved: [u8; 3],
}
const _: () = assert!(size_of::<ConnectionRow>() == 24 && size_of::<ArchivedConnectionRow>() == 24);

/// junction/connection/laneLink as written.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ConnectionLaneLinkRow {
    /// Lane number on the incoming road.
    pub from: i32,
    /// Lane number on the connecting or linked road.
    pub to: i32,
}
const _: () = assert!(
    size_of::<ConnectionLaneLinkRow>() == 8 && size_of::<ArchivedConnectionLaneLinkRow>() == 8
);
