//! Instructions of one query, and of compiling one byte, counted by valgrind, against stated bounds: a gate that noise cannot
//! move.
//!
//! The count of a long run less that of a short one, so that starting and opening do not count. Time is in `queries.rs`.

mod views;

use mapd_compiler::{CompileOptions, compile};
use std::io::Write;
use std::path::Path;
use std::process::{Command, ExitCode};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Queries of the short and of the long run.
const RUNS: [usize; 2] = [500, 2_500];

/// Kinds of [`query_probe`](../planner/src/bin/query_probe.rs) and the instructions that one query may take on the carried town:
/// what it took when the bound was set, and a twentieth.
const BOUNDS: [(&str, u64); 12] = [
    ("nearest", 3_090),
    ("trajectory", 2_735),
    ("beside", 16_190),
    ("hinted", 5_625),
    ("inertial", 520),
    ("inertial-trajectory", 515),
    ("track", 755),
    ("position", 1_245),
    ("contains", 810),
    ("near", 28_880),
    ("near-few", 5_940),
    ("short-length", 815),
];

/// Instructions that the nearest lane of a point beside a tight turn may take, where a look along the stretch tells whether another place is nearer.
const TURN: f64 = 41_500.0;

/// Most that all lanes near a place may take where they are few, as a multiple of the nearest alone within the same radius.
const FEW: f64 = 2.0;

/// Records of a short and of a long road, and most that the length of a lane along the whole of one may take in instructions, as a multiple of what it takes
/// along the other: what is stored of it is searched in, no more.
const RECORDS: [usize; 2] = [200, 10_000];
const LONGER: f64 = 1.25;

/// Instructions that one particle of a cloud may take as part of a batch, on the carried town; a part of them lie beside all lanes.
const PARTICLE: f64 = 1_130.0;
/// Instructions that one place along the longest road may take from track coordinates as part of a batch.
const PLACE: f64 = 386.0;
/// How many batches of particles, and of places, in the short and in the long run.
const CLOUDS: [usize; 2] = [1, 3];

/// Kinds of [`path_probe`](../planner/src/bin/path_probe.rs), on a path of at least 500 m over the carried town and between its ends, as for queries.
const PATH_BOUNDS: [(&str, u64); 10] = [
    ("project", 970),
    ("at", 3_345),
    ("build", 536_000),
    ("corridor", 184_400),
    ("surface", 378_200),
    ("segments", 12_250),
    ("conflicts", 1_181_000),
    ("request", 27_000),
    ("alternatives", 116_400),
    ("reach", 44_100),
];
/// Instructions that one point may take in a batch of 1,000, as for queries.
const PATH_POINT: f64 = 1_250.0;
/// How many points a batch of [`path_probe`](../planner/src/bin/path_probe.rs) has, and how many batches.
const PATH_POINTS: f64 = 1_000.0;
const PATH_BATCHES: [usize; 2] = [1, 3];
/// Questions of the short and of the long run.
const PATH_RUNS: [usize; 2] = [50, 250];

/// Blocks of the town that is compiled, in either direction: some batches of text.
const BLOCKS: usize = 12;
/// Times that it is compiled in the short and in the long run.
const COMPILATIONS: [usize; 2] = [1, 3];
/// Instructions that compiling may take per byte of OpenDRIVE, without landmarks: as for queries.
const PER_BYTE: f64 = 331.0;
/// Most that compiling may take with a patch of some roads, as a share of what it takes without.
const PATCHED: f64 = 1.10;

/// Lanes on either side of two sections, each with so many widths, and the most that compiling the wider one may take of what the other does: lines
/// of twice the lanes have four times the points.
const LANES: [usize; 2] = [16, 32];
const WIDTHS: usize = 40;
const WIDER: f64 = 5.0;

/// The programs that ask queries, and of paths and routes, built as planners link the client: they lie outside of the crates that answer. With the
/// packages of this benchmark, so that what they have in common is built once. None where they cannot be built.
fn probes() -> Option<[String; 3]> {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let arguments = "build --quiet --release --bins -p mapd -p mapd-gates -p mapd-planner";
    let is_built = Command::new(cargo)
        .args(arguments.split(' '))
        .status()
        .is_ok_and(|status| status.success());
    let target = Path::new(env!("CARGO_BIN_EXE_compile_probe")).parent()?;
    let programs = ["query_probe", "view_probe", "path_probe"].map(|name| target.join(name));
    (is_built && programs.iter().all(|program| program.exists()))
        .then(|| programs.map(|program| program.to_string_lossy().into_owned()))
}

/// Instructions of a whole run on two threads; none where valgrind is missing or says nothing.
fn instructions(program: &str, args: &[&str]) -> Option<u64> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args(args)
        .env("RAYON_NUM_THREADS", "2")
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&output.stderr);
    let line = text.lines().find(|line| line.contains("Collected"))?;
    line.rsplit(' ').next()?.parse().ok().filter(|_| output.status.success())
}

/// What is counted: a program, its arguments, and how often it does what is asked in the short and in the long run.
#[derive(Clone)]
struct Job<'a> {
    program: &'a str,
    args: Vec<&'a str>,
    runs: [usize; 2],
}

impl<'a> Job<'a> {
    fn new(program: &'a str, args: &[&'a str], runs: [usize; 2]) -> Self {
        Self { program, args: args.to_vec(), runs }
    }
}

/// Instructions of one of what each program does so many times, in the order of the jobs. As many run at once as there are processors: what is
/// counted does not depend on what else runs.
///
/// Panics: a program fails.
fn counted(jobs: &[Job<'_>]) -> Vec<f64> {
    let next = AtomicUsize::new(0);
    let counts: Vec<OnceLock<u64>> = (0..2 * jobs.len()).map(|_| OnceLock::new()).collect();
    let work = || {
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            let Some(Job { program, args, runs }) = jobs.get(number / 2) else { return };
            let times = runs[number % 2].to_string();
            let count = instructions(program, &[&args[..], &[&times]].concat());
            let count = count.unwrap_or_else(|| panic!("{program} {args:?} fails under valgrind"));
            counts[number].set(count).expect("counted once");
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    let of = |number: usize| counts[number].get().copied().unwrap_or_default();
    let each = |(i, job): (usize, &Job<'_>)| {
        of(2 * i + 1).saturating_sub(of(2 * i)) as f64 / (job.runs[1] - job.runs[0]) as f64
    };
    jobs.iter().enumerate().map(each).collect()
}

/// Prints a line of results.
fn print(line: &str) {
    // A closed stdout ends the benchmark's purpose, not the benchmark.
    let _ = writeln!(std::io::stdout(), "{line}");
}

/// Tells a figure; whether it is beyond its bound.
fn exceeds(what: &str, found: f64, bound: f64, digits: usize) -> bool {
    let mark = if found > bound { ": EXCEEDED" } else { "" };
    print(&format!("{what}: {found:.digits$} instructions, at most {bound:.digits$}{mark}"));
    found > bound
}

/// Compiles a map and writes its archive.
fn write(text: impl std::io::Read + Send, path: &Path) {
    let compiled = compile(text, &CompileOptions::default(), &mut |_| {}).expect("reading works");
    let rows = compiled.rows.expect("accepted");
    let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
    std::fs::write(path, &archive[..]).expect("the archive is written");
}

fn main() -> ExitCode {
    if !Command::new("valgrind").arg("--version").output().is_ok_and(|out| out.status.success()) {
        print("skipped: valgrind is missing or does not run");
        return ExitCode::SUCCESS;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("town.mapd");
    let file = std::fs::File::open(mapd_tests::carried("town.xodr")).expect("the town opens");
    write(file, &path);
    let text = mapd_tests::town::town(BLOCKS, BLOCKS);
    let town = folder.path().join("town.xodr");
    std::fs::write(&town, &text).expect("the town is written");
    let (path, town) = (path.to_string_lossy(), town.to_string_lossy());
    let Some([probe, view_probe, path_probe]) = probes() else {
        print("the programs that ask queries cannot be built");
        return ExitCode::FAILURE;
    };
    let mut exceeded = false;
    let jobs = BOUNDS.map(|(kind, _)| Job::new(&probe, &[&path, kind], RUNS));
    let counts = counted(&jobs);
    for ((kind, bound), each) in BOUNDS.into_iter().zip(&counts) {
        exceeded |= exceeds(kind, *each, bound as f64, 0);
    }
    let turns = folder.path().join("turns.mapd");
    write(mapd_tests::graph_maps::tight_turns().as_bytes(), &turns);
    let turn = counted(&[Job::new(&probe, &[&turns.to_string_lossy(), "turn"], RUNS)])[0];
    exceeded |= exceeds("beside tight turns", turn, TURN, 0);
    let of = |(kind, _): &(&str, u64)| *kind == "near-few";
    let few = BOUNDS.iter().position(of).map(|at| counts[at]).expect("counted");
    let nearest = counted(&[Job::new(&probe, &[&path, "nearest-few"], RUNS)])[0];
    let what = format!("near-few: {:.2} of the nearest alone", few / nearest);
    exceeded |= exceeds(&what, few, nearest * FEW, 0);
    let roads = RECORDS.map(|records| {
        let road = folder.path().join(format!("{records}.mapd"));
        write(mapd_tests::long_lane::long_lane(records, true).as_bytes(), &road);
        road.to_string_lossy().into_owned()
    });
    let jobs = [0, 1].map(|i| Job::new(&probe, &[&roads[i], "length"], RUNS));
    let lengths = counted(&jobs);
    let what = format!(
        "length of {} records: {:.2} of {}",
        RECORDS[1],
        lengths[1] / lengths[0],
        RECORDS[0]
    );
    exceeded |= exceeds(&what, lengths[1], lengths[0] * LONGER, 0);
    let kinds = ["cloud", "cloud-single", "inertial-batch"];
    let jobs = kinds.map(|kind| Job::new(&probe, &[&path, kind], CLOUDS));
    let clouds = counted(&jobs);
    let [batch, single, place] = [0, 1, 2].map(|i| clouds[i] / mapd_planner::PARTICLES as f64);
    exceeded |= exceeds("inertial, a place of a batch", place, PLACE, 0);
    exceeded |= exceeds("cloud, per particle", batch, PARTICLE, 0);
    print(&format!("the same one by one: {single:.0}, {:.1} ×", single / batch));
    let mut jobs =
        PATH_BOUNDS.map(|(kind, _)| Job::new(&path_probe, &[&path, kind], PATH_RUNS)).to_vec();
    jobs.push(Job::new(&path_probe, &[&path, "project-batch"], PATH_BATCHES));
    let paths = counted(&jobs);
    for ((kind, bound), each) in PATH_BOUNDS.into_iter().zip(&paths) {
        exceeded |= exceeds(&format!("path, {kind}"), *each, bound as f64, 0);
    }
    let batch = paths[PATH_BOUNDS.len()];
    exceeded |= exceeds("path, a point of a batch", batch / PATH_POINTS, PATH_POINT, 0);
    let patch = folder.path().join("patch.xodr");
    std::fs::write(&patch, mapd_tests::maps::own_roads(&text)).expect("the patch is written");
    let compile_probe = env!("CARGO_BIN_EXE_compile_probe");
    let patch = patch.to_string_lossy();
    let jobs = ["-", &patch].map(|patch| Job::new(compile_probe, &[&town, patch], COMPILATIONS));
    let compiled = counted(&jobs);
    let [plain, patched] = [compiled[0], compiled[1]];
    exceeded |= exceeds("compile, per byte", plain / text.len() as f64, PER_BYTE, 1);
    let what = format!("compile with a patch: {:.3} of without", patched / plain);
    exceeded |= exceeds(&what, patched, plain * PATCHED, 0);
    let sections = LANES.map(|lanes| {
        let file = folder.path().join(format!("{lanes}.xodr"));
        let text = mapd_tests::long_lane::many_lanes(lanes, WIDTHS, false);
        std::fs::write(&file, text).expect("the section is written");
        file.to_string_lossy().into_owned()
    });
    let jobs = [0, 1].map(|i| Job::new(compile_probe, &[&sections[i], "-"], COMPILATIONS));
    let wide = counted(&jobs);
    let what = format!("{} lanes: {:.2} of {}", 2 * LANES[1], wide[1] / wide[0], 2 * LANES[0]);
    exceeded |= exceeds(&what, wide[1], wide[0] * WIDER, 0);
    exceeded |= views::run(&view_probe, folder.path());
    if exceeded { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
