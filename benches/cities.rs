//! Cities: the tilings of 104 MB and 526 MB, each compiled by `mapd compile` in a process of its own. Peak memory, size of the
//! archive and answers are held to bounds; times are printed, with the ratio to what the smaller tiling would predict.
//!
//! `cargo bench -p mapd-benches --bench cities -- FILE…` compiles more files in the same way, and asks them for places that are
//! known: centres of their lanes, and lanes of straight roads as the document has them. With `--only` the tilings are left out.

mod straight_roads;

use mapd_benches::{Random, compiled, pitch, print, tiling};
use mapd_client::{Map, NearestOptions, Snapshot, glam::DVec2};
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

/// Tiles along x and y, and the largest archive \[bytes\]: 200 MB for the larger one, as many for each byte of the smaller.
const CITIES: [(usize, usize, u64); 2] = [(6, 6, 37_000_000), (13, 14, 200_000_000)];
/// Largest memory of a compiler beyond twice its archive \[bytes\].
const BESIDE: u64 = 48 << 20;
/// Largest memory of a compiler of the larger tiling \[bytes\].
const LARGEST: u64 = 500_000_000;
/// Points of each corner's tile that are asked for.
const POINTS: usize = 1_000;
/// Largest difference of an answer from that on the single tile `[m]`: coordinates of kilometres are written with 17 digits.
const SAME: f64 = 1e-6;
/// Farthest that a point of a centre line may lie from the lane that is found there `[m]`: points are off by the index' tolerance.
const ON_LANE: f64 = 0.05;
/// Largest difference in s and t between the document's numbers and the answer `[m]`.
const AS_WRITTEN: f64 = 1e-6;

/// What compiling took.
struct Made {
    time: Duration,
    /// Largest memory of the process \[bytes\].
    peak: u64,
    /// Of the archive.
    bytes: u64,
}

/// Compiles a file in a process of its own.
fn compile(file: &Path, archive: &Path) -> Made {
    let told = archive.with_extension("peak");
    let start = Instant::now();
    let ended = Command::new(env!("CARGO_BIN_EXE_mapd_under_bench"))
        .arg("compile")
        .arg(file)
        .arg("-o")
        .arg(archive)
        .arg("--quiet")
        .env("MAPD_BENCH_PEAK", &told)
        .stderr(Stdio::null())
        .status()
        .expect("the compiler starts");
    let time = start.elapsed();
    assert!(ended.success(), "{}: {ended}", file.display());
    let peak = std::fs::read_to_string(&told).expect("the compiler says its largest memory");
    let peak = peak.trim().parse::<u64>().expect("a number") << 10;
    let bytes = std::fs::metadata(archive).expect("an archive").len();
    Made { time, peak, bytes }
}

/// Asks the single tile and a corner of the tiling for the same places; how many answers differ.
fn differences(single: Map<'_>, city: Map<'_>, shift: DVec2) -> usize {
    let lanes: Vec<_> = single.lanes().filter(|lane| lane.number() != 0).collect();
    let options = NearestOptions::default();
    let mut ties = 0;
    let differs = |number: &usize| {
        let lane = lanes[number * lanes.len() / POINTS];
        let line = lane.center_line();
        let Some(place) = line.position(line.len() / 2) else { return true };
        // Beside the middle, so that the nearest lane is one alone.
        let place = place.truncate() + DVec2::new(0.3, 0.1);
        let ask = |map: Map<'_>, place: DVec2| {
            let found = map.nearest_lane(place, &options).expect("an answer")?;
            let lane = map.lane(found.lane).expect("a lane");
            Some((lane.number(), lane.section().number(), found.position))
        };
        match (ask(single, place), ask(city, place + shift)) {
            (Some((number, section, at)), Some((other_number, other_section, other))) => {
                let far = |away: &[f64]| away.iter().any(|away| away.abs() > SAME);
                if far(&[at.distance - other.distance, at.offset.abs() - other.offset.abs()]) {
                    return true;
                }
                // Of lanes that lie on each other, all else the same, the id decides, and ids are others in each tile.
                let is_other = number != other_number || section != other_section;
                let places = [at.s - other.s, at.t - other.t, at.z - other.z];
                if is_other || far(&places) {
                    ties += 1;
                }
                false
            }
            (None, None) => false,
            _ => true,
        }
    };
    let found = (0..POINTS).filter(differs).count();
    print(&format!("  of {POINTS} answers {ties} chose among lanes that lie on each other"));
    found
}

/// Asks for random points of lanes' centre lines; how many are answered with a lane that does not lie there.
fn astray(map: Map<'_>) -> usize {
    let lanes: Vec<_> = map.lanes().filter(|lane| lane.number() != 0).collect();
    let (mut random, mut others) = (Random(7), 0);
    let mut is_astray = |_: &usize| {
        let lane = lanes[(random.unit() * lanes.len() as f64) as usize];
        let line = lane.center_line();
        let Some(place) = line.position((random.unit() * line.len() as f64) as usize) else {
            return true;
        };
        let found = map.nearest_lane(place.truncate(), &NearestOptions::default());
        let Some(found) = found.expect("an answer") else { return true };
        others += usize::from(found.lane != lane.lane_id());
        found.position.distance > ON_LANE
    };
    let astray = (0..POINTS).filter(|number| is_astray(number)).count();
    print(&format!(
        "  of {POINTS} centres of lanes {others} lie on another lane, too, which was found"
    ));
    astray
}

/// Asks for the middles of lanes of straight roads, computed from the document's numbers alone; how many are answered with
/// another place.
fn other_than_written(file: &Path, map: Map<'_>) -> usize {
    let written = straight_roads::sample(file, POINTS);
    let mut others = 0;
    let mut differs = |one: &&straight_roads::Written| {
        let found = map.nearest_lane(one.place, &NearestOptions::default()).expect("an answer");
        let Some(found) = found else { return true };
        let lane = map.lane(found.lane).expect("a lane");
        if lane.road().id() != one.road || lane.number() != one.lane {
            // Where lanes lie on one another, another one may be as near.
            others += 1;
            return found.position.distance > 0.0;
        }
        let away = [found.position.s - one.s, found.position.t - one.t];
        away.iter().any(|away| away.abs() > AS_WRITTEN)
    };
    let differing = written.iter().filter(|one| differs(one)).count();
    let all = written.len();
    print(&format!(
        "  of {all} places from the document {others} lie on another lane, too, which was found"
    ));
    differing
}

fn main() -> ExitCode {
    let folder = tempfile::tempdir().expect("a folder");
    let archive = folder.path().join("city.mapd");
    let mut exceeded = false;
    let mut hold = |what: &str, found: u64, most: u64| {
        let over = if found > most { ": EXCEEDED" } else { "" };
        print(&format!("  {what}: {found}, at most {most}{over}"));
        exceeded |= found > most;
    };
    let mut before: Option<(u64, Duration)> = None;
    let is_only = std::env::args().any(|argument| argument == "--only");
    for (columns, rows, most) in CITIES.into_iter().filter(|_| !is_only) {
        let Some(tiling) = tiling(folder.path(), columns, rows) else { continue };
        let input = std::fs::metadata(&tiling.file).expect("the tiling").len();
        let made = compile(&tiling.file, &archive);
        let as_before = before.map_or(String::new(), |(bytes, time)| {
            let predicted = time.as_secs_f64() * input as f64 / bytes as f64;
            format!(", {:.2} × what the smaller one predicts", made.time.as_secs_f64() / predicted)
        });
        before = Some((input, made.time));
        print(&format!(
            "{columns} × {rows} tiles, {} MB: {:.2?}, {:.0} MB/s{as_before}",
            input / 1_000_000,
            made.time,
            input as f64 / 1e6 / made.time.as_secs_f64()
        ));
        hold("bytes of the archive", made.bytes, most);
        hold("bytes of memory at most", made.peak, (2 * made.bytes + BESIDE).min(LARGEST));
        let single = compiled(&tiling.base);
        let city = Snapshot::open(&archive).expect("the archive opens");
        let pitch = DVec2::from(pitch(single.map()));
        let (last_x, last_y) = (columns - 1, rows - 1);
        for (x, y) in [(0, 0), (last_x, 0), (0, last_y), (last_x, last_y)] {
            let shift = pitch * DVec2::new(x as f64, y as f64);
            let found = differences(single.map(), city.map(), shift);
            hold(&format!("other answers in tile {x}, {y}"), found as u64, 0);
        }
        std::fs::remove_file(&tiling.file).expect("removed");
    }
    for file in std::env::args().skip(1).filter(|argument| !argument.starts_with('-')) {
        let input = std::fs::metadata(&file).expect("the map").len();
        let made = compile(file.as_ref(), &archive);
        print(&format!(
            "{file}, {} MB: {:.2?}, {:.0} MB/s",
            input / 1_000_000,
            made.time,
            input as f64 / 1e6 / made.time.as_secs_f64()
        ));
        print(&format!("  bytes of the archive: {}", made.bytes));
        hold("bytes of memory at most", made.peak, 2 * made.bytes + BESIDE);
        let map = Snapshot::open(&archive).expect("the archive opens");
        hold("centres of lanes answered with a lane elsewhere", astray(map.map()) as u64, 0);
        let others = other_than_written(file.as_ref(), map.map());
        hold("places from the document answered with others", others as u64, 0);
    }
    if exceeded { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
