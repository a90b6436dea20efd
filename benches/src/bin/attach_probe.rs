//! One process that attaches, answers once and ends: `attach_probe shm NAME` or `attach_probe file PATH`.
//!
//! With `file` it is the floor: the same archive by plain open and mmap.

use mapd_client::{Client, NearestOptions, Snapshot, glam::DVec2};
use std::process::ExitCode;
use std::time::Duration;

/// Longest wait.
const WAIT: Duration = Duration::from_secs(5);

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [how, what] = args.as_slice() else { return ExitCode::from(2) };
    let snapshot = match how.as_str() {
        "shm" => Client::connect(what, WAIT).map(|client| client.snapshot()),
        _ => Snapshot::open(what),
    };
    let answered = snapshot.is_ok_and(|snapshot| {
        let middle = snapshot.map().bounds();
        let point = DVec2::new(middle.0.x + middle.1.x, middle.0.y + middle.1.y) * 0.5;
        snapshot.map().nearest_lane(point, &NearestOptions::default()).is_ok()
    });
    if answered { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
