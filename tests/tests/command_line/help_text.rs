//! `mapd help`: topics, commands of commands, suggestions; and docs/api/mapd.txt, which lists all that the command line takes, so that every change of it
//! is seen. `MAPD_UPDATE=1 cargo test --workspace --test command_line -- help_text::` writes that page again.

use mapd_tests::command::run;
use mapd_tests::workspace;
use std::fmt::Write as _;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Width of the page.
const WIDTH: usize = 150;

fn check(args: &[&str], code: i32, expected: &str) {
    let output = run(MAPD, args, "");
    let told = format!(
        "{}{}",
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
    assert_eq!(output.status.code(), Some(code), "{args:?}: {told}");
    assert!(told.contains(expected), "{args:?}: {told}");
    assert!(!told.contains('\u{1b}'), "colours in a pipe: {told}");
}

#[test]
fn topics_and_commands_are_explained() {
    for (args, code, expected) in [
        (&["help"][..], 0, "Usage: mapd [OPTIONS]"),
        (&["help", "query"], 0, "Usage: mapd query"),
        (&["help", "overlay", "apply"], 0, "Usage: mapd overlay <NAME> apply"),
        (&["help", "sources"], 0, "shm:NAME"),
        (&["help", "units"], 0, "counter-clockwise from the x axis"),
        (&["help", "exit-codes"], 0, "accepted, and parts of the map are left out"),
        (&["help", "environment"], 0, "NO_COLOR"),
        (&["help", "files"], 0, "mapd.toml"),
        (&["help", "help"], 0, "Topics: sources, units, exit-codes, environment, files"),
        (&["help", "qeury"], 2, "'query'"),
        (&["help", "overlay", "aply"], 2, "overlay has no command aply; did you mean \"apply\"?"),
        (&["help", "overlay", "x"], 2, "overlay has no command x\n"),
    ] {
        check(args, code, expected);
    }
}

/// Texts that are printed as they are.
#[test]
fn topics_and_tables_fit_a_terminal() {
    for topic in ["sources", "units", "exit-codes", "environment", "files", "query"] {
        let output = run(MAPD, &["help", topic], "");
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        // Options and paragraphs are as wide as the terminal.
        let (_, table) = text.split_once("\nKinds, with").unwrap_or(("", &text));
        let (table, _) = table.split_once("\nMetres and").unwrap_or((table, ""));
        let long: Vec<&str> = table.lines().filter(|line| line.chars().count() > 80).collect();
        assert!(long.is_empty() && table.lines().count() > 5, "{topic}: {long:?}");
    }
}

#[test]
fn the_nearest_word_is_suggested() {
    for (args, meant) in [
        (&["chekc"][..], "'check'"),
        (&["check", "m.xodr", "--formt", "json"], "'--format'"),
        (&["query", "m.xodr", "neerest"], "'nearest'"),
        (&["query", "m.xodr", "route", "--vehicle", "buss"], "did you mean \"bus\"?"),
    ] {
        check(args, 2, meant);
    }
    let town = mapd_tests::carried("town.xodr").display().to_string();
    check(&["query", &town, "nearest"], 2, "needs the columns x,y or lat,lon, the input has none");
    check(&["query", &town, "nearest", "--types", "drivng"], 2, "did you mean \"driving\"?");
}

/// Long help of a command and of those below it.
fn write(command: &mut clap::Command, page: &mut String) {
    let name = command.get_bin_name().unwrap_or(command.get_name()).to_owned();
    let help = command.render_long_help();
    writeln!(page, "== {name}\n\n{help}").expect("text");
    for below in command.get_subcommands_mut().filter(|below| !below.is_hide_set()) {
        write(below, page);
    }
}

#[test]
fn the_page_lists_what_the_command_line_takes() {
    let mut command = mapd::cli::command().term_width(WIDTH);
    command.build();
    let mut page = String::new();
    write(&mut command, &mut page);
    let path = workspace().join("docs/api/mapd.txt");
    if std::env::var_os("MAPD_UPDATE").is_some() {
        std::fs::write(&path, &page).expect("written");
    }
    let listed = std::fs::read_to_string(&path).unwrap_or_default();
    let differs = page.lines().zip(listed.lines()).find(|(is, was)| is != was);
    assert!(page == listed, "{}: {differs:?}", path.display());
}
