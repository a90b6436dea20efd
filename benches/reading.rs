//! Reading with all structural checks, and the rules beyond, against quick-xml's own loop over events, attributes and numbers: in
//! instructions by callgrind, where valgrind is installed, and in time.
//!
//! `reading [FILE…]` compares them on each file; without files on Town05 of the corpus.

use mapd_benches::{best, floor, print, small_map};
use mapd_rules::{Checker, Settings};
use mapd_xodr::{Limits, Reader};
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Reading may cost this many times the instructions of the bare loop.
const GOAL: f64 = 2.0;

/// All rules together may cost this many times the instructions of the bare loop.
const RULES_GOAL: f64 = 1.0;

/// Runs of which the best counts.
const RUNS: usize = 20;

/// Every element into its type, checked against the schema.
fn read(path: &Path) -> usize {
    let mut reader = Reader::open(path, Limits::default()).expect("the map opens");
    let mut count = 0;
    while let Some(item) = reader.next().expect("reading works") {
        black_box(&item);
        count += reader.take_findings().len();
    }
    count
}

/// As [`read`], and every element shown to the rules, and the network at the end.
fn check(path: &Path) -> usize {
    let mut reader = Reader::open(path, Limits::default()).expect("the map opens");
    let mut checker = Checker::new(&Settings::default());
    let mut count = 0;
    while let Some(mut item) = reader.next().expect("reading works") {
        checker.item(&mut item);
        count += reader.take_findings().len() + checker.take_findings().len();
    }
    checker.finish();
    count + checker.take_findings().len()
}

/// Instructions of one loop over a file, in a process of its own; none without valgrind.
fn instructions(which: &str, path: &Path) -> Option<f64> {
    let program = std::env::current_exe().ok()?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args(["--only", which])
        .arg(path)
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    text.split("Collected : ").nth(1)?.split_whitespace().next()?.parse().ok()
}

fn compare(path: &Path) {
    let bytes = std::fs::metadata(path).expect("the map").len();
    let bare = best(RUNS, || {
        black_box(floor(path));
    });
    let whole = best(RUNS, || {
        black_box(read(path));
    });
    let checked = best(RUNS, || {
        black_box(check(path));
    });
    let ratio = whole.as_secs_f64() / bare.as_secs_f64();
    let rules = (checked.as_secs_f64() - whole.as_secs_f64()) / bare.as_secs_f64();
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    print(&format!(
        "reading {name}: {bytes} B in {whole:.1?}, bare loop {bare:.1?}; time ratio {ratio:.2}, of the rules {rules:.2}"
    ));
    match ["bare", "read", "check"].map(|which| instructions(which, path)) {
        [Some(bare), Some(whole), Some(checked)] => print(&format!(
            "reading {name}: {whole} instructions, bare loop {bare}; ratio {:.2}, goal {GOAL}; rules {}, ratio {:.2}, goal \
             {RULES_GOAL}",
            whole / bare,
            checked - whole,
            (checked - whole) / bare
        )),
        _ => print("reading: no instruction counts, valgrind is not installed"),
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|a| a != "--bench").collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["--only", "bare", path] => {
            black_box(floor(Path::new(path)));
        }
        ["--only", "read", path] => {
            black_box(read(Path::new(path)));
        }
        ["--only", "check", path] => {
            black_box(check(Path::new(path)));
        }
        [] => compare(&small_map().1),
        files => files.iter().map(PathBuf::from).for_each(|path| compare(&path)),
    }
}
