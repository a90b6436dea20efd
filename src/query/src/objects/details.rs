//! Markings, borders, skeletons, materials and parking of objects, as written.

use super::object::Object;
use super::outline::ObjectOutline;
use super::placement::ObjectPlacement;
use crate::map::Map;
use glam::DVec3;
use mapd_archive::{
    ArchivedObjectBorderRow, ArchivedObjectMarkingRow, ArchivedObjectMaterialRow,
    ArchivedObjectSkeletonRow, ArchivedObjectValueRow, ArchivedParkingSpaceRow, ObjectSide, Range,
    string,
};

/// Rows of one object in a table that is sorted by object.
fn of_object<T>(rows: &[T], number: u32, object: impl Fn(&T) -> u32) -> &[T] {
    let first = rows.partition_point(|row| object(row) < number);
    let after = rows.partition_point(|row| object(row) <= number);
    rows.get(first..after).unwrap_or(&[])
}

/// Positions of corners that a marking or border names, where the object stands.
fn corners<'a>(
    placement: ObjectPlacement<'a>,
    range: Range,
) -> impl ExactSizeIterator<Item = DVec3> + use<'a> {
    let tables = placement.object().map.tables();
    let (origin, axes) = (placement.position(), placement.attitude());
    range.of(tables.object_corners).iter().map(move |point| {
        let local =
            tables.object_points.get(*point as usize).map_or(DVec3::ZERO, super::outline::local);
        origin + axes.to_parent(local)
    })
}

/// The outline in a row of the archive's table, if it is one of the object's.
fn outline(placement: ObjectPlacement<'_>, row: u32) -> Option<ObjectOutline<'_>> {
    let range = placement.object().row.outlines();
    let number = row.checked_sub(range.first).filter(|number| *number < range.count)?;
    placement.outlines().nth(number as usize)
}

/// A painted line along an object (OpenDRIVE 1.8.1, 13.7).
#[derive(Clone, Copy)]
pub struct ObjectMarking<'a> {
    placement: ObjectPlacement<'a>,
    row: &'a ArchivedObjectMarkingRow,
}

impl<'a> ObjectMarking<'a> {
    /// The outline that it runs along; none for one along a side.
    pub fn outline(&self) -> Option<ObjectOutline<'a>> {
        outline(self.placement, self.row.outline())
    }

    /// Corners that it runs along, in order, inertial `[m]`; none: the whole outline, or the side.
    pub fn corners(&self) -> impl ExactSizeIterator<Item = DVec3> + use<'a> {
        corners(self.placement, self.row.corners())
    }

    /// The side that it runs along, if that is given.
    pub fn side(&self) -> Option<ObjectSide> {
        Some(ObjectSide::from_code(self.row.side())).filter(|side| *side != ObjectSide::None)
    }

    /// Color as written.
    pub fn color(&self) -> &'a str {
        string(self.placement.object().map.tables(), self.row.color())
    }

    /// Weight as written: standard or bold; empty if absent.
    pub fn weight(&self) -> &'a str {
        string(self.placement.object().map.tables(), self.row.weight())
    }

    /// Type of a parking space's marking in OpenDRIVE 1.4; empty elsewhere.
    pub fn kind(&self) -> &'a str {
        string(self.placement.object().map.tables(), self.row.kind())
    }

    /// Width `[m]`; 0 if not given.
    pub fn width(&self) -> f64 {
        f64::from(self.row.width())
    }

    /// Height above the object's foot `[m]`.
    pub fn z_offset(&self) -> f64 {
        f64::from(self.row.z_offset())
    }

    /// Length of a stroke `[m]`; 0 if not given.
    pub fn stroke_length(&self) -> f64 {
        f64::from(self.row.line_length())
    }

    /// Length of the gap behind a stroke `[m]`; 0 if not given.
    pub fn gap_length(&self) -> f64 {
        f64::from(self.row.space_length())
    }

    /// How far after its first corner the line begins `[m]`.
    pub fn start_offset(&self) -> f64 {
        f64::from(self.row.start_offset())
    }

    /// How far before its last corner the line ends `[m]`.
    pub fn stop_offset(&self) -> f64 {
        f64::from(self.row.stop_offset())
    }
}

/// A frame along an outline (OpenDRIVE 1.8.1, 13.9).
#[derive(Clone, Copy)]
pub struct ObjectBorder<'a> {
    placement: ObjectPlacement<'a>,
    row: &'a ArchivedObjectBorderRow,
}

impl<'a> ObjectBorder<'a> {
    /// The outline.
    pub fn outline(&self) -> Option<ObjectOutline<'a>> {
        outline(self.placement, self.row.outline())
    }

    /// Corners that it runs along, in order, inertial `[m]`; none: the whole outline.
    pub fn corners(&self) -> impl ExactSizeIterator<Item = DVec3> + use<'a> {
        corners(self.placement, self.row.corners())
    }

    /// Kind as written: concrete, curb, paint.
    pub fn kind(&self) -> &'a str {
        string(self.placement.object().map.tables(), self.row.kind())
    }

    /// Width `[m]`.
    pub fn width(&self) -> f64 {
        f64::from(self.row.width())
    }
}

/// A vertex of a skeleton.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SkeletonVertex {
    /// Inertial `[m]`.
    pub position: DVec3,
    /// Radius of the tube around the line `[m]`; 0 if not given.
    pub radius: f64,
    /// Whether the object meets the ground here.
    pub is_on_ground: bool,
}

/// A line of a skeleton (OpenDRIVE 1.8.1, 13.8).
#[derive(Clone, Copy)]
pub struct Skeleton<'a> {
    placement: ObjectPlacement<'a>,
    row: &'a ArchivedObjectSkeletonRow,
}

impl<'a> Skeleton<'a> {
    /// Vertices in order.
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = SkeletonVertex> + use<'a> {
        let (origin, axes) = (self.placement.position(), self.placement.attitude());
        let rows = self.row.vertices().of(self.placement.object().map.tables().skeleton_vertices);
        rows.iter().map(move |row| {
            let local = DVec3::new(f64::from(row.u()), f64::from(row.v()), f64::from(row.z()));
            SkeletonVertex {
                position: origin + axes.to_parent(local),
                radius: f64::from(row.radius()),
                is_on_ground: row.flags() & 1 != 0,
            }
        })
    }
}

/// What makes an object a parking space (OpenDRIVE 1.8.1, 13.10).
#[derive(Clone, Copy)]
pub struct ParkingSpace<'a> {
    map: Map<'a>,
    row: &'a ArchivedParkingSpaceRow,
}

impl<'a> ParkingSpace<'a> {
    /// Who may park, as written: all, car, women, handicapped, bus, truck, electric, residents; empty if absent.
    pub fn access(&self) -> &'a str {
        string(self.map.tables(), self.row.access())
    }

    /// Restrictions in words.
    pub fn restrictions(&self) -> &'a str {
        string(self.map.tables(), self.row.restrictions())
    }
}

/// What an object is made of.
#[derive(Clone, Copy)]
pub struct ObjectMaterial<'a> {
    map: Map<'a>,
    row: &'a ArchivedObjectMaterialRow,
}

impl<'a> ObjectMaterial<'a> {
    /// Code of the surface as written.
    pub fn surface(&self) -> &'a str {
        string(self.map.tables(), self.row.surface())
    }

    /// Color of painted markings as written (OpenDRIVE 1.8).
    pub fn road_mark_color(&self) -> &'a str {
        string(self.map.tables(), self.row.color())
    }

    /// Friction coefficient, if given.
    pub fn friction(&self) -> Option<f64> {
        Some(f64::from(self.row.friction())).filter(|n| *n >= 0.0)
    }

    /// Roughness as written, if given.
    pub fn roughness(&self) -> Option<f64> {
        Some(f64::from(self.row.roughness())).filter(|n| *n >= 0.0)
    }
}

impl<'a> ObjectPlacement<'a> {
    /// Painted lines along the object where it stands.
    pub fn markings(&self) -> impl ExactSizeIterator<Item = ObjectMarking<'a>> + use<'a> {
        let (placement, number) = (*self, self.object().object_id().row());
        let rows = of_object(self.object().map.tables().object_markings, number, |r| r.object());
        rows.iter().map(move |row| ObjectMarking { placement, row })
    }

    /// Frames along its outlines where it stands.
    pub fn borders(&self) -> impl ExactSizeIterator<Item = ObjectBorder<'a>> + use<'a> {
        let (placement, number) = (*self, self.object().object_id().row());
        let rows = of_object(self.object().map.tables().object_borders, number, |r| r.object());
        rows.iter().map(move |row| ObjectBorder { placement, row })
    }

    /// Lines that describe it from inside, where it stands.
    pub fn skeletons(&self) -> impl ExactSizeIterator<Item = Skeleton<'a>> + use<'a> {
        let (placement, number) = (*self, self.object().object_id().row());
        let rows = of_object(self.object().map.tables().object_skeletons, number, |r| r.object());
        rows.iter().map(move |row| Skeleton { placement, row })
    }
}

impl<'a> Object<'a> {
    /// What makes it a parking space, if the file has that.
    pub fn parking_space(&self) -> Option<ParkingSpace<'a>> {
        let (map, number) = (self.map, self.object_id().row());
        let rows = of_object(map.tables().parking_spaces, number, |r| r.object());
        rows.first().map(|row| ParkingSpace { map, row })
    }

    /// What its class means by its value: `[m/s]`, `[m]` or `[kg]`.
    pub fn value(&self) -> Option<f64> {
        self.value_row().map(|row| row.value())
    }

    /// Unit in which the number of its value is read, such as `km/h`: objects state none. Empty without a value.
    pub fn assumed_unit(&self) -> &'a str {
        self.value_row().map_or("", |row| string(self.map.tables(), row.unit()))
    }

    fn value_row(&self) -> Option<&'a ArchivedObjectValueRow> {
        let number = self.object_id().row();
        of_object(self.map.tables().object_values, number, |row| row.object()).first()
    }

    /// What it is made of.
    pub fn materials(&self) -> impl ExactSizeIterator<Item = ObjectMaterial<'a>> + use<'a> {
        let (map, number) = (self.map, self.object_id().row());
        let rows = of_object(map.tables().object_materials, number, |r| r.object());
        rows.iter().map(move |row| ObjectMaterial { map, row })
    }
}
