//! A crossing of four arms: each movement knows its light, its stop line and whom it yields to, and a route meets signals in
//! their order.

use mapd_archive::encode;
use mapd_client::Snapshot;
use mapd_compiler::{CompileOptions, ReadOptions, compile_from};
use mapd_query::route::{PositionOnLane, RouteScratch, ShortestLength};
use mapd_query::rules::{LaneLine, LineAhead, LineSource, RightOfWay, SpeedOrigin, Turn};
use mapd_query::signals::SignalsAhead;
use mapd_query::vocabulary::{Class, Relation, RoadRules, VehicleClass};
use mapd_query::{Lane, Map};
use mapd_tests::crossroads::{ARMS, crossroads, left_hand_crossroads, light, signal};
use mapd_tests::graph_maps::{lane as graph_lane, section};
use std::f64::consts::FRAC_PI_2;

const CAR: VehicleClass = VehicleClass::PassengerCar;

fn open(text: &str) -> Snapshot {
    let (reading, options) = (ReadOptions::default(), CompileOptions::default());
    let compiled = compile_from(|| Ok(text.as_bytes()), &reading, &options, &mut |_| {})
        .expect("reading works");
    let findings = &compiled.diagnostics;
    let rows = compiled.rows.as_ref().unwrap_or_else(|| panic!("{findings:?}"));
    let bytes = encode(rows, &compiled.provenance).expect("encodes");
    mapd_archive::verify(&bytes).expect("the archive proves");
    Snapshot::from_bytes(bytes).expect("opens")
}

fn lane<'a>(map: Map<'a>, key: &str) -> Lane<'a> {
    let key = key.parse().expect("a key");
    map.lane_by_key(&key).unwrap_or_else(|| panic!("no lane {key}"))
}

/// The lane of a connecting road, which has one.
fn movement<'a>(map: Map<'a>, road: &str) -> Lane<'a> {
    let road = map.road_by_id(road).unwrap_or_else(|| panic!("no road {road}"));
    let section = road.section(0).expect("a section");
    section.lanes().find(|lane| lane.number() != 0).expect("a lane")
}

/// Who goes first by what the file says, else by the rules of Germany; as far as neither says, what is open.
fn by_rules(row: &RightOfWay<'_>) -> Relation {
    let rules = RoadRules::of("DE").expect("its rules");
    row.relation_by(rules).unwrap_or(row.relation())
}

/// Whom a movement yields to, and why.
fn yields(map: Map<'_>, road: &str) -> Vec<String> {
    let of = movement(map, road);
    let rows = of.right_of_way().filter(|row| by_rules(row) == Relation::Yields);
    let told = rows
        .filter_map(|row| Some(format!("{} {}", row.other()?.road().id(), row.reason().name())));
    let mut told: Vec<String> = told.collect();
    told.sort();
    told
}

/// Id of a line or crosswalk.
fn id<'a>(map: Map<'a>, line: &LaneLine) -> &'a str {
    match line.source {
        LineSource::Signal(id) => map.signal(id).expect("known").id(),
        LineSource::Object(id) => map.object(id).expect("known").id(),
    }
}

/// The relation of two movements is seen alike from both sides.
fn check_symmetry(map: Map<'_>) {
    for row in map.lanes().flat_map(|lane| lane.right_of_way().map(move |row| (lane, row))) {
        let (lane, row) = row;
        let other = row.other().expect("a lane");
        let back = other
            .right_of_way()
            .find(|back| back.other().is_some_and(|back| back.lane_id() == lane.lane_id()));
        let back = back.expect("each pair stands twice");
        let expected = match by_rules(&row) {
            Relation::Yields => Relation::Priority,
            Relation::Priority => Relation::Yields,
            same => same,
        };
        assert_eq!((by_rules(&back), back.reason()), (expected, row.reason()));
    }
}

fn lit() -> Snapshot {
    let signals = std::array::from_fn(|arm| {
        light(&format!("L{arm}"))
            + &signal(&format!("S{arm}"), 2.0, 1.75, "-", "294", "")
            + &signal(&format!("C{arm}"), 4.0, 0.0, "none", "293", "")
            + &signal(&format!("V{arm}"), 60.0, 5.0, "-", "274", "value=\"50\" unit=\"km/h\"")
    });
    let group = |id: &str, arms: [usize; 2]| {
        let controls: String =
            arms.iter().map(|arm| format!("<control signalId=\"L{arm}\" type=\"0\"/>")).collect();
        format!("<controller id=\"{id}\" name=\"group {id}\">{controls}</controller>\n")
    };
    let beside = group("A", [0, 2]) + &group("B", [1, 3]);
    let synchronised =
        "<controller id=\"A\" sequence=\"0\"/><controller id=\"B\" sequence=\"1\"/>\n";
    open(&crossroads(signals, synchronised, &beside))
}

#[test]
fn each_movement_knows_its_light_line_and_group() {
    let snapshot = lit();
    let map = snapshot.map();
    for from in 0..ARMS {
        for (step, turn) in [(1, Turn::Right), (2, Turn::Straight), (3, Turn::Left)] {
            let to = (from + step) % ARMS;
            let of = movement(map, &format!("{from}{to}"));
            assert_eq!(of.turn(), turn, "{from}{to}");
            let lights: Vec<&str> = of.movement_lights().map(|one| one.signal().id()).collect();
            assert_eq!(lights, [format!("L{from}")], "{from}{to}");
            let line = of.movement_stop_line().expect("a stop line");
            assert_eq!(line.signal().id(), format!("S{from}"));
            let light = of.movement_lights().next().expect("a light").signal();
            let states = light.light().expect("lamps and phases");
            assert_eq!((states.bulbs, states.arrows), (7, 0));
            let group = light.controllers().next().expect("a controller");
            assert_eq!(group.id(), if from % 2 == 0 { "A" } else { "B" });
            assert_eq!(group.junctions().next().map(|junction| junction.id()), Some("100"));
            let incoming = of.entries().next().expect("a lane leads in");
            let crossing = incoming.crosswalks().next().expect("a crosswalk").signal();
            assert_eq!(crossing.id(), format!("C{from}"));
            // It goes over the crosswalk of the arm that it comes from and of the one that it leads to.
            let passed: Vec<_> = of.movement_crossings().map(|line| id(map, &line)).collect();
            assert_eq!(passed, [format!("C{from}"), format!("C{to}")], "{from}{to}");
        }
    }
    let junction = map.junction_by_id("100").expect("the junction");
    let order: Vec<_> = junction.controllers().map(|c| (c.id(), c.sequence())).collect();
    assert_eq!(order, [("A", Some(0)), ("B", Some(1))]);
}

#[test]
fn each_light_knows_what_it_governs() {
    let snapshot = lit();
    let map = snapshot.map();
    for arm in 0..ARMS {
        let signal = map.signal_by_id(&format!("L{arm}")).expect("a light");
        let mut governed: Vec<&str> = signal.movements().map(|lane| lane.road().id()).collect();
        governed.sort_unstable();
        let others = (0..ARMS).filter(|to| *to != arm);
        assert_eq!(governed, others.map(|to| format!("{arm}{to}")).collect::<Vec<_>>());
    }
    let sign = map.signal_by_id("V0").expect("a sign");
    assert_eq!(sign.movements().count(), 0, "a sign governs none");
}

/// Lights of a whole junction under one controller do not switch together where their movements cross.
#[test]
fn one_controller_for_all_lights_still_lets_them_decide() {
    let signals = std::array::from_fn(|arm| light(&format!("L{arm}")));
    let controls: String = (0..ARMS).map(|arm| format!("<control signalId=\"L{arm}\"/>")).collect();
    let beside = format!("<controller id=\"A\">{controls}</controller>");
    let snapshot = open(&crossroads(signals, "", &beside));
    let map = snapshot.map();
    check_symmetry(map);
    let with = |road: &str, other: &str| {
        let own = movement(map, road);
        let mut rows = own.right_of_way();
        let row = rows.find(|row| row.other().is_some_and(|lane| lane.road().id() == other));
        by_rules(&row.expect("they meet"))
    };
    assert_eq!([with("02", "13"), with("02", "31")], [Relation::Lights; 2]);
    assert_eq!(with("03", "20"), Relation::Yields, "oncoming lights are green together");
}

/// A light whose orientation is against the lane that its validity names is for that lane.
#[test]
fn a_validity_goes_before_the_orientation() {
    let text = crossroads(Default::default(), "", "");
    let light = "<signal id=\"X\" s=\"0.5\" t=\"-4\" zOffset=\"3\" orientation=\"-\" dynamic=\"yes\" country=\"OpenDRIVE\" type=\"1000001\" subtype=\"-1\"><validity fromLane=\"-1\" toLane=\"-1\"/></signal>";
    let (before, road) = text.split_once("<road id=\"02\"").expect("a connecting road");
    let road = road.replacen("</road>", &format!("<signals>{light}</signals></road>"), 1);
    let snapshot = open(&format!("{before}<road id=\"02\"{road}"));
    let map = snapshot.map();
    let lights = |road: &str| -> Vec<String> {
        let of = movement(map, road);
        of.movement_lights().map(|one| one.signal().id().to_owned()).collect()
    };
    assert_eq!((lights("02"), lights("03")), (vec!["X".to_owned()], vec![]));
    let light = map.signal_by_id("X").expect("a light");
    let governed: Vec<&str> = light.movements().map(|lane| lane.road().id()).collect();
    assert_eq!(governed, ["02"]);
    // Traffic from arm 0 meets it half a metre behind the arm's end.
    let from = PositionOnLane { lane: lane(map, "0:0:1").lane_id(), s: 80.0 };
    let mut ahead = SignalsAhead::default();
    map.signals_ahead(from, 200.0, CAR, &mut ahead).expect("an answer");
    assert_eq!(met(map, &ahead), [("X".to_owned(), 80.5)]);
}

/// A crosswalk that is written in one connecting road lies on all that begin there, whatever its orientation.
#[test]
fn a_crosswalk_in_a_junction_is_everybodys() {
    let text = crossroads(Default::default(), "", "");
    let (before, road) = text.split_once("<road id=\"02\"").expect("a connecting road");
    for orientation in ["+", "-", "none"] {
        let zebra = format!(
            "<objects><object id=\"zebra\" type=\"crosswalk\" s=\"1\" t=\"-1.75\" zOffset=\"0\" orientation=\"{orientation}\" length=\"1\" width=\"3\" height=\"0.01\"/></objects>"
        );
        let road = road.replacen("</lanes>", &format!("</lanes>{zebra}"), 1);
        let snapshot = open(&format!("{before}<road id=\"02\"{road}"));
        let map = snapshot.map();
        let passed = |road: &str| -> Vec<&str> {
            movement(map, road).movement_crossings().map(|line| id(map, &line)).collect()
        };
        for road in ["01", "02", "03"] {
            assert_eq!(passed(road), ["zebra"], "{road} {orientation}");
        }
        assert_eq!(passed("13"), [""; 0]);
    }
}

/// Where the last metres before the junction are sections of their own, a light and its line are found all the same.
#[test]
fn short_sections_before_a_junction_hide_nothing() {
    let arm = signal("L", 12.0, 5.0, "-", "1000001", "")
        + &signal("S", 13.0, 1.75, "-", "294", "")
        + &signal("C", 15.0, 0.0, "none", "293", "")
        + &signal("far", 40.0, 5.0, "-", "1000001", "");
    let text = crossroads([arm, String::new(), String::new(), String::new()], "", "");
    // Arm 0 in sections of 3, 7 and 80 m.
    let whole = section(0.0, &graph_lane(1, ""), &graph_lane(-1, ""));
    let parts = section(0.0, &graph_lane(1, "s1"), &graph_lane(-1, "s-1"))
        + &section(3.0, &graph_lane(1, "p1 s1"), &graph_lane(-1, "p-1 s-1"))
        + &section(10.0, &graph_lane(1, "p1"), &graph_lane(-1, "p-1"));
    let snapshot = open(&text.replacen(&whole, &parts, 1));
    let map = snapshot.map();
    let of = movement(map, "02");
    let lights: Vec<&str> = of.movement_lights().map(|one| one.signal().id()).collect();
    assert_eq!(lights, ["L"], "the other is 40 m away");
    assert_eq!(of.movement_stop_line().map(|one| one.signal().id()), Some("S"));
    assert_eq!(of.movement_stop().map(|line| id(map, &line)), Some("S"));
    assert_eq!(of.movement_crossings().map(|line| id(map, &line)).collect::<Vec<_>>(), ["C"]);
    let back = movement(map, "20");
    assert_eq!(back.movement_crossings().map(|line| id(map, &line)).collect::<Vec<_>>(), ["C"]);
    let light = map.signal_by_id("L").expect("a light");
    assert_eq!(light.movements().count(), 3);
}

#[test]
fn lights_decide_between_groups_and_turns_within_one() {
    let snapshot = lit();
    let map = snapshot.map();
    check_symmetry(map);
    let straight = movement(map, "02");
    let relations: Vec<(&str, Relation)> = straight
        .right_of_way()
        .map(|row| (row.other().expect("a lane").road().id(), by_rules(&row)))
        .collect();
    assert!(relations.contains(&("13", Relation::Lights)), "{relations:?}");
    assert!(relations.contains(&("21", Relation::Priority)), "{relations:?}");
    assert!(!relations.iter().any(|(_, relation)| *relation == Relation::Yields));
    // Who turns left yields to who comes straight on and to who turns right into the same arm.
    assert_eq!(
        yields(map, "03"),
        ["20 turn across oncoming traffic", "23 turn across oncoming traffic"]
    );
}

#[test]
fn signs_decide_where_there_are_no_lights() {
    let sign = |arm: usize, kind| signal(&format!("R{arm}"), 3.0, 5.0, "-", kind, "");
    let signals = [sign(0, "306"), sign(1, "205"), sign(2, "306"), sign(3, "206")];
    let snapshot = open(&crossroads(signals, "", ""));
    let map = snapshot.map();
    check_symmetry(map);
    assert_eq!(yields(map, "02"), [""; 0]);
    let told = yields(map, "13");
    for expected in ["02 yield sign", "20 yield sign"] {
        assert!(told.contains(&expected.to_owned()), "{told:?}");
    }
    // A stop sign stands below a yield sign.
    let told = yields(map, "31");
    assert!(told.contains(&"02 stop sign".to_owned()), "{told:?}");
    assert!(told.contains(&"12 stop sign".to_owned()) || !told.iter().any(|t| t.starts_with("12")));
}

#[test]
fn junction_priority_decides_where_there_are_no_signs() {
    let priority = "<priority high=\"0\" low=\"1\"/><priority high=\"0\" low=\"3\"/>\n";
    let snapshot = open(&crossroads(Default::default(), priority, ""));
    let map = snapshot.map();
    check_symmetry(map);
    assert!(yields(map, "13").contains(&"02 junction priority".to_owned()));
    assert!(yields(map, "31").contains(&"02 junction priority".to_owned()));
    // The other arm is named nowhere: from the right.
    assert!(yields(map, "13").contains(&"20 from the right".to_owned()), "{:?}", yields(map, "13"));
}

#[test]
fn without_anything_traffic_from_the_right_goes_first() {
    let snapshot = open(&crossroads(Default::default(), "", ""));
    let map = snapshot.map();
    check_symmetry(map);
    // Arm 0 drives west: from its right, the north, comes arm 1.
    assert!(yields(map, "02").contains(&"13 from the right".to_owned()));
    assert!(!yields(map, "02").iter().any(|told| told.starts_with("31 ")));
}

#[test]
fn lines_and_crosswalks_may_be_objects() {
    let light_alone = [light("L0"), light("L1"), String::new(), String::new()];
    let text = crossroads(light_alone, "", "");
    let (before, arm) = text.split_once("<road id=\"1\"").expect("arm 1");
    let object = |id: &str, kind: &str, s: f64, length: f64| {
        format!(
            "<object id=\"{id}\" {kind} s=\"{s}\" t=\"1.75\" zOffset=\"0\" orientation=\"-\" length=\"{length}\" width=\"3\" height=\"0.01\" hdg=\"0\" pitch=\"0\" roll=\"0\"/>"
        )
    };
    let objects = object("line", "type=\"roadMark\" name=\"StopLine\"", 2.0, 0.5)
        + &object("zebra", "type=\"crosswalk\" name=\"\"", 5.0, 4.0);
    let arm = arm.replacen("</lanes>", &format!("</lanes><objects>{objects}</objects>"), 1);
    let snapshot = open(&format!("{before}<road id=\"1\"{arm}"));
    let map = snapshot.map();
    // Traffic comes in against s: it meets the line's far side at 2 + 0.25, the crosswalk's at 5 + 2.
    let stop = movement(map, "13").movement_stop().expect("a line");
    assert_eq!((id(map, &stop), stop.class), ("line", Class::StopLine));
    assert!((stop.s - 2.25).abs() < 1e-4, "{stop:?}");
    let incoming = lane(map, "1:0:1");
    let crossings: Vec<_> = incoming.crossings().collect();
    assert_eq!(crossings.iter().map(|line| id(map, line)).collect::<Vec<_>>(), ["zebra"]);
    assert!((crossings[0].s - 7.0).abs() < 1e-4, "{crossings:?}");
    // A route from arm 1 to arm 3 passes both, and nothing of the other arm.
    let place = |key: &str| PositionOnLane { lane: lane(map, key).lane_id(), s: 80.0 };
    let (mut scratch, mut steps, mut lines) = (RouteScratch::default(), Vec::new(), Vec::new());
    let (from, to) = (place("1:0:1"), place("3:0:-1"));
    let route = map.route(from, to, CAR, &ShortestLength::default(), &mut scratch, &mut steps);
    assert!(route.expect("an answer").is_some());
    map.lines_along(&steps, &mut lines).expect("an answer");
    let passed: Vec<_> = lines.iter().map(|one| (id(map, &one.line), one.distance)).collect();
    let expected = [("zebra", 80.0 - 7.0), ("line", 80.0 - 2.25)];
    assert_eq!(passed.len(), expected.len(), "{passed:?}");
    for (found, expected) in passed.iter().zip(expected) {
        assert!(found.0 == expected.0 && (found.1 - expected.1).abs() < 1e-4, "{passed:?}");
    }
    // Without a line, at the light.
    let stop = movement(map, "02").movement_stop().expect("a light");
    assert_eq!((id(map, &stop), stop.class, stop.s), ("L0", Class::TrafficLight, 1.0));
    assert_eq!(movement(map, "20").movement_stop(), None);
}

#[test]
fn with_left_hand_traffic_turns_to_the_right_yield() {
    let lights = std::array::from_fn(|arm| light(&format!("L{arm}")));
    let snapshot = open(&left_hand_crossroads(lights, "", ""));
    let map = snapshot.map();
    check_symmetry(map);
    for (to, turn) in [("01", Turn::Right), ("02", Turn::Straight), ("03", Turn::Left)] {
        let of = movement(map, to);
        assert_eq!(of.turn(), turn);
        let lights: Vec<&str> = of.movement_lights().map(|one| one.signal().id()).collect();
        assert_eq!(lights, ["L0"], "{to}");
    }
    let across = |id: &str| format!("{id} turn across oncoming traffic");
    assert_eq!(yields(map, "01"), [across("20"), across("21")]);
    assert_eq!(yields(map, "02"), [""; 0]);
    assert_eq!(yields(map, "03"), [""; 0], "a turn to the near side crosses nobody");
    // Without lights, who comes from the right goes first on this side of the road too.
    let snapshot = open(&left_hand_crossroads(Default::default(), "", ""));
    check_symmetry(snapshot.map());
    assert!(yields(snapshot.map(), "02").contains(&"13 from the right".to_owned()));
}

/// What is met, with distances rounded to a centimetre.
fn met(map: Map<'_>, ahead: &SignalsAhead) -> Vec<(String, f64)> {
    let rounded = |x: f64| (x * 100.0).round() / 100.0;
    let name =
        |one: &mapd_query::signals::SignalAhead| map.signal_of(one).expect("known").id().to_owned();
    ahead.iter().map(|one| (name(one), rounded(one.distance))).collect()
}

#[test]
fn a_route_meets_signals_in_their_order() {
    let snapshot = lit();
    let map = snapshot.map();
    let from = PositionOnLane { lane: lane(map, "0:0:1").lane_id(), s: 80.0 };
    let to = PositionOnLane { lane: lane(map, "2:0:-1").lane_id(), s: 80.0 };
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let route = map.route(from, to, CAR, &ShortestLength::default(), &mut scratch, &mut steps);
    assert!(route.expect("an answer").is_some());
    let mut ahead = SignalsAhead::default();
    map.signals_along(&steps, &mut ahead).expect("an answer");
    // In along arm 0 from s = 80: the sign at 60, crosswalk at 4, line at 2, light at 1; 20 m across; then arm 2's
    // crosswalk at 4, while its line and light are for those who come in.
    let straight = [("V0", 20.0), ("C0", 76.0), ("S0", 78.0), ("L0", 79.0), ("C2", 104.0)];
    let straight = straight.map(|(id, distance)| (id.to_owned(), distance));
    assert_eq!(met(map, &ahead), straight);

    // Of these, the lines and crosswalks.
    let mut lines = Vec::new();
    map.lines_along(&steps, &mut lines).expect("an answer");
    let rounded = |x: f64| (x * 100.0).round() / 100.0;
    let name = |one: &LineAhead| (id(map, &one.line).to_owned(), rounded(one.distance));
    assert_eq!(
        lines.iter().map(name).collect::<Vec<_>>(),
        [1, 2, 4].map(|i: usize| straight[i].clone())
    );

    // All ways: a right turn's centre line has radius 10 − 1.75, a left turn's 10 + 1.75.
    map.signals_ahead(from, 110.0, CAR, &mut ahead).expect("an answer");
    let mut all = straight.to_vec();
    let turned = |id: &str, radius: f64| {
        (id.to_owned(), ((80.0 + radius * FRAC_PI_2 + 4.0) * 100.0).round() / 100.0)
    };
    all.extend([turned("C1", 8.25), turned("C3", 11.75)]);
    all.sort_by(|a, b| a.1.total_cmp(&b.1));
    assert_eq!(met(map, &ahead), all);
    map.signals_ahead(from, 77.0, CAR, &mut ahead).expect("an answer");
    assert_eq!(met(map, &ahead), straight[..2]);
}

#[test]
fn speed_signs_hold_from_their_place_on() {
    let snapshot = lit();
    let map = snapshot.map();
    let incoming = lane(map, "0:0:1");
    assert_eq!(incoming.speed_rule_at(70.0).origin, SpeedOrigin::None);
    let rule = incoming.speed_rule_at(30.0);
    assert_eq!(rule.origin, SpeedOrigin::Signal);
    assert!((rule.max.expect("a limit") - 50.0 / 3.6).abs() < 1e-12);
    let sign = map.signal(rule.signal.expect("a sign")).expect("known");
    assert_eq!((sign.id(), sign.class()), ("V0", Class::SpeedLimit));
    assert_eq!(lane(map, "0:0:-1").speed_rule_at(30.0).origin, SpeedOrigin::None, "the other way");
    assert_eq!(
        movement(map, "02").speed_rule_at(5.0).origin,
        SpeedOrigin::Entry,
        "in a junction what came in with the vehicle goes on holding"
    );
    assert!(incoming.allows_at(5.0, CAR) && incoming.access_at(5.0).any(|class| class == CAR));
}

#[test]
fn bans_on_overtaking_hold_until_they_end() {
    // Traffic comes in from s = 90 down to 0.
    let signs = [("N", 80.0, "276"), ("T", 60.0, "277"), ("E", 40.0, "280"), ("F", 20.0, "282")];
    let signs = signs.map(|(id, s, kind)| signal(id, s, 5.0, "-", kind, ""));
    let arms = std::array::from_fn(|arm| if arm == 0 { signs.concat() } else { String::new() });
    let snapshot = open(&crossroads(arms, "", ""));
    let map = snapshot.map();
    let banned = |lane: Lane<'_>, s: f64| {
        let rule = lane.overtaking_rule_at(s);
        [rule.all, rule.trucks].map(|sign| sign.map(|sign| map.signal(sign).expect("known").id()))
    };
    let incoming = lane(map, "0:0:1");
    for (s, expected) in [
        (85.0, [None, None]),
        (70.0, [Some("N"), None]),
        (50.0, [Some("N"), Some("T")]),
        (30.0, [None, Some("T")]),
        (10.0, [None, None]),
    ] {
        assert_eq!(banned(incoming, s), expected, "at {s}");
    }
    assert_eq!(banned(lane(map, "0:0:-1"), 50.0), [None, None], "the other way");
}
