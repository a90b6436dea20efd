//! Where an object stands: at its own place, or as one of its copies.

use super::object::Object;
use super::outline::ObjectOutline;
use crate::ids::ObjectId;
use glam::DVec3;
use mapd_archive::{ObjectShape, Range, copy_flags};
use mapd_geometry::Attitude;

/// Names a place of an object; valid for one map content.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PlacementId {
    /// The object.
    pub object: ObjectId,
    /// Which of its copies, from 0; none for an object that is not repeated.
    pub copy: Option<u32>,
}

/// An object where it stands.
#[derive(Clone, Copy)]
pub struct ObjectPlacement<'a> {
    object: Object<'a>,
    copy: Option<u32>,
    position: DVec3,
    /// Heading, pitch, roll.
    angles: [f64; 3],
    /// Length, width, height, radius.
    sizes: [f64; 4],
    /// s, t.
    track: [f64; 2],
    shape: ObjectShape,
    outlines: Range,
    is_swept: bool,
}

impl<'a> ObjectPlacement<'a> {
    /// The object at its own place.
    pub(super) fn of_object(object: Object<'a>) -> Self {
        let row = object.row;
        let origin = object.map.origin().extend(0.0);
        Self {
            object,
            copy: None,
            position: origin + DVec3::new(row.x(), row.y(), row.z()),
            angles: [row.heading(), f64::from(row.pitch()), f64::from(row.roll())],
            sizes: [row.length(), row.width(), row.height(), row.radius()].map(f64::from),
            track: [row.s(), row.t()],
            shape: ObjectShape::from_code(row.shape()),
            outlines: row.outlines(),
            is_swept: false,
        }
    }

    /// The copy in a row of the archive's table.
    pub(super) fn of_copy(object: Object<'a>, number: u32) -> Option<Self> {
        let row = object.map.tables().object_copies.get(number as usize)?;
        let origin = object.map.origin().extend(0.0);
        let is_swept = row.flags() & copy_flags::SWEPT != 0;
        Some(Self {
            object,
            copy: number.checked_sub(object.row.copies().first),
            position: origin + DVec3::new(row.x(), row.y(), row.z()),
            angles: [row.heading(), f64::from(row.pitch()), f64::from(row.roll())],
            sizes: [row.length(), row.width(), row.height(), row.radius()].map(f64::from),
            track: [row.s(), row.t()],
            shape: ObjectShape::from_code(row.shape()),
            outlines: if is_swept { row.outlines() } else { object.row.outlines() },
            is_swept,
        })
    }

    /// The object.
    pub fn object(&self) -> Object<'a> {
        self.object
    }

    /// Names this place.
    pub fn placement_id(&self) -> PlacementId {
        PlacementId { object: self.object.object_id(), copy: self.copy }
    }

    /// The place's number in the objects' index: the object's row, or the number of objects plus the copy's row.
    pub fn item(&self) -> u32 {
        match self.copy {
            None => self.object.object_id().row(),
            Some(copy) => {
                let objects = self.object.map.tables().objects.len() as u32;
                objects.wrapping_add(self.object.row.copies().first).wrapping_add(copy)
            }
        }
    }

    /// Inertial position of the origin `[m]`.
    pub fn position(&self) -> DVec3 {
        self.position
    }

    /// Heading, pitch and roll `[rad]`, inertial.
    pub fn angles(&self) -> [f64; 3] {
        self.angles
    }

    /// Where its axes point: u ahead, v to the left, w upwards.
    pub fn attitude(&self) -> Attitude {
        let [heading, pitch, roll] = self.angles;
        Attitude::new(heading, pitch, roll)
    }

    /// s `[m]` on the object's road.
    pub fn s(&self) -> f64 {
        self.track[0]
    }

    /// t `[m]`, positive to the left.
    pub fn t(&self) -> f64 {
        self.track[1]
    }

    /// Length `[m]`; 0 if not given. Of a swept copy along the road.
    pub fn length(&self) -> f64 {
        self.sizes[0]
    }

    /// Width `[m]`; 0 if not given. Of a swept copy at its start.
    pub fn width(&self) -> f64 {
        self.sizes[1]
    }

    /// Height `[m]`: the place's own, or that of the highest corner; 0 if none is given.
    pub fn height(&self) -> f64 {
        let corners = self.outlines().flat_map(|outline| outline.heights());
        corners.fold(self.sizes[2], f64::max)
    }

    /// Radius `[m]`; 0 if not given.
    pub fn radius(&self) -> f64 {
        self.sizes[3]
    }

    /// What the extent is made of.
    pub fn shape(&self) -> ObjectShape {
        self.shape
    }

    /// Whether it is the object without gaps along a stretch of road.
    pub fn is_swept(&self) -> bool {
        self.is_swept
    }

    /// Outlines in file order.
    pub fn outlines(&self) -> impl ExactSizeIterator<Item = ObjectOutline<'a>> + use<'a> {
        let placement = *self;
        let rows = self.outlines.of(self.object.map.tables().object_outlines);
        rows.iter().map(move |row| ObjectOutline::new(placement, row))
    }
}
