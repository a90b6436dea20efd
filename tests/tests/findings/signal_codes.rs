//! What signals and objects write in place of a country's code or a unit: they stay, a finding says it, and the catalogue that
//! counts is the documented one.

use mapd_archive::encode;
use mapd_client::Snapshot;
use mapd_compiler::{Compilation, CompileOptions, ReadOptions, Verdict, compile, compile_from};
use mapd_query::signals::Signal;
use mapd_query::vocabulary::Class;
use mapd_tests::object_maps::{ObjectRoad, PLAIN, document};
use mapd_xodr::Severity;

const KMH: f64 = 1.0 / 3.6;
const UNIT: &str = "mapd:xodr:1.4.0:signal.value_unit";
const VALUE: &str = "mapd:value.type";
const ASSUMED: &str = "mapd:compile.assumed_unit";

fn compiled(text: &str) -> Compilation {
    compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {}).expect("reading works")
}

fn snapshot(compiled: &Compilation) -> Snapshot {
    let rows = compiled.rows.as_ref().unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let bytes = encode(rows, &compiled.provenance).expect("encodes");
    mapd_archive::verify(&bytes).expect("the archive proves");
    Snapshot::from_bytes(bytes).expect("opens")
}

fn with_signals(version: &str, objects: &str, signals: &str) -> String {
    document(&ObjectRoad { version, ..PLAIN }, objects)
        .replace("</objects>", &format!("</objects><signals>{signals}</signals>"))
}

fn sign(country: &str, more: &str) -> String {
    format!(
        r#"<signal id="V" name="" s="20" t="-5" zOffset="2" hOffset="0" orientation="+" dynamic="no" country="{country}" type="274" subtype="-1" height="1" width="1" {more}/>"#
    )
}

/// Findings of a rule: how bad each is.
fn told(compiled: &Compilation, rule: &str) -> Vec<Severity> {
    let of_rule = compiled.diagnostics.iter().filter(|d| d.finding.rule == rule);
    of_rule.map(|d| d.finding.severity).collect()
}

/// The country as written, and what its speed sign of 50 km/h says.
fn check_country(version: &str, country: &str, warnings: usize) {
    let name = format!("{country:?} in {version}");
    let text = with_signals(version, "", &sign(country, "value=\"50\" unit=\"km/h\""));
    let compiled = compiled(&text);
    assert_eq!(compiled.verdict, Verdict::Accepted, "{name}: {:?}", compiled.diagnostics);
    assert_eq!(told(&compiled, VALUE), vec![Severity::Warning; warnings], "{name}");
    let snapshot = snapshot(&compiled);
    let signal = snapshot.map().signal_by_id("V").expect("it stays");
    assert_eq!(signal.code()[0], country, "{name}");
    assert_eq!((signal.class(), signal.value()), (Class::SpeedLimit, Some(50.0 * KMH)), "{name}");
}

#[test]
fn no_country_leaves_a_signal_out() {
    check_country("1.4", "DE", 0);
    check_country("1.5", "DE", 1);
    check_country("1.5", "DEU", 0);
    check_country("1.6", "ARGENTINA", 1);
    check_country("1.7", "de", 1);
    check_country("1.7", "DE", 0);
    check_country("1.8", "Atlantis!", 1);
    check_country("1.8", "1", 1);
}

#[test]
fn a_country_of_a_road_type_is_a_warning_too() {
    for (country, warnings) in [("DE", 0), ("de", 1), ("ARGENTINA", 1)] {
        let types = format!(r#"<type s="0" type="town" country="{country}"/><planView>"#);
        let text = document(&PLAIN, "").replace("<planView>", &types);
        let compiled = compiled(&text);
        assert_eq!(compiled.verdict, Verdict::Accepted, "{country}");
        assert_eq!(told(&compiled, VALUE), vec![Severity::Warning; warnings], "{country}");
    }
}

#[test]
fn a_value_without_unit_is_told_in_every_version() {
    for version in ["1.4", "1.5", "1.6", "1.7", "1.8", "1.9"] {
        for (country, value, meant, assumed, warnings) in [
            ("OpenDRIVE", "value=\"16.5\"", Some(16.5), true, 1),
            ("DEU", "value=\"60\"", Some(60.0 * KMH), true, 1),
            ("USA", "value=\"60\"", Some(60.0 * 0.44704), true, 1),
            ("OpenDRIVE", "value=\"60\" unit=\"km/h\"", Some(60.0 * KMH), false, 0),
            ("DEU", "value=\"-1\"", None, false, 0),
        ] {
            let name = format!("{country} {value} in {version}");
            let compiled = compiled(&with_signals(version, "", &sign(country, value)));
            assert_eq!(told(&compiled, UNIT), vec![Severity::Warning; warnings], "{name}");
            let snapshot = snapshot(&compiled);
            let signal = snapshot.map().signal_by_id("V").expect("a signal");
            let close = signal.value().zip(meant).is_none_or(|(a, b)| (a - b).abs() < 1e-12);
            assert!(
                close && signal.value().is_some() == meant.is_some(),
                "{name}: {:?}",
                signal.value()
            );
            assert_eq!(signal.is_unit_assumed(), assumed, "{name}");
        }
    }
}

#[test]
fn a_value_of_a_sign_on_a_board_needs_a_unit_too() {
    let board = |unit: &str| {
        format!(
            r#"<staticBoard><sign id="S" v="0" z="1" orientation="+" dynamic="no" country="DE" type="274" subtype="-1" value="30" {unit}/></staticBoard>"#
        )
    };
    for (unit, warnings) in [("", 1), ("unit=\"km/h\"", 0)] {
        let carrier = sign("DE", "").replace("/>", &format!(">{}</signal>", board(unit)));
        let compiled = compiled(&with_signals("1.8", "", &carrier));
        assert_eq!(told(&compiled, UNIT).len(), warnings, "{unit}");
    }
}

/// A sign that is written as an object, or a signal with nothing but a name.
fn named(element: &str, id: &str, name: &str) -> String {
    format!(
        r#"<{element} id="{id}" name="{name}" s="20" t="-5" zOffset="0" hdg="0" pitch="0" roll="0" orientation="-" type="-1"/>"#
    )
}

#[test]
fn names_of_stop_lines_and_limits_are_known() {
    let objects: String =
        [("a", "Speed_30"), ("b", "speed_90"), ("c", "StopLine"), ("d", "Speed_Bump")]
            .map(|(id, name)| named("object", id, name))
            .concat();
    let signals: String = [("e", "StopLine"), ("f", "Speed_60")]
        .map(|(id, name)| {
            named("signal", id, name)
                .replace("/>", " subtype=\"-1\" dynamic=\"no\" country=\"OpenDRIVE\"/>")
        })
        .concat();
    let compiled = compiled(&with_signals("1.4", &objects, &signals));
    assert_eq!(told(&compiled, ASSUMED), [Severity::Info; 3], "each number that is read");
    let snapshot = snapshot(&compiled);
    let map = snapshot.map();
    let objects: Vec<_> = map.objects().map(|o| (o.class(), o.value(), o.assumed_unit())).collect();
    assert_eq!(
        objects,
        [
            (Class::SpeedLimit, Some(30.0 * KMH), "km/h"),
            (Class::SpeedLimit, Some(90.0 * KMH), "km/h"),
            (Class::StopLine, None, ""),
            (Class::Unknown, None, ""),
        ]
    );
    let signals: Vec<_> = map.signals().map(|s: Signal<'_>| (s.class(), s.value())).collect();
    assert_eq!(signals, [(Class::StopLine, None), (Class::SpeedLimit, Some(60.0 * KMH))]);
}

fn open(name: &str) -> Option<(Compilation, Snapshot)> {
    let Some(folder) = mapd_tests::shared("found") else {
        mapd_tests::say("SKIPPED: no shared maps beside the workspace");
        return None;
    };
    let path = folder.join(name);
    let file = || std::fs::File::open(&path);
    let (reading, options) = (ReadOptions::default(), CompileOptions::default());
    let compiled = compile_from(file, &reading, &options, &mut |_| {}).expect("reading works");
    let snapshot = snapshot(&compiled);
    Some((compiled, snapshot))
}

#[test]
fn no_signal_of_the_maps_that_showed_it_is_lost() {
    for (name, signals) in [
        ("small/min_country.xodr", 1),
        ("maps/Ex_Signal-Dependency.xodr", 2),
        ("maps/ARG_Carcarana-1_1_T-1.xodr", 25),
    ] {
        let Some((compiled, snapshot)) = open(name) else { return };
        assert_eq!(snapshot.map().signals().len(), signals, "{name}");
        assert!(!told(&compiled, VALUE).is_empty(), "{name}");
    }
}

#[test]
fn values_of_the_maps_that_showed_it() {
    let Some((compiled, heights)) = open("maps/sample03heightmap.xodr") else { return };
    assert!(!told(&compiled, UNIT).is_empty());
    let limits = heights.map().signals().filter(|signal| signal.class() == Class::SpeedLimit);
    let limits: Vec<f64> = limits.filter_map(|signal| signal.value()).collect();
    assert_eq!(limits.len(), 2);
    assert!(limits.iter().all(|limit| (limit - 60.0 * KMH).abs() < 1e-9), "{limits:?}");
    let Some((_, campus)) = open("maps/UAS_Augsburg_CampusBrunnenlech_signalized.xodr") else {
        return;
    };
    let lines = campus.map().signals().filter(|signal| signal.class() == Class::StopLine);
    assert_eq!(lines.count(), 6);
    let Some((compiled, town)) = open("maps/Town04.xodr") else { return };
    let limits = town.map().objects().filter(|object| object.class() == Class::SpeedLimit);
    let limits: Vec<f64> = limits.filter_map(|object| object.value()).collect();
    assert_eq!(limits.len(), 53);
    assert_eq!(limits.iter().filter(|limit| **limit == 90.0 * KMH).count(), 22);
    assert_eq!(told(&compiled, ASSUMED).len(), 53);
}
