//! Every public function of the Rust client has a form in C, or a reason why it has none: `forms.txt`.
//!
//! Functions are found in the sources as rustfmt writes them: `pub fn` in an `impl` of a type that a library or a public module of it
//! exports, or a free one that it exports.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// What they export is the client's.
const LIBRARIES: [&str; 2] = ["client", "query"];
/// Where that may lie.
const SOURCES: [&str; 3] = ["client", "query", "transport"];

fn source(of: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(of).join("src")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn files(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap().flatten() {
        let path = entry.path();
        if path.is_dir() {
            files(&path, into);
        } else if path.extension().is_some_and(|end| end == "rs") {
            into.push(path);
        }
    }
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty())
}

/// What a file names in `pub use`.
fn used(text: &str, into: &mut BTreeSet<String>) {
    for used in text.split("pub use ").skip(1) {
        let used = used.split(';').next().unwrap_or_default();
        into.extend(words(used).map(str::to_owned));
    }
}

/// The file of a module that a library's own file declares.
fn module(library: &str, name: &str) -> PathBuf {
    let flat = source(library).join(format!("{name}.rs"));
    if flat.exists() { flat } else { source(library).join(name).join("mod.rs") }
}

/// What the libraries export: all that they, their public modules and the groups of names in `groups.rs` name in `pub use`, and what
/// public modules define themselves.
fn exported() -> BTreeSet<String> {
    let mut all = BTreeSet::new();
    for library in LIBRARIES {
        let text = read(&source(library).join("lib.rs"));
        used(&text, &mut all);
        for line in text.lines() {
            let declared = line.strip_suffix(';').unwrap_or_default();
            if let Some(name) = declared.strip_prefix("pub mod ") {
                let text = read(&module(library, name));
                used(&text, &mut all);
                all.extend(text.lines().filter_map(item).map(str::to_owned));
            } else if declared == "mod groups" {
                used(&read(&module(library, "groups")), &mut all);
            }
        }
    }
    all
}

/// The type, trait or function that a line of a module begins to define for all.
fn item(line: &str) -> Option<&str> {
    let rest = line.strip_prefix("pub ")?;
    let kinds = ["struct ", "enum ", "union ", "trait ", "type "];
    let named = kinds.iter().find_map(|kind| rest.strip_prefix(kind));
    named.map_or_else(|| defined(line), |name| words(name).next())
}

/// The name of a function that a line begins to define.
fn defined(line: &str) -> Option<&str> {
    let rest = line.strip_prefix("pub ")?;
    let rest = rest.strip_prefix("const ").unwrap_or(rest);
    words(rest.strip_prefix("fn ")?).next()
}

/// The type that an `impl` without a trait is of.
fn implemented(line: &str) -> Option<&str> {
    let rest = line.strip_prefix("impl")?;
    let rest = match rest.strip_prefix('<') {
        Some(generic) => generic.split_once("> ")?.1,
        None => rest.trim_start(),
    };
    if rest.contains(" for ") { None } else { words(rest).next() }
}

/// Every public function by its type; `-` for those without one.
fn functions() -> BTreeSet<(String, String)> {
    let exported = exported();
    let mut all = BTreeSet::new();
    let mut sources = Vec::new();
    SOURCES.iter().for_each(|folder| files(&source(folder), &mut sources));
    for path in sources {
        let mut of = None;
        for line in read(&path).lines().take_while(|line| *line != "#[cfg(test)]") {
            if line.starts_with("impl") {
                of = implemented(line).filter(|of| exported.contains(*of)).map(str::to_owned);
            } else if line == "}" {
                of = None;
            }
            if let Some(name) = defined(line).filter(|name| exported.contains(*name)) {
                all.insert(("-".to_owned(), name.to_owned()));
            }
            if let (Some(of), Some(name)) = (&of, line.strip_prefix("    ").and_then(defined)) {
                all.insert((of.clone(), name.to_owned()));
            }
        }
    }
    all
}

/// Functions of the C header.
fn header() -> BTreeSet<String> {
    let text = read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("include/mapd.h"));
    text.lines()
        .filter(|line| !line.starts_with([' ', '*', '/']))
        .filter_map(|line| line.split_once('('))
        .filter_map(|(before, _)| words(before).last())
        .filter(|word| word.starts_with("mapd_"))
        .map(str::to_owned)
        .collect()
}

#[test]
fn every_function_has_a_form_or_a_reason() {
    let (functions, header) = (functions(), header());
    assert!(functions.len() > 500 && header.len() > 120, "{} {}", functions.len(), header.len());
    let mut wrong = Vec::new();
    let (mut explicit, mut whole) = (BTreeSet::new(), BTreeMap::new());
    let mut named = BTreeSet::new();
    let table = read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/forms.txt"));
    for line in table.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let (left, form) = line.split_once(": ").unwrap_or((line, ""));
        let mut left = left.split_whitespace();
        let of = left.next().unwrap_or_default().to_owned();
        for name in left {
            if name == "*" {
                whole.insert(of.clone(), false);
            } else if !explicit.insert((of.clone(), name.to_owned())) {
                wrong.push(format!("{of} {name} is there twice"));
            }
        }
        match form.strip_prefix("- ") {
            Some(reason) if !reason.is_empty() => {}
            Some(_) => wrong.push(format!("no reason: {line}")),
            None if form.is_empty() => wrong.push(format!("no form: {line}")),
            None => named.extend(form.split_whitespace().map(str::to_owned)),
        }
    }
    for one in &functions {
        let (of, name) = one;
        match whole.get_mut(of) {
            _ if explicit.contains(one) => {}
            Some(is_used) => *is_used = true,
            None => wrong.push(format!("{of}::{name} has neither a form in C nor a reason")),
        }
    }
    let gone = explicit.difference(&functions);
    wrong.extend(gone.map(|(of, name)| format!("the client has no {of}::{name}")));
    let idle = whole.iter().filter(|(_, is_used)| !**is_used);
    wrong.extend(idle.map(|(of, _)| format!("{of} * stands for nothing")));
    wrong.extend(named.difference(&header).map(|name| format!("the header has no {name}")));
    wrong.extend(header.difference(&named).map(|name| format!("{name} is no form of anything")));
    assert!(wrong.is_empty(), "forms.txt:\n{}", wrong.join("\n"));
}
