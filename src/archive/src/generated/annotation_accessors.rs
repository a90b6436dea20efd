//! Reading the rows of what files say besides.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::annotation_rows::*;
use crate::table::Range;

impl ArchivedAnnotationRow {
    /// Row of the owner in the table of `owner_kind`, minus the row of the annotation before, modulo 2^32; the document counts as row 0.
    #[inline]
    pub fn owner(&self) -> u32 {
        self.owner.to_native()
    }
    /// Where it stands below the owner, such as `planView/geometry[2]`; empty for the owner itself.
    #[inline]
    pub fn path(&self) -> u32 {
        self.path.to_native()
    }
    /// Of user data its code; of an element its tag; of an attribute its name; of an include the file as written.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// Value of user data or of an attribute; else empty.
    #[inline]
    pub fn value(&self) -> u32 {
        self.value.to_native()
    }
    /// Of user data what stands inside, of an element the whole of it, as written; empty where there is nothing or it was larger than the limit.
    #[inline]
    pub fn text(&self) -> u32 {
        self.text.to_native()
    }
    /// Line of the element's start tag, from 1, minus the line of the annotation before, modulo 2^32.
    #[inline]
    pub fn line(&self) -> u32 {
        self.line.to_native()
    }
    /// Column of the start tag in bytes, from 1.
    #[inline]
    pub fn column(&self) -> u32 {
        self.column.to_native()
    }
    /// 0 for the document itself, else the number of the included file, from 1: its row in `included_files` plus 1.
    #[inline]
    pub fn file(&self) -> u16 {
        self.file.to_native()
    }
    /// 0 user data, 1 data quality, 2 an include that was not followed, 3 an element that the standard does not have there, 4 an element of another namespace, 5 an attribute, 6 the owner itself, which stands in an included file.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
    /// 0 the document, 1 road, 2 lane section, 3 lane, 4 junction, 5 connection, 6 object, 7 signal, 8 controller, 9 junction group, 10 station.
    #[inline]
    pub fn owner_kind(&self) -> u8 {
        self.owner_kind
    }
}

impl ArchivedAnnotationBlockRow {
    /// Row of the owner of the annotation before; 0 in the first block.
    #[inline]
    pub fn owner(&self) -> u32 {
        self.owner.to_native()
    }
    /// Line of the annotation before; 0 in the first block.
    #[inline]
    pub fn line(&self) -> u32 {
        self.line.to_native()
    }
    /// Number of annotations in the block: 256 in all but the last.
    #[inline]
    pub fn count(&self) -> u16 {
        self.count.to_native()
    }
    /// `owner_kind` of the annotation before; 0 in the first block.
    #[inline]
    pub fn owner_kind(&self) -> u8 {
        self.owner_kind
    }
}

impl ArchivedIncludedFileRow {
    /// Path relative to the folder of the document, where it lies there, else the file's name.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// Line of the include, from 1.
    #[inline]
    pub fn line(&self) -> u32 {
        self.line.to_native()
    }
    /// Column of the include in bytes, from 1.
    #[inline]
    pub fn column(&self) -> u32 {
        self.column.to_native()
    }
    /// Number of the file that the include stands in: 0 the document itself.
    #[inline]
    pub fn file(&self) -> u32 {
        self.file.to_native()
    }
}

impl ArchivedLaneVisibilityRow {
    /// `[m]` Start on the road.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// `[m]` How far one sees ahead; −1 if not given.
    #[inline]
    pub fn forward(&self) -> f64 {
        self.forward.to_native()
    }
    /// `[m]` How far one sees back; −1 if not given.
    #[inline]
    pub fn back(&self) -> f64 {
        self.back.to_native()
    }
    /// `[m]` How far one sees to the left; −1 if not given.
    #[inline]
    pub fn left(&self) -> f64 {
        self.left.to_native()
    }
    /// `[m]` How far one sees to the right; −1 if not given.
    #[inline]
    pub fn right(&self) -> f64 {
        self.right.to_native()
    }
    /// The lane.
    #[inline]
    pub fn lane(&self) -> u32 {
        self.lane.to_native()
    }
}

impl ArchivedLaneRuleRow {
    /// `[m]` Start on the road.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// The lane.
    #[inline]
    pub fn lane(&self) -> u32 {
        self.lane.to_native()
    }
    /// The rule in words.
    #[inline]
    pub fn value(&self) -> u32 {
        self.value.to_native()
    }
}

impl ArchivedJunctionGroupRow {
    /// junctionGroup/@id verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// junctionGroup/@name.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// Its junctions, in file order.
    #[inline]
    pub fn members(&self) -> Range {
        self.members.to_native()
    }
    /// Lanes of a roundabout's ring; empty for other groups.
    #[inline]
    pub fn ring(&self) -> Range {
        self.ring.to_native()
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
    /// 0 not given, 1 roundabout, 2 unknown, 3 complex junction, 4 highway interchange.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
}

impl ArchivedJunctionGroupMemberRow {
    /// The group.
    #[inline]
    pub fn group(&self) -> u32 {
        self.group.to_native()
    }
    /// The junction, where the map has it.
    #[inline]
    pub fn junction(&self) -> u32 {
        self.junction.to_native()
    }
    /// junctionReference/@junction verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
}
