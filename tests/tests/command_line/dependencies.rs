//! A planner that names `mapd-client` builds no parser, no thread pool, no command line.

use std::process::Command;

/// Crates that only the compiler and the daemon need.
const HEAVY: [&str; 14] = [
    "quick-xml",
    "rayon",
    "rstar",
    "clap",
    "indicatif",
    "serde_json",
    "mapd-xodr",
    "mapd-rules",
    "mapd-compiler",
    // Only with the feature `geodesy`, and the last two not even then.
    "proj4rs",
    "proj4wkt",
    "crs-definitions",
    // Only with the feature `trust`, and the last not even then.
    "minisign-verify",
    "minisign",
];

#[test]
fn the_client_stays_light() {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let output = Command::new(cargo)
        .args([
            "tree",
            "-p",
            "mapd-client",
            "--edges",
            "normal",
            "--prefix",
            "none",
            "--format",
            "{p}",
            "--offline",
        ])
        .current_dir(mapd_tests::workspace())
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let tree = String::from_utf8_lossy(&output.stdout).into_owned();
    let crates: Vec<&str> =
        tree.lines().filter_map(|line| line.split_whitespace().next()).collect();
    assert!(crates.contains(&"iceoryx2"), "this is no tree of the client:\n{tree}");
    for heavy in HEAVY {
        assert!(!crates.contains(&heavy), "mapd-client depends on {heavy}:\n{tree}");
    }
}
