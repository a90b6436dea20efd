//! `mapd bench`: every line is there, on a file and on a running daemon's map, and nothing is left behind.

use mapd_tests::test_domain::TestDomain;
use serde_json::Value;

fn place() -> TestDomain {
    TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"))
}

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

const SMALL: [&str; 7] = ["bench", "--clients", "3", "--queries", "300", "--routes", "20"];

const LINES: [&str; 13] = [
    "exec to first answer",
    "attach",
    "first query",
    "all at once: exec to first answer",
    "all at once: attach",
    "clock alone",
    "nearest lane, random",
    "x,y to s,t, random",
    "s,t to x,y,z, random",
    "nearest lane, trajectory",
    "x,y to s,t, trajectory",
    "s,t to x,y,z, trajectory",
    "route by length",
];

/// Percentiles rise, counts are what was asked for, ratios are those of the medians.
fn check(report: &Value) {
    let lines: Vec<&Value> = [&report["boot"]["comparisons"], &report["queries"]]
        .iter()
        .flat_map(|list| list.as_array().expect("a list"))
        .collect();
    let names: Vec<&str> =
        lines.iter().map(|line| line["what"].as_str().expect("a name")).collect();
    assert_eq!(names, LINES);
    for line in lines {
        for side in ["shared", "file"] {
            let number = |key: &str| line[side][key].as_u64().expect("a number");
            let count = number("count");
            let wanted: &[u64] = match line["what"].as_str() {
                Some("route by length") => &[20],
                Some(name) if LINES[..5].contains(&name) => &[3],
                _ => &[300],
            };
            assert!(wanted.contains(&count), "{line}");
            let percentiles = ["p50_ns", "p90_ns", "p99_ns", "max_ns"].map(number);
            assert!(percentiles.is_sorted(), "{line}");
        }
        let ratio = line["ratio_p50"].as_f64().expect("a ratio");
        let median = |side: &str| line[side]["p50_ns"].as_f64().expect("a number");
        assert!((ratio * median("file") - median("shared")).abs() <= 1.0, "{line}");
    }
    for taken in report["boot"]["all_answered_ns"].as_array().expect("two") {
        assert!(taken.as_u64().is_some_and(|ns| ns > 0), "{taken}");
    }
}

fn json(output: &std::process::Output) -> Value {
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    serde_json::from_slice(&output.stdout).expect("JSON")
}

#[test]
fn on_a_file_in_a_domain_of_its_own() {
    let place = place();
    let output = place.command().args(SMALL).args(["--json", &town()]).output().expect("runs");
    let report = json(&output);
    check(&report);
    assert_eq!(report["map"], "bench");
    assert!(place.segments().is_empty() && !place.domain().root().exists(), "another's domain");
    let output = place.command().args(SMALL).arg(town()).output().expect("runs");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    for line in LINES {
        assert!(text.lines().any(|l| l.starts_with(line)), "{line} is missing in {text}");
    }
}

#[test]
fn on_a_running_daemons_map() {
    let place = place();
    let daemon = place.serve(&[&town()]);
    for source in [&["shm:town"][..], &[]] {
        let output = place.command().args(SMALL).arg("--json").args(source).output().expect("runs");
        let report = json(&output);
        check(&report);
        assert_eq!(report["map"], "town");
        assert!(report["generation"].as_u64().is_some_and(|generation| generation > 0));
    }
    assert_eq!(daemon.stop(), 0);
}

#[test]
fn without_a_source_and_a_daemon_it_says_what_to_do() {
    let place = place();
    let output = place.command().args(SMALL).output().expect("runs");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("name a SOURCE"), "{said}");
}
