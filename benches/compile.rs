//! Compile throughput against quick-xml's own loop over events, attributes and numbers.

use mapd::archive_file;
use mapd_benches::{best_computed, computed, computed_here, floor, maps, print};
use mapd_compiler::{CompileOptions, Progress, compile};
use std::hint::black_box;
use std::path::Path;
use std::time::{Duration, Instant};

/// A stage of a compilation, and what it took.
#[derive(Clone, Copy)]
struct Stage {
    name: &'static str,
    time: Duration,
    /// By all threads together.
    computed: Duration,
    /// By the thread that the others wait for.
    alone: Duration,
}

/// A place in time: now, computed by all threads, by this one.
fn now() -> (Instant, Duration, Duration) {
    (Instant::now(), computed().unwrap_or_default(), computed_here().unwrap_or_default())
}

/// The stages of one compilation, and of writing and proving its archive, as `mapd compile` does.
fn stages(path: &Path, archive: &Path) -> Vec<Stage> {
    let file = std::fs::File::open(path).expect("the map opens");
    let (mut begun, mut stage) = (now(), "reading");
    let mut times = Vec::new();
    let mut pass = |next: &'static str| {
        if next != stage {
            let end = now();
            times.push(Stage {
                name: stage,
                time: end.0 - begun.0,
                computed: end.1.saturating_sub(begun.1),
                alone: end.2.saturating_sub(begun.2),
            });
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

/// The least time of each stage, of what was computed in it, and of that what was computed by the first thread.
fn best_stages(runs: usize, path: &Path, archive: &Path) -> String {
    let all: Vec<_> = (0..runs).map(|_| stages(path, archive)).collect();
    let least = |i: usize, of: fn(&Stage) -> Duration| {
        all.iter().filter_map(|run| run.get(i)).map(of).min().unwrap_or_default()
    };
    let first = all.first().into_iter().flatten().enumerate();
    let texts = first.map(|(i, stage)| {
        let [time, computed, alone] =
            [least(i, |s| s.time), least(i, |s| s.computed), least(i, |s| s.alone)];
        format!("{} {time:.1?} ({computed:.1?}, {alone:.1?})", stage.name)
    });
    texts.collect::<Vec<_>>().join(", ")
}

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    let archive = folder.path().join("archive.mapd");
    for (name, path) in maps(folder.path()) {
        let bytes = std::fs::metadata(&path).expect("the map").len();
        let runs = if bytes > 50_000_000 { 3 } else { 10 };
        let bare = best_computed(runs, || {
            black_box(floor(&path));
        });
        let mut size = 0;
        // Landmarks are routing's own and counted apart.
        for (what, landmarks) in [("", 0), (" with landmarks", CompileOptions::default().landmarks)]
        {
            let options = CompileOptions { landmarks, ..CompileOptions::default() };
            let whole = best_computed(runs, || {
                let file = std::fs::File::open(&path).expect("the map opens");
                let compiled = compile(file, &options, &mut |_| {}).expect("reading works");
                let rows = compiled.rows.expect("accepted");
                archive_file::write(&archive, &rows, &compiled.provenance)
                    .expect("writes and proves");
                size = std::fs::metadata(&archive).expect("the archive").len();
            });
            let rate = bytes as f64 / whole.0.as_secs_f64() / 1e6;
            print(&format!(
                "compile {name}{what}: {bytes} B to a verified archive of {size} B in {:.1?} ({rate:.0} MB/s), computed {:.1?}; bare quick-xml loop {:.1?}; ratio {:.2}, computed {:.2}",
                whole.0,
                whole.1,
                bare.0,
                whole.0.as_secs_f64() / bare.0.as_secs_f64(),
                whole.1.as_secs_f64() / bare.1.as_secs_f64(),
            ));
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
            "  {name} by stage (computed, of it by the first thread): {}",
            best_stages(runs, &path, &archive)
        ));
    }
}
