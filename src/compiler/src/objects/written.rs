//! What the file says about objects, in numbers, kept until everything that they are placed on is known.

use mapd_archive::{ObjectOutlineRow, ObjectRow, Range};
use mapd_geometry::Primitive;
use mapd_xodr::Span;

/// All objects of the document.
#[derive(Default)]
pub(crate) struct Objects {
    pub(crate) objects: Vec<Object>,
    /// Reference lines of junctions that have objects: (junction, geometries).
    pub(crate) junction_lines: Vec<(u32, Range)>,
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
    /// The start tag.
    pub(crate) span: Span,
}

/// An outline before its corners are placed.
pub(crate) struct Outline {
    pub(crate) row: ObjectOutlineRow,
    pub(crate) corners: Vec<Corner>,
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
            Self::Between(pair) => between(pair, ds, length),
            Self::Cubic([a, b, c, d]) => a + ds * (b + ds * (c + ds * d)),
        }
    }
}

/// A value that changes linearly along a repetition.
pub(crate) fn between([start, end]: [f64; 2], ds: f64, length: f64) -> f64 {
    if length > 0.0 { start + (end - start) * (ds / length) } else { start }
}
