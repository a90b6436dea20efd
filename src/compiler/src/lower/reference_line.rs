//! The reference line and the cubics along it.

use super::need::Part;
use super::{Lowering, between};
use mapd_archive::{CubicRow, GeometryRow, Range};
use mapd_geometry::{ParameterRange, Primitive, Start, compile};
use mapd_xodr::{
    self as xodr, Attribute, CubicRecord, Finding, ParamPoly3Range, Severity, Span, Value as _,
};

/// Path of a geometry within its road.
const GEOMETRY: &str = "planView/geometry";

impl Lowering {
    pub(super) fn geometries(
        &mut self,
        plan_view: &xodr::PlanView,
        road: &str,
        findings: &mut Vec<Finding>,
    ) -> Range {
        let before = self.rows.geometries.len();
        for g in &plan_view.geometry {
            let found = findings.len();
            self.geometry(g, &mut Part { span: g.span, path: (road, GEOMETRY), findings });
            // Which one, only where there is something to say: writing a number takes longer than lowering a line.
            if let Some(s) = g.s.value() {
                for finding in findings.iter_mut().skip(found) {
                    finding.path = format!("{road}/{GEOMETRY}[@s={s}]");
                }
            }
        }
        between(before, self.rows.geometries.len())
    }

    /// Appends a geometry.
    fn geometry(&mut self, g: &xodr::Geometry, part: &mut Part<'_>) {
        let numbers =
            [("s", &g.s), ("x", &g.x), ("y", &g.y), ("hdg", &g.hdg), ("length", &g.length)]
                .map(|(name, attribute)| part.need(attribute.value(), name));
        let primitive = primitive(g, part);
        let (
            [Some(s), Some(x), Some(y), Some(hdg), Some(length)],
            Some((primitive, parameter_range)),
        ) = (numbers, primitive)
        else {
            return;
        };
        let compiled = match compile(&primitive, length) {
            Ok(compiled) => compiled,
            Err(error) => {
                let message = format!("the curve cannot be evaluated: {error}");
                return part.add("mapd:compile.curve", Severity::Error, message);
            }
        };
        let start = Start::new(x, y, hdg);
        let first = self.rows.coefficients.len();
        self.rows.coefficients.extend_from_slice(&compiled.coefficients);
        self.rows.geometries.push(GeometryRow {
            s,
            x,
            y,
            hdg,
            cos: start.cos,
            sin: start.sin,
            length,
            coefficients: between(first, self.rows.coefficients.len()),
            error: (compiled.error as f32).next_up(),
            kind: compiled.kind.code(),
            parameter_range,
            reserved: [0; 2],
        });
    }

    /// Records with `shift` added to their s, by s. Where the file's order differs (a finding: by rounding a warning, else
    /// an error) s decides, because a record holds until the next one along the road.
    pub(super) fn cubics<R: CubicRecord>(
        &mut self,
        records: &[R],
        shift: f64,
        path: (&str, &str),
        findings: &mut Vec<Finding>,
    ) -> Range {
        let before = self.rows.cubics.len();
        for record in records {
            let [a, b, c, d] = record.coefficients();
            let (Some(s), Some(a), Some(b), Some(c), Some(d)) = (record.start(), a, b, c, d) else {
                incomplete(record, &mut Part { span: record.span(), path, findings });
                continue;
            };
            self.rows.cubics.push(CubicRow { s: s + shift, a, b, c, d });
        }
        self.interned.add(&mut self.rows.cubics, before)
    }
}

/// Says what a record lacks.
#[cold]
fn incomplete<R: CubicRecord>(record: &R, part: &mut Part<'_>) {
    part.need(record.start(), R::START);
    for (name, value) in ["a", "b", "c", "d"].iter().zip(record.coefficients()) {
        part.need(value, name);
    }
}

/// Numbers of a shape's tag; none where one is missing, with findings about each.
fn numbers<const N: usize>(
    part: &mut Part<'_>,
    span: Span,
    written: [(&str, &Option<Attribute<f64>>); N],
) -> Option<[f64; N]> {
    let geometry = std::mem::replace(&mut part.span, span);
    let values = written.map(|(name, attribute)| part.need(attribute.value(), name));
    part.span = geometry;
    let mut all = [0.0; N];
    for (place, value) in all.iter_mut().zip(values) {
        *place = value?;
    }
    Some(all)
}

/// The primitive and the code of `pRange` as written. Of several shapes the first one that the standard names counts.
fn primitive(g: &xodr::Geometry, part: &mut Part<'_>) -> Option<(Primitive, u8)> {
    if g.line.is_some() {
        return Some((Primitive::Line, 0));
    }
    if let Some(p) = &g.spiral {
        let written = [("curvStart", &p.curv_start), ("curvEnd", &p.curv_end)];
        let [curvature_start, curvature_end] = numbers(part, p.span, written)?;
        return Some((Primitive::Spiral { curvature_start, curvature_end }, 0));
    }
    if let Some(p) = &g.arc {
        let [curvature] = numbers(part, p.span, [("curvature", &p.curvature)])?;
        return Some((Primitive::Arc { curvature }, 0));
    }
    if let Some(p) = &g.poly3 {
        let v = numbers(part, p.span, [("a", &p.a), ("b", &p.b), ("c", &p.c), ("d", &p.d)])?;
        return Some((Primitive::Poly3 { v }, 0));
    }
    let Some(p) = &g.param_poly3 else {
        let message = "expected one of line, spiral, arc, poly3, paramPoly3, found none".to_owned();
        part.unusable("", message);
        return None;
    };
    let u = [("aU", &p.a_u), ("bU", &p.b_u), ("cU", &p.c_u), ("dU", &p.d_u)];
    let v = [("aV", &p.a_v), ("bV", &p.b_v), ("cV", &p.c_v), ("dV", &p.d_v)];
    let (u, v) = (numbers(part, p.span, u), numbers(part, p.span, v));
    let (range, code) = match p.p_range.value() {
        Some(ParamPoly3Range::ArcLength) => (ParameterRange::ArcLength, 1),
        Some(ParamPoly3Range::Normalized) => (ParameterRange::Normalized, 2),
        _ => {
            let message = "expected paramPoly3/@pRange, found none; read as normalized".to_owned();
            part.add("mapd:compile.p_range", Severity::Warning, message);
            if let Some(finding) = part.findings.last_mut() {
                finding.hint = "write pRange=\"normalized\" or pRange=\"arcLength\"".to_owned();
            }
            (ParameterRange::Normalized, 0)
        }
    };
    Some((Primitive::ParamPoly3 { u: u?, v: v?, range }, code))
}
