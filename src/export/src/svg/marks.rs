//! Road marks in a drawing: each line of a mark along its lane's border, broken as the file says.

use super::{Paper, points};
use mapd_client::Lane;
use mapd_client::roads::RoadMark;
use mapd_client::vocabulary::RoadMarkColor;
use mapd_web::MarkStroke;
use std::io::{Result, Write};

/// Draws a lane's marks.
pub(super) fn write(lane: &Lane<'_>, paper: Paper, out: &mut dyn Write) -> Result<()> {
    for mark in lane.road_marks() {
        for stroke in MarkStroke::of(&mark, lane.number()) {
            draw(lane, &mark, &stroke, paper, out)?;
        }
    }
    Ok(())
}

/// Draws one stroke.
fn draw(
    lane: &Lane<'_>,
    mark: &RoadMark<'_>,
    stroke: &MarkStroke,
    paper: Paper,
    out: &mut dyn Write,
) -> Result<()> {
    let line = stroke.line(lane, mark);
    if line.len() < 2 {
        return Ok(());
    }
    write!(
        out,
        "<path class=\"mark {}\" stroke-width=\"{:.3}\"",
        class(stroke.color),
        stroke.width
    )?;
    write!(out, " d=\"")?;
    // Dashes lie at s, which is no length along the line: each is drawn by itself.
    for dash in stroke.painted(&line) {
        points(dash.into_iter(), paper, 'M', out)?;
    }
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
