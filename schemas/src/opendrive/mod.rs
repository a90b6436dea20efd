//! Reads the table of OpenDRIVE's elements and checks that it is whole.

pub mod coverage;
mod names;
mod reader_code;
mod schema_code;
mod struct_code;
mod versions;
mod walk_code;
mod words_code;

use anyhow::{Context, Result, bail, ensure};
pub use names::field;
use serde::Deserialize;
use std::path::Path;
pub use versions::{Occurs, Spanned, VERSIONS, Version, VersionSet};

/// The parts of the standard, in the order in which the outputs list them; each is a file of the table.
pub const PARTS: [&str; 15] = [
    "document",
    "header",
    "road",
    "plan_view",
    "profiles",
    "lanes",
    "road_mark",
    "objects",
    "object_outlines",
    "signals",
    "semantics",
    "controller",
    "junction",
    "railroad",
    "additional_data",
];

/// Elements that may stand in any other.
pub const ADDITIONAL: [(&str, &str); 3] =
    [("userData", "UserData"), ("include", "Include"), ("dataQuality", "DataQuality")];

/// The whole table.
pub struct Table {
    /// Elements by part.
    pub parts: Vec<SchemaPart>,
    /// Enumerations.
    pub words: Vec<Words>,
}

/// The elements of one part.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SchemaPart {
    /// Name of the part and of its file.
    #[serde(skip)]
    pub name: &'static str,
    /// The elements.
    #[serde(rename = "element")]
    pub elements: Vec<Element>,
}

/// A type of element.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(missing_docs)]
pub struct Element {
    pub name: String,
    pub schema: Option<String>,
    #[serde(default)]
    pub section: String,
    pub since: Option<Version>,
    pub doc: String,
    pub key: Option<String>,
    pub content: Option<String>,
    #[serde(default)]
    pub any: bool,
    #[serde(default)]
    pub variants: Vec<String>,
    #[serde(default = "nothing")]
    pub additional: Spanned<String>,
    pub mapd: Option<Use>,
    #[serde(default)]
    pub attributes: Vec<Attribute>,
    #[serde(default)]
    pub children: Vec<Child>,
}

/// An attribute of an element.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(missing_docs)]
pub struct Attribute {
    pub name: String,
    #[serde(rename = "type")]
    pub kind: Spanned<String>,
    #[serde(default)]
    pub unit: String,
    #[serde(rename = "use")]
    pub need: Spanned<String>,
    pub text_use: Option<String>,
    pub since: Option<Version>,
    pub until: Option<Version>,
    pub deprecated: Option<Version>,
    #[serde(default)]
    pub when: Vec<String>,
    pub mapd: Option<Use>,
    /// Words are kept as the text that they are, also where the standard does not list them.
    #[serde(default)]
    pub as_text: bool,
    pub doc: String,
}

/// A child of an element.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(missing_docs)]
pub struct Child {
    pub name: String,
    #[serde(rename = "type")]
    pub kind: String,
    pub occurs: Spanned<Occurs>,
    pub order: u16,
    pub choice: Option<String>,
    pub since: Option<Version>,
    pub until: Option<Version>,
    pub deprecated: Option<Version>,
    #[serde(default)]
    pub when: Vec<String>,
}

/// An enumeration.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(missing_docs)]
pub struct Words {
    pub name: String,
    pub schema: String,
    pub doc: String,
    #[serde(default)]
    pub synonyms: Vec<Synonym>,
    pub words: Vec<Word>,
}

/// Another spelling of a word, in any case.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(missing_docs)]
pub struct Synonym {
    pub written: String,
    pub word: String,
}

/// A word of an enumeration.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(missing_docs)]
pub struct Word {
    pub word: String,
    pub since: Option<Version>,
    pub until: Option<Version>,
    pub deprecated: Option<Version>,
    pub deprecated_until: Option<Version>,
}

impl Word {
    /// Versions that have it.
    pub fn versions(&self) -> VersionSet {
        VersionSet::between(self.since, self.until)
    }

    /// Versions that deprecate it.
    pub fn deprecations(&self) -> VersionSet {
        match self.deprecated {
            Some(since) => {
                VersionSet::between(Some(since), self.deprecated_until).and(self.versions())
            }
            None => VersionSet::NONE,
        }
    }
}

/// What mapd does with an element or attribute beyond reading and checking it.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Use {
    /// The map depends on it.
    Builds,
    /// The map carries it as written.
    Stores,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WordsFile {
    words: Vec<Words>,
}

fn nothing() -> Spanned<String> {
    Spanned::always("none".to_owned())
}

impl Table {
    /// Reads the folder of the table.
    ///
    /// Errors: a file is missing or does not hold what a table holds; a name is used that no entry has.
    pub fn read(folder: &Path) -> Result<Self> {
        let text = |name: &str| {
            let path = folder.join(name).with_extension("toml");
            std::fs::read_to_string(&path).with_context(|| format!("reading {}", path.display()))
        };
        let mut parts = Vec::new();
        for name in PARTS {
            let mut part: SchemaPart =
                toml::from_str(&text(name)?).with_context(|| name.to_owned())?;
            part.name = name;
            for element in &mut part.elements {
                element.children.sort_by_key(|child| child.order);
            }
            parts.push(part);
        }
        let WordsFile { words } = toml::from_str(&text("words")?).context("words")?;
        let table = Self { parts, words };
        for element in table.elements() {
            table.check(element).with_context(|| format!("element {}", element.name))?;
        }
        Ok(table)
    }

    /// All elements.
    pub fn elements(&self) -> impl Iterator<Item = &Element> {
        self.parts.iter().flat_map(|part| &part.elements)
    }

    /// The element of a name.
    pub fn element(&self, name: &str) -> Option<&Element> {
        self.elements().find(|element| element.name == name)
    }

    /// The enumeration of a name.
    pub fn words(&self, name: &str) -> Option<&Words> {
        self.words.iter().find(|words| words.name == name)
    }

    fn check(&self, element: &Element) -> Result<()> {
        let same = self.elements().filter(|other| other.name == element.name).count();
        ensure!(same == 1, "the name is used twice");
        ensure!(element.attributes.len() < 64 && element.children.len() < 64, "more than 63");
        for attribute in &element.attributes {
            let kind = attribute.value_type()?;
            if let Some(words) = kind.strip_prefix("words ") {
                ensure!(self.words(words).is_some(), "no enumeration {words}");
            }
            ensure!(attribute.when.iter().all(|w| element.variants.contains(w)), "no such variant");
        }
        for child in &element.children {
            ensure!(self.element(&child.kind).is_some(), "no element {}", child.kind);
            ensure!(child.when.iter().all(|w| element.variants.contains(w)), "no such variant");
        }
        if let Some(key) = &element.key {
            ensure!(element.attributes.iter().any(|a| a.name == *key), "no attribute {key}");
        }
        Ok(())
    }
}

impl Element {
    /// Versions that have it.
    pub fn versions(&self) -> VersionSet {
        VersionSet::between(self.since, None)
    }

    /// Versions in which something that may stand anywhere may stand inside.
    pub fn additional(&self, name: &str) -> VersionSet {
        self.additional.versions(|value| value == "all" || value.split(' ').any(|v| v == name))
    }
}

impl Attribute {
    /// Versions that have it, in an element of the given age.
    pub fn versions(&self, element: &Element) -> VersionSet {
        VersionSet::between(self.since.or(element.since), self.until)
    }

    /// The type without range, by which it is read in all versions.
    ///
    /// Errors: the table has a type that is not known.
    pub fn value_type(&self) -> Result<String> {
        let (kind, _) = split_range(self.kind.last());
        match kind.split(' ').next().unwrap_or_default() {
            "text" | "int" | "uint" | "double" | "boolean" | "yes_no" | "xs_boolean"
            | "country" | "speed_limit" | "lane_speed_limit" | "position_or_end" | "words" => {
                Ok(kind.to_owned())
            }
            other => bail!("@{}: unknown type {other}", self.name),
        }
    }

    /// Versions that take any text although the type is another.
    pub fn loose(&self) -> VersionSet {
        let kind = split_range(self.kind.last()).0;
        self.kind.versions(|value| kind != "text" && value.starts_with("text"))
    }

    /// Versions that want a number although the type is text.
    pub fn numeric(&self) -> VersionSet {
        let kind = split_range(self.kind.last()).0;
        self.kind.versions(|value| kind == "text" && value.starts_with("double"))
    }

    /// Versions that require it.
    pub fn required(&self, element: &Element) -> VersionSet {
        self.need.versions(|need| need == "required").and(self.versions(element))
    }
}

impl Child {
    /// Versions that have it, in an element of the given age.
    pub fn versions(&self, table: &Table, element: &Element) -> VersionSet {
        let own = table.element(&self.kind).and_then(|child| child.since);
        let since = self.since.max(element.since).max(own);
        VersionSet::between(since, self.until)
    }

    /// Whether there may be several in some version.
    pub fn repeats(&self) -> bool {
        self.occurs.values().any(|occurs| occurs.max != Some(1))
    }
}

/// A type as written, split into the type and its range; the range may be empty.
pub fn split_range(kind: &str) -> (&str, &str) {
    match kind.rsplit_once(' ') {
        Some((kind, range)) if !kind.is_empty() && kind != "words" => (kind, range),
        _ => (kind, ""),
    }
}

/// Everything that follows from the table.
///
/// Errors: the table has something that code cannot be written for.
pub fn outputs(table: &Table) -> Result<Vec<crate::Output>> {
    const FOLDER: &str = "src/xodr/src/generated";
    let mut outputs = vec![
        (format!("{FOLDER}/mod.rs"), module(table)),
        (format!("{FOLDER}/words.rs"), words_code::enums(table)),
        (format!("{FOLDER}/schema_words.rs"), words_code::lists(table)),
    ];
    for part in &table.parts {
        let name = part.name;
        outputs.push((format!("{FOLDER}/{name}.rs"), struct_code::structs(table, part)?));
        outputs.push((format!("{FOLDER}/schema_{name}.rs"), schema_code::statics(table, part)?));
        outputs.push((format!("{FOLDER}/read_{name}.rs"), reader_code::readers(table, part)?));
        if part.elements.iter().any(|element| !struct_code::is_root(element)) {
            outputs.push((format!("{FOLDER}/walk_{name}.rs"), walk_code::walks(part)));
        }
    }
    Ok(outputs)
}

/// The note at the head of a generated file.
fn note(part: &str) -> String {
    format!(
        "// Written by `cargo run -p mapd-schemas` from schemas/opendrive/{part}.toml; change that file instead.\n\n"
    )
}

fn module(table: &Table) -> String {
    let mut out = "//! The document's types, the schema and the reader that follow from the table.\n// Written by `cargo run -p mapd-schemas` from schemas/opendrive; change those files instead.\n\n#![allow(clippy::single_match, reason = \"elements differ in how many attributes they have\")]\n\n".to_owned();
    for part in &table.parts {
        let name = part.name;
        // Top-level elements are read from outside.
        let public = if name == "document" { "pub(crate) " } else { "" };
        out += &format!("mod {name};\n{public}mod read_{name};\npub(crate) mod schema_{name};\n");
        if part.elements.iter().any(|element| !struct_code::is_root(element)) {
            out += &format!("mod walk_{name};\n");
        }
    }
    out += "pub(crate) mod schema_words;\nmod words;\n\n";
    for part in &table.parts {
        out += &format!("pub use {}::*;\n", part.name);
    }
    out += "pub use words::*;\n";
    out
}
