//! Junction groups, and what junctions note for those who look for owners.

use crate::draft::{Draft, between};
use crate::without::Extra;
use mapd_archive::{
    AnnotationOwner, JunctionGroupKind, JunctionGroupMemberRow, JunctionGroupRow, NONE, Range,
};
use mapd_xodr::source::NearPlaces;
use mapd_xodr::{Junction, JunctionGroup, JunctionGroupType, Text as _, Value as _};

impl Draft {
    /// Appends a group. Its junctions are resolved later.
    pub(crate) fn junction_group(&mut self, group: &JunctionGroup, places: &NearPlaces) {
        if self.without.has(Extra::JunctionGroups) {
            return;
        }
        let number = self.rows.junction_groups.len() as u32;
        let before = self.rows.junction_group_members.len();
        for member in &group.junction_reference {
            let id = self.strings.add(member.junction.text());
            let row = JunctionGroupMemberRow { group: number, junction: NONE, id };
            self.rows.junction_group_members.push(row);
        }
        let kind = match group.r#type.value() {
            None => JunctionGroupKind::None,
            Some(JunctionGroupType::Roundabout) => JunctionGroupKind::Roundabout,
            Some(JunctionGroupType::ComplexJunction) => JunctionGroupKind::ComplexJunction,
            Some(JunctionGroupType::HighwayInterchange) => JunctionGroupKind::HighwayInterchange,
            Some(_) => JunctionGroupKind::Other,
        };
        let at = places.position(group.span.start);
        let row = JunctionGroupRow {
            id: self.strings.add(group.id.text()),
            name: self.strings.add(group.name.text()),
            members: between(before, self.rows.junction_group_members.len()),
            ring: Range::default(),
            line: at.line,
            column: at.column,
            kind: kind.code(),
            reserved: [0; 3],
        };
        self.rows.junction_groups.push(row);
        self.annotate(group, (AnnotationOwner::JunctionGroup, number), "", places);
    }

    /// Notes which rows the connections of a junction will have that comes next.
    pub(crate) fn note_connections(&mut self, junction: &Junction) {
        let before = self.connections as u32;
        for (row, connection) in (before..).zip(&junction.connection) {
            self.owners.add(connection.span, AnnotationOwner::Connection, row);
        }
    }
}
