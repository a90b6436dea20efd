//! What annotations belong to.

use mapd_archive::{AnnotationOwner, AnnotationRow, RowMappings};
use mapd_xodr::Span;

/// An owner of annotations: its kind and row; of what gets its row later, its number among those that do.
pub(crate) type Owner = (AnnotationOwner, u32);

/// What got a row of its own since the last top-level element, by its start tag.
#[derive(Default)]
pub(crate) struct Owners(Vec<(u64, Owner)>);

impl Owners {
    /// Forgets all, before the next top-level element.
    pub(crate) fn clear(&mut self) {
        self.0.clear();
    }

    /// Notes the row of what a start tag begins.
    pub(crate) fn add(&mut self, span: Span, kind: AnnotationOwner, row: u32) {
        self.0.push((span.start, (kind, row)));
    }

    /// Orders them, before they are asked for.
    pub(crate) fn sort(&mut self) {
        self.0.sort_unstable_by_key(|(start, _)| *start);
    }

    /// What got a row by the start tag at this place.
    pub(crate) fn at(&self, start: u64) -> Option<Owner> {
        let at = self.0.binary_search_by_key(&start, |(start, _)| *start).ok()?;
        self.0.get(at).map(|(_, owner)| *owner)
    }
}

/// Numbers of what gets its rows later, before a part.
#[derive(Clone, Copy)]
pub(crate) struct Before {
    pub(crate) connections: usize,
    pub(crate) objects: usize,
    pub(crate) controllers: usize,
    pub(crate) stations: usize,
}

/// Lets rows that were appended refer to where their owners come to lie.
pub(crate) fn move_owners(rows: &mut [AnnotationRow], before: Before, moves: &RowMappings) {
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
