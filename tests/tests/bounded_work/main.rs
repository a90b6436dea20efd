//! What a small file may ask of the compiler: work and memory are bounded by limits and by the file's size.

// Objects: copies, outlines, lanes that they lie on.
mod objects;
// What a map is too large for.
mod limits;
// Points of roads' and lanes' lines.
mod lines;
// Roads over one another.
mod overlaps;
// Rules and links of the whole network.
mod network;

use mapd_archive::{NO_RELATION, RelationReason, Rows};
use mapd_compiler::{Compilation, CompileOptions, ReadOptions, compile_from};
use mapd_query::Map;
use mapd_query::SRange;
use mapd_query::vocabulary::Relation;
use mapd_tests::object_maps::{PLAIN, compile, document, open};
use std::fmt::Write as _;
use std::time::{Duration, Instant};

/// Time that each of these maps takes at most, in a build without optimization on a machine with other work: what is
/// tested for took minutes, and grew with the square.
const PATIENCE: Duration = Duration::from_secs(60);

/// Compiles a document within [`PATIENCE`].
fn soon(what: &str, text: &str) -> Compilation {
    soon_with(what, text, &CompileOptions::default())
}

/// As [`soon`], with these options.
fn soon_with(what: &str, text: &str, options: &CompileOptions) -> Compilation {
    let start = Instant::now();
    let open = || Ok(text.as_bytes());
    let reading = ReadOptions::default();
    let compiled = compile_from(open, &reading, options, &mut |_| {}).expect("reading works");
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

/// What a map of one road is compiled into where this is written in it: the only finding of the compiler's own, and its place.
fn check(what: &str, text: &str, (rule, path): (&str, &str)) {
    let compiled = soon(what, text);
    let own: Vec<_> = compiled.diagnostics.iter().map(|told| &told.finding).collect();
    let found = own.iter().find(|finding| finding.rule == rule && finding.path == path);
    assert!(found.is_some(), "{what}: {own:?}");
    let left = compiled.rows.map_or(0, |rows| rows.points.len() + rows.object_points.len());
    assert!(left < 100_000, "{what}: {left} points");
}

/// A road that turns about its own axis hundreds of times, so that lines beside it bend as often. Farther from it they have
/// more points.
const TWIST: &str = r#"<superelevation s="0" a="0" b="3" c="0" d="0"/>"#;

/// A road of a metre, of an id, that begins at x and has a lane.
fn metre(id: &str, x: f64) -> String {
    format!(
        r#"<road id="{id}" length="1" junction="-1"><planView><geometry s="0" x="{x:?}" y="0" hdg="0" length="1"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#
    )
}

fn map_of(content: &str) -> String {
    format!(r#"<OpenDRIVE><header revMajor="1" revMinor="7"/>{content}</OpenDRIVE>"#)
}

/// Findings of a rule.
fn count(compiled: &Compilation, rule: &str) -> usize {
    compiled.diagnostics.iter().filter(|told| told.finding.rule == rule).count()
}
