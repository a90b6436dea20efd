//! Outlines of objects as written.

use super::need::{ElementContext, ElementPath};
use super::objects::left_out;
use crate::draft::Draft;
use crate::draft::{Corner, Curve, Outline};
use mapd_archive::{LaneType, NONE, ObjectOutlineRow, OutlineFill, Range, outline_flags};
use mapd_geometry::Start;
use mapd_rules::line::{LocalCurve, local_curve};
use mapd_xodr::{self as xodr, Attribute, Span, Text as _, Value as _};

/// Fewest corners of an outline that encloses something.
const CLOSED_CORNERS: usize = 3;
/// Types of objects whose outlines are lines unless they say that they are closed.
const LINEAR: [&str; 3] = ["barrier", "railing", "soundBarrier"];

impl Draft {
    /// The outlines of an object in the old form (a child of its own) and the new one. One without two corners or a
    /// curve is left out.
    pub(super) fn outlines(
        &self,
        object: &xodr::Object,
        part: &mut ElementContext<'_>,
    ) -> Vec<Outline> {
        let new = object.outlines.iter().flat_map(|outlines| &outlines.outline);
        let is_linear = LINEAR.contains(&object.r#type.text());
        let mut all = Vec::new();
        let old = object.outline.iter().map(|outline| &**outline);
        for (number, outline) in old.chain(new).enumerate() {
            let tail = format!("{}/outline", part.path.inside);
            let mut part = ElementContext {
                span: outline.span,
                path: ElementPath::new(part.path.owner, &tail),
                findings: part.findings,
            };
            all.extend(self::outline(outline, number, is_linear, &mut part));
        }
        all
    }
}

fn outline(
    outline: &xodr::Outline,
    number: usize,
    is_linear: bool,
    part: &mut ElementContext<'_>,
) -> Option<Outline> {
    let (mut corners, mut ids) = (Vec::new(), Vec::new());
    let mut add = |span: Span, id: Option<u32>, corner: Option<Corner>| match corner {
        Some(corner) => {
            corners.push(corner);
            ids.push(id.unwrap_or(NONE));
        }
        None => {
            let message = "a corner lacks a number, or a curve its one shape; it is left out";
            let mut part = ElementContext { span, path: part.path, findings: part.findings };
            left_out(&mut part, message.to_owned());
        }
    };
    for c in &outline.corner_road {
        let corner = numbers([&c.s, &c.t, &c.dz, &c.height]).map(Corner::Road);
        add(c.span, c.id.value(), corner);
    }
    for c in &outline.corner_local {
        let corner = numbers([&c.u, &c.v, &c.z, &c.height]).map(Corner::Local);
        add(c.span, c.id.value(), corner);
    }
    for c in &outline.curve_local {
        add(c.span, c.id.value(), curve(c).map(|c| Corner::Curve(Box::new(c))));
    }
    let has_curve = corners.iter().any(|corner| matches!(corner, Corner::Curve(_)));
    if corners.len() < 2 && !has_curve {
        let message = format!(
            "expected at least two corners or a curve, found {}; the outline is left out",
            corners.len()
        );
        left_out(part, message);
        return None;
    }
    let can_close = corners.len() >= CLOSED_CORNERS || has_curve;
    let is_closed = can_close && outline.closed.value().unwrap_or(!is_linear);
    let flags = [
        (outline.outer.value().unwrap_or(true), outline_flags::OUTER),
        (is_closed, outline_flags::CLOSED),
    ];
    let lane_type = outline.lane_type.value().map_or("none", xodr::LaneType::name);
    let fill = outline.fill_type.value().map_or("", xodr::OutlineFillType::name);
    let fill = match OutlineFill::from_name(fill) {
        OutlineFill::Unknown => OutlineFill::None,
        known => known,
    };
    let row = ObjectOutlineRow {
        points: Range::default(),
        id: outline.id.value().unwrap_or(NONE),
        fill: fill.code(),
        lane_type: LaneType::from_name(lane_type).code(),
        flags: flags.iter().filter(|(on, _)| *on).fold(0, |all, (_, flag)| all | flag),
        reserved: 0,
    };
    Some(Outline { row, corners, ids, number })
}

/// Place and height of a corner. A height that is not given is 0, and so is a z: files of 1.4 leave them out.
fn numbers([a, b, z, height]: [&Option<Attribute<f64>>; 4]) -> Option<[f64; 4]> {
    Some([a.value()?, b.value()?, z.value().unwrap_or(0.0), height.value().unwrap_or(0.0)])
}

/// Beside its shape a curve needs a place; height and z as of corners.
fn curve(written: &xodr::CurveLocal) -> Option<Curve> {
    let LocalCurve { start: Start { heading, .. }, length, primitive } = local_curve(written)?;
    let start = numbers([&written.u, &written.v, &written.z, &written.height])?;
    Some(Curve { start, heading, length, primitive })
}
