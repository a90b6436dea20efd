//! What mapd's benchmarks share. Each benchmark prints ratios against a floor or a peer measured in the same run.
//!
//! ```text
//! cargo bench -p mapd-benches --bench compile
//! cargo bench -p mapd-benches --bench cities
//! cargo bench -p mapd-benches --bench reading
//! cargo bench -p mapd-benches --bench attach
//! cargo bench -p mapd-benches --bench reload
//! cargo bench -p mapd-benches --bench overlays
//! cargo bench -p mapd-benches --bench queries
//! cargo bench -p mapd-benches --bench geodesy
//! cargo bench -p mapd-benches --bench routing
//! cargo bench -p mapd-benches --bench path
//! ```
//!
//! They use `carla/Town05.xodr` of the shared corpus and its 6×6 tiling, and say so where these are missing.

use mapd_client::{Map, Snapshot};
pub use mapd_planner::{PARTICLES, cloud, long_way, places};
pub use mapd_tests::maps::{Random, own_roads};
use quick_xml::events::Event;
use std::hint::black_box;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

/// Prints a line of results.
pub fn print(line: &str) {
    // A closed stdout ends the benchmark's purpose, not the benchmark.
    let _ = writeln!(std::io::stdout(), "{line}");
}

/// A map of a few megabytes: `carla/Town05` of the corpus, else the town that the project carries.
pub fn small_map() -> (&'static str, PathBuf) {
    match mapd_tests::shared("maps") {
        Some(shared) => ("Town05", shared.join("carla/Town05.xodr")),
        None => {
            print("no shared corpus beside the workspace; the carried town stands in");
            ("town", mapd_tests::carried("town.xodr"))
        }
    }
}

/// The benchmark maps that are there: name and path. The tiling is made once, in `folder`.
pub fn maps(folder: &Path) -> Vec<(&'static str, PathBuf)> {
    let Some(shared) = mapd_tests::shared("maps") else {
        print("skipped in part: no shared corpus beside the workspace; the carried town stands in");
        return vec![("town", mapd_tests::carried("town.xodr"))];
    };
    let town = shared.join("carla/Town05.xodr");
    let mut maps = vec![("Town05", town.clone())];
    maps.extend(tiling(folder, 6, 6).map(|tiling| ("big104", tiling.file)));
    maps
}

/// A map repeated side by side.
pub struct Tiling {
    /// The file.
    pub file: PathBuf,
    /// The file that is repeated.
    pub base: PathBuf,
}

/// Repeats `carla/Town05` of the corpus in so many columns and rows; none, said aloud, where that cannot be done.
pub fn tiling(folder: &Path, columns: usize, rows: usize) -> Option<Tiling> {
    let skipped =
        || print(&format!("skipped in part: no tiling of {columns} × {rows} can be made"));
    let Some(shared) = mapd_tests::shared("maps") else {
        skipped();
        return None;
    };
    let base = shared.join("carla/Town05.xodr");
    let file = folder.join(format!("tiles{columns}x{rows}.xodr"));
    let tile = shared.with_file_name("tools").join("tile.py");
    let mut made = Command::new("python3");
    made.arg(tile).arg(&base).arg(&file).args([columns.to_string(), rows.to_string()]);
    let is_made = made.output().is_ok_and(|output| output.status.success()) && file.exists();
    if !is_made {
        skipped();
    }
    is_made.then_some(Tiling { file, base })
}

/// How far apart tiles are: as far as the map's geometries, and 100 m.
pub fn pitch(map: Map<'_>) -> [f64; 2] {
    let spread = |of: fn(&mapd_archive::ArchivedGeometryRow) -> f64| {
        let places = map.tables().geometries.iter().map(of);
        let ends = places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], place| {
            [low.min(place), high.max(place)]
        });
        ends[1] - ends[0] + 100.0
    };
    [spread(|g| g.x()), spread(|g| g.y())]
}

/// A map, compiled in this process.
pub fn compiled(path: &Path) -> Snapshot {
    let file = std::fs::File::open(path).expect("the map opens");
    let compiled = mapd_compiler::compile(file, &Default::default(), &mut |_| {});
    let compiled = compiled.expect("reading works");
    let rows = compiled.rows.expect("accepted");
    let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
    Snapshot::from_bytes(archive).expect("opens")
}

/// Best time of several runs: what the machine can do when nothing disturbs it.
pub fn best(runs: usize, mut work: impl FnMut()) -> Duration {
    (0..runs)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed()
        })
        .min()
        .unwrap_or_default()
}

/// Time that the threads of this process have computed so far; none where the system does not say. Threads that have ended
/// do not count.
pub fn computed() -> Option<Duration> {
    let tasks = std::fs::read_dir("/proc/self/task").ok()?.flatten();
    tasks.map(|task| computed_by(&task.path())).sum()
}

/// As [`computed`], of this thread alone.
pub fn computed_here() -> Option<Duration> {
    computed_by(Path::new("/proc/thread-self"))
}

fn computed_by(task: &Path) -> Option<Duration> {
    let text = std::fs::read_to_string(task.join("schedstat")).ok()?;
    Some(Duration::from_nanos(text.split(' ').next()?.parse().ok()?))
}

/// Best time of several runs, and the least that was computed in one of them.
pub fn best_computed(runs: usize, mut work: impl FnMut()) -> (Duration, Duration) {
    let mut least = Duration::MAX;
    let wall = best(runs, || {
        let before = computed();
        work();
        if let Some(time) = before.zip(computed()).and_then(|(a, b)| b.checked_sub(a)) {
            least = least.min(time);
        }
    });
    (wall, least)
}

/// Median and 99th percentile.
pub fn percentiles(mut times: Vec<Duration>) -> (Duration, Duration) {
    times.sort();
    let at = |share: f64| {
        times.get(((times.len() as f64 - 1.0) * share) as usize).copied().unwrap_or_default()
    };
    (at(0.5), at(0.99))
}

/// Bytes that a processor reads at a time.
const LINE: usize = 64;
/// Reads of [`wait`].
const READS: u32 = 1 << 20;

/// The floor of a query at a random place: a read of so many bytes' memory that waits for the one before.
pub fn wait(bytes: usize) -> Duration {
    let count = (bytes / LINE).max(2);
    // Each line names the next; all are one ring (Sattolo's shuffle).
    let mut lines: Vec<[u64; LINE / 8]> = (0..count as u64).map(|i| [i; LINE / 8]).collect();
    let mut random = Random(9);
    for i in (1..count).rev() {
        lines.swap(i, (random.unit() * i as f64) as usize);
    }
    let (start, mut at) = (Instant::now(), 0u64);
    for _ in 0..READS {
        at = lines[at as usize][0];
    }
    black_box(at);
    start.elapsed() / READS
}

/// The floor of reading: quick-xml's loop over every event, every attribute, every number. The sum of the numbers.
pub fn floor(path: &Path) -> f64 {
    let mut reader = quick_xml::Reader::from_file(path).expect("the map opens");
    let mut buffer = Vec::new();
    let mut sum = 0.0;
    loop {
        buffer.clear();
        match reader.read_event_into(&mut buffer).expect("well-formed") {
            Event::Start(tag) | Event::Empty(tag) => {
                for attribute in tag.attributes() {
                    let value = attribute.expect("an attribute").value;
                    sum += value.parse::<f64>().unwrap_or(0.0);
                }
            }
            Event::Eof => return sum,
            _ => {}
        }
    }
}
