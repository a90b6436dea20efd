//! The daemon as victim: alone, and while a client holds the generation before.

use crate::holder::{DEADLINE, MAP, Stage};
use crate::trace::{self, Call};
use crate::{Plan, Tally};
use mapd_client::Client;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command};

pub(crate) fn kill_everywhere_alone(plan: &Plan) -> Result<Tally, Box<dyn std::error::Error>> {
    let stage = Stage::new()?;
    let calls = calls(&stage)?;
    let mut tally = Tally::default();
    for call in calls.iter().step_by(plan.step) {
        start_and_stop(&mut trace::killing(&stage.daemon(), call))?;
        tally.kills += 1;
        if let Err(error) = next_daemon(&stage, &mut tally) {
            tally.bad.push(format!("{call:?}: {error}"));
        }
        let left = stage.left();
        if !left.is_empty() {
            tally.bad.push(format!("{call:?}: left behind {left:?}"));
        }
    }
    Ok(tally)
}

pub(crate) fn kill_everywhere_held(plan: &Plan) -> Result<Tally, Box<dyn std::error::Error>> {
    let stage = Stage::new()?;
    let calls = calls(&stage)?;
    let mut tally = Tally::default();
    let first = stage.place.serve(&[&stage.archive.display().to_string()]);
    let client = Client::connect_in(&stage.domain(), MAP, DEADLINE)?;
    first.kill();
    for call in calls.iter().step_by(plan.step) {
        let held = client.snapshot();
        start_and_stop(&mut trace::killing(&stage.daemon(), call))?;
        tally.kills += 1;
        if let Err(error) = stage.check(&held) {
            tally.bad.push(format!("{call:?}: what was held: {error}"));
        }
        if let Err(error) = next_daemon_for(&stage, &mut tally, Some(&client)) {
            tally.bad.push(format!("{call:?}: {error}"));
        }
        let newest = client.snapshot().generation();
        if newest <= held.generation() {
            let held = held.generation();
            tally.bad.push(format!("{call:?}: generation {newest} after {held}"));
        }
        if let Err(error) = stage.check(&held) {
            tally.bad.push(format!("{call:?}: what was held, after the next daemon: {error}"));
        }
    }
    drop(client);
    // The last one out leaves files to the next daemon, which clears them up as it ends.
    next_daemon(&stage, &mut tally)?;
    let left = stage.left();
    if !left.is_empty() {
        tally.bad.push(format!("left behind {left:?}"));
    }
    Ok(tally)
}

/// The calls of a daemon that starts, publishes and is told to end.
fn calls(stage: &Stage) -> Result<Vec<Call>, Box<dyn std::error::Error>> {
    let log = tempfile::NamedTempFile::new()?;
    if !start_and_stop(&mut trace::logging(&stage.daemon(), log.path()))? {
        return Err("the daemon fails even where nobody kills it".into());
    }
    Ok(trace::calls(&std::fs::read_to_string(log.path())?))
}

/// Runs a traced daemon to its end, which it is asked for once it serves. Whether it came to serving and ended well.
fn start_and_stop(command: &mut Command) -> Result<bool, Box<dyn std::error::Error>> {
    let mut strace = command.spawn()?;
    let served = serves(&mut strace)?;
    if served && let Some(daemon) = trace::tracee(&strace) {
        // Fails if it has just been killed, which is what we are here for.
        Command::new("kill").args(["-TERM", &daemon.to_string()]).output()?;
    }
    Ok(strace.wait()?.success() && served)
}

/// Reads its messages until it serves, and lets the rest go.
fn serves(strace: &mut Child) -> Result<bool, Box<dyn std::error::Error>> {
    let mut lines = BufReader::new(strace.stderr.take().ok_or("no stderr")?);
    let mut line = String::new();
    while lines.read_line(&mut line)? > 0 {
        if line.contains("serving") {
            std::thread::spawn(move || std::io::copy(&mut lines, &mut std::io::sink()));
            return Ok(true);
        }
        line.clear();
    }
    Ok(false)
}

fn next_daemon(stage: &Stage, tally: &mut Tally) -> Result<(), String> {
    next_daemon_for(stage, tally, None)
}

/// The next daemon starts by itself, a fresh client and the one that held have right answers from it, and it ends well.
fn next_daemon_for(
    stage: &Stage,
    tally: &mut Tally,
    client: Option<&Client>,
) -> Result<(), String> {
    let mut daemon = stage.place.start(&[&stage.archive.display().to_string()]);
    let told = daemon.wait_for_serving();
    told.map_err(|text| format!("the next daemon does not serve: {text}"))?;
    let taken = stage.fresh()?;
    tally.worst_ms = tally.worst_ms.max(taken.as_millis());
    if let Some(client) = client {
        let next = client.wait_next(DEADLINE).map_err(|error| error.to_string())?;
        stage.check(&next)?;
    }
    match daemon.stop() {
        0 => Ok(()),
        code => Err(format!("the next daemon ended with {code}")),
    }
}
