//! `docs/coverage.md`: what becomes of every element and attribute, as a run has shown.

use super::struct_code::attribute_doc;
use super::{Element, Table};
use std::fmt::Write as _;

const HEAD: &str = "# Coverage of OpenDRIVE 1.4 to 1.9

Written by `cargo run -p mapd-tests --bin coverage`; a test fails where this page differs from what that finds.

Every element and attribute below is read and checked against the schema of the version that the file states. What becomes of it is
shown, not declared: a map that has it is compiled twice, with two values, and the two archives are compared row by row. mapd

- **stores** it: the value itself stands in a field, words as the code of that field,
- **builds** from it: what the archives differ in follows from the value,
- **keeps** it: nothing is built from it; it is an annotation of the part that it stands in ([annotations.md](annotations.md)), and the value itself is the answer, or
- **checks** it: the standard leaves it one value, or nothing in a map may follow from it; the remark says why.

Beside it stand the tables in which the archives differ, the first four where there are more; `table.field` where the value itself is found. Tables are
those of [format.md](format.md). Elements without attributes are taken out instead; where no map is left without them, they are needed.
";

/// What a run has shown of an element or attribute.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Shown {
    /// `stores`, `builds`, `keeps` or `checks`.
    pub word: &'static str,
    /// Where it shows, or why it does not.
    pub places: String,
}

/// The whole page. `shown` is asked for each element, with none, and for each of its attributes.
pub fn page(table: &Table, shown: &dyn Fn(&str, Option<&str>) -> Shown) -> String {
    let mut out = HEAD.to_owned();
    let count = |word: &str| {
        let own = table.elements().filter(|e| shown(&e.name, None).word == word).count();
        let attributes = table.elements().flat_map(|e| {
            e.attributes.iter().filter(move |a| shown(&e.name, Some(&a.name)).word == word)
        });
        (own, attributes.count())
    };
    out += "\n| | types of elements | attributes |\n|---|---|---|\n";
    for word in ["stores", "builds", "keeps", "checks"] {
        let (elements, attributes) = count(word);
        let _ = writeln!(out, "| {word} | {elements} | {attributes} |");
    }
    for part in &table.parts {
        let _ = write!(out, "\n## {}\n", part.name.replace('_', " "));
        for element in &part.elements {
            let own = shown(&element.name, None);
            let at =
                if own.places.is_empty() { String::new() } else { format!(" ({})", own.places) };
            let places = places(table, element);
            let _ = write!(
                out,
                "\n### {}\n\n{}{places}\n\nmapd {} it{at}.\n",
                element.name, element.doc, own.word
            );
            if !element.attributes.is_empty() {
                out += "\n| attribute | mapd | where | type | |\n|---|---|---|---|---|\n";
            }
            for attribute in &element.attributes {
                let doc = attribute_doc(element, attribute);
                let doc = doc.split_once(": ").map_or("", |(_, doc)| doc);
                let unit = match attribute.unit.as_str() {
                    "" => String::new(),
                    unit => format!(" `[{unit}]`"),
                };
                let Shown { word, places } = shown(&element.name, Some(&attribute.name));
                let _ = writeln!(
                    out,
                    "| `{}` | {word} | {places} | {}{unit} | {doc} |",
                    attribute.name,
                    attribute.kind.last()
                );
            }
        }
    }
    out
}

/// Where an element stands, as a sentence.
fn places(table: &Table, element: &Element) -> String {
    let mut places = Vec::new();
    for parent in table.elements() {
        for child in parent.children.iter().filter(|child| child.kind == element.name) {
            let versions = child.versions(table, parent).words();
            let versions = if versions.is_empty() { versions } else { format!(" ({versions})") };
            places.push(format!("`{}` in {}{versions}", child.name, parent.name));
        }
    }
    for (tag, kind) in super::ADDITIONAL {
        if kind == element.name {
            places.push(format!("`{tag}` in any element"));
        }
    }
    if places.is_empty() { ".".to_owned() } else { format!(": {}.", places.join("; ")) }
}
