//! Which roads' lanes a signal is for where other roads refer to it: a validity limits lanes, also to none.

use mapd_compiler::{CompileOptions, compile};
use mapd_query::Map;
use mapd_query::vocabulary::LaneMethod;
use mapd_tests::graph_maps::{Line, document, lane, road, section};
use mapd_tests::maps::{found, open, open_text};
use mapd_tests::object_maps;
use std::collections::BTreeMap;

use LaneMethod::{Orientation, OrientationGuess, Validity};

/// A lane of a road, and how it was found.
type On<'a> = (&'a str, i32, LaneMethod);

/// Lanes that a signal is for, in the order of roads.
fn lanes_of<'a>(map: Map<'a>, id: &str) -> Vec<On<'a>> {
    let places = map.signal_places();
    let own = places.filter(|place| place.signal().is_some_and(|signal| signal.id() == id));
    let lanes = own.flat_map(|place| place.lanes());
    lanes
        .map(|one| {
            let lane = one.lane().expect("a lane");
            (lane.road().id(), lane.number(), one.method())
        })
        .collect()
}

fn validity(lane: i32) -> String {
    format!("<validity fromLane=\"{lane}\" toLane=\"{lane}\"/>")
}

/// Two roads with lanes 1 and −1: signal L with these children on road 1, and these references on road 2.
fn map(inside: &str, references: &str) -> String {
    let lanes = section(0.0, &lane(1, ""), &lane(-1, ""));
    let one = |id: &str, x: f64, signals: &str| {
        let plain = road(id, "junction=\"-1\"", Line(x, 0.0, 0.0, 50.0, 0.0), "", &lanes);
        plain.replace("</road>", &format!("<signals>{signals}</signals></road>"))
    };
    let signal = format!(
        r#"<signal id="L" s="48" t="-6" zOffset="3" orientation="-" dynamic="yes" country="OpenDRIVE" type="1000001" subtype="-1">{inside}</signal>"#
    );
    document(&(one("1", 0.0, &signal) + &one("2", 100.0, references)))
}

fn reference(inside: &str) -> String {
    format!(r#"<signalReference id="L" s="0.5" t="0" orientation="+">{inside}</signalReference>"#)
}

/// Lanes of L, and how often its lack of lanes is told.
fn check(name: &str, (inside, references): (&str, &str), expected: &[On<'_>], told: usize) {
    let text = map(inside, references);
    let snapshot = open_text(&text);
    assert_eq!(lanes_of(snapshot.map(), "L"), expected, "{name}");
    let compiled = compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {});
    let findings = compiled.expect("reading works").diagnostics;
    let found = findings.iter().filter(|d| d.finding.rule == "mapd:compile.signal_lanes");
    assert_eq!(found.count(), told, "{name}");
}

#[test]
fn a_validity_of_lane_0_names_none_of_its_own_road() {
    let (none, right) = (validity(0), validity(-1));
    let to_right = reference(&right);
    check("the reference names it", (&none, &to_right), &[("2", -1, Validity)], 0);
    check("a reference to all", (&none, &reference("")), &[("2", -1, Orientation)], 0);
    let twice = none.repeat(2);
    check("said twice", (&twice, &to_right), &[("2", -1, Validity)], 0);
    check("nobody refers to it", (&none, ""), &[("1", 1, OrientationGuess)], 0);
    let all = [("1", 1, Orientation), ("2", -1, Validity)];
    check("without a validity", ("", &to_right), &all, 0);
    let both = none.clone() + &validity(1);
    check("lane 0 and another", (&both, &to_right), &[("1", 1, Validity), ("2", -1, Validity)], 0);
    check("references to none", (&none, &reference(&none)), &[], 2);
    let two = reference(&none) + &to_right;
    check("one of two to none", (&none, &two), &[("2", -1, Validity)], 0);
}

#[test]
fn signs_on_a_board_are_for_no_lanes_that_their_carrier_is_not_for() {
    let board = r#"<staticBoard><sign id="S" v="0" z="1" orientation="-" dynamic="no" country="DE" type="206" subtype="-1"/></staticBoard>"#;
    for (references, expected) in
        [(String::new(), vec![("1", 1, OrientationGuess)]), (reference(&validity(-1)), Vec::new())]
    {
        let text = map(&(validity(0) + board), &references);
        let text = text.replace("revMinor=\"7\"", "revMinor=\"8\"");
        let snapshot = open_text(&text);
        assert_eq!(lanes_of(snapshot.map(), "S"), expected);
    }
}

#[test]
fn objects_are_never_for_a_lane_by_orientation_alone() {
    let object = |t: f64, orientation: &str| {
        format!(
            r#"<object id="o" type="pole" s="20" t="{t}" zOffset="0" orientation="{orientation}" radius="0.1">{}</object>"#,
            validity(0)
        )
    };
    let reference = r#"<objectReference id="o" s="60" t="-1.75" orientation="+"><validity fromLane="-1" toLane="-1"/></objectReference>"#;
    for (objects, expected) in [
        (object(1.75, "-"), vec![(1, LaneMethod::Track)]),
        (object(1.75, "+"), vec![(1, LaneMethod::Track)]),
        (object(-20.0, "-"), vec![(-2, LaneMethod::Nearest)]),
        (object(-20.0, "-") + reference, vec![(-1, Validity)]),
    ] {
        let snapshot = object_maps::open(&object_maps::document(&object_maps::PLAIN, &objects));
        let object = snapshot.map().object_by_id("o").expect("the object");
        let lanes = object.lanes().map(|at| (at.lane().expect("a lane").number(), at.method()));
        assert_eq!(lanes.collect::<Vec<_>>(), expected, "{objects}");
    }
}

#[test]
fn lights_that_face_a_junction_are_for_no_lane_that_leaves_it() {
    let Some(small) = found("small/z.xodr") else { return };
    let snapshot = open(&small);
    assert_eq!(lanes_of(snapshot.map(), "L"), [("10", -1, Validity)]);
    let Some(town) = found("maps/Town01.xodr") else { return };
    let snapshot = open(&town);
    let mut roads: Vec<&str> =
        lanes_of(snapshot.map(), "362").iter().map(|(road, ..)| *road).collect();
    roads.sort_unstable();
    assert_eq!(roads, ["40", "46"]);
}

/// Signals' lanes by how they were found: validity, orientation, s and t, nearest, guess.
const METHODS: [(&str, [usize; 5]); 4] = [
    ("Town01", [72, 0, 0, 0, 0]),
    ("Town04", [121, 0, 0, 0, 0]),
    ("cloverleaf", [118, 0, 6, 1, 26]),
    ("WBeaverAve", [0, 0, 14, 0, 35]),
];

#[test]
fn methods_of_the_maps_that_showed_it() {
    for (name, expected) in METHODS {
        let Some(path) = found(&format!("maps/{name}.xodr")) else { return };
        let snapshot = open(&path);
        let mut counts: BTreeMap<u8, usize> = BTreeMap::new();
        for one in snapshot.map().signal_places().flat_map(|place| place.lanes()) {
            *counts.entry(one.method().code()).or_default() += 1;
        }
        let methods = LaneMethod::ALL.iter().map(|m| counts.get(&m.code()).copied());
        let methods: Vec<usize> = methods.map(Option::unwrap_or_default).collect();
        assert_eq!(methods, expected, "{name}");
    }
}
