//! Lanes: areas, borders, reference lines, marks, directions.

use super::{MOST_PARTS, place, sections};
use crate::drawing::{Dashes, Drawing, EdgePoint, Fill, Pen};
use crate::paint::Paint;
use crate::strokes::MarkStroke;
use mapd_query::glam::DVec2;
use mapd_query::roads::LinePoint;
use mapd_query::{Lane, LaneSection, Map};

/// Size of the triangle that shows where a lane leads `[m]`.
const WAY: f64 = 1.1;
/// The shortest lane that has one `[m]`.
const SHORTEST_WAY: f64 = 6.0;
/// From one to the next on a long lane `[m]`.
const WAY_STEP: f64 = 60.0;

fn lanes<'a>(section: &LaneSection<'a>) -> impl Iterator<Item = Lane<'a>> + use<'a> {
    section.lanes().filter(|lane| lane.number() != 0)
}

pub(super) fn areas(map: Map<'_>, drawing: &mut Drawing) {
    for (level, section) in sections(map) {
        drawing.near(place(&section).truncate());
        for lane in lanes(&section) {
            area(&lane, Paint::from(lane.kind()), level, drawing);
        }
    }
}

/// The area of one lane.
pub(crate) fn area(lane: &Lane<'_>, paint: Paint, level: i64, drawing: &mut Drawing) {
    let (left, right) = (lane.left_bound_of_reference_line(), lane.right_bound_of_reference_line());
    if left.len() > 1 && right.len() > 1 {
        let point = |at: LinePoint| EdgePoint { s: at.s, position: at.position };
        let fill = Fill { paint: paint as u8, level };
        drawing.strip(left.points().map(point), right.points().map(point), fill);
    }
}

pub(super) fn borders(map: Map<'_>, drawing: &mut Drawing) {
    for (level, section) in sections(map) {
        drawing.near(place(&section).truncate());
        let is_in_junction = section.road().is_some_and(|road| road.junction().is_some());
        let paint = if is_in_junction { Paint::JunctionBorder } else { Paint::Border };
        let pen = Pen { paint: paint as u8, level, ..Pen::default() };
        for lane in lanes(&section) {
            drawing.line(lane.border().positions(), &pen);
        }
    }
}

pub(super) fn reference_lines(map: Map<'_>, drawing: &mut Drawing) {
    for (level, section) in sections(map) {
        drawing.near(place(&section).truncate());
        let pen = Pen { paint: Paint::Reference as u8, level, ..Pen::default() };
        if let Some(center) = section.lane(0) {
            drawing.line(center.border().positions(), &pen);
        }
    }
}

pub(super) fn marks(map: Map<'_>, drawing: &mut Drawing) {
    for (level, section) in sections(map) {
        drawing.near(place(&section).truncate());
        for lane in section.lanes() {
            for mark in lane.road_marks() {
                for stroke in MarkStroke::of(&mark, lane.number()) {
                    let pen =
                        Pen { paint: Paint::from(stroke.color) as u8, level, width: stroke.width };
                    let from = stroke.extent.pattern_s;
                    let dashes = stroke.extent.dashes.map(|lengths| Dashes { from, lengths });
                    let line = stroke.line(&lane, &mark).into_iter();
                    let point = |at: LinePoint| EdgePoint { s: at.s, position: at.position };
                    drawing.line_along(line.map(point), dashes, &pen);
                }
            }
        }
    }
}

/// Triangles in lanes that motor vehicles use, pointing where they drive.
pub(super) fn directions(map: Map<'_>, drawing: &mut Drawing) {
    for (level, section) in sections(map) {
        drawing.near(place(&section).truncate());
        let (start, end) = (section.s_start(), section.s_end());
        let count = (((end - start) / WAY_STEP).round() as usize).clamp(1, MOST_PARTS);
        let is_shown = |lane: &Lane<'_>| lane.kind().is_drivable() && !lane.is_bidirectional();
        for lane in lanes(&section).filter(is_shown).filter(|_| end - start >= SHORTEST_WAY) {
            for i in 0..count {
                let s = start + (end - start) * (i as f64 + 0.5) / count as f64;
                direction(&lane, s, level, drawing);
            }
        }
    }
}

fn direction(lane: &Lane<'_>, s: f64, level: i64, drawing: &mut Drawing) {
    let Ok(pose) = lane.pose_at(s, 0.0) else { return };
    if lane.width_at(s) < WAY {
        return;
    }
    let ahead = (DVec2::new(libm::cos(pose.heading), libm::sin(pose.heading)) * WAY).extend(0.0);
    let side = ahead.truncate().perp().extend(0.0);
    let tips = [
        pose.position + ahead,
        pose.position - 0.5 * ahead + 0.45 * side,
        pose.position - 0.5 * ahead - 0.45 * side,
    ];
    drawing.area(&tips, Paint::Direction as u8, level);
}
