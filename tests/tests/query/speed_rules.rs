//! Which speed limit holds, and who says so; signals that say themselves what they mean.

use mapd_compiler::Compilation;
use mapd_query::rules::SpeedOrigin;
use mapd_query::vocabulary::{Class, VehicleClass};
use mapd_tests::maps::found;
use mapd_tests::object_maps::{ObjectRoad, PLAIN, compile, document, open};

const KMH: f64 = 1.0 / 3.6;

/// What stands in a map for these tests, all of it optional.
#[derive(Default)]
struct Rules<'a> {
    /// Children of the header's `defaultRegulations`.
    regulations: &'a str,
    /// `type` elements of the road.
    types: &'a str,
    /// What lane −1 holds beside its width.
    lane: &'a str,
    signals: &'a str,
}

fn map(rules: &Rules<'_>) -> String {
    let header = format!(
        r#"<header revMajor="1" revMinor="9"><defaultRegulations>{}</defaultRegulations></header>"#,
        rules.regulations
    );
    let signals = format!("</objects><signals>{}</signals>", rules.signals);
    let lane = r#"<lane id="-1" type="driving" level="false"><width sOffset="0" a="3.5" b="0" c="0" d="0"/>"#;
    document(&ObjectRoad { version: "1.9", ..PLAIN }, "")
        .replace(r#"<header revMajor="1" revMinor="9"/>"#, &header)
        .replace("<planView>", &format!("{}<planView>", rules.types))
        .replace(lane, &format!("{lane}{}", rules.lane))
        .replace("</objects>", &signals)
}

fn sign(id: &str, s: f64, kind: &str, inside: &str) -> String {
    format!(
        r#"<signal id="{id}" s="{s}" t="-5" zOffset="2" orientation="+" dynamic="no" {kind}>{inside}</signal>"#
    )
}

/// Limits at places of a lane: s, metres per second if any, who says so.
fn check(rules: &Rules<'_>, lane: i32, expected: &[(f64, Option<f64>, SpeedOrigin)]) {
    let snapshot = open(&map(rules));
    let section = snapshot.map().road_by_id("1").expect("the road").section(0).expect("a section");
    let lane = section.lane(lane).expect("a lane");
    for (s, max, origin) in expected {
        let rule = lane.speed_rule_at(*s);
        assert_eq!(rule.origin, *origin, "at {s}: {rule:?}");
        let fits = match (rule.max, max) {
            (Some(found), Some(max)) => found == *max || (found - max).abs() < 1e-12,
            (found, max) => found == *max,
        };
        assert!(fits, "at {s}: {rule:?}, expected {max:?}");
        assert_eq!(rule.signal.is_some(), *origin == SpeedOrigin::Signal);
    }
}

const TOWN: &str = r#"<roadRegulations type="town"><semantics><speed type="maximum" value="50" unit="km/h"/></semantics></roadRegulations>"#;

use SpeedOrigin::{Default as ByDefault, Lane, None as Nobody, RoadType, Signal};

#[test]
fn a_sign_goes_before_the_lane_before_the_road_before_the_header() {
    let signals =
        sign("V", 80.0, r#"country="DE" type="274" subtype="-1" value="30" unit="km/h""#, "")
            + &sign(
                "E",
                95.0,
                r#"country="DE" type="278" subtype="-1" value="30" unit="km/h""#,
                "",
            );
    let rules = Rules {
        regulations: TOWN,
        types: r#"<type s="0" type="town"/><type s="40" type="rural"><speed max="100" unit="km/h"/></type>"#,
        lane: r#"<speed sOffset="60" max="70" unit="km/h"/>"#,
        signals: &signals,
    };
    let ahead = [
        (10.0, Some(50.0 * KMH), ByDefault),
        (40.0, Some(100.0 * KMH), RoadType),
        (60.0, Some(70.0 * KMH), Lane),
        (80.0, Some(30.0 * KMH), Signal),
        (94.0, Some(30.0 * KMH), Signal),
        (95.0, Some(70.0 * KMH), Lane),
    ];
    check(&rules, -1, &ahead);
    // Neither the sign nor the lane's record is for the other direction.
    check(&rules, 1, &[(10.0, Some(50.0 * KMH), ByDefault), (90.0, Some(100.0 * KMH), RoadType)]);
    // Without the one, the next: nobody at last.
    check(&Rules { signals: "", ..rules }, -1, &[(90.0, Some(70.0 * KMH), Lane)]);
    check(&Rules { signals: "", lane: "", ..rules }, -1, &[(90.0, Some(100.0 * KMH), RoadType)]);
    check(&Rules { regulations: TOWN, ..Rules::default() }, -1, &[(90.0, None, Nobody)]);
    check(&Rules::default(), -1, &[(90.0, None, Nobody)]);
}

#[test]
fn no_limit_is_a_rule_and_undefined_is_none() {
    let road =
        |max: &str| format!(r#"<type s="0" type="town"><speed max="{max}" unit="km/h"/></type>"#);
    let of = |types: &str, expected| {
        check(&Rules { regulations: TOWN, types, ..Rules::default() }, -1, &[expected]);
    };
    of(&road("no limit"), (5.0, Some(f64::INFINITY), RoadType));
    of(&road("undefined"), (5.0, Some(50.0 * KMH), ByDefault));
    of(&road("60"), (5.0, Some(60.0 * KMH), RoadType));
}

fn count(compiled: &Compilation, rule: &str) -> usize {
    compiled.diagnostics.iter().filter(|one| one.finding.rule == rule).count()
}

/// Units that can only mean one are read as it; what cannot be read is unknown, whatever else holds on the road. Each with the rule that tells of it.
#[test]
fn a_limit_that_cannot_be_read_is_unknown() {
    const LEXICAL: &str = "mapd:value.lexical";
    const UNKNOWN: &str = "mapd:compile.speed_limit";
    const IMPLAUSIBLE: &str = "mapd:compile.speed_plausible";
    let of = |attributes: &str, max: Option<f64>, told: Option<&str>| {
        let (lane, road) = match max {
            Some(_) => (SpeedOrigin::Lane, SpeedOrigin::RoadType),
            None => (Nobody, Nobody),
        };
        let record = format!(r#"<speed sOffset="20" {attributes}/>"#);
        let fifty = r#"<type s="0" type="town"><speed max="50" unit="km/h"/></type>"#;
        let on_lane = Rules { regulations: TOWN, types: fifty, lane: &record, ..Rules::default() };
        check(&on_lane, -1, &[(10.0, Some(50.0 * KMH), RoadType), (30.0, max, lane)]);
        let types = format!(r#"<type s="0" type="town"><speed {attributes}/></type>"#);
        let on_road = Rules { regulations: TOWN, types: &types, ..Rules::default() };
        check(&on_road, -1, &[(10.0, max, road)]);
        check(&on_road, 1, &[(10.0, max, road)]);
        for rules in [on_lane, on_road] {
            let compiled = compile(&map(&rules));
            let rules = [LEXICAL, UNKNOWN, IMPLAUSIBLE];
            let counts = rules.map(|rule| count(&compiled, rule));
            let expected = rules.map(|rule| usize::from(told == Some(rule)));
            assert_eq!(counts, expected, "{attributes}: {:?}", compiled.diagnostics);
        }
    };
    for unit in ["kph", "KM/H", "kmh", "Kmh", " KPH "] {
        of(&format!(r#"max="50" unit="{unit}""#), Some(50.0 * KMH), Some(LEXICAL));
    }
    of(r#"max="50" unit="Mph""#, Some(50.0 * 0.44704), Some(LEXICAL));
    of(r#"max="30" unit="M/S""#, Some(30.0), Some(LEXICAL));
    for stated in [
        r#"max="50" unit="knots""#,
        r#"max="50" unit="km""#,
        r#"max="-1" unit="km/h""#,
        r#"max="-0.5""#,
        r#"max="fast" unit="km/h""#,
        r#"unit="km/h""#,
    ] {
        of(stated, None, Some(UNKNOWN));
    }
    of(r#"max="40""#, Some(40.0), None);
    of(r#"max="0" unit="km/h""#, Some(0.0), None);
    of(r#"max="50""#, Some(50.0), Some(IMPLAUSIBLE));
    of(r#"max="400" unit="km/h""#, Some(400.0 / 3.6), None);
    of(r#"max="250" unit="mph""#, Some(250.0 * 0.44704), Some(IMPLAUSIBLE));
}

/// A sign of a limit in a unit that cannot be read ends what held before, and what holds behind is unknown.
#[test]
fn a_sign_in_an_unknown_unit_leaves_the_limit_unknown() {
    let de = |value: &str| format!(r#"country="DE" type="274" subtype="-1" {value}"#);
    let semantics = r#"<semantics><speed type="maximum" value="30" unit="knots"/></semantics>"#;
    let fifty = r#"<type s="0" type="town"><speed max="50" unit="km/h"/></type>"#;
    for (kind, inside, max) in [
        (de(r#"value="30" unit="kph""#), "", Some(30.0 * KMH)),
        (de(r#"value="30" unit="MPH""#), "", Some(30.0 * 0.44704)),
        (de(r#"value="30" unit="knots""#), "", None),
        (de(r#"value="30" unit="t""#), "", None),
        (r#"type="none" subtype="-1""#.to_owned(), semantics, None),
        // The number is a code of the country's, which has its unit.
        (
            r#"country="DE" type="274" subtype="53" value="-1" unit="knots""#.to_owned(),
            "",
            Some(30.0 * KMH),
        ),
    ] {
        let signals = sign("V", 20.0, &kind, inside);
        let rules = Rules { types: fifty, signals: &signals, ..Rules::default() };
        let origin = if max.is_some() { Signal } else { Nobody };
        check(&rules, -1, &[(10.0, Some(50.0 * KMH), RoadType), (30.0, max, origin)]);
        let compiled = compile(&map(&rules));
        let told = count(&compiled, "mapd:compile.speed_limit");
        assert_eq!(told, usize::from(max.is_none()), "{kind} {inside}");
    }
}

#[test]
fn semantics_go_before_the_code() {
    let meant = |inside: &str| format!("<semantics>{inside}</semantics>");
    for (inside, class, value) in [
        (
            r#"<speed type="maximum" value="30" unit="mph"/>"#,
            Class::SpeedLimit,
            Some(30.0 * 0.44704),
        ),
        (r#"<speed type="zone" value="20" unit="km/h"/>"#, Class::SpeedLimitZone, Some(20.0 * KMH)),
        (r#"<priority type="yield"/>"#, Class::Yield, None),
        (r#"<priority type="4way"/>"#, Class::Stop, None),
        (r#"<priority type="stopLine"/>"#, Class::StopLine, None),
        (r#"<lane type="noOvertakeTrucks"/>"#, Class::NoOvertakingByTrucks, None),
        (r#"<warning/>"#, Class::Warning, None),
    ] {
        // By its code, a stop sign.
        let signals = sign("1", 20.0, r#"country="DE" type="206" subtype="-1""#, &meant(inside));
        let snapshot = open(&map(&Rules { signals: &signals, ..Rules::default() }));
        let signal = snapshot.map().signal_by_id("1").expect("the signal");
        assert_eq!(signal.class(), class, "{inside}");
        let fits = match (signal.value(), value) {
            (Some(found), Some(value)) => (found - value).abs() < 1e-12,
            (found, value) => found == value,
        };
        assert!(fits, "{inside}: {:?}", signal.value());
        assert_eq!(signal.semantics().next().map(|one| one.class), Some(class), "{inside}");
        assert_eq!(signal.code()[2], "206", "what is written stays");
    }
}

#[test]
fn a_temporary_or_invalidated_sign_says_so() {
    let kind = r#"country="DE" type="274" subtype="-1" value="30" unit="km/h" temporary="true""#;
    let gone = kind.replace("temporary", "invalidated");
    let signals = sign("T", 20.0, kind, "") + &sign("I", 60.0, &gone.replace("30", "10"), "");
    let rules = Rules { signals: &signals, ..Rules::default() };
    let snapshot = open(&map(&rules));
    let signal = |id| snapshot.map().signal_by_id(id).expect("a signal");
    assert!(signal("T").is_temporary() && !signal("T").is_invalidated());
    assert!(signal("I").is_invalidated());
    // What no longer holds changes nothing.
    check(&rules, -1, &[(10.0, None, Nobody), (80.0, Some(30.0 * KMH), Signal)]);
}

#[test]
fn access_is_asked_by_lane_and_place() {
    let lane = r#"<access sOffset="0" rule="allow" restriction="bus"/><access sOffset="50" rule="deny" restriction="trucks"/>"#;
    let snapshot = open(&map(&Rules { lane, ..Rules::default() }));
    let section = snapshot.map().road_by_id("1").expect("the road").section(0).expect("a section");
    let lane = section.lane(-1).expect("a lane");
    assert_eq!(lane.access_at(10.0).collect::<Vec<_>>(), [VehicleClass::Bus]);
    assert!(lane.allows_at(60.0, VehicleClass::PassengerCar));
    assert!(lane.access_at(60.0).all(|class| lane.allows_at(60.0, class)));
    assert!(!lane.allows_at(60.0, VehicleClass::Truck));
}

/// Lanes of junctions that are open, and those among them of which the limit is unknown in the middle.
#[test]
fn limits_within_junctions_are_known_as_counted() {
    for (name, expected) in [
        ("Town03", [0, 683]),
        ("Town04", [59, 452]),
        ("Town05", [0, 1_440]),
        ("cloverleaf", [22, 213]),
    ] {
        let path = match name {
            "Town03" | "Town05" => {
                let folder = mapd_tests::shared("maps/carla");
                folder.map(|folder| folder.join(format!("{name}.xodr")))
            }
            _ => found(&format!("maps/{name}.xodr")),
        };
        let Some(path) = path else {
            mapd_tests::say("SKIPPED in part: no shared maps beside the workspace");
            return;
        };
        let snapshot = mapd_tests::maps::open(&path);
        let map = snapshot.map();
        let inside = |lane: &mapd_client::Lane<'_>| lane.road().junction().is_some();
        let open = |lane: &mapd_client::Lane<'_>| lane.nodes().any(|node| node.is_open());
        let lanes: Vec<_> = map.lanes().filter(|lane| inside(lane) && open(lane)).collect();
        let unknown = lanes.iter().filter(|lane| {
            let section = lane.section();
            lane.speed_rule_at(0.5 * (section.s_start() + section.s_end())).max.is_none()
        });
        assert_eq!([unknown.count(), lanes.len()], expected, "{name}");
    }
}
