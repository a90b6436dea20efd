//! The compiler's modules import each other only in the order that ARCHITECTURE.md states.

use mapd_tests::workspace;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// What stands before the list of modules on the page.
const LIST: &str = "Inside the compiler, each module imports only those above it:";
/// What stands before the names of those that all may import.
const SHARED: &str = "All of them may import ";

/// The order of the page: the line of each module; those of one line do not import each other. And what all may import.
struct Order {
    lines: BTreeMap<String, usize>,
    shared: BTreeSet<String>,
}

impl Order {
    fn of(page: &str) -> Self {
        let (_, list) = page.split_once(LIST).expect("the list");
        let mut blocks = list.split("```");
        let block = blocks.nth(1).expect("a block").trim_start_matches("text");
        let mut lines = BTreeMap::new();
        for (number, line) in block.lines().enumerate() {
            let names = line.split("  ").next().unwrap_or_default();
            for name in names.split(", ").map(str::trim).filter(|name| !name.is_empty()) {
                assert_eq!(lines.insert(name.to_owned(), number), None, "{name} is listed twice");
            }
        }
        let (_, shared) = list.split_once(SHARED).expect("what is shared");
        let sentence = shared.split('.').next().unwrap_or_default();
        let shared = sentence.split('`').skip(1).step_by(2).map(str::to_owned).collect();
        Self { lines, shared }
    }

    /// Whether a module may import another one.
    fn allows(&self, from: &str, to: &str) -> bool {
        let line = |name: &str| self.lines.get(name);
        from == to
            || self.shared.contains(to)
            || line(from).zip(line(to)).is_some_and(|(from, to)| to < from)
    }
}

/// Modules of the crate that a source names by `crate::`, lists in braces too.
fn imports(source: &str) -> BTreeSet<String> {
    let code: Vec<_> = source.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
    let code = code.join("\n");
    let name_at = |text: &str| {
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
        text.chars().take_while(|c| is_part(*c)).collect::<String>()
    };
    let mut out = BTreeSet::new();
    for (at, found) in code.match_indices("crate::") {
        if code[..at].ends_with('$') {
            continue;
        }
        let rest = &code[at + found.len()..];
        let Some(list) = rest.strip_prefix('{') else {
            out.insert(name_at(rest));
            continue;
        };
        let (mut depth, mut begins) = (1, true);
        for (i, c) in list.char_indices() {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                ',' if depth == 1 => begins = true,
                _ if begins && !c.is_whitespace() => {
                    begins = false;
                    out.insert(name_at(&list[i..]));
                }
                _ => {}
            }
            if depth == 0 {
                break;
            }
        }
    }
    out
}

/// Sources of a module: a file, or all below a folder.
fn sources(path: &Path, out: &mut Vec<(String, String)>) {
    if path.is_dir() {
        for entry in fs::read_dir(path).expect("a folder").flatten() {
            sources(&entry.path(), out);
        }
    } else {
        let text = fs::read_to_string(path).expect("readable");
        out.push((path.display().to_string(), text));
    }
}

#[test]
fn modules_import_in_the_order_of_the_page() {
    let root = workspace();
    let order = Order::of(&fs::read_to_string(root.join("ARCHITECTURE.md")).expect("the page"));
    let (mut modules, mut strays, mut arrows) = (BTreeSet::new(), Vec::new(), BTreeSet::new());
    for entry in fs::read_dir(root.join("src/compiler/src")).expect("a folder").flatten() {
        let name = entry.path().file_stem().expect("a name").to_string_lossy().into_owned();
        if name == "lib" {
            continue;
        }
        let mut files = Vec::new();
        sources(&entry.path(), &mut files);
        for (file, text) in &files {
            for to in imports(text) {
                if !order.allows(&name, &to) {
                    strays.push(format!("{file}: {to}"));
                }
                arrows.insert((name.clone(), to));
            }
        }
        modules.insert(name);
    }
    assert!(strays.is_empty(), "against the page's order:\n{}", strays.join("\n"));
    // What is listed is there, all of it, and the scan has seen arrows.
    let listed: BTreeSet<_> = order.lines.keys().chain(&order.shared).cloned().collect();
    assert_eq!(modules, listed);
    assert!(arrows.len() > 20, "{arrows:?}");
}

#[test]
fn imports_are_found_in_lists_and_paths() {
    let source = "use crate::draft::{a, b};\nuse crate::{graph::{x, y}, index};\n// crate::no\nlet a = crate::lower::f();";
    let found: Vec<_> = imports(source).into_iter().collect();
    assert_eq!(found, ["draft", "graph", "index", "lower"]);
}

#[test]
fn an_arrow_upwards_is_found() {
    let page = format!("{LIST}\n\n```text\na     one\nb, c  two\n```\n\n{SHARED}`d` and `e`.\n");
    let order = Order::of(&page);
    for (from, to, expected) in [
        ("b", "a", true),
        ("a", "b", false),
        ("b", "c", false),
        ("b", "b", true),
        ("a", "d", true),
        ("d", "a", false),
        ("d", "e", true),
        ("a", "unknown", false),
    ] {
        assert_eq!(order.allows(from, to), expected, "{from} → {to}");
    }
}
