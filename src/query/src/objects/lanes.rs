//! Which lanes objects belong to.

use super::object::Object;
use crate::extents::SRange;
use crate::lane::Lane;
use crate::map::Map;
use mapd_archive::{ArchivedObjectLaneRow, LaneMethod};

/// An object's belonging to a lane.
#[derive(Clone, Copy)]
pub struct ObjectLane<'a> {
    map: Map<'a>,
    row: &'a ArchivedObjectLaneRow,
}

impl<'a> ObjectLane<'a> {
    /// The object; none in a damaged archive.
    pub fn object(&self) -> Option<Object<'a>> {
        Object::new(self.map, self.row.object())
    }

    /// The lane; none in a damaged archive.
    pub fn lane(&self) -> Option<Lane<'a>> {
        Lane::new(self.map, self.row.lane())
    }

    /// How the object came to the lane.
    pub fn method(&self) -> LaneMethod {
        LaneMethod::from_code(self.row.method())
    }

    /// Distance of the object from the lane's area in plan view `[m]`; 0 on it.
    pub fn distance(&self) -> f64 {
        f64::from(self.row.distance())
    }

    /// From where to where on the road the object lies on the lane, or beside it `[m]`: s, ascending, over all of its
    /// copies.
    pub fn s_range(&self) -> SRange {
        let start = self.lane().map_or(0.0, |lane| lane.section().s_start());
        let [low, high] = [self.row.s_from(), self.row.s_to()].map(|s| start + f64::from(s));
        SRange { low, high }
    }
}

impl<'a> Object<'a> {
    /// Lanes that it belongs to, nearer ones first: by its validity, else those that its area lies on, else the nearest.
    pub fn lanes(&self) -> impl ExactSizeIterator<Item = ObjectLane<'a>> + use<'a> {
        let map = self.map;
        let rows = self.row.lanes().of(map.tables().object_lanes);
        rows.iter().map(move |row| ObjectLane { map, row })
    }
}

impl<'a> Lane<'a> {
    /// Objects that belong to the lane, in ascending s: crosswalks, stop lines, parking spaces, what stands beside it.
    pub fn objects(&self) -> impl Iterator<Item = ObjectLane<'a>> + use<'a> {
        let (map, number) = (self.map, self.row_number());
        let tables = map.tables();
        let row = move |i: &u32| tables.object_lanes.get(*i as usize);
        let rows = tables.lane_objects;
        let first = rows.partition_point(|i| row(i).is_some_and(|row| row.lane() < number));
        let own = move |row: &&'a ArchivedObjectLaneRow| row.lane() == number;
        let behind = rows.get(first..).unwrap_or(&[]);
        behind.iter().map_while(row).take_while(own).map(move |row| ObjectLane { map, row })
    }
}
