//! Every public function of the Rust client has a form in C, or a reason why it has none: `forms.txt`; in Python likewise: `src/python/tests/forms.txt`.
//!
//! Functions are found in the sources as rustfmt writes them: `pub fn` in an `impl` of a type that a library or a public module of it
//! exports, or a free one that it exports.
//!
//! Every function of C has a form in C++ or stands in a list here, and a test or an example calls it.

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

/// Functions of the C header that no header of C++ uses, and why.
const NOT_IN_CPP: [(&str, &str); 1] = [(
    "mapd_nearest_options_init",
    "NearestOptions has the defaults itself, so that it is constexpr",
)];

/// The text of files in a folder of this crate whose names end in one of these.
fn texts(folder: &str, ends: &[&str]) -> Vec<String> {
    let mut all = Vec::new();
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap().flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|end| ends.iter().any(|one| end == *one)) {
                all.push(read(&path));
            }
        }
    }
    all
}

/// Headers of C++, without comments.
fn cpp() -> Vec<String> {
    let code = |text: String| {
        text.lines()
            .filter(|line| !line.trim().starts_with("//"))
            .fold(String::new(), |all, line| all + line + "\n")
    };
    texts("include", &["hpp"]).into_iter().map(code).collect()
}

/// Names of C++ by whose call a function of C is called: the `try_f` in whose body it stands, and its `f`; of options the type.
fn wrappers(headers: &[String]) -> BTreeMap<String, BTreeSet<String>> {
    let mut all: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut of = "";
    for line in headers.iter().flat_map(|text| text.lines()) {
        let begun = line.split('(').next().unwrap_or_default();
        let named = words(begun).last().unwrap_or_default();
        if line.contains("struct ") || line.contains("class ") {
            of =
                words(line.split([':', '{']).next().unwrap_or_default()).last().unwrap_or_default();
        } else if line.contains("inline ")
            || (named.starts_with("try_") && line.ends_with(['{', ',']))
        {
            of = named.trim_start_matches("try_");
        }
        for name in words(line).filter(|word| word.starts_with("mapd_")) {
            all.entry(name.to_owned()).or_default().insert(of.to_owned());
        }
    }
    all
}

#[test]
fn every_function_is_in_cpp_or_has_a_reason() {
    let headers = cpp();
    let used: BTreeSet<&str> = headers.iter().flat_map(|text| words(text)).collect();
    let header = header();
    let excused: BTreeSet<&str> = NOT_IN_CPP.iter().map(|(name, _)| *name).collect();
    let missing: BTreeSet<&str> =
        header.iter().map(String::as_str).filter(|name| !used.contains(name)).collect();
    assert_eq!(missing, excused, "functions of C that C++ lacks, and those that have a reason");
    assert!(NOT_IN_CPP.iter().all(|(_, reason)| !reason.is_empty()));
}

#[test]
fn every_function_is_called_by_a_program() {
    let mut programs = texts("tests", &["c", "cpp", "h", "hpp"]);
    programs.extend(texts("../../examples/c", &["c"]));
    programs.extend(texts("../../examples/cpp", &["cpp", "hpp"]));
    let mut called = BTreeSet::new();
    for text in &programs {
        let is_named =
            |word: &&str| word.starts_with("mapd_") || word.starts_with(char::is_uppercase);
        called.extend(words(text).filter(is_named));
        for (at, _) in text.match_indices('(') {
            let before = text[..at].rsplit(|c: char| !c.is_alphanumeric() && c != '_').next();
            called.extend(before.map(|name| name.trim_start_matches("try_")));
        }
    }
    let wrappers = wrappers(&cpp());
    let is_called = |name: &str| {
        let by = |names: &BTreeSet<String>| names.iter().any(|name| called.contains(name.as_str()));
        called.contains(name) || wrappers.get(name).is_some_and(by)
    };
    let header = header();
    let missing: Vec<&str> =
        header.iter().map(String::as_str).filter(|name| !is_called(name)).collect();
    assert!(missing.is_empty(), "no program calls {missing:?}");
}

/// What a table of forms says that the sources do not, and what it leaves out: `same` are functions that need no line, `forms` what there is,
/// `needed` of these what must be the form of something.
fn wrong_in(
    table: &str,
    language: &str,
    same: impl Fn(&(String, String)) -> bool,
    forms: &BTreeSet<String>,
    needed: &BTreeSet<String>,
) -> Vec<String> {
    let functions = functions();
    assert!(functions.len() > 500 && needed.len() > 120, "{} {}", functions.len(), needed.len());
    let mut wrong = Vec::new();
    let (mut explicit, mut whole) = (BTreeSet::new(), BTreeMap::new());
    let mut named = BTreeSet::new();
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
            _ if same(one) => {
                named.insert(format!("{of}.{name}"));
            }
            Some(is_used) => *is_used = true,
            None => {
                wrong.push(format!("{of}::{name} has neither a form in {language} nor a reason"))
            }
        }
    }
    let gone = explicit.difference(&functions);
    wrong.extend(gone.map(|(of, name)| format!("the client has no {of}::{name}")));
    let idle = whole.iter().filter(|(_, is_used)| !**is_used);
    wrong.extend(idle.map(|(of, _)| format!("{of} * stands for nothing")));
    wrong.extend(named.difference(forms).map(|name| format!("{language} has no {name}")));
    wrong.extend(needed.difference(&named).map(|name| format!("{name} is no form of anything")));
    wrong
}

#[test]
fn every_function_has_a_form_in_c_or_a_reason() {
    let header = header();
    let table = read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/forms.txt"));
    let wrong = wrong_in(&table, "C", |_| false, &header, &header);
    assert!(wrong.is_empty(), "forms.txt:\n{}", wrong.join("\n"));
}

/// Classes, methods, fields and functions of a file of Python, as `Class`, `Class.method` and `function`, with a prefix; private ones are left out.
fn of_python(file: &str, prefix: &str) -> BTreeSet<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../python/python/mapd");
    let (mut all, mut of) = (BTreeSet::new(), String::new());
    for line in read(&folder.join(file)).lines().filter(|line| !line.is_empty()) {
        let (inside, line) = match line.strip_prefix("    ") {
            // Of a function's parameters.
            Some(_) if of.is_empty() => continue,
            Some(line) => (format!("{of}."), line),
            None => (prefix.to_owned(), line),
        };
        if inside == prefix {
            of.clear();
        }
        if let Some(name) = line.strip_prefix("class ").and_then(|rest| words(rest).next()) {
            of = name.to_owned();
        }
        let named = line.strip_prefix("class ").or_else(|| line.strip_prefix("def "));
        let field = || line.split_once(": ").map(|(name, _)| name);
        let name = named.and_then(|rest| words(rest).next()).or_else(field);
        let is_name = |name: &&str| {
            !name.starts_with('_') && name.chars().all(|c| c.is_alphanumeric() || c == '_')
        };
        all.extend(name.filter(is_name).map(|name| format!("{inside}{name}")));
    }
    all
}

#[test]
fn every_function_has_a_form_in_python_or_a_reason() {
    let compiled = of_python("_mapd.pyi", "");
    let methods = |name: &&String| name.contains('.') || name.starts_with(char::is_lowercase);
    let needed: BTreeSet<String> = compiled.iter().filter(methods).cloned().collect();
    let mut forms = compiled;
    for (file, prefix) in
        [("_results.py", ""), ("_columns.py", ""), ("_compile.py", ""), ("raw.py", "raw.")]
    {
        forms.extend(of_python(file, prefix));
    }
    let table = read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../python/tests/forms.txt"));
    let same = |(of, name): &(String, String)| needed.contains(&format!("{of}.{name}"));
    let wrong = wrong_in(&table, "Python", same, &forms, &needed);
    assert!(wrong.is_empty(), "src/python/tests/forms.txt:\n{}", wrong.join("\n"));
}
