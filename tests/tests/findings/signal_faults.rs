//! Signals that are wrong or odd: findings, not crashes, and the rest of the map stays.

use mapd_archive::encode;
use mapd_client::Snapshot;
use mapd_compiler::{Compilation, CompileOptions, ReadOptions, compile_from};
use mapd_query::vocabulary::LaneMethod;
use mapd_tests::crossroads::signal;
use mapd_tests::graph_maps::{Line, document, lane, road, section};

/// One road to the east with lanes 1 and −1, or only −1, and these signals; what stands beside it.
fn compiled(left: bool, signals: &str, beside: &str) -> Compilation {
    let lanes =
        section(0.0, if left { lane(1, "") } else { String::new() }.as_str(), &lane(-1, ""));
    let plain = road("1", "junction=\"-1\"", Line(0.0, 0.0, 0.0, 50.0, 0.0), "", &lanes);
    let with = plain.replace("</road>", &format!("<signals>{signals}</signals></road>"));
    let text = document(&(with + beside));
    let (reading, options) = (ReadOptions::default(), CompileOptions::default());
    compile_from(|| Ok(text.as_bytes()), &reading, &options, &mut |_| {}).expect("reading works")
}

fn snapshot(compiled: &Compilation) -> Snapshot {
    let findings = &compiled.diagnostics;
    let rows = compiled.rows.as_ref().unwrap_or_else(|| panic!("{findings:?}"));
    let bytes = encode(rows, &compiled.provenance).expect("encodes");
    mapd_archive::verify(&bytes).expect("the archive proves");
    Snapshot::from_bytes(bytes).expect("opens")
}

/// A signal at s = 20 beside the road with these children.
fn holding(id: &str, orientation: &str, children: &str) -> String {
    signal(id, 20.0, -5.0, orientation, "274", "value=\"50\"")
        .replace("/>", &format!(">{children}</signal>"))
}

/// Signals that stay, and rules that are named for the others.
fn check(name: &str, compiled: &Compilation, stay: &[&str], rules: &[&str]) {
    let told: Vec<&str> = compiled.diagnostics.iter().map(|d| d.finding.rule).collect();
    for rule in rules {
        assert!(told.iter().any(|one| one.contains(rule)), "{name}: {rule} is not among {told:?}");
    }
    let snapshot = snapshot(compiled);
    let found: Vec<&str> = snapshot.map().signals().map(|signal| signal.id()).collect();
    assert_eq!(found, stay, "{name}");
    mapd_tests::damage::ask_everything(
        encode(compiled.rows.as_ref().expect("rows"), &compiled.provenance).expect("encodes"),
    );
}

#[test]
fn faults_are_findings() {
    let good = signal("ok", 10.0, -5.0, "+", "206", "");
    let with = |odd: &str| format!("{good}{odd}");
    // For traffic against s, but no lane goes that way.
    let light = signal("light", 20.0, 5.0, "-", "1000001", "");
    check("no lane", &compiled(false, &with(&light), ""), &["ok", "light"], &["signal_lanes"]);
    // From the higher lane to the lower one: a finding, and the lanes are those between.
    let turned = holding("turned", "none", "<validity fromLane=\"1\" toLane=\"-1\"/>");
    check(
        "from > to",
        &compiled(true, &with(&turned), ""),
        &["ok", "turned"],
        &["signal.reference.from_lower_equal_to"],
    );
    let a = holding("a", "+", "<dependency id=\"b\"/>");
    let b = holding("b", "+", "<dependency id=\"a\"/>");
    let looped = compiled(true, &with(&(a + &b)), "");
    check("loop", &looped, &["ok", "a", "b"], &["topology.dependency_cycle"]);
    let lost = "<signalReference id=\"nowhere\" s=\"5\" t=\"0\" orientation=\"+\"/>";
    check("reference", &compiled(true, &with(lost), ""), &["ok"], &["signal_reference"]);
    let unreadable = holding("bad", "+", "").replace("s=\"20\"", "s=\"many\"");
    check("no s", &compiled(true, &with(&unreadable), ""), &["ok"], &["value"]);
    let control = "<controller id=\"c\"><control signalId=\"nowhere\"/><control signalId=\"ok\"/></controller>";
    check("control", &compiled(true, &good, control), &["ok"], &["ids.only_ref_defined_ids"]);
    let beyond = signal("beyond", 80.0, -5.0, "+", "206", "");
    check(
        "beyond the end",
        &compiled(true, &with(&beyond), ""),
        &["ok", "beyond"],
        &["signal.on_road"],
    );
}

/// Lane numbers and methods of one signal.
fn lanes(left: bool, signal: &str) -> Vec<(i32, LaneMethod)> {
    let compiled = compiled(left, signal, "");
    let snapshot = snapshot(&compiled);
    let places = snapshot.map().signal_places().flat_map(|place| place.lanes());
    places.map(|one| (one.lane().expect("a lane").number(), one.method())).collect()
}

#[test]
fn lanes_are_found_by_validity_orientation_place_and_nearness() {
    use LaneMethod::{Nearest, Orientation, OrientationGuess, Track, Validity};
    let at = |t: f64, orientation: &str, validity: &str| {
        holding("x", orientation, validity).replace("t=\"-5\"", &format!("t=\"{t}\""))
    };
    let one = |number: i32| format!("<validity fromLane=\"{number}\" toLane=\"{number}\"/>");
    assert_eq!(lanes(true, &at(-5.0, "+", &one(-1))), [(-1, Validity)]);
    let both = "<validity fromLane=\"1\" toLane=\"-1\"/>";
    assert_eq!(lanes(true, &at(-5.0, "none", both)), [(1, Validity), (-1, Validity)]);
    assert_eq!(lanes(true, &at(-5.0, "+", both)), [(-1, Validity)], "only those that travel so");
    assert_eq!(lanes(true, &at(-5.0, "+", "")), [(-1, Orientation)]);
    assert_eq!(lanes(true, &at(5.0, "-", "")), [(1, Orientation)]);
    assert_eq!(lanes(true, &at(5.0, "none", "")), [(1, Orientation), (-1, Orientation)]);
    assert_eq!(lanes(true, &at(-5.0, "+", &one(0))), [(-1, OrientationGuess)], "0 names none");
    assert_eq!(lanes(true, &at(-1.0, "+", &one(-7))), [(-1, Track)], "no such lane");
    assert_eq!(lanes(true, &at(-9.0, "+", &one(-7))), [(-1, Nearest)], "beside the road");
    assert_eq!(lanes(true, &at(-90.0, "+", &one(-7))), [], "far beside the road");
}
