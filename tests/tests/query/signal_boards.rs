//! Boards of signals, and what signals, boards and objects have to do with each other.

use mapd_client::{Map, Snapshot, glam::DVec3};
use mapd_compiler::Compilation;
use mapd_query::roads::LaneRange;
use mapd_query::signals::{DisplayArea, Signal, SignalLink};
use mapd_tests::object_maps::{PLAIN, compile, document, open};

const AREAS: &str = r#"<displayArea index="1" v="2" z="1" width="1.4" height="0.7"/><displayArea v="-2" z="1" width="wide" height="0.7"/>"#;

/// A road with a gantry, a pole and these signals; behind it these elements.
fn map(signals: &str, behind: &str) -> String {
    let objects = r#"<object id="gantry" type="gantry" s="20" t="0" zOffset="5" length="0.5" width="12" height="1" orientation="none"/>
<object id="pole" type="pole" s="30" t="-5" zOffset="0" radius="0.1" height="3" orientation="none"/>"#;
    document(&PLAIN, objects)
        .replace("</objects>", &format!("</objects><signals>{signals}</signals>"))
        .replace("</OpenDRIVE>", &format!("{behind}</OpenDRIVE>"))
}

/// A signal at s = 20 in the middle of the road, 6 m up, for traffic along s.
fn carrier(id: &str, children: &str) -> String {
    format!(
        r#"<signal id="{id}" s="20" t="0" zOffset="6" orientation="+" dynamic="yes" country="OpenDRIVE" type="multiBoard" subtype="-1">{children}</signal>"#
    )
}

fn sign(id: &str, children: &str) -> String {
    format!(
        r#"<sign id="{id}" v="-1" z="0.5" orientation="+" dynamic="no" country="DE" type="274" subtype="55">{children}</sign>"#
    )
}

fn vms(children: &str) -> String {
    format!(
        r#"<vmsBoard displayType="LED" displayWidth="7" displayHeight="2.5" v="3" z="0.5">{children}</vmsBoard>"#
    )
}

const OBJECT: &str = r#"<reference elementType="object" elementId="gantry" type="carries"/>"#;

fn whole() -> Snapshot {
    let children = r#"<dependency id="other" type="limit"/>"#.to_owned()
        + OBJECT
        + "<staticBoard><validity fromLane=\"-1\" toLane=\"-1\"/>"
        + r#"<reference elementType="signal" elementId="other"/>"#
        + &sign("lower", "")
        + &sign("own", "<validity fromLane=\"-2\" toLane=\"-2\"/>")
        + "</staticBoard>"
        + &vms(&format!(
            "<validity fromLane=\"-2\" toLane=\"-1\"/><dependency id=\"lower\"/>{OBJECT}{AREAS}"
        ));
    let other = r#"<signal id="other" s="30" t="-5" zOffset="2" orientation="+" dynamic="no" country="DE" type="206" subtype="-1"><reference elementType="object" elementId="pole"/></signal>"#;
    let group = r#"<vmsGroup id="g"><vmsBoardReference signalId="board" vmsIndex="0" groupIndex="4"/><vmsBoardReference signalId="board" vmsIndex="7" groupIndex="5"/></vmsGroup>"#;
    open(&map(&(carrier("board", &children) + other), group))
}

fn signal<'a>(map: Map<'a>, id: &str) -> Signal<'a> {
    map.signal_by_id(id).unwrap_or_else(|| panic!("no signal {id}"))
}

fn check_point(found: Option<DVec3>, expected: [f64; 3]) {
    let found = found.expect("a place");
    assert!(found.distance(DVec3::from_array(expected)) < 1e-9, "{found}");
}

#[test]
fn boards_have_their_areas_in_space() {
    let snapshot = whole();
    let map = snapshot.map();
    let board = signal(map, "board").boards().next().expect("a board");
    assert_eq!((board.display_type(), board.size()), ("LED", [Some(7.0), Some(2.5)]));
    assert_eq!(board.validities().collect::<Vec<_>>(), [LaneRange { from: -2, to: -1 }]);
    // Its face looks back along x, so that its left is towards −y.
    check_point(board.position(), [20.0, -3.0, 6.5]);
    let areas: Vec<DisplayArea<'_>> = board.areas().collect();
    let told: Vec<_> = areas.iter().map(|area| (area.index(), area.size())).collect();
    assert_eq!(told, [(Some(1), [Some(1.4), Some(0.7)]), (None, [None, Some(0.7)])]);
    check_point(areas[0].position(), [20.0, -2.0, 7.0]);
    check_point(areas[1].position(), [20.0, 2.0, 7.0]);
    assert_eq!(areas[1].offset(), [-2.0, 1.0]);
    assert_eq!(areas[0].board().and_then(|b| b.carrier()).map(|s| s.id()), Some("board"));
    let members: Vec<_> = map.board_groups().collect();
    assert_eq!(members.len(), 2);
    assert_eq!((members[0].group(), members[0].rank()), ("g", Some(4)));
    assert_eq!(members[0].board().map(|b| b.display_type()), Some("LED"));
    assert!(members[1].board().is_none() && members[1].signal().is_some());
}

#[test]
fn signs_are_for_the_lanes_of_their_board() {
    let snapshot = whole();
    let lanes = |id: &str| -> Vec<i32> {
        let places = snapshot.map().signal_places();
        let own = places.filter(|place| place.signal().is_some_and(|s| s.id() == id));
        let lanes = own.flat_map(|place| place.lanes());
        lanes.filter_map(|one| Some(one.lane()?.number())).collect()
    };
    assert_eq!(lanes("lower"), [-1], "the board's");
    assert_eq!(lanes("own"), [-2], "its own");
}

/// What links name: (id, whether the map has it).
fn named<'a>(links: impl Iterator<Item = SignalLink<'a>>) -> Vec<(&'a str, bool)> {
    links.map(|link| (link.id, link.signal.is_some() || link.object.is_some())).collect()
}

#[test]
fn signals_and_objects_know_each_other() {
    let snapshot = whole();
    let map = snapshot.map();
    let board = signal(map, "board");
    assert_eq!(named(board.links()), [("gantry", true), ("other", true)]);
    assert_eq!(named(board.dependencies()), [("other", true)]);
    let link = board.links().next().expect("a link");
    let object = link.object.expect("an object");
    assert_eq!((object.id(), link.kind, link.is_object), ("gantry", "carries", true));
    let vms = board.boards().next().expect("a board");
    assert_eq!(named(vms.links()), [("gantry", true)]);
    assert_eq!(named(vms.dependencies()), [("lower", true)]);
    let signals_of = |id: &str| -> Vec<&str> {
        map.object_by_id(id).expect("an object").signals().map(|signal| signal.id()).collect()
    };
    assert_eq!(signals_of("gantry"), ["board", "board"], "itself, and by its board");
    assert_eq!(signals_of("pole"), ["other"]);
}

/// Findings about ids that are not there.
fn undefined(compiled: &Compilation) -> Vec<String> {
    let rule = "asam.net:xodr:1.4.0:ids.only_ref_defined_ids";
    let told = compiled.diagnostics.iter().filter(|told| told.finding.rule == rule);
    told.map(|told| told.finding.path.clone()).collect()
}

#[test]
fn what_leads_nowhere_is_a_finding() {
    let lost_object = r#"<reference elementType="object" elementId="nowhere"/>"#;
    let lost_signal = r#"<reference elementType="signal" elementId="nowhere"/>"#;
    let lost = r#"<dependency id="nowhere"/>"#;
    let of_sign = format!("<staticBoard>{}</staticBoard>", sign("x", lost_object));
    for (children, what) in [
        (lost_object.to_owned(), "signal/reference/@elementId"),
        (lost_signal.to_owned(), "signal/reference/@elementId"),
        // An object's id is no signal's.
        (lost_signal.replace("nowhere", "pole"), "signal/reference/@elementId"),
        (lost.to_owned(), "signal/dependency/@id"),
        (of_sign, "signal/staticBoard/sign/reference/@elementId"),
        (
            format!("<staticBoard>{lost}{}</staticBoard>", sign("x", "")),
            "signal/staticBoard/dependency/@id",
        ),
        (vms(lost), "signal/vmsBoard/dependency/@id"),
        (vms(lost_object), "signal/vmsBoard/reference/@elementId"),
    ] {
        let compiled = compile(&map(&carrier("board", &children), ""));
        let paths = undefined(&compiled);
        let [path] = &paths[..] else { panic!("{what}: {paths:?}") };
        let tail = what.trim_start_matches("signal");
        assert!(path.ends_with(tail), "{what}: {path}");
        let snapshot = open(&map(&carrier("board", &children), ""));
        let board = signal(snapshot.map(), "board");
        let vms = board.boards().next();
        let own = named(board.links()).into_iter().chain(named(board.dependencies()));
        let of_board =
            vms.iter().flat_map(|b| named(b.links()).into_iter().chain(named(b.dependencies())));
        assert!(own.chain(of_board).all(|(_, known)| !known), "{what}");
    }
    // A sign on a board is a signal that others may name.
    let boards = format!("<staticBoard>{}</staticBoard>", sign("x", ""));
    let reference = r#"<signalReference id="x" s="5" t="0" orientation="+"/>"#;
    assert_eq!(undefined(&compile(&map(&(carrier("board", &boards) + reference), ""))), [""; 0]);
}
