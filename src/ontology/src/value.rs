//! Values: where they are written, and in what unit.

use crate::file::{Entry, EntryFault, File};
use crate::pattern::WILD;
use std::collections::HashMap;

/// A unit, and what a number is multiplied with to be in SI units (m/s, m, kg).
pub(crate) type Unit = (&'static str, f64);

/// Units as in OpenDRIVE 1.4 to 1.9 (e_unit), and that of values whose unit nobody names: OpenDRIVE 1.6, 2.3.2, has SI units
/// wherever none is stated.
const UNITS: [Unit; 10] = [
    ("m/s", 1.0),
    ("km/h", 1.0 / 3.6),
    ("mph", 0.44704),
    ("m", 1.0),
    ("km", 1000.0),
    ("ft", 0.3048),
    ("mile", 1609.344),
    ("kg", 1.0),
    ("t", 1000.0),
    ("%", 0.01),
];

/// SI units, whatever the value measures.
pub(crate) const SI: Unit = ("SI", 1.0);

/// The unit of a name; none if OpenDRIVE does not have it.
pub(crate) fn unit(name: &str) -> Option<Unit> {
    UNITS.into_iter().chain([SI]).find(|(own, _)| *own == name)
}

/// Where a value is taken from.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Source {
    /// The attribute `value`, through a table of the file if one is named.
    Written(Option<HashMap<String, f64>>),
    /// The subtype, likewise.
    Subtype(Option<HashMap<String, f64>>),
    /// The number behind the text of this pattern in the name.
    Name(String),
    /// A number.
    Fixed(f64),
}

/// Reads `written subtype:speed 30` of an entry.
pub(crate) fn sources(entry: &Entry, file: &File) -> Result<Vec<Source>, EntryFault> {
    entry.value.split_whitespace().map(|word| source(word, entry, file)).collect()
}

fn source(word: &str, entry: &Entry, file: &File) -> Result<Source, EntryFault> {
    let (from, table) = match word.split_once(':') {
        Some((from, name)) => {
            let table = file.tables.get(name).ok_or_else(|| EntryFault::Table(name.to_owned()))?;
            (from, Some(table.clone()))
        }
        None => (word, None),
    };
    match (from, table) {
        ("written", table) => Ok(Source::Written(table)),
        ("subtype", table) => Ok(Source::Subtype(table)),
        ("name", None) => Ok(Source::Name(entry.name.clone().unwrap_or_default())),
        (number, None) => {
            let number = number.parse().map_err(|_| EntryFault::Word(number.to_owned()))?;
            Ok(Source::Fixed(number))
        }
        _ => Err(EntryFault::Word(word.to_owned())),
    }
}

impl Source {
    /// Whether the file states the number itself, so that it should state its unit too. Other values are codes: tables say what
    /// they stand for, unit and all.
    pub(crate) fn is_stated(&self) -> bool {
        matches!(self, Self::Written(None) | Self::Name(_))
    }

    /// The value, in the unit that the signal has.
    pub(crate) fn value(&self, written: Option<f64>, subtype: &str, name: &str) -> Option<f64> {
        let value = match self {
            // Files write −1 or 0 for "none".
            Self::Written(table) => {
                let value = written.filter(|value| *value > 0.0)?;
                match table {
                    Some(table) => *table.get(&format!("{value}"))?,
                    None => value,
                }
            }
            Self::Subtype(Some(table)) => *table.get(subtype)?,
            Self::Subtype(None) => subtype.parse().ok()?,
            Self::Name(pattern) => number_in(name, pattern)?,
            Self::Fixed(value) => *value,
        };
        (value.is_finite() && value > 0.0).then_some(value)
    }
}

/// The whole number behind the longest text of the pattern that the name fits: `Speed_*` reads 30 from `Speed_30_2`.
fn number_in(name: &str, pattern: &str) -> Option<f64> {
    let (name, pattern) = (name.to_lowercase(), pattern.to_lowercase());
    let text = pattern.split(WILD).max_by_key(|part| part.len())?;
    let behind = name.get(name.find(text)? + text.len()..)?;
    let end = behind.find(|c: char| !c.is_ascii_digit()).unwrap_or(behind.len());
    behind.get(..end)?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::number_in;

    #[test]
    fn numbers_in_names() {
        for (name, pattern, expected) in [
            ("Speed_30", "Speed_*", Some(30.0)),
            ("speed_50_4", "Speed_*", Some(50.0)),
            ("de_274-50", "de_274-*", Some(50.0)),
            ("Plan_1_3_Signs_SpeedLimit25_Inner", "*_SpeedLimit*", Some(25.0)),
            ("Speed_", "Speed_*", None),
            ("Speed_30_2", "Speed_#*", Some(30.0)),
        ] {
            assert_eq!(number_in(name, pattern), expected, "{name}");
        }
    }
}
