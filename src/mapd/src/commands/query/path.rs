//! `mapd query … path`, `corridor`, `project`, `conflicts`: of routes as lines.

use super::holes::Holes;
use super::kinds::{Tools, number, numbers, text};
use super::route::Router;
use super::row::Row;
use mapd_client::Map;
use mapd_query::glam::DVec2;
use mapd_query::path::{Corridor, Path, PathBuffer, PathCrossing, PathOptions, Yields, YieldsBy};
use mapd_query::rules::Basis;
use mapd_query::vocabulary::RelationReason;

/// Columns that a route is found by.
pub(super) const ROUTE: [&str; 6] =
    ["from_road", "from_s", "from_lane", "to_road", "to_s", "to_lane"];

/// Stations of one row's answer at most.
const MOST_STATIONS: f64 = 1e6;

/// The path of the last row: rows of one route together cost one search.
#[derive(Default)]
pub(crate) struct Paths {
    buffer: PathBuffer,
    /// What the row said of its route, and why there is no path if there is none.
    known: Option<([String; 6], Result<(), String>)>,
    corridor: Corridor,
}

impl Paths {
    /// Finds the path of a row's route, unless it is the one of the row before.
    fn find(
        &mut self,
        router: &mut Router<'_>,
        holes: &Holes<'_>,
        map: Map<'_>,
        row: &Row<'_>,
    ) -> Result<(), String> {
        let asked = ROUTE.map(|column| row.text(column).unwrap_or_default().to_owned());
        if let Some((known, found)) = &self.known
            && *known == asked
        {
            return found.clone();
        }
        let found = router.find(holes, map, row).and_then(|_| {
            let options = PathOptions::default();
            map.path(router.steps(), &options, &mut self.buffer).map_err(|e| e.to_string())?;
            Ok(())
        });
        self.known = Some((asked, found.clone()));
        found
    }
}

/// Which of the answers along a route is wanted.
#[derive(Clone, Copy)]
pub(super) enum PathQuestion {
    /// The driven line.
    Line,
    /// The room beside it.
    Corridor,
    /// A point's place on it.
    Project,
    /// Who meets it.
    Conflicts,
}

/// Answers a row about the path of its route.
///
/// Errors: there is no route, or no answer along it, and why.
pub(super) fn answer<'a>(
    along: PathQuestion,
    tools: &mut Tools<'a>,
    map: Map<'a>,
    row: &Row<'_>,
    out: &mut Vec<String>,
) -> Result<(), String> {
    let Tools { router, paths, holes, .. } = tools;
    paths.find(router, holes, map, row)?;
    let path = Path::of(map, &paths.buffer).map_err(text)?;
    match along {
        PathQuestion::Line => line(&path, router, out),
        PathQuestion::Corridor => corridor(&path, router, &mut paths.corridor, out),
        PathQuestion::Project => project(&path, map, row, out),
        PathQuestion::Conflicts => conflicts(&path, router, out),
    }
}

/// `path`: a row for each station.
fn line<'a>(path: &Path<'a, '_>, router: &Router<'a>, out: &mut Vec<String>) -> Result<(), String> {
    let (view, step, end) = (router.view(), router.step(), path.length());
    check_step(step, end)?;
    let mut stations = 0u64;
    loop {
        let next = stations as f64 * step;
        stations += 1;
        let along = if next < end { next } else { end };
        let at = path.at(along).map_err(text)?;
        let p = at.position;
        numbers(out, &[at.along, p.x, p.y, p.z, at.heading, at.curvature]);
        out.push(view.map().lane(at.lane).map_err(text)?.key().to_string());
        numbers(out, &[at.left, at.right]);
        let speed = view.speed_on_path(path, along, router.vehicle()).map_err(text)?;
        out.push(speed.max.map(number).unwrap_or_default());
        if along >= end {
            return Ok(());
        }
    }
}

/// `corridor`: a row for each station.
fn corridor<'a>(
    path: &Path<'a, '_>,
    router: &Router<'a>,
    room: &mut Corridor,
    out: &mut Vec<String>,
) -> Result<(), String> {
    let (step, length) = (router.step(), path.length());
    check_step(step, length)?;
    let view = router.view();
    view.corridor(path, 0.0, length, step, router.vehicle(), room).map_err(text)?;
    path.corridor_surface(room).map_err(text)?;
    for i in 0..room.len() {
        let (left, right) = (room.left[i], room.right[i]);
        numbers(out, &[room.along[i], left.x, left.y, right.x, right.y]);
        let marks = [room.left_mark[i], room.right_mark[i]];
        out.extend(marks.map(|mark| mark.kind.name().to_owned()));
        out.extend(marks.map(|mark| u8::from(mark.may_cross).to_string()));
        out.extend(marks.map(|mark| mark.edge.name().to_owned()));
        let facts = [room.speed[i].max, room.surface[i].friction];
        out.extend(facts.map(|fact| fact.map(number).unwrap_or_default()));
    }
    Ok(())
}

/// `project`: a point.
fn project(
    path: &Path<'_, '_>,
    map: Map<'_>,
    row: &Row<'_>,
    out: &mut Vec<String>,
) -> Result<(), String> {
    let point = DVec2::new(row.number("x")?, row.number("y")?);
    let heading = row.optional("hdg")?;
    let found = path.project(point, None).map_err(text)?;
    numbers(out, &[found.along, found.d]);
    let difference = heading.map(|heading| number(found.heading_difference(heading)));
    out.push(difference.unwrap_or_default());
    out.push(map.lane(found.lane).map_err(text)?.key().to_string());
    out.push(found.clamped.name().to_owned());
    Ok(())
}

/// `conflicts`: a row for each.
fn conflicts<'a>(
    path: &Path<'a, '_>,
    router: &Router<'a>,
    out: &mut Vec<String>,
) -> Result<(), String> {
    let (view, rules) = (router.view(), router.rules());
    let map = view.map();
    let (mut found, mut lanes, mut crossings) = (Vec::new(), Vec::new(), Vec::new());
    view.conflicts(path, &mut found, &mut lanes).map_err(text)?;
    view.crossings(path, &mut crossings).map_err(text)?;
    let mut crossings = crossings.into_iter().peekable();
    for one in found {
        while let Some(before) = crossings.next_if(|own| own.along[0] < one.along[0]) {
            crossing(&before, out);
        }
        numbers(out, &one.along);
        out.push(map.lane(one.other).map_err(text)?.key().to_string());
        numbers(out, &one.other_s);
        out.push(one.kind.name().to_owned());
        let YieldsBy { yields, basis } = match rules {
            Some(rules) => one.yields_by(&lanes, rules),
            None => YieldsBy { yields: one.yields, basis: one.basis() },
        };
        out.push(yields.name().to_owned());
        out.push(one.reason.name().to_owned());
        numbers(out, &[one.wait]);
        out.push(basis.name().to_owned());
        let keys = one.lanes_of(&lanes).iter().map(|own| map.lane(own.other).map_err(text));
        let keys = keys.map(|lane| Ok(lane?.key().to_string()));
        out.push(keys.collect::<Result<Vec<_>, String>>()?.join(";"));
    }
    crossings.for_each(|own| crossing(&own, out));
    Ok(())
}

/// A crosswalk's row among `conflicts`.
fn crossing(own: &PathCrossing, out: &mut Vec<String>) {
    numbers(out, &own.along);
    out.extend([const { String::new() }; 3]);
    let (reason, basis) = match own.yields {
        Yields::Lights => (RelationReason::Lights, Basis::Written),
        _ => (RelationReason::None, Basis::Unknown),
    };
    let words = [own.line.class.name(), own.yields.name(), reason.name()];
    out.extend(words.map(str::to_owned));
    numbers(out, &[own.wait]);
    out.push(basis.name().to_owned());
    out.push(String::new());
}

fn check_step(step: f64, length: f64) -> Result<(), String> {
    if step > 0.0 && length / step <= MOST_STATIONS {
        return Ok(());
    }
    Err(format!("a step of {step:?} m gives too many stations over {length:?} m"))
}
