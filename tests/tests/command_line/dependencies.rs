//! A planner that names `mapd-client` builds no parser, no thread pool, no command line; one that only observes, no iceoryx2 and few crates.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
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

/// Crates that a planner builds that only observes, build scripts and macros among them.
const MOST_OF_AN_OBSERVER: usize = 40;

/// Names of the crates that building `mapd-client` takes.
fn crates(options: &[&str]) -> BTreeSet<String> {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let output = Command::new(cargo)
        .args(["tree", "-p", "mapd-client", "--edges", "normal,build", "--offline"])
        .args(["--prefix", "none", "--no-dedupe", "--format", "{p}"])
        .args(options)
        .current_dir(mapd_tests::workspace())
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let tree = String::from_utf8(output.stdout).expect("text");
    // Name and version: two versions of a crate are two crates.
    let named = |line: &str| line.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    tree.lines().map(named).collect()
}

fn has(crates: &BTreeSet<String>, name: &str) -> bool {
    crates.iter().any(|of| of.split(' ').next() == Some(name))
}

#[test]
fn the_client_stays_light() {
    let crates = crates(&[]);
    assert!(has(&crates, "iceoryx2"), "this is no tree of the client: {crates:?}");
    for heavy in HEAVY {
        assert!(!has(&crates, heavy), "mapd-client depends on {heavy}: {crates:?}");
    }
}

#[test]
fn an_observer_needs_few_crates() {
    let crates = crates(&["--no-default-features"]);
    assert!(has(&crates, "mapd-transport") && !has(&crates, "iceoryx2"), "{crates:?}");
    assert!(crates.len() <= MOST_OF_AN_OBSERVER, "{} crates: {crates:?}", crates.len());
}

/// `1.90.0` or `1.90` as numbers.
fn release(text: &str) -> Vec<u32> {
    text.split('.').map(|part| part.parse().expect("a number")).collect()
}

#[test]
fn no_dependency_needs_a_newer_rust_than_is_promised() {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let output = Command::new(cargo)
        .args(["metadata", "--format-version", "1", "--offline", "--locked"])
        .args(["--filter-platform", "x86_64-unknown-linux-gnu"])
        .current_dir(mapd_tests::workspace())
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let packages = metadata["packages"].as_array().expect("packages");
    let of = |name: &str| packages.iter().find(|package| package["name"] == name);
    let ours = of("mapd").and_then(|mapd| mapd["rust_version"].as_str()).expect("it is stated");
    let newer: Vec<&serde_json::Value> = packages
        .iter()
        .filter(|package| {
            package["rust_version"].as_str().is_some_and(|needed| release(needed) > release(ours))
        })
        .map(|package| &package["name"])
        .collect();
    assert!(newer.is_empty(), "these need a newer Rust than {ours}: {newer:?}");
}

/// A target without a test harness is built once instead of twice, and a unit test that somebody adds to it would never run.
#[test]
fn what_has_no_harness_has_no_unit_tests() {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let output = Command::new(cargo)
        .args(["metadata", "--format-version", "1", "--offline", "--no-deps"])
        .current_dir(mapd_tests::workspace())
        .output()
        .expect("cargo runs");
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let packages = metadata["packages"].as_array().expect("packages");
    let targets =
        packages.iter().flat_map(|package| package["targets"].as_array().expect("targets"));
    let mut seen = 0;
    // Benchmarks and examples are never tests, and what is beside them in a folder is not theirs.
    let has_none = |target: &&serde_json::Value| {
        target["test"] == false && !matches!(target["kind"][0].as_str(), Some("bench" | "example"))
    };
    for target in targets.filter(has_none) {
        let file = Path::new(target["src_path"].as_str().expect("a path"));
        let folder = file.parent().expect("a folder");
        // A program beside a library is its one file: what else is in the folder belongs to the library.
        let is_beside_library = file.ends_with("main.rs") && folder.join("lib.rs").exists();
        let sources = if is_beside_library { vec![file.to_owned()] } else { rust_files(folder) };
        for source in sources {
            let text = std::fs::read_to_string(&source).expect("text");
            assert!(!text.contains("#[test]"), "{} is never run", source.display());
            seen += 1;
        }
    }
    assert!(seen > 0, "no target is without a harness");
}

/// Rust files in a folder and all below it.
fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}
