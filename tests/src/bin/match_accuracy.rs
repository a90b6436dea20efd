//! How often the lane of a simulated drive is found, matched as a whole, tracked from fix to fix, and by the nearest lane of each fix, as a table:
//! `cargo run --release -p mapd-tests --bin match_accuracy -- MAP.xodr`.

use mapd_tests::{drives, maps, say};
use std::path::PathBuf;
use std::process::ExitCode;

/// Drives for each row, of two minutes.
const DRIVES: u64 = 6;
/// Standard deviation of the headings that a tracker gets `[rad]`; the other two get none.
const HEADING_NOISE: f64 = 0.05;

fn main() -> ExitCode {
    let Some(path) = std::env::args_os().nth(1).map(PathBuf::from) else {
        say("expected the path of a map");
        return ExitCode::FAILURE;
    };
    let snapshot = maps::open(&path);
    let map = snapshot.map();
    say("| noise [m] | fixes per second | whole trace | nearest lane | tracked, with a heading |");
    say("|---|---|---|---|---|");
    for noise in [0.3, 1.0, 5.0] {
        for (every, rate) in [(1, "10"), (10, "1"), (100, "0.1")] {
            let [whole, plain] = drives::accuracy(map, noise, every, DRIVES);
            let [tracked, _] = drives::tracked(map, [noise, HEADING_NOISE], every, false, DRIVES);
            let [whole, plain, tracked] = [whole, plain, tracked].map(|share| 100.0 * share);
            say(&format!("| {noise} | {rate} | {whole:.1} % | {plain:.1} % | {tracked:.1} % |"));
        }
    }
    ExitCode::SUCCESS
}
