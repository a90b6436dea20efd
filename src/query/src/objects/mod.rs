//! Objects beside and on the road (docs/objects.md).

mod details;
mod footprint;
mod lanes;
mod near;
mod object;
mod outline;
mod placement;

pub use crate::structures::{ObjectReference, Structure};
pub use details::{
    ObjectBorder, ObjectMarking, ObjectMaterial, ParkingSpace, Skeleton, SkeletonVertex,
};
pub use lanes::ObjectLane;
pub use near::NearObject;
pub use object::Object;
pub use outline::ObjectOutline;
pub use placement::{ObjectPlacement, PlacementId};

use crate::error::QueryError;
use crate::ids::ObjectId;
use crate::junction::Junction;
use crate::map::{Map, find};
use crate::road::Road;
use mapd_archive::{ArchivedObjectRow, NONE};

impl<'a> Map<'a> {
    /// All objects: those of roads in the order of the roads, then those of junctions.
    pub fn objects(&self) -> impl Iterator<Item = Object<'a>> + use<'a> {
        let map = *self;
        (0..map.tables().objects.len() as u32).filter_map(move |row| Object::new(map, row))
    }

    /// The object of an id.
    ///
    /// Errors: an id of another map content, or that names nothing; a damaged archive.
    pub fn object(&self, id: ObjectId) -> Result<Object<'a>, QueryError> {
        self.known_id(id.row, id.content, id.tile)?;
        Object::new(*self, id.row).ok_or_else(|| QueryError::Corrupt.of_row(id.row))
    }

    /// The object with OpenDRIVE's id, compared byte by byte; of several the first.
    pub fn object_by_id(&self, id: &str) -> Option<Object<'a>> {
        let name = |row: u32| Object::new(*self, row).map(|object| object.id());
        let rows = self.tables().objects_by_id;
        let any = find(rows, id, name)?;
        let before =
            rows.partition_point(|row| name(*row).unwrap_or("").as_bytes() < id.as_bytes());
        Object::new(*self, rows.get(before).copied().unwrap_or(any))
    }
}

/// Objects of one owner: a stretch of the table, which is sorted by what `of` tells.
fn objects_of(
    map: Map<'_>,
    of: fn(&ArchivedObjectRow) -> (u32, u32),
    owner: (u32, u32),
) -> impl Iterator<Item = Object<'_>> {
    let rows = map.tables().objects;
    let first = rows.partition_point(|row| of(row) < owner);
    let after = rows.partition_point(|row| of(row) <= owner);
    (first as u32..after as u32).filter_map(move |row| Object::new(map, row))
}

impl<'a> Road<'a> {
    /// Objects that are written in the road, in file order.
    pub fn objects(&self) -> impl Iterator<Item = Object<'a>> + use<'a> {
        let number = self.road_id().row();
        objects_of(self.map, |row| (row.road(), NONE), (number, NONE))
    }
}

impl<'a> Junction<'a> {
    /// Objects that are written in the junction itself (OpenDRIVE 1.8), in file order. Those of its connecting roads are
    /// the roads'.
    pub fn objects(&self) -> impl Iterator<Item = Object<'a>> + use<'a> {
        let number = self.junction_id().row();
        objects_of(self.map, |row| (row.road(), row.junction()), (NONE, number))
    }
}
