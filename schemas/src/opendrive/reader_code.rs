//! The reader: which attribute and which child goes into which field.

use super::names::{constant, field};
use super::struct_code::{child_field, is_root, rust_type};
use super::{Element, SchemaPart, Table, note};
use anyhow::{Result, bail};
use std::fmt::Write as _;

/// One implementation for each element of a part.
pub(super) fn readers(_table: &Table, part: &SchemaPart) -> Result<String> {
    let name = part.name;
    let mut out = format!("//! Reads the elements of `{name}`.\n{}", note(name));
    let root = part.elements.iter().any(is_root);
    if root {
        out += "use super::*;\nuse crate::cursor::Cursor;\n";
    } else {
        let _ = writeln!(out, "use super::{name}::*;\nuse super::schema_{name}::*;");
        out += "use crate::cursor::Cursor;\nuse crate::element::Element;\nuse crate::extension::Extensions;\nuse crate::finding::Span;\nuse crate::schema::ElementSchema;\n";
    }
    for element in &part.elements {
        out += &if is_root(element) { root_reader(element) } else { reader(element)? };
    }
    Ok(out)
}

fn root_reader(element: &Element) -> String {
    let mut out = "\n/// Reads the top-level element of a slot.\npub(crate) fn item(slot: usize, cursor: &mut Cursor<'_>) -> Option<Item> {\nSome(match slot {\n".to_owned();
    for (slot, child) in element.children.iter().enumerate() {
        let _ = writeln!(out, "{slot} => Item::{}(cursor.boxed()),", child.kind);
    }
    out += "_ => return None,\n})\n}\n";
    out
}

fn reader(element: &Element) -> Result<String> {
    let mut out = format!(
        "\nimpl Element for {} {{\nfn schema() -> &'static ElementSchema {{ &{} }}\nfn begin(&mut self, span: Span) {{ self.span = span; }}\nfn extensions(&mut self) -> &mut Extensions {{ &mut self.extensions }}\n",
        element.name,
        constant(&element.name)
    );
    if !element.attributes.is_empty() {
        out += "fn attribute(&mut self, slot: usize, cursor: &mut Cursor<'_>) {\nmatch slot {\n";
        for (slot, attribute) in element.attributes.iter().enumerate() {
            let field = field(&attribute.name);
            let mut code = read(&attribute.value_type()?)?;
            if attribute.as_text {
                code = code.replace("cursor.word::<", "cursor.word_as_text::<");
            }
            let _ = writeln!(out, "{slot} => self.{field} = {code},");
        }
        out += "_ => {}\n}\n}\n";
    }
    if let Some(content) = &element.content {
        let _ = writeln!(
            out,
            "fn content(&mut self, cursor: &mut Cursor<'_>) {{ self.content = {}; }}",
            read(content)?
        );
    }
    if !element.children.is_empty() {
        out += "fn child(&mut self, slot: usize, cursor: &mut Cursor<'_>) {\nmatch slot {\n";
        for (slot, child) in element.children.iter().enumerate() {
            let field = child_field(element, child);
            let method = if child.repeats() { "push" } else { "put" };
            let _ = writeln!(out, "{slot} => cursor.{method}(&mut self.{field}),");
        }
        out += "_ => {}\n}\n}\n";
    }
    out += "}\n";
    Ok(out)
}

fn read(kind: &str) -> Result<String> {
    Ok(match kind {
        "double" => "cursor.double()".to_owned(),
        "int" => "cursor.int()".to_owned(),
        "uint" => "cursor.uint()".to_owned(),
        "boolean" | "yes_no" | "xs_boolean" => "cursor.boolean()".to_owned(),
        "speed_limit" | "lane_speed_limit" => "cursor.speed_limit()".to_owned(),
        "position_or_end" => "cursor.position_or_end()".to_owned(),
        "text" => "cursor.text()".to_owned(),
        "country" => "cursor.country()".to_owned(),
        words if words.starts_with("words ") => format!("cursor.word::<{}>()", rust_type(words)),
        other => bail!("unknown type {other}"),
    })
    .map(|code| code.replace("word::<", "word::<super::words::"))
}
