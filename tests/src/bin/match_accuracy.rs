//! How often the lane of a simulated drive is found, matched as a whole, tracked from fix to fix, and by the nearest lane of each fix, as a table:
//! `cargo run --release -p mapd-tests --bin match_accuracy -- MAP.xodr`. With `--judge` before the maps, a table of one row for each map instead: shares of wrong lanes beside
//! what no answer can beat, and how far stated probabilities are from the shares of right lanes.

use mapd_tests::{drives, maps, say};
use std::path::PathBuf;
use std::process::ExitCode;

/// Drives for each row, of two minutes.
const DRIVES: u64 = 6;
/// Standard deviation of the headings that a tracker gets `[rad]`; the other two get none.
const HEADING_NOISE: f64 = 0.05;

/// Noise of what is judged `[m]`, and fixes of ten a second that count, one of so many.
const JUDGED_NOISE: f64 = 0.3;
const JUDGED_EVERY: usize = 10;
/// How drivers keep to the middle of a lane `[m]`, and to its direction `[rad]`: the latter is what `MatchOptions` assume.
const WANDER: drives::Wander = [0.3, 0.1];
/// Drives of each map that are judged.
const JUDGED_DRIVES: u64 = 100;

fn main() -> ExitCode {
    let mut paths = std::env::args_os().skip(1).map(PathBuf::from).peekable();
    if paths.next_if(|first| first.as_os_str() == "--judge").is_some() {
        judge(paths);
        return ExitCode::SUCCESS;
    }
    let Some(path) = paths.next() else {
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

fn judge(paths: impl Iterator<Item = PathBuf>) {
    let percent = |share: f64| format!("{:.2} %", 100.0 * share);
    say(
        "| map | unavoidable | tracker | pose, last lane | pose | more than 1.2 m apart: tracker | pose |",
    );
    say("|---|---|---|---|---|---|---|");
    let mut bins = Vec::new();
    for path in paths {
        let snapshot = maps::open(&path);
        let noise = [JUDGED_NOISE, HEADING_NOISE];
        let judged = drives::judge(snapshot.map(), noise, JUDGED_EVERY, WANDER, JUDGED_DRIVES);
        let name = path.file_stem().map(|name| name.to_string_lossy().into_owned());
        let name = name.unwrap_or_default();
        let shares = [
            judged.bayes.wrong(),
            judged.tracker.wrong(),
            judged.last_lane.wrong(),
            judged.pose.wrong(),
            judged.tracker.wrong_apart(),
            judged.pose.wrong_apart(),
        ];
        say(&format!("| {name} | {} |", shares.map(percent).join(" | ")));
        for (kind, score) in [("tracker", &judged.tracker), ("pose", &judged.pose)] {
            bins.push((format!("{name}, {kind}"), score.bins));
        }
    }
    say("");
    say("| stated − right, in bins of 0.2 (hypotheses) |");
    for (name, bins) in bins {
        let one = |[n, said, was]: [f64; 3]| {
            let n = n.max(1.0);
            format!("{:+.1} ({n})", 100.0 * (said - was) / n)
        };
        say(&format!("| {name} | {} |", bins.map(one).join(" | ")));
    }
}
