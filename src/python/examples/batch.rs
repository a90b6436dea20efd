//! Time of nearest lanes in a batch in Rust, for `measure.py` to compare Python's with: `batch ARCHIVE COUNT` prints nanoseconds per point, the best of some runs.

use mapd_client::batch::{BatchScratch, NearestLanes, Places};
use mapd_client::{NearestOptions, Snapshot};
use std::io::Write as _;
use std::process::ExitCode;
use std::time::Instant;

/// Runs, of which the best counts.
const RUNS: u32 = 15;

fn run() -> Option<f64> {
    let mut args = std::env::args().skip(1);
    let snapshot = Snapshot::open(args.next()?).ok()?;
    let count = args.next()?.parse::<usize>().ok().filter(|count| *count > 0)?;
    let (map, options) = (snapshot.map(), NearestOptions::default());
    let bounds = map.bounds();
    // A low-discrepancy sequence (Roberts 2018), the same in Python.
    let at =
        |i: usize, share: f64, low: f64, high: f64| low + (high - low) * (i as f64 * share).fract();
    let x: Vec<f64> =
        (0..count).map(|i| at(i, 0.754_877_666_246_692_8, bounds.low.x, bounds.high.x)).collect();
    let y: Vec<f64> =
        (0..count).map(|i| at(i, 0.569_840_290_998_053_2, bounds.low.y, bounds.high.y)).collect();
    let places = Places { x: &x, y: &y, ..Places::default() };
    let (mut scratch, mut found) = (BatchScratch::default(), NearestLanes::default());
    let mut best = f64::INFINITY;
    for _ in 0..RUNS {
        let begun = Instant::now();
        map.nearest_lanes(places, &options, &mut scratch, &mut found).ok()?;
        best = best.min(begun.elapsed().as_secs_f64());
    }
    Some(best * 1e9 / count as f64)
}

fn main() -> ExitCode {
    let Some(time) = run() else { return ExitCode::FAILURE };
    let is_written = writeln!(std::io::stdout(), "{time:.1}").is_ok();
    if is_written { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
