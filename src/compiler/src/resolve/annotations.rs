//! What is known of annotations once the document has been read.

use crate::draft::Draft;
use crate::without::Extra;
use mapd_archive::{AnnotationKind, AnnotationOwner, IncludedFileRow, NONE};
use mapd_xodr::source::Places;
use std::collections::HashMap;
use std::path::Path;

/// Names files, gives objects the rows that they will have, orders annotations by their owners and writes them. `folder` is that of
/// the document.
pub(crate) fn finish(draft: &mut Draft, places: &Places, folder: Option<&Path>) {
    included_files(draft, places, folder);
    if draft.rows.annotations.is_empty() {
        return;
    }
    let objects = draft.objects.rows();
    let names: Vec<u32> = draft.rows.included_files.iter().map(|file| file.name).collect();
    let mut all = std::mem::take(&mut *draft.rows.annotations);
    for row in &mut all {
        if row.owner_kind == AnnotationOwner::Object.code() {
            row.owner = objects.get(row.owner as usize).copied().unwrap_or(NONE);
        }
        if row.kind == AnnotationKind::SourceFile.code() {
            let file = usize::from(row.file).wrapping_sub(1);
            row.name = names.get(file).copied().unwrap_or_default();
        }
    }
    all.sort_by_key(|row| (row.owner_kind, row.owner));
    draft.rows.set_annotations(&all);
}

/// A row for each file that was included.
fn included_files(draft: &mut Draft, places: &Places, folder: Option<&Path>) {
    let files = if draft.without.has(Extra::Includes) { 1 } else { places.files() };
    let real = folder.and_then(|folder| folder.canonicalize().ok());
    for number in 1..files {
        let start = Places::start(u16::try_from(number).unwrap_or(u16::MAX), 0);
        let place = places.place(start);
        let at = places.included_at(start).unwrap_or_default();
        let position = places.position(at);
        let name = relative(&place.file, [folder, real.as_deref()]);
        draft.rows.included_files.push(IncludedFileRow {
            name: draft.strings.add(&name),
            line: position.line,
            column: position.column,
            file: places.file_at(at).into(),
        });
    }
    if draft.without.has(Extra::Includes) {
        draft.rows.annotations.iter_mut().for_each(|row| row.file = 0);
    }
}

/// Names the junctions of groups, of those with one id the first.
pub(crate) fn groups(draft: &mut Draft) {
    if draft.rows.junction_group_members.is_empty() {
        return;
    }
    let mut by_id = HashMap::new();
    for (row, junction) in (0..).zip(draft.rows.junctions.iter()) {
        by_id.entry(junction.id).or_insert(row);
    }
    for member in draft.rows.junction_group_members.iter_mut() {
        member.junction = by_id.get(&member.id).copied().unwrap_or(NONE);
    }
}

/// A file's path below the first of the folders that it lies in, else its name alone: where a map lies is no matter of its
/// archive's.
fn relative(file: &str, folders: [Option<&Path>; 2]) -> String {
    let path = Path::new(file);
    let below = folders.into_iter().flatten().find_map(|folder| path.strip_prefix(folder).ok());
    let name = || path.file_name().map_or(path, Path::new);
    below.unwrap_or_else(name).to_string_lossy().replace('\\', "/")
}
