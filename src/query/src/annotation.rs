//! What files say of their parts beyond what has a query of its own: data of applications, quality of data, elements that the
//! standard does not have, attributes that nothing is built from, and which file a part came from.

use crate::extents::SourcePosition;
use crate::ids::{ControllerId, JunctionId, LaneId, LaneSectionId, ObjectId, RoadId, SignalId};
use crate::junction::{Connection, Junction};
use crate::junction_group::JunctionGroup;
use crate::lane::Lane;
use crate::map::Map;
use crate::objects::Object;
use crate::railway::Station;
use crate::road::Road;
use crate::section::LaneSection;
use crate::signals::{Controller, Signal};
use mapd_archive::{
    AnnotationEntry, AnnotationKind, AnnotationOwner, ArchivedIncludedFileRow, string,
};

/// Something that the file says of one of its parts.
#[derive(Clone, Copy)]
pub struct Annotation<'a> {
    map: Map<'a>,
    entry: AnnotationEntry<'a>,
}

/// What an annotation belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
#[non_exhaustive]
pub enum Annotated {
    /// The document: its header, and what stands in its root.
    Document,
    /// A road.
    Road(RoadId),
    /// A lane section.
    Section(LaneSectionId),
    /// A lane.
    Lane(LaneId),
    /// A junction.
    Junction(JunctionId),
    /// A connection, by its row in the archive's table.
    Connection(u32),
    /// An object.
    Object(ObjectId),
    /// A signal.
    Signal(SignalId),
    /// A controller.
    Controller(ControllerId),
    /// A junction group, by its row in the archive's table.
    JunctionGroup(u32),
    /// A station, by its row in the archive's table.
    Station(u32),
}

impl<'a> Annotation<'a> {
    /// What it is.
    pub fn kind(&self) -> AnnotationKind {
        AnnotationKind::from_code(self.entry.row.kind())
    }

    /// The part of the map that it belongs to: the innermost around it that has a row. None for a damaged archive.
    pub fn owner(&self) -> Option<Annotated> {
        let (row, content) = (self.entry.owner, self.map.content());
        Some(match AnnotationOwner::from_code(self.entry.row.owner_kind()) {
            AnnotationOwner::Document => Annotated::Document,
            AnnotationOwner::Road => Annotated::Road(RoadId::new(row, content)),
            AnnotationOwner::Section => Annotated::Section(LaneSectionId::new(row, content)),
            AnnotationOwner::Lane => Annotated::Lane(LaneId::new(row, content)),
            AnnotationOwner::Junction => Annotated::Junction(JunctionId::new(row, content)),
            AnnotationOwner::Connection => Annotated::Connection(row),
            AnnotationOwner::Object => Annotated::Object(ObjectId::new(row, content)),
            AnnotationOwner::Signal => Annotated::Signal(SignalId::new(row, content)),
            AnnotationOwner::Controller => Annotated::Controller(ControllerId::new(row, content)),
            AnnotationOwner::JunctionGroup => Annotated::JunctionGroup(row),
            AnnotationOwner::Station => Annotated::Station(row),
            _ => return None,
        })
    }

    /// Kind of the part that it belongs to.
    pub fn owner_kind(&self) -> AnnotationOwner {
        AnnotationOwner::from_code(self.entry.row.owner_kind())
    }

    /// Where it stands below the owner, such as `planView/geometry[2]`, numbers from 1; empty for the owner itself.
    pub fn path(&self) -> &'a str {
        string(self.map.tables(), self.entry.row.path())
    }

    /// Of user data its code; of an element its tag; of an attribute its name, empty for the text of an element; of an
    /// include the file as written; of a part from an included file that file's name.
    pub fn name(&self) -> &'a str {
        string(self.map.tables(), self.entry.row.name())
    }

    /// Value of user data or of an attribute; else empty.
    pub fn value(&self) -> &'a str {
        string(self.map.tables(), self.entry.row.value())
    }

    /// Of user data what stands inside, of an element the whole of it, as XML; empty where there is nothing.
    pub fn text(&self) -> &'a str {
        string(self.map.tables(), self.entry.row.text())
    }

    /// Line and column of the element's start tag, from 1, in [`Annotation::file`].
    pub fn source_position(&self) -> SourcePosition {
        SourcePosition { line: self.entry.line, column: self.entry.row.column() }
    }

    /// The included file that it stands in; none for the document itself.
    pub fn file(&self) -> Option<IncludedFile<'a>> {
        let number = usize::from(self.entry.row.file()).checked_sub(1)?;
        let row = self.map.tables().included_files.get(number)?;
        Some(IncludedFile { map: self.map, row })
    }
}

/// A file that the document included.
#[derive(Clone, Copy)]
pub struct IncludedFile<'a> {
    map: Map<'a>,
    row: &'a ArchivedIncludedFileRow,
}

impl<'a> IncludedFile<'a> {
    /// Path relative to the folder of the document; of a file elsewhere its name alone.
    pub fn name(&self) -> &'a str {
        string(self.map.tables(), self.row.name())
    }

    /// Line and column of the include, from 1, in [`IncludedFile::included_by`].
    pub fn source_position(&self) -> SourcePosition {
        SourcePosition { line: self.row.line(), column: self.row.column() }
    }

    /// The file that includes it; none for the document itself.
    pub fn included_by(&self) -> Option<IncludedFile<'a>> {
        let number = (self.row.file() as usize).checked_sub(1)?;
        let row = self.map.tables().included_files.get(number)?;
        Some(IncludedFile { map: self.map, row })
    }
}

impl<'a> Map<'a> {
    /// Everything that the file says besides, by the parts it belongs to: first the document's, then those of roads, lane
    /// sections, lanes, junctions and so on, in the order of [`AnnotationOwner`].
    pub fn annotations(&self) -> impl ExactSizeIterator<Item = Annotation<'a>> + use<'a> {
        let map = *self;
        map.tables().all_annotations().map(move |entry| Annotation { map, entry })
    }

    /// What is said of the document: its header, its licenses, and what stands in its root.
    pub fn document_annotations(&self) -> impl ExactSizeIterator<Item = Annotation<'a>> + use<'a> {
        annotations(*self, AnnotationOwner::Document, 0)
    }

    /// Files that the document included, in the order in which it did.
    pub fn included_files(&self) -> impl ExactSizeIterator<Item = IncludedFile<'a>> + use<'a> {
        let map = *self;
        map.tables().included_files.iter().map(move |row| IncludedFile { map, row })
    }
}

/// Annotations of a part, in file order.
pub(crate) fn annotations(
    map: Map<'_>,
    kind: AnnotationOwner,
    owner: u32,
) -> impl ExactSizeIterator<Item = Annotation<'_>> {
    let own = map.tables().annotations_of(kind.code(), owner);
    own.map(move |entry| Annotation { map, entry })
}

macro_rules! annotated {
    ($($type:ident, $kind:ident, $row:expr;)*) => { $(
        impl<'a> $type<'a> {
            /// What the file says of it besides, in file order: see [`Annotation`].
            pub fn annotations(&self) -> impl ExactSizeIterator<Item = Annotation<'a>> + use<'a> {
                let row: fn(&Self) -> u32 = $row;
                annotations(self.map, AnnotationOwner::$kind, row(self))
            }
        }
    )* };
}

annotated! {
    Road, Road, |road| road.road_id().row;
    LaneSection, Section, |section| section.section_id().row;
    Lane, Lane, |lane| lane.lane_id().row;
    Junction, Junction, |junction| junction.junction_id().row;
    Connection, Connection, |connection| connection.number;
    Object, Object, |object| object.object_id().row;
    Signal, Signal, |signal| signal.signal_id().row;
    Controller, Controller, |controller| controller.controller_id().row;
    JunctionGroup, JunctionGroup, |group| group.number;
    Station, Station, |station| station.number;
}
