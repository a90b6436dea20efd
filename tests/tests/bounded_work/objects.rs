//! Objects: copies, outlines, and the lanes that they lie on.

use super::*;

/// Copies of all objects that a map may have (docs/objects.md).
const MOST_COPIES: usize = 2_000_000;

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
    for lane in 3..1000 {
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
