//! Proving what files say besides: annotations are in the order of their owners, and these are there.

use crate::Tables;
use crate::annotation_codes::{AnnotationKind, AnnotationOwner};
use crate::annotations::{BLOCK, number_bits};
use crate::error::VerifyError;
use crate::verify::Check;

/// Owners are there, in order; files are those that were included; members of groups know their group.
pub(crate) fn annotations(tables: &Tables<'_>) -> Result<(), VerifyError> {
    are_whole(tables)?;
    let (mut before, mut line) = ((0, 0), 0);
    let count = tables.all_annotations().len();
    let mut all = tables.all_annotations();
    for row in 0..count {
        let check = Check { table: "annotation_numbers", row };
        let Some(entry) = all.next() else {
            return check.fail("", format!("a row below {}", tables.annotations.len()), "another");
        };
        if row % BLOCK == 0
            && let Some(block) = tables.annotation_blocks.get(row / BLOCK)
        {
            let (stated, last) =
                ((block.owner_kind(), block.owner(), block.line()), (before.0, before.1, line));
            if stated != last {
                let check = Check { table: "annotation_blocks", row: row / BLOCK };
                return check.fail("owner", format!("{last:?}"), format!("{stated:?}"));
            }
        }
        let annotation = entry.row;
        let kind = AnnotationOwner::from_code(annotation.owner_kind());
        // What a later release may annotate besides is not known here.
        if kind != AnnotationOwner::Unknown {
            check.reference("owner", entry.owner, owners(tables, kind), false)?;
        }
        let owner = (annotation.owner_kind(), entry.owner);
        if owner < before {
            return check.fail("owner", format!("at least {before:?}"), format!("{owner:?}"));
        }
        (before, line) = (owner, entry.line);
        let file = usize::from(annotation.file());
        let is_of_a_file = annotation.kind() == AnnotationKind::SourceFile.code();
        let files = tables.included_files.len();
        if file > files || (is_of_a_file && file == 0) {
            return check.fail("file", format!("at most {files}, of a source file above 0"), file);
        }
    }
    for (row, file) in tables.included_files.iter().enumerate() {
        // A file is included by one that was opened before it.
        if file.file() as usize > row {
            let check = Check { table: "included_files", row };
            return check.fail("file", format!("at most {row}"), file.file());
        }
    }
    for (number, group) in tables.junction_groups.iter().enumerate() {
        for (i, member) in group.members().of(tables.junction_group_members).iter().enumerate() {
            let row = group.members().first as usize + i;
            if member.group() as usize != number {
                let check = Check { table: "junction_group_members", row };
                return check.fail("group", number.to_string(), member.group());
            }
        }
    }
    Ok(())
}

/// Blocks are full but for the last, and have the bits that numbers need.
fn are_whole(tables: &Tables<'_>) -> Result<(), VerifyError> {
    let blocks = tables.annotation_blocks;
    for (row, block) in blocks.iter().enumerate() {
        let count = usize::from(block.count());
        let is_full = count == BLOCK || (row + 1 == blocks.len() && (1..BLOCK).contains(&count));
        if !is_full {
            let check = Check { table: "annotation_blocks", row };
            return check.fail("count", format!("{BLOCK}, in the last at most that"), count);
        }
    }
    let bits = tables.all_annotations().len() * number_bits(tables.annotations.len());
    let (bytes, check) = (bits.div_ceil(8), Check { table: "annotation_numbers", row: 0 });
    if tables.annotation_numbers.len() != bytes {
        return check.fail("", format!("{bytes} bytes"), tables.annotation_numbers.len());
    }
    Ok(())
}

/// Rows that owners of a kind may have.
fn owners(tables: &Tables<'_>, kind: AnnotationOwner) -> usize {
    match kind {
        AnnotationOwner::Document => 1,
        AnnotationOwner::Road => tables.roads.len(),
        AnnotationOwner::Section => tables.sections.len(),
        AnnotationOwner::Lane => tables.lanes.len(),
        AnnotationOwner::Junction => tables.junctions.len(),
        AnnotationOwner::Connection => tables.connections.len(),
        AnnotationOwner::Object => tables.objects.len(),
        AnnotationOwner::Signal => tables.signals.len(),
        AnnotationOwner::Controller => tables.controllers.len(),
        AnnotationOwner::JunctionGroup => tables.junction_groups.len(),
        AnnotationOwner::Station => tables.stations.len(),
        AnnotationOwner::Unknown => 0,
    }
}
