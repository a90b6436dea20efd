//! Says which lane a position is on, from a map that another process serves.
//!
//! `which_lane MAP X Y`, for example `which_lane town 50 -1.75`

use anyhow::{Context, Result, bail};
use mapd_client::{Client, NearestOptions, glam::DVec2};
use std::io::Write;
use std::time::Duration;

fn main() -> Result<()> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [name, x, y] = args.as_slice() else { bail!("usage: which_lane MAP X Y") };
    let point = DVec2::new(
        x.parse().context("X must be a number")?,
        y.parse().context("Y must be a number")?,
    );

    // Waits up to two seconds for daemon and map; nothing is copied, the archive is read where it lies.
    let client = Client::connect(name, Duration::from_secs(2))?;
    let snapshot = client.snapshot();
    let map = snapshot.map();

    let mut out = std::io::stdout().lock();
    match map.nearest_lane(point, &NearestOptions::default())? {
        Some(hit) => {
            let lane = map.lane(hit.lane)?;
            let p = hit.position;
            writeln!(out, "lane {} ({})", lane.key(), lane.kind().name())?;
            writeln!(
                out,
                "s = {:.3} m, {:.3} m from its centre, {:.3} m outside",
                p.s, p.offset, p.distance
            )?;
            for next in lane.successors() {
                writeln!(out, "leads to {}", map.lane(next)?.key())?;
            }
        }
        None => writeln!(out, "no lane within 10 m")?,
    }
    Ok(())
}
