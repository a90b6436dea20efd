//! `.ci/promises` demands a line in the list of changes for each part that has changed.

use mapd_tests::workspace;
use std::path::Path;
use std::process::{Command, Output};

fn git(folder: &Path, args: &[&str]) {
    let who = ["-c", "user.name=a", "-c", "user.email=a@example.org"];
    let output = Command::new("git").current_dir(folder).args(who).args(args).output();
    let output = output.expect("git runs");
    assert!(output.status.success(), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
}

fn write(folder: &Path, file: &str, text: &str) {
    let path = folder.join(file);
    std::fs::create_dir_all(path.parent().expect("a folder")).expect("made");
    std::fs::write(path, text).expect("written");
}

fn promises(folder: &Path) -> Output {
    let script = workspace().join(".ci/promises");
    Command::new(script).arg("HEAD").current_dir(folder).output().expect("runs")
}

/// Changes files of a release; labels that are missing then.
fn check(changed: &[(&str, &str)], expected: &[&str]) {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    git(folder, &["init", "-q"]);
    for file in [
        "CHANGELOG.md",
        "docs/api/mapd.txt",
        "docs/api/mapd-query.txt",
        "src/c/abi.txt",
        "src/python/python/mapd/_mapd.pyi",
        "schemas/report.schema.json",
        "tests/data/archives/one.mapd",
    ] {
        write(folder, file, "released\n");
    }
    git(folder, &["add", "-A"]);
    git(folder, &["commit", "-q", "-m", "a release"]);
    for (file, text) in changed {
        write(folder, file, text);
    }
    let output = promises(folder);
    assert_eq!(output.status.success(), expected.is_empty(), "{output:?}");
    let told = String::from_utf8_lossy(&output.stderr);
    let labels = told.lines().filter_map(|line| line.split_once('[')?.1.strip_suffix("]:"));
    assert_eq!(labels.collect::<Vec<_>>(), expected, "{told}");
}

#[test]
fn each_part_that_has_changed_needs_its_line() {
    let lines = "released\n- A query less. [Rust, C]\n- A column more. [command line]\n";
    let log = ("CHANGELOG.md", lines);
    let rust = ("docs/api/mapd-query.txt", "fewer\n");
    let c = ("src/c/abi.txt", "fewer\n");
    let line = ("docs/api/mapd.txt", "more\n");
    let python = ("src/python/python/mapd/_mapd.pyi", "more\n");
    let json = ("schemas/report.schema.json", "{}\n");
    let archive = ("tests/data/archives/one.mapd", "other\n");
    check(&[], &[]);
    check(&[("README.md", "what nobody promises\n")], &[]);
    check(&[rust], &["Rust"]);
    check(&[("CHANGELOG.md", "released\n- A line without a label.\n"), rust], &["Rust"]);
    check(&[log, rust, c, line], &[]);
    check(&[log, rust, python, json, archive], &["Python", "JSON", "archive"]);
}
