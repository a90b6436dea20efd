//! Bridges, tunnels and references to objects of other roads.

use crate::extents::{LaneRange, SRange, SourcePosition};
use crate::map::Map;
use crate::objects::Object;
use crate::road::Road;
use mapd_archive::{
    ArchivedObjectReferenceRow, ArchivedStructureRow, Orientation, Range, StructureKind, string,
};

/// A bridge or tunnel (OpenDRIVE 1.8.1, 13.12 and 13.13).
#[derive(Clone, Copy)]
pub struct Structure<'a> {
    map: Map<'a>,
    row: &'a ArchivedStructureRow,
}

/// Lane numbers from the lower to the higher one.
pub(crate) fn validities<'a>(
    map: Map<'a>,
    range: Range,
) -> impl ExactSizeIterator<Item = LaneRange> + use<'a> {
    range
        .of(map.tables().lane_ranges)
        .iter()
        .map(|range| LaneRange { from: range.from(), to: range.to() })
}

impl<'a> Structure<'a> {
    /// Which of the two.
    pub fn kind(&self) -> StructureKind {
        StructureKind::from_code(self.row.kind())
    }

    /// OpenDRIVE's id, verbatim.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// Name for people.
    pub fn name(&self) -> &'a str {
        string(self.map.tables(), self.row.name())
    }

    /// `type` as written: concrete, steel, brick, wood; standard, underpass.
    pub fn type_name(&self) -> &'a str {
        string(self.map.tables(), self.row.material())
    }

    /// The road; none in a damaged archive.
    pub fn road(&self) -> Option<Road<'a>> {
        Road::new(self.map, self.row.road())
    }

    /// From where to where on the road `[m]`: s, ascending, as written.
    pub fn s_range(&self) -> SRange {
        SRange { low: self.row.s(), high: self.row.s() + self.row.length() }
    }

    /// Lane numbers that it is written to hold for; none: for all lanes.
    pub fn validities(&self) -> impl ExactSizeIterator<Item = LaneRange> + use<'a> {
        validities(self.map, self.row.validities())
    }

    /// Degree of artificial light in a tunnel, 0 to 1, if given.
    pub fn lighting(&self) -> Option<f64> {
        Some(f64::from(self.row.lighting())).filter(|n| *n >= 0.0)
    }

    /// Degree of daylight in a tunnel, 0 to 1, if given.
    pub fn daylight(&self) -> Option<f64> {
        Some(f64::from(self.row.daylight())).filter(|n| *n >= 0.0)
    }

    /// Place in its file: line and column of the start tag, from 1.
    pub fn source_position(&self) -> SourcePosition {
        SourcePosition { line: self.row.line(), column: self.row.column() }
    }
}

/// An object of another road that concerns a road too (OpenDRIVE 1.8.1, 13.11).
#[derive(Clone, Copy)]
pub struct ObjectReference<'a> {
    map: Map<'a>,
    row: &'a ArchivedObjectReferenceRow,
}

impl<'a> ObjectReference<'a> {
    /// The object; none where the map has none of this id.
    pub fn object(&self) -> Option<Object<'a>> {
        Object::new(self.map, self.row.object())
    }

    /// Id of the object as written.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// The road that refers to it; none in a damaged archive.
    pub fn road(&self) -> Option<Road<'a>> {
        Road::new(self.map, self.row.road())
    }

    /// s on the referring road `[m]`.
    pub fn s(&self) -> f64 {
        self.row.s()
    }

    /// t on the referring road `[m]`.
    pub fn t(&self) -> f64 {
        self.row.t()
    }

    /// Height above the referring road's reference line `[m]`.
    pub fn z_offset(&self) -> f64 {
        f64::from(self.row.z_offset())
    }

    /// Length along s over which it holds `[m]`; 0 if not given.
    pub fn valid_length(&self) -> f64 {
        f64::from(self.row.valid_length())
    }

    /// Direction of travel on the referring road that it is for.
    pub fn orientation(&self) -> Orientation {
        Orientation::from_code(self.row.orientation())
    }

    /// Lane numbers of the referring road that it holds for; none: for all lanes.
    pub fn validities(&self) -> impl ExactSizeIterator<Item = LaneRange> + use<'a> {
        validities(self.map, self.row.validities())
    }
}

impl<'a> Map<'a> {
    /// All bridges and tunnels, by road.
    pub fn structures(&self) -> impl ExactSizeIterator<Item = Structure<'a>> + use<'a> {
        let map = *self;
        map.tables().structures.iter().map(move |row| Structure { map, row })
    }

    /// All references to objects, by referring road.
    pub fn object_references(
        &self,
    ) -> impl ExactSizeIterator<Item = ObjectReference<'a>> + use<'a> {
        let map = *self;
        map.tables().object_references.iter().map(move |row| ObjectReference { map, row })
    }
}

impl<'a> Road<'a> {
    /// Bridges and tunnels of the road, in file order.
    pub fn structures(&self) -> impl ExactSizeIterator<Item = Structure<'a>> + use<'a> {
        let (map, number) = (self.map, self.road_id().row());
        let rows = map.tables().structures;
        let first = rows.partition_point(|row| row.road() < number);
        let after = rows.partition_point(|row| row.road() <= number);
        rows.get(first..after).unwrap_or(&[]).iter().map(move |row| Structure { map, row })
    }

    /// Bridges and tunnels that s lies in, ends included.
    pub fn structures_at(&self, s: f64) -> impl Iterator<Item = Structure<'a>> + use<'a> {
        self.structures().filter(move |structure| {
            let SRange { low: from, high: to } = structure.s_range();
            from <= s && s <= to
        })
    }

    /// References of the road to objects of others, in file order.
    pub fn object_references(
        &self,
    ) -> impl ExactSizeIterator<Item = ObjectReference<'a>> + use<'a> {
        let (map, number) = (self.map, self.road_id().row());
        let rows = map.tables().object_references;
        let first = rows.partition_point(|row| row.road() < number);
        let after = rows.partition_point(|row| row.road() <= number);
        rows.get(first..after).unwrap_or(&[]).iter().map(move |row| ObjectReference { map, row })
    }
}
