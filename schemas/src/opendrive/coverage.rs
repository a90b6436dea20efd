//! `docs/coverage.md`: what mapd does with every element and attribute.

use super::struct_code::attribute_doc;
use super::{Element, Table, Use};
use std::fmt::Write as _;

const HEAD: &str = "# Coverage of OpenDRIVE 1.4 to 1.9

Written by `cargo run -p mapd-schemas` from `schemas/opendrive`; change those files instead.

Every element and attribute below is read and checked against the schema of the version that the file states. Beyond that,
mapd either

- **builds** from it: the compiled map depends on it,
- **stores** it: the compiled map carries it as written, or
- **keeps** it: nothing is built from it; the compiled map has it as an annotation of the part that it stands in ([annotations.md](annotations.md)).

What stands in a file beyond these (other namespaces, unknown elements) is an annotation too, as text with its place.
";

/// The whole page.
pub(super) fn page(table: &Table) -> String {
    let mut out = HEAD.to_owned();
    let elements: Vec<&Element> = table.elements().collect();
    let of = |wanted: Option<Use>| {
        let e = elements.iter().filter(|e| e.mapd == wanted).count();
        let a = elements.iter().flat_map(|e| &e.attributes).filter(|a| a.mapd == wanted).count();
        (e, a)
    };
    out += "\n| | types of elements | attributes |\n|---|---|---|\n";
    for (name, wanted) in
        [("builds", Some(Use::Builds)), ("stores", Some(Use::Stores)), ("keeps", None)]
    {
        let (e, a) = of(wanted);
        let _ = writeln!(out, "| {name} | {e} | {a} |");
    }
    for part in &table.parts {
        let _ = write!(out, "\n## {}\n", part.name.replace('_', " "));
        for element in &part.elements {
            let _ = write!(
                out,
                "\n### {}: {}\n\n{}{}\n",
                element.name,
                word(element.mapd),
                element.doc,
                places(table, element)
            );
            if !element.attributes.is_empty() {
                out += "\n| attribute | mapd | type | |\n|---|---|---|---|\n";
            }
            for attribute in &element.attributes {
                let doc = attribute_doc(element, attribute);
                let doc = doc.split_once(": ").map_or("", |(_, doc)| doc);
                let unit = match attribute.unit.as_str() {
                    "" => String::new(),
                    unit => format!(" `[{unit}]`"),
                };
                let _ = writeln!(
                    out,
                    "| `{}` | {} | {}{unit} | {doc} |",
                    attribute.name,
                    word(attribute.mapd),
                    attribute.kind.last()
                );
            }
        }
    }
    out
}

fn word(mapd: Option<Use>) -> &'static str {
    match mapd {
        Some(Use::Builds) => "builds",
        Some(Use::Stores) => "stores",
        None => "keeps",
    }
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
