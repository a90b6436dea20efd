//! Who goes first: what is written, else what the country says that the caller names; nothing is taken from geometry alone.

use crate::path_meets::lane_by;
use mapd_client::route::{PositionOnLane, RouteScratch, ShortestLength};
use mapd_client::vocabulary::{Relation, RelationReason, RoadRules, VehicleClass};
use mapd_client::{Lane, Map, RoadId};
use mapd_query::path::{PathBuffer, PathOptions, Yields};
use mapd_query::rules::{Basis, RightOfWay, Turn};
use mapd_tests::graph_maps::{Line, connection, document, junction, lane, link, road, section};
use mapd_tests::maps::{carried_and, found, open, open_text};
use std::f64::consts::FRAC_PI_2;

/// Towns with junctions, left-hand traffic, priorities, lights.
const MAPS: [&str; 6] = [
    "carla/Town03",
    "carla/Town05",
    "sumo/lefthand_netconvert",
    "Scenic/Town10HD",
    "Scenic/Town07",
    "SMARTS/od_newmarket_map",
];

/// Where a way through a junction comes from or leads to: road, direction, and how many lanes are open that way.
fn arm(lane: &Lane<'_>) -> (RoadId, bool, usize) {
    let forward = lane.is_forward();
    let open = |own: &Lane<'_>| own.nodes().any(|n| n.is_forward() == forward && n.is_open());
    (lane.road().road_id(), forward, lane.section().lanes().filter(open).count())
}

/// Whether a lane goes straight on along a road of several lanes that another lane joins from one of fewer.
fn is_joined(map: Map<'_>, own: &Lane<'_>, other: &Lane<'_>) -> bool {
    let entry = |lane: &Lane<'_>| lane.entries().next().map(|lane| arm(&lane));
    let exit = |lane: &Lane<'_>| {
        let last = lane.movement_lanes().last()?;
        last.successors().next().map(|id| arm(&map.lane(id).expect("a lane")))
    };
    let (Some(from), Some(ramp), Some(to)) = (entry(own), entry(other), exit(own)) else {
        return false;
    };
    let same = exit(other).is_some_and(|theirs| (theirs.0, theirs.1) == (to.0, to.1));
    own.turn() == Turn::Straight && same && from.2 == to.2 && ramp.2 < from.2
}

/// Checks every conflict of a map; how many there are with an answer that only a country's rules give, and how many at which a road is joined.
fn check(map: Map<'_>, name: &str) -> [usize; 2] {
    let [mut by_rule, mut joined] = [0; 2];
    for own in map.lanes() {
        for (conflict, one) in own.conflicts().filter_map(|conflict| {
            let same = |way: &RightOfWay<'_>| {
                way.other().map(|lane| lane.lane_id()) == conflict.other().map(|l| l.lane_id())
            };
            Some((conflict, own.right_of_way().find(same)?))
        }) {
            let other = one.other().expect("a lane");
            let at = format!("{name}: {} and {}", own.key(), other.key());
            let written = !matches!(
                one.reason(),
                RelationReason::None | RelationReason::Turn | RelationReason::FromTheRight
            );
            let decided =
                matches!(one.relation(), Relation::Yields | Relation::Priority | Relation::Lights);
            assert_eq!(decided, written, "{at}");
            assert_eq!(one.basis(), if written { Basis::Written } else { Basis::Unknown }, "{at}");
            assert_eq!((conflict.relation(), conflict.basis()), (one.relation(), one.basis()));
            assert_eq!(conflict.reason(), one.reason());
            for rules in RoadRules::ALL {
                let (relation, basis) = (one.relation_by(rules), one.basis_by(rules));
                match relation {
                    Some(relation) if written => {
                        assert_eq!((relation, basis), (one.relation(), Basis::Written), "{at}");
                    }
                    Some(_) => assert_eq!(basis, Basis::Rule, "{at}"),
                    None => assert_eq!(basis, Basis::Unknown, "{at}"),
                }
                by_rule += usize::from(basis == Basis::Rule);
            }
            if is_joined(map, &own, &other) && one.reason() == RelationReason::FromTheRight {
                joined += 1;
                for rules in RoadRules::ALL {
                    assert_eq!(one.relation_by(rules), None, "{at}");
                }
            }
        }
    }
    [by_rule, joined]
}

#[test]
fn without_a_country_only_what_is_written_decides() {
    let mut by_rule = 0;
    for file in carried_and(&MAPS) {
        let snapshot = open(&file);
        by_rule += check(snapshot.map(), &file.display().to_string())[0];
    }
    assert!(by_rule > 0, "no rule says anything");
}

/// A main road of two lanes goes straight on through a junction, which a ramp of one or two lanes joins from the right.
fn joined(ramp: i32, lanes_behind: i32, type_behind: &str) -> String {
    let lanes = |count: i32, links: &dyn Fn(i32) -> String| -> String {
        (1..=count).map(|i| lane(-i, &links(i))).collect()
    };
    let plain = |count: i32| section(0.0, "", &lanes(count, &|_| String::new()));
    let into = |i: i32| i + 2 - ramp;
    let side = -3.5 * f64::from(2 - ramp);
    let outside = "junction=\"-1\"";
    let inside = "junction=\"9\"";
    let kind = format!("<type s=\"0\" type=\"{type_behind}\"/><planView>");
    let main =
        road("1", outside, Line(-90.0, 0.0, 0.0, 90.0, 0.0), &link("s junction 9"), &plain(2))
            .replace("<planView>", "<type s=\"0\" type=\"town\"/><planView>");
    let behind = road(
        "2",
        outside,
        Line(20.0, 0.0, 0.0, 90.0, 0.0),
        &link("p junction 9"),
        &plain(lanes_behind),
    )
    .replace("<planView>", &kind);
    let ramp_road = road(
        "3",
        outside,
        Line(10.0, side - 100.0, FRAC_PI_2, 90.0, 0.0),
        &link("s junction 9"),
        &plain(ramp),
    )
    .replace("<planView>", "<type s=\"0\" type=\"town\"/><planView>");
    let straight = road(
        "12",
        inside,
        Line(0.0, 0.0, 0.0, 20.0, 0.0),
        &(link("p road 1 end") + &link("s road 2 start")),
        &section(0.0, "", &lanes(2, &|i| format!("p-{i} s-{i}"))),
    );
    let joining = road(
        "32",
        inside,
        Line(10.0, side - 10.0, FRAC_PI_2, 10.0 * FRAC_PI_2, -0.1),
        &(link("p road 3 end") + &link("s road 2 start")),
        &section(0.0, "", &lanes(ramp, &|i| format!("p-{i} s-{}", into(i)))),
    );
    let links = |count: i32| -> String { (1..=count).map(|i| format!("-{i}>-{i} ")).collect() };
    let from = |road: &str, by: &str| {
        format!(
            "id=\"{by}\" incomingRoad=\"{road}\" connectingRoad=\"{by}\" contactPoint=\"start\""
        )
    };
    let connections =
        connection(&from("1", "12"), &links(2)) + &connection(&from("3", "32"), &links(ramp));
    document(
        &(main + &behind + &ramp_road + &straight + &joining + &junction("9", "", &connections)),
    )
}

fn meets<'a>(own: Lane<'a>, other: Lane<'a>) -> RightOfWay<'a> {
    let is_it = |lane: Lane<'a>| lane.lane_id() == other.lane_id();
    own.right_of_way().find(|one| one.other().is_some_and(is_it)).expect("they meet")
}

#[test]
fn who_goes_straight_on_does_not_yield_to_a_ramp_by_rule() {
    let check = |ramp: i32, behind: i32, kind: &str, expected: Option<Relation>| {
        let snapshot = open_text(&joined(ramp, behind, kind));
        let map = snapshot.map();
        let (own, other) = (lane_by(map, "12:0:-2"), lane_by(map, &format!("32:0:-{ramp}")));
        let one = meets(own, other);
        assert_eq!(one.reason(), RelationReason::FromTheRight);
        assert_eq!((one.relation(), one.basis()), (Relation::Unknown, Basis::Unknown));
        let germany = RoadRules::of("DE").expect("its rules");
        assert_eq!(one.relation_by(germany), expected, "{ramp} into {behind}");
        let back = expected.map(|_| Relation::Priority);
        assert_eq!(meets(other, own).relation_by(germany), back, "{ramp} into {behind}");
        assert_eq!(own.yields_to().count(), 0);
    };
    let yields = Some(Relation::Yields);
    check(1, 2, "town", None);
    check(2, 2, "town", yields);
    // The road does not go on as it was.
    check(1, 3, "town", yields);
    check(1, 2, "rural", yields);
}

/// Six lanes at 65 mph go straight on; a ramp comes in from the right.
#[test]
fn no_motorway_of_town04_yields_to_a_ramp() {
    let Some(town) = found("maps/Town04.xodr") else { return };
    let snapshot = open(&town);
    let map = snapshot.map();
    let [by_rule, joined] = check(map, "Town04");
    assert!(by_rule > 0 && joined > 0, "{by_rule}, {joined}");
    let mut met = 0;
    for number in 3..=7 {
        let own = lane_by(map, &format!("775:0:{number}"));
        for one in own.right_of_way() {
            let other = one.other().expect("a lane");
            if other.road().id() != "779" {
                continue;
            }
            met += usize::from(one.reason() == RelationReason::FromTheRight);
            assert_ne!(one.relation(), Relation::Yields, "{}", other.key());
            for rules in RoadRules::ALL {
                let found = one.relation_by(rules);
                assert_ne!(found, Some(Relation::Yields), "{} {}", other.key(), rules.country);
            }
        }
    }
    assert!(met > 0, "no right before left");
    // The same of the path that goes straight on.
    let place = |key: &str, s: f64| PositionOnLane { lane: lane_by(map, key).lane_id(), s };
    let lane = lane_by(map, "775:0:6");
    let (from, to) = (lane.section().s_end(), lane.section().s_start());
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let (cost, car) = (ShortestLength::default(), VehicleClass::PassengerCar);
    let ends = [place("775:0:6", from), place("775:0:6", to)];
    let route = map.route(ends[0], ends[1], car, &cost, &mut scratch, &mut steps);
    route.expect("an answer").expect("a way");
    let (mut buffer, mut together, mut found) = (PathBuffer::default(), Vec::new(), Vec::new());
    let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    path.conflicts(&mut together, &mut found);
    let ramp = |id| map.lane(id).expect("a lane").road().id() == "779";
    let of_ramp: Vec<_> = found.iter().filter(|one| ramp(one.other)).collect();
    assert!(!of_ramp.is_empty(), "{found:?}");
    for one in of_ramp {
        assert_eq!(one.yields, Yields::Unknown, "{one:?}");
        for rules in RoadRules::ALL {
            assert_ne!(one.yields_by(rules).yields, Yields::Yields, "{one:?}");
        }
    }
}
