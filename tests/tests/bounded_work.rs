//! What a small file may ask of the compiler: work and memory are bounded by limits and by the file's size.

use mapd_archive::{NO_RELATION, RelationReason, Rows};
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

/// An outline with these corners (u, v) beside s = 50.
fn outline(corners: impl Iterator<Item = (f64, f64)>) -> String {
    let mut text = String::from(
        r#"<object id="1" type="building" s="50" t="0" zOffset="0" hdg="0" orientation="none"><outlines><outline id="0" closed="true">"#,
    );
    for (u, v) in corners {
        let _ = write!(text, r#"<cornerLocal u="{u:.6}" v="{v:.6}" z="0" height="1"/>"#);
    }
    text + "</outline></outlines></object>"
}

/// Lanes of the only object: number, stretch of s, rounded to decimetres.
fn lanes(map: Map<'_>) -> Vec<(i32, [i64; 2])> {
    let object = map.objects().next().expect("an object");
    let round = |s: f64| (s * 10.0).round() as i64;
    let row = |at: mapd_query::ObjectLane<'_>| {
        let (from, to) = at.s_range();
        (at.lane().expect("a lane").number(), [round(from), round(to)])
    };
    let mut lanes: Vec<_> = object.lanes().map(row).collect();
    lanes.sort_unstable();
    lanes
}

/// Every corner was compared with every other one, and that again for every lane.
#[test]
fn corners_of_an_outline_are_not_compared_with_each_other() {
    let ellipse = |count: usize| {
        outline((0..count).map(move |i| {
            let angle = std::f64::consts::TAU * i as f64 / count as f64;
            (40.0 * angle.cos(), 3.0 * angle.sin())
        }))
    };
    // Half of the corners' stations are used, and all of them: the same lanes along the same stretches.
    let few = open(&document(&PLAIN, &ellipse(400)));
    let many = document(&PLAIN, &ellipse(40_000));
    soon("an outline of many corners", &many);
    assert_eq!(lanes(few.map()), lanes(open(&many).map()));
    assert_eq!(lanes(few.map()), [(-1, [100, 900]), (1, [100, 900])]);
}

/// Of an outline with many corners, not all are looked at one by one; none is passed over.
#[test]
fn a_narrow_corner_among_many_reaches_its_lane() {
    // Along t = 30 but for one corner that is a tenth of a millimetre wide, at s = 50.01 on lane −1.
    let (count, length) = (10_000, 80.0);
    let far = |i: i32| (f64::from(i) * length / f64::from(count) - 40.0, 30.0);
    let there = (0..=5000).map(far).chain([(0.010_05, -2.0), (0.010_1, 30.0)]);
    let back = [(40.0, 30.0), (40.0, 31.0), (-40.0, 31.0)];
    let corners = there.chain((5002..count).map(far)).chain(back);
    let snapshot = open(&document(&PLAIN, &outline(corners)));
    let found = lanes(snapshot.map());
    assert!(
        found.iter().any(|(lane, [from, to])| *lane == -1 && *from <= 501 && *to >= 499),
        "{found:?}"
    );
}

/// Every pair of lanes looked through all priorities of the map.
#[test]
fn priorities_are_looked_up_not_looked_through() {
    let mut text = String::from(r#"<OpenDRIVE><header revMajor="1" revMinor="7"/>"#);
    for id in 0..100 {
        let heading = f64::from(id) * 0.031;
        let (x, y) = (-50.0 * heading.cos(), -50.0 * heading.sin());
        let _ = write!(
            text,
            r#"<road id="{id}" length="100" junction="9"><planView><geometry s="0" x="{x:?}" y="{y:?}" hdg="{heading:?}" length="100"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#
        );
    }
    text.push_str(r#"<junction id="9" name="">"#);
    for road in 0..100_000 {
        let _ = write!(text, r#"<priority high="{}" low="1"/>"#, 1000 + road);
    }
    // Of two rows that contradict each other the first counts.
    text.push_str(
        r#"<priority high="3" low="5"/><priority high="5" low="3"/></junction></OpenDRIVE>"#,
    );
    let rows = rows(soon("priorities of a junction", &text));
    let found =
        rows.conflicts.iter().filter(|row| row.reason == RelationReason::JunctionPriority.code());
    let relations: Vec<u8> = found.map(|row| row.relation).collect();
    assert_eq!(relations, [Relation::Priority.code(), Relation::Yields.code()]);
    let pairs = rows.conflicts.iter().filter(|row| row.relation != NO_RELATION).count();
    assert!(pairs > 9000, "{pairs} pairs");
}
