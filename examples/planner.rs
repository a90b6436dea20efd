//! A planner's cycle: wait for the map, find the lane, find a route, and ask it as a path: where am I, what is the room, who has to
//! give way and where, how fast. Follows the map when it is swapped.
//!
//! `planner MAP X Y ROAD S LANE [GENERATIONS]`: from a point to a place; ends after so many generations (default 1).

use anyhow::{Context, Result, bail};
use mapd_client::glam::DVec2;
use mapd_client::path::{Corridor, PathBuffer, PathOptions, Yields};
use mapd_client::route::{PositionOnLane, RouteScratch, ShortestTime};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Client, LaneTypes, Map, NearestOptions};
use std::io::Write;
use std::time::Duration;

/// How long the map may take to come.
const PATIENCE: Duration = Duration::from_secs(30);
/// The room that is asked for `[m]`.
const HORIZON: f64 = 150.0;

/// What is kept from cycle to cycle, so that only the first one allocates.
#[derive(Default)]
struct Buffers {
    scratch: RouteScratch,
    steps: Vec<mapd_client::route::RouteStep>,
    path: PathBuffer,
    room: Corridor,
    conflicts: Vec<mapd_client::path::PathConflict>,
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
    for number in 1..=generations {
        plan(snapshot.map(), start, goal, &mut buffers)?;
        if number < generations {
            // Ids belong to one content; everything is found again on the new one.
            snapshot = client.wait_next(PATIENCE)?;
        }
    }
    Ok(())
}

fn plan(
    map: Map<'_>,
    start: DVec2,
    [road, s, lane]: [&String; 3],
    buffers: &mut Buffers,
) -> Result<()> {
    let Buffers { scratch, steps, path, room, conflicts } = buffers;
    let mut out = std::io::stdout().lock();
    let car = VehicleClass::PassengerCar;
    let options = NearestOptions { types: LaneTypes::drivable(), ..NearestOptions::default() };
    let here = map.nearest_lane(start, &options)?.context("no lane is near")?;
    let (s, number): (f64, i32) = (s.parse()?, lane.parse()?);
    let section = map.road_by_id(road).and_then(|road| road.section_at(s));
    let goal = section.and_then(|section| section.lane(number)).context("no such goal")?;
    let from = PositionOnLane { lane: here.lane, s: here.position.s };
    let to = PositionOnLane { lane: goal.lane_id(), s };
    let route = map.route(from, to, car, &ShortestTime::default(), scratch, steps)?;
    let route = route.context("no way there")?;
    let path = map.path(steps, &PathOptions::default(), path)?;
    writeln!(
        out,
        "{:.1} m, {:.1} s, {} joints",
        path.length(),
        route.travel_time,
        path.joints().len()
    )?;

    let own = path.project(start, None)?;
    writeln!(out, "at S = {:.2} m, {:.2} m left of the line", own.along, own.d)?;
    path.corridor(own.along, HORIZON, 1.0, car, room)?;
    let narrowest = room.left.iter().zip(&room.right).map(|(l, r)| l.distance(*r));
    let narrowest = narrowest.fold(f64::INFINITY, f64::min);
    writeln!(out, "the lane is at least {narrowest:.2} m wide over {} stations", room.len())?;
    if let Some(limit) = path.speed_at(own.along).and_then(|rule| rule.max) {
        writeln!(out, "limit {limit:.1} m/s")?;
    }
    path.conflicts(conflicts);
    for one in conflicts.iter().filter(|one| one.yields != Yields::Priority) {
        let other = map.lane(one.other)?.key();
        let (who, wait) = (one.yields.name(), one.wait);
        writeln!(out, "S = {:.1} m: lane {other}, {who}; wait at {wait:.1} m", one.along[0])?;
    }
    Ok(())
}
