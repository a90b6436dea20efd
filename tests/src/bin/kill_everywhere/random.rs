//! Daemons and clients killed at random moments.

use crate::check::{Witness, nothing_left};
use crate::report::Report;
use crate::watchdog;
use mapd_client::Attach;
use mapd_tests::maps::Random;
use mapd_tests::say;
use mapd_tests::stage::{Checked, Stage};
use std::io::Write;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Longest life of a client before it is killed: somewhat longer than it needs to attach, ask and detach.
const LONGEST_CLIENT: Duration = Duration::from_millis(40);

/// Longest life of a daemon that is being killed while it starts.
const LONGEST_START: Duration = Duration::from_millis(60);

/// Longest pause before a serving daemon is killed.
const LONGEST_SERVICE: Duration = Duration::from_millis(30);

/// Clients that are killed together.
const CLIENTS: f64 = 3.0;

pub(crate) fn seed_of_clock() -> u64 {
    let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    now.as_secs()
}

pub(crate) fn run(stage: &Stage, kills: u32, seed: u64) -> Checked<Report> {
    say(&format!("random kills: --seed {seed}"));
    let mut random = Random(seed | 1);
    let mut report = Report::new(format!("random, seed {seed}"), 0, kills as usize);
    let mut daemon = stage.serve()?;
    let mut witness = Witness::new(stage)?;
    let mut done = 0;
    while done < kills {
        watchdog::step(&format!("random kill {done}"));
        // Clients in any phase of their life, killed while the daemon serves, or just before it is killed too.
        let clients = random.between(0.0, CLIENTS + 1.0) as u32;
        let mut children = Vec::new();
        for _ in 0..clients {
            let is_observer = random.unit() < 0.5;
            let attach = if is_observer { Attach::Observer } else { Attach::Subscriber };
            let end = Instant::now() + LONGEST_CLIENT.mul_f64(random.unit());
            children.push((end, client(stage, attach)?));
        }
        children.sort_by_key(|(when, _)| *when);
        let kill_daemon = random.unit() < 0.5;
        if kill_daemon {
            std::thread::sleep(LONGEST_SERVICE.mul_f64(random.unit()));
            daemon.kill();
            report.ran(true);
            done += 1;
            // Its successors may be killed too, while they start.
            while random.unit() < 0.5 {
                let successor = mapd_tests::stage::Daemon::spawn(stage.daemon_command())?;
                std::thread::sleep(LONGEST_START.mul_f64(random.unit()));
                successor.kill();
                report.ran(true);
                done += 1;
            }
            let when = format!("at random, {done} kills");
            report.note(&when, witness.still_reads());
            let start = Instant::now();
            match report.note(&when, stage.serve()) {
                Some(next) => daemon = next,
                None => return Ok(report),
            }
            report.started(start.elapsed());
            report.note(&when, witness.follows());
        }
        for (when, mut child) in children {
            std::thread::sleep(when.saturating_duration_since(Instant::now()));
            let ended = child.try_wait().map_err(|error| error.to_string())?.is_some();
            let _ = child.kill();
            let _ = child.wait();
            if !ended {
                report.ran(true);
                done += 1;
            }
        }
        let when = format!("at random, {done} kills");
        if let Some(time) = report.note(&when, stage.fresh_client()) {
            report.attached(time);
        }
        report.note(&when, witness.still_reads());
        if !daemon.is_running() {
            report.note(&when, Err::<(), _>("the daemon has ended".to_owned()));
            return Ok(report);
        }
    }
    drop(witness);
    let end = daemon.stop().and_then(|()| nothing_left(stage));
    report.note(&"at random, in the end", end);
    Ok(report)
}

fn client(stage: &Stage, attach: Attach) -> Checked<Child> {
    let mut command = stage.client_command(attach);
    command.stdin(Stdio::piped()).stderr(Stdio::null());
    let mut child = command.spawn().map_err(|error| error.to_string())?;
    if let Some(mut stdin) = child.stdin.take() {
        // It may have ended already.
        let _ = stdin.write_all(stage.question().as_bytes());
    }
    Ok(child)
}
