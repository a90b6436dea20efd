//! The first page of help, `mapd -h`: what a newcomer looks for, on one screen of 24 lines and 80 columns.

use super::TOPICS;
use clap::Command;
use clap::builder::StyledStr;
use std::fmt::Write as _;

/// What stands on one line: names, and what they are for, where that is not what the command says of itself.
struct Line {
    names: &'static str,
    purpose: Option<&'static str>,
}

const fn own(names: &'static str) -> Line {
    Line { names, purpose: None }
}

const fn line(names: &'static str, purpose: &'static str) -> Line {
    Line { names, purpose: Some(purpose) }
}

/// Commands by what people want to do. A test looks for each of them.
const GROUPS: [(&str, &[Line]); 5] = [
    (
        "Serve",
        &[
            line("--load FILE...", "Serve maps or folders; --watch follows changes"),
            own("status"),
            own("reload"),
            line("rollback, activate", "Serve the generation before, or the staged one"),
            line("overlay", "Say what is so on the road today: closed, slower"),
        ],
    ),
    (
        "Check",
        &[
            line("check", "List all that is wrong with an OpenDRIVE file"),
            own("inspect"),
            own("view"),
        ],
    ),
    ("Ask", &[own("query"), line("match", "Find the lanes of a recorded trace, by CSV, too")]),
    (
        "Compile",
        &[own("compile"), own("export"), line("sign", "Sign archives and entries of overlays")],
    ),
    (
        "Operate",
        &[
            own("doctor"),
            own("bench"),
            line("completions, man", "Write completions of a shell, or the man pages"),
        ],
    ),
];

/// Columns where there is no terminal that says how many it has.
const COLUMNS: usize = 80;

/// Where names and purposes begin.
const NAMES: usize = 9;
const PURPOSES: usize = 29;

/// The page, as wide as the terminal but no wider than `most` columns.
pub(super) fn page(program: &Command, most: usize) -> StyledStr {
    let columns = columns().min(most);
    let styles = program.get_styles();
    let (header, literal) = (styles.get_header(), styles.get_literal());
    let mut page = String::new();
    let about = program.get_about().map(ToString::to_string).unwrap_or_default();
    wrap(&mut page, &about, 0, 0, columns);
    let usage = "mapd --load FILE... [OPTIONS], or mapd COMMAND [OPTIONS]";
    let _ = write!(page, "\n{header}Usage:{header:#} ");
    wrap(&mut page, usage, 7, 7, columns);
    page.push('\n');
    for (group, lines) in GROUPS {
        let mut group = group;
        for Line { names, purpose } in lines {
            let of_command =
                || program.find_subcommand(names)?.get_about().map(ToString::to_string);
            let purpose = purpose.map(str::to_owned).or_else(of_command).unwrap_or_default();
            let _ = write!(page, "{header}{group}{header:#}{:1$}", "", NAMES - group.len());
            let gap = PURPOSES - NAMES - names.len();
            let _ = write!(page, "{literal}{names}{literal:#}{:gap$}", "");
            wrap(&mut page, &purpose, PURPOSES, PURPOSES.min(columns / 3), columns);
            group = "";
        }
    }
    page.push('\n');
    let topics: Vec<&str> = TOPICS.iter().map(|(topic, _)| *topic).collect();
    let more = format!(
        "mapd --help lists all options, mapd help COMMAND explains a command, and mapd help TOPIC one of {}.",
        topics.join(", ")
    );
    wrap(&mut page, &more, 0, 0, columns);
    page.into()
}

/// Columns of the terminal; where there is none, those that the environment names.
fn columns() -> usize {
    let terminal = terminal_size::terminal_size().map(|(width, _)| usize::from(width.0));
    let told = || std::env::var("COLUMNS").ok()?.parse().ok();
    let is_some = |columns: &usize| *columns > 0;
    terminal.filter(is_some).or_else(told).filter(is_some).unwrap_or(COLUMNS)
}

/// Appends words to a line that has `at` characters; further lines are indented.
fn wrap(page: &mut String, text: &str, at: usize, indent: usize, columns: usize) {
    let mut at = at;
    let mut is_first = true;
    for word in text.split_whitespace() {
        let length = word.chars().count();
        if is_first {
            at += length;
        } else if at + 1 + length <= columns {
            page.push(' ');
            at += 1 + length;
        } else {
            let _ = write!(page, "\n{:indent$}", "");
            at = indent + length;
        }
        page.push_str(word);
        is_first = false;
    }
    page.push('\n');
}
