//! The form of a table's file.

use serde::Deserialize;
use std::collections::HashMap;

/// A file of `schemas/ontology`, or of the user's.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct File {
    pub(crate) name: String,
    #[serde(default, rename = "doc")]
    _doc: String,
    /// Countries as maps write them; `*`: every country.
    #[serde(default)]
    pub(crate) countries: Vec<String>,
    /// The table that is asked where this one knows nothing.
    pub(crate) base: Option<String>,
    /// Unit of values that have none.
    pub(crate) unit: Option<String>,
    /// From what is written to what is meant.
    #[serde(default)]
    pub(crate) tables: HashMap<String, HashMap<String, f64>>,
    #[serde(default)]
    pub(crate) signals: Vec<Entry>,
    #[serde(default)]
    pub(crate) objects: Vec<Entry>,
    #[serde(default, rename = "section")]
    pub(crate) sections: Vec<Section>,
    /// Lights of the user's own.
    #[serde(default, rename = "light")]
    pub(crate) lights: Vec<LightEntry>,
}

/// Entries that belong together.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Section {
    #[serde(rename = "doc")]
    _doc: String,
    #[serde(default)]
    pub(crate) signals: Vec<Entry>,
    #[serde(default)]
    pub(crate) objects: Vec<Entry>,
}

/// What is written, and what it means.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Entry {
    pub(crate) r#type: Option<String>,
    pub(crate) subtype: Option<String>,
    pub(crate) name: Option<String>,
    pub(crate) class: String,
    /// Where the value is taken from, separated by spaces.
    #[serde(default)]
    pub(crate) value: String,
    pub(crate) unit: Option<String>,
    pub(crate) light: Option<String>,
    #[serde(default)]
    pub(crate) arrows: Vec<String>,
}

/// `lights.toml`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Lights {
    #[serde(rename = "light")]
    pub(crate) lights: Vec<LightEntry>,
}

/// What a light can show.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LightEntry {
    pub(crate) name: String,
    #[serde(default, rename = "doc")]
    _doc: String,
    pub(crate) bulbs: Vec<String>,
    pub(crate) phases: Vec<String>,
}

/// What is wrong with an entry.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub(crate) enum EntryFault {
    /// A class that the vocabulary does not have.
    #[error("class `{0}` is not in the vocabulary of docs/ontology.md")]
    Class(String),
    /// A light that no table describes.
    #[error("light `{0}` is not in lights.toml")]
    Light(String),
    /// A unit that OpenDRIVE does not have.
    #[error("unit `{0}` is not one of OpenDRIVE's")]
    Unit(String),
    /// A table of values that the file does not have.
    #[error("the file has no `[tables.{0}]`")]
    Table(String),
    /// A word that is none of those allowed.
    #[error("`{0}` is not a known word")]
    Word(String),
    /// An entry that fits everything.
    #[error("needs type, subtype or name")]
    Nothing,
}

/// Why a file cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum OntologyError {
    /// It is not TOML of the right form.
    #[error("{file}: {message}")]
    Form {
        /// The file.
        file: String,
        /// What the reader says, with line and column.
        message: String,
    },
    /// An entry says something that cannot be.
    #[error("{file}: entry {entry}: {message}")]
    Entry {
        /// The file.
        file: String,
        /// The entry's type, subtype and name.
        entry: String,
        /// What is wrong.
        message: String,
    },
    /// It is based on a table that does not exist.
    #[error("{file}: no table is called `{base}`")]
    Base {
        /// The file.
        file: String,
        /// The name.
        base: String,
    },
}
