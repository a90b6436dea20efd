//! How the costs of compiling grow with a file and its archive, for each kind of file that is a pile of something: the exponents of instructions, counted by
//! valgrind, and of memory.
//!
//! `cargo bench -p mapd -p mapd-gates -p mapd-planner --bench piles -- [TIMES] [PART_OF_A_NAME]`: so many times as large as usual, and the kinds that are named so.

use mapd_tests::piles::{PILES, Pile};
use std::collections::HashMap;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, ExitCode};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Instructions may grow with this power of the bytes of file and archive together.
const MOST: f64 = 1.2;

/// Kinds that grow faster as long as they are small, and how fast at most: limits end it (docs/reading.md), those of lanes of a section or of pairs of roads that overlap. None
/// may join them.
const KNOWN: [(&str, f64); 12] = [
    // Of each two roads that cross it is found where: up to 65,536 pairs, and 16 more for each road.
    ("roads that cross in a grid", 1.65),
    ("spirals on one another", 1.45),
    // Times along each lane change with each type: up to 4,096 of both, and 32 more for each; beyond, the road is left out, and the archive is smaller.
    ("speeds of road types, lanes", 2.5),
    // Each road is another conflict with the one before.
    ("priorities in a chain over roads", 1.35),
    // Widths add up from lane 0 outwards: up to 1,024 lanes.
    ("shapes along, lanes", 1.5),
    ("road marks on the centre, lanes", 1.4),
    ("lanes with as many widths", 1.4),
    ("lane offsets, lanes", 1.35),
    ("bridges, lanes", 1.35),
    ("validities of an object, lanes", 1.35),
    ("validities of a signal, lanes", 1.35),
    // Corners of outlines are compared with those of others: up to 1,000,000 pairs.
    ("outlines with borders", 1.85),
];

/// What a kind of a size costs.
#[derive(Clone, Copy)]
struct Costs {
    /// Of the file and of the archive.
    bytes: [f64; 2],
    instructions: f64,
    /// Most memory `[bytes]`.
    peak: f64,
}

/// Runs the probe, under valgrind for the instructions and without for the memory.
///
/// Panics: it fails.
fn costs(folder: &Path, number: usize, pile: &Pile, n: usize) -> Costs {
    let file = folder.join(format!("{number}-{n}.xodr"));
    let text = (pile.text)(n);
    std::fs::write(&file, &text).expect("the map is written");
    let probe = env!("CARGO_BIN_EXE_pile_probe");
    let run = |command: &mut Command| {
        // One thread: waiting for others takes instructions.
        let output = command.arg(&file).env("RAYON_NUM_THREADS", "1").output();
        let output = output.expect("the probe runs");
        assert!(output.status.success(), "{} of {n}: {output:?}", pile.name);
        [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned())
    };
    let [printed, _] = run(&mut Command::new(probe));
    let mut figures = printed.split_whitespace().map(|word| word.parse().expect("a number"));
    let mut figure = || figures.next().expect("a figure");
    let (archive, peak) = (figure(), figure());
    let callgrind = ["--tool=callgrind", "--callgrind-out-file=/dev/null"];
    let [_, told] = run(Command::new("valgrind").args(callgrind).arg(probe));
    let line = told.lines().find(|line| line.contains("Collected")).expect("a count");
    let instructions = line.rsplit(' ').next().and_then(|word| word.parse().ok());
    let instructions = instructions.expect("a number");
    // What is large is not kept.
    std::fs::remove_file(&file).expect("the map is removed");
    Costs { bytes: [text.len() as f64, archive], instructions, peak }
}

/// The power of the bytes with which something grows, from what doubling adds twice.
fn exponent(of: [Costs; 3], what: impl Fn(&Costs) -> f64) -> f64 {
    let grown = |what: &dyn Fn(&Costs) -> f64| {
        let [small, twice, four_times] = of.each_ref().map(what);
        (four_times - twice).max(1.0) / (twice - small).max(1.0)
    };
    grown(&what).ln() / grown(&|costs| costs.bytes.iter().sum()).ln()
}

/// Prints a line of results.
fn print(line: &str) {
    // A closed stdout ends the benchmark's purpose, not the benchmark.
    let _ = writeln!(std::io::stdout(), "{line}");
}

fn main() -> ExitCode {
    if !Command::new("valgrind").arg("--version").output().is_ok_and(|out| out.status.success()) {
        print("skipped: valgrind is missing or does not run");
        return ExitCode::SUCCESS;
    }
    let mut times = 1;
    let mut parts = Vec::new();
    for word in std::env::args().skip(1).filter(|word| !word.starts_with("--")) {
        match word.parse::<usize>() {
            Ok(number) => times = number,
            Err(_) => parts.push(word),
        }
    }
    let is_asked =
        |pile: &&Pile| parts.is_empty() || parts.iter().any(|part| pile.name.contains(part));
    let piles: Vec<&Pile> = PILES.iter().filter(is_asked).collect();
    let known: HashMap<&str, f64> = KNOWN.into_iter().collect();
    let folder = tempfile::tempdir().expect("a folder");
    let (next, exceeded) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    print("instructions memory | million instructions, MB, KB of file and archive at the largest");
    let work = || {
        while let Some(pile) = piles.get(next.fetch_add(1, Ordering::Relaxed)) {
            let sizes = [1, 2, 4].map(|size| size * times * pile.small);
            let number = PILES.iter().position(|one| one.name == pile.name).unwrap_or_default();
            let all = sizes.map(|n| costs(folder.path(), number, pile, n));
            let (found, memory) =
                (exponent(all, |of| of.instructions), exponent(all, |of| of.peak));
            let [.., Costs { bytes: [file, archive], instructions, peak }] = all;
            let most = known.get(pile.name).copied().unwrap_or(MOST);
            let mark = if found > most { ": EXCEEDED" } else { "" };
            print(&format!(
                "{found:5.2} {memory:5.2} | {:6.0} {:6.1} {:6.0} {:6.0} | {} of {}{mark}",
                instructions / 1e6,
                peak / 1e6,
                file / 1e3,
                archive / 1e3,
                sizes[2],
                pile.name
            ));
            if found > most {
                exceeded.lock().expect("no panic").push(pile.name);
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    let exceeded = exceeded.into_inner().expect("no panic");
    if exceeded.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
