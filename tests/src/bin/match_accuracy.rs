//! How often the lane of a simulated drive is found, matched as a whole and by the nearest lane of each fix, as a table:
//! `cargo run --release -p mapd-tests --bin match_accuracy -- MAP.xodr`.

use mapd_tests::{drives, maps, say};
use std::path::PathBuf;
use std::process::ExitCode;

/// Drives for each row, of two minutes.
const DRIVES: u64 = 6;

fn main() -> ExitCode {
    let Some(path) = std::env::args_os().nth(1).map(PathBuf::from) else {
        say("expected the path of a map");
        return ExitCode::FAILURE;
    };
    let snapshot = maps::open(&path);
    say("| noise [m] | fixes per second | whole trace | nearest lane |\n|---|---|---|---|");
    for noise in [0.3, 1.0, 5.0] {
        for (every, rate) in [(1, "10"), (10, "1"), (100, "0.1")] {
            let [whole, plain] = drives::accuracy(snapshot.map(), noise, every, DRIVES);
            say(&format!("| {noise} | {rate} | {:.1} % | {:.1} % |", 100.0 * whole, 100.0 * plain));
        }
    }
    ExitCode::SUCCESS
}
