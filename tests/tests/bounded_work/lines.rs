//! Lines of roads and lanes: their points are bounded by limits and by the file's size.

use super::*;

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
    let swept = r#"<repeat s="0" length="100" distance="0" tStart="0" tEnd="0" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0" bT="1e3" cT="-1e3" dT="1e2"/>"#;
    check("swept", &object(swept).replace("revMinor=\"8\"", "revMinor=\"9\""), part);
    let beyond = swept.replace("1e3", "1e9");
    let left_out = ("mapd:compile.object_repeat", part.1);
    check(
        "swept beyond the map",
        &object(&beyond).replace("revMinor=\"8\"", "revMinor=\"9\""),
        left_out,
    );
    let wide = swept.replace("distance", r#"widthStart="1" widthEnd="1" distance"#);
    check("swept with a width", &object(&wide).replace("revMinor=\"8\"", "revMinor=\"9\""), part);
}

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

/// Times along lanes looked at all records of speed for each of them: 20,000 took seconds, and ten times as many minutes.
#[test]
fn records_of_speed_are_looked_at_once() {
    const RECORDS: usize = 100_000;
    let s = |i: usize| i as f64 / RECORDS as f64;
    let speeds: String = (0..RECORDS)
        .map(|i| format!(r#"<speed sOffset="{}" max="{}"/>"#, s(i), 10 + i % 7))
        .collect();
    let types: String = (0..RECORDS)
        .map(|i| format!(r#"<type s="{}" type="town"><speed max="{}"/></type>"#, s(i), 10 + i % 7))
        .collect();
    let of_lane =
        map_of(&metre("1", 0.0).replace("</lane></right>", &format!("{speeds}</lane></right>")));
    let of_road = map_of(&metre("1", 0.0).replace("<planView>", &format!("{types}<planView>")));
    for (what, text) in [("speeds of a lane", of_lane), ("types of a road", of_road)] {
        let rows = rows(soon(what, &text));
        let times: Vec<f32> = rows.lane_nodes.iter().map(|node| node.time).collect();
        // Each of 10 to 16 m/s holds for a seventh of the metre.
        let expected: f32 = (10..17).map(|speed| 1.0 / 7.0 / speed as f32).sum();
        assert!(
            times.iter().any(|time| (time - expected).abs() < 1e-5),
            "{what}: {times:?}, not {expected}"
        );
    }
}
