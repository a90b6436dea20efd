//! Versions of the standard, sets of them, and values that change with them.

use serde::{Deserialize, Deserializer, de::Error as _};
use std::fmt;

/// The versions of the table, oldest first. 1.6 stands for 1.6.1 too: they do not differ.
pub const VERSIONS: [&str; 7] = ["1.4", "1.5", "1.6", "1.7", "1.8", "1.8.1", "1.9"];

/// A version: its rank in [`VERSIONS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Version(usize);

impl Version {
    /// The first version for whose files the text's own view of what is required is applied.
    pub(super) const TEXT: Self = Self(4);

    fn parse(text: &str) -> Option<Self> {
        VERSIONS.iter().position(|version| *version == text).map(Self)
    }
}

impl fmt::Display for Version {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(VERSIONS[self.0])
    }
}

impl<'de> Deserialize<'de> for Version {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        Self::parse(&text).ok_or_else(|| D::Error::custom(format!("no version {text}")))
    }
}

/// A set of versions, one bit for each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VersionSet(u8);

impl VersionSet {
    /// No version.
    pub const NONE: Self = Self(0);
    /// Every version.
    pub const ALL: Self = Self((1 << VERSIONS.len()) - 1);

    /// From one version to another, both included; from the oldest, to the newest, where none is given.
    pub fn between(since: Option<Version>, until: Option<Version>) -> Self {
        let first = since.map_or(0, |version| version.0);
        let last = until.map_or(VERSIONS.len() - 1, |version| version.0);
        Self((first..=last).fold(0, |set, version| set | 1 << version))
    }

    /// What both have.
    pub fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// What the other does not have.
    pub fn without(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// Whether a version, by its rank, belongs to it.
    pub fn has(self, version: usize) -> bool {
        self.0 >> version & 1 == 1
    }

    /// The bits.
    pub fn bits(self) -> u8 {
        self.0
    }

    /// As words: "1.5 to 1.8", "since 1.5", "1.4 and 1.9"; empty for all.
    pub fn words(self) -> String {
        let ranks: Vec<usize> = (0..VERSIONS.len()).filter(|rank| self.has(*rank)).collect();
        let (Some(first), Some(last)) = (ranks.first(), ranks.last()) else {
            return "never".to_owned();
        };
        let whole = ranks.len() == last - first + 1;
        match (whole, *first, *last) {
            (true, 0, last) if last + 1 == VERSIONS.len() => String::new(),
            (true, first, last) if last + 1 == VERSIONS.len() => {
                format!("since {}", VERSIONS[first])
            }
            (true, first, last) if first == last => format!("in {}", VERSIONS[first]),
            (true, 0, last) => format!("until {}", VERSIONS[last]),
            (true, first, last) => format!("{} to {}", VERSIONS[first], VERSIONS[last]),
            (false, ..) => {
                let names: Vec<&str> = ranks.iter().map(|rank| VERSIONS[*rank]).collect();
                format!("in {}", names.join(", "))
            }
        }
    }
}

/// A value that may change with the version: "1.4: optional; 1.5: required", or one for all.
#[derive(Clone, Debug)]
pub struct Spanned<T> {
    steps: Vec<(Version, T)>,
}

impl<T> Spanned<T> {
    /// One value for all versions.
    pub fn always(value: T) -> Self {
        Self { steps: vec![(Version(0), value)] }
    }

    /// The value of the newest version.
    pub fn last(&self) -> &T {
        &self.steps[self.steps.len() - 1].1
    }

    /// The value in a version, by its rank; none before the first.
    pub fn at(&self, version: usize) -> Option<&T> {
        self.steps.iter().rev().find(|(since, _)| since.0 <= version).map(|(_, value)| value)
    }

    /// All values, oldest first.
    pub fn values(&self) -> impl Iterator<Item = &T> {
        self.steps.iter().map(|(_, value)| value)
    }

    /// Versions whose value is as asked.
    pub fn versions(&self, is: impl Fn(&T) -> bool) -> VersionSet {
        let ranks = (0..VERSIONS.len()).filter(|version| self.at(*version).is_some_and(&is));
        VersionSet(ranks.fold(0, |set, version| set | 1 << version))
    }
}

/// Reading one value of a [`Spanned`].
pub trait FromText: Sized {
    /// None for text that is no such value.
    fn from_text(text: &str) -> Option<Self>;
}

impl FromText for String {
    fn from_text(text: &str) -> Option<Self> {
        Some(text.to_owned())
    }
}

/// How often a child stands in its parent: "1..*".
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Occurs {
    /// At least.
    pub min: u16,
    /// At most; none for any number.
    pub max: Option<u16>,
}

impl FromText for Occurs {
    fn from_text(text: &str) -> Option<Self> {
        let (min, max) = text.split_once("..")?;
        let max = if max == "*" { None } else { Some(max.parse().ok()?) };
        Some(Self { min: min.parse().ok()?, max })
    }
}

impl<'de, T: FromText> Deserialize<'de> for Spanned<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let wrong = || D::Error::custom(format!("cannot read {text:?}"));
        let mut steps = Vec::new();
        for step in text.split("; ") {
            let (since, value) = match step.split_once(": ") {
                Some((since, value)) => (Version::parse(since).ok_or_else(wrong)?, value),
                None => (Version(0), step),
            };
            steps.push((since, T::from_text(value).ok_or_else(wrong)?));
        }
        if steps.is_empty() || !steps.is_sorted_by(|a, b| a.0 < b.0) {
            return Err(wrong());
        }
        Ok(Self { steps })
    }
}
