//! Row types of the tables of what is derived from the network and lies beside it.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use crate::table::Range;
use bytemuck::{Pod, Zeroable};
use rkyv::Archive;

/// Lateral profiles of the roads that have any besides superelevation, by road.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SurfaceRow {
    /// The road.
    pub road: u32,
    /// Stations of the lateral shape, ascending in s (OpenDRIVE 1.8.1, 10.5.3).
    pub shapes: Range,
    /// Crossfall `[rad]` over s left of the reference line; positive falls outwards (OpenDRIVE 1.4, 1.5).
    pub crossfall_left: Range,
    /// Crossfall `[rad]` over s right of the reference line; positive falls outwards.
    pub crossfall_right: Range,
    /// t `[m]` over s from which the strips count.
    pub strip_offset: Range,
    /// Strips of the cross-section surface (OpenDRIVE 1.8.1, 10.6).
    pub strips: Range,
}
const _: () = assert!(size_of::<SurfaceRow>() == 44 && size_of::<ArchivedSurfaceRow>() == 44);

/// Stations of lateral shapes.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ShapeStationRow {
    /// `[m]` s on the road.
    pub s: f64,
    /// Height `[m]` over t: each record starts at the t `[m]` in its field `s`.
    pub records: Range,
}
const _: () =
    assert!(size_of::<ShapeStationRow>() == 16 && size_of::<ArchivedShapeStationRow>() == 16);

/// Strips of cross-section surfaces; coefficients count from the strip's inner edge, signed as t is.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SurfaceStripRow {
    /// Width `[m]` over s; empty for a strip without an outer end.
    pub width: Range,
    /// Constant part `[m]` over s.
    pub constant: Range,
    /// Linear part over s.
    pub linear: Range,
    /// Quadratic part `[1/m]` over s.
    pub quadratic: Range,
    /// Cubic part `[1/m²]` over s.
    pub cubic: Range,
    /// strip/@id: 1 and 2 to the left, −1 and −2 to the right, from the middle outwards.
    pub id: i32,
    /// 0 absolute, 1 relative to the inner strip's outer edge.
    pub mode: u32,
}
const _: () =
    assert!(size_of::<SurfaceStripRow>() == 48 && size_of::<ArchivedSurfaceStripRow>() == 48);

/// lane/height records, by lane and s: the lane's height above the road's surface, linear between its edges.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct LaneHeightRow {
    /// `[m]` Start on the road.
    pub s: f64,
    /// `[m]` Height at the edge nearer to lane 0.
    pub inner: f64,
    /// `[m]` Height at the edge away from lane 0.
    pub outer: f64,
    /// The lane.
    pub lane: u32,
    /// 0.
    pub reserved: u32,
}
const _: () = assert!(size_of::<LaneHeightRow>() == 32 && size_of::<ArchivedLaneHeightRow>() == 32);

/// lane/material records, by lane and s.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct LaneMaterialRow {
    /// `[m]` Start on the road.
    pub s: f64,
    /// Friction coefficient; −1 if not given.
    pub friction: f64,
    /// Roughness as written; −1 if not given.
    pub roughness: f64,
    /// The lane.
    pub lane: u32,
    /// material/@surface.
    pub surface: u32,
}
const _: () =
    assert!(size_of::<LaneMaterialRow>() == 32 && size_of::<ArchivedLaneMaterialRow>() == 32);

/// Elevation grids of junctions, by junction (OpenDRIVE 1.8.1, 12.8): inside, their heights replace those of the connecting roads.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ElevationGridRow {
    /// `[m]` Start of the junction's reference line, relative to the local origin.
    pub x: f64,
    /// `[m]` Start of the junction's reference line, relative to the local origin.
    pub y: f64,
    /// Cosine of the line's heading.
    pub cos: f64,
    /// Sine of the line's heading.
    pub sin: f64,
    /// `[m]` First row's place on the line.
    pub s_start: f64,
    /// `[m]` Distance between rows, and between points of a row.
    pub spacing: f64,
    /// The junction.
    pub junction: u32,
    /// Rows along the line.
    pub rows: Range,
    /// Joints at which the roads' own heights pass into the grid's.
    pub transitions: Range,
    /// 0.
    pub reserved: u32,
}
const _: () =
    assert!(size_of::<ElevationGridRow>() == 72 && size_of::<ArchivedElevationGridRow>() == 72);

/// A row of an elevation grid: heights from its point on the reference line outwards.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct GridRowRow {
    /// `[m]` Height on the reference line.
    pub center: f64,
    /// Heights to the left `[m]`.
    pub left: Range,
    /// Heights to the right `[m]`.
    pub right: Range,
}
const _: () = assert!(size_of::<GridRowRow>() == 24 && size_of::<ArchivedGridRowRow>() == 24);

/// Joints of junctions with an elevation grid, in the direction that has the junction on the left.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct GridTransitionRow {
    /// `[m]` One end of the joint, relative to the local origin.
    pub start_x: f64,
    /// `[m]` One end of the joint.
    pub start_y: f64,
    /// `[m]` The other end of the joint.
    pub end_x: f64,
    /// `[m]` The other end of the joint.
    pub end_y: f64,
    /// `[m]` Length of the transition into the junction.
    pub length: f64,
}
const _: () =
    assert!(size_of::<GridTransitionRow>() == 40 && size_of::<ArchivedGridTransitionRow>() == 40);

/// lane/roadMark records, each sequence once. A record describes the mark on a lane's outer border, or on lane 0's own line for lane 0, up to the next record of the sequence.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct RoadMarkRow {
    /// `[m]` Start, relative to the start of the section in which the lane is written.
    pub s_offset: f64,
    /// How it looks.
    pub style: u32,
    /// 1 for the last of a sequence.
    pub last: u8,
    /// 0.
    pub reserved: [u8; 3],
}
const _: () = assert!(size_of::<RoadMarkRow>() == 16 && size_of::<ArchivedRoadMarkRow>() == 16);

/// Styles of road marks, each once, in the order of their first use.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct RoadMarkStyleRow {
    /// `[m]` roadMark/@width; −1 if not given.
    pub width: f64,
    /// `[m]` roadMark/@height; −1 if not given.
    pub height: f64,
    /// roadMark/@material.
    pub material: u32,
    /// roadMark/type/@name.
    pub name: u32,
    /// Lines of the pattern or the explicit mark, in file order.
    pub lines: Range,
    /// Lateral shift `[m]` of the mark's middle over s (OpenDRIVE 1.8.1, 11.10.4); a style with sway belongs to one mark.
    pub sway: Range,
    /// Kind: 0 not given, 1 none, 2 solid, 3 broken, 4 solid solid, 5 solid broken, 6 broken solid, 7 broken broken, 8 botts dots, 9 grass, 10 curb, 11 custom, 12 edge.
    pub kind: u8,
    /// 0 not given, 1 standard, 2 bold.
    pub weight: u8,
    /// 0 not given, 1 standard, 2 blue, 3 green, 4 red, 5 white, 6 yellow, 7 black, 8 orange, 9 violet.
    pub color: u8,
    /// 0 not given, 1 increase, 2 decrease, 3 both, 4 none.
    pub lane_change: u8,
    /// 0.
    pub reserved: [u8; 4],
}
const _: () =
    assert!(size_of::<RoadMarkStyleRow>() == 48 && size_of::<ArchivedRoadMarkStyleRow>() == 48);

/// Lines of road marks: of a pattern (roadMark/type/line), repeated every `length` + `space`, or explicit (roadMark/explicit/line), once.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct RoadMarkLineRow {
    /// `[m]` Length of a line.
    pub length: f64,
    /// `[m]` Gap to the next one; −1 for an explicit line.
    pub space: f64,
    /// `[m]` Of the line's middle from the lane's border.
    pub t_offset: f64,
    /// `[m]` Start of the first line after the mark's start.
    pub s_offset: f64,
    /// `[m]` Width; −1 if not given.
    pub width: f64,
    /// Who may cross, seen from inside: 0 not given, 1 no passing, 2 caution, 3 none.
    pub rule: u8,
    /// As `color` of a style.
    pub color: u8,
    /// 0.
    pub reserved: [u8; 6],
}
const _: () =
    assert!(size_of::<RoadMarkLineRow>() == 48 && size_of::<ArchivedRoadMarkLineRow>() == 48);

/// Temporary lanes of roads (OpenDRIVE 1.9), by road. Their sections and lanes are rows like others, which no road's own sections, no node of the lane graph and no leaf of the index names.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct LaneLayerRow {
    /// The road.
    pub road: u32,
    /// Sections, ascending in s; there may be gaps between them.
    pub sections: Range,
    /// Lane offset of the layer `[m]` over s.
    pub lane_offsets: Range,
}
const _: () = assert!(size_of::<LaneLayerRow>() == 20 && size_of::<ArchivedLaneLayerRow>() == 20);

/// Exactly one row: facts about the whole lane graph.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct GraphRow {
    /// `[m]` Unit of `landmark_lengths`.
    pub length_step: f64,
    /// `[s]` Unit of `landmark_times`.
    pub time_step: f64,
    /// `[m]` What a change of lane counts in `landmark_lengths`.
    pub change_length: f64,
    /// `[s]` What a change of lane counts in `landmark_times`.
    pub change_time: f64,
    /// Number of strongly connected components.
    pub components: u32,
    /// Number of places in `landmark_lengths` and `landmark_times`.
    pub bounds: u32,
    /// Number of landmarks; 0 if the map has none.
    pub landmarks: u32,
    /// 0.
    pub reserved: u32,
}
const _: () = assert!(size_of::<GraphRow>() == 48 && size_of::<ArchivedGraphRow>() == 48);

/// Nodes of the lane graph: a lane, or a piece of one, travelled in one direction. Lane by lane.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct LaneNodeRow {
    /// The lane.
    pub lane: u32,
    /// Strongly connected component, numbered in topological order of the condensation.
    pub component: u32,
    /// Place in `landmark_lengths` and `landmark_times` of the node's anchor: the node itself, or one from which a way without a change of lane leads to it; u32::MAX if no motor vehicle may use the node.
    pub bound: u32,
    /// `[m]` Smaller end of the piece, from the section's start.
    pub s_from: f32,
    /// `[m]` Length of the centre line in plan view.
    pub length: f32,
    /// `[s]` What a route by time counts for it: its length at the recorded speed limits, at 50 km/h where none is recorded, at 130 km/h where there is none.
    pub time: f32,
    /// Node beside it, in driving direction to the left, that travels the same way: its row is this one's plus this less 32768; 32768 if there is none.
    pub left: u16,
    /// Node beside it, in driving direction to the right, that travels the same way, in the same way.
    pub right: u16,
    /// Length of the way from the anchor, in the graph's `length_step`, rounded up; 0 for the anchor itself.
    pub anchor_length: u16,
    /// Time from the anchor, in `time_step`, rounded up.
    pub anchor_time: u16,
    /// Bit i: vehicle class i may use it.
    pub access: u16,
    /// 1 travels towards +s, 2 change to the left allowed, 4 change to the right allowed.
    pub flags: u8,
    /// 0.
    pub reserved: u8,
}
const _: () = assert!(size_of::<LaneNodeRow>() == 36 && size_of::<ArchivedLaneNodeRow>() == 36);

/// Facts about each entry of `successors`, and the element of the file that states it. Length, time and access are those of the node that the edge leaves.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct EdgeRow {
    /// Line of the link, from 1; 0 where no link is needed.
    pub line: u32,
    /// Column of the link in bytes, from 1.
    pub column: u32,
    /// 0 for the document itself, else the number of the included file.
    pub file: u16,
    /// 0 within a lane, 1 link inside a road, 2 link over a road's end, 3 lane link of a connection, 4 implied by a connection without lane links, 5 at a virtual junction, 6 end of a path across a road.
    pub kind: u8,
    /// 1 closes a loop: without these edges the graph has no cycle.
    pub flags: u8,
}
const _: () = assert!(size_of::<EdgeRow>() == 12 && size_of::<ArchivedEdgeRow>() == 12);

/// Lanes of one junction whose areas meet, by `lane`; each pair is stored twice, once for each lane.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ConflictRow {
    /// The lane.
    pub lane: u32,
    /// The lane that it conflicts with.
    pub other: u32,
    /// Start of the common area on `lane`, from its section's start, rounded down to steps: of the least power of two metres above a 65,535th of the section's length.
    pub from: u16,
    /// End of the common area on `lane`, rounded up; not beyond the section's end.
    pub to: u16,
    /// Start of the common area on `other`, in steps of its section, rounded down.
    pub other_from: u16,
    /// End of the common area on `other`, rounded up; not beyond the section's end.
    pub other_to: u16,
    /// 0 cross, 1 merge, 2 overlap, 3 crossing of roads.
    pub kind: u8,
    /// Who goes first: 0 `lane` yields, 1 `lane` has priority, 2 lights decide, 3 nothing decides; 4 for lanes that come from one entry, and where roads cross.
    pub relation: u8,
    /// Why: 0 none, 1 lights, 2 stop sign, 3 yield sign, 4 priority road, 5 junction priority, 6 turn across oncoming traffic, 7 from the right.
    pub reason: u8,
    /// 0.
    pub reserved: u8,
}
const _: () = assert!(size_of::<ConflictRow>() == 20 && size_of::<ArchivedConflictRow>() == 20);
