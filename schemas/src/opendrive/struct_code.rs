//! The document's types.

use super::names::field;
use super::{Attribute, Child, Element, SchemaPart, Table, VersionSet, note, split_range};
use anyhow::Result;
use std::fmt::Write as _;

/// One struct for each element of a part, and the items of the stream for the root.
pub(super) fn structs(table: &Table, part: &SchemaPart) -> Result<String> {
    let mut out = format!("//! Elements of `{}`.\n{}", part.name, note(part.name));
    let root = part.elements.iter().any(is_root);
    if !root || part.elements.len() > 1 {
        out += "#[allow(unused_imports, reason = \"each part needs some\")]\n";
        out += "use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};\n";
        out += "use crate::extension::Extensions;\nuse crate::finding::Span;\n";
    }
    out += "#[allow(unused_imports, reason = \"each part needs some\")]\nuse super::*;\n";
    for element in &part.elements {
        out += &if is_root(element) { items(element) } else { element_struct(table, element)? };
    }
    Ok(out)
}

/// Whether an element is the root, which is never in memory as a whole.
pub(super) fn is_root(element: &Element) -> bool {
    element.name == "OpenDrive"
}

fn items(element: &Element) -> String {
    let mut out =
        "\n/// A top-level element.\n#[derive(Clone, Debug, PartialEq)]\npub enum Item {\n"
            .to_owned();
    for child in &element.children {
        let _ = writeln!(out, "/// `{}`.\n{}(Box<{}>),", child.name, child.kind, child.kind);
    }
    out += "}\n";
    out
}

fn element_struct(table: &Table, element: &Element) -> Result<String> {
    let mut facts = Vec::new();
    if let Some(schema) = &element.schema {
        facts.push(schema.split('|').map(|s| format!("`{s}`")).collect::<Vec<_>>().join(", "));
    }
    if !element.section.is_empty() {
        facts.push(format!("section {}", element.section));
    }
    facts.push(element.versions().words());
    facts.retain(|fact| !fact.is_empty());
    let mut out = format!(
        "\n/// {}{}.\n#[derive(Clone, Debug, Default, PartialEq)]\npub struct {} {{\n/// The start tag.\npub span: Span,\n",
        element.doc,
        if facts.is_empty() { String::new() } else { format!(" ({})", facts.join("; ")) },
        element.name
    );
    for attribute in &element.attributes {
        let kind = if attribute.as_text { "text".to_owned() } else { attribute.value_type()? };
        let _ = writeln!(
            out,
            "/// {}\npub {}: Option<Attribute<{}>>,",
            attribute_doc(element, attribute),
            field(&attribute.name),
            rust_type(&kind)
        );
    }
    if let Some(content) = &element.content {
        let _ = writeln!(
            out,
            "/// The text inside.\npub content: Option<Attribute<{}>>,",
            rust_type(content)
        );
    }
    for child in &element.children {
        let kind = &child.kind;
        let holder =
            if child.repeats() { format!("Vec<{kind}>") } else { format!("Option<Box<{kind}>>") };
        let _ = writeln!(
            out,
            "/// {}\npub {}: {holder},",
            child_doc(table, element, child),
            child_field(element, child)
        );
    }
    out += "/// What stands inside beyond the standard's own elements.\npub extensions: Extensions,\n}\n";
    Ok(out)
}

/// The field of a child; told apart where an attribute has the same name.
pub(super) fn child_field(element: &Element, child: &Child) -> String {
    if element.attributes.iter().any(|attribute| attribute.name == child.name) {
        format!("{}_element", super::names::snake(&child.name))
    } else {
        field(&child.name)
    }
}

/// The type in Rust of a type of value.
pub(super) fn rust_type(kind: &str) -> &str {
    match kind {
        "double" => "f64",
        "int" => "i32",
        "uint" => "u32",
        "boolean" | "yes_no" | "xs_boolean" => "bool",
        "speed_limit" | "lane_speed_limit" => "SpeedLimit",
        "position_or_end" => "PositionOrEnd",
        "text" | "country" => "Box<str>",
        other => other.strip_prefix("words ").unwrap_or(other),
    }
}

/// What is to be said of an attribute, in one line.
pub(super) fn attribute_doc(element: &Element, attribute: &Attribute) -> String {
    let mut out = format!("`@{}`", attribute.name);
    if !attribute.unit.is_empty() {
        let _ = write!(out, " `[{}]`", attribute.unit);
    }
    let _ = write!(out, ": {}.", escape(&attribute.doc));
    for fact in facts(element, attribute) {
        let _ = write!(out, " {fact}.");
    }
    out
}

/// Range, need and versions of an attribute, as sentences without their ends.
fn facts(element: &Element, attribute: &Attribute) -> Vec<String> {
    let mut facts = Vec::new();
    let versions = attribute.versions(element);
    let when = |set: VersionSet| {
        let words = set.words();
        let plain = set == versions || words.is_empty();
        if plain { String::new() } else { format!(" {words}") }
    };
    let mut done = Vec::new();
    for range in attribute.kind.values().map(|kind| split_range(kind).1) {
        if range.is_empty() || done.contains(&range) {
            continue;
        }
        done.push(range);
        let set = attribute.kind.versions(|kind| split_range(kind).1 == range).and(versions);
        let words = match range {
            ">=0" => "At least 0".to_owned(),
            ">=1" => "At least 1".to_owned(),
            ">0" => "Above 0".to_owned(),
            "!=0" => "Not 0".to_owned(),
            "0..1" => "From 0 to 1".to_owned(),
            fixed => format!("Always {}", fixed.trim_start_matches('=')),
        };
        facts.push(format!("{words}{}", when(set)));
    }
    let required = attribute.required(element);
    if required != VersionSet::NONE {
        facts.push(format!("Required{}", when(required)));
    }
    match attribute.text_use.as_deref() {
        Some("required") => facts.push("Required by the text since 1.8".to_owned()),
        Some("optional") => facts.push("Optional by the text of 1.9".to_owned()),
        _ => {}
    }
    if !attribute.when.is_empty() {
        facts.push(format!("Of variant {}", attribute.when.join(", ")));
    }
    if versions != element.versions() {
        facts.push(capitalized(&versions.words()));
    }
    if let Some(since) = attribute.deprecated {
        facts.push(format!("Deprecated since {since}"));
    }
    facts
}

fn child_doc(table: &Table, element: &Element, child: &Child) -> String {
    let doc = table.element(&child.kind).map_or("", |kind| kind.doc.as_str());
    let mut out = format!("`{}`: {}.", child.name, escape(doc));
    let versions = child.versions(table, element);
    if versions != element.versions() {
        let _ = write!(out, " {}.", capitalized(&versions.words()));
    }
    if !child.when.is_empty() {
        let _ = write!(out, " Of variant {}.", child.when.join(", "));
    }
    if let Some(since) = child.deprecated {
        let _ = write!(out, " Deprecated since {since}.");
    }
    out
}

fn capitalized(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

fn escape(text: &str) -> String {
    text.replace('[', "\\[").replace(']', "\\]")
}
