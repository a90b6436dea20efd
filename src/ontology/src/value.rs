//! Values: where they are written, and in what unit.

use crate::file::{File, Wrong};
use std::collections::HashMap;

/// What a number is multiplied with to be in SI units (m/s, m, kg). Units as in OpenDRIVE 1.4 to 1.9 (e_unit).
pub(crate) fn factor(unit: &str) -> Option<f64> {
    Some(match unit {
        "m/s" | "m" | "kg" => 1.0,
        "km/h" => 1.0 / 3.6,
        "mph" => 0.44704,
        "km" | "t" => 1000.0,
        "ft" => 0.3048,
        "mile" => 1609.344,
        "%" => 0.01,
        _ => return None,
    })
}

/// Where a value is taken from.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Source {
    /// The attribute `value`, through a table of the file if one is named.
    Written(Option<HashMap<String, f64>>),
    /// The subtype, likewise.
    Subtype(Option<HashMap<String, f64>>),
    /// The last number in the name.
    Name,
    /// A number.
    Fixed(f64),
}

/// Reads `written subtype:speed 30`.
pub(crate) fn sources(text: &str, file: &File) -> Result<Vec<Source>, Wrong> {
    text.split_whitespace().map(|word| source(word, file)).collect()
}

fn source(word: &str, file: &File) -> Result<Source, Wrong> {
    let (from, table) = match word.split_once(':') {
        Some((from, name)) => {
            let table = file.tables.get(name).ok_or_else(|| Wrong::Table(name.to_owned()))?;
            (from, Some(table.clone()))
        }
        None => (word, None),
    };
    match (from, table) {
        ("written", table) => Ok(Source::Written(table)),
        ("subtype", table) => Ok(Source::Subtype(table)),
        ("name", None) => Ok(Source::Name),
        (number, None) => {
            let number = number.parse().map_err(|_| Wrong::Word(number.to_owned()))?;
            Ok(Source::Fixed(number))
        }
        _ => Err(Wrong::Word(word.to_owned())),
    }
}

impl Source {
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
            Self::Name => number_in(name)?,
            Self::Fixed(value) => *value,
        };
        (value.is_finite() && value > 0.0).then_some(value)
    }
}

/// The first whole number in a text that no other number's letters join: `speed_30_2` gives 30, `de_274-50` 50 after the dash.
fn number_in(name: &str) -> Option<f64> {
    let text = name.rsplit_once('-').map_or(name, |(_, after)| after);
    let digits = text.split(|c: char| !c.is_ascii_digit()).find(|part| !part.is_empty())?;
    digits.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::number_in;

    #[test]
    fn numbers_in_names() {
        for (name, expected) in [
            ("Speed_30", Some(30.0)),
            ("speed_50_4", Some(50.0)),
            ("de_274-50", Some(50.0)),
            ("stop", None),
        ] {
            assert_eq!(number_in(name), expected, "{name}");
        }
    }
}
