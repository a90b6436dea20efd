//! What a small file may ask of the compiler: work and memory are bounded by limits and by the file's size.

use mapd_archive::{RelationReason, Rows};
use mapd_compiler::Compilation;
use mapd_query::{Map, Relation};
use mapd_tests::object_maps::{PLAIN, compile, document, open};
use std::fmt::Write as _;
use std::time::{Duration, Instant};

/// Copies of all objects that a map may have (docs/objects.md).
const MOST_COPIES: usize = 2_000_000;
/// Time that each of these maps takes at most, in a build without optimization on a machine with other work: what is
/// tested for took minutes, and grew with the square.
const PATIENCE: Duration = Duration::from_secs(60);

/// Compiles a document within [`PATIENCE`].
fn soon(what: &str, text: &str) -> Compilation {
    let start = Instant::now();
    let compiled = compile(text);
    let taken = start.elapsed();
    mapd_tests::say(&format!("{what}: {} bytes, {:.1} s", text.len(), taken.as_secs_f64()));
    assert!(taken < PATIENCE, "{what}: {taken:?}");
    compiled
}

fn rows(compiled: Compilation) -> Rows {
    compiled.rows.unwrap_or_else(|| panic!("rejected: {:?}", compiled.diagnostics))
}

/// Most memory that this process has had so far `[bytes]`.
fn peak() -> usize {
    let status = std::fs::read_to_string("/proc/self/status").expect("a status");
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).expect("a peak");
    line.trim().trim_end_matches(" kB").parse::<usize>().expect("a number") * 1024
}

/// The limit counted copies that had been made already, those of hundreds of objects at once: 14 KB took a gigabyte.
#[test]
fn copies_beyond_a_maps_limit_are_not_even_made() {
    const OBJECTS: usize = 60;
    const COPIES: usize = 100_000;
    let mut objects = String::new();
    for id in 0..OBJECTS {
        let _ = writeln!(
            objects,
            r#"<object id="{id}" type="pole" s="0" t="0" zOffset="0" radius="0.1" height="1"><repeat s="0" length="100" distance="0.001" tStart="1" tEnd="1" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/></object>"#
        );
    }
    let before = peak();
    let compiled = compile(&document(&PLAIN, &objects));
    // The copies as they are made and as they are stored, with their lanes and the index.
    let most = MOST_COPIES * 600;
    assert!(peak() - before < most, "{} bytes", peak() - before);
    let left_out = |id: usize| {
        let path = format!("OpenDRIVE/road[@id=1]/objects/object[@id={id}]");
        let mut all = compiled.diagnostics.iter();
        all.any(|told| {
            told.finding.path == path && told.finding.message.contains("100000 repetitions")
        })
    };
    for id in 0..OBJECTS {
        assert_eq!(left_out(id), id >= MOST_COPIES / COPIES, "object {id}");
    }
    assert_eq!(rows(compiled).object_copies.len(), MOST_COPIES);
}
