//! Where the map has holes: parts of the document with errors, which are not in the map as written.

use crate::extents::SourcePosition;
use crate::map::Map;
use crate::region::Region;
use glam::DVec2;
use mapd_archive::{ArchivedQuarantinedRow, QuarantinedKind, string};
use std::fmt;

/// A part of the document that is not in the map as written.
#[derive(Clone, Copy)]
pub struct Quarantined<'a> {
    map: Map<'a>,
    row: &'a ArchivedQuarantinedRow,
    number: u32,
}

impl<'a> Quarantined<'a> {
    /// What it is.
    pub fn kind(&self) -> QuarantinedKind {
        QuarantinedKind::from_code(self.row.kind())
    }

    /// OpenDRIVE's id, verbatim.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// Id of the road or junction that it belongs to; its own for a road or junction.
    pub fn owner(&self) -> &'a str {
        string(self.map.tables(), self.row.owner())
    }

    /// What the owner is; its own kind for a part of its own.
    pub fn owner_kind(&self) -> QuarantinedKind {
        QuarantinedKind::from_code(self.row.owner_kind())
    }

    /// Whether it is a road that is in the map as its bare reference line: it has no lanes and no way leads over it.
    pub fn is_reference_line(&self) -> bool {
        self.row.treatment() == 1
    }

    /// The rectangle around it; none where its place is not known.
    pub fn extent(&self) -> Option<Region> {
        let row = self.row;
        (row.has_extent() == 1).then(|| Region {
            low: DVec2::new(row.min_x(), row.min_y()),
            high: DVec2::new(row.max_x(), row.max_y()),
        })
    }

    /// Distance of a point from the extent in plan view `[m]`, 0 inside; none where its place is not known.
    pub fn distance(&self, point: DVec2) -> Option<f64> {
        let Region { low: min, high: max } = self.extent()?;
        let outside = (min - point).max(point - max).max(DVec2::ZERO);
        Some(outside.length())
    }

    /// Length of a road as written `[m]`; 0 for other parts.
    pub fn length(&self) -> f64 {
        self.row.length()
    }

    /// Id of the rule whose finding is the reason.
    pub fn rule(&self) -> &'a str {
        string(self.map.tables(), self.row.rule())
    }

    /// What the finding says.
    pub fn message(&self) -> &'a str {
        string(self.map.tables(), self.row.message())
    }

    /// Place of the finding in its file: line and column, from 1.
    pub fn source_position(&self) -> SourcePosition {
        SourcePosition { line: self.row.line(), column: self.row.column() }
    }

    /// Name of the included file that the finding stands in, without its folder; none for the document itself.
    pub fn source_file(&self) -> Option<&'a str> {
        let tables = self.map.tables();
        let row = tables.quarantined_files.iter().find(|row| row.part() == self.number)?;
        Some(string(tables, row.file()))
    }

    /// What is left out, why and where the reason stands, as people say it; `document` is what the document is called.
    pub fn explained<'d>(&self, document: &'d str) -> impl fmt::Display + use<'a, 'd> {
        Explained { part: *self, document }
    }
}

/// `object 12 of road 7`, and of a road or junction `road 7`.
impl fmt::Display for Quarantined<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.kind().name(), self.id())?;
        if self.owner_kind() != self.kind() {
            write!(f, " of {} {}", self.owner_kind().name(), self.owner())?;
        }
        Ok(())
    }
}

struct Explained<'a, 'd> {
    part: Quarantined<'a>,
    document: &'d str,
}

impl fmt::Display for Explained<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { part, document } = *self;
        let kept =
            if part.is_reference_line() { "has its reference line alone" } else { "is left out" };
        let file = part.source_file().unwrap_or(document);
        let SourcePosition { line, column } = part.source_position();
        let (rule, message) = (part.rule(), part.message());
        write!(f, "{part} {kept}: {rule} in {file}, line {line}, column {column}: {message}")
    }
}

impl<'a> Map<'a> {
    /// Parts of the document that are not in the map as written, in the order of the document. Empty for a map that was
    /// accepted whole.
    pub fn quarantined(&self) -> impl ExactSizeIterator<Item = Quarantined<'a>> + use<'a> {
        let map = *self;
        let rows = map.tables().quarantined.iter();
        rows.enumerate().map(move |(i, row)| Quarantined { map, row, number: i as u32 })
    }

    /// Why the map has no part of this kind and id, or has a road without its lanes: the part itself is in quarantine, or an object
    /// or signal belongs to a road or junction that is. Of several with that id the first in the document; none where the document
    /// has no such part. A lane is in quarantine with its road.
    ///
    /// Looks at all that is left out, one after the other: for the case that a part is not found.
    pub fn left_out(&self, kind: QuarantinedKind, id: &str) -> Option<Quarantined<'a>> {
        let tables = self.tables();
        let own = |part: &Quarantined<'a>| part.kind() == kind && part.id() == id;
        self.quarantined().find(own).or_else(|| {
            let mut contents = tables.quarantined_contents.iter();
            let content =
                contents.find(|row| row.kind() == kind.code() && string(tables, row.id()) == id)?;
            self.quarantined().nth(content.part() as usize)
        })
    }

    /// Those whose extent comes as near to a point as `radius` `[m]` in plan view: an answer about that place may lack them.
    pub fn quarantined_near(
        &self,
        point: DVec2,
        radius: f64,
    ) -> impl Iterator<Item = Quarantined<'a>> + use<'a> {
        let near = move |part: &Quarantined<'a>| part.distance(point).is_some_and(|d| d <= radius);
        self.quarantined().filter(near)
    }
}
