//! One process that attaches, answers once, says so with a byte on stdout, and ends: `attach_probe shm NAME`,
//! `attach_probe subscriber NAME` or `attach_probe file PATH`. `attach_probe times NAME` attaches as often as `PROBE_TIMES` says and prints the nanoseconds of each
//! attach, a line each.
//!
//! With `file` it is the floor: the same archive by plain open and mmap. Behind the byte, `subscriber` says how long each phase of
//! the attach took: microseconds, separated by blanks.

use mapd_client::{Attach, Client, ClientError, Domain, NearestOptions, Snapshot};
use std::io::Write;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Longest wait.
const WAIT: Duration = Duration::from_secs(5);

fn connect(attach: Attach, map: &str) -> Result<Client, ClientError> {
    let domain = Domain::from_env().map_err(mapd_client::AttachError::from)?;
    Client::connect_as(attach, &domain, map, WAIT)
}

fn times(map: &str) -> ExitCode {
    let (Ok(domain), Ok(times)) = (Domain::from_env(), std::env::var("PROBE_TIMES")) else {
        return ExitCode::from(2);
    };
    let mut taken = Vec::new();
    for _ in 0..times.parse().unwrap_or(0) {
        let start = Instant::now();
        let client = Client::connect_in(&domain, map, WAIT);
        taken.push(start.elapsed().as_nanos());
        if client.is_err() {
            return ExitCode::FAILURE;
        }
    }
    // Only now: a reader that is woken by a line would run beside the next attach.
    let lines: String = taken.iter().map(|taken| format!("{taken}\n")).collect();
    match std::io::stdout().write_all(lines.as_bytes()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(_) => ExitCode::FAILURE,
    }
}

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [how, what] = args.as_slice() else { return ExitCode::from(2) };
    if how == "times" {
        return times(what);
    }
    let client = match how.as_str() {
        "shm" => Some(connect(Attach::Observer, what)),
        "subscriber" => Some(connect(Attach::Subscriber, what)),
        _ => None,
    };
    let snapshot = match &client {
        Some(client) => client.as_ref().ok().map(Client::snapshot),
        None => Snapshot::open(what).ok(),
    };
    let answered = snapshot.is_some_and(|snapshot| {
        let bounds = snapshot.map().bounds();
        let point = bounds.low.midpoint(bounds.high).truncate();
        snapshot.map().nearest_lane(point, &NearestOptions::default()).is_ok()
    });
    if !answered {
        return ExitCode::FAILURE;
    }
    let mut out = std::io::stdout().lock();
    let told = out.write_all(b"!").and_then(|()| out.flush());
    let phases = match client {
        Some(Ok(client)) => client.attach_timing().map_or_else(String::new, |t| {
            [t.lock, t.node, t.service, t.subscriber, t.receive]
                .map(|phase| phase.as_micros().to_string())
                .join(" ")
        }),
        _ => String::new(),
    };
    match told.and_then(|()| out.write_all(phases.as_bytes())) {
        Ok(()) => ExitCode::SUCCESS,
        Err(_) => ExitCode::FAILURE,
    }
}
