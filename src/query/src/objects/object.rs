//! An object as written, and where it stands.

use super::outline::ObjectOutline;
use super::placement::ObjectPlacement;
use crate::error::QueryError;
use crate::extents::{LaneRange, SourcePosition};
use crate::ids::ObjectId;
use crate::junction::Junction;
use crate::map::Map;
use crate::road::Road;
use glam::DVec3;
use mapd_archive::{
    ArchivedObjectRow, Class, NONE, ObjectShape, Orientation, object_flags, string,
};

/// An object (OpenDRIVE 1.8.1, 13).
#[derive(Clone, Copy)]
pub struct Object<'a> {
    pub(crate) map: Map<'a>,
    number: u32,
    pub(crate) row: &'a ArchivedObjectRow,
}

impl<'a> Object<'a> {
    pub(crate) fn new(map: Map<'a>, number: u32) -> Option<Self> {
        Some(Self { map, number, row: map.tables().objects.get(number as usize)? })
    }

    /// Dense id.
    pub fn object_id(&self) -> ObjectId {
        ObjectId::new(self.number, self.map.content())
    }

    /// OpenDRIVE's id, verbatim.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// Name for people.
    pub fn name(&self) -> &'a str {
        string(self.map.tables(), self.row.name())
    }

    /// What it means, in mapd's vocabulary (docs/ontology.md); `Unknown` where no table knows its type and name.
    pub fn class(&self) -> Class {
        Class::from_code(self.row.class())
    }

    /// `type` as written, whether the standard lists it or not; empty if absent.
    pub fn type_name(&self) -> &'a str {
        string(self.map.tables(), self.row.kind())
    }

    /// `subtype` as written.
    pub fn subtype(&self) -> &'a str {
        string(self.map.tables(), self.row.subtype())
    }

    /// The road that it is written in; none for an object of a junction.
    pub fn road(&self) -> Option<Road<'a>> {
        Road::new(self.map, self.row.road())
    }

    /// The junction that it is written in; none for an object of a road.
    pub fn junction(&self) -> Option<Junction<'a>> {
        Some(self.row.junction())
            .filter(|row| *row != NONE)
            .and_then(|row| Junction::new(self.map, row))
    }

    /// s as written `[m]`, along the reference line of the road or junction.
    pub fn s(&self) -> f64 {
        self.row.s()
    }

    /// t as written `[m]`, positive to the left.
    pub fn t(&self) -> f64 {
        self.row.t()
    }

    /// Height of the origin above the reference line at s `[m]`.
    pub fn z_offset(&self) -> f64 {
        f64::from(self.row.z_offset())
    }

    /// Inertial position of its origin `[m]`: beside the reference line at s, at the line's height plus zOffset
    /// (OpenDRIVE 1.9, 13.1). A repeated object stands at its [placements](Object::placements) instead.
    pub fn position(&self) -> DVec3 {
        self.template().position()
    }

    /// As [`Object::position`], but zOffset above the surface there, as some tools place objects: that of the road, or of the
    /// junction's elevation grid, without which an object of a junction is where `position` says.
    ///
    /// Errors: a damaged archive.
    pub fn position_on_surface(&self) -> Result<DVec3, QueryError> {
        match self.road() {
            Some(road) => {
                let surface = road.surface_at(self.s(), self.t())?;
                Ok(self.position().with_z(surface.position.z + self.z_offset()))
            }
            None => {
                let position = self.position();
                let junction = self.junction();
                let grid = junction.and_then(|j| j.grid_height_at(position.truncate()));
                Ok(grid.map_or(position, |grid| position.with_z(grid.height + self.z_offset())))
            }
        }
    }

    /// Inertial heading `[rad]`, in (−π, π].
    pub fn heading(&self) -> f64 {
        self.row.heading()
    }

    /// Inertial pitch `[rad]`; positive lowers the front.
    pub fn pitch(&self) -> f64 {
        f64::from(self.row.pitch())
    }

    /// Inertial roll `[rad]`; positive lifts the left side.
    pub fn roll(&self) -> f64 {
        f64::from(self.row.roll())
    }

    /// Length along its own u axis `[m]`; 0 if not given.
    pub fn length(&self) -> f64 {
        f64::from(self.row.length())
    }

    /// Width along its own v axis `[m]`; 0 if not given.
    pub fn width(&self) -> f64 {
        f64::from(self.row.width())
    }

    /// Height `[m]`: the object's own, or that of its highest corner; 0 if none is given.
    pub fn height(&self) -> f64 {
        self.template().height()
    }

    /// Radius `[m]`; 0 if not given.
    pub fn radius(&self) -> f64 {
        f64::from(self.row.radius())
    }

    /// What its extent is made of.
    pub fn shape(&self) -> ObjectShape {
        ObjectShape::from_code(self.row.shape())
    }

    /// Direction of travel that it is for. It says nothing about where the object faces.
    pub fn orientation(&self) -> Orientation {
        Orientation::from_code(self.row.orientation())
    }

    /// Length along s over which it holds `[m]`; 0 if not given.
    pub fn valid_length(&self) -> f64 {
        f64::from(self.row.valid_length())
    }

    /// Lane numbers that it is written to hold for, each from the lower to the higher one; none: for all lanes.
    pub fn validities(&self) -> impl ExactSizeIterator<Item = LaneRange> + use<'a> {
        let ranges = self.row.validities().of(self.map.tables().lane_ranges);
        ranges.iter().map(|range| LaneRange { from: range.from(), to: range.to() })
    }

    fn has(&self, flag: u8) -> bool {
        self.row.flags() & flag != 0
    }

    /// Whether its state may change.
    pub fn is_dynamic(&self) -> bool {
        self.has(object_flags::DYNAMIC)
    }

    /// Whether it stands perpendicular to the road instead of upright.
    pub fn is_perpendicular(&self) -> bool {
        self.has(object_flags::PERPENDICULAR)
    }

    /// Whether it stands for a limited time (OpenDRIVE 1.9).
    pub fn is_temporary(&self) -> bool {
        self.has(object_flags::TEMPORARY)
    }

    /// Whether it is written to hold no longer (OpenDRIVE 1.9).
    pub fn is_invalidated(&self) -> bool {
        self.has(object_flags::INVALIDATED)
    }

    /// Whether s lies beyond the road, so that the object stands beside its end.
    pub fn is_clamped(&self) -> bool {
        self.has(object_flags::CLAMPED)
    }

    /// Outlines as written, in file order.
    pub fn outlines(&self) -> impl ExactSizeIterator<Item = ObjectOutline<'a>> + use<'a> {
        self.template().outlines()
    }

    /// Corners of the area that it covers, inertial `[m]`: see [`ObjectPlacement::footprint`].
    pub fn footprint(&self, out: &mut Vec<DVec3>) {
        self.template().footprint(out);
    }

    /// The object at its own s and t: where it stands unless it is repeated.
    pub fn template(&self) -> ObjectPlacement<'a> {
        ObjectPlacement::of_object(*self)
    }

    /// Whether it is repeated: then it stands at the copies alone.
    pub fn is_repeated(&self) -> bool {
        self.row.copies().count > 0
    }

    /// Every place where it stands: its own, or those of its copies.
    pub fn placements(&self) -> impl Iterator<Item = ObjectPlacement<'a>> + use<'a> {
        let object = *self;
        let copies = self.row.copies();
        let own = (copies.count == 0).then(|| object.template());
        let rows = copies.rows(self.map.tables().object_copies.len());
        own.into_iter().chain(rows.filter_map(move |row| ObjectPlacement::of_copy(object, row)))
    }

    /// A copy by its number, from 0.
    pub fn copy(&self, number: u32) -> Option<ObjectPlacement<'a>> {
        let copies = self.row.copies();
        let row = copies.first.checked_add(number).filter(|_| number < copies.count)?;
        ObjectPlacement::of_copy(*self, row)
    }

    /// Place of the object in its file: line and column of the start tag, from 1.
    pub fn source_position(&self) -> SourcePosition {
        SourcePosition { line: self.row.line(), column: self.row.column() }
    }
}
