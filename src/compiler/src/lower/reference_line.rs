//! The reference line and the cubics along it.

use super::need::{ElementContext, ElementPath, MOST_COEFFICIENT};
use crate::draft::{Draft, between};
use mapd_archive::{CubicRow, GeometryRow, Range};
use mapd_geometry::ParameterRange;
use mapd_rules::catalog::building;
use mapd_rules::line::{Fault, Piece, ReferenceLine};
use mapd_xodr::{self as xodr, CubicRecord, Finding, Severity, Span, Value as _};

/// Path of a geometry within its road.
const GEOMETRY: &str = "planView/geometry";

impl Draft {
    /// Appends the geometries of a reference line, which are the curves that the rules looked at.
    pub(super) fn geometries(
        &mut self,
        plan_view: &xodr::PlanView,
        line: &ReferenceLine,
        road: &str,
        findings: &mut Vec<Finding>,
    ) -> Range {
        let before = self.rows.geometries.len();
        for (index, g) in plan_view.geometry.iter().enumerate() {
            let (found, far) = (findings.len(), self.too_far.len());
            let mut part =
                ElementContext { span: g.span, path: ElementPath::new(road, GEOMETRY), findings };
            match line.piece(index) {
                Some(piece) => self.geometry(piece, g.param_poly3.is_some(), &mut part),
                None => line.faults_of(index).for_each(|fault| say(fault, g.span, &mut part)),
            }
            // Which one, only where there is something to say: writing a number takes longer than lowering a line.
            if let Some(s) = g.s.value() {
                let far = self.too_far.iter_mut().skip(far);
                for finding in findings.iter_mut().skip(found).chain(far) {
                    finding.path = format!("{road}/{GEOMETRY}[@s={s}]");
                }
            }
        }
        between(before, self.rows.geometries.len())
    }

    /// Appends a geometry.
    fn geometry(&mut self, piece: &Piece, is_parametric: bool, part: &mut ElementContext<'_>) {
        let along = [(piece.s, "s"), (piece.length, "length")];
        if !along.iter().all(|(value, name)| part.need_along(Some(*value), name).is_some()) {
            return;
        }
        let parameter_range = match piece.range {
            Some(ParameterRange::ArcLength) => 1,
            Some(ParameterRange::Normalized) => 2,
            None => 0,
        };
        if is_parametric && piece.range.is_none() {
            let message = "expected paramPoly3/@pRange, found none; read as normalized".to_owned();
            part.add(&building::P_RANGE, Severity::Warning, message);
            if let Some(finding) = part.findings.last_mut() {
                finding.hint = "write pRange=\"normalized\" or pRange=\"arcLength\"".to_owned();
            }
        }
        let Piece { start, compiled, .. } = piece;
        self.too_far.extend(part.too_far([start.x, start.y]));
        let first = self.rows.coefficients.len();
        self.rows.coefficients.extend_from_slice(&compiled.coefficients);
        self.rows.geometries.push(GeometryRow {
            s: piece.s,
            x: start.x,
            y: start.y,
            hdg: start.heading,
            cos: start.cos,
            sin: start.sin,
            length: piece.length,
            coefficients: self.coefficients.add(&mut self.rows.coefficients, first),
            error: (compiled.error as f32).next_up(),
            kind: compiled.kind.code(),
            parameter_range,
            reserved: [0; 2],
        });
    }

    /// Records with `shift` added to their s, by s.
    pub(super) fn cubics<R: CubicRecord>(
        &mut self,
        records: &[R],
        shift: f64,
        path: ElementPath<'_>,
        findings: &mut Vec<Finding>,
    ) -> Range {
        let before = self.rows.cubics.len();
        for record in records {
            let [a, b, c, d] = record.coefficients();
            let (Some(s), Some(a), Some(b), Some(c), Some(d)) = (record.start(), a, b, c, d) else {
                incomplete(record, &mut ElementContext { span: record.span(), path, findings });
                continue;
            };
            if let Some(value) = [a, b, c, d].iter().find(|value| value.abs() > MOST_COEFFICIENT) {
                let mut part = ElementContext { span: record.span(), path, findings };
                too_steep(&mut part, *value);
                continue;
            }
            self.rows.cubics.push(CubicRow { s: s + shift, a, b, c, d });
        }
        self.cubics.add(&mut self.rows.cubics, before)
    }
}

/// Says what a record lacks.
#[cold]
fn incomplete<R: CubicRecord>(record: &R, part: &mut ElementContext<'_>) {
    part.need(record.start(), R::START);
    for (name, value) in ["a", "b", "c", "d"].iter().zip(record.coefficients()) {
        part.need(value, name);
    }
}

/// Says that a coefficient is beyond measure.
#[cold]
fn too_steep(part: &mut ElementContext<'_>, value: f64) {
    let message = format!(
        "expected coefficients from -{MOST_COEFFICIENT:e} to {MOST_COEFFICIENT:e}, found {value:e}"
    );
    part.unusable("", message);
}

/// Says what keeps a geometry from being a curve.
#[cold]
fn say(fault: &Fault, geometry: Span, part: &mut ElementContext<'_>) {
    match fault {
        Fault::Missing { name, span } => {
            part.span = *span;
            part.need(None::<f64>, name);
            part.span = geometry;
        }
        Fault::Shapes(count) => {
            let found = if *count == 0 { "none".to_owned() } else { format!("{count} of them") };
            let shapes = "line, spiral, arc, poly3, paramPoly3";
            part.unusable("", format!("expected one of {shapes}, found {found}"));
        }
        Fault::Curve(error) => {
            let message = format!("the curve cannot be evaluated: {error}");
            part.unusable("", message);
        }
    }
}
