//! Appends what else is written in objects, once their outlines have rows.

use super::Shape;
use super::line::Line;
use super::place::Standing;
use crate::draft::single;
use crate::draft::{Corner, Details, OutlineCorners, Vertex};
use crate::findings::TooLarge;
use glam::DVec3;
use mapd_archive::{
    NONE, ObjectBorderRow, ObjectMarkingRow, ObjectMaterialRow, ObjectSkeletonRow, ObjectValueRow,
    ParkingSpaceRow, Range, Rows, SkeletonVertexRow,
};
use std::collections::HashMap;

/// The vertices of an object's skeletons, line by line, in its own frame.
pub(super) fn skeletons(
    line: &Line<'_>,
    standing: &Standing,
    details: &Details,
) -> Vec<Vec<SkeletonVertexRow>> {
    let vertex = |vertex: &Vertex| {
        let local = match vertex.corner {
            Corner::Road([s, t, dz, _]) => {
                let position = line.at(s, t)?.position + DVec3::Z * dz;
                standing.axes.to_local(position - standing.origin)
            }
            Corner::Local([u, v, z, _]) => DVec3::new(u, v, z),
            Corner::Curve(_) => return None,
        };
        let [u, v, z] = local.to_array().map(single);
        let flags = u32::from(vertex.is_on_ground);
        Some(SkeletonVertexRow { u, v, z, radius: single(vertex.radius), flags })
    };
    details.skeletons.iter().map(|line| line.iter().filter_map(vertex).collect()).collect()
}

/// An object's corners by their ids: each of its details asks for some.
pub(super) struct Corners {
    /// Number of outlines.
    outlines: usize,
    /// By id: outlines that have it, ascending, with the number of the first point of each that does.
    places: HashMap<u32, Vec<(u32, u32)>>,
}

impl Corners {
    pub(super) fn new(shapes: &[Shape]) -> Self {
        let mut places: HashMap<u32, Vec<(u32, u32)>> = HashMap::new();
        for (number, shape) in (0u32..).zip(shapes) {
            for (id, point) in &shape.corners {
                let of_id = places.entry(*id).or_default();
                if of_id.last().is_none_or(|(last, _)| *last < number) {
                    of_id.push((number, *point));
                }
            }
        }
        Self { outlines: shapes.len(), places }
    }

    fn of_id(&self, id: u32) -> &[(u32, u32)] {
        self.places.get(&id).map_or(&[], Vec::as_slice)
    }

    /// The number of a corner's point within an outline.
    fn point(&self, outline: u32, id: u32) -> Option<u32> {
        let of_id = self.of_id(id);
        let at = of_id.binary_search_by_key(&outline, |(outline, _)| *outline).ok()?;
        of_id.get(at).map(|(_, point)| *point)
    }

    /// The first outline that has all of some corners.
    fn find(&self, ids: &[u32]) -> Option<u32> {
        let rarest = ids.iter().min_by_key(|id| self.of_id(**id).len())?;
        let mut having = self.of_id(*rarest).iter().map(|(outline, _)| *outline);
        having.find(|outline| ids.iter().all(|id| self.point(*outline, *id).is_some()))
    }

    /// The row of the outline and the points that a line runs along. Corners that the outline does not have are passed
    /// over; a rule names them.
    fn resolve(&self, along: &OutlineCorners, rows: &Rows, outlines: Range) -> (u32, Vec<u32>) {
        let stated = along.outline.map(|number| number as u32);
        let number = stated.or_else(|| self.find(&along.corners));
        let Some(number) = number.filter(|number| (*number as usize) < self.outlines) else {
            return (NONE, Vec::new());
        };
        let row = outlines.first + number;
        let first = rows.object_outlines.get(row as usize).map_or(0, |row| row.points.first);
        let point = |id: &u32| self.point(number, *id).map(|at| first + at);
        (row, along.corners.iter().filter_map(point).collect())
    }
}

/// What details belong to.
pub(super) struct Of<'a> {
    /// Row of the object.
    pub(super) object: u32,
    /// Its outlines.
    pub(super) outlines: Range,
    /// Their corners.
    pub(super) corners: &'a Corners,
}

/// Appends an object's details.
pub(super) fn append(
    rows: &mut Rows,
    of: &Of<'_>,
    details: &Details,
    skeletons: Vec<Vec<SkeletonVertexRow>>,
) -> Result<(), TooLarge> {
    let Of { object, outlines, corners } = *of;
    let named = |along: &OutlineCorners, rows: &mut Rows| {
        let (outline, points) = corners.resolve(along, rows, outlines);
        let before = rows.object_corners.len();
        rows.object_corners.extend(points);
        let range = Range::between(before, rows.object_corners.len());
        Ok::<_, TooLarge>((outline, range.ok_or_else(|| TooLarge::new("object_corners"))?))
    };
    for marking in &details.markings {
        let (outline, corners) = named(&marking.along, rows)?;
        rows.object_markings.push(ObjectMarkingRow { object, outline, corners, ..marking.row });
    }
    for border in &details.borders {
        let (outline, corners) = named(&border.along, rows)?;
        rows.object_borders.push(ObjectBorderRow { object, outline, corners, ..border.row });
    }
    for vertices in skeletons {
        let before = rows.skeleton_vertices.len();
        rows.skeleton_vertices.extend(vertices);
        let vertices = Range::between(before, rows.skeleton_vertices.len());
        let vertices = vertices.ok_or_else(|| TooLarge::new("skeleton_vertices"))?;
        rows.object_skeletons.push(ObjectSkeletonRow { object, vertices });
    }
    rows.object_materials
        .extend(details.materials.iter().map(|row| ObjectMaterialRow { object, ..*row }));
    rows.parking_spaces.extend(details.parking.map(|row| ParkingSpaceRow { object, ..row }));
    rows.object_values.extend(details.value.map(|row| ObjectValueRow { object, ..row }));
    Ok(())
}
