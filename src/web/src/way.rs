//! A route between two places: its lanes, its room, whom it meets.

use crate::drawing::{Drawing, EdgePoint, Fill, Pen, level};
use crate::paint::Paint;
use crate::place::top_lane;
use crate::scene::{level_of, middle, object};
use crate::sheet::{Kind, Link, Words};
use mapd_query::compiling::ByRow as _;
use mapd_query::glam::{DVec2, DVec3};
use mapd_query::path::{Corridor, Path, PathBuffer, PathOptions};
use mapd_query::route::{Enter, PositionOnLane, RouteScratch, RouteStep, ShortestTime};
use mapd_query::view::View;
use mapd_query::vocabulary::VehicleClass;
use mapd_query::{Lane, LaneId, Map, QueryError};
use serde::Serialize;

/// From station to station of the drawn line and its room `[m]`.
const STEP: f64 = 1.0;
/// Width of the driven line `[m]`.
const LINE: f64 = 0.5;

/// A route.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Way {
    /// Length `[m]`.
    pub length: f64,
    /// What the graph counts as time `[s]`.
    pub time: f64,
    /// What of it is at assumed speeds `[s]`.
    pub assumed_time: f64,
    /// Number of changes of lane.
    pub lane_changes: u32,
    /// Lane by lane.
    pub steps: Vec<Step>,
    /// Whom it meets.
    pub conflicts: Vec<Meeting>,
    /// What an overlay says along it now.
    pub today: Vec<Told>,
}

/// Where an entry of an overlay holds on a route.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Told {
    /// From and to where on the route `[m]`.
    pub along: [f64; 2],
    /// The entry.
    pub entry: Words,
}

/// A lane of a route.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Step {
    /// The lane.
    pub lane: Words,
    /// How it is entered.
    pub enter: &'static str,
    /// s on its road where it is entered and left `[m]`.
    pub s: [f64; 2],
}

/// Where a route meets another lane.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Meeting {
    /// From and to where on the route `[m]`.
    pub along: [f64; 2],
    /// The other lane.
    pub other: Words,
    /// Who gives way.
    pub yields: &'static str,
    /// Why.
    pub reason: &'static str,
}

/// A way as a table and as a drawing.
pub struct DrawnWay {
    /// What the table says.
    pub way: Way,
    /// What the page draws.
    pub drawing: Drawing,
}

/// Why there is no route.
const NO_LANE: &str = "no lane for passenger cars within 10 m of";
const NO_WAY: &str = "no way for a passenger car leads there";

/// The way of a passenger car that takes the shortest time today, from the lane at one place to that at another.
///
/// Errors: a sentence that says why there is none.
pub fn way(view: View<'_>, from: [f64; 2], to: [f64; 2]) -> Result<DrawnWay, String> {
    let map = view.map();
    let (from, to) = (place(map, from, "the start")?, place(map, to, "the destination")?);
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let (car, cost) = (VehicleClass::PassengerCar, ShortestTime::default());
    let route = view
        .route(from, to, car, &cost, &mut scratch, &mut steps)
        .map_err(|error| error.to_string())?
        .ok_or(NO_WAY)?;
    let mut buffer = PathBuffer::default();
    let path = map
        .path(&steps, &PathOptions::default(), &mut buffer)
        .map_err(|error| error.to_string())?;
    let (mut found, mut lanes) = (Vec::new(), Vec::new());
    view.conflicts(&path, &mut found, &mut lanes).map_err(|error| error.to_string())?;
    let mut told = Vec::new();
    view.restrictions_on_path(&path, car, &mut told).map_err(|error| error.to_string())?;
    let conflicts = found.iter().filter_map(|conflict| {
        Some(Meeting {
            along: conflict.along,
            other: Words::from(&map.lane(conflict.other).ok()?),
            yields: conflict.yields.name(),
            reason: conflict.reason.name(),
        })
    });
    let way = Way {
        length: route.length,
        time: route.travel_time,
        assumed_time: route.assumed_time,
        lane_changes: route.lane_changes,
        steps: steps.iter().filter_map(|step| table_row(map, step)).collect(),
        conflicts: conflicts.collect(),
        today: told
            .iter()
            .map(|one| Told { along: one.along, entry: Words::from(one.restriction.entry) })
            .collect(),
    };
    let drawing = draw(view, &path, &steps).map_err(|error| error.to_string())?;
    Ok(DrawnWay { way, drawing })
}

fn place(map: Map<'_>, [x, y]: [f64; 2], which: &str) -> Result<PositionOnLane, String> {
    let is_open =
        |lane: &Lane<'_>| lane.nodes().any(|node| node.allows(VehicleClass::PassengerCar));
    let found = top_lane(map, DVec2::new(x, y), is_open).map_err(|error| error.to_string())?;
    let found = found.ok_or_else(|| format!("{NO_LANE} {which}"))?;
    Ok(PositionOnLane { lane: found.lane, s: found.position.s })
}

fn table_row(map: Map<'_>, step: &RouteStep) -> Option<Step> {
    let enter = match step.enter {
        Enter::Start => "start",
        Enter::Ahead => "ahead",
        Enter::Left => "change to the left",
        Enter::Right => "change to the right",
    };
    Some(Step { lane: Words::from(&map.lane(step.lane).ok()?), enter, s: [step.s_from, step.s_to] })
}

/// The driven line, and the room beside it.
fn draw<'a>(
    view: View<'a>,
    path: &Path<'a, '_>,
    steps: &[RouteStep],
) -> Result<Drawing, QueryError> {
    let (map, car) = (view.map(), VehicleClass::PassengerCar);
    let mut drawing = Drawing::new(middle(map));
    let mut corridor = Corridor::default();
    view.corridor(path, 0.0, path.length(), STEP, car, &mut corridor)?;
    drawing.near(DVec2::ZERO);
    let level = level(map.bounds().high.z - middle(map).z);
    let points = |line: &[DVec3]| -> Vec<EdgePoint> {
        let both = corridor.along.iter().zip(line);
        both.map(|(s, position)| EdgePoint { s: *s, position: *position }).collect()
    };
    // A change to the lane beside is no room between two lanes; one ahead goes on without a gap.
    let mut ahead = steps.iter().peekable();
    let mut is_beside = |lane: LaneId| {
        let mut is_beside = false;
        while ahead.next_if(|step| step.lane != lane).is_some() {
            let entered = ahead.peek().map(|step| step.enter);
            is_beside |= matches!(entered, Some(Enter::Left | Enter::Right));
        }
        is_beside
    };
    let changes: Vec<usize> =
        (0..corridor.len()).filter(|i| is_beside(corridor.lane[*i])).collect();
    let (left, right) = (points(&corridor.left), points(&corridor.right));
    let ends = changes.iter().copied().chain([corridor.len()]);
    let starts = [0].into_iter().chain(changes.iter().copied());
    let fill = Fill { paint: Paint::Corridor as u8, level };
    let pen = Pen { paint: Paint::CorridorLine as u8, level, ..Pen::default() };
    for (start, end) in starts.zip(ends) {
        let (left, right) = (&left[start..end], &right[start..end]);
        drawing.strip(left.iter().copied(), right.iter().copied(), fill);
        drawing.line(left.iter().map(|point| point.position), &pen);
        drawing.line(right.iter().map(|point| point.position), &pen);
    }
    let pen = Pen { paint: Paint::Route as u8, level, width: LINE };
    let line: Result<Vec<DVec3>, QueryError> =
        corridor.along.iter().map(|along| Ok(path.at(*along)?.position)).collect();
    drawing.line(line?.into_iter(), &pen);
    drawing.finish();
    Ok(drawing)
}

/// What is drawn over the map for a thing that was chosen: the thing itself, and of a lane those that it leads to and gives way to.
pub fn highlight(map: Map<'_>, about: Link) -> Drawing {
    let mut drawing = Drawing::new(middle(map));
    drawing.near(DVec2::ZERO);
    let mut fill = |lane: &Lane<'_>, paint: Paint| {
        crate::scene::area(lane, paint, level_of(map, lane), &mut drawing);
    };
    match about.kind {
        Kind::Lane => {
            let Some(lane) = map.lane_by_row(about.row) else { return drawing };
            let lanes = |ids: &mut dyn Iterator<Item = LaneId>| {
                ids.filter_map(|id| map.lane(id).ok()).collect::<Vec<_>>()
            };
            lanes(&mut lane.predecessors()).iter().for_each(|one| fill(one, Paint::Before));
            lanes(&mut lane.successors()).iter().for_each(|one| fill(one, Paint::Next));
            lane.yields_to().for_each(|one| fill(&one.lane, Paint::Other));
            fill(&lane, Paint::Chosen);
        }
        Kind::Road => {
            let sections = map.road_by_row(about.row).into_iter().flat_map(|road| road.sections());
            let lanes = sections.flat_map(|section| section.lanes());
            lanes.filter(|lane| lane.number() != 0).for_each(|lane| fill(&lane, Paint::Chosen));
        }
        Kind::Junction => {
            let connections = map.junction_by_row(about.row).into_iter();
            let roads = connections
                .flat_map(|junction| junction.connections())
                .filter_map(|connection| connection.connecting_road());
            let lanes = roads.flat_map(|road| road.sections()).flat_map(|section| section.lanes());
            lanes.filter(|lane| lane.number() != 0).for_each(|lane| fill(&lane, Paint::Chosen));
        }
        Kind::Signal => {
            let places = map.signals().nth(about.row as usize).into_iter();
            let lanes = places.flat_map(|signal| signal.places()).flat_map(|place| place.lanes());
            lanes.filter_map(|one| one.lane()).for_each(|lane| fill(&lane, Paint::Other));
        }
        Kind::Object => {
            let one = map.objects().nth(about.row as usize);
            for place in one.iter().flat_map(|one| one.placements()) {
                object(map, &place, [Paint::Chosen; 2], &mut drawing);
            }
        }
        Kind::Quarantine => {}
    }
    drawing.finish();
    drawing
}
