//! Options of the command line and the docs name each other: none is forgotten, and none is named that is gone.

use mapd_tests::workspace;
use std::collections::BTreeSet;
use std::fs;

/// Pages made of other tables, which say nothing of options.
const GENERATED: [&str; 3] = ["coverage.md", "format.md", "rules.md"];

/// Options of other programs that docs name by themselves: of `cargo test`, and of `kill_everywhere`.
const OF_OTHERS: [&str; 4] = ["--test", "--victim", "--call", "--moments"];

/// An option, and the command that has it.
struct Named {
    /// `mapd`, or `mapd compile`.
    command: String,
    /// As it is written: `--output`, `-o`.
    forms: Vec<String>,
}

/// Options of a command and of those below it, as `--help` lists them.
fn options(command: &clap::Command, path: &str, all: &mut Vec<Named>) {
    for option in command.get_arguments().filter(|option| !option.is_hide_set()) {
        let long = option.get_long().filter(|long| !["help", "version"].contains(long));
        if let Some(long) = long {
            let short = option.get_short().map(|short| format!("-{short}"));
            let forms = [format!("--{long}")].into_iter().chain(short).collect();
            all.push(Named { command: path.to_owned(), forms });
        }
    }
    for below in command.get_subcommands().filter(|below| !below.is_hide_set()) {
        options(below, &format!("{path} {}", below.get_name()), all);
    }
}

/// Everything that a command or one below it understands.
fn understood(command: &clap::Command, all: &mut BTreeSet<String>) {
    for option in command.get_arguments() {
        let names =
            option.get_long().into_iter().chain(option.get_all_aliases().unwrap_or_default());
        all.extend(names.map(|name| format!("--{name}")));
    }
    for below in command.get_subcommands() {
        understood(below, all);
    }
}

/// Name and text of each page of the docs.
fn pages() -> Vec<(String, String)> {
    let entries = fs::read_dir(workspace().join("docs")).expect("docs").flatten();
    let files =
        entries.map(|entry| entry.path()).filter(|p| p.extension().is_some_and(|e| e == "md"));
    let page = |path: std::path::PathBuf| {
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        (name, fs::read_to_string(path).expect("text"))
    };
    files.map(page).filter(|(name, _)| !GENERATED.contains(&name.as_str())).collect()
}

/// Whether a text has this as a word of code: what follows is no part of an option's or command's name.
fn says(text: &str, word: &str) -> bool {
    text.match_indices(word).any(|(at, _)| {
        let before =
            text[..at].chars().next_back().is_none_or(|c| !c.is_alphanumeric() && c != '-');
        let after = text[at + word.len()..].chars().next();
        before && after.is_none_or(|c| !c.is_alphanumeric() && c != '-' && c != '_')
    })
}

/// How a page speaks of a command.
fn speaks_of(text: &str, command: &str) -> bool {
    match command {
        "mapd" => ["mapd --load", "mapd --config"].iter().any(|form| says(text, form)),
        command => says(text, command),
    }
}

/// Every option stands on a page that speaks of its command.
#[test]
fn every_option_is_on_a_page() {
    let mut all = Vec::new();
    options(&mapd::cli::command(), "mapd", &mut all);
    assert!(all.len() > 100, "{} options are too few to be all", all.len());
    let pages = pages();
    let is_told = |named: &&Named| {
        pages.iter().any(|(_, text)| {
            speaks_of(text, &named.command) && named.forms.iter().any(|form| says(text, form))
        })
    };
    let forgotten: Vec<String> = all
        .iter()
        .filter(|named| !is_told(named))
        .map(|named| format!("{} {}", named.command, named.forms[0]))
        .collect();
    assert!(forgotten.is_empty(), "no page of docs/ names {forgotten:#?}");
}

/// Every option that a page or the README names by itself exists.
#[test]
fn no_page_names_an_option_that_is_gone() {
    let mut known: BTreeSet<String> = OF_OTHERS.map(str::to_owned).into();
    known.extend(["--help", "--version"].map(str::to_owned));
    understood(&mapd::cli::command(), &mut known);
    let readme = fs::read_to_string(workspace().join("README.md")).expect("text");
    let mut pages = pages();
    pages.push(("README.md".to_owned(), readme));
    let mut gone = Vec::new();
    for (page, text) in &pages {
        for code in text.split('`').skip(1).step_by(2).filter(|code| code.starts_with("--")) {
            let end = code.find(|c: char| !c.is_alphanumeric() && c != '-').unwrap_or(code.len());
            if !known.contains(&code[..end]) {
                gone.push(format!("{page}: {code}"));
            }
        }
    }
    assert!(gone.is_empty(), "options that nothing has: {gone:#?}");
}
