//! Road marks in a drawing: each line of a mark along its lane's border, broken as the file says.

use super::svg::{Paper, points};
use mapd_client::glam::DVec3;
use mapd_client::{Lane, RoadMark, RoadMarkColor, RoadMarkKind, Track};
use std::io::{Result, Write};

/// Length and gap of a broken line for which the file gives none `[m]`.
const BROKEN: [f64; 2] = [3.0, 6.0];
/// Diameter of and gap between Botts' dots `[m]`.
const DOTS: [f64; 2] = [0.1, 1.2];
/// Distance between places of a mark that sways `[m]`.
const SWAY_STEP: f64 = 0.5;
/// Gap between the two lines of a double mark, in widths of one line.
const DOUBLE_GAP: f64 = 1.0;

/// One stroke along a lane's border.
struct Stroke {
    /// Middle, to the left of the border `[m]`.
    t_offset: f64,
    /// Width `[m]`.
    width: f64,
    /// Line and gap `[m]`; drawn through if there is none.
    dashes: Option<[f64; 2]>,
    /// Where it begins and ends on the road `[m]`.
    s: [f64; 2],
    color: RoadMarkColor,
}

/// Draws a lane's marks.
pub(super) fn write(lane: &Lane<'_>, paper: Paper, out: &mut dyn Write) -> Result<()> {
    for mark in lane.road_marks() {
        for stroke in strokes(&mark, lane.number()) {
            draw(lane, &mark, &stroke, paper, out)?;
        }
    }
    Ok(())
}

/// The strokes of a mark: its own lines, or those that its kind stands for.
fn strokes(mark: &RoadMark<'_>, lane: i32) -> Vec<Stroke> {
    let (width, color) = (mark.width_or_default(), mark.color());
    let whole = [mark.s(), mark.s_end()];
    if mark.lines().len() > 0 && mark.kind() != RoadMarkKind::None {
        let own = mark.lines().map(|line| {
            let start = whole[0] + line.s_offset;
            let explicit_end = (start + line.length).min(whole[1]);
            let end = if line.space.is_none() { explicit_end } else { whole[1] };
            Stroke {
                t_offset: line.t_offset,
                width: line.width.filter(|width| *width > 0.0).unwrap_or(width),
                dashes: line.space.filter(|space| *space > 0.0).map(|space| [line.length, space]),
                s: [start, end],
                color: if line.color == RoadMarkColor::NotGiven { color } else { line.color },
            }
        });
        return own.collect();
    }
    use RoadMarkKind as Kind;
    let (solid, broken) = (None, Some(BROKEN));
    // From lane 0 outwards.
    let lines: &[Option<[f64; 2]>] = match mark.kind() {
        Kind::None => &[],
        Kind::Broken => &[broken],
        Kind::SolidSolid => &[solid, solid],
        Kind::SolidBroken => &[solid, broken],
        Kind::BrokenSolid => &[broken, solid],
        Kind::BrokenBroken => &[broken, broken],
        Kind::BottsDots => &[Some(DOTS)],
        _ => &[solid],
    };
    let outwards = if lane < 0 { -1.0 } else { 1.0 };
    let middle = 0.5 * (lines.len() as f64 - 1.0);
    let place = |i: usize| outwards * (i as f64 - middle) * width * (1.0 + DOUBLE_GAP);
    let stroke = |(i, dashes): (usize, &Option<[f64; 2]>)| Stroke {
        t_offset: place(i),
        width,
        dashes: *dashes,
        s: whole,
        color,
    };
    lines.iter().enumerate().map(stroke).collect()
}

/// Draws one stroke at the places where the lane's border has points: that is within the border's tolerance.
fn draw(
    lane: &Lane<'_>,
    mark: &RoadMark<'_>,
    stroke: &Stroke,
    paper: Paper,
    out: &mut dyn Write,
) -> Result<()> {
    let [from, to] = stroke.s;
    let border = lane.border();
    let mut places: Vec<f64> = border.stations().collect();
    if mark.sways() {
        places.extend((0..((to - from) / SWAY_STEP) as usize).map(|i| from + i as f64 * SWAY_STEP));
        places.sort_by(f64::total_cmp);
    }
    places.retain(|s| *s > from && *s < to);
    places.insert(0, from);
    places.push(to);
    let line: Vec<DVec3> = places
        .into_iter()
        .filter_map(|s| {
            let t = mark.t_at(s) + stroke.t_offset;
            lane.road().to_inertial(Track { s, t, h: 0.0 }).ok()
        })
        .map(|pose| pose.position)
        .collect();
    if line.len() < 2 || from >= to {
        return Ok(());
    }
    write!(
        out,
        "<path class=\"mark {}\" stroke-width=\"{:.3}\"",
        class(stroke.color),
        stroke.width
    )?;
    if let Some([length, space]) = stroke.dashes {
        write!(out, " stroke-dasharray=\"{length:.3} {space:.3}\"")?;
    }
    write!(out, " d=\"")?;
    points(line.into_iter(), paper, 'M', out)?;
    writeln!(out, "\"/>")
}

fn class(color: RoadMarkColor) -> &'static str {
    match color {
        RoadMarkColor::Blue => "blue",
        RoadMarkColor::Green => "grass",
        RoadMarkColor::Red => "red",
        RoadMarkColor::Yellow => "yellow",
        RoadMarkColor::Black => "black",
        RoadMarkColor::Orange => "orange",
        RoadMarkColor::Violet => "violet",
        _ => "white",
    }
}
