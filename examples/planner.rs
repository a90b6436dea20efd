//! A planner's cycle: wait for the map, find the lane, find a route, and ask it as a path: where am I, what is the room, what lies ahead, until when must
//! I change lanes, who has to give way and where. When the map is swapped, the path is found again on the new one.
//!
//! `planner MAP X Y ROAD S LANE [GENERATIONS]`: from a point to a place; ends after so many generations (default 1).

use anyhow::{Context, Result, bail};
use mapd_client::glam::{DMat3, DVec2, DVec3};
use mapd_client::localisation::{LaneMatch, MatchOptions, VehiclePose};
use mapd_client::path::{
    ConflictLane, Corridor, Path, PathBuffer, PathChange, PathChangeKind, PathConflict, PathFact,
    PathFactKind, PathOptions, PathSegment, Yields,
};
use mapd_client::route::{PositionOnLane, RouteScratch, RouteStep, ShortestTime};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Client, Map, Point};
use std::io::Write;
use std::time::Duration;

/// What drives.
const CAR: VehicleClass = VehicleClass::PassengerCar;
/// How long the map may take to come.
const PATIENCE: Duration = Duration::from_secs(30);
/// The room that is asked for `[m]`.
const HORIZON: f64 = 150.0;
/// Deviations of x, y `[m]` and heading `[rad]`: one that large says that the heading is not known.
const DEVIATIONS: DVec3 = DVec3::new(0.5, 0.5, 10.0);

/// What is kept from cycle to cycle, so that only the first one allocates.
#[derive(Default)]
struct Buffers {
    matches: Vec<LaneMatch>,
    scratch: RouteScratch,
    steps: Vec<RouteStep>,
    path: PathBuffer,
    changes: Vec<PathChange>,
    room: Corridor,
    facts: Vec<PathFact>,
    segments: Vec<PathSegment>,
    conflicts: Vec<PathConflict>,
    met: Vec<ConflictLane>,
}

fn main() -> Result<()> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let (name, x, y, goal, generations) = match args.as_slice() {
        [name, x, y, road, s, lane] => (name, x, y, [road, s, lane], 1),
        [name, x, y, road, s, lane, count] => {
            (name, x, y, [road, s, lane], count.parse().context("GENERATIONS must be a number")?)
        }
        _ => bail!("usage: planner MAP X Y ROAD S LANE [GENERATIONS]"),
    };
    let start = DVec2::new(x.parse()?, y.parse()?);
    let client = Client::connect(name, PATIENCE).context("the map did not come in time")?;
    let mut snapshot = client.snapshot();
    let mut buffers = Buffers::default();
    find(snapshot.map(), start, goal, &mut buffers)?;
    look_along(snapshot.map(), start, &mut buffers)?;
    for _ in 1..generations {
        let next = client.wait_next(PATIENCE)?;
        // Ids belong to one content. The old map stays as long as its snapshot is held, and so does the path.
        if !find_again(snapshot.map(), next.map(), &mut buffers)? {
            find(next.map(), start, goal, &mut buffers)?;
        }
        snapshot = next;
        look_along(snapshot.map(), start, &mut buffers)?;
    }
    Ok(())
}

/// The route from the most probable lane that leads to the goal.
fn find(
    map: Map<'_>,
    start: DVec2,
    [road, s, lane]: [&String; 3],
    buffers: &mut Buffers,
) -> Result<()> {
    let Buffers { matches, scratch, steps, .. } = buffers;
    let (s, number): (f64, i32) = (s.parse()?, lane.parse()?);
    let section = map.road_by_id(road).and_then(|road| road.section_at(s));
    let goal = section.and_then(|section| section.lane(number)).context("no such goal")?;
    let to = PositionOnLane { lane: goal.lane_id(), s };
    let pose = VehiclePose { position: Point::from(start), heading: 0.0 };
    let covariance = DMat3::from_diagonal(DEVIATIONS * DEVIATIONS);
    let options = MatchOptions { vehicle: Some(CAR), ..MatchOptions::default() };
    map.match_pose(&pose, &covariance, &options, matches)?;
    for one in matches.iter() {
        let from = PositionOnLane { lane: one.lane, s: one.position.s };
        if map.route(from, to, CAR, &ShortestTime::default(), scratch, steps)?.is_some() {
            return Ok(());
        }
    }
    bail!("no way there")
}

/// The route along the same lanes on another map; false where none is left.
fn find_again(old: Map<'_>, new: Map<'_>, buffers: &mut Buffers) -> Result<bool> {
    let Buffers { scratch, steps, path, changes, .. } = buffers;
    let path = Path::of(old, path)?;
    let found = path.rebase(new, CAR, &ShortestTime::default(), scratch, steps, changes)?;
    let mut out = std::io::stdout().lock();
    writeln!(out, "another map: {} stretches of the path have changed", changes.len())?;
    for PathChange { along: [from, to], kind } in changes.iter() {
        let kind = match kind {
            PathChangeKind::Moved(by) => format!("moved by {by:.2} m"),
            PathChangeKind::Replaced(by) => format!("another lane, {by:.2} m beside"),
            _ => "gone".to_owned(),
        };
        writeln!(out, "S = {from:.1} to {to:.1} m: {kind}")?;
    }
    Ok(found.is_some())
}

/// What a planner asks in each cycle.
fn look_along(map: Map<'_>, here: DVec2, buffers: &mut Buffers) -> Result<()> {
    let Buffers { steps, path, room, facts, segments, conflicts, met, .. } = buffers;
    let path = map.path(steps, &PathOptions::default(), path)?;
    let mut out = std::io::stdout().lock();
    let time = path.travel_time([0.0, path.length()])?.time;
    writeln!(out, "{:.1} m, {time:.1} s, {} joints", path.length(), path.joints().len())?;

    let own = path.project(here, None)?;
    writeln!(out, "at S = {:.2} m, {:.2} m left of the line", own.along, own.d)?;
    path.corridor(own.along, HORIZON, 1.0, CAR, room)?;
    let narrowest = room.left.iter().zip(&room.right).map(|(l, r)| l.distance(*r));
    let narrowest = narrowest.fold(f64::INFINITY, f64::min);
    writeln!(out, "the lane is at least {narrowest:.2} m wide over {} stations", room.len())?;
    if let Some(limit) = path.speed_at(own.along).and_then(|rule| rule.max) {
        writeln!(out, "limit {limit:.1} m/s")?;
    }

    path.facts(facts);
    for fact in facts.iter().filter(|fact| fact.along[0] >= own.along) {
        if let PathFactKind::Signal { signal, governs: true } = fact.kind {
            let signal = map.signal(signal)?;
            let class = signal.class().name();
            writeln!(out, "S = {:.1} m: signal {}, {class}", fact.along[0], signal.id())?;
        }
    }
    path.segments(CAR, segments);
    for lane in segments.iter().filter(|one| one.driven && one.changes > 0) {
        let (key, last) = (map.lane(lane.lane)?.key(), lane.last_change);
        writeln!(out, "lane {key}: {} changes left, the next until S = {last:.1} m", lane.changes)?;
    }

    path.conflicts(conflicts, met);
    for one in conflicts.iter().filter(|one| one.yields != Yields::Priority) {
        let other = map.lane(one.other)?.key();
        let (who, wait) = (one.yields.name(), one.wait);
        writeln!(out, "S = {:.1} m: lane {other}, {who}; wait at {wait:.1} m", one.along[0])?;
    }
    Ok(())
}
