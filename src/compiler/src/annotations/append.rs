//! Appends the annotations of a part of a map to those of the whole.

use mapd_archive::{AnnotationOwner, AnnotationRow, Moves};

/// Numbers of what gets its rows later, before a part.
#[derive(Clone, Copy)]
pub(crate) struct Before {
    pub(crate) connections: usize,
    pub(crate) objects: usize,
    pub(crate) controllers: usize,
    pub(crate) stations: usize,
}

/// Lets rows that were appended refer to where their owners come to lie.
pub(crate) fn move_owners(rows: &mut [AnnotationRow], before: Before, moves: &Moves) {
    for row in rows {
        let behind = |count: usize| row.owner.wrapping_add(count as u32);
        row.owner = match AnnotationOwner::from_code(row.owner_kind) {
            AnnotationOwner::Road => moves.roads.row(row.owner),
            AnnotationOwner::Section => moves.sections.row(row.owner),
            AnnotationOwner::Lane => moves.lanes.row(row.owner),
            AnnotationOwner::Junction => moves.junctions.row(row.owner),
            AnnotationOwner::Signal => moves.signals.row(row.owner),
            AnnotationOwner::JunctionGroup => moves.junction_groups.row(row.owner),
            AnnotationOwner::Connection => behind(before.connections),
            AnnotationOwner::Object => behind(before.objects),
            AnnotationOwner::Controller => behind(before.controllers),
            AnnotationOwner::Station => behind(before.stations),
            _ => row.owner,
        };
    }
}
