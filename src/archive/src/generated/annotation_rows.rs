//! Row types of the tables of what files say besides.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use crate::table::Range;
use bytemuck::{Pod, Zeroable};
use rkyv::Archive;

/// Data of the file that has no table of its own: data of applications, quality of data, elements that the standard does not have, and attributes that are not used otherwise. A row is the difference of an annotation from the one before, and equal rows are stored once; `annotation_numbers` has their order.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct AnnotationRow {
    /// Row of the owner in the table of `owner_kind`, minus the row of the annotation before, modulo 2^32; the document counts as row 0.
    pub owner: u32,
    /// Where it stands below the owner, such as `planView/geometry[2]`; empty for the owner itself.
    pub path: u32,
    /// Of user data its code; of an element its tag; of an attribute its name; of an include the file as written.
    pub name: u32,
    /// Value of user data or of an attribute; else empty.
    pub value: u32,
    /// Of user data what stands inside, of an element the whole of it, as written; empty where there is nothing or it was larger than the limit.
    pub text: u32,
    /// Line of the element's start tag, from 1, minus the line of the annotation before, modulo 2^32.
    pub line: u32,
    /// Column of the start tag in bytes, from 1.
    pub column: u32,
    /// 0 for the document itself, else the number of the included file, from 1: its row in `included_files` plus 1.
    pub file: u16,
    /// 0 user data, 1 data quality, 2 an include that was not followed, 3 an element that the standard does not have there, 4 an element of another namespace, 5 an attribute, 6 the owner itself, which stands in an included file.
    pub kind: u8,
    /// 0 the document, 1 road, 2 lane section, 3 lane, 4 junction, 5 connection, 6 object, 7 signal, 8 controller, 9 junction group, 10 station.
    pub owner_kind: u8,
}
const _: () = assert!(size_of::<AnnotationRow>() == 32 && size_of::<ArchivedAnnotationRow>() == 32);

/// A row for each 256 annotations: the values that the first of them is relative to, so that the annotations of an owner are found without reading all.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct AnnotationBlockRow {
    /// Row of the owner of the annotation before; 0 in the first block.
    pub owner: u32,
    /// Line of the annotation before; 0 in the first block.
    pub line: u32,
    /// Number of annotations in the block: 256 in all but the last.
    pub count: u16,
    /// `owner_kind` of the annotation before; 0 in the first block.
    pub owner_kind: u8,
    /// 0.
    pub reserved: u8,
}
const _: () =
    assert!(size_of::<AnnotationBlockRow>() == 12 && size_of::<ArchivedAnnotationBlockRow>() == 12);

/// Files that the document includes, in that order.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct IncludedFileRow {
    /// Path relative to the folder of the document, where it lies there, else the file's name.
    pub name: u32,
    /// Line of the include, from 1.
    pub line: u32,
    /// Column of the include in bytes, from 1.
    pub column: u32,
    /// Number of the file that the include stands in: 0 the document itself.
    pub file: u32,
}
const _: () =
    assert!(size_of::<IncludedFileRow>() == 16 && size_of::<ArchivedIncludedFileRow>() == 16);

/// lane/visibility records, by lane and s (OpenDRIVE 1.4, 1.5).
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct LaneVisibilityRow {
    /// `[m]` Start on the road.
    pub s: f64,
    /// `[m]` How far one sees ahead; −1 if not given.
    pub forward: f64,
    /// `[m]` How far one sees back; −1 if not given.
    pub back: f64,
    /// `[m]` How far one sees to the left; −1 if not given.
    pub left: f64,
    /// `[m]` How far one sees to the right; −1 if not given.
    pub right: f64,
    /// The lane.
    pub lane: u32,
    /// 0.
    pub reserved: u32,
}
const _: () =
    assert!(size_of::<LaneVisibilityRow>() == 48 && size_of::<ArchivedLaneVisibilityRow>() == 48);

/// lane/rule records, by lane and s.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct LaneRuleRow {
    /// `[m]` Start on the road.
    pub s: f64,
    /// The lane.
    pub lane: u32,
    /// The rule in words.
    pub value: u32,
}
const _: () = assert!(size_of::<LaneRuleRow>() == 16 && size_of::<ArchivedLaneRuleRow>() == 16);

/// Groups of junctions in file order: roundabouts and interchanges.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct JunctionGroupRow {
    /// junctionGroup/@id verbatim.
    pub id: u32,
    /// junctionGroup/@name.
    pub name: u32,
    /// Its junctions, in file order.
    pub members: Range,
    /// Lanes of a roundabout's ring; empty for other groups.
    pub ring: Range,
    /// Line of the start tag, from 1.
    pub line: u32,
    /// Column of the start tag in bytes, from 1.
    pub column: u32,
    /// 0 not given, 1 roundabout, 2 unknown, 3 complex junction, 4 highway interchange.
    pub kind: u8,
    /// 0.
    pub reserved: [u8; 3],
}
const _: () =
    assert!(size_of::<JunctionGroupRow>() == 36 && size_of::<ArchivedJunctionGroupRow>() == 36);

/// junctionGroup/junctionReference, by group.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct JunctionGroupMemberRow {
    /// The group.
    pub group: u32,
    /// The junction, where the map has it.
    pub junction: u32,
    /// junctionReference/@junction verbatim.
    pub id: u32,
}
const _: () = assert!(
    size_of::<JunctionGroupMemberRow>() == 12 && size_of::<ArchivedJunctionGroupMemberRow>() == 12
);
