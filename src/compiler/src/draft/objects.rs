//! What the file says about objects, in numbers, kept until everything that they are placed on is known.

use mapd_archive::{
    ObjectBorderRow, ObjectMarkingRow, ObjectMaterialRow, ObjectOutlineRow, ObjectReferenceRow,
    ObjectRow, ObjectShape, ObjectValueRow, ParkingSpaceRow, PlatformRow, PlatformSegmentRow,
    Range, RowMappings, StationRow, StructureRow, SwitchRow,
};
use mapd_geometry::Primitive;
use mapd_xodr::Span;

/// All objects of the document.
#[derive(Default)]
pub(crate) struct Objects {
    pub(crate) objects: Vec<Object>,
    /// Reference lines of junctions that have objects: (junction, geometries), in order of their rows.
    pub(crate) junction_lines: Vec<(u32, Range)>,
    pub(crate) references: Vec<Reference>,
    pub(crate) structures: Vec<Structure>,
    pub(crate) switches: Vec<Switch>,
    pub(crate) stations: Vec<Station>,
}

impl Objects {
    /// The rows that objects will have: those of junctions come last, for they have no road, whose number is the largest.
    pub(crate) fn rows(&self) -> Vec<u32> {
        let mut order: Vec<usize> = (0..self.objects.len()).collect();
        order.sort_by_key(|number| self.objects[*number].row.road);
        let mut rows = vec![0; order.len()];
        for (row, number) in (0..).zip(order) {
            rows[number] = row;
        }
        rows
    }
}

/// An object: its row but for what follows from its place, and the shapes that are placed with it.
pub(crate) struct Object {
    pub(crate) row: ObjectRow,
    /// `zOffset` `[m]`, which the row has in single precision.
    pub(crate) z_offset: f64,
    /// Heading, pitch and roll as written `[rad]`.
    pub(crate) angles: [f64; 3],
    pub(crate) outlines: Vec<Outline>,
    pub(crate) repeats: Vec<Repeat>,
    /// Lane numbers that it holds for, from the lower to the higher one.
    pub(crate) validities: Vec<(i32, i32)>,
    pub(crate) details: Option<Box<Details>>,
    /// The start tag.
    pub(crate) span: Span,
}

/// An outline before its corners are placed.
pub(crate) struct Outline {
    pub(crate) row: ObjectOutlineRow,
    pub(crate) corners: Vec<Corner>,
    /// Ids of the corners; u32::MAX where one has none.
    pub(crate) ids: Vec<u32>,
    /// Its place among the outlines as written.
    pub(crate) number: usize,
}

/// A corner or curve of an outline.
pub(crate) enum Corner {
    /// `cornerRoad`: s, t, height above the reference line, height `[m]`.
    Road([f64; 4]),
    /// `cornerLocal`: u, v, z, height `[m]`.
    Local([f64; 4]),
    /// `curveLocal`.
    Curve(Box<Curve>),
}

/// A curve in the object's frame.
pub(crate) struct Curve {
    /// u, v, z, height of its start `[m]`.
    pub(crate) start: [f64; 4],
    pub(crate) heading: f64,
    pub(crate) length: f64,
    pub(crate) primitive: Primitive,
}

/// A `repeat` element. Pairs are the values at its start and end.
#[derive(Clone, Copy)]
pub(crate) struct Repeat {
    pub(crate) s: f64,
    pub(crate) length: f64,
    /// Between two copies `[m]`; 0: without gaps.
    pub(crate) distance: f64,
    pub(crate) t: Lateral,
    pub(crate) z_offset: [f64; 2],
    pub(crate) height: [f64; 2],
    pub(crate) width: [f64; 2],
    pub(crate) length_of_copy: [f64; 2],
    pub(crate) radius: [f64; 2],
    /// Along the straight line between both ends instead of the reference line.
    pub(crate) is_detached: bool,
    pub(crate) span: Span,
}

/// Lateral place along a repetition.
#[derive(Clone, Copy)]
pub(crate) enum Lateral {
    /// Linear between both ends.
    Between([f64; 2]),
    /// A cubic over the distance from the start (OpenDRIVE 1.9).
    Cubic([f64; 4]),
}

impl Lateral {
    /// t at a distance from the start of a repetition of this length `[m]`.
    pub(crate) fn at(self, ds: f64, length: f64) -> f64 {
        match self {
            Self::Between(pair) => linear(pair, ds, length),
            Self::Cubic([a, b, c, d]) => a + ds * (b + ds * (c + ds * d)),
        }
    }
}

/// A value that changes linearly along a repetition.
pub(crate) fn linear([start, end]: [f64; 2], ds: f64, length: f64) -> f64 {
    if length > 0.0 { start + (end - start) * (ds / length) } else { start }
}

/// What else is written in an object; most have none of it.
#[derive(Default)]
pub(crate) struct Details {
    pub(crate) markings: Vec<Marking>,
    pub(crate) borders: Vec<Border>,
    pub(crate) skeletons: Vec<Vec<Vertex>>,
    pub(crate) materials: Vec<ObjectMaterialRow>,
    pub(crate) parking: Option<ParkingSpaceRow>,
    pub(crate) value: Option<ObjectValueRow>,
}

/// Which outline's which corners a line runs along, as written.
#[derive(Default)]
pub(crate) struct OutlineCorners {
    /// Number of the outline; none: the first that has the corners.
    pub(crate) outline: Option<usize>,
    /// Ids of corners.
    pub(crate) corners: Vec<u32>,
}

/// A marking before its corners are known.
pub(crate) struct Marking {
    pub(crate) row: ObjectMarkingRow,
    pub(crate) along: OutlineCorners,
}

/// A border before its corners are known.
pub(crate) struct Border {
    pub(crate) row: ObjectBorderRow,
    pub(crate) along: OutlineCorners,
}

/// A vertex of a skeleton.
pub(crate) struct Vertex {
    /// Without a height.
    pub(crate) corner: Corner,
    pub(crate) radius: f64,
    pub(crate) is_on_ground: bool,
}

/// Objects of other roads that concern a road, before ids are known.
pub(crate) struct Reference {
    pub(crate) row: ObjectReferenceRow,
    pub(crate) validities: Vec<(i32, i32)>,
}

/// A bridge or tunnel.
pub(crate) struct Structure {
    pub(crate) row: StructureRow,
    pub(crate) validities: Vec<(i32, i32)>,
}

/// A switch with the ids of its tracks and partner.
pub(crate) struct Switch {
    pub(crate) row: SwitchRow,
    pub(crate) tracks: [String; 2],
    pub(crate) partner: String,
}

/// A station.
pub(crate) struct Station {
    pub(crate) row: StationRow,
    pub(crate) platforms: Vec<Platform>,
}

/// A platform: its row, and what lies beside it with the ids of the roads.
pub(crate) struct Platform {
    pub(crate) row: PlatformRow,
    pub(crate) segments: Vec<(String, PlatformSegmentRow)>,
}

/// To single precision; what does not fit becomes the largest number that does, so that tables stay finite.
pub(crate) fn single(value: f64) -> f32 {
    if value.is_nan() {
        return 0.0;
    }
    mapd_geometry::clamp(value, f64::from(f32::MIN), f64::from(f32::MAX)) as f32
}

/// The shape that length, width and radius make. Both written is against the standard; a box tells more.
pub(crate) fn shape([length, width, radius]: [f32; 3]) -> ObjectShape {
    let is_box = length > 0.0 && width > 0.0;
    match (radius > 0.0, length > 0.0 || width > 0.0) {
        (true, _) if !is_box => ObjectShape::Cylinder,
        (_, true) => ObjectShape::Box,
        _ => ObjectShape::Point,
    }
}

impl Objects {
    /// Takes what is written in the part of the document that comes next.
    pub(crate) fn append(&mut self, part: Self, moves: &RowMappings) {
        self.objects.extend(part.objects.into_iter().map(|mut object| {
            object.row.move_by(moves);
            object.outlines.iter_mut().for_each(|outline| outline.row.move_by(moves));
            if let Some(details) = &mut object.details {
                details.move_by(moves);
            }
            object
        }));
        let lines = part.junction_lines.into_iter();
        let lines = lines
            .map(|(junction, line)| (moves.junctions.row(junction), moves.geometries.range(line)));
        self.junction_lines.extend(lines);
        self.references.extend(part.references.into_iter().map(|mut reference| {
            reference.row.move_by(moves);
            reference
        }));
        self.structures.extend(part.structures.into_iter().map(|mut structure| {
            structure.row.move_by(moves);
            structure
        }));
        self.switches.extend(part.switches.into_iter().map(|mut switch| {
            switch.row.move_by(moves);
            switch
        }));
        self.stations.extend(part.stations.into_iter().map(|mut station| {
            station.row.move_by(moves);
            for platform in &mut station.platforms {
                platform.row.move_by(moves);
                platform.segments.iter_mut().for_each(|(_, segment)| segment.move_by(moves));
            }
            station
        }));
    }
}

impl Details {
    fn move_by(&mut self, moves: &RowMappings) {
        self.markings.iter_mut().for_each(|marking| marking.row.move_by(moves));
        self.borders.iter_mut().for_each(|border| border.row.move_by(moves));
        self.materials.iter_mut().for_each(|row| row.move_by(moves));
        if let Some(row) = &mut self.parking {
            row.move_by(moves);
        }
        if let Some(row) = &mut self.value {
            row.move_by(moves);
        }
    }
}
