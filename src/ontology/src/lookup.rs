//! From what is written to what it means.

use crate::entry::{Question, Ready};
use crate::file::{Entry, EntryFault, File, Lights, OntologyError};
use crate::generated::TABLES;
use crate::light::Light;
use crate::value::{SI, Source, Unit, unit};
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
    /// The unit in which a number was read that the file states without one, such as `km/h`, or `SI`; none where the unit is
    /// written, and where the value is part of the code.
    pub assumed_unit: Option<&'static str>,
    /// What it can show, if it is a light.
    pub light: Option<Light>,
}

const UNKNOWN: Meaning =
    Meaning { class: Class::Unknown, value: None, assumed_unit: None, light: None };

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
    /// Of values that are written without one.
    unit: Option<Unit>,
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
            let read = toml::from_str::<Lights>(text).map_err(|error| form(file, text, &error));
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
        let read: File = toml::from_str(text).map_err(|error| form(file, text, &error))?;
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
            unit: read.unit.as_deref().and_then(unit),
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
        found.map_or(UNKNOWN, |entry| {
            meaning(entry, code, &subtype, || self.unit_without_any(entry, &country))
        })
    }

    /// The unit of a number that the file states without one: that of the country's own table, or of the entry where the table
    /// says otherwise; SI units for the generic catalogue and for countries without a table, as the standard has it.
    fn unit_without_any(&self, entry: &Ready, country: &str) -> Unit {
        if entry.is_everywhere {
            return entry.unit_here.unwrap_or(SI);
        }
        let all = || self.user.iter().chain(self.standard.iter());
        let own = || all().filter(|table| table.is_for(country) && table.name != SEMANTICS);
        let mut of_country = own().find_map(|table| table.unit);
        let mut next = own().next();
        for _ in 0..DEEPEST_BASE {
            let Some(table) = next.filter(|_| of_country.is_none()) else { break };
            of_country = table.unit;
            next = all().find(|one| Some(&one.name) == table.base.as_ref());
        }
        match of_country {
            None | Some(SI) => SI,
            Some(of_country) => entry.unit.unwrap_or(of_country),
        }
    }

    /// What an element of `signal/semantics` means: `element` such as `speed`, `kind` its `type`.
    pub fn semantics(&self, element: &str, kind: &str, value: Option<f64>, unit: &str) -> Meaning {
        let (r#type, subtype) = (element.to_lowercase(), kind.to_lowercase());
        let question = Question { r#type: &r#type, subtype: &subtype, name: "" };
        let tables = self.user.iter().chain(self.standard.iter());
        let mut of = tables.filter(|table| table.countries.iter().any(|one| one == SEMANTICS));
        let code = SignalCode { value, unit, ..SignalCode::default() };
        let found = of.find_map(|table| best(&table.signals, question, |_| true));
        found.map_or(UNKNOWN, |entry| meaning(entry, &code, &subtype, || here(entry)))
    }

    /// What an object means, with the value that its name states.
    pub fn object(&self, code: &ObjectCode<'_>) -> Meaning {
        let (r#type, subtype) = (absent(code.r#type), absent(code.subtype));
        let name = code.name.to_lowercase();
        let question = Question { r#type: &r#type, subtype: &subtype, name: &name };
        let found = self.entry("", question, |table| &table.objects);
        let named = SignalCode { name: code.name, ..SignalCode::default() };
        found.map_or(UNKNOWN, |entry| meaning(entry, &named, &subtype, || here(entry)))
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

/// The unit of values in the file that an entry stands in.
fn here(entry: &Ready) -> Unit {
    entry.unit_here.unwrap_or(SI)
}

/// What an entry says of a code; `without_any`: the unit of numbers that the file states without one.
fn meaning(
    entry: &Ready,
    code: &SignalCode<'_>,
    subtype: &str,
    without_any: impl FnOnce() -> Unit,
) -> Meaning {
    let value =
        |source: &Source| Some((source.value(code.value, subtype, code.name)?, source.is_stated()));
    let Some((value, is_stated)) = entry.sources.iter().find_map(value) else {
        return Meaning { class: entry.class, light: entry.light, ..UNKNOWN };
    };
    let written = unit(code.unit);
    let is_assumed = is_stated && written.is_none();
    let (name, factor) =
        written.unwrap_or_else(|| if is_stated { without_any() } else { here(entry) });
    Meaning {
        class: entry.class,
        value: Some(value * factor),
        assumed_unit: is_assumed.then_some(name),
        light: entry.light,
    }
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

fn form(file: &str, text: &str, error: &toml::de::Error) -> OntologyError {
    let before = error.span().and_then(|span| text.get(..span.start)).unwrap_or_default();
    let line = before.matches('\n').count() + 1;
    let message = format!("at line {line}: {}", error.message().replace('\n', ", "));
    OntologyError::Form { file: file.to_owned(), message }
}

fn in_entry(file: &str, entry: &str, wrong: &EntryFault) -> OntologyError {
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
