//! Waits at boot for a map (daemon and client may start in any order), then follows its generations.
//!
//! `wait_at_boot MAP SECONDS [GENERATIONS]`: ends after so many generations (default 1).

use anyhow::{Context, Result, bail};
use mapd_client::Client;
use std::io::Write;
use std::time::Duration;

fn main() -> Result<()> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let (name, seconds, generations) = match args.as_slice() {
        [name, seconds] => (name, seconds, 1),
        [name, seconds, count] => {
            (name, seconds, count.parse().context("GENERATIONS must be a number")?)
        }
        _ => bail!("usage: wait_at_boot MAP SECONDS [GENERATIONS]"),
    };
    let deadline = Duration::from_secs(seconds.parse().context("SECONDS must be a number")?);

    let client = Client::connect(name, deadline).context("the map did not come in time")?;
    let mut snapshot = client.snapshot();
    let mut out = std::io::stdout().lock();
    for number in 1..=generations {
        let map = snapshot.map();
        let km = map.road_length() / 1000.0;
        writeln!(
            out,
            "generation {}: {} roads, {km:.3} km",
            snapshot.generation(),
            map.roads().count()
        )?;
        if number < generations {
            // The old snapshot stays valid until it is dropped, here by being replaced.
            snapshot = client.wait_next(deadline)?;
        }
    }
    Ok(())
}
