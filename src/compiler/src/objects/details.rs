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

/// Ids of an object's corners, outline by outline, and where its outlines and points begin in their tables.
pub(super) struct Corners {
    /// (id, number of the point within the outline) of each outline.
    ids: Vec<Vec<(u32, u32)>>,
}

impl Corners {
    pub(super) fn new(shapes: &[Shape]) -> Self {
        Self { ids: shapes.iter().map(|shape| shape.corners.clone()).collect() }
    }

    /// The row of the outline and the points that a line runs along. Corners that the outline does not have are passed
    /// over; a rule names them.
    fn resolve(&self, along: &OutlineCorners, rows: &Rows, outlines: Range) -> (u32, Vec<u32>) {
        let has = |outline: &Vec<(u32, u32)>| {
            along.corners.iter().all(|id| outline.iter().any(|(of, _)| of == id))
        };
        let number = along.outline.or_else(|| {
            (!along.corners.is_empty()).then(|| self.ids.iter().position(has)).flatten()
        });
        let Some((number, ids)) = number.and_then(|n| Some((n as u32, self.ids.get(n)?))) else {
            return (NONE, Vec::new());
        };
        let row = outlines.first + number;
        let first = rows.object_outlines.get(row as usize).map_or(0, |row| row.points.first);
        let point = |id: &u32| ids.iter().find(|(of, _)| of == id).map(|(_, at)| first + at);
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
