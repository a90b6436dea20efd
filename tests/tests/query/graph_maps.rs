//! Lane graphs of small maps made by hand: edges, what is wrong with links, cycles, lane changes, conflicts.

use mapd_client::{Map, Snapshot};
use mapd_compiler::{Compilation, CompileOptions, CyclePolicy, MarkReading, Verdict, compile};
use mapd_query::SRange;
use mapd_query::graph::LaneNode;
use mapd_query::route::{
    LaneSequences, PositionOnLane, RouteScratch, ShortestLength, next_lane_change,
};
use mapd_query::vocabulary::{ConflictKind, EdgeKind, VehicleClass};
use mapd_tests::ends;
use mapd_tests::graph_maps::*;
use mapd_xodr::Severity;
use std::collections::{BTreeMap, BTreeSet};

fn compiled(text: &str, cycles: CyclePolicy) -> Compilation {
    let options = CompileOptions { cycles, ..CompileOptions::default() };
    compile(text.as_bytes(), &options, &mut |_| {}).expect("reading works")
}

fn open(what: &str, text: &str) -> Snapshot {
    let compiled = compiled(text, CyclePolicy::default());
    let graph = |rule: &str| rule.starts_with("mapd:graph.");
    let wrong: Vec<_> = compiled.diagnostics.iter().filter(|d| graph(d.finding.rule)).collect();
    assert!(
        wrong.iter().all(|d| d.finding.severity < Severity::Warning) || what.contains("both"),
        "{what}: {wrong:?}"
    );
    let rows = compiled.rows.unwrap_or_else(|| panic!("{what}: {:?}", compiled.diagnostics));
    let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
    mapd_archive::verify(&archive).expect("verifies");
    Snapshot::from_bytes(archive).expect("opens")
}

fn key(node: &LaneNode<'_>) -> String {
    let sign = if node.is_forward() { '+' } else { '-' };
    format!("{}{sign}", node.lane().expect("a lane").key())
}

fn edges(map: Map<'_>) -> Vec<String> {
    let mut all: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for node in map.lane_nodes() {
        for edge in node.edges().filter(|edge| edge.kind() != EdgeKind::Within) {
            all.entry(key(&node)).or_default().insert(key(&edge.target().expect("a node")));
        }
    }
    let line = |(from, to): (String, BTreeSet<String>)| {
        format!("{from} > {}", to.into_iter().collect::<Vec<_>>().join(" "))
    };
    all.into_iter().map(line).collect()
}

#[test]
fn each_map_has_its_edges() {
    for map in all() {
        let snapshot = open(map.name, &map.text);
        assert_eq!(edges(snapshot.map()), map.edges, "{}", map.name);
    }
}

/// The links of a direct junction may all stand in the connections from one road, in some from either, or twice: that draws no finding.
#[test]
fn direct_junctions_are_sound_whichever_way_they_are_written() {
    let direct =
        all().into_iter().filter(|map| map.name.contains("oncoming") || map.name.contains("twice"));
    for map in direct {
        for finding in compiled(&map.text, CyclePolicy::default()).diagnostics {
            let finding = finding.finding;
            let is_about = finding.rule.contains("junction");
            assert!(!is_about || finding.severity < Severity::Warning, "{}: {finding:?}", map.name);
        }
    }
}

#[test]
fn a_virtual_junction_cuts_nodes_but_no_lane() {
    let map = all().into_iter().find(|map| map.name.starts_with("virtual")).expect("a map");
    let snapshot = open(map.name, &map.text);
    let map = snapshot.map();
    let main = map.lane_by_key(&"1:0:-1".parse().expect("a key")).expect("a lane");
    let ranges: Vec<_> = main.nodes().map(|node| ends(node.s_range())).collect();
    assert_eq!(ranges, [(0.0, 45.0), (45.0, 75.0), (75.0, 120.0)]);
    assert_eq!(map.road_by_id("1").expect("a road").sections().count(), 1);
    // Past the side road, into it, and out of it again.
    let place = |key: &str, s| PositionOnLane {
        lane: map.lane_by_key(&key.parse().expect("a key")).expect("a lane").lane_id(),
        s,
    };
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    for (from, to, lanes, length) in [
        (("1:0:-1", 10.0), ("1:0:-1", 110.0), "1:0:-1", 100.0),
        (
            ("1:0:-1", 10.0),
            ("2:0:-1", 20.0),
            "1:0:-1 5:0:-1 2:0:-1",
            35.0 + 13.25 * std::f64::consts::FRAC_PI_2 + 20.0,
        ),
        (
            ("2:0:1", 20.0),
            ("1:0:-1", 80.0),
            "2:0:1 6:0:-1 1:0:-1",
            20.0 + 13.25 * std::f64::consts::FRAC_PI_2 + 5.0,
        ),
    ] {
        let route = map
            .route(
                place(from.0, from.1),
                place(to.0, to.1),
                VehicleClass::PassengerCar,
                &ShortestLength::default(),
                &mut scratch,
                &mut steps,
            )
            .expect("an answer")
            .unwrap_or_else(|| panic!("no way from {from:?} to {to:?}"));
        let found: Vec<_> = steps
            .iter()
            .map(|step| map.lane(step.lane).expect("known").key().to_string())
            .collect();
        assert_eq!(found.join(" "), lanes);
        assert!((route.length - length).abs() < 1e-4, "{} is not {length}", route.length);
    }
}

#[test]
fn virtual_connections_cut_nodes_where_they_attach() {
    let snapshot = named("virtual connections of a side road");
    let map = snapshot.map();
    let ranges = |key: &str| {
        let lane = map.lane_by_key(&key.parse().expect("a key")).expect("a lane");
        lane.nodes().map(|node| ends(node.s_range())).collect::<Vec<_>>()
    };
    assert_eq!(ranges("1:0:-1"), [(0.0, 60.0), (60.0, 120.0)]);
    assert_eq!(ranges("2:0:-1"), [(0.0, 50.0)]);
    let kinds: BTreeSet<_> =
        map.lane_nodes().flat_map(|node| node.edges()).map(|edge| edge.kind().name()).collect();
    assert_eq!(kinds, [EdgeKind::Within.name(), EdgeKind::Virtual.name()].into());
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    for (from, to, length) in [
        (("1:0:-1", 10.0), ("2:0:-1", 20.0), Some(70.0)),
        (("2:0:1", 20.0), ("1:0:-1", 90.0), Some(50.0)),
        (("1:0:1", 90.0), ("2:0:-1", 20.0), None),
    ] {
        let [from, to] = [from, to].map(|(key, s)| place(map, key, s));
        let car = VehicleClass::PassengerCar;
        let cost = ShortestLength::default();
        let route = map.route(from, to, car, &cost, &mut scratch, &mut steps).expect("an answer");
        assert_eq!(route.map(|route| route.length), length);
    }
}

#[test]
fn paths_across_roads_are_for_those_who_walk_or_cycle() {
    // Who walks goes either way; who cycles keeps to the traffic rule, so only the way from the start is there.
    let cases = [
        ("walking", VehicleClass::Pedestrian, Some(20.0 + 9.0 + 14.0), Some(14.0 + 9.0 + 20.0)),
        ("biking", VehicleClass::Bicycle, Some(20.0 + 9.0 + 14.0), None),
        ("biking", VehicleClass::Pedestrian, None, None),
        ("walking", VehicleClass::PassengerCar, None, None),
    ];
    for (kind, vehicle, over, back) in cases {
        let snapshot = open(kind, &crossing_path(kind, 2));
        let map = snapshot.map();
        let (near, far) = (place(map, "1:0:-2", 34.0), place(map, "1:0:2", 40.0));
        let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
        for (from, to, expected) in [(near, far, over), (far, near, back)] {
            let cost = ShortestLength::default();
            let route = map.route(from, to, vehicle, &cost, &mut scratch, &mut steps);
            let length = route.expect("an answer").map(|route| route.length);
            assert_eq!(length.map(|l| (l * 1e3).round() / 1e3), expected, "{kind} {vehicle:?}");
        }
        // Lanes for driving know where the path crosses them.
        let main = map.lane_by_key(&"1:0:-1".parse().expect("a key")).expect("a lane");
        let crossed: Vec<_> = main
            .conflicts()
            .map(|c| {
                (c.kind(), c.other().expect("a lane").key().to_string(), ends(c.other_range()))
            })
            .collect();
        assert_eq!(crossed, [(ConflictKind::Cross, "2:0:-1".to_owned(), (1.0, 4.5))], "{kind}");
    }
}

#[test]
fn lanes_of_a_direct_junction_overlap_until_they_part() {
    // The outer lane's left edge leaves the straight lane's right one where the arc has fallen by a lane's width.
    let parted = (1000.0f64 * 1000.0 - 996.5 * 996.5).sqrt();
    for (zone, end) in
        [("", parted), (" overlapZone=\"150\"", parted), (" overlapZone=\"30\"", 30.0)]
    {
        let snapshot = open("exit", &slow_exit(zone));
        let map = snapshot.map();
        let lane = map.lane_by_key(&"2:0:-1".parse().expect("a key")).expect("a lane");
        let found: Vec<_> = lane.conflicts().collect();
        let [conflict] = found.as_slice() else { panic!("{zone}: {}", found.len()) };
        assert_eq!(conflict.kind(), ConflictKind::Overlap);
        assert_eq!(conflict.other().expect("a lane").key().to_string(), "3:0:-1");
        let SRange { low: from, high: to } = conflict.s_range();
        assert!(from == 0.0 && (to - end).abs() < 1.5, "{zone}: {from} to {to}, not {end}");
    }
}

/// A broken map, the rule that must find it, how bad it is, and the tag where it stands.
type Broken = (&'static str, String, &'static str, Severity, &'static str);

/// A road of centimetres with both ends at one junction, whose connecting road is as short.
fn short_loop() -> String {
    let line = |x: f64| Line(x, 0.0, 0.0, 0.04, 0.0);
    let own = link("p junction 9") + &link("s junction 9");
    let back = link("p road 1 end") + &link("s road 1 start");
    let inside = "junction=\"9\"";
    let attributes = "id=\"0\" incomingRoad=\"1\" connectingRoad=\"5\" contactPoint=\"start\"";
    let roads = road("1", "junction=\"-1\"", line(0.0), &own, &section(0.0, "", &lane(-1, "")))
        + &road("5", inside, line(0.04), &back, &section(0.0, "", &lane(-1, "p-1 s-1")));
    document(&(roads + &junction("9", "", &connection(attributes, "-1>-1"))))
}

fn broken() -> Vec<Broken> {
    let plain = "junction=\"-1\"";
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let two = |first: &str, second: &str| {
        document(&road(
            "1",
            plain,
            line,
            "",
            &(section(0.0, &lane(1, ""), &lane(-1, first))
                + &section(50.0, &lane(1, second), &lane(-1, ""))),
        ))
    };
    let inside = "junction=\"7\"";
    let around = [
        road(
            "5",
            inside,
            line,
            &(link("p road 6 end") + &link("s road 6 start")),
            &section(0.0, "", &lane(-1, "p-1 s-1")),
        ),
        road(
            "6",
            inside,
            Line(100.0, 0.0, 0.0, 100.0, 0.0),
            &(link("p road 5 end") + &link("s road 5 start")),
            &section(0.0, "", &lane(-1, "p-1 s-1")),
        ),
    ];
    let apart = [
        road("1", plain, line, &link("s road 2 start"), &section(0.0, "", &lane(-1, "s-1"))),
        road("2", plain, Line(100.0, 5.0, 0.0, 50.0, 0.0), "", &section(0.0, "", &lane(-1, ""))),
    ];
    vec![
        (
            "a link to a lane that is not there",
            two("s-5", ""),
            "mapd:graph.missing_lane",
            Severity::Warning,
            "<successor id=\"-5\"",
        ),
        (
            "a link into oncoming traffic",
            two("s1", ""),
            "mapd:graph.direction",
            Severity::Warning,
            "<successor id=\"1\"",
        ),
        (
            "a link to a road that is not there",
            document(&road(
                "1",
                plain,
                line,
                &link("s road 9 start"),
                &section(0.0, "", &lane(-1, "s-1")),
            )),
            "asam.net:xodr:1.4.0:ids.only_ref_defined_ids",
            Severity::Warning,
            "<successor elementType=\"road\" elementId=\"9\"",
        ),
        (
            "a virtual connection to a road that is not there",
            side_road("elementId=\"9\" elementS=\"0\" elementDir=\"+\""),
            "mapd:graph.no_place",
            Severity::Warning,
            "<successor elementType=\"road\" elementId=\"9\"",
        ),
        (
            "a virtual connection behind a road's end",
            side_road("elementId=\"2\" elementS=\"51\" elementDir=\"+\""),
            "mapd:graph.no_place",
            Severity::Warning,
            "<successor elementType=\"road\" elementId=\"2\" elementS=\"51\"",
        ),
        (
            "a virtual connection against the traffic",
            side_road("elementId=\"2\" elementS=\"25\" elementDir=\"-\""),
            "mapd:graph.direction",
            Severity::Warning,
            "<laneLink from=\"-1\" to=\"-1\"",
        ),
        (
            "a virtual connection out of a road's end",
            side_road("elementId=\"2\" elementS=\"0\" elementDir=\"-\""),
            "mapd:graph.no_place",
            Severity::Warning,
            "<laneLink from=\"-1\" to=\"-1\"",
        ),
        (
            "a direct junction's link between lanes that both lead in",
            exit_road(-1, &direct(&[("1", "2", "start", "-1>1"), ("1", "3", "start", "-2>-1")])),
            "mapd:graph.direction",
            Severity::Warning,
            "<laneLink from=\"-1\" to=\"1\"",
        ),
        (
            "a direct junction's link between lanes that both lead out",
            exit_road(-1, &direct(&[("1", "2", "start", "1>-1"), ("1", "3", "start", "-2>-1")])),
            "mapd:graph.direction",
            Severity::Warning,
            "<laneLink from=\"1\" to=\"-1\"",
        ),
        (
            "a direct junction's link from a lane that is not there",
            exit_road(-1, &direct(&[("1", "2", "start", "-5>-1"), ("1", "3", "start", "-2>-1")])),
            "mapd:graph.missing_lane",
            Severity::Error,
            "<laneLink from=\"-5\" to=\"-1\"",
        ),
        (
            "a path across to a lane that is not there",
            crossing_path("walking", 4),
            "mapd:graph.no_place",
            Severity::Warning,
            "<endLaneLink",
        ),
        (
            "a loop without length",
            short_loop(),
            "mapd:graph.no_progress",
            Severity::Error,
            "<laneLink from=\"-1\"",
        ),
        (
            "a cycle within a junction",
            document(&(around.concat() + &junction("7", "", ""))),
            "mapd:graph.junction_cycle",
            Severity::Error,
            "<successor id=\"-1\"",
        ),
        (
            "lanes that do not meet",
            document(&apart.concat()),
            "mapd:graph.gap",
            Severity::Warning,
            "<successor id=\"-1\"",
        ),
    ]
}

#[test]
fn what_is_wrong_with_links_is_found_with_its_place() {
    for (what, text, rule, severity, tag) in broken() {
        let compiled = compiled(&text, CyclePolicy::default());
        let found: Vec<_> =
            compiled.diagnostics.iter().filter(|d| d.finding.rule == rule).collect();
        let at = text.find(tag).expect("the tag stands there");
        let line = text[..at].matches('\n').count() as u32 + 1;
        let column = (at - text[..at].rfind('\n').map_or(0, |newline| newline + 1)) as u32 + 1;
        let first = found.first().unwrap_or_else(|| panic!("{what}: {:?}", compiled.diagnostics));
        assert_eq!((first.line, first.column), (line, column), "{what}: {first:?}");
        assert_eq!(first.finding.severity, severity, "{what}");
        let rejected = severity == Severity::Error;
        assert_eq!(
            compiled.verdict == Verdict::Rejected,
            rejected,
            "{what}: {:?}",
            compiled.diagnostics
        );
        assert_eq!(compiled.rows.is_none(), rejected, "{what}");
    }
}

#[test]
fn what_leads_nowhere_is_no_edge() {
    let (_, text, ..) =
        broken().into_iter().find(|broken| broken.2 == "mapd:graph.direction").expect("a map");
    let compiled = compiled(&text, CyclePolicy::default());
    assert!(compiled.rows.expect("accepted").successors.is_empty());
}

#[test]
fn cycles_by_policy() {
    let map = all().into_iter().find(|map| map.name == "roundabout").expect("a map");
    for (policy, verdict, severity) in [
        (CyclePolicy::Illegal, Verdict::Accepted, None),
        (CyclePolicy::All, Verdict::Rejected, Some(Severity::Error)),
        (CyclePolicy::Report, Verdict::Accepted, Some(Severity::Info)),
    ] {
        let compiled = compiled(&map.text, policy);
        assert_eq!(compiled.verdict, verdict, "{policy:?}");
        let found: Vec<_> =
            compiled.diagnostics.iter().filter(|d| d.finding.rule == "mapd:graph.cycle").collect();
        assert_eq!(found.first().map(|d| d.finding.severity), severity, "{policy:?}");
        for finding in found {
            // The whole path with the place of each link, back to where it began.
            let message = &finding.finding.message;
            for key in
                ["1:0:-1 (link at ", "2:0:-1 (link at ", "3:0:-1 (link at ", "4:0:-1 (link at "]
            {
                assert!(message.contains(key), "{message}");
            }
            assert!(message.ends_with("→ 1:0:-1"), "{message}");
        }
    }
    // A lawful loop is one component, closed by one edge.
    let snapshot = open(map.name, &map.text);
    let components: BTreeSet<_> =
        snapshot.map().lane_nodes().map(|node| node.component()).collect();
    assert_eq!(components.len(), 1);
    let closing = snapshot.map().lane_nodes().flat_map(|n| n.edges()).filter(|e| e.closes_loop());
    assert_eq!(closing.count(), 1);
    // Forbidden cycles are warnings where cycles are only reported.
    let compiled = compiled(&short_loop(), CyclePolicy::Report);
    let found = compiled.diagnostics.iter().find(|d| d.finding.rule == "mapd:graph.no_progress");
    assert_eq!(found.map(|d| d.finding.severity), Some(Severity::Warning));
    assert!(compiled.rows.is_some());
}

/// A road of 100 m with two lanes each way and these marks on lane −1 and lane 0.
fn marked(own: &str, center: &str, rule: &str) -> String {
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    let right = wide(-1, "", "", width, own) + &lane(-2, "");
    let left = lane(2, "") + &lane(1, "");
    let sections = section(0.0, &left, &right).replace(
        "<lane id=\"0\" type=\"none\"/>",
        &format!("<lane id=\"0\" type=\"none\">{center}</lane>"),
    );
    let attributes = format!("junction=\"-1\"{rule}");
    document(&road("1", &attributes, Line(0.0, 0.0, 0.0, 100.0, 0.0), "", &sections))
}

fn mark(s: f64, change: &str) -> String {
    format!("<roadMark sOffset=\"{s}\" type=\"broken\" color=\"white\" laneChange=\"{change}\"/>")
}

#[test]
fn lane_changes_follow_the_marks() {
    let none = mark(0.0, "none");
    let part = none.clone() + &mark(30.0, "both") + &mark(70.0, "none");
    let lht = " rule=\"LHT\"";
    // Marks on lane −1, traffic rule, lane, direction of the change, where it is allowed.
    type Case<'a> = (&'a str, &'a str, &'a str, bool, &'a [(f64, f64)]);
    let cases: [Case<'_>; 12] = [
        ("", "", "1:0:-1", false, &[(0.0, 100.0)]),
        ("", "", "1:0:-1", true, &[]),
        (&none, "", "1:0:-1", false, &[]),
        (&part, "", "1:0:-1", false, &[(30.0, 70.0)]),
        (&part, "", "1:0:-2", true, &[(30.0, 70.0)]),
        // Numbers increase from −2 to −1: to the left, in driving direction, with right-hand traffic.
        (&mark(0.0, "increase"), "", "1:0:-2", true, &[(0.0, 100.0)]),
        (&mark(0.0, "increase"), "", "1:0:-1", false, &[]),
        (&mark(0.0, "decrease"), "", "1:0:-1", false, &[(0.0, 100.0)]),
        (&mark(0.0, "decrease"), "", "1:0:-2", true, &[]),
        // With left-hand traffic the right lanes travel towards −s: lane −2 is then on the left.
        (&mark(0.0, "decrease"), lht, "1:0:-1", true, &[(0.0, 100.0)]),
        (&mark(0.0, "decrease"), lht, "1:0:-2", false, &[]),
        (&none, "", "1:0:2", true, &[(0.0, 100.0)]),
    ];
    for (own, rule, lane, left, expected) in cases {
        let snapshot = open(lane, &marked(own, &none, rule));
        let map = snapshot.map();
        let lane_of = map.lane_by_key(&lane.parse().expect("a key")).expect("a lane");
        let allowed = |node: &LaneNode<'_>| {
            let to = if left { node.change_left() } else { node.change_right() };
            to.is_some()
        };
        let found: Vec<_> =
            lane_of.nodes().filter(allowed).map(|node| ends(node.s_range())).collect();
        assert_eq!(found, expected, "{lane} {} {own} {rule}", if left { "left" } else { "right" });
    }
}

/// Marks that do not say whether lanes may be changed allow it, unless they are to be read by their type: from −1 to −2, from −2 to −1.
#[test]
fn marks_are_read_by_their_type_if_so_wanted() {
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    for (kind, outwards, inwards) in [
        ("solid", false, false),
        ("solid solid", false, false),
        ("curb", false, false),
        ("edge", false, false),
        ("broken", true, true),
        ("broken broken", true, true),
        ("botts dots", true, true),
        ("none", true, true),
        ("custom", true, true),
        // Named from lane 0 outwards.
        ("solid broken", false, true),
        ("broken solid", true, false),
    ] {
        let mark =
            |more: &str| format!("<roadMark sOffset=\"0\" type=\"{kind}\" color=\"white\"{more}/>");
        for traffic in ["", " rule=\"LHT\""] {
            for side in [-1, 1] {
                for (reading, more, due) in [
                    (MarkReading::Standard, "", [true, true]),
                    (MarkReading::Type, "", [outwards, inwards]),
                    (MarkReading::Type, " laneChange=\"both\"", [true, true]),
                    (MarkReading::Type, " laneChange=\"none\"", [false, false]),
                ] {
                    let lanes = [wide(side, "", "", width, &mark(more)), lane(2 * side, "")];
                    let (left, right) = match side {
                        1 => (lanes[1].clone() + &lanes[0], String::new()),
                        _ => (String::new(), lanes.concat()),
                    };
                    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
                    let attributes = format!("junction=\"-1\"{traffic}");
                    let text =
                        document(&road("1", &attributes, line, "", &section(0.0, &left, &right)));
                    let options = CompileOptions { marks: reading, ..CompileOptions::default() };
                    let snapshot = mapd_tests::maps::open_text_with(&text, &options);
                    let found = [side, 2 * side].map(|id| {
                        let key = format!("1:0:{id}").parse().expect("a key");
                        let lane = snapshot.map().lane_by_key(&key).expect("a lane");
                        let node = lane.nodes().next().expect("a node");
                        node.change_left().or(node.change_right()).is_some()
                    });
                    assert_eq!(found, due, "{kind}{more} {reading:?} {side}{traffic}");
                }
            }
        }
    }
}

#[test]
fn access_closes_and_opens_lanes() {
    let access = |text: &str| format!("<access sOffset=\"0\" {text}");
    let nested = |types: &str| format!("<access sOffset=\"0\" rule=\"deny\">{types}</access>");
    let cases = [
        ("", "passengerCar bus bicycle", "pedestrian tram"),
        (&access("rule=\"deny\" restriction=\"trucks\"/>"), "passengerCar bus", "truck"),
        (
            &access("rule=\"deny\" restriction=\"autonomous traffic\"/>"),
            "passengerCar",
            "autonomousTraffic",
        ),
        (&access("rule=\"allow\" restriction=\"none\"/>"), "passengerCar truck", "pedestrian"),
        (&access("rule=\"deny\" restriction=\"truck\"/>"), "passengerCar bus", "truck pedestrian"),
        (&access("rule=\"allow\" restriction=\"bus\"/>"), "bus", "passengerCar taxi bicycle"),
        (
            &access(
                "rule=\"allow\"><restriction type=\"taxi\"/><restriction type=\"bicycle\"/></access>",
            ),
            "taxi bicycle",
            "bus passengerCar",
        ),
        (&access("rule=\"deny\" restriction=\"none\"/>"), "passengerCar truck", "pedestrian"),
        (&access("restriction=\"truck\"/>"), "passengerCar", "truck"),
        (&access("rule=\"deny\" restriction=\"lorry\"/>"), "passengerCar bus", "truck"),
    ];
    // Who is meant is not said: nothing stays open that might be closed, with a warning.
    let unsaid: [(&str, &str, &str); 9] = [
        (&access("rule=\"deny\" restriction=\"van\"/>"), "bicycle", "passengerCar truck bus"),
        (&access("rule=\"deny\" restriction=\"\"/>"), "bicycle", "passengerCar truck bus"),
        (&access("rule=\"deny\"/>"), "bicycle", "passengerCar truck bus"),
        (&access("restriction=\"van\"/>"), "bicycle", "passengerCar truck bus"),
        (&nested("<restriction/>"), "bicycle", "passengerCar truck bus"),
        (
            &nested("<restriction type=\"bicycle\"/><restriction type=\"van\"/>"),
            "",
            "bicycle passengerCar truck",
        ),
        (&access("rule=\"allow\" restriction=\"van\"/>"), "", "bicycle passengerCar truck"),
        (&access("rule=\"allow\"/>"), "", "bicycle passengerCar truck"),
        (
            &(access("rule=\"allow\" restriction=\"van\"/>")
                + &access("rule=\"allow\" restriction=\"bus\"/>")),
            "bus",
            "bicycle passengerCar truck",
        ),
    ];
    let cases = cases.into_iter().map(|case| (case, 0)).chain(unsaid.map(|case| (case, 1)));
    for ((text, open_to, closed_to), warnings) in cases {
        let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
        let lanes = section(0.0, "", &wide(-1, "", "", width, text));
        let road = road("1", "junction=\"-1\"", Line(0.0, 0.0, 0.0, 100.0, 0.0), "", &lanes);
        let found = compiled(&document(&road), CyclePolicy::default()).diagnostics;
        let told = found.iter().filter(|found| found.finding.rule == "mapd:compile.access");
        assert_eq!(told.count(), warnings, "{text}");
        let snapshot = open("access", &document(&road));
        let node = snapshot.map().lane_nodes().next().expect("a node");
        for (words, expected) in [(open_to, true), (closed_to, false)] {
            for word in words.split_whitespace() {
                assert_eq!(node.allows(VehicleClass::from_name(word)), expected, "{word}: {text}");
            }
        }
    }
}

#[test]
fn lanes_that_cross_know_where() {
    // Two straight connecting roads across each other, and two that lead into one lane.
    let inside = "junction=\"7\"";
    let right = section(0.0, "", &lane(-1, "s-1"));
    let roads = [
        road("1", inside, Line(-20.0, 0.0, 0.0, 40.0, 0.0), &link("s road 3 start"), &right),
        road(
            "2",
            inside,
            Line(0.0, -20.0, std::f64::consts::FRAC_PI_2, 40.0, 0.0),
            "",
            &right.replace("<successor id=\"-1\"/>", ""),
        ),
        road(
            "3",
            "junction=\"-1\"",
            Line(20.0, 0.0, 0.0, 50.0, 0.0),
            "",
            &section(0.0, "", &lane(-1, "")),
        ),
        road(
            "4",
            inside,
            Line(0.0, 20.0, -std::f64::consts::FRAC_PI_2, 20.0 * std::f64::consts::FRAC_PI_2, 0.05),
            &link("s road 3 start"),
            &right,
        ),
    ];
    let snapshot = open("crossing", &document(&(roads.concat() + &junction("7", "", ""))));
    let map = snapshot.map();
    let of = |key: &str| {
        let lane = map.lane_by_key(&key.parse().expect("a key")).expect("a lane");
        lane.conflicts()
            .map(|c| {
                (
                    c.other().expect("a lane").key().to_string(),
                    c.kind(),
                    ends(c.s_range()),
                    ends(c.other_range()),
                )
            })
            .collect::<Vec<_>>()
    };
    let near = |found: (f64, f64), expected: (f64, f64)| {
        let cell = 0.5 + 1e-3;
        (expected.0 - cell..=expected.0 + 1e-3).contains(&found.0)
            && (expected.1 - 1e-3..=expected.1 + cell).contains(&found.1)
    };
    let first = of("1:0:-1");
    let (_, kind, own, other) =
        first.iter().find(|conflict| conflict.0 == "2:0:-1").expect("they cross");
    assert_eq!(*kind, ConflictKind::Cross);
    assert!(near(*own, (20.0, 23.5)) && near(*other, (16.5, 20.0)), "{own:?} {other:?}");
    let merge = first.iter().find(|conflict| conflict.0 == "4:0:-1").expect("they merge");
    assert_eq!(merge.1, ConflictKind::Merge);
    assert_eq!(merge.2.1, 40.0, "up to the end");
    // Seen from the other side it is the same.
    let back = of("2:0:-1");
    let turned = back.iter().find(|conflict| conflict.0 == "1:0:-1").expect("they cross");
    assert_eq!((turned.2, turned.3), (*other, *own));
}

fn place(map: Map<'_>, key: &str, s: f64) -> PositionOnLane {
    let lane = map.lane_by_key(&key.parse().expect("a key")).expect("a lane");
    PositionOnLane { lane: lane.lane_id(), s }
}

fn named(name: &str) -> Snapshot {
    let map = all().into_iter().find(|map| map.name == name).expect("a map");
    open(map.name, &map.text)
}

#[test]
fn sequences_follow_every_way() {
    let snapshot = named("merge and split");
    let map = snapshot.map();
    let car = VehicleClass::PassengerCar;
    let (mut scratch, mut out) = (RouteScratch::default(), LaneSequences::default());
    let keys = |out: &mut LaneSequences| {
        let text = |lanes: &[_]| {
            let key = |lane: &_| map.lane(*lane).expect("known").key().to_string();
            lanes.iter().map(key).collect::<Vec<_>>().join(" ")
        };
        let mut all = Vec::new();
        while let Some(lanes) = out.next_sequence() {
            all.push(text(lanes));
        }
        all
    };
    map.lane_sequences_ahead(place(map, "1:0:-1", 10.0), 200.0, car, &mut scratch, &mut out)
        .expect("an answer");
    assert_eq!(keys(&mut out), ["1:0:-1 1:1:-1 1:2:-1", "1:0:-1 1:1:-1 1:2:-2"]);
    map.lane_sequences_ahead(place(map, "1:0:-1", 10.0), 60.0, car, &mut scratch, &mut out)
        .expect("an answer");
    assert_eq!(keys(&mut out), ["1:0:-1 1:1:-1"]);
    map.lane_sequences_behind(place(map, "1:2:-2", 120.0), 200.0, car, &mut scratch, &mut out)
        .expect("an answer");
    assert_eq!(keys(&mut out), ["1:2:-2 1:1:-1 1:0:-1", "1:2:-2 1:1:-1 1:0:-2"]);
    // A ring goes round until the distance is reached: 2π · 38.25 m each time towards +s on the outer lane.
    let snapshot = named("ring road that links to itself");
    let map = snapshot.map();
    map.lane_sequences_ahead(place(map, "1:0:-1", 0.0), 600.0, car, &mut scratch, &mut out)
        .expect("an answer");
    assert_eq!(out.next_sequence().map(<[_]>::len), Some(3));
    assert_eq!((out.sequence().len(), out.next_sequence()), (3, None));
    // The ring stands once, and what is left of it from the start on.
    assert_eq!(out.network().reached().len(), 2);
}

/// A cycle of centimetres, which only `--cycles report` leaves in a map, would be gone round thousands of times.
#[test]
fn sequences_do_not_go_round_a_cycle_without_progress() {
    let links = link("p road 1 end") + &link("s road 1 start");
    let line = Line(0.0, 0.0, 0.0, 0.04, 0.0);
    let own = road("1", "junction=\"-1\"", line, &links, &section(0.0, "", &lane(-1, "p-1 s-1")));
    let rows = compiled(&document(&own), CyclePolicy::Report).rows.expect("a map");
    let archive = mapd_archive::encode(&rows, &Default::default()).expect("encodes");
    let snapshot = Snapshot::from_bytes(archive).expect("opens");
    let map = snapshot.map();
    let (mut scratch, mut out) = (RouteScratch::default(), LaneSequences::default());
    let from = place(map, "1:0:-1", 0.0);
    map.lane_sequences_ahead(from, 1_000.0, VehicleClass::PassengerCar, &mut scratch, &mut out)
        .expect("an answer");
    assert_eq!(out.network().reached().len(), 2);
    assert_eq!(out.next_sequence().map(<[_]>::len), Some(2));
    assert_eq!(out.next_sequence(), None);
}

#[test]
fn junctions_and_lane_changes_ahead_are_named_with_their_distance() {
    let snapshot = named("connection without lane links");
    let map = snapshot.map();
    let car = VehicleClass::PassengerCar;
    let next = |key, s, distance| {
        map.next_junction(place(map, key, s), distance, car)
            .expect("an answer")
            .map(|next| next.distance)
    };
    assert_eq!(next("1:0:-1", 40.0, 100.0), Some(60.0));
    assert_eq!(next("1:0:-1", 40.0, 50.0), None);
    assert_eq!(next("5:0:-1", 5.0, 50.0), Some(0.0));
    assert_eq!(next("2:0:-1", 5.0, 500.0), None);
    // One change is needed, where the marks allow it.
    let marks = mark(0.0, "none") + &mark(30.0, "both") + &mark(70.0, "none");
    let snapshot = open("marks", &marked(&marks, "", ""));
    let map = snapshot.map();
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let (from, to) = (place(map, "1:0:-1", 10.0), place(map, "1:0:-2", 90.0));
    let cost = ShortestLength::default();
    let route = map.route(from, to, car, &cost, &mut scratch, &mut steps).expect("an answer");
    let route = route.expect("a way");
    assert_eq!((route.lane_changes, route.length, route.cost), (1, 80.0, 100.0));
    for (s, expected) in [(10.0, (20.0, 60.0)), (30.0, (0.0, 40.0)), (50.0, (0.0, 20.0))] {
        let change = next_lane_change(map, &steps, 0, place(map, "1:0:-1", s)).expect("an answer");
        let change = change.expect("a change");
        assert_eq!(
            (change.left, change.from, change.until),
            (false, expected.0, expected.1),
            "{s}"
        );
    }
    // Through a place on the way it costs the same; past it there is no way back.
    let via = |s| {
        let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
        let places = [from, place(map, "1:0:-2", s), to];
        let route = map.route_via(&places, car, &cost, &mut scratch, &mut steps);
        route.expect("an answer").map(|route| route.cost)
    };
    assert_eq!((via(80.0), via(95.0)), (Some(100.0), None));
}

#[test]
fn roads_that_cross_at_a_crossing_conflict() {
    let lanes = section(0.0, "", &lane(-1, ""));
    let half = std::f64::consts::FRAC_PI_2;
    let roads = road("1", "junction=\"-1\"", Line(-50.0, 0.0, 0.0, 100.0, 0.0), "", &lanes)
        + &road("2", "junction=\"-1\"", Line(0.0, -50.0, half, 100.0, 0.0), "", &lanes);
    let part = |id: usize, from: f64, to: f64| {
        format!("<roadSection id=\"{id}\" roadId=\"{id}\" sStart=\"{from}\" sEnd=\"{to}\"/>\n")
    };
    let sections = part(1, 45.0, 60.0) + &part(2, 40.0, 55.0);
    let snapshot =
        open("crossing", &document(&(roads + &junction("7", "type=\"crossing\"", &sections))));
    let map = snapshot.map();
    assert!(map.tables().successors.is_empty(), "a crossing links nothing");
    let own = map.lane_by_key(&"1:0:-1".parse().expect("a key")).expect("a lane");
    let found: Vec<_> =
        own.conflicts().map(|c| (c.kind(), ends(c.s_range()), ends(c.other_range()))).collect();
    assert_eq!(found, [(ConflictKind::Crossing, (50.0, 53.5), (46.5, 50.0))]);
}
