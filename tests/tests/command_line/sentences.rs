//! Sentences of the pages and of `--help` are short enough to be read once.

use mapd_tests::workspace;
use std::fs;

/// Most words of a sentence; a piece of code is one word.
const MOST_WORDS: usize = 38;

/// Most words of a table's cell, which has no sentences to pause at.
const MOST_WORDS_OF_A_CELL: usize = 42;

/// Pages made of other tables, whose texts are reviewed there.
const GENERATED: [&str; 3] = ["coverage.md", "format.md", "rules.md"];

/// Whether a line begins a list's item: what is behind its mark.
fn item(line: &str) -> Option<&str> {
    let number = line.trim_start_matches(|c: char| c.is_ascii_digit());
    let behind = |rest: &str, mark: &str| rest.strip_prefix(mark).map(str::len);
    let length = behind(line, "- ").or_else(|| behind(line, "* "));
    let length = length.or_else(|| (number.len() < line.len()).then(|| behind(number, ". "))?)?;
    Some(&line[line.len() - length..])
}

/// Paragraphs and items of a page; no code, tables and headings.
fn paragraphs(page: &str) -> Vec<String> {
    let mut all = vec![String::new()];
    let mut is_code = false;
    for line in page.lines().map(str::trim) {
        let is_fence = line.starts_with("```");
        is_code ^= is_fence;
        if is_code || is_fence || line.is_empty() || line.starts_with(['|', '#', '<']) {
            all.push(String::new());
            continue;
        }
        if item(line).is_some() {
            all.push(String::new());
        }
        let last = all.last_mut().expect("there is always one");
        last.push_str(item(line).unwrap_or(line));
        last.push(' ');
    }
    all
}

/// A text in which each piece of code, and each address of a link, is one word or none.
fn spoken(text: &str) -> String {
    let mut out = String::new();
    for (i, part) in text.split('`').enumerate() {
        out.push_str(if i % 2 == 0 { part } else { "code" });
    }
    while let Some(at) = out.find("](") {
        let Some(end) = out[at..].find(')') else { break };
        out.replace_range(at..=at + end, "");
    }
    out
}

/// Words of each sentence that has too many, with its text.
fn too_long(paragraph: &str) -> Vec<String> {
    let mut long = Vec::new();
    let mut words = Vec::new();
    let text = spoken(paragraph);
    let mut rest = text.split_whitespace().peekable();
    while let Some(word) = rest.next() {
        if word.contains(char::is_alphanumeric) {
            words.push(word);
        }
        let is_end = word.trim_end_matches(['"', '*', ')']).ends_with(['.', '!', '?']);
        if is_end || rest.peek().is_none() {
            if words.len() > MOST_WORDS {
                long.push(format!("{} words: {}", words.len(), words.join(" ")));
            }
            words.clear();
        }
    }
    long
}

/// Cells of tables with too many words.
fn long_cells(page: &str) -> Vec<String> {
    let rows = page.lines().filter(|line| line.starts_with('|')).map(spoken);
    let cells = rows.flat_map(|row| row.split('|').map(str::to_owned).collect::<Vec<_>>());
    let count = |cell: &str| {
        cell.split_whitespace().filter(|word| word.contains(char::is_alphanumeric)).count()
    };
    cells.filter(|cell| count(cell) > MOST_WORDS_OF_A_CELL).collect()
}

/// Every sentence and every cell of a page is short enough.
fn check(name: &str, page: &str) {
    let cells = long_cells(page);
    assert!(
        cells.is_empty(),
        "{name} has cells of more than {MOST_WORDS_OF_A_CELL} words: {cells:#?}"
    );
    let long: Vec<String> = paragraphs(page).iter().flat_map(|text| too_long(text)).collect();
    assert!(long.is_empty(), "{name} has sentences of more than {MOST_WORDS} words: {long:#?}");
}

#[test]
fn pages() {
    let docs = fs::read_dir(workspace().join("docs")).expect("docs").flatten();
    let docs = docs.map(|entry| format!("docs/{}", entry.file_name().to_string_lossy()));
    let is_page = |name: &String| {
        name.ends_with(".md") && !GENERATED.iter().any(|other| name.ends_with(other))
    };
    let names = ["README.md", "ARCHITECTURE.md"].map(str::to_owned).into_iter().chain(docs);
    let names: Vec<String> = names.filter(is_page).collect();
    assert!(names.len() > 30, "{names:?} are too few to be all");
    for name in names {
        check(&name, &fs::read_to_string(workspace().join(&name)).expect("text"));
    }
}

/// Help of a command and of those below it: what each is, and what each of its arguments is.
fn help(command: &clap::Command, path: &str) {
    let name = format!("{path} {}", command.get_name());
    let own = [command.get_about(), command.get_long_about()].into_iter().flatten();
    let of_arguments = command.get_arguments().flat_map(|arg| {
        [arg.get_help(), arg.get_long_help()].into_iter().flatten().map(ToString::to_string)
    });
    for text in own.map(ToString::to_string).chain(of_arguments) {
        check(&name, &text);
    }
    for below in command.get_subcommands() {
        help(below, &name);
    }
}

#[test]
fn help_of_commands() {
    help(&mapd::cli::command(), "");
}

#[test]
fn what_is_too_long_is_found() {
    let sentence = |words: usize| format!("{}.", vec!["word"; words].join(" "));
    for (text, long) in [
        (sentence(MOST_WORDS), 0),
        (sentence(MOST_WORDS + 1), 1),
        (format!("Short. {} Short.", sentence(MOST_WORDS + 1)), 1),
        (format!("- {}\n- {}", sentence(MOST_WORDS), sentence(MOST_WORDS)), 0),
        (format!("1. {}\n   {}", "word ".repeat(MOST_WORDS), "word"), 1),
        (format!("```text\n{}\n```\n| {} |", sentence(99), sentence(99)), 0),
        (format!("`{}` and [a page](at some place) {}", sentence(99), sentence(5)), 0),
    ] {
        let found: Vec<String> = paragraphs(&text).iter().flat_map(|one| too_long(one)).collect();
        assert_eq!(found.len(), long, "{text:?}: {found:?}");
    }
    let row = |words: usize| format!("| name | {} |", "word ".repeat(words));
    assert_eq!(long_cells(&row(MOST_WORDS_OF_A_CELL)).len(), 0);
    assert_eq!(long_cells(&row(MOST_WORDS_OF_A_CELL + 1)).len(), 1);
}
