//! The schema as statics that the reader checks against.

use super::names::constant;
use super::{
    Attribute, Child, Element, SchemaPart, Table, VERSIONS, VersionSet, note, split_range,
};
use anyhow::{Context, Result, bail};
use std::fmt::Write as _;

/// One static for each element of a part.
pub(super) fn statics(table: &Table, part: &SchemaPart) -> Result<String> {
    let mut out = format!("//! The schema of `{}`.\n{}", part.name, note(part.name));
    out += "#[allow(unused_imports, reason = \"each part needs some\")]\n";
    out += "use crate::generated::schema_words::*;\n";
    let mut parts: Vec<&str> = Vec::new();
    for child in part.elements.iter().flat_map(|element| &element.children) {
        let of = table.parts.iter().find(|p| p.elements.iter().any(|e| e.name == child.kind));
        parts.extend(of.map(|p| p.name).filter(|name| *name != part.name));
    }
    parts.sort_unstable();
    parts.dedup();
    for name in parts {
        let _ = writeln!(out, "use crate::generated::schema_{name}::*;");
    }
    out += "#[allow(unused_imports, reason = \"each part needs some\")]\n";
    out += "use crate::schema::{Choice, ElementSchema, Kind, MANY, Range, V1_4, V1_5, V1_6, V1_7, V1_8, V1_8_1, V1_9, attribute, between, child, from};\n";
    if part.elements.iter().any(|element| !element.variants.is_empty()) {
        out += "use crate::variants;\n";
    }
    for element in &part.elements {
        out += &element_static(table, element).with_context(|| element.name.clone())?;
    }
    Ok(out)
}

fn element_static(table: &Table, element: &Element) -> Result<String> {
    let mut out = format!(
        "\npub(crate) static {}: ElementSchema = ElementSchema::new(\n\"{}\",\n&[",
        constant(&element.name),
        element.name
    );
    for attribute in &element.attributes {
        out += &attribute_code(element, attribute)?;
        out += ",\n";
    }
    out += "],\n&[";
    for child in &element.children {
        out += &child_code(table, element, child)?;
        out += ",\n";
    }
    out += "],\n)";
    if let Some(key) = &element.key {
        let at = element.attributes.iter().position(|a| a.name == *key).unwrap_or_default();
        let _ = write!(out, ".key({at})");
    }
    if let Some(content) = &element.content {
        let _ = write!(out, ".content({})", kind_code(content)?);
    }
    if element.any {
        out += ".any()";
    }
    let choices: Vec<&str> = element.children.iter().filter_map(|c| c.choice.as_deref()).collect();
    match choices.first() {
        Some(&"one") => out += ".choice(Choice::One)",
        Some(&"at most one") => out += ".choice(Choice::AtMostOne)",
        Some(&"any") | None => {}
        Some(other) => bail!("unknown choice {other}"),
    }
    let additional = ["userData", "include", "dataQuality"].map(|name| element.additional(name));
    if additional.iter().any(|set| *set != VersionSet::NONE) {
        let sets = additional.map(set_code).join(", ");
        let _ = write!(out, ".additional({sets})");
    }
    if !element.variants.is_empty() {
        let names: Vec<String> = element.variants.iter().map(|v| format!("{v:?}")).collect();
        let name = super::names::snake(&element.name);
        let _ = write!(out, ".variants(&[{}], variants::{name})", names.join(", "));
    }
    out += ";\n";
    Ok(out)
}

/// Rust code of a set of versions.
pub(super) fn set_code(set: VersionSet) -> String {
    let name = |rank: usize| format!("V{}", VERSIONS[rank].replace('.', "_"));
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for rank in (0..VERSIONS.len()).filter(|rank| set.has(*rank)) {
        match runs.last_mut() {
            Some((_, last)) if *last + 1 == rank => *last = rank,
            _ => runs.push((rank, rank)),
        }
    }
    let run = |(first, last): &(usize, usize)| {
        if last + 1 == VERSIONS.len() {
            format!("from({})", name(*first))
        } else {
            format!("between({}, {})", name(*first), name(*last))
        }
    };
    if runs.is_empty() {
        "0".to_owned()
    } else {
        runs.iter().map(run).collect::<Vec<_>>().join(" | ")
    }
}

/// Rust code of a type of value.
pub(super) fn kind_code(kind: &str) -> Result<String> {
    Ok(match kind {
        "text" => "Kind::Text".to_owned(),
        "int" => "Kind::Int".to_owned(),
        "uint" => "Kind::Uint".to_owned(),
        "double" => "Kind::Double".to_owned(),
        "boolean" => "Kind::Boolean".to_owned(),
        "yes_no" => "Kind::YesNo".to_owned(),
        "xs_boolean" => "Kind::XsBoolean".to_owned(),
        "country" => "Kind::Country".to_owned(),
        "speed_limit" => "Kind::SpeedLimit".to_owned(),
        "lane_speed_limit" => "Kind::LaneSpeedLimit".to_owned(),
        "position_or_end" => "Kind::PositionOrEnd".to_owned(),
        other => match other.strip_prefix("words ") {
            Some(words) => format!("Kind::Words(&{})", constant(words)),
            None => bail!("unknown type {other}"),
        },
    })
}

fn range_code(range: &str) -> Result<String> {
    Ok(match range {
        ">=0" => "Range::AtLeast0".to_owned(),
        ">=1" => "Range::AtLeast1".to_owned(),
        ">0" => "Range::Above0".to_owned(),
        "!=0" => "Range::Not0".to_owned(),
        "0..1" => "Range::ZeroToOne".to_owned(),
        fixed => match fixed.strip_prefix('=').and_then(|n| n.parse::<i32>().ok()) {
            Some(number) => format!("Range::Exactly({number})"),
            None => bail!("unknown range {range}"),
        },
    })
}

fn attribute_code(element: &Element, attribute: &Attribute) -> Result<String> {
    let versions = attribute.versions(element);
    let mut out =
        format!("attribute(\"{}\", {})", attribute.name, kind_code(&attribute.value_type()?)?);
    let mut add = |name: &str, set: VersionSet| {
        if set != VersionSet::NONE {
            let _ = write!(out, ".{name}({})", set_code(set));
        }
    };
    if versions != VersionSet::ALL {
        add("only", versions);
    }
    add("required", attribute.required(element));
    let late = VersionSet::between(Some(super::Version::TEXT), None).and(versions);
    if attribute.text_use.as_deref() == Some("required") {
        add("by_text", late.without(attribute.required(element)));
    }
    add("loose", attribute.loose());
    add("numeric", attribute.numeric());
    if let Some(since) = attribute.deprecated {
        add("deprecated", VersionSet::between(Some(since), None).and(versions));
    }
    if attribute.text_use.as_deref() == Some("optional") {
        out += ".not_by_text()";
    }
    let ranges: Vec<&str> = attribute.kind.values().map(|kind| split_range(kind).1).collect();
    let mut done: Vec<&str> = Vec::new();
    for range in ranges.into_iter().filter(|range| !range.is_empty()) {
        if done.contains(&range) {
            continue;
        }
        done.push(range);
        if attribute.value_type()? == "text" {
            let _ = write!(out, ".fixed({:?})", range.trim_start_matches('='));
            continue;
        }
        let set = attribute.kind.versions(|kind| split_range(kind).1 == range);
        let _ = write!(out, ".range({}, {})", range_code(range)?, set_code(set));
    }
    out += &when_code(element, &attribute.when);
    Ok(out)
}

fn when_code(element: &Element, when: &[String]) -> String {
    if when.is_empty() {
        return String::new();
    }
    let bits = element
        .variants
        .iter()
        .enumerate()
        .filter(|(_, variant)| when.contains(variant))
        .fold(0u8, |bits, (rank, _)| bits | 1 << rank);
    format!(".when({bits:#06b})")
}

fn child_code(table: &Table, element: &Element, child: &Child) -> Result<String> {
    let versions = child.versions(table, element);
    let mut out = format!("child(\"{}\", &{}, {})", child.name, constant(&child.kind), child.order);
    if versions != VersionSet::ALL {
        let _ = write!(out, ".only({})", set_code(versions));
    }
    let mut done = Vec::new();
    for occurs in child.occurs.values() {
        if done.contains(occurs) || (occurs.min == 0 && occurs.max.is_none()) {
            continue;
        }
        done.push(*occurs);
        let set = child.occurs.versions(|other| other == occurs);
        let max = occurs.max.map_or("MANY".to_owned(), |max| max.to_string());
        let _ = write!(out, ".occurs({}, {max}, {})", occurs.min, set_code(set));
    }
    if child.choice.is_some() {
        out += ".choice()";
    }
    if let Some(since) = child.deprecated {
        let set = VersionSet::between(Some(since), None).and(versions);
        let _ = write!(out, ".deprecated({})", set_code(set));
    }
    out += &when_code(element, &child.when);
    Ok(out)
}
