//! The reference line of a road, ready to be evaluated.

use crate::place::{number, value};
use mapd_geometry::{Compiled, Curve, CurvePoint, ParameterRange, Primitive, Start, compile};
use mapd_xodr::{Geometry, ParamPoly3Range, PlanView};

/// A geometry that could be compiled.
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
    /// The shape, and how far its true length is from the one that is written.
    pub compiled: Compiled,
}

impl Piece {
    fn new(geometry: &Geometry, index: usize) -> Option<Self> {
        let length = number(&geometry.length);
        let start = Start::new(number(&geometry.x), number(&geometry.y), number(&geometry.hdg));
        let compiled = compile(&primitive(geometry)?, length).ok()?;
        Some(Self { s: number(&geometry.s), length, index, start, compiled })
    }

    /// The curve.
    pub fn curve(&self) -> Option<Curve<'_>> {
        Curve::new(self.compiled.kind, self.start, self.length, &self.compiled.coefficients)
    }

    /// Everything about the point at a distance from the piece's start `[m]`, kept within its length.
    pub fn at(&self, u: f64) -> Option<CurvePoint> {
        Some(self.curve()?.evaluate(u))
    }
}

/// The shape that a geometry has, as written; none where it has none. Missing numbers count as 0.
pub fn primitive(geometry: &Geometry) -> Option<Primitive> {
    if geometry.line.is_some() {
        Some(Primitive::Line)
    } else if let Some(arc) = &geometry.arc {
        Some(Primitive::Arc { curvature: number(&arc.curvature) })
    } else if let Some(spiral) = &geometry.spiral {
        let (curvature_start, curvature_end) =
            (number(&spiral.curv_start), number(&spiral.curv_end));
        Some(Primitive::Spiral { curvature_start, curvature_end })
    } else if let Some(p) = &geometry.poly3 {
        Some(Primitive::Poly3 { v: [number(&p.a), number(&p.b), number(&p.c), number(&p.d)] })
    } else if let Some(p) = &geometry.param_poly3 {
        let range = match value(&p.p_range) {
            Some(ParamPoly3Range::ArcLength) => ParameterRange::ArcLength,
            _ => ParameterRange::Normalized,
        };
        Some(Primitive::ParamPoly3 {
            u: [number(&p.a_u), number(&p.b_u), number(&p.c_u), number(&p.d_u)],
            v: [number(&p.a_v), number(&p.b_v), number(&p.c_v), number(&p.d_v)],
            range,
        })
    } else {
        None
    }
}

/// The geometries of a road that can be evaluated, in file order.
#[derive(Clone, Debug, Default)]
pub struct ReferenceLine {
    /// The pieces.
    pub pieces: Vec<Piece>,
}

impl ReferenceLine {
    /// Compiles what can be compiled.
    pub fn new(plan_view: Option<&PlanView>) -> Self {
        let geometries = plan_view.map_or(&[][..], |plan_view| &plan_view.geometry);
        let pieces = geometries.iter().enumerate();
        Self {
            pieces: pieces.filter_map(|(index, geometry)| Piece::new(geometry, index)).collect(),
        }
    }

    /// The point at `s` `[m]`, kept within the piece that begins last before it. None where there is no piece.
    pub fn at(&self, s: f64) -> Option<CurvePoint> {
        let after = self.pieces.partition_point(|piece| piece.s <= s);
        let piece = self.pieces.get(after.saturating_sub(1))?;
        piece.at(s - piece.s)
    }

    /// Where the last piece ends `[m]`.
    pub fn end(&self) -> f64 {
        self.pieces.last().map_or(0.0, |last| last.s + last.length)
    }
}
