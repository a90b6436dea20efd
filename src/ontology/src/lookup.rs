//! From what is written to what it means.

use crate::entry::{Question, Ready};
use crate::file::{Entry, File, Lights, OntologyError, Wrong};
use crate::generated::TABLES;
use crate::light::Light;
use crate::value::factor;
use mapd_archive::Class;
use std::collections::HashMap;
use std::sync::{Arc, LazyLock};

/// What a signal writes about itself; empty where it writes nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct SignalCode<'a> {
    /// `country`.
    pub country: &'a str,
    /// `type`.
    pub r#type: &'a str,
    /// `subtype`.
    pub subtype: &'a str,
    /// `name`.
    pub name: &'a str,
    /// `value`.
    pub value: Option<f64>,
    /// `unit`.
    pub unit: &'a str,
}

/// What an object writes about itself; empty where it writes nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct ObjectCode<'a> {
    /// `type`.
    pub r#type: &'a str,
    /// `subtype`.
    pub subtype: &'a str,
    /// `name`.
    pub name: &'a str,
}

/// What a signal means.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meaning {
    /// The class.
    pub class: Class,
    /// Its value in m/s, m or kg, if it has one.
    pub value: Option<f64>,
    /// What it can show, if it is a light.
    pub light: Option<Light>,
}

const UNKNOWN: Meaning = Meaning { class: Class::Unknown, value: None, light: None };

/// Files with a place of their own in the order.
const GENERIC: &str = "opendrive";
const SEMANTICS: &str = "semantics";
const VENDORS: &str = "vendors";
const LIGHTS: &str = "lights.toml";

/// Tables that base on each other are followed so far; a loop of bases ends there.
const DEEPEST_BASE: usize = 8;

#[derive(Clone, Debug)]
struct Table {
    name: String,
    /// In lower case.
    countries: Vec<String>,
    base: Option<String>,
    signals: Vec<Ready>,
    objects: Vec<Ready>,
}

/// The tables, those of mapd and those of the user.
#[derive(Clone, Debug)]
pub struct Ontology {
    standard: Arc<Vec<Table>>,
    user: Vec<Table>,
    /// Texts of the user's tables, the last one first.
    texts: Vec<String>,
    lights: HashMap<String, Light>,
}

/// mapd's own tables, read once.
static STANDARD: LazyLock<Ontology> = LazyLock::new(Ontology::read_standard);

impl Default for Ontology {
    fn default() -> Self {
        Self::standard()
    }
}

impl Ontology {
    /// mapd's own tables.
    pub fn standard() -> Self {
        STANDARD.clone()
    }

    fn read_standard() -> Self {
        let mut ontology = Self {
            standard: Arc::default(),
            user: Vec::new(),
            texts: Vec::new(),
            lights: HashMap::new(),
        };
        for (file, text) in TABLES.iter().filter(|(file, _)| *file == LIGHTS) {
            let read = toml::from_str::<Lights>(text).map_err(|error| form(file, &error));
            if let Ok(lights) = read {
                for light in &lights.lights {
                    ontology.lights.extend(light.light().map(|bits| (light.name.clone(), bits)));
                }
            }
        }
        // The tables come with the build; a test reads each of them.
        let tables = TABLES.iter().filter(|(file, _)| *file != LIGHTS);
        let read = tables.filter_map(|(file, text)| ontology.table(file, text).ok()).collect();
        ontology.standard = Arc::new(read);
        ontology
    }

    /// Adds a user's table, which is asked before all others; `file` names it in errors.
    ///
    /// Errors: the text is no TOML, or says something that cannot be.
    pub fn extend(&mut self, file: &str, text: &str) -> Result<(), OntologyError> {
        let table = self.table(file, text)?;
        if let Some(base) = &table.base {
            let known = self.standard.iter().chain(self.user.iter()).any(|one| one.name == *base);
            if !known && *base != table.name {
                return Err(OntologyError::Base { file: file.to_owned(), base: base.clone() });
            }
        }
        self.user.insert(0, table);
        self.texts.insert(0, text.to_owned());
        Ok(())
    }

    fn table(&self, file: &str, text: &str) -> Result<Table, OntologyError> {
        let read: File = toml::from_str(text).map_err(|error| form(file, &error))?;
        let mut lights = self.lights.clone();
        for light in &read.lights {
            let bits = light.light().map_err(|wrong| in_entry(file, &light.name, &wrong))?;
            lights.insert(light.name.clone(), bits);
        }
        let ready = |entry: &Entry| {
            Ready::new(entry, &read, &lights).map_err(|wrong| in_entry(file, &named(entry), &wrong))
        };
        let signals = read.signals.iter().chain(read.sections.iter().flat_map(|s| &s.signals));
        let objects = read.objects.iter().chain(read.sections.iter().flat_map(|s| &s.objects));
        Ok(Table {
            signals: signals.map(ready).collect::<Result<_, _>>()?,
            objects: objects.map(ready).collect::<Result<_, _>>()?,
            countries: read.countries.iter().map(|country| country.to_lowercase()).collect(),
            name: read.name,
            base: read.base,
        })
    }

    /// What a signal means.
    pub fn signal(&self, code: &SignalCode<'_>) -> Meaning {
        let (country, r#type) = (code.country.trim().to_lowercase(), absent(code.r#type));
        let (subtype, name) = (absent(code.subtype), code.name.to_lowercase());
        let question = Question { r#type: &r#type, subtype: &subtype, name: &name };
        let found = self.entry(&country, question, |table| &table.signals);
        found.map_or(UNKNOWN, |entry| meaning(entry, code, &subtype))
    }

    /// What an element of `signal/semantics` means: `element` such as `speed`, `kind` its `type`.
    pub fn semantics(&self, element: &str, kind: &str, value: Option<f64>, unit: &str) -> Meaning {
        let (r#type, subtype) = (element.to_lowercase(), kind.to_lowercase());
        let question = Question { r#type: &r#type, subtype: &subtype, name: "" };
        let tables = self.user.iter().chain(self.standard.iter());
        let mut of = tables.filter(|table| table.countries.iter().any(|one| one == SEMANTICS));
        let code = SignalCode { value, unit, ..SignalCode::default() };
        let found = of.find_map(|table| best(&table.signals, question, |_| true));
        found.map_or(UNKNOWN, |entry| meaning(entry, &code, &subtype))
    }

    /// What an object means.
    pub fn object(&self, code: &ObjectCode<'_>) -> Class {
        let (r#type, subtype) = (absent(code.r#type), absent(code.subtype));
        let name = code.name.to_lowercase();
        let question = Question { r#type: &r#type, subtype: &subtype, name: &name };
        let found = self.entry("", question, |table| &table.objects);
        found.map_or(Class::Unknown, |entry| entry.class)
    }

    fn entry(
        &self,
        country: &str,
        question: Question<'_>,
        of: impl Fn(&Table) -> &[Ready],
    ) -> Option<&Ready> {
        let ours = |table: &&Table| table.is_for(country) || table.is_for_all();
        let vendors = || self.standard.iter().filter(|table| table.name == VENDORS);
        let user = self.user.iter().filter(ours).find_map(|t| best(of(t), question, |_| true));
        user.or_else(|| vendors().find_map(|t| best(of(t), question, Ready::names_type_and_name)))
            .or_else(|| self.along_bases(country, |table| best(of(table), question, |_| true)))
            .or_else(|| vendors().find_map(|t| best(of(t), question, Ready::names_type)))
            .or_else(|| vendors().find_map(|t| best(of(t), question, |_| true)))
    }

    /// Asks the country's table, then those that it is based on, then the generic catalogue, whose own numbers mean the same
    /// everywhere.
    fn along_bases<'a>(
        &'a self,
        country: &str,
        ask: impl Fn(&'a Table) -> Option<&'a Ready>,
    ) -> Option<&'a Ready> {
        let all = || self.user.iter().chain(self.standard.iter());
        let own = |table: &&Table| table.is_for(country) && table.name != SEMANTICS;
        let generic = || all().find(|table| table.name == GENERIC);
        let mut next = all().find(own).or_else(generic);
        for _ in 0..DEEPEST_BASE {
            let Some(table) = next else { break };
            if let Some(found) = ask(table) {
                return Some(found);
            }
            // A user's table for a country that has one goes before it.
            let later = self.standard.iter().filter(own).find(|one| one.name == table.name);
            next = later
                .filter(|later| !std::ptr::eq(*later, table))
                .or_else(|| all().find(|one| Some(&one.name) == table.base.as_ref()));
        }
        generic().and_then(ask)
    }

    /// Texts of the user's tables, the last one first.
    pub fn user_texts(&self) -> &[String] {
        &self.texts
    }
}

impl Table {
    fn is_for(&self, country: &str) -> bool {
        self.countries.iter().any(|one| one == country)
    }

    fn is_for_all(&self) -> bool {
        self.countries.iter().any(|one| one == "*")
    }
}

/// The entry that fits best; of equal ones the later.
fn best<'a>(
    entries: &'a [Ready],
    question: Question<'_>,
    counts: impl Fn(&Ready) -> bool,
) -> Option<&'a Ready> {
    let fitting = entries.iter().filter(|entry| counts(entry));
    let fitting = fitting.filter_map(|entry| Some((entry.fit(question)?, entry)));
    fitting.max_by_key(|(fit, _)| *fit).map(|(_, entry)| entry)
}

fn meaning(entry: &Ready, code: &SignalCode<'_>, subtype: &str) -> Meaning {
    let found = entry.sources.iter().find_map(|s| s.value(code.value, subtype, code.name));
    let unit = factor(code.unit).or_else(|| entry.unit.as_deref().and_then(factor));
    let value = found.map(|value| value * unit.unwrap_or(1.0));
    Meaning { class: entry.class, value, light: entry.light }
}

/// In lower case; files write `-1` and `none` for what is not there.
fn absent(text: &str) -> String {
    let text = text.trim().to_lowercase();
    if text == "-1" || text == "none" { String::new() } else { text }
}

fn named(entry: &Entry) -> String {
    let parts = [&entry.r#type, &entry.subtype, &entry.name];
    parts.into_iter().flatten().map(String::as_str).collect::<Vec<_>>().join(" ")
}

fn form(file: &str, error: &toml::de::Error) -> OntologyError {
    OntologyError::Form { file: file.to_owned(), message: error.to_string().trim().to_owned() }
}

fn in_entry(file: &str, entry: &str, wrong: &Wrong) -> OntologyError {
    OntologyError::Entry {
        file: file.to_owned(),
        entry: entry.to_owned(),
        message: wrong.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_of_the_build_reads() {
        let ontology = Ontology::standard();
        for (file, text) in TABLES.iter().filter(|(file, _)| *file != LIGHTS) {
            let table = ontology.table(file, text).unwrap_or_else(|error| panic!("{error}"));
            let known = |base: &String| ontology.standard.iter().any(|one| one.name == *base);
            assert!(table.base.as_ref().is_none_or(known), "{file}");
        }
        assert!(ontology.lights.len() > 5);
    }
}
