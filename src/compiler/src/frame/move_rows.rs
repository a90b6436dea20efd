//! Moves what the file has in x, y and z.

use super::{TargetFrame, scales};
use crate::draft::{Draft, Interned};
use crate::findings::finding;
use crate::resolve::Resolved;
use glam::{DVec2, DVec3};
use mapd_archive::{CubicRow, GeometryRow, Range, Rows};
use mapd_geometry::{Curve, CurveKind, CurveTransform, Start};
use mapd_query::compiling::ByRow as _;
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity, Span};
use rayon::prelude::*;
use std::collections::HashMap;

/// Geometries that one task moves.
const GEOMETRIES_PER_TASK: usize = 64;
/// Parts into which each edge of a rectangle is cut: straight lines bend on their way.
const EDGE_PARTS: usize = 8;

/// A geometry in the target frame.
struct Moved {
    row: GeometryRow,
    coefficients: Vec<f64>,
    /// Bound of its distance from the exact image `[m]`.
    error: f64,
    scale: [f64; 2],
}

/// Moves everything; errors for what has no place in the target frame.
pub(super) fn all(
    frame: &mut TargetFrame,
    draft: &mut Draft,
    signals: &mut Resolved,
    findings: &mut Vec<Finding>,
) {
    geometries(frame, draft, findings);
    heights(frame.height_shift, draft);
    grids(frame, draft, findings);
    quarantined(frame, draft);
    signals.move_by(&|at, heading| frame.standing(at, heading));
}

fn geometries(frame: &mut TargetFrame, draft: &mut Draft, findings: &mut Vec<Finding>) {
    let rows = &mut draft.rows;
    let transform = CurveTransform::default();
    let moved: Vec<Vec<Result<Moved, String>>> = {
        let one = |row: &GeometryRow| geometry(frame, &transform, row, &rows.coefficients);
        let tasks = rows.geometries.par_chunks(GEOMETRIES_PER_TASK);
        tasks.map(|chunk| chunk.iter().map(one).collect()).collect()
    };
    let (mut coefficients, mut shapes) = (Vec::new(), Interned::default());
    let mut failed = Vec::new();
    let mut error = 0.0_f64;
    for (number, moved) in moved.into_iter().flatten().enumerate() {
        match moved {
            Ok(mut moved) => {
                let before = coefficients.len();
                coefficients.extend_from_slice(&moved.coefficients);
                moved.row.coefficients = shapes.add(&mut coefficients, before);
                error = error.max(moved.error);
                frame.scale[0] = frame.scale[0].min(moved.scale[0]);
                frame.scale[1] = frame.scale[1].max(moved.scale[1]);
                rows.geometries[number] = moved.row;
            }
            Err(why) => failed.push((number as u32, why)),
        }
    }
    rows.coefficients = coefficients.into();
    frame.error += error;
    for (number, why) in failed {
        let message = format!("cannot be transformed into {}: {why}", frame.target);
        findings.push(about_geometry(draft, number, message));
    }
}

/// An error about the road that a geometry belongs to.
#[cold]
fn about_geometry(draft: &Draft, number: u32, message: String) -> Finding {
    let owns = |range: Range| range.first <= number && u64::from(number) < range.end();
    let road = draft.rows.roads.iter().position(|road| owns(road.geometries));
    let span = road.and_then(|road| draft.road_spans.get(road).copied());
    let path = match road {
        Some(_) => "OpenDRIVE/road/planView/geometry",
        None => "OpenDRIVE/junction/planView/geometry",
    };
    let span = span.unwrap_or_default();
    finding(&building::TARGET_FRAME, Severity::Error, span, path.to_owned(), message, "")
}

/// A geometry that has been read.
pub(super) fn curve<'a>(row: &GeometryRow, coefficients: &'a [f64]) -> Option<Curve<'a>> {
    let start = Start { x: row.x, y: row.y, heading: row.hdg, cos: row.cos, sin: row.sin };
    let kind = CurveKind::from_code(row.kind)?;
    Curve::new(kind, start, row.length, row.coefficients.of(coefficients))
}

fn geometry(
    frame: &TargetFrame,
    transform: &CurveTransform,
    row: &GeometryRow,
    coefficients: &[f64],
) -> Result<Moved, String> {
    let curve = curve(row, coefficients).ok_or("its curve is damaged")?;
    let mut chart_error = 0.0_f64;
    let moved = transform.apply(&curve, |at| {
        let chart = frame.charts.at(at)?;
        chart_error = chart_error.max(chart.error());
        Some(chart)
    });
    let moved = moved.map_err(|error| error.to_string())?;
    let mut scale = [f64::INFINITY, f64::NEG_INFINITY];
    for u in [0.0, 0.5 * row.length, row.length] {
        let at = curve.tangent(u);
        let at = DVec2::new(at.x, at.y);
        if let Some(chart) = frame.charts.at(at) {
            let [low, high] = scales(chart.slopes_at(at));
            scale = [scale[0].min(low), scale[1].max(high)];
        }
    }
    let error = f64::from(row.error) * scale[1] + moved.error;
    let row = GeometryRow {
        x: moved.start.x,
        y: moved.start.y,
        hdg: moved.start.heading,
        cos: moved.start.cos,
        sin: moved.start.sin,
        error: (error as f32).next_up(),
        kind: CurveKind::Transformed.code(),
        ..*row
    };
    Ok(Moved { row, coefficients: moved.coefficients, error: error + chart_error, scale })
}

/// Moves whatever has a height of its own.
fn heights(shift: f64, draft: &mut Draft) {
    if shift == 0.0 {
        return;
    }
    let rows = &mut draft.rows;
    // Other tables and other roads may use the same records: these are put beside them, once.
    let mut lifted: HashMap<(u32, u32), Range> = HashMap::new();
    for road in rows.roads.iter_mut() {
        let written = road.elevations;
        road.elevations = *lifted.entry((written.first, written.count)).or_insert_with(|| {
            let mut records = written.of(&rows.cubics).to_vec();
            if records.first().is_none_or(|first| first.s > 0.0) {
                // Where no record holds, the height is 0.
                records.insert(0, CubicRow { s: 0.0, a: 0.0, b: 0.0, c: 0.0, d: 0.0 });
            }
            let before = rows.cubics.len();
            rows.cubics.extend(records.iter().map(|row| CubicRow { a: row.a + shift, ..*row }));
            Range::between(before, rows.cubics.len()).unwrap_or_default()
        });
    }
    for row in rows.grid_rows.iter_mut() {
        row.center += shift;
    }
    for height in rows.grid_heights.iter_mut() {
        *height += shift;
    }
}

fn grids(frame: &TargetFrame, draft: &mut Draft, findings: &mut Vec<Finding>) {
    for grid in draft.rows.elevation_grids.iter_mut() {
        let at = DVec2::new(grid.x, grid.y);
        let Some(chart) = frame.charts.at(at) else {
            let message = format!(
                "the elevation grid at ({:.1}, {:.1}) lies outside the area of {}",
                at.x, at.y, frame.target
            );
            let path = "OpenDRIVE/junction/elevationGrid".to_owned();
            let severity = Severity::Error;
            findings.push(finding(
                &building::TARGET_FRAME,
                severity,
                Span::default(),
                path,
                message,
                "",
            ));
            continue;
        };
        let [by_x, by_y] = chart.slopes_at(at);
        let along = by_x * grid.cos + by_y * grid.sin;
        let scale = along.length();
        let image = chart.whole(at);
        (grid.x, grid.y) = (image.x, image.y);
        (grid.cos, grid.sin) = (along.x / scale, along.y / scale);
        // The grid stays where its heights were measured, which is a matter of places, not of lengths as written.
        grid.s_start *= scale;
        grid.spacing *= scale;
    }
}

/// Moves the rectangles around what was left out.
fn quarantined(frame: &TargetFrame, draft: &mut Draft) {
    for part in draft.rows.quarantined.iter_mut().filter(|part| part.has_extent == 1) {
        let low = DVec2::new(part.min_x, part.min_y);
        let high = DVec2::new(part.max_x, part.max_y);
        let (mut min, mut max) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let mut whole = true;
        for at in edge(low, high) {
            match frame.charts.at(at) {
                Some(chart) => {
                    let image = chart.whole(at);
                    (min, max) = (min.min(image), max.max(image));
                }
                None => whole = false,
            }
        }
        if !whole {
            (min, max) = (DVec2::ZERO, DVec2::ZERO);
            part.has_extent = 0;
        }
        (part.min_x, part.min_y, part.max_x, part.max_y) = (min.x, min.y, max.x, max.y);
    }
}

/// Places around a rectangle.
pub(crate) fn edge(low: DVec2, high: DVec2) -> impl Iterator<Item = DVec2> {
    (0..=EDGE_PARTS).flat_map(move |part| {
        let at = low.lerp(high, part as f64 / EDGE_PARTS as f64);
        [
            DVec2::new(at.x, low.y),
            DVec2::new(at.x, high.y),
            DVec2::new(low.x, at.y),
            DVec2::new(high.x, at.y),
        ]
    })
}

/// Smallest and largest coordinates of all lanes in the file's frame; none for a map without lanes.
pub(super) fn file_bounds(frame: &TargetFrame, rows: &Rows) -> Option<[DVec3; 2]> {
    let map = rows.map.first()?;
    let none = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let join = |a: (DVec2, DVec2), b: (DVec2, DVec2)| (a.0.min(b.0), a.1.max(b.1));
    let archive = crate::sample::view(rows);
    let seen = mapd_query::Map::new(&archive, 0);
    let numbers: Vec<u32> = (0..rows.lanes.len() as u32).collect();
    let lanes = numbers.par_chunks(GEOMETRIES_PER_TASK).map(|lanes| {
        let mut bounds = none;
        let mut chart: Option<super::Local> = None;
        for lane in lanes.iter().filter_map(|lane| seen.lane_by_row(*lane)) {
            for at in lane.border().positions().map(DVec3::truncate) {
                if !chart.as_ref().is_some_and(|chart| chart.holds(at)) {
                    chart = frame.back.at(at);
                }
                if let Some(chart) = &chart {
                    let image = chart.whole(at);
                    bounds = join(bounds, (image, image));
                }
            }
        }
        bounds
    });
    let (low, high) = lanes.reduce(|| none, join);
    let shift = frame.height_shift;
    let bounds = [low.extend(map.min_z - shift), high.extend(map.max_z - shift)];
    bounds.iter().all(|corner| corner.is_finite()).then_some(bounds)
}
