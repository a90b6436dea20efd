//! A planner that heeds what is so today only: it plans anew whenever another generation or another overlay comes, and says by which entry its usual
//! way is closed or slower.
//!
//! `todays_road MAP X Y ROAD S LANE [PLANS]`: from a point to a place; ends after so many plans (default 1).

use anyhow::{Context, Result, bail};
use mapd_client::glam::DVec2;
use mapd_client::route::{PositionOnLane, RouteScratch, RouteStep, ShortestTime};
use mapd_client::view::{Restriction, View};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Attach, Client, Domain, LaneTypes, NearestOptions};
use std::io::Write;
use std::time::{Duration, SystemTime};

/// How long the map, and whatever changes, may take to come.
const PATIENCE: Duration = Duration::from_secs(30);
/// What drives.
const CAR: VehicleClass = VehicleClass::PassengerCar;

fn main() -> Result<()> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let (name, x, y, goal, plans) = match args.as_slice() {
        [name, x, y, road, s, lane] => (name, x, y, [road, s, lane], 1),
        [name, x, y, road, s, lane, count] => {
            (name, x, y, [road, s, lane], count.parse().context("PLANS must be a number")?)
        }
        _ => bail!("usage: todays_road MAP X Y ROAD S LANE [PLANS]"),
    };
    let start = DVec2::new(x.parse()?, y.parse()?);
    let client = Client::connect_as(Attach::Observer, &Domain::from_env()?, name, PATIENCE)?;
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    for number in 1..=plans {
        // Generation and overlay, always a pair. The moment is ours: queries read no clock.
        let snapshot = client.snapshot();
        plan(snapshot.view(SystemTime::now()), start, goal, &mut scratch, &mut steps)?;
        if number < plans && !client.wait_change(PATIENCE)? {
            bail!("nothing has changed");
        }
    }
    Ok(())
}

fn plan(
    view: View<'_>,
    start: DVec2,
    [road, s, lane]: [&String; 3],
    scratch: &mut RouteScratch,
    steps: &mut Vec<RouteStep>,
) -> Result<()> {
    let (map, mut out) = (view.map(), std::io::stdout().lock());
    let options = NearestOptions { types: LaneTypes::routable(), ..NearestOptions::default() };
    let here = map.nearest_lane(start, &options)?.context("no lane is near")?;
    let (s, number): (f64, i32) = (s.parse()?, lane.parse()?);
    let section = map.road_by_id(road).and_then(|road| road.section_at(s));
    let goal = section.and_then(|section| section.lane(number)).context("no such goal")?;
    let from = PositionOnLane { lane: here.lane, s: here.position.s };
    let to = PositionOnLane { lane: goal.lane_id(), s };
    let mut told: Vec<Restriction<'_>> = Vec::new();
    // What the usual way meets today.
    if map.route(from, to, CAR, &ShortestTime::default(), scratch, steps)?.is_some() {
        view.restrictions_along(steps, CAR, &mut told)?;
    }
    for one in &told {
        let (entry, lane) = (one.entry, map.lane(one.lane)?.key());
        let (kind, stretch) = (entry.kind().name(), [one.s_from, one.s_to]);
        writeln!(out, "{} on lane {lane}, s {stretch:.0?}: {kind} {}", entry.id(), entry.text())?;
    }
    match view.route(from, to, CAR, &ShortestTime::default(), scratch, steps)? {
        Some(route) => {
            let mut roads = Vec::new();
            for step in steps.iter() {
                roads.push(map.lane(step.lane)?.road().id());
            }
            roads.dedup();
            let (length, time) = (route.length, route.travel_time);
            writeln!(out, "{length:.0} m, {time:.0} s by roads {}", roads.join(" "))?;
        }
        None => writeln!(out, "no way today")?,
    }
    out.flush()?;
    Ok(())
}
