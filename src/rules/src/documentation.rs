//! The catalog as text for people: `docs/rules.md` and a page of examples for each group.

use crate::catalog;
use crate::example::Example;
use crate::rule::{NEWEST, Rule};
use crate::settings::{Profile, Settings};
use crate::structural::{KEPT, LEFT_OUT, STRUCTURAL};
use mapd_xodr::Severity;
use std::fmt::Write as _;

/// What an error is, wherever the documentation says it.
pub const ERROR: &str = "An error takes the smallest part that contains it out of the map, or rejects the map; the profile decides what is an error.";

const HEAD: [&str; 2] = [
    "# Rules

Written by `cargo run -p mapd-rules --example rules_doc` from the catalog in `src/rules/src/catalog/`; change that instead.

This page lists every rule that mapd checks, with its severity in each profile. ",
    " A warning is for what the standard forbids and mapd can use
all the same, or for what is allowed and hardly meant; information is allowed and worth knowing.

| profile | rules | severity |
|---|---|---|
| `default` | all | as below: only what cannot be used is an error |
| `strict` | all | as below, in the second column: everything that the standard forbids is an error |
| `asam` | those with an id of ASAM's, from the version in the id on, and those of reading and building | as below, in the third column: as in ASAM's checker if it has the rule; otherwise error, and warning for recommendations |

A configuration file turns single rules off or changes their severity; see [checks.md](checks.md#rules). The tables have the severity of the worst finding: of what reading finds,
the default profile has an error only where something cannot be built, and a warning elsewhere.
",
];

fn word(severity: Severity) -> &'static str {
    match severity {
        Severity::Info => "information",
        Severity::Warning => "warning",
        Severity::Error => "error",
    }
}

/// Name of a group's page.
fn page(title: &str) -> String {
    title.to_lowercase().replace([' ', ','], "-").replace("--", "-")
}

fn versions(rule: &Rule) -> String {
    match (rule.since, rule.until) {
        (4, NEWEST) => "all".to_owned(),
        (since, NEWEST) => format!("from 1.{since}"),
        (4, until) => format!("to 1.{until}"),
        (since, until) if since == until => format!("1.{since}"),
        (since, until) => format!("1.{since} to 1.{until}"),
    }
}

fn tolerances(rule: &Rule) -> String {
    let bounds = rule.tolerances.iter().map(|t| format!("{} {} {}", t.name, t.value, t.unit));
    bounds.map(|bound| bound.trim_end().to_owned()).collect::<Vec<_>>().join("; ")
}

/// In `docs/checks.md`, what stands between these two lines is written from the catalog.
const ERRORS: [&str; 2] = ["<!-- errors of the catalog -->", "<!-- end -->"];

/// Rules whose findings take a part out, with the reason why it cannot be used: a table of `docs/checks.md`.
fn errors() -> String {
    let mut table = "\n| rule | the part cannot be used, because |\n|---|---|\n".to_owned();
    for rule in catalog::all().filter(|rule| !rule.because.is_empty()) {
        // Writing to a string cannot fail.
        let _ = writeln!(table, "| `{}` | {} |", rule.id, rule.because);
    }
    table + "\n"
}

/// `docs/checks.md` with the list of errors that the catalog yields; none where it has no place for one.
pub fn with_errors(page: &str) -> Option<String> {
    let (before, rest) = page.split_once(ERRORS[0])?;
    let (_, after) = rest.split_once(ERRORS[1])?;
    Some(format!("{before}{}\n{}{}{after}", ERRORS[0], errors(), ERRORS[1]))
}

/// A page of the documentation.
pub struct Page {
    /// Its path from `docs/`.
    pub path: String,
    /// Its text.
    pub text: String,
}

/// Every page of the documentation.
pub fn documentation() -> Vec<Page> {
    let mut index = HEAD.join(ERROR);
    let mut pages = Vec::new();
    let asam = Settings { profile: Profile::Asam, ..Settings::default() };
    for (title, slices) in catalog::GROUPS {
        let page = page(title);
        // Writing to a string cannot fail.
        let _ = write!(
            index,
            "\n## {title}\n\nWith examples: [rules/{page}.md](rules/{page}.md)\n\n| rule | default | strict | asam | versions | what must hold | bounds |\n|---|---|---|---|---|---|---|\n"
        );
        let mut text = format!(
            "# {title}\n\nWritten by `cargo run -p mapd-rules --example rules_doc`; see [rules.md](../rules.md).\n"
        );
        for rule in slices.iter().copied().flatten() {
            let advisory = if rule.advisory { " (recommended)" } else { "" };
            let _ = writeln!(
                index,
                "| `{}` | {} | {} | {} | {} | {}{advisory} | {} |",
                rule.id,
                word(rule.severity),
                word(rule.strict),
                asam.severity(rule).map_or("–", word),
                versions(rule),
                rule.meaning,
                tolerances(rule),
            );
            let _ = write!(text, "\n## `{}`\n\n{}\n", rule.id, rule.meaning);
            if rule.fixed {
                let _ = write!(text, "\nIts severity cannot be changed: {}.\n", rule.because);
            }
            if !rule.aliases.is_empty() {
                let _ = write!(text, "\nAlso `{}`.\n", rule.aliases.join("`, `"));
            }
            for (name, example) in [("Valid", rule.valid), ("Invalid", rule.invalid)] {
                let snippet = example.snippet();
                if let Example::Words(words) = example {
                    let _ = write!(text, "\n{name}: {words}.\n");
                    continue;
                }
                let snippet = if snippet.is_empty() { "<!-- nothing -->" } else { snippet };
                let _ =
                    write!(text, "\n{name}, in `{}`:\n\n```xml\n{snippet}\n```\n", example.place());
            }
        }
        pages.push(Page { path: format!("rules/{page}.md"), text });
    }
    index.push_str("\n## Rules of the schema\n\nThe schema contains these rules; reading reports them.\n\n| rules | finding | about |\n|---|---|---|\n");
    for entry in STRUCTURAL {
        let _ = writeln!(
            index,
            "| `{}` | `{}` | {} |",
            entry.ids.join("`, `"),
            entry.by,
            entry.subject
        );
    }
    let others = [
        ("Rules that mapd ensures in other ways", "by", KEPT),
        ("Rules that mapd does not check", "reason", LEFT_OUT),
    ];
    for (title, column, list) in others {
        let _ = write!(index, "\n## {title}\n\n| rule | {column} |\n|---|---|\n");
        for (id, reason) in list {
            let _ = writeln!(index, "| `{id}` | {reason} |");
        }
    }
    pages.insert(0, Page { path: "rules.md".to_owned(), text: index });
    pages
}
