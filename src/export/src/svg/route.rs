//! A route as it is asked for on the command line, and drawn.

use super::Paper;
use crate::{ExportError, Result};
use mapd_client::Map;
use mapd_client::path::{PathBuffer, PathOptions};
use mapd_client::route::{PositionOnLane, RouteScratch, ShortestLength};
use mapd_client::vocabulary::{QuarantinedKind, VehicleClass};
use std::io::{self, Write};
use std::str::FromStr;

/// From point to point of the drawn line `[m]`.
const STEP: f64 = 0.5;
/// Places of a line at most; on a way of more than 2,000 km they are farther apart.
const MOST_PARTS: usize = 1 << 22;

/// Two places on lanes, which are parsed from `ROAD,S,LANE:ROAD,S,LANE`: ids of roads as the file has them, s `[m]`.
#[derive(Clone, Debug, PartialEq)]
pub struct RouteEnds {
    from: End,
    to: End,
}

#[derive(Clone, Debug, PartialEq)]
struct End {
    road: String,
    s: f64,
    lane: i32,
}

impl FromStr for RouteEnds {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        // A road's id may have colons and commas; s and lane have none.
        let ends = text.match_indices(':').filter_map(|(at, _)| {
            Some(Self { from: end(&text[..at])?, to: end(&text[at + 1..])? })
        });
        let mut ends = ends.fuse();
        match (ends.next(), ends.next()) {
            (Some(one), None) => Ok(one),
            _ => Err(format!("expected ROAD,S,LANE:ROAD,S,LANE, found {text:?}")),
        }
    }
}

fn end(text: &str) -> Option<End> {
    let (rest, lane) = text.rsplit_once(',')?;
    let (road, s) = rest.rsplit_once(',')?;
    let s = s.trim().parse::<f64>().ok().filter(|s| s.is_finite())?;
    Some(End { road: road.to_owned(), s, lane: lane.trim().parse().ok()? })
}

fn place(map: Map<'_>, end: &End) -> Result<PositionOnLane> {
    let Some(road) = map.road_by_id(&end.road) else {
        let left_out = map.left_out(QuarantinedKind::Road, &end.road);
        return Err(ExportError::NoRoute(match left_out {
            Some(part) => part.explained("the document").to_string(),
            None => format!("the map has no road {:?}", end.road),
        }));
    };
    let lane = road.section_at(end.s).and_then(|section| section.lane(end.lane));
    let lane = lane.ok_or_else(|| {
        let End { road, lane, s } = end;
        ExportError::NoRoute(format!("road {road:?} has no lane {lane} at s = {s:?}"))
    })?;
    Ok(PositionOnLane { lane: lane.lane_id(), s: end.s })
}

/// The driven line of the shortest way of a passenger car, as places in plan view.
///
/// Errors: no such lane, no way.
pub(super) fn line(map: Map<'_>, ends: &RouteEnds) -> Result<Vec<mapd_client::glam::DVec2>> {
    let (from, to) = (place(map, &ends.from)?, place(map, &ends.to)?);
    let (car, cost) = (VehicleClass::PassengerCar, ShortestLength::default());
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    map.route(from, to, car, &cost, &mut scratch, &mut steps)?
        .ok_or_else(|| ExportError::NoRoute(format!("no way for {}", car.name())))?;
    let mut buffer = PathBuffer::default();
    let path = map.path(&steps, &PathOptions::default(), &mut buffer)?;
    let count = ((path.length() / STEP).ceil() as usize).clamp(1, MOST_PARTS);
    let along = |i: usize| path.length() * i as f64 / count as f64;
    (0..=count).map(|i| Ok(path.at(along(i))?.position.truncate())).collect()
}

/// Draws the line.
pub(super) fn write(
    line: &[mapd_client::glam::DVec2],
    paper: Paper,
    out: &mut dyn Write,
) -> io::Result<()> {
    write!(out, "<path class=\"route\" d=\"")?;
    for (i, point) in line.iter().enumerate() {
        let p = paper.at(*point);
        write!(out, "{}{:.3},{:.3}", if i == 0 { 'M' } else { ' ' }, p.x, p.y)?;
    }
    writeln!(out, "\"/>")
}
