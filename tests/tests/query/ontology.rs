//! The vocabulary of signals and objects: codes of many catalogues, the corpus, and a country that is only a file.

use mapd_ontology::{Class, Light, ObjectCode, Ontology, SignalCode, arrow, bulb};
use mapd_xodr::{Item, Limits, Reader, Text as _, Value as _};
use std::collections::BTreeMap;

/// Share of the corpus's signals that must be mapped.
const MAPPED: f64 = 0.95;

/// (country, type, subtype, name, value, unit) and what they mean, with the value in SI units.
type Case =
    ((&'static str, &'static str, &'static str, &'static str, f64, &'static str), Class, f64);

const KMH: f64 = 1.0 / 3.6;
const MPH: f64 = 0.44704;

#[rustfmt::skip]
const CASES: &[Case] = &[
    (("DE", "274", "-1", "", 50.0, "km/h"), Class::SpeedLimit, 50.0 * KMH),
    (("de", "274", "", "", 30.0, ""), Class::SpeedLimit, 30.0 * KMH),
    (("DEU", "274", "57", "", -1.0, ""), Class::SpeedLimit, 70.0 * KMH),
    (("DE", "274", "130", "", 0.0, ""), Class::SpeedLimit, 130.0 * KMH),
    (("OpenDRIVE", "274", "55", "Sg274.flt", -1.0, ""), Class::SpeedLimit, 50.0 * KMH),
    (("OpenDRIVE", "274", "-1", "", 25.0, "mph"), Class::SpeedLimit, 25.0 * MPH),
    (("DE", "274.1", "-1", "", -1.0, ""), Class::SpeedLimitZone, 30.0 * KMH),
    (("DE", "278", "57", "", -1.0, ""), Class::EndOfSpeedLimit, 70.0 * KMH),
    (("US", "R2-1", "45", "", -1.0, ""), Class::SpeedLimit, 45.0 * MPH),
    (("USA", "R1-1", "-1", "", -1.0, ""), Class::Stop, 0.0),
    (("US", "r1-2", "", "", -1.0, ""), Class::Yield, 0.0),
    (("US", "1000001", "-1", "", -1.0, ""), Class::TrafficLight, 0.0),
    (("US", "W1-2", "", "", -1.0, ""), Class::WarningCurve, 0.0),
    (("CN", "jin", "38", "", 60.0, "km/h"), Class::SpeedLimit, 60.0 * KMH),
    (("cn", "jin", "", "speed_highest_70", 70.0, ""), Class::SpeedLimit, 70.0 * KMH),
    (("cn", "shi", "", "speed_lowest_50", 50.0, ""), Class::MinimumSpeed, 50.0 * KMH),
    (("se", "c", "31", "", 5.0, ""), Class::SpeedLimit, 50.0 * KMH),
    (("se", "c", "27", "", 1.0, ""), Class::NoOvertaking, 0.0),
    (("", "", "", "de_274-50", 0.0, ""), Class::SpeedLimit, 50.0 * KMH),
    (("OpenDRIVE", "206", "-1", "Sign_Stop", -1.0, ""), Class::Stop, 0.0),
    (("", "-1", "-1", "Sign_Yield_02", -1.0, ""), Class::Yield, 0.0),
    (("OpenDRIVE", "1000003", "-1", "", 0.0, ""), Class::Crosswalk, 0.0),
    (("OpenDRIVE", "294", "-1", "SgRMHoldingline-1Lane.flt", 0.0, ""), Class::StopLine, 0.0),
    (("OpenDRIVE", "332", "-1", "Arrow_NoParking_Korea218", 0.0, ""), Class::NoParking, 0.0),
    (("OpenDRIVE", "332", "-1", "exit", 0.0, ""), Class::GuideSign, 0.0),
    (("Atlantis", "205", "-1", "", -1.0, ""), Class::Yield, 0.0),
    (("DE", "262", "-1", "", 7.5, "t"), Class::MaximumWeight, 7500.0),
    (("DE", "265", "-1", "", 3.8, ""), Class::MaximumHeight, 3.8),
    (("DE", "9999", "-1", "", 0.0, ""), Class::Unknown, 0.0),
    // Without a unit: the country's, also for signs of the table that it is based on; SI units without a table.
    (("OpenDRIVE", "274", "-1", "", 16.5, ""), Class::SpeedLimit, 16.5),
    (("", "274", "-1", "", 16.5, ""), Class::SpeedLimit, 16.5),
    (("FRA", "274", "-1", "", 16.5, ""), Class::SpeedLimit, 16.5),
    (("ARGENTINA", "274", "-1", "", 40.0, "km/h"), Class::SpeedLimit, 40.0 * KMH),
    (("Germany", "274", "-1", "", 60.0, ""), Class::SpeedLimit, 60.0 * KMH),
    (("US", "274", "-1", "", 25.0, ""), Class::SpeedLimit, 25.0 * MPH),
    (("DE", "262", "-1", "", 7.5, ""), Class::MaximumWeight, 7500.0),
    (("", "262", "-1", "", 7500.0, ""), Class::MaximumWeight, 7500.0),
    (("OpenDRIVE", "-1", "-1", "StopLine", -1.0, ""), Class::StopLine, 0.0),
    (("OpenDRIVE", "-1", "-1", "Speed_30_2", -1.0, ""), Class::SpeedLimit, 30.0 * KMH),
    (("OpenDRIVE", "-1", "-1", "Speed_30", -1.0, "mph"), Class::SpeedLimit, 30.0 * MPH),
    (("OpenDRIVE", "-1", "-1", "Speed_Bump", -1.0, ""), Class::Unknown, 0.0),
    (("DE", "1000001", "-1", "", -1.0, ""), Class::TrafficLight, 0.0),
];

fn code<'a>(case: &Case) -> SignalCode<'a> {
    let (country, r#type, subtype, name, value, unit) = case.0;
    SignalCode { country, r#type, subtype, name, value: Some(value), unit }
}

#[test]
fn codes_of_many_catalogues() {
    let ontology = Ontology::standard();
    for case in CASES {
        let meaning = ontology.signal(&code(case));
        assert_eq!(meaning.class, case.1, "{case:?}");
        assert!((meaning.value.unwrap_or(0.0) - case.2).abs() < 1e-9, "{case:?}: {meaning:?}");
    }
}

#[test]
fn a_unit_that_is_not_written_is_named() {
    let ontology = Ontology::standard();
    for (country, subtype, name, value, unit, expected) in [
        ("DE", "-1", "", 50.0, "", Some("km/h")),
        ("DE", "-1", "", 50.0, "km/h", None),
        ("DE", "55", "", -1.0, "", None),
        ("OpenDRIVE", "-1", "", 50.0, "", Some("SI")),
        ("US", "-1", "", 50.0, "", Some("mph")),
    ] {
        let value = Some(value);
        let code = SignalCode { country, r#type: "274", subtype, name, value, unit };
        let meaning = ontology.signal(&code);
        assert!(meaning.value.is_some(), "{code:?}");
        assert_eq!(meaning.assumed_unit, expected, "{code:?}");
    }
    for (name, class, value) in [
        ("Speed_90", Class::SpeedLimit, Some(90.0 * KMH)),
        ("speed_60", Class::SpeedLimit, Some(60.0 * KMH)),
        ("Speed_Bump", Class::Unknown, None),
        ("StopLine", Class::StopLine, None),
        ("Sign_Stop", Class::Sign, None),
    ] {
        let code = ObjectCode { r#type: "-1", subtype: "", name };
        let meaning = ontology.object(&code);
        assert_eq!((meaning.class, meaning.value), (class, value), "{name}");
        assert_eq!(meaning.assumed_unit, value.map(|_| "km/h"), "{name}");
    }
}

#[test]
fn lights_show_what_their_type_allows() {
    let light = |r#type, subtype| {
        let code = SignalCode { country: "OpenDRIVE", r#type, subtype, ..SignalCode::default() };
        Ontology::standard().signal(&code).light.unwrap_or_default()
    };
    let three = bulb::RED | bulb::YELLOW | bulb::GREEN;
    for (r#type, subtype, bulbs, arrows) in [
        ("1000001", "-1", three, 0),
        ("1000002", "-1", bulb::RED | bulb::GREEN, 0),
        ("1000011", "10", three, arrow::LEFT),
        ("1000011", "50", three, arrow::STRAIGHT | arrow::RIGHT),
        ("1000012", "10", bulb::GREEN, arrow::LEFT),
        ("1000020", "-1", bulb::RED, 0),
    ] {
        let found = light(r#type, subtype);
        assert_eq!((found.bulbs, found.arrows), (bulbs, arrows), "{type} {subtype}");
        assert_ne!(found.phases, 0, "{type} {subtype}");
    }
    let sign = Ontology::standard().signal(&SignalCode { r#type: "206", ..SignalCode::default() });
    assert_eq!(sign.light, None::<Light>);
}

const ATLANTIS: &str = r#"
name = "atlantis"
countries = ["Atlantis"]
base = "opendrive"
unit = "mph"
signals = [
  { type = "W", subtype = "1", class = "stop" },
  { type = "F", class = "speed_limit", value = "written:tides" },
  { type = "205", class = "priority_road" },
  { type = "L", class = "traffic_light", light = "sea" },
]
light = [{ name = "sea", bulbs = ["green"], phases = ["green", "off"] }]
tables = { tides = { 1 = 10, 2 = 20 } }
"#;

#[test]
fn a_country_is_a_file() {
    let mut ontology = Ontology::standard();
    ontology.extend("atlantis.toml", ATLANTIS).expect("the file is right");
    let ask = |r#type, subtype, value| {
        let country = "Atlantis";
        ontology.signal(&SignalCode { country, r#type, subtype, value, ..SignalCode::default() })
    };
    assert_eq!(ask("W", "1", None).class, Class::Stop);
    assert_eq!(ask("W", "2", None).class, Class::Unknown);
    let limit = ask("F", "", Some(2.0));
    assert_eq!((limit.class, limit.value), (Class::SpeedLimit, Some(20.0 * MPH)));
    assert_eq!(ask("205", "", None).class, Class::PriorityRoad, "overrides its base");
    assert_eq!(ask("206", "", None).class, Class::Stop, "from its base");
    assert_eq!(ask("1000002", "", None).class, Class::PedestrianLight, "numbers of every country");
    assert_eq!(ask("L", "", None).light.map(|light| light.bulbs), Some(bulb::GREEN));
    let german = SignalCode { country: "DE", r#type: "205", ..SignalCode::default() };
    assert_eq!(ontology.signal(&german).class, Class::Yield, "others stay as they are");
}

#[test]
fn wrong_files_say_where() {
    for (text, expected) in [
        ("name = ", "wrong.toml"),
        ("name = \"x\"\nsignals = [{ type = \"1\", class = \"sotp\" }]", "class `sotp`"),
        ("name = \"x\"\nsignals = [{ class = \"stop\" }]", "needs type"),
        ("name = \"x\"\nbase = \"nowhere\"", "`nowhere`"),
        (
            "name = \"x\"\nunit = \"knots\"\nsignals = [{ type = \"1\", class = \"stop\" }]",
            "`knots`",
        ),
        (
            "name = \"x\"\nsignals = [{ type = \"1\", class = \"stop\", light = \"z\" }]",
            "light `z`",
        ),
        (
            "name = \"x\"\nsignals = [{ type = \"1\", class = \"stop\", value = \"a:b\" }]",
            "tables.b",
        ),
    ] {
        let error = Ontology::standard().extend("wrong.toml", text).expect_err(text).to_string();
        assert!(error.contains(expected) && error.contains("wrong.toml"), "{error}");
    }
}

#[test]
fn nearly_all_signals_of_the_corpus_are_mapped() {
    let Some(corpus) = mapd_tests::corpus() else {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    };
    let ontology = Ontology::standard();
    let (mut all, mut unknown) = (0, BTreeMap::new());
    for (_, path) in corpus {
        let mut reader = Reader::open(&path, Limits::default()).expect("opens");
        while let Ok(Some(item)) = reader.next() {
            let Item::Road(road) = item else { continue };
            for signal in road.signals.iter().flat_map(|signals| &signals.signal) {
                let (r#type, subtype) = (signal.r#type.text(), signal.subtype.text());
                let (country, name) = (signal.country.text(), signal.name.text());
                let value = signal.value.value();
                let code = SignalCode { country, r#type, subtype, name, value, unit: "" };
                all += 1;
                if ontology.signal(&code).class == Class::Unknown {
                    let key = format!("{country} {type} {subtype} {name}");
                    *unknown.entry(key.trim().to_owned()).or_insert(0) += 1;
                }
            }
        }
    }
    let missing: i32 = unknown.values().sum();
    let share = 1.0 - f64::from(missing) / f64::from(all);
    assert!(all > 600, "the corpus has {all} signals");
    assert!(share >= MAPPED, "{share} mapped; not: {unknown:#?}");
    // docs/ontology.md lists them.
    let page =
        std::fs::read_to_string(mapd_tests::workspace().join("docs/ontology.md")).expect("page");
    for code in unknown.keys() {
        assert!(page.contains(&format!("`{code}`")), "docs/ontology.md does not list `{code}`");
    }
}
