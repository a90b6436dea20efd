//! From `<geometry>` and `<curveLocal>` to curves: the one place where that is done. The rules look at these curves, and the map is built of them.

use crate::catalog::{GAP, KINK, S_ROUNDING};
use crate::place::value;
use crate::shapes::compiled;
use mapd_geometry::{
    CompileError, Compiled, Curve, CurvePoint, ParameterRange, Primitive, Start, Tangent,
    normalize_angle,
};
use mapd_xodr::{Attribute, CurveLocal, Geometry, ParamPoly3Range, PlanView, Span};

/// A geometry that is a curve.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Where it begins as written `[m]`.
    pub s: f64,
    /// Length as written `[m]`.
    pub length: f64,
    /// Rank among the geometries.
    pub index: usize,
    /// Position and heading as written.
    pub start: Start,
    /// Range of a parametric cubic as written; none where it is not, which counts as normalized, and of other shapes.
    pub range: Option<ParameterRange>,
    /// The shape, and how far its true length is from the one that is written.
    pub compiled: Compiled,
}

/// What keeps a geometry from being a curve.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// A number is absent or cannot be read.
    Missing {
        /// The attribute.
        name: &'static str,
        /// The tag that lacks it: the geometry's or its shape's.
        span: Span,
    },
    /// It has not one shape but so many.
    Shapes(usize),
    /// The shape and its length make no curve.
    Curve(CompileError),
}

/// Number of shapes that a geometry may choose from.
const SHAPES: usize = 5;

/// An attribute's name and number.
type NamedNumber<'a> = (&'static str, &'a Option<Attribute<f64>>);

/// Numbers of a tag; none where one is missing, with a fault about each.
fn numbers<const N: usize>(
    span: Span,
    written: [NamedNumber<'_>; N],
    faults: &mut Vec<Fault>,
) -> Option<[f64; N]> {
    let mut all = [0.0; N];
    let mut is_whole = true;
    for (place, (name, attribute)) in all.iter_mut().zip(written) {
        match attribute {
            Some(attribute) => *place = attribute.value,
            None => {
                faults.push(Fault::Missing { name, span });
                is_whole = false;
            }
        }
    }
    is_whole.then_some(all)
}

/// Number of shapes that a geometry has.
fn shapes(g: &Geometry) -> usize {
    let written: [bool; SHAPES] = [
        g.line.is_some(),
        g.spiral.is_some(),
        g.arc.is_some(),
        g.poly3.is_some(),
        g.param_poly3.is_some(),
    ];
    written.into_iter().filter(|is_there| *is_there).count()
}

/// The shape that a geometry has, as written, and the range of a parametric cubic, if it is written. None where it has no
/// shape, several, or one that lacks a number.
fn primitive(g: &Geometry, faults: &mut Vec<Fault>) -> Option<(Primitive, Option<ParameterRange>)> {
    let count = shapes(g);
    if count != 1 {
        faults.push(Fault::Shapes(count));
        return None;
    }
    if let Some(p) = &g.spiral {
        let written = [("curvStart", &p.curv_start), ("curvEnd", &p.curv_end)];
        let [curvature_start, curvature_end] = numbers(p.span, written, faults)?;
        return Some((Primitive::Spiral { curvature_start, curvature_end }, None));
    }
    if let Some(p) = &g.arc {
        return Some((arc(p.span, &p.curvature, faults)?, None));
    }
    if let Some(p) = &g.poly3 {
        let written = [("a", &p.a), ("b", &p.b), ("c", &p.c), ("d", &p.d)];
        return Some((Primitive::Poly3 { v: numbers(p.span, written, faults)? }, None));
    }
    let Some(p) = &g.param_poly3 else { return Some((Primitive::Line, None)) };
    let u = [("aU", &p.a_u), ("bU", &p.b_u), ("cU", &p.c_u), ("dU", &p.d_u)];
    let v = [("aV", &p.a_v), ("bV", &p.b_v), ("cV", &p.c_v), ("dV", &p.d_v)];
    let written = range(value(&p.p_range));
    Some((cubic(p.span, [u, v], written, faults)?, written))
}

fn arc(
    span: Span,
    curvature: &Option<Attribute<f64>>,
    faults: &mut Vec<Fault>,
) -> Option<Primitive> {
    let [curvature] = numbers(span, [("curvature", curvature)], faults)?;
    Some(Primitive::Arc { curvature })
}

/// A parametric cubic of the coefficients of u and v; a range that is not written counts as normalized.
fn cubic(
    span: Span,
    [u, v]: [[NamedNumber<'_>; 4]; 2],
    range: Option<ParameterRange>,
    faults: &mut Vec<Fault>,
) -> Option<Primitive> {
    let (u, v) = (numbers(span, u, faults), numbers(span, v, faults));
    let range = range.unwrap_or(ParameterRange::Normalized);
    Some(Primitive::ParamPoly3 { u: u?, v: v?, range })
}

fn range(written: Option<ParamPoly3Range>) -> Option<ParameterRange> {
    match written {
        Some(ParamPoly3Range::ArcLength) => Some(ParameterRange::ArcLength),
        Some(ParamPoly3Range::Normalized) => Some(ParameterRange::Normalized),
        _ => None,
    }
}

/// A `<curveLocal>` of an object's outline that is a curve, in the object's own frame (OpenDRIVE 1.9.0, 13).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalCurve {
    /// Where it begins: u and v `[m]`, heading `[rad]`; a heading that is not written is 0.
    pub start: Start,
    /// Length as written `[m]`.
    pub length: f64,
    /// The shape as written.
    pub primitive: Primitive,
}

/// The curve of a `<curveLocal>`; none where it lacks its place or its length, or has not exactly one shape with all its numbers.
pub fn local_curve(curve: &CurveLocal) -> Option<LocalCurve> {
    let faults = &mut Vec::new();
    let number = |attribute: &Option<Attribute<f64>>| Some(attribute.as_ref()?.value);
    let heading = number(&curve.hdg).unwrap_or(0.0);
    let start = Start::new(number(&curve.u)?, number(&curve.v)?, heading);
    let primitive = match (&curve.line, &curve.arc, &curve.param_poly3) {
        (Some(_), None, None) => Primitive::Line,
        (None, Some(p), None) => arc(p.span, &p.curvature, faults)?,
        (None, None, Some(p)) => {
            let u = [("aU", &p.a_u), ("bU", &p.b_u), ("cU", &p.c_u), ("dU", &p.d_u)];
            let v = [("aV", &p.a_v), ("bV", &p.b_v), ("cV", &p.c_v), ("dV", &p.d_v)];
            cubic(p.span, [u, v], range(value(&p.p_range)), faults)?
        }
        _ => return None,
    };
    Some(LocalCurve { start, length: number(&curve.length)?, primitive })
}

impl Piece {
    /// The curve of a geometry; none where something is wrong with it, with all that is.
    fn new(g: &Geometry, index: usize, faults: &mut Vec<Fault>) -> Option<Self> {
        let written =
            [("s", &g.s), ("x", &g.x), ("y", &g.y), ("hdg", &g.hdg), ("length", &g.length)];
        let numbers = numbers(g.span, written, faults);
        let primitive = primitive(g, faults);
        let ([s, x, y, heading, length], (primitive, range)) = (numbers?, primitive?);
        let compiled =
            compiled(&primitive, length).map_err(|error| faults.push(Fault::Curve(error)));
        let start = Start::new(x, y, heading);
        Some(Self { s, length, index, start, range, compiled: compiled.ok()? })
    }

    /// The curve.
    pub fn curve(&self) -> Option<Curve<'_>> {
        Curve::new(self.compiled.kind, self.start, self.length, &self.compiled.coefficients)
    }

    /// Everything about the point at a distance from the piece's start `[m]`, kept within its length.
    pub fn at(&self, u: f64) -> Option<CurvePoint> {
        Some(self.curve()?.evaluate(u))
    }

    /// The place there in plan view `[m]`, the same bits as in [`Piece::at`].
    pub(crate) fn place(&self, u: f64) -> Option<[f64; 2]> {
        let Tangent { x, y, .. } = self.curve()?.tangent(u);
        Some([x, y])
    }

    /// The heading there `[rad]`, the same bits as in [`Piece::at`].
    pub(crate) fn heading(&self, u: f64) -> Option<f64> {
        Some(self.curve()?.heading(u))
    }

    /// The curvature there `[1/m]`, the same bits as in [`Piece::at`].
    pub(crate) fn curvature(&self, u: f64) -> Option<f64> {
        Some(self.curve()?.curvature(u))
    }
}

/// The geometries of a road or junction, in file order.
#[derive(Clone, Debug, Default)]
pub struct ReferenceLine {
    /// Those that are curves.
    pub pieces: Vec<Piece>,
    /// What is wrong with the others, by their rank among the geometries.
    pub faults: Vec<(usize, Fault)>,
}

impl ReferenceLine {
    /// Compiles what can be compiled.
    pub fn new(plan_view: Option<&PlanView>) -> Self {
        let geometries = plan_view.map_or(&[][..], |plan_view| &plan_view.geometry);
        let mut line = Self { pieces: Vec::with_capacity(geometries.len()), faults: Vec::new() };
        let mut found = Vec::new();
        for (index, geometry) in geometries.iter().enumerate() {
            line.pieces.extend(Piece::new(geometry, index, &mut found));
            line.faults.extend(found.drain(..).map(|fault| (index, fault)));
        }
        line
    }

    /// Whether the geometries are one line from s = 0 on: each is a curve that begins behind the one before it, where that ends, as closely as in a map
    /// without warnings.
    pub(crate) fn is_whole(&self) -> bool {
        let meets = |pair: &[Piece]| {
            let [last, next] = pair else { return false };
            let (Some(end), Some(start)) = (last.at(last.length), next.at(0.0)) else {
                return false;
            };
            next.s > last.s
                && (last.s + last.length - next.s).abs() <= S_ROUNDING.value
                && mapd_geometry::hypot(start.x - end.x, start.y - end.y) <= GAP.value
                && normalize_angle(start.heading - end.heading).abs() <= KINK.value
        };
        self.faults.is_empty()
            && self.pieces.first().is_some_and(|first| first.s.abs() <= S_ROUNDING.value)
            && self.pieces.windows(2).all(meets)
    }

    /// The curve of the geometry of a rank; none where it is none.
    pub fn piece(&self, index: usize) -> Option<&Piece> {
        let at = self.pieces.binary_search_by_key(&index, |piece| piece.index).ok()?;
        self.pieces.get(at)
    }

    /// What keeps the geometry of a rank from being a curve.
    pub fn faults_of(&self, index: usize) -> impl Iterator<Item = &Fault> {
        let first = self.faults.partition_point(|(rank, _)| *rank < index);
        let rest = self.faults.get(first..).unwrap_or_default().iter();
        rest.take_while(move |(rank, _)| *rank == index).map(|(_, fault)| fault)
    }

    /// The point at `s` `[m]`, kept within the piece that begins last before it. None where there is no piece.
    pub fn at(&self, s: f64) -> Option<CurvePoint> {
        let piece = self.piece_at(s)?;
        piece.at(s - piece.s)
    }

    /// The piece that begins last before `s` `[m]`, else the first.
    fn piece_at(&self, s: f64) -> Option<&Piece> {
        self.pieces.get(self.rank_at(s))
    }

    /// Rank among the pieces of that one.
    pub(crate) fn rank_at(&self, s: f64) -> usize {
        self.pieces.partition_point(|piece| piece.s <= s).saturating_sub(1)
    }

    /// Where the last piece ends `[m]`.
    pub fn end(&self) -> f64 {
        self.pieces.last().map_or(0.0, |last| last.s + last.length)
    }
}

/// The same for places that are asked for one after the other: the curve of the last one is at hand for the next.
pub(crate) struct Walk<'a> {
    line: &'a ReferenceLine,
    /// The piece that was asked for last.
    rank: usize,
    curve: Option<Curve<'a>>,
}

impl<'a> Walk<'a> {
    /// Along a line.
    pub(crate) fn new(line: &'a ReferenceLine) -> Self {
        Self { line, rank: usize::MAX, curve: None }
    }

    /// As [`ReferenceLine::at`].
    pub(crate) fn at(&mut self, s: f64) -> Option<CurvePoint> {
        let (curve, u) = self.curve_at(s)?;
        Some(curve.evaluate(u))
    }

    /// The curvature there `[1/m]`, the same bits as in [`Walk::at`].
    pub(crate) fn curvature_at(&mut self, s: f64) -> Option<f64> {
        let (curve, u) = self.curve_at(s)?;
        Some(curve.curvature(u))
    }

    fn curve_at(&mut self, s: f64) -> Option<(&Curve<'a>, f64)> {
        let rank = self.line.rank_at(s);
        let piece = self.line.pieces.get(rank)?;
        if rank != self.rank {
            (self.rank, self.curve) = (rank, piece.curve());
        }
        Some((self.curve.as_ref()?, s - piece.s))
    }
}
