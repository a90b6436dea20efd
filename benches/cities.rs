//! Cities: the tilings of 104 MB and 526 MB, each compiled by `mapd compile` in a process of its own. Peak memory, size of the
//! archive and answers are held to bounds; times are printed, with the ratio to what the smaller tiling would predict.
//!
//! `cargo bench -p mapd-benches --bench cities -- FILE…` compiles more files in the same way, without asking them anything.

use mapd_benches::{compiled, pitch, print, tiling};
use mapd_client::{Map, NearestOptions, Snapshot, glam::DVec2};
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

/// Tiles along x and y, and the largest archive \[bytes\]: 200 MB for the larger one, as many for each byte of the smaller.
const CITIES: [(usize, usize, u64); 2] = [(6, 6, 40_000_000), (13, 14, 200_000_000)];
/// Largest memory of a compiler beyond twice its archive \[bytes\].
const BESIDE: u64 = 64 << 20;
/// Largest memory of a compiler of the larger tiling \[bytes\].
const LARGEST: u64 = 500_000_000;
/// Points of each corner's tile that are asked for.
const POINTS: usize = 1_000;
/// Largest difference of an answer from that on the single tile `[m]`: coordinates of kilometres are written with 17 digits.
const SAME: f64 = 1e-6;
/// Pause between two looks at a compiler's memory.
const LOOK: Duration = Duration::from_millis(2);

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
    let start = Instant::now();
    let mut child = Command::new(env!("CARGO_BIN_EXE_mapd_under_bench"))
        .arg("compile")
        .arg(file)
        .arg("-o")
        .arg(archive)
        .arg("--quiet")
        .stderr(Stdio::null())
        .spawn()
        .expect("the compiler starts");
    let status = format!("/proc/{}/status", child.id());
    let mut peak = 0;
    let ended = loop {
        // The system's own largest value so far, which never falls.
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kib = line.and_then(|line| line.trim().strip_suffix(" kB")?.parse::<u64>().ok());
        peak = peak.max(kib.unwrap_or(0) << 10);
        if let Some(ended) = child.try_wait().expect("waited for") {
            break ended;
        }
        std::thread::sleep(LOOK);
    };
    assert!(ended.success(), "{}: {ended}", file.display());
    let bytes = std::fs::metadata(archive).expect("an archive").len();
    Made { time: start.elapsed(), peak, bytes }
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
    for (columns, rows, most) in CITIES {
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
    }
    if exceeded { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
