//! A map as a drawing: x to the right, y up, one unit a metre.

mod index_boxes;
mod marks;
mod objects;
mod route;
mod style;

use crate::{Options, Progress, Result, overlay};
use mapd_client::Bounds;
use mapd_client::glam::{DVec2, DVec3};
use mapd_client::roads::Polyline;
use mapd_client::signals::Signal;
use mapd_client::view::View;
use mapd_client::vocabulary::LaneType;
use mapd_client::{Lane, LaneSection};
pub use route::RouteEnds;
use std::io::{self, Write};

/// Room around the map `[m]`.
const MARGIN: f64 = 5.0;
/// Heights that differ by more than this are drawn one above the other `[m]`.
const LEVEL: f64 = 3.0;
/// Size of the triangle that shows where a lane leads `[m]`, and the shortest lane that has one.
const WAY: (f64, f64) = (1.2, 6.0);
/// Length of the stroke from a signal to where it faces `[m]`.
const SIGNAL: f64 = 1.0;
/// Number of digits after the point: millimetres.
const DIGITS: usize = 3;

/// From inertial coordinates to those of the drawing, relative to its upper left corner.
#[derive(Clone, Copy)]
struct Paper {
    left: f64,
    top: f64,
}

impl Paper {
    /// A point of the drawing.
    fn at(self, p: DVec2) -> DVec2 {
        DVec2::new(p.x - self.left, self.top - p.y)
    }
}

/// Writes the drawing.
///
/// Errors: what writing gives.
pub(super) fn write(
    view: View<'_>,
    options: &Options,
    progress: &mut dyn FnMut(Progress),
    out: &mut dyn Write,
) -> Result<()> {
    let map = view.map();
    let route = options.route.as_ref().map(|ends| route::line(map, ends)).transpose()?;
    let Bounds { low, high } = map.bounds();
    let size = (high - low).truncate() + 2.0 * MARGIN;
    let paper = Paper { left: low.x - MARGIN, top: high.y + MARGIN };
    writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
    writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.3} {:.3}\">",
        size.x, size.y
    )?;
    writeln!(out, "<style>{}</style>", style::SHEET)?;
    writeln!(out, "<rect class=\"ground\" width=\"100%\" height=\"100%\"/>")?;
    // Lanes without a use are often verges drawn far beyond the road: they lie below everything else.
    for lane in map.lanes().filter(|lane| lane.kind() == LaneType::None) {
        area(&lane, paper, out)?;
    }
    // What lies higher is drawn later and covers what it passes over; on one level, as in a junction, all lines are seen.
    let mut sections: Vec<(i64, LaneSection<'_>)> = map
        .roads()
        .flat_map(|road| road.sections())
        .map(|section| ((height(&section) / LEVEL).round() as i64, section))
        .collect();
    sections.sort_by_key(|(level, _)| *level);
    let mut done = 0;
    for level in sections.chunk_by(|(a, _), (b, _)| a == b) {
        let lanes = || {
            let lanes = level.iter().flat_map(|(_, section)| section.lanes());
            lanes.filter(|lane| lane.number() != 0)
        };
        for lane in lanes().filter(|lane| lane.kind() != LaneType::None) {
            Progress::tell("lanes", done, progress);
            done += 1;
            area(&lane, paper, out)?;
        }
        for lane in lanes() {
            line(lane.border(), "bound", paper, out)?;
        }
        for center in level.iter().filter_map(|(_, section)| section.lane(0)) {
            line(center.border(), "reference", paper, out)?;
        }
        for lane in level.iter().flat_map(|(_, section)| section.lanes()) {
            marks::write(&lane, paper, out)?;
        }
        for lane in lanes() {
            way(&lane, paper, out)?;
        }
    }
    progress(Progress { doing: "objects and signals", done: 0 });
    objects::write(map, paper, out)?;
    for signal in map.signals() {
        mark(&signal, paper, out)?;
    }
    for one in view.restrictions() {
        let (Some(corners), class) = (overlay::area(map, &one), overlay::class(one.entry.kind()))
        else {
            continue;
        };
        write!(out, "<path class=\"overlay {class}\" d=\"")?;
        points(corners.into_iter(), paper, 'M', out)?;
        let (id, kind, text) = (one.entry.id(), one.entry.kind().name(), one.entry.text());
        writeln!(out, "z\"><title>{}: {kind} {}</title></path>", escape(id), escape(text))?;
    }
    if let Some(line) = &route {
        route::write(line, paper, out)?;
    }
    if options.index_boxes {
        index_boxes::write(map, paper, out)?;
    }
    Ok(writeln!(out, "</svg>")?)
}

/// Height in the middle of a section `[m]`.
fn height(section: &LaneSection<'_>) -> f64 {
    let line = section.lane(0).map(|center| center.border());
    line.and_then(|line| line.position(line.len() / 2)).map_or(0.0, |p| p.z)
}

/// The lane's area, filled by its type.
fn area(lane: &Lane<'_>, paper: Paper, out: &mut dyn Write) -> io::Result<()> {
    if lane.center_line().len() < 2 {
        return Ok(());
    }
    write!(out, "<path class=\"{}\" d=\"", style::class(lane.kind()))?;
    points(lane.left_bound_of_reference_line().positions(), paper, 'M', out)?;
    let right: Vec<DVec3> = lane.right_bound_of_reference_line().positions().collect();
    points(right.into_iter().rev(), paper, 'L', out)?;
    writeln!(
        out,
        "z\"><title>{} {}</title></path>",
        escape(&lane.key().to_string()),
        lane.kind().name()
    )
}

fn line(line: Polyline<'_>, class: &str, paper: Paper, out: &mut dyn Write) -> io::Result<()> {
    if line.len() < 2 {
        return Ok(());
    }
    write!(out, "<path class=\"{class}\" d=\"")?;
    points(line.positions(), paper, 'M', out)?;
    writeln!(out, "\"/>")
}

/// Points of a path, the first one after `first`.
fn points(
    points: impl Iterator<Item = DVec3>,
    paper: Paper,
    first: char,
    out: &mut dyn Write,
) -> io::Result<()> {
    for (i, point) in points.enumerate() {
        let p = paper.at(point.truncate());
        let command = if i == 0 { first } else { ' ' };
        write!(out, "{command}{:.DIGITS$},{:.DIGITS$}", p.x, p.y)?;
    }
    Ok(())
}

/// A triangle in the middle of a lane that motor vehicles use, pointing where they drive.
fn way(lane: &Lane<'_>, paper: Paper, out: &mut dyn Write) -> io::Result<()> {
    let section = lane.section();
    let (start, end) = (section.s_start(), section.s_end());
    let (size, shortest) = WAY;
    if !lane.kind().is_drivable() || lane.is_bidirectional() || end - start < shortest {
        return Ok(());
    }
    let middle = 0.5 * (start + end);
    let Ok(pose) = lane.pose_at(middle, 0.0) else { return Ok(()) };
    if lane.width_at(middle) < size {
        return Ok(());
    }
    let ahead = DVec2::from_angle(pose.heading) * size;
    let center = pose.position.truncate();
    let tips = [
        center + ahead,
        center - 0.5 * ahead + 0.5 * ahead.perp(),
        center - 0.5 * ahead - 0.5 * ahead.perp(),
    ];
    write!(out, "<path class=\"way\" d=\"")?;
    points(tips.into_iter().map(|p| p.extend(0.0)), paper, 'M', out)?;
    writeln!(out, "z\"/>")
}

/// A dot where a signal stands, with a stroke to where it faces.
fn mark(signal: &Signal<'_>, paper: Paper, out: &mut dyn Write) -> io::Result<()> {
    let at = signal.position().truncate();
    let (from, to) = (paper.at(at), paper.at(at + DVec2::from_angle(signal.facing()) * SIGNAL));
    writeln!(
        out,
        "<path class=\"signal\" d=\"M{:.DIGITS$},{:.DIGITS$} {:.DIGITS$},{:.DIGITS$}\"><title>{} {}</title></path>",
        from.x,
        from.y,
        to.x,
        to.y,
        escape(signal.id()),
        signal.class().name()
    )
}

/// Text that may stand between tags.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
