//! Groups of junctions: roundabouts and interchanges.

use crate::extents::SourcePosition;
use crate::ids::LaneId;
use crate::junction::Junction;
use crate::map::Map;
use mapd_archive::{
    ArchivedJunctionGroupMemberRow, ArchivedJunctionGroupRow, JunctionGroupKind, string,
};

/// Junctions that belong together (OpenDRIVE 1.8.1, 12.14).
#[derive(Clone, Copy)]
pub struct JunctionGroup<'a> {
    pub(crate) map: Map<'a>,
    pub(crate) number: u32,
    row: &'a ArchivedJunctionGroupRow,
}

/// A junction of a group, as it is named.
#[derive(Clone, Copy)]
pub struct JunctionGroupMember<'a> {
    map: Map<'a>,
    row: &'a ArchivedJunctionGroupMemberRow,
}

impl<'a> JunctionGroup<'a> {
    fn new(map: Map<'a>, number: u32) -> Option<Self> {
        Some(Self { map, number, row: map.tables().junction_groups.get(number as usize)? })
    }

    /// OpenDRIVE's id, verbatim.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// OpenDRIVE's name.
    pub fn name(&self) -> &'a str {
        string(self.map.tables(), self.row.name())
    }

    /// What the group is.
    pub fn kind(&self) -> JunctionGroupKind {
        JunctionGroupKind::from_code(self.row.kind())
    }

    /// Its junctions, in file order.
    pub fn members(&self) -> impl ExactSizeIterator<Item = JunctionGroupMember<'a>> + use<'a> {
        let map = self.map;
        let rows = self.row.members().of(map.tables().junction_group_members).iter();
        rows.map(move |row| JunctionGroupMember { map, row })
    }

    /// Lanes of a roundabout's ring, in the order of their rows: those of its junctions, and of roads from one of its
    /// junctions to another, from which a way leads round within the group and back. Empty for other groups, and where no
    /// way leads round.
    pub fn ring(&self) -> impl ExactSizeIterator<Item = LaneId> + use<'a> {
        let content = self.map.content();
        let lanes = self.row.ring().of(self.map.tables().ring_lanes).iter();
        lanes.map(move |row| LaneId::new(*row, content))
    }

    /// Line and column of the start tag, from 1.
    pub fn source_position(&self) -> SourcePosition {
        SourcePosition { line: self.row.line(), column: self.row.column() }
    }
}

impl<'a> JunctionGroupMember<'a> {
    /// Id of the junction as written.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// The junction, where the map has it.
    pub fn junction(&self) -> Option<Junction<'a>> {
        Junction::new(self.map, self.row.junction())
    }
}

impl<'a> Map<'a> {
    /// All junction groups in file order.
    pub fn junction_groups(&self) -> impl ExactSizeIterator<Item = JunctionGroup<'a>> + use<'a> {
        let map = *self;
        let rows = map.tables().junction_groups.iter().enumerate();
        rows.map(move |(number, row)| JunctionGroup { map, number: number as u32, row })
    }
}

impl<'a> Junction<'a> {
    /// Groups that name it, in file order: most junctions are in none, few in more than one.
    pub fn groups(&self) -> impl Iterator<Item = JunctionGroup<'a>> + use<'a> {
        let (map, own) = (self.map, self.junction_id().row);
        let members = map.tables().junction_group_members.iter();
        members
            .filter(move |member| member.junction() == own)
            .filter_map(move |member| JunctionGroup::new(map, member.group()))
    }

    /// The first group that names it.
    pub fn group(&self) -> Option<JunctionGroup<'a>> {
        self.groups().next()
    }
}
