//! Row types of the tables of objects.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use crate::table::Range;
use bytemuck::{Pod, Zeroable};
use rkyv::Archive;

/// Objects by road, in file order; those of junctions after those of roads. The row number is the ObjectId.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ObjectRow {
    /// `[m]` x of the object's origin relative to the local origin.
    pub x: f64,
    /// `[m]` y of the object's origin relative to the local origin.
    pub y: f64,
    /// `[m]` z of the object's origin: elevation of the reference line at s plus zOffset.
    pub z: f64,
    /// `[m]` object/@s as written.
    pub s: f64,
    /// `[m]` object/@t as written.
    pub t: f64,
    /// `[rad]` Inertial heading of the object's u axis, in (−π, π].
    pub heading: f64,
    /// `[rad]` Inertial pitch, turned after the heading; positive lowers the front.
    pub pitch: f32,
    /// `[rad]` Inertial roll, turned last; positive lifts the left side.
    pub roll: f32,
    /// `[m]` object/@zOffset.
    pub z_offset: f32,
    /// `[m]` object/@length; 0 if absent.
    pub length: f32,
    /// `[m]` object/@width; 0 if absent.
    pub width: f32,
    /// `[m]` object/@height; 0 if absent.
    pub height: f32,
    /// `[m]` object/@radius; 0 if absent.
    pub radius: f32,
    /// `[m]` object/@validLength; 0 if absent.
    pub valid_length: f32,
    /// object/@id verbatim.
    pub id: u32,
    /// object/@name.
    pub name: u32,
    /// object/@type verbatim.
    pub kind: u32,
    /// object/@subtype.
    pub subtype: u32,
    /// Road that it is written in; none for an object of a junction.
    pub road: u32,
    /// Junction that it is written in.
    pub junction: u32,
    /// Outlines in file order.
    pub outlines: Range,
    /// Where the object stands if it is repeated; empty if it stands at its own place.
    pub copies: Range,
    /// Lanes that it belongs to.
    pub lanes: Range,
    /// Lane numbers that it is written to hold for.
    pub validities: Range,
    /// Line of the start tag, from 1.
    pub line: u32,
    /// Column of the start tag in bytes, from 1.
    pub column: u32,
    /// Class in mapd's vocabulary.
    pub class: u16,
    /// 0 point, 1 box, 2 cylinder, 3 outlines.
    pub shape: u8,
    /// Direction of travel that it is for: 0 both or not given, 1 along s, 2 against s.
    pub orientation: u8,
    /// 1 dynamic, 2 perpendicular to the road, 4 temporary, 8 invalidated, 16 s beyond the road and moved to its end.
    pub flags: u8,
    /// 0.
    pub reserved: [u8; 3],
}
const _: () = assert!(size_of::<ObjectRow>() == 152 && size_of::<ArchivedObjectRow>() == 152);

/// Outlines of objects, and of the areas that continuous repetitions sweep over.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ObjectOutlineRow {
    /// Corners in order; a closed outline leads from the last to the first.
    pub points: Range,
    /// outline/@id; u32::MAX if absent.
    pub id: u32,
    /// What fills it: 0 not given, 1 grass, 2 concrete, 3 cobble, 4 asphalt, 5 pavement, 6 gravel, 7 soil, 8 paint.
    pub fill: u8,
    /// Lane type code that it stands for; 0 if none.
    pub lane_type: u8,
    /// 1 outer, 2 closed.
    pub flags: u8,
    /// 0.
    pub reserved: u8,
}
const _: () =
    assert!(size_of::<ObjectOutlineRow>() == 16 && size_of::<ArchivedObjectOutlineRow>() == 16);

/// Corners in the frame of the object or copy that they belong to: u ahead, v to the left, z upwards.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ObjectPointRow {
    /// `[m]` Ahead of the origin.
    pub u: f32,
    /// `[m]` Left of the origin.
    pub v: f32,
    /// `[m]` Above the origin.
    pub z: f32,
    /// `[m]` Height of the object at this corner.
    pub height: f32,
}
const _: () =
    assert!(size_of::<ObjectPointRow>() == 16 && size_of::<ArchivedObjectPointRow>() == 16);

/// Places of repeated objects, object by object, in the order of the repetitions and of s.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ObjectCopyRow {
    /// `[m]` x of the origin relative to the local origin.
    pub x: f64,
    /// `[m]` y of the origin relative to the local origin.
    pub y: f64,
    /// `[m]` z of the origin.
    pub z: f64,
    /// `[m]` s on the road; of a swept copy, its start.
    pub s: f64,
    /// `[m]` Lateral place; of a swept copy at its start.
    pub t: f64,
    /// `[rad]` Inertial heading of the u axis; 0 for a swept copy.
    pub heading: f64,
    /// `[rad]` As in `objects`.
    pub pitch: f32,
    /// `[rad]` As in `objects`.
    pub roll: f32,
    /// `[m]` Length; of a swept copy along the road.
    pub length: f32,
    /// `[m]` Width; of a swept copy at its start.
    pub width: f32,
    /// `[m]` Height; of a swept copy at its start.
    pub height: f32,
    /// `[m]` Radius; 0 if it has none.
    pub radius: f32,
    /// The object.
    pub object: u32,
    /// What a swept copy covers; empty for the others, which have the object's own outlines.
    pub outlines: Range,
    /// As in `objects`.
    pub shape: u8,
    /// 1 swept.
    pub flags: u8,
    /// 0.
    pub reserved: u16,
}
const _: () = assert!(size_of::<ObjectCopyRow>() == 88 && size_of::<ArchivedObjectCopyRow>() == 88);

/// validity elements: lane numbers from the lower to the higher one.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct LaneRangeRow {
    /// Lowest lane number.
    pub from: i32,
    /// Highest lane number.
    pub to: i32,
}
const _: () = assert!(size_of::<LaneRangeRow>() == 8 && size_of::<ArchivedLaneRangeRow>() == 8);

/// Which lanes objects belong to, object by object, nearer lanes first.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ObjectLaneRow {
    /// The object.
    pub object: u32,
    /// The lane.
    pub lane: u32,
    /// `[m]` Where the object begins along the lane, from its section's start.
    pub s_from: f32,
    /// `[m]` Where it ends along the lane.
    pub s_to: f32,
    /// `[m]` Plan-view distance of the object from the lane's area; 0 on it.
    pub distance: f32,
    /// 0 by validity, 2 the object's area lies on the lane, 3 as the nearest lane; 1 is not used for objects.
    pub method: u8,
    /// 0.
    pub reserved: [u8; 3],
}
const _: () = assert!(size_of::<ObjectLaneRow>() == 24 && size_of::<ArchivedObjectLaneRow>() == 24);

/// Packed R-tree: node i of a level has children 16·i … 16·i + 15 on the next one; below the last level lie `object_index_items`. Boxes contain the objects' areas in plan view, are relative to the local origin and rounded outwards; unused places are empty boxes.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct BoxNodeRow {
    /// `[m]` Smallest x of each child.
    pub min_x: [f32; 16],
    /// `[m]` Smallest y of each child.
    pub min_y: [f32; 16],
    /// `[m]` Largest x of each child.
    pub max_x: [f32; 16],
    /// `[m]` Largest y of each child.
    pub max_y: [f32; 16],
}
const _: () = assert!(size_of::<BoxNodeRow>() == 256 && size_of::<ArchivedBoxNodeRow>() == 256);

/// Painted lines along objects, by object: along corners of an outline, or along a side.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ObjectMarkingRow {
    /// The object.
    pub object: u32,
    /// Outline that the corners are of; none where none is meant.
    pub outline: u32,
    /// Corners that the line runs along, in order; empty: the whole outline, or the side.
    pub corners: Range,
    /// marking/@color.
    pub color: u32,
    /// marking/@weight.
    pub weight: u32,
    /// parkingSpace/marking/@type of OpenDRIVE 1.4; empty elsewhere.
    pub kind: u32,
    /// `[m]` Width of the line; 0 if not given.
    pub width: f32,
    /// `[m]` Height of the line above the object's foot.
    pub z_offset: f32,
    /// `[m]` Length of a stroke; 0 if not given.
    pub line_length: f32,
    /// `[m]` Length of the gap between two strokes; 0: none.
    pub space_length: f32,
    /// `[m]` How far after its first corner the line begins.
    pub start_offset: f32,
    /// `[m]` How far before its last corner the line ends.
    pub stop_offset: f32,
    /// 0 not given, 1 left, 2 right, 3 front, 4 rear.
    pub side: u8,
    /// 0.
    pub reserved: [u8; 3],
}
const _: () =
    assert!(size_of::<ObjectMarkingRow>() == 56 && size_of::<ArchivedObjectMarkingRow>() == 56);

/// Frames along outlines of objects, by object.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ObjectBorderRow {
    /// The object.
    pub object: u32,
    /// The outline; none where the object has none of that id.
    pub outline: u32,
    /// Corners that the border runs along; empty: the whole outline.
    pub corners: Range,
    /// border/@type.
    pub kind: u32,
    /// `[m]` Width.
    pub width: f32,
}
const _: () =
    assert!(size_of::<ObjectBorderRow>() == 24 && size_of::<ArchivedObjectBorderRow>() == 24);

/// Lines that describe objects from inside, by object (OpenDRIVE 1.8.1, 13.8).
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ObjectSkeletonRow {
    /// The object.
    pub object: u32,
    /// Vertices in order.
    pub vertices: Range,
}
const _: () =
    assert!(size_of::<ObjectSkeletonRow>() == 12 && size_of::<ArchivedObjectSkeletonRow>() == 12);

/// Vertices of skeletons in the object's frame.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SkeletonVertexRow {
    /// `[m]` Ahead of the origin.
    pub u: f32,
    /// `[m]` Left of the origin.
    pub v: f32,
    /// `[m]` Above the origin.
    pub z: f32,
    /// `[m]` Radius of the tube around the line; 0 if not given.
    pub radius: f32,
    /// 1 the object meets the ground here.
    pub flags: u32,
}
const _: () =
    assert!(size_of::<SkeletonVertexRow>() == 20 && size_of::<ArchivedSkeletonVertexRow>() == 20);

/// Objects that are parking spaces, by object.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ParkingSpaceRow {
    /// The object.
    pub object: u32,
    /// parkingSpace/@restrictions.
    pub restrictions: u32,
    /// parkingSpace/@access.
    pub access: u32,
}
const _: () =
    assert!(size_of::<ParkingSpaceRow>() == 12 && size_of::<ArchivedParkingSpaceRow>() == 12);

/// Materials of objects, by object.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ObjectMaterialRow {
    /// The object.
    pub object: u32,
    /// material/@surface.
    pub surface: u32,
    /// material/@roadMarkColor.
    pub color: u32,
    /// Friction coefficient; −1 if not given.
    pub friction: f32,
    /// Roughness as written; −1 if not given.
    pub roughness: f32,
}
const _: () =
    assert!(size_of::<ObjectMaterialRow>() == 20 && size_of::<ArchivedObjectMaterialRow>() == 20);

/// Values that objects mean, by object: the limit that the name of a sign states.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ObjectValueRow {
    /// `[m/s, m or kg]` What the class means by its value.
    pub value: f64,
    /// The object.
    pub object: u32,
    /// Unit in which the number is read: objects state none. `SI`: whatever SI unit fits.
    pub unit: u32,
}
const _: () =
    assert!(size_of::<ObjectValueRow>() == 16 && size_of::<ArchivedObjectValueRow>() == 16);

/// Objects of one road that concern another, by road, in file order.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ObjectReferenceRow {
    /// `[m]` s on the referring road.
    pub s: f64,
    /// `[m]` Lateral place on the referring road.
    pub t: f64,
    /// The referring road.
    pub road: u32,
    /// The object; none if the map has none of this id.
    pub object: u32,
    /// Id of the object as written.
    pub id: u32,
    /// Lane numbers of the referring road that it holds for.
    pub validities: Range,
    /// `[m]` objectReference/@zOffset.
    pub z_offset: f32,
    /// `[m]` Length along s over which it holds; 0 if absent.
    pub valid_length: f32,
    /// As in `objects`.
    pub orientation: u8,
    /// 0.
    pub reserved: [u8; 3],
}
const _: () =
    assert!(size_of::<ObjectReferenceRow>() == 48 && size_of::<ArchivedObjectReferenceRow>() == 48);

/// Bridges and tunnels, by road, in file order.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct StructureRow {
    /// `[m]` Start on the road.
    pub s: f64,
    /// `[m]` Length along s.
    pub length: f64,
    /// The road.
    pub road: u32,
    /// Id verbatim.
    pub id: u32,
    /// Name.
    pub name: u32,
    /// bridge/@type or tunnel/@type.
    pub material: u32,
    /// Lane numbers that it is written to hold for.
    pub validities: Range,
    /// Degree of artificial light in a tunnel; −1 if not given.
    pub lighting: f32,
    /// Degree of daylight in a tunnel; −1 if not given.
    pub daylight: f32,
    /// Line of the start tag, from 1.
    pub line: u32,
    /// Column of the start tag in bytes, from 1.
    pub column: u32,
    /// 0 bridge, 1 tunnel.
    pub kind: u8,
    /// 0.
    pub reserved: [u8; 7],
}
const _: () = assert!(size_of::<StructureRow>() == 64 && size_of::<ArchivedStructureRow>() == 64);

/// Railway switches, by road, in file order.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SwitchRow {
    /// `[m]` s on the main track.
    pub main_s: f64,
    /// `[m]` s on the side track.
    pub side_s: f64,
    /// The road that it is written in.
    pub road: u32,
    /// switch/@id.
    pub id: u32,
    /// switch/@name.
    pub name: u32,
    /// Main track; none if the map does not have it.
    pub main: u32,
    /// Side track; none if the map does not have it.
    pub side: u32,
    /// Switch at the other end of the side track.
    pub partner: u32,
    /// 0 not given, 1 dynamic, 2 straight, 3 turn.
    pub position: u8,
    /// 0 not given, 1 along s, 2 against s.
    pub main_direction: u8,
    /// As `main_direction`.
    pub side_direction: u8,
    /// 0.
    pub reserved: [u8; 5],
}
const _: () = assert!(size_of::<SwitchRow>() == 48 && size_of::<ArchivedSwitchRow>() == 48);

/// Stations in file order.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct StationRow {
    /// station/@id.
    pub id: u32,
    /// station/@name.
    pub name: u32,
    /// station/@type.
    pub kind: u32,
    /// Platforms in file order.
    pub platforms: Range,
}
const _: () = assert!(size_of::<StationRow>() == 20 && size_of::<ArchivedStationRow>() == 20);

/// Platforms of stations.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct PlatformRow {
    /// platform/@id.
    pub id: u32,
    /// platform/@name.
    pub name: u32,
    /// Stretches of track beside it.
    pub segments: Range,
}
const _: () = assert!(size_of::<PlatformRow>() == 16 && size_of::<ArchivedPlatformRow>() == 16);

/// Stretches of track beside platforms.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct PlatformSegmentRow {
    /// `[m]` Start on the road.
    pub s_start: f64,
    /// `[m]` End on the road.
    pub s_end: f64,
    /// The road; none if the map does not have it.
    pub road: u32,
    /// Side of the road that the platform is on: 0 not given, 1 left, 2 right.
    pub side: u8,
    /// 0.
    pub reserved: [u8; 3],
}
const _: () =
    assert!(size_of::<PlatformSegmentRow>() == 24 && size_of::<ArchivedPlatformSegmentRow>() == 24);
