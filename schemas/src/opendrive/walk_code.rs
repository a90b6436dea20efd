//! Walking over elements without knowing their types: children, what stands beside them, and what no table of the archive has.

use super::names::field;
use super::struct_code::{child_field, is_root};
use super::{Element, SchemaPart, note};
use std::fmt::Write as _;

/// One implementation of `Written` for each element of a part.
pub(super) fn walks(part: &SchemaPart) -> String {
    let name = part.name;
    let elements = part.elements.iter().filter(|element| !is_root(element));
    let code: String = elements.map(walk).collect();
    let mut out = format!("//! Walks over the elements of `{name}`.\n{}", note(name));
    out += "use super::*;\nuse crate::extension::Extensions;\nuse crate::finding::Span;\n";
    let used = [
        ("Keep<", "Keep"),
        ("Visit<", "Visit"),
        ("impl Written", "Written"),
        ("\nchild(", "child"),
        ("\nchildren(", "children"),
        ("\nkeep(", "keep"),
    ];
    let used = used.iter().filter(|(use_, _)| code.contains(use_)).map(|(_, name)| *name);
    let _ = writeln!(out, "use crate::written::{{{}}};", used.collect::<Vec<_>>().join(", "));
    out + &code
}

fn walk(element: &Element) -> String {
    let name = &element.name;
    let mut out = format!(
        "\nimpl Written for {name} {{\nfn kind(&self) -> &'static str {{ \"{name}\" }}\nfn span(&self) -> Span {{ self.span }}\nfn extensions(&self) -> &Extensions {{ &self.extensions }}\n"
    );
    // What the archive has no place of its own for.
    let kept: Vec<_> = element.attributes.iter().filter(|a| a.mapd.is_none()).collect();
    let content = element.content.is_some() && element.mapd.is_none();
    if !kept.is_empty() || content {
        out += "fn kept(&self, to: Keep<'_>) {\n";
        for attribute in kept {
            let _ = writeln!(
                out,
                "keep(\"{}\", &self.{}, to);",
                attribute.name,
                field(&attribute.name)
            );
        }
        if content {
            out += "keep(\"\", &self.content, to);\n";
        }
        out += "}\n";
    }
    if !element.children.is_empty() {
        out += "fn children(&self, visit: Visit<'_>) {\n";
        for one in &element.children {
            let of = if one.repeats() { "children" } else { "child" };
            let _ = writeln!(
                out,
                "{of}(\"{}\", &self.{}, visit);",
                one.name,
                child_field(element, one)
            );
        }
        out += "}\n";
    }
    out + "}\n"
}
