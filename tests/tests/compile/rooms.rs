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

/// Modules of a crate, or of a folder of it, that import a module: all files but those of the module itself.
fn importers(folder: &Path, module: &str) -> Vec<String> {
    let (mut files, mut found) = (Vec::new(), Vec::new());
    sources(folder, &mut files);
    assert!(files.len() > 50, "{} has few sources", folder.display());
    for (file, text) in files {
        let own = Path::new(&file).strip_prefix(folder).expect("below the folder");
        let is_own = own.starts_with(module) || own == Path::new(&format!("{module}.rs"));
        if !is_own && imports(&text).contains(module) {
            found.push(own.display().to_string());
        }
    }
    found
}

/// The page says that `cli` defines the commands and that nothing below imports it: `lib.rs` only declares it.
#[test]
fn nothing_in_the_program_imports_its_command_line() {
    assert_eq!(importers(&workspace().join("src/mapd/src"), "cli"), Vec::<String>::new());
}

/// Dependencies on crates of the workspace that a manifest has outside of tests.
fn own_dependencies(manifest: &str) -> BTreeSet<String> {
    let sections = manifest.split("\n[").filter(|section| section.starts_with("dependencies]"));
    let lines = sections.flat_map(str::lines);
    let names = lines.filter_map(|line| line.strip_prefix("mapd-"));
    names.map(|name| name.split(['.', ' ', '=']).next().unwrap_or(name).to_owned()).collect()
}

/// What the page's table of crates says that one may depend on, by folder. Dependencies that others of the row bring are not listed again.
fn listed_dependencies(page: &str) -> BTreeMap<String, BTreeSet<String>> {
    let rows = page.lines().filter(|line| line.starts_with("| `src/"));
    let cells = rows.map(|row| row.split(" | ").map(str::trim).collect::<Vec<_>>());
    let words = |text: &str| {
        let parts = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '-'));
        parts.filter(|part| !part.is_empty()).map(str::to_owned).collect()
    };
    let of = |cells: Vec<&str>| {
        let folder = cells.first()?.trim_matches(['|', ' ', '`']).strip_prefix("src/")?.to_owned();
        (cells.len() == 4).then(|| (folder, words(cells.last().copied().unwrap_or_default())))
    };
    cells.filter_map(of).collect()
}

#[test]
fn crates_depend_on_those_that_the_page_lists() {
    let root = workspace();
    let page = fs::read_to_string(root.join("ARCHITECTURE.md")).expect("the page");
    let listed = listed_dependencies(&page);
    assert!(listed.len() >= 15, "{listed:?}");
    let mut strays = Vec::new();
    for (folder, allowed) in listed.iter().filter(|(_, allowed)| !allowed.contains("all")) {
        // Folders of scripts have none.
        let manifest = fs::read_to_string(root.join("src").join(folder).join("Cargo.toml"));
        for name in own_dependencies(&manifest.unwrap_or_default()) {
            if !allowed.contains(&name) {
                strays.push(format!("{folder} → {name}"));
            }
        }
    }
    assert!(strays.is_empty(), "not in the page's table: {strays:?}");
}

#[test]
fn a_dependency_that_is_not_listed_is_found() {
    let page = "| `src/a` | `mapd-a` | of `b`, `c` | b, glam; d as a feature |";
    let listed = listed_dependencies(page);
    let manifest = "[package]\nname = \"x\"\n\n[dependencies]\nmapd-b.workspace = true\nmapd-e = { workspace = true }\n\n[dev-dependencies]\nmapd-f.workspace = true\n";
    let own = own_dependencies(manifest);
    assert_eq!(own, BTreeSet::from(["b", "e"].map(str::to_owned)));
    assert!(listed["a"].contains("b") && !listed["a"].contains("e"), "{listed:?}");
}
