//! The vocabulary of signals and objects, and the tables that map what maps write to it.

use crate::Output;
use anyhow::{Context, Result, ensure};
use serde::Deserialize;
use std::collections::HashSet;
use std::fmt::Write as _;
use std::path::Path;

const NOTE: &str = "// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.\n\n";
const START: &str = "<!-- classes: written from schemas/ontology/classes.toml -->\n";
const END: &str = "<!-- end of classes -->\n";

/// Codes end below this: sets of classes are 256 bits, of which the last stands for what has no mapping
/// (`src/archive/src/classes.rs`).
const CODES_END: u16 = 255;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Vocabulary {
    #[serde(rename = "group")]
    groups: Vec<Group>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Group {
    name: String,
    doc: String,
    /// Whether its classes are landmarks for localisation, where they do not say so themselves.
    #[serde(default)]
    landmark: bool,
    classes: Vec<Class>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Class {
    code: u16,
    name: String,
    doc: String,
    /// Whether localisers find it again: it is fixed, seen from the road and has a place of its own.
    landmark: Option<bool>,
}

/// Rules of the road by country.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Rules {
    rules: Vec<CountryRules>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CountryRules {
    country: String,
    from_side: Option<String>,
    turn: bool,
    source: String,
}

impl Rules {
    fn code(&self) -> Result<String> {
        let mut out = format!(
            "//! Rules of the road by country.\n{NOTE}use crate::road_rules::{{FromSide, RoadRules}};\n\n"
        );
        out += "/// By country.\npub(crate) const RULES: &[RoadRules] = &[\n";
        let mut countries = HashSet::new();
        for CountryRules { country, from_side, turn, source } in &self.rules {
            let letters = country.len() == 2 && country.chars().all(|c| c.is_ascii_uppercase());
            ensure!(letters, "a country has two capital letters, found {country}");
            ensure!(countries.insert(country), "country {country} stands twice");
            let from_side = match from_side.as_deref() {
                None => "None",
                Some("right") => "Some(FromSide::Right)",
                Some("left") => "Some(FromSide::Left)",
                Some(other) => anyhow::bail!("from_side is right or left, found {other}"),
            };
            let _ = writeln!(
                out,
                "RoadRules {{ country: {country:?}, from_side: {from_side}, turn: {turn}, source: {source:?} }},"
            );
        }
        Ok(out + "];\n")
    }
}

/// Everything that follows from `schemas/ontology`.
pub(crate) fn outputs(root: &Path) -> Result<Vec<Output>> {
    let folder = root.join("schemas/ontology");
    let read = |name: &str| {
        let path = folder.join(name);
        std::fs::read_to_string(&path).with_context(|| format!("reading {}", path.display()))
    };
    let vocabulary: Vocabulary = toml::from_str(&read("classes.toml")?)?;
    vocabulary.check()?;
    let mut names = Vec::new();
    for entry in std::fs::read_dir(&folder)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if name.ends_with(".toml") && name != "classes.toml" && name != "rules.toml" {
            names.push(name);
        }
    }
    names.sort();
    let generated = "src/ontology/src/generated";
    let mut outputs = Vec::new();
    let mut modules = format!("//! The tables of `schemas/ontology`, as text.\n{NOTE}");
    let mut tables = "/// Name of each file and its text.\n".to_owned();
    tables += "pub(crate) const TABLES: &[(&str, &str)] = &[\n";
    for name in &names {
        let text = read(name)?;
        ensure!(!text.contains("\"##"), "{name} must not contain \"##");
        let module = name.trim_end_matches(".toml").replace('-', "_");
        let _ = writeln!(modules, "mod {module};");
        let _ = writeln!(tables, "({name:?}, {module}::TEXT),");
        let code = format!("pub(super) const TEXT: &str = r##\"{text}\"##;\n");
        let code = format!("//! `{name}`.\n{NOTE}/// The file.\n{code}");
        outputs.push((format!("{generated}/{module}.rs"), code));
    }
    outputs.push((format!("{generated}/mod.rs"), format!("{modules}\n{tables}];\n")));
    let page =
        std::fs::read_to_string(root.join("docs/ontology.md")).context("docs/ontology.md")?;
    outputs.push(("src/archive/src/generated/classes.rs".to_owned(), vocabulary.code()));
    outputs.push(("docs/ontology.md".to_owned(), vocabulary.splice(&page)?));
    let rules: Rules = toml::from_str(&read("rules.toml")?)?;
    outputs.push(("src/archive/src/generated/road_rules.rs".to_owned(), rules.code()?));
    Ok(outputs)
}

impl Vocabulary {
    fn classes(&self) -> impl Iterator<Item = &Class> {
        self.groups.iter().flat_map(|group| &group.classes)
    }

    fn check(&self) -> Result<()> {
        let (mut codes, mut names) = (HashSet::new(), HashSet::new());
        for class in self.classes() {
            ensure!(class.code < CODES_END, "codes end below {CODES_END}, found {}", class.code);
            ensure!(codes.insert(class.code), "code {} stands twice", class.code);
            ensure!(names.insert(&class.name), "class {} stands twice", class.name);
        }
        Ok(())
    }

    fn code(&self) -> String {
        let mut out =
            format!("//! What signals and objects mean.\n{NOTE}use crate::classes::classes;\n\n");
        out += "classes! {\n";
        for group in &self.groups {
            let _ = writeln!(out, "    /// {}.\n    {} {{", group.doc, variant(&group.name));
            for class in &group.classes {
                let (name, code) = (variant(&class.name), class.code);
                let _ = writeln!(
                    out,
                    "        /// {}\n        {name} = {code}, {:?}, {};",
                    class.doc,
                    class.name,
                    class.landmark.unwrap_or(group.landmark)
                );
            }
            out += "    }\n";
        }
        out += "}\n";
        out
    }

    /// Replaces what stands between the two marks of the page.
    fn splice(&self, page: &str) -> Result<String> {
        let start =
            page.find(START).context("docs/ontology.md lacks the mark where classes start")?;
        let start = start + START.len();
        let end = page.find(END).context("docs/ontology.md lacks the mark where classes end")?;
        let mut out = String::new();
        for group in &self.groups {
            let _ = write!(
                out,
                "\n**{}**\n\n| code | class | landmark | meaning |\n|---|---|---|---|\n",
                group.doc
            );
            for class in &group.classes {
                let landmark = if class.landmark.unwrap_or(group.landmark) { "yes" } else { "" };
                let Class { code, name, doc, .. } = class;
                let _ = writeln!(out, "| {code} | `{name}` | {landmark} | {doc} |");
            }
        }
        out.push('\n');
        Ok(format!("{}{}{}", &page[..start], out, &page[end..]))
    }
}

/// `speed_limit` as `SpeedLimit`.
fn variant(name: &str) -> String {
    name.split('_')
        .flat_map(|word| {
            let mut letters = word.chars();
            letters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(letters)
        })
        .collect()
}
