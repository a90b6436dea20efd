//! Reading entries: whole or not at all.

use crate::entry::Entry;
use crate::time::Moment;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use thiserror::Error;

/// How much there may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Entries in all.
    pub entries: usize,
    /// Of a document \[bytes\].
    pub bytes: usize,
}

impl Default for Limits {
    /// 10,000 entries, 4 MiB.
    fn default() -> Self {
        Self { entries: 10_000, bytes: 4 << 20 }
    }
}

/// Entries, in the order in which they were given.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Document {
    /// What is said.
    pub entries: Vec<Entry>,
}

/// Why a document is refused.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum DocumentError {
    /// Too long.
    #[error("{found} bytes; at most {most} are taken (--overlay-bytes)")]
    Bytes {
        /// Bytes there are.
        found: usize,
        /// Bytes that are taken.
        most: usize,
    },
    /// Too many.
    #[error("{found} entries; at most {most} are taken (--overlay-entries)")]
    Entries {
        /// Entries there are.
        found: usize,
        /// Entries that are taken.
        most: usize,
    },
    /// Not JSON, or not what the schema says.
    #[error("{place}: {why}")]
    Json {
        /// Where, such as `entries[3].lanes[0].s`.
        place: String,
        /// What is wrong.
        why: String,
    },
    /// An entry that cannot be.
    #[error("entry {id:?} (number {number}), {field}: {why}")]
    Entry {
        /// Its name.
        id: String,
        /// Its place in the document, from 0.
        number: usize,
        /// The field.
        field: String,
        /// What is wrong.
        why: String,
    },
}

impl Document {
    /// Reads a document.
    ///
    /// Errors: the first thing that is wrong, with its entry and field; then nothing is taken.
    pub fn read(text: &[u8], limits: &Limits) -> Result<Self, DocumentError> {
        if text.len() > limits.bytes {
            return Err(DocumentError::Bytes { found: text.len(), most: limits.bytes });
        }
        // serde would take an array for the fields in their order.
        if text.trim_ascii_start().starts_with(b"[") {
            let why = "expected an object with the field `entries`, found an array".to_owned();
            return Err(DocumentError::Json { place: "document".to_owned(), why });
        }
        let mut reader = serde_json::Deserializer::from_slice(text);
        let document: Self = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
            let (place, why) = (error.path().to_string(), error.into_inner().to_string());
            DocumentError::Json { place: if place == "." { "document".into() } else { place }, why }
        })?;
        reader.end().map_err(|error| DocumentError::Json {
            place: "document".to_owned(),
            why: error.to_string(),
        })?;
        document.check(limits)?;
        Ok(document)
    }

    /// Checks what [`Document::read`] checks beyond the form, for entries that were read otherwise.
    ///
    /// Errors: the first thing that is wrong, with its entry and field.
    pub fn check(&self, limits: &Limits) -> Result<(), DocumentError> {
        if self.entries.len() > limits.entries {
            return Err(DocumentError::Entries { found: self.entries.len(), most: limits.entries });
        }
        let mut names = BTreeSet::new();
        for (number, entry) in self.entries.iter().enumerate() {
            let twice = || ("id".to_owned(), "another entry has it".to_owned());
            let twice = (!names.insert(&entry.id)).then(twice);
            if let Some((field, why)) = twice.or_else(|| entry.wrong()) {
                return Err(DocumentError::Entry { id: entry.id.clone(), number, field, why });
            }
        }
        Ok(())
    }

    /// Takes over the entries of another document: those of the same name are replaced in their place.
    ///
    /// Errors: there would be too many, or one has the name of an entry that another feed said; nothing is changed then.
    pub fn apply(&mut self, other: Self, limits: &Limits) -> Result<(), DocumentError> {
        let mut all = self.entries.clone();
        let mut known: std::collections::BTreeMap<String, usize> =
            all.iter().enumerate().map(|(i, entry)| (entry.id.clone(), i)).collect();
        for (number, entry) in other.entries.into_iter().enumerate() {
            match known.get(&entry.id).and_then(|i| all.get_mut(*i)) {
                // What one feed closed, another would open.
                Some(own) if own.feed != entry.feed => {
                    let why = match own.feed.as_str() {
                        "" => "an entry of no feed has it already".to_owned(),
                        feed => format!("an entry of the feed {feed:?} has it already"),
                    };
                    let (id, field) = (entry.id, "id".to_owned());
                    return Err(DocumentError::Entry { id, number, field, why });
                }
                Some(own) => *own = entry,
                None => {
                    known.insert(entry.id.clone(), all.len());
                    all.push(entry);
                }
            }
        }
        let all = Self { entries: all };
        all.check(limits)?;
        *self = all;
        Ok(())
    }

    /// Says of all entries that they come from a feed.
    pub fn set_feed(&mut self, feed: &str) {
        self.entries.iter_mut().for_each(|entry| feed.clone_into(&mut entry.feed));
    }

    /// Removes entries of a feed that another document does not have, unless it could not be read what became of them
    /// ([`Feed::unread`](crate::Feed::unread)).
    pub fn forget_of_feed(&mut self, feed: &str, kept: &Self, unread: &[String]) {
        let kept: BTreeSet<&str> = kept.entries.iter().map(|entry| entry.id.as_str()).collect();
        let unread: BTreeSet<&str> = unread.iter().map(String::as_str).collect();
        let is_unread = |id: &str| {
            let features = id.match_indices('/').filter_map(|(end, _)| id.get(..end));
            ["", id].into_iter().chain(features).any(|name| unread.contains(name))
        };
        self.entries.retain(|entry| {
            entry.feed != feed || kept.contains(entry.id.as_str()) || is_unread(&entry.id)
        });
    }

    /// Removes entries by name; the first name that there is none of, if there is one: nothing is removed then.
    pub fn remove(&mut self, ids: &[String]) -> Result<(), String> {
        let known: BTreeSet<&str> = self.entries.iter().map(|entry| entry.id.as_str()).collect();
        if let Some(unknown) = ids.iter().find(|id| !known.contains(id.as_str())) {
            return Err(unknown.clone());
        }
        self.entries.retain(|entry| !ids.contains(&entry.id));
        Ok(())
    }

    /// Forgets entries that ended before a moment.
    pub fn forget_ended(&mut self, now: Moment) {
        self.entries.retain(|entry| entry.until.is_none_or(|until| until > now));
    }

    /// As JSON.
    pub fn to_json(&self) -> String {
        // Nothing in a document cannot be written.
        serde_json::to_string(self).unwrap_or_default()
    }
}
