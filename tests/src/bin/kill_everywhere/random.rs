//! Both sides killed at random moments.

use crate::holder::{DEADLINE, MAP, Stage};
use crate::{Plan, Tally};
use mapd_client::Client;
use mapd_tests::maps::Random;
use mapd_tests::say;
use std::process::Child;
use std::time::Duration;

/// Longest life of a victim before it is killed \[µs\]: somewhat more than attaching, or starting to serve, takes.
const LIFE_US: [f64; 2] = [8_000.0, 30_000.0];

pub(crate) fn kill(plan: &Plan) -> Result<Tally, Box<dyn std::error::Error>> {
    say(&format!("seed {}", plan.seed));
    let stage = Stage::new()?;
    let mut random = Random(plan.seed | 1);
    let mut tally = Tally::default();
    let archive = stage.archive.display().to_string();
    let mut daemon = stage.place.serve(&[&archive]);
    let client = Client::connect_in(&stage.domain(), MAP, DEADLINE)?;
    for round in 0..plan.random {
        let held = client.snapshot();
        let is_client = random.unit() < 0.5;
        if is_client {
            let mut victim = stage.client().spawn()?;
            end(&mut victim, random.between(0.0, LIFE_US[0]))?;
        } else {
            // The one that serves dies, then one that is about to.
            daemon.kill();
            let mut victim = stage.daemon().spawn()?;
            end(&mut victim, random.between(0.0, LIFE_US[1]))?;
            daemon = stage.place.start(&[&archive]);
            if let Err(text) = daemon.wait_for_serving() {
                tally.bad.push(format!("round {round}: the next daemon does not serve: {text}"));
                daemon = stage.place.serve(&[&archive]);
            }
        }
        tally.kills += 1;
        let what = if is_client { "client" } else { "daemon" };
        match stage.fresh() {
            Ok(taken) => tally.worst_ms = tally.worst_ms.max(taken.as_millis()),
            Err(error) => tally.bad.push(format!("round {round}, {what}: {error}")),
        }
        if let Err(error) = stage.check(&held) {
            tally.bad.push(format!("round {round}, {what}: what was held: {error}"));
        }
        if !is_client {
            match client.wait_next(DEADLINE).map_err(|error| error.to_string()) {
                Ok(next) => {
                    if let Err(error) = stage.check(&next) {
                        tally.bad.push(format!("round {round}: the next generation: {error}"));
                    }
                }
                Err(error) => tally.bad.push(format!("round {round}: {error}")),
            }
        }
    }
    drop(client);
    let code = daemon.stop();
    if code != 0 || !stage.left().is_empty() {
        tally.bad.push(format!("the daemon ended with {code} and left {:?}", stage.left()));
    }
    Ok(tally)
}

/// Lets a process live so long \[µs\], then kills it.
fn end(victim: &mut Child, life_us: f64) -> std::io::Result<()> {
    std::thread::sleep(Duration::from_micros(life_us as u64));
    victim.kill()?;
    victim.wait().map(|_| ())
}
