//! What is left out of the map.

use crate::draft::Draft;
use crate::quarantine::{QuarantinedContent, QuarantinedPart, Treatment};
use mapd_archive::{QuarantinedContentRow, QuarantinedFileRow, QuarantinedRow};

/// Appends what is not in the map as the document has it.
pub(crate) fn store(draft: &mut Draft, parts: &[QuarantinedPart]) {
    for part in parts {
        let [min_x, min_y, max_x, max_y] = part.extent.unwrap_or_default();
        let row = QuarantinedRow {
            min_x,
            min_y,
            max_x,
            max_y,
            length: part.length,
            id: draft.strings.add(&part.id),
            owner: draft.strings.add(&part.owner),
            rule: draft.strings.add(part.rule),
            message: draft.strings.add(&part.message),
            line: part.line,
            column: part.column,
            kind: part.kind.code(),
            treatment: u8::from(part.treatment == Treatment::ReferenceLine),
            has_extent: u8::from(part.extent.is_some()),
            owner_kind: part.owner_kind.code(),
            reserved: [0; 4],
        };
        let part_row = draft.rows.quarantined.len() as u32;
        draft.rows.quarantined.push(row);
        // Folders differ from machine to machine; the archive does not.
        let file = std::path::Path::new(&*part.file).file_name();
        if let Some(file) = file.map(|name| name.to_string_lossy()) {
            let file = draft.strings.add(&file);
            draft.rows.quarantined_files.push(QuarantinedFileRow { part: part_row, file });
        }
        for QuarantinedContent { kind, id } in &part.contents {
            let id = draft.strings.add(id);
            let row =
                QuarantinedContentRow { id, part: part_row, kind: kind.code(), reserved: [0; 3] };
            draft.rows.quarantined_contents.push(row);
        }
    }
}
