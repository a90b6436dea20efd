//! What the program says of itself: help, completions and man pages; and how much it says to people.

use mapd_tests::command::run;
use mapd_tests::workspace;
use serde_json::Value;
use std::path::Path;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// What a command writes to stdout.
pub(crate) fn text(args: &[&str]) -> String {
    let output = run(MAPD, args, "");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{args:?}: {errors}");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Names of the commands that are not hidden.
fn commands() -> Vec<String> {
    let shown = |command: &&clap::Command| !command.is_hide_set();
    let command = mapd::cli::command();
    command.get_subcommands().filter(shown).map(|one| one.get_name().to_owned()).collect()
}

/// Lines and columns of a terminal that people have; the line after the page is the shell's.
const SCREEN: usize = 24;
const COLUMNS: usize = 80;

/// The first page where there are so many columns.
fn first_page(columns: usize) -> String {
    let mut short = std::process::Command::new(MAPD);
    // What this machine has set is no part of it.
    short.arg("-h").env("COLUMNS", columns.to_string()).env("MAPD_CACHE", "/somewhere/else");
    let short = short.output().expect("runs").stdout;
    String::from_utf8_lossy(&short).into_owned()
}

#[test]
fn short_help_fits_a_screen_and_long_help_has_all_under_headings() {
    let short = first_page(COLUMNS);
    assert!(!short.contains("/somewhere/else"), "{short}");
    assert!(short.lines().count() < SCREEN, "{short}");
    for columns in [40, COLUMNS] {
        let page = first_page(columns);
        assert!(page.lines().all(|line| line.chars().count() <= columns), "{columns}: {page}");
    }
    let long = text(&["--help"]);
    for heading in ["Serving:", "Compiling:", "Findings:", "Trust:", "Operating:", "Shared memory:"]
    {
        assert!(long.contains(heading), "{heading} in {long}");
    }
    let options = mapd::cli::command();
    for option in options.get_arguments().filter_map(clap::Arg::get_long) {
        assert!(long.contains(&format!("--{option}")), "{option} in {long}");
    }
    let is_separator = |c: char| c.is_whitespace() || c == ',';
    let lines = short.lines().filter_map(|line| line.get(9..29));
    let named: Vec<&str> = lines.flat_map(|names| names.split(is_separator)).collect();
    for command in commands().iter().filter(|command| *command != "help") {
        assert!(named.contains(&command.as_str()), "{command} in {short}");
    }
    assert!(short.contains("mapd help COMMAND"), "{short}");
}

/// Without a command there is nothing to do but to say what there is.
#[test]
fn the_first_page_is_shown_where_nothing_is_asked() {
    let nothing = run(MAPD, &[], "");
    assert_eq!(nothing.status.code(), Some(2));
    for args in [&["-h"][..], &["--load", "town.xodr", "-h"]] {
        let page = text(args);
        assert_eq!(page, String::from_utf8_lossy(&nothing.stdout), "{args:?}");
    }
    assert!(text(&["check", "-h"]).contains("Usage: mapd check"));
}

#[test]
fn inspect_shows_tables_where_they_are_asked_for() {
    let town = workspace().join("examples/maps/town.xodr").display().to_string();
    let page = text(&["inspect", &town]);
    assert!(page.contains("extent        211.0 m × 211.0 m, 0.0 m high\n"), "{page}");
    assert!(page.contains("quarantine    empty: nothing was left out\n"), "{page}");
    assert!(!page.contains("lane_nodes"), "{page}");
    let with_tables = text(&["inspect", &town, "--tables"]);
    assert!(with_tables.starts_with(page.trim_end()), "{with_tables}");
    assert!(with_tables.contains("\nlane_nodes "), "{with_tables}");
    assert!(!with_tables.contains("\nlane_rules "), "no empty tables: {with_tables}");
}

/// Writes a town with an attribute that no version knows, on the first roads.
fn odd_town(folder: &Path, count: usize) -> String {
    let path = folder.join("map.xodr");
    let town = std::fs::read_to_string(workspace().join("examples/maps/town.xodr")).expect("read");
    std::fs::write(&path, town.replacen("<road ", "<road odd=\"1\" ", count)).expect("written");
    path.display().to_string()
}

/// `inspect` counts what `check` finds; an archive keeps no findings.
#[test]
fn inspect_counts_findings() {
    let folder = tempfile::tempdir().expect("a folder");
    let map = odd_town(folder.path(), 10);
    let json = |args: &[&str]| -> Value { serde_json::from_str(&text(args)).expect("JSON") };
    let checked = &json(&["check", &map, "--json"]);
    let found = &json(&["inspect", &map, "--json"])["findings"];
    for count in ["errors", "warnings", "information"] {
        assert_eq!(found[count], checked["counts"][count], "{count}: {found}");
    }
    let all: u64 = checked["findings"].as_array().expect("findings").len() as u64;
    let rules = found["by_rule"].as_array().expect("rules");
    assert_eq!(rules.iter().filter_map(|rule| rule["count"].as_u64()).sum::<u64>(), all);
    assert_eq!((&rules[0]["severity"], &rules[0]["count"]), (&"warning".into(), &10.into()));
    let page = text(&["inspect", &map]);
    let rule = rules[0]["rule"].as_str().expect("a rule");
    assert!(page.contains("findings      0 errors, 10 warnings, 8 of information; "), "{page}");
    assert!(page.contains(&format!("\n  warning       10: {rule}\n")), "{page}");
    let archive = folder.path().join("m.mapd").display().to_string();
    run(MAPD, &["compile", &map, "-o", &archive], "");
    assert_eq!(json(&["inspect", &archive, "--json"])["findings"], Value::Null);
    assert!(text(&["inspect", &archive]).contains("\nfindings      not in an archive: "));
}

#[test]
fn findings_of_one_rule_fold_after_three() {
    const COUNT: usize = 10;
    let folder = tempfile::tempdir().expect("a folder");
    let map = &odd_town(folder.path(), COUNT);
    let told = |text: &str| text.lines().filter(|line| line.contains(": warning[")).count();
    let folded = text(&["check", map]);
    assert_eq!(told(&folded), 3, "{folded}");
    assert!(folded.contains("\n9 more findings of these rules; --all tells each\n"), "{folded}");
    let all = text(&["check", map, "--all"]);
    assert_eq!(told(&all), COUNT, "{all}");
    assert!(!all.contains("--all"), "{all}");
    let compiled = run(
        MAPD,
        &["compile", map, "-o", folder.path().join("m.mapd").to_str().expect("text")],
        "",
    );
    let errors = String::from_utf8_lossy(&compiled.stderr).into_owned();
    assert_eq!(told(&errors), 3, "{errors}");
    assert!(errors.contains(": 7 more warnings; `--report` writes all\n"), "{errors}");
}

#[test]
fn negative_numbers_are_values_that_options_refuse_by_themselves() {
    let town = workspace().join("examples/maps/town.xodr").display().to_string();
    for (kind, option, expected) in [
        ("path", "--step", "expected a positive finite number of metres"),
        ("route", "--lane-change", "expected"),
        ("nearest", "--radius", "expected"),
    ] {
        let output = run(MAPD, &["query", &town, kind, option, "-1"], "");
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{option}: {told}");
        assert!(told.contains(expected) && !told.contains("unexpected argument"), "{told}");
    }
}
