//! What the table says that mapd builds from or stores, the compiler names.

use mapd_schemas::opendrive::{Table, field};
use std::path::Path;

/// All code of a folder.
fn code(folder: &Path, out: &mut String) {
    let mut entries: Vec<_> = std::fs::read_dir(folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .flatten()
        .map(|entry| entry.path())
        .collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            code(&path, out);
        } else {
            *out += &std::fs::read_to_string(&path).expect("code");
        }
    }
}

#[test]
fn what_is_used_is_named_by_the_compiler() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace");
    let mut text = std::fs::read_to_string(root.join("src/xodr/src/record.rs")).expect("code");
    code(&root.join("src/compiler/src"), &mut text);
    let words: std::collections::HashSet<&str> =
        text.split(|c: char| !c.is_alphanumeric() && c != '_' && c != '#').collect();
    let table = Table::read(&root.join("schemas/opendrive")).expect("the table reads");
    for element in table.elements() {
        for attribute in element.attributes.iter().filter(|attribute| attribute.mapd.is_some()) {
            let field = field(&attribute.name);
            assert!(words.contains(field.as_str()), "{}: {field}", element.name);
            assert!(element.mapd.is_some(), "{} is used, its element is not", element.name);
        }
    }
}
