//! Instructions of one query, counted by valgrind, against stated bounds: a gate that noise cannot move.
//!
//! The count of a long run less that of a short one, so that starting and opening do not count. Time is in `queries.rs`.

use mapd_benches::print;
use mapd_compiler::{CompileOptions, compile};
use std::path::Path;
use std::process::{Command, ExitCode};

/// Queries of the short and of the long run.
const RUNS: [usize; 2] = [500, 2_500];

/// Kinds of [`query_probe`](../src/bin/query_probe.rs) and the instructions that one query may take on the carried town:
/// what it took when the bound was set, and a tenth.
const BOUNDS: [(&str, u64); 5] = [
    ("nearest", 4_430),
    ("trajectory", 3_920),
    ("hinted", 3_840),
    ("inertial", 535),
    ("inertial-trajectory", 515),
];

/// Instructions of a whole run; none where valgrind is missing or says nothing.
fn instructions(archive: &Path, kind: &str, count: usize) -> Option<u64> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(env!("CARGO_BIN_EXE_query_probe"))
        .arg(archive)
        .args([kind, &count.to_string()])
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&output.stderr);
    let line = text.lines().find(|line| line.contains("Collected"))?;
    line.rsplit(' ').next()?.parse().ok().filter(|_| output.status.success())
}

fn main() -> ExitCode {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("town.mapd");
    let file = std::fs::File::open(mapd_tests::carried("town.xodr")).expect("the town opens");
    let compiled = compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
    let rows = compiled.rows.expect("accepted");
    let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
    std::fs::write(&path, &archive[..]).expect("the archive is written");
    let mut exceeded = false;
    for (kind, bound) in BOUNDS {
        let counts = RUNS.map(|count| instructions(&path, kind, count));
        let [Some(short), Some(long)] = counts else {
            print("skipped: valgrind is missing or does not run");
            return ExitCode::SUCCESS;
        };
        let each = long.saturating_sub(short) / (RUNS[1] - RUNS[0]) as u64;
        let over = each > bound;
        print(&format!(
            "{kind}: {each} instructions, at most {bound}{}",
            if over { ": EXCEEDED" } else { "" }
        ));
        exceeded |= over;
    }
    if exceeded { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
