//! Corners of outlines in the object's frame.

use super::line::Line;
use super::place::Standing;
use super::{MOST_MADE_OF_AN_OBJECT, Shape};
use crate::draft::single;
use crate::draft::{Corner, Curve, Outline};
use crate::sample::{Fault, flatten};
use glam::DVec3;
use mapd_archive::{NONE, ObjectPointRow, outline_flags};
use mapd_geometry::{Start, compile};

/// A corner in the object's frame.
pub(super) fn point(local: DVec3, height: f64) -> ObjectPointRow {
    let [u, v, z] = local.to_array().map(single);
    ObjectPointRow { u, v, z, height: single(height) }
}

/// An outline with its corners placed; none where no corner is left.
///
/// Errors: a place is not finite, or its curves make more points than an object may have.
pub(super) fn shape(
    line: &Line<'_>,
    standing: &Standing,
    outline: &Outline,
    tolerance: f64,
) -> Result<Option<Shape>, Fault> {
    let mut points = Vec::with_capacity(outline.corners.len());
    let is_closed = outline.row.flags & outline_flags::CLOSED != 0;
    let mut corners = Vec::new();
    let mut made = 0;
    for (i, corner) in outline.corners.iter().enumerate() {
        if let Some(id) = outline.ids.get(i).filter(|id| **id != NONE) {
            corners.push((*id, points.len() as u32));
        }
        match corner {
            Corner::Road([s, t, dz, height]) => {
                let station = line.at(*s, *t).ok_or(Fault::NotFinite)?;
                let from_origin = station.position + DVec3::Z * *dz - standing.origin;
                points.push(point(standing.axes.to_local(from_origin), *height));
            }
            Corner::Local([u, v, z, height]) => {
                points.push(point(DVec3::new(*u, *v, *z), *height));
            }
            Corner::Curve(curve) => {
                let next = outline.corners.get(i + 1).or(outline.corners.first());
                let end = match next {
                    Some(Corner::Curve(next)) if is_closed || i + 1 < outline.corners.len() => {
                        [next.start[2], next.start[3]]
                    }
                    _ => [curve.start[2], curve.start[3]],
                };
                let before = points.len();
                let is_last = i + 1 == outline.corners.len();
                curve_points(curve, end, is_last && !is_closed, tolerance, &mut points)?;
                made += points.len() - before;
                if made > MOST_MADE_OF_AN_OBJECT {
                    return Err(Fault::TooManyPoints);
                }
            }
        }
    }
    let shape = Shape { row: outline.row, points, made, corners };
    Ok(Some(shape).filter(|shape| !shape.points.is_empty()))
}

/// Corners along a curve; its end is the next one's start. z and height change linearly to the next curve's.
fn curve_points(
    curve: &Curve,
    [end_z, end_height]: [f64; 2],
    with_end: bool,
    tolerance: f64,
    points: &mut Vec<ObjectPointRow>,
) -> Result<(), Fault> {
    let [u, v, z, height] = curve.start;
    let compiled = compile(&curve.primitive, curve.length).map_err(|_| Fault::NotFinite)?;
    let start = Start::new(u, v, curve.heading);
    let shape =
        mapd_geometry::Curve::new(compiled.kind, start, curve.length, &compiled.coefficients)
            .ok_or(Fault::NotFinite)?;
    let share = |s: f64| if curve.length > 0.0 { s / curve.length } else { 0.0 };
    let mut at = |s: f64| {
        let p = shape.evaluate(s);
        let p = DVec3::new(p.x, p.y, z + (end_z - z) * share(s));
        p.is_finite().then_some(p)
    };
    let mut samples = Vec::new();
    flatten(&[0.0, curve.length], tolerance, &mut at, &mut samples)?;
    let count = if with_end { samples.len() } else { samples.len().saturating_sub(1).max(1) };
    let placed = samples.iter().take(count);
    points.extend(placed.map(|p| point(p.position, height + (end_height - height) * share(p.s))));
    Ok(())
}
