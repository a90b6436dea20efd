//! Compile throughput against quick-xml's own loop over events, attributes and numbers. `PEER` may name a program that loads the map
//! whose path it is given and prints `wall_ms=` with the milliseconds that loading alone took: it then runs in turns with them.

use mapd::archive_file;
use mapd_benches::{best_computed, computed, computed_here, floor, maps, print};
use mapd_compiler::{CompileOptions, Progress, compile};
use mapd_xodr::{Item, Limits, Reader};
use std::ffi::OsString;
use std::fs::File;
use std::hint::black_box;
use std::io::{self, Read};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

/// Bytes that the compiler sets aside at a time to be hashed.
const HASHED: usize = 256 << 10;
/// Threads that the model is asked for beyond those of this machine.
const MANY: u32 = 16;

/// A stage of a compilation, and what it took.
#[derive(Clone, Copy)]
struct Stage {
    name: &'static str,
    time: Duration,
    /// By all threads together.
    computed: Duration,
    /// By the thread that began it.
    alone: Duration,
    /// For how long cores computed nothing in its time, all together.
    waited: Duration,
}

/// A place in time: now, computed by all threads, by this one.
fn now() -> (Instant, Duration, Duration) {
    (Instant::now(), computed().unwrap_or_default(), computed_here().unwrap_or_default())
}

/// The stages of one compilation, and of writing and proving its archive, as `mapd compile` does.
fn stages(path: &Path, archive: &Path) -> Vec<Stage> {
    let file = File::open(path).expect("the map opens");
    let (mut begun, mut stage) = (now(), "reading");
    let mut times = Vec::new();
    let cores = std::thread::available_parallelism().map_or(1, |cores| cores.get() as u32);
    let mut pass = |next: &'static str| {
        if next != stage {
            let end = now();
            let (time, computed) = (end.0 - begun.0, end.1.saturating_sub(begun.1));
            let alone = end.2.saturating_sub(begun.2);
            let waited = (time * cores).saturating_sub(computed);
            times.push(Stage { name: stage, time, computed, alone, waited });
            (begun, stage) = (end, next);
        }
    };
    let options = CompileOptions { landmarks: 0, ..CompileOptions::default() };
    let compiled = compile(file, &options, &mut |progress| {
        pass(match progress {
            Progress::Linking { .. } => "linking",
            Progress::Sampling { .. } => "sampling",
            Progress::Graph { .. } => "lane graph",
            Progress::Indexing { .. } => "index",
            _ => "reading",
        });
    });
    let compiled = compiled.expect("reading works");
    pass("writing and proving");
    let rows = compiled.rows.expect("accepted");
    archive_file::write(archive, &rows, &compiled.provenance).expect("writes and proves");
    pass("end");
    times
}

/// The least time of each stage, of what was computed in it, of that what was computed by the first thread, and of what the cores waited.
fn best_stages(runs: usize, path: &Path, archive: &Path) -> String {
    let all: Vec<_> = (0..runs).map(|_| stages(path, archive)).collect();
    let least = |i: usize, of: fn(&Stage) -> Duration| {
        all.iter().filter_map(|run| run.get(i)).map(of).min().unwrap_or_default()
    };
    let first = all.first().into_iter().flatten().enumerate();
    let texts = first.map(|(i, stage)| {
        let [time, computed] = [least(i, |s| s.time), least(i, |s| s.computed)];
        let [alone, waited] = [least(i, |s| s.alone), least(i, |s| s.waited)];
        format!("{} {time:.1?} ({computed:.1?}, {alone:.1?}, {waited:.1?})", stage.name)
    });
    texts.collect::<Vec<_>>().join(", ")
}

/// Sets aside what it reads, as the compiler does for hashing.
struct SetAside {
    file: File,
    bytes: Vec<u8>,
}

impl Read for SetAside {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.file.read(buffer)?;
        if self.bytes.len() >= HASHED {
            self.bytes.clear();
        }
        self.bytes.extend_from_slice(&buffer[..count]);
        Ok(count)
    }
}

/// What cutting a map into batches takes, which is done by one thread at a time: reading the file, decoding it, counting its lines.
fn cutting(runs: usize, path: &Path) -> Duration {
    let once = || {
        let file = SetAside { file: File::open(path).expect("the map opens"), bytes: Vec::new() };
        let mut reader = Reader::new(file, Limits::default());
        while !matches!(reader.next().expect("reading works"), Some(Item::Header(_)) | None) {}
        let mut rest = reader.split().expect("behind the header roads follow");
        while let Some(batch) = rest.cutter.next() {
            black_box(batch);
        }
    };
    let start = computed_here().unwrap_or_default();
    (0..runs).for_each(|_| once());
    // Together: of a small map one run is less than what the system counts by.
    computed_here().unwrap_or_default().saturating_sub(start) / runs as u32
}

/// What a number of threads would take by the stages of one compilation on two: what one thread computes alone does not get shorter, nor do waits; the rest
/// is shared among all.
fn model(stages: &[Stage], threads: u32) -> Duration {
    let cores = std::thread::available_parallelism().map_or(1, |cores| cores.get() as u32);
    stages.iter().map(|s| s.alone.max(s.computed / threads) + s.waited / cores).sum()
}

/// The best compilation with so many threads.
fn measured(runs: usize, path: &Path, archive: &Path, threads: usize) -> Duration {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
    let whole = |stages: Vec<Stage>| stages.iter().map(|stage| stage.time).sum();
    let times = (0..runs).map(|_| whole(pool.install(|| stages(path, archive))));
    times.min().unwrap_or_default()
}

/// How the stages scale: the model of the best run on all cores beside what is measured, and what more threads would make of it.
fn scaling(runs: usize, path: &Path, archive: &Path) -> String {
    let whole = |stages: &Vec<Stage>| stages.iter().map(|stage| stage.time).sum::<Duration>();
    let mut best = (0..runs).map(|_| stages(path, archive)).min_by_key(whole).unwrap_or_default();
    let cut = cutting(runs, path);
    // The thread that began collects while others cut: the longer of both does not get shorter with more threads.
    if let Some(reading) = best.first_mut() {
        reading.alone = reading.alone.max(cut);
    }
    let bytes = std::fs::metadata(path).expect("the map").len() as f64;
    let [one, two, many] = [1, 2, MANY].map(|threads| model(&best, threads));
    format!(
        "cutting {cut:.1?}; 1 thread {one:.1?}, measured {:.1?}; 2 threads {two:.1?}, measured {:.1?}; {MANY} threads {many:.1?}, {:.2} GB/s",
        measured(runs, path, archive, 1),
        whole(&best),
        bytes / many.as_secs_f64() / 1e9
    )
}

/// How long the program that `PEER` names loads a map; none without one, or where it gives up.
fn peer_load(peer: Option<&OsString>, path: &Path) -> Option<Duration> {
    let told = Command::new(peer?).arg(path).output().ok()?;
    let told = String::from_utf8(told.stdout).ok()?;
    let (_, time) = told.split_once("wall_ms=")?;
    let time = time.split_whitespace().next()?.parse::<f64>().ok()?;
    Duration::try_from_secs_f64(time / 1e3).ok()
}

fn ratio(a: Duration, b: Duration) -> f64 {
    a.as_secs_f64() / b.as_secs_f64()
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

fn main() {
    let peer = std::env::var_os("PEER");
    let folder = tempfile::tempdir().expect("a folder");
    let archive = folder.path().join("archive.mapd");
    for (name, path) in maps(folder.path()) {
        let bytes = std::fs::metadata(&path).expect("the map").len();
        let runs = if bytes > 50_000_000 { 5 } else { 10 };
        // Landmarks are routing's own and counted apart.
        for (what, landmarks) in [("", 0), (" with landmarks", CompileOptions::default().landmarks)]
        {
            let options = CompileOptions { landmarks, ..CompileOptions::default() };
            // Each in turn with the bare loop: a machine that others share changes its speed.
            let mut peers = Vec::new();
            let pairs: Vec<[(Duration, Duration); 2]> = (0..runs)
                .map(|_| {
                    let bare = best_computed(1, || {
                        black_box(floor(&path));
                    });
                    let whole = best_computed(1, || {
                        let file = File::open(&path).expect("the map opens");
                        let compiled = compile(file, &options, &mut |_| {}).expect("reading works");
                        let rows = compiled.rows.expect("accepted");
                        archive_file::write(&archive, &rows, &compiled.provenance)
                            .expect("writes and proves");
                    });
                    peers.extend(peer_load(peer.as_ref(), &path).map(|load| ratio(whole.0, load)));
                    [bare, whole]
                })
                .collect();
            let [bare, whole] = [0, 1].map(|i| pairs.iter().map(|pair| pair[i].0).min());
            let [bare, whole] = [bare, whole].map(Option::unwrap_or_default);
            let computed = pairs.iter().map(|pair| pair[1].1).min().unwrap_or_default();
            let size = std::fs::metadata(&archive).expect("the archive").len();
            let rate = bytes as f64 / whole.as_secs_f64() / 1e6;
            print(&format!(
                "compile {name}{what}: {bytes} B to a verified archive of {size} B in {whole:.1?} ({rate:.0} MB/s), computed {computed:.1?}; bare quick-xml loop {bare:.1?}; ratio {:.2}, computed {:.2} (medians of {runs} pairs)",
                median(pairs.iter().map(|[bare, whole]| ratio(whole.0, bare.0))),
                median(pairs.iter().map(|[bare, whole]| ratio(whole.1, bare.1))),
            ));
            if !peers.is_empty() {
                let least = peers.iter().copied().fold(f64::INFINITY, f64::min);
                let all = median(peers.iter().copied());
                print(&format!(
                    "  {all:.2} × what PEER takes to load it (median; least {least:.2})"
                ));
            }
        }
        // A peer that builds its own representation, which nobody else can share, and checks nothing.
        let start = now();
        let peer = xodr::load_file(&path);
        let end = now();
        let loads = if peer.is_ok() { "loads it" } else { "gives up" };
        print(&format!(
            "  xodr {loads} in {:.1?}, computed {:.1?}",
            end.0 - start.0,
            end.1.saturating_sub(start.1)
        ));
        drop(peer);
        print(&format!(
            "  {name} by stage (computed, of it by the first thread, cores waited): {}",
            best_stages(runs, &path, &archive)
        ));
        print(&format!("  {name} by model: {}", scaling(runs, &path, &archive)));
    }
}
