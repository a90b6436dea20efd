//! A localiser's cycle: which lanes may the vehicle be in, how high is the ground, where is the next road mark?
//!
//! `localiser MAP X Y HEADING [DEVIATION]`: by a pose with these standard deviations `[m]`, 0.1 rad (default 0.5 m).

use anyhow::{Context, Result, bail};
use mapd_client::glam::{DMat3, DVec2, DVec3};
use mapd_client::localisation::{GroundScratch, LaneMatch, MarkFilter, MatchOptions, VehiclePose};
use mapd_client::{Client, Map, Point};
use std::io::Write;
use std::time::Duration;

/// How long the map may take to come.
const PATIENCE: Duration = Duration::from_secs(30);
/// Standard deviation of the heading `[rad]`.
const HEADING_DEVIATION: f64 = 0.1;

/// What is kept from cycle to cycle, so that only the first one allocates.
#[derive(Default)]
struct Buffers {
    matches: Vec<LaneMatch>,
    ground: GroundScratch,
}

fn main() -> Result<()> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let (name, numbers) = args.split_first().context("no map")?;
    let numbers: Vec<f64> = numbers.iter().map(|one| one.parse()).collect::<Result<_, _>>()?;
    let (x, y, heading, deviation) = match numbers.as_slice() {
        [x, y, heading] => (*x, *y, *heading, 0.5),
        [x, y, heading, deviation] => (*x, *y, *heading, *deviation),
        _ => bail!("usage: localiser MAP X Y HEADING [DEVIATION]"),
    };
    let client = Client::connect(name, PATIENCE).context("the map did not come in time")?;
    let snapshot = client.snapshot();
    let deviations = DVec3::new(deviation, deviation, HEADING_DEVIATION);
    localise(snapshot.map(), DVec2::new(x, y), heading, deviations, &mut Buffers::default())
}

fn localise(
    map: Map<'_>,
    at: DVec2,
    heading: f64,
    deviations: DVec3,
    buffers: &mut Buffers,
) -> Result<()> {
    let mut out = std::io::stdout().lock();
    let pose = VehiclePose { position: Point::from(at), heading };
    let covariance = DMat3::from_diagonal(deviations * deviations);
    let Buffers { matches, ground } = buffers;
    let none = map.match_pose(&pose, &covariance, &MatchOptions::default(), matches)?;
    for one in matches.iter() {
        let key = map.lane(one.lane)?.key();
        let (way, place) = (if one.forward { "along" } else { "against" }, &one.position);
        writeln!(
            out,
            "{:.3} lane {key} {way}, s = {:.2} m, {:.2} m left of its centre",
            one.probability, place.s, place.offset
        )?;
    }
    writeln!(out, "{none:.3} no lane")?;
    if let Some(ground) = map.ground_at(at, &[], ground)? {
        writeln!(out, "ground at {:.2} m, level {} of {}", ground.z, ground.level, ground.levels)?;
    }
    if let Some(mark) = map.nearest_mark(at, &MarkFilter::default())? {
        writeln!(out, "mark {} in {:.2} m", mark.kind.name(), mark.distance)?;
    }
    Ok(())
}
