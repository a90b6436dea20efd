//! What a small file may ask of the compiler: work and memory are bounded by limits and by the file's size.

use mapd_archive::{NO_RELATION, RelationReason, Rows};
use mapd_compiler::{Compilation, CompileOptions, ReadOptions, compile_from};
use mapd_query::Map;
use mapd_query::SRange;
use mapd_query::vocabulary::Relation;
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
    let row = |at: mapd_query::objects::ObjectLane<'_>| {
        let SRange { low: from, high: to } = at.s_range();
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

/// Edges of each lane were added up from lane 0 again, for each object.
#[test]
fn lanes_are_not_added_up_for_each_lane() {
    let mut lanes = String::new();
    for lane in 3..2000 {
        let _ = write!(
            lanes,
            r#"<lane id="-{lane}" type="driving"><width sOffset="0" a="0.3" b="0" c="0" d="0"/></lane>"#
        );
    }
    let mut objects = String::new();
    for id in 0..1000 {
        let _ = write!(
            objects,
            r#"<object id="{id}" type="pole" s="50" t="-50" zOffset="0" radius="0.1" height="1"/>"#
        );
    }
    let text = document(&PLAIN, &objects).replace("</right>", &format!("{lanes}</right>"));
    let rows = rows(soon("objects beside many lanes", &text));
    assert!(rows.object_lanes.len() >= 1000, "{}", rows.object_lanes.len());
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

/// What a map of one road is compiled into where this is written in it: the only finding of the compiler's own, and its place.
fn check(what: &str, text: &str, (rule, path): (&str, &str)) {
    let compiled = soon(what, text);
    let own: Vec<_> = compiled.diagnostics.iter().map(|told| &told.finding).collect();
    let found = own.iter().find(|finding| finding.rule == rule && finding.path == path);
    assert!(found.is_some(), "{what}: {own:?}");
    let left = compiled.rows.map_or(0, |rows| rows.points.len() + rows.object_points.len());
    assert!(left < 100_000, "{what}: {left} points");
}

/// Between two places a metre apart a cubic may be as long as the way to the sun: its points took gigabytes, and no end was
/// seen.
#[test]
fn lines_of_astronomic_length_take_out_their_part() {
    let road = ("mapd:compile.too_large", "OpenDRIVE/road[@id=1]");
    let plain = document(&PLAIN, "");
    let with = |from: &str, to: &str| {
        assert!(plain.contains(from), "{from}");
        plain.replace(from, to)
    };
    let cubic = |name: &str, [a, b, c, d]: [f64; 4]| {
        format!(r#"<{name} s="0" a="{a:?}" b="{b:?}" c="{c:?}" d="{d:?}"/>"#)
    };
    let offset = cubic("laneOffset", [1e9, -1e12, 1e12, 1e9]);
    check("lane offset", &with("<lanes>", &format!("<lanes>{offset}")), road);
    let old = r#"<elevation s="0" a="0.0" b="0.0" c="0" d="0"/>"#;
    check("elevation", &with(old, &cubic("elevation", [0.0, 1e9, -1e12, 1e12])), road);
    let old = r#"<superelevation s="0" a="0.0" b="0" c="0" d="0"/>"#;
    check("superelevation", &with(old, &cubic("superelevation", [0.0, 1e6, 0.0, 0.0])), road);
    let old = r#"<width sOffset="0" a="2.5" b="0" c="0" d="0"/>"#;
    let wide = r#"<width sOffset="0" a="2.5" b="1e9" c="-1e8" d="1e7"/>"#;
    check("width", &with(old, wide), road);
    let object = |inner: &str| {
        document(
            &PLAIN,
            &format!(
                r#"<object id="7" type="barrier" s="0" t="0" zOffset="0" height="1">{inner}</object>"#
            ),
        )
    };
    let part = ("mapd:compile.object_part", "OpenDRIVE/road[@id=1]/objects/object[@id=7]");
    let swept = r#"<repeat s="0" length="100" distance="0" tStart="0" tEnd="0" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0" bT="1e9" cT="-1e9" dT="1e8"/>"#;
    check("swept", &object(swept).replace("revMinor=\"8\"", "revMinor=\"9\""), part);
    let wide = swept.replace("distance", r#"widthStart="1" widthEnd="1" distance"#);
    check("swept with a width", &object(&wide).replace("revMinor=\"8\"", "revMinor=\"9\""), part);
}

/// A road that turns about its own axis hundreds of times, so that lines beside it bend as often. Farther from it they have
/// more points.
const TWIST: &str = r#"<superelevation s="0" a="0" b="3" c="0" d="0"/>"#;

/// Many lines each of which is not too long: the map as a whole has a limit that grows with its file.
#[test]
fn points_of_a_map_are_bounded_by_its_file() {
    let mut sections = String::new();
    for i in 0..5 {
        let s = 1000 * i;
        let _ = write!(
            sections,
            r#"<laneSection s="{s}"><center><lane id="0" type="none"/></center><right>"#
        );
        for lane in 1..=60 {
            let _ = write!(
                sections,
                r#"<lane id="-{lane}" type="driving"><width sOffset="0" a="0.2" b="0" c="0" d="0"/></lane>"#
            );
        }
        sections.push_str("</right></laneSection>");
    }
    let text = format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="5000" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="5000"><line/></geometry></planView><lateralProfile>{TWIST}</lateralProfile><lanes>{sections}</lanes></road></OpenDRIVE>"#
    );
    let compiled = soon("a twisted road", &text);
    let own = compiled.diagnostics.iter().map(|told| &told.finding);
    let found: Vec<_> = own.filter(|finding| finding.rule == "mapd:compile.too_large").collect();
    assert!(found.len() == 1 && found[0].path == "OpenDRIVE", "{found:?}");
    assert!(compiled.rows.is_none());
}

/// As of lanes, of what is swept along roads: those beyond the limit are left out, each with its finding.
#[test]
fn points_of_swept_objects_are_bounded_by_the_file() {
    const OBJECTS: usize = 50;
    let mut objects = String::new();
    for id in 0..OBJECTS {
        let _ = writeln!(
            objects,
            r#"<object id="{id}" type="barrier" s="0" t="0" zOffset="0" height="1"><repeat s="0" length="1000" distance="0" tStart="2" tEnd="2" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/></object>"#
        );
    }
    let flat = r#"<superelevation s="0" a="0.0" b="0" c="0" d="0"/>"#;
    let text = document(&PLAIN, &objects).replace(flat, TWIST);
    let compiled = soon("swept objects", &text.replace(r#"length="100""#, r#"length="1000""#));
    let findings = compiled.diagnostics.iter().map(|told| &told.finding);
    let parts = findings.filter(|finding| finding.rule == "mapd:compile.object_part");
    let lost: Vec<_> = parts.map(|finding| finding.path.clone()).collect();
    let rows = rows(compiled);
    let (points, copies) = (rows.object_points.len(), rows.object_copies.len());
    mapd_tests::say(&format!("{points} points of {copies} objects, {} left out", lost.len()));
    assert!(points <= (1 << 19) + OBJECTS * (1 << 9), "{points}");
    // The first ones fit.
    let expected =
        (copies..OBJECTS).map(|id| format!("OpenDRIVE/road[@id=1]/objects/object[@id={id}]"));
    assert_eq!(lost, expected.collect::<Vec<_>>());
    assert!(copies > 0 && copies < OBJECTS, "{copies}");
}

/// Roads side by side, each line of some thousand points, whose lanes' rows are apart by what the index keeps lines
/// for: each of them took the others' place, and was decoded as a whole again for the next segment.
#[test]
fn long_lanes_side_by_side_are_not_decoded_for_each_segment() {
    const LANES: &str = r#"<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="0.2" b="0" c="0" d="0"/></lane></right></laneSection></lanes>"#;
    const LENGTH: f64 = 60_000.0;
    const BETWEEN: usize = 127;
    let mut text = String::from(r#"<OpenDRIVE><header revMajor="1" revMinor="7"/>"#);
    let mut road = |id: usize, [x, y]: [f64; 2], length: f64, shape: &str| {
        let _ = write!(
            text,
            r#"<road id="{id}" length="{length:?}" junction="-1"><planView><geometry s="0" x="{x:?}" y="{y:?}" hdg="0" length="{length:?}">{shape}</geometry></planView>{LANES}</road>"#
        );
    };
    let long = 16;
    for i in 0..long {
        let id = i * (BETWEEN + 1);
        road(id, [0.0, 0.3 * i as f64], LENGTH, r#"<arc curvature="0.0001"/>"#);
        for k in 1..=BETWEEN {
            road(id + k, [10.0 * k as f64, -1000.0 - 10.0 * i as f64], 1.0, "<line/>");
        }
    }
    text.push_str("</OpenDRIVE>");
    let fine = 1e-3;
    let options = CompileOptions {
        index_tolerance: fine,
        bound_tolerance: fine,
        ..CompileOptions::default()
    };
    let rows = rows(soon_with("long lanes side by side", &text, &options));
    let most = rows.lanes.iter().map(|lane| lane.center_count).max();
    assert!(most > Some(1000), "{most:?} points");
    // All segments are there: 16 of a leaf.
    let points = rows.lanes.iter().map(|lane| usize::from(lane.center_count)).sum::<usize>();
    assert!(rows.index_leaves.len() * 16 + rows.lanes.len() > points, "{points} points");
}

/// Each pair of stretches of two roads looked through all junctions of one road for each of the other's.
#[test]
fn junctions_of_overlapping_roads_are_looked_up() {
    const JUNCTIONS: usize = 20_000;
    let overlaps = |is_shared: bool| {
        let mut text = String::from(r#"<OpenDRIVE><header revMajor="1" revMinor="7"/>"#);
        for (id, y) in [(1, 0.0), (2, 1.0)] {
            let _ = write!(
                text,
                r#"<road id="{id}" length="1000" junction="-1"><planView><geometry s="0" x="0" y="{y:?}" hdg="0" length="1000"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#
            );
        }
        for junction in 0..JUNCTIONS {
            for road in [1, 2] {
                let _ = write!(
                    text,
                    r#"<junction id="{}"><connection id="0" incomingRoad="{road}" connectingRoad="{road}"/></junction>"#,
                    2 * junction + road
                );
            }
        }
        if is_shared {
            text.push_str(
                r#"<junction id="both"><connection id="0" incomingRoad="1" connectingRoad="2"/></junction>"#,
            );
        }
        text.push_str("</OpenDRIVE>");
        let compiled = soon("roads of many junctions", &text);
        let rules = compiled.diagnostics.iter().map(|told| told.finding.rule);
        rules.filter(|rule| rule.ends_with(":road.no_overlap_outside_junction")).count()
    };
    assert_eq!([true, false].map(overlaps), [0, 1]);
}

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

const OVERLAPS: &str = "mapd:compile.overlaps";

/// Each pair was compared and kept: 32 million, in gigabytes.
#[test]
fn roads_over_one_another_are_not_all_compared() {
    let at = |x: fn(u32) -> f64| {
        map_of(&(0..8000).map(|id| metre(&id.to_string(), x(id))).collect::<String>())
    };
    let before = peak();
    let compiled = soon("roads at one place", &at(|_| 0.0));
    assert!(peak() - before < 400 << 20, "{} bytes", peak() - before);
    assert_eq!(count(&compiled, OVERLAPS), 1);
    assert_eq!(rows(compiled).roads.len(), 8000);
    // Beside one another, nothing is cut short.
    let compiled = soon("roads in a row", &at(|id| f64::from(id) * 2.0));
    assert_eq!(count(&compiled, OVERLAPS), 0);
}

/// So were those that share an id, of which all but none are left out.
#[test]
fn roads_of_one_id_are_not_all_compared() {
    let text = map_of(&metre("1", 0.0).repeat(4000));
    let compiled = soon("roads of one id", &text);
    assert!(compiled.rows.is_none());
    assert!(count(&compiled, "asam.net:xodr:1.4.0:ids.id_unique_in_class") > 0);
}

/// Roads without anything, each of which is left out.
#[test]
fn empty_roads_are_left_out_at_once() {
    let roads: String =
        (0..25_000).map(|id| format!(r#"<road id="{id}" length="1" junction="-1"/>"#)).collect();
    let compiled = soon("empty roads", &map_of(&roads));
    assert!(compiled.rows.is_none());
}

/// For each geometry all those before it were looked through, and cross-sections of each were compared with those of all others.
#[test]
fn geometries_are_not_looked_through_for_each_other() {
    const COUNT: usize = 100_000;
    let each = 1.0 / COUNT as f64;
    let shapes: String = (0..COUNT)
        .map(|i| {
            let s = i as f64 * each;
            format!(r#"<geometry s="{s:?}" x="{s:?}" y="0" hdg="0" length="{each:?}"><line/></geometry>"#)
        })
        .collect();
    let whole = r#"<geometry s="0" x="0.0" y="0" hdg="0" length="1"><line/></geometry>"#;
    let text = map_of(&metre("1", 0.0).replace(whole, &shapes));
    assert!(text.len() > 80 * COUNT);
    check("geometries in a metre", &text, ("mapd:compile.too_large", "OpenDRIVE/road[@id=1]"));
    // As many as a lane can have are built.
    let few: String = shapes.split_inclusive("</geometry>").step_by(4).collect();
    let few =
        few.replace(&format!(r#"length="{each:?}""#), &format!(r#"length="{:?}""#, 4.0 * each));
    let rows = rows(soon("fewer geometries in a metre", &text.replace(&shapes, &few)));
    assert_eq!(rows.geometries.len(), COUNT / 4);
}

/// Roads that lead to one junction lie over one another, and it is no fault: their pairs were looked at all the same.
#[test]
fn roads_of_one_junction_are_not_all_compared() {
    const EACH: usize = 3000;
    let mut text = String::new();
    for id in 0..EACH {
        let link = r#"<link><successor elementType="junction" elementId="9"/></link><planView>"#;
        text += &metre(&format!("in{id}"), -1.0).replace("<planView>", link);
        let link = format!(
            r#"<link><predecessor elementType="road" elementId="in{id}" contactPoint="end"/></link><planView>"#
        );
        let road = metre(&id.to_string(), 0.0).replace("<planView>", &link);
        text += &road.replace(r#"junction="-1""#, r#"junction="9""#);
    }
    text += r#"<junction id="9" name="">"#;
    for id in 0..EACH {
        let _ = write!(
            text,
            r#"<connection id="{id}" incomingRoad="in{id}" connectingRoad="{id}" contactPoint="start"><laneLink from="-1" to="-1"/></connection>"#
        );
    }
    let compiled = soon("connections of a junction", &map_of(&(text + "</junction>")));
    assert_eq!(count(&compiled, OVERLAPS), 1);
    assert_eq!(rows(compiled).connections.len(), EACH);
}

/// From each signal all that it depends on through others was searched anew.
#[test]
fn dependencies_of_signals_are_followed_once() {
    const COUNT: usize = 20_000;
    let signals = |last: &str| {
        let mut text = String::from("<signals>");
        for id in 0..COUNT {
            let next = if id + 1 < COUNT { (id + 1).to_string() } else { last.to_owned() };
            let _ = write!(
                text,
                r#"<signal id="{id}" s="0.5" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE"><dependency id="{next}"/></signal>"#
            );
        }
        let road = metre("1", 0.0).replace("</road>", &(text + "</signals></road>"));
        soon("a chain of dependencies", &map_of(&road))
    };
    const CYCLE: &str = "mapd:xodr:1.4.0:topology.dependency_cycle";
    for (last, cycles) in [("nowhere", 0), ("0", 1), ("19998", 1)] {
        let compiled = signals(last);
        assert_eq!(count(&compiled, CYCLE), cycles, "the last depends on {last}");
        assert_eq!(rows(compiled).signals.len(), COUNT, "none is lost");
    }
}

/// A road whose sections but for the first say what lies to the left alone, so that its lanes to the right go on past them.
fn going_on(lanes: usize, sections: usize) -> String {
    let lane = |id: i32| {
        format!(
            r#"<lane id="{id}" type="driving"><width sOffset="0" a="0.1" b="0" c="0" d="0"/></lane>"#
        )
    };
    let (left, center) =
        (format!("<left>{}</left>", lane(1)), r#"<center><lane id="0" type="none"/></center>"#);
    let right: String = (1..=lanes as i32).map(|id| lane(-id)).collect();
    let mut text =
        format!(r#"<laneSection s="0">{left}{center}<right>{right}</right></laneSection>"#);
    for at in 1..=sections {
        let s = at as f64 / (sections + 1) as f64;
        let _ = write!(
            text,
            r#"<laneSection s="{s:?}" singleSide="true">{left}{center}</laneSection>"#
        );
    }
    text
}

/// Each lane that went on past a section for the other side became a row there, so that rows grew with the square of the text.
#[test]
fn lanes_that_go_on_past_sections_for_the_other_side_are_limited() {
    const LIMIT: usize = 64;
    const SECTIONS: usize = 300;
    let whole = metre("1", 0.0);
    let start = whole.find("<laneSection").expect("a section");
    let end = whole.find("</lanes>").expect("an end");
    let road = |lanes| {
        let sections = going_on(lanes, SECTIONS);
        map_of(&format!("{}{sections}{}", &whole[..start], &whole[end..]))
    };
    let rows = rows(soon("lanes that go on", &road(LIMIT)));
    assert_eq!(rows.lanes.len(), (SECTIONS + 1) * (LIMIT + 2));
    let what = ("mapd:compile.too_large", "OpenDRIVE/road[@id=1]/lanes/laneSection");
    check("more lanes that go on", &road(2 * LIMIT), what);
}
