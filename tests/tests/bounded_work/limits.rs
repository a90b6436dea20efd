//! What a map is too large for is a finding with its place: the road or the repetition is left out before the work begins.

use super::*;
use mapd_archive::LaneMethod;
use mapd_tests::piles::PILES;
use std::collections::BTreeSet;

const TOO_LARGE: &str = "mapd:compile.too_large";

/// A map of the road [`metre`], longer, and with other content in places that it has.
fn longer(length: usize, changes: &[(&str, &str)]) -> String {
    let mut road = metre("1", 0.0).replace(r#"length="1""#, &format!(r#"length="{length}""#));
    for (from, to) in changes {
        assert!(road.contains(from), "{from}");
        road = road.replace(from, to);
    }
    map_of(&road)
}

fn each(count: usize, one: impl Fn(usize) -> String) -> String {
    (0..count).map(one).collect()
}

/// Lanes to the right, instead of the one.
fn lanes(count: usize) -> String {
    let width = r#"<width sOffset="0" a="0.1" b="0" c="0" d="0"/>"#;
    let lanes = each(count, |i| format!(r#"<lane id="-{}" type="driving">{width}</lane>"#, i + 1));
    format!("<right>{lanes}</right>")
}

const RIGHT: &str = r#"<right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#;

/// Each is a piece of the lane: their number ended the program as if the machine had failed, without a word about the road.
#[test]
fn pieces_of_a_lane_beyond_its_table_are_a_finding() {
    let records = |count: usize| {
        let rows = each(count, |i| {
            let class = ["bus", "taxi"][i % 2];
            format!(r#"<access sOffset="{i}" rule="allow" restriction="{class}"/>"#)
        });
        longer(count, &[("</lane></right>", &format!("{rows}</lane></right>"))])
    };
    check("access records", &records(70_000), (TOO_LARGE, "OpenDRIVE/road[@id=1]"));
    let few = rows(soon("fewer access records", &records(20_000)));
    assert_eq!(few.lane_nodes.len(), 20_000);
}

/// A lane's row counts the sections in 16 bits; beyond, its key would have named another section.
#[test]
fn lanes_go_on_past_so_many_sections() {
    const MOST: usize = 1 << 16;
    let left =
        r#"<left><lane id="1" type="none"/></left><center><lane id="0" type="none"/></center>"#;
    let sections = each(MOST, |i| {
        let s = 1 + i;
        format!(r#"<laneSection s="{s}" singleSide="true">{left}</laneSection>"#)
    });
    let text = longer(MOST + 2, &[("</lanes>", &format!("{sections}</lanes>"))]);
    let mut reading = ReadOptions::default();
    // What is read of a road is limited to less by default.
    reading.limits.item_bytes = 1 << 28;
    let open = || Ok(text.as_bytes());
    let compiled = compile_from(open, &reading, &CompileOptions::default(), &mut |_| {});
    let compiled = compiled.expect("reading works");
    assert_eq!(count(&compiled, TOO_LARGE), 1, "{:?}", compiled.diagnostics);
}

#[test]
fn lanes_of_a_section_are_limited() {
    const MOST: usize = 1024;
    let whole = rows(soon("lanes", &longer(1, &[(RIGHT, &lanes(MOST))])));
    assert_eq!(whole.lanes.len(), MOST + 1);
    let what = (TOO_LARGE, "OpenDRIVE/road[@id=1]/lanes/laneSection");
    check("more lanes", &longer(1, &[(RIGHT, &lanes(MOST + 1))]), what);
}

/// What is at each record for each lane: the product of two numbers that are written one beside the other.
#[test]
fn records_along_a_road_times_its_lanes_are_limited() {
    let what = (TOO_LARGE, "OpenDRIVE/road[@id=1]/lanes");
    let speeds = |count: usize, of: usize| {
        let types = each(count, |i| {
            let max = 10 + i % 2;
            format!(r#"<type s="{i}" type="town"><speed max="{max}"/></type>"#)
        });
        let plan = format!("{types}<planView>");
        longer(count, &[("<planView>", &plan), (RIGHT, &lanes(of))])
    };
    check("speeds and lanes", &speeds(200, 200), what);
    // As many of one as anybody likes, beside a few of the other.
    rows(soon("speeds", &speeds(2000, 20)));
    rows(soon("lanes with speeds", &speeds(20, 500)));
    let offsets = |count: usize, of: usize| {
        let rows =
            each(count, |i| format!(r#"<laneOffset s="{i}" a="{}" b="0" c="0" d="0"/>"#, i % 2));
        longer(count, &[("<lanes>", &format!("<lanes>{rows}")), (RIGHT, &lanes(of))])
    };
    check("offsets and lanes", &offsets(500, 500), what);
    rows(soon("offsets", &offsets(2000, 8)));
}

/// All corners of each copy were compared with lanes.
#[test]
fn copies_times_corners_are_limited() {
    const REPEAT: &str = "mapd:compile.object_repeat";
    let text = |copies: usize, corners: usize| {
        let distance = 100.0 / copies as f64;
        let corners = each(corners, |i| {
            format!(r#"<cornerLocal u="{}" v="{}" z="0" height="1"/>"#, i % 7, i % 5)
        });
        document(
            &PLAIN,
            &format!(
                r#"<object id="7" type="building" s="0" t="9" zOffset="0" height="1"><repeat s="0" length="100" distance="{distance}" tStart="9" tEnd="9" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/><outlines><outline id="0">{corners}</outline></outlines></object>"#
            ),
        )
    };
    let compiled = soon("copies and corners", &text(400, 400));
    assert_eq!(count(&compiled, REPEAT), 1);
    assert_eq!(rows(compiled).object_copies.len(), 0);
    let compiled = soon("fewer copies and corners", &text(100, 100));
    assert_eq!(count(&compiled, REPEAT), 0);
    assert!(rows(compiled).object_copies.len() >= 100);
}

/// Where there are many, lengths and times of pieces are added up for all lanes of a section at once, and elsewhere one by one: it is the same.
#[test]
fn pieces_of_many_lanes_are_measured_as_one_by_one() {
    let speeds =
        each(40, |i| format!(r#"<type s="{i}" type="town"><speed max="{}"/></type>"#, 5 + i % 7));
    let side = |name: &str, sign: i32| {
        let mut numbers: Vec<i32> = (1..=20).map(|number| sign * number).collect();
        numbers.sort_by_key(|number| -number);
        let lane = |number: &i32| {
            let share = f64::from(number.abs()) * 0.37;
            let own = if number % 3 == 0 {
                format!(
                    r#"<speed sOffset="{}" max="{}"/><speed sOffset="33.5" max="no limit"/>"#,
                    share, 3
                )
            } else {
                String::new()
            };
            let access = if number % 5 == 0 {
                format!(r#"<access sOffset="{}" rule="allow" restriction="bus"/>"#, 10.0 + share)
            } else {
                String::new()
            };
            format!(
                r#"<lane id="{number}" type="driving"><width sOffset="0" a="0.3" b="0.01" c="0" d="0"/><width sOffset="{}" a="0.5" b="-0.03" c="0" d="0"/>{own}{access}</lane>"#,
                5.0 + share
            )
        };
        format!("<{name}>{}</{name}>", numbers.iter().map(lane).collect::<String>())
    };
    let center = r#"<center><lane id="0" type="none"/></center>"#;
    let text = longer(
        50,
        &[
            ("<line/>", r#"<arc curvature="0.02"/>"#),
            ("<planView>", &format!("{speeds}<planView>")),
            ("<lanes>", r#"<lanes><laneOffset s="0" a="0" b="0.01" c="0" d="0"/>"#),
            (center, &format!("{}{center}", side("left", 1))),
            (RIGHT, &side("right", -1)),
        ],
    );
    let snapshot = open(&text);
    let map = snapshot.map();
    let mut pieces = 0;
    for node in map.lane_nodes() {
        let (lane, SRange { low, high }) = (node.lane().expect("a lane"), node.s_range());
        let (length, time) = (lane.length_between(low, high), lane.time_between(low, high));
        let is_near = |found: f64, expected: f64| (found - expected).abs() <= 1e-6 * expected;
        assert!(is_near(node.length(), length), "{} m, not {length}", node.length());
        assert!(is_near(node.travel_time(), time), "{} s, not {time}", node.travel_time());
        pieces += 1;
    }
    assert!(pieces > 200, "{pieces}");
}

/// Validities of a signal and of an object, however many, name what they name.
#[test]
fn lanes_of_many_validities_are_those_that_they_name() {
    let validities = each(2000, |i| {
        let lane = -2 * (1 + i as i64 % 100);
        format!(r#"<validity fromLane="{lane}" toLane="{lane}"/>"#)
    });
    let signal = format!(
        r#"<signals><signal id="1" s="0.5" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE">{validities}</signal></signals>"#
    );
    let object = format!(
        r#"<objects><object id="1" type="pole" s="0.5" t="0" zOffset="0" radius="0.1" height="1" orientation="+">{validities}</object></objects>"#
    );
    let text = longer(1, &[(RIGHT, &lanes(200)), ("</road>", &format!("{object}{signal}</road>"))]);
    let rows = rows(soon("validities", &text));
    let named: Vec<i32> = (1..=100).map(|lane| -2 * lane).collect();
    let number = |lane: u32| rows.lanes.get(lane as usize).map_or(0, |lane| lane.number);
    let of_signal: Vec<i32> = rows.signal_lanes.iter().map(|row| number(row.lane)).collect();
    assert_eq!(of_signal, named);
    assert!(rows.signal_lanes.iter().all(|row| row.method == LaneMethod::Validity.code()));
    let mut of_object: Vec<i32> = rows.object_lanes.iter().map(|row| number(row.lane)).collect();
    of_object.sort_unstable_by_key(|number| -number);
    assert_eq!(of_object, named);
}

/// The kinds of file of which an optimised build counts how their costs grow (`benches/gates/piles.rs`) are maps.
#[test]
fn piles_are_documents() {
    let mut names = BTreeSet::new();
    for pile in PILES {
        assert!(names.insert(pile.name), "{} twice", pile.name);
        let compiled = soon(pile.name, &(pile.text)(6));
        let is_broken = |rule: &&str| rule.ends_with("xml") || rule.contains("schema");
        let rules: BTreeSet<&str> =
            compiled.diagnostics.iter().map(|told| told.finding.rule).collect();
        assert!(!rules.iter().any(is_broken), "{}: {rules:?}", pile.name);
    }
}
