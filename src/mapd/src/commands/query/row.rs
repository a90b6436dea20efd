//! One row of the input, by column names.

use csv::StringRecord;
use mapd_query::glam::DVec2;

/// A row with its header.
pub(crate) struct Row<'a> {
    headers: &'a StringRecord,
    record: &'a StringRecord,
}

impl<'a> Row<'a> {
    pub(crate) fn new(headers: &'a StringRecord, record: &'a StringRecord) -> Self {
        Self { headers, record }
    }

    /// A column's text; an error that names the column where the row ends before it.
    pub(crate) fn text(&self, name: &str) -> Result<&'a str, String> {
        self.headers
            .iter()
            .position(|header| header == name)
            .and_then(|i| self.record.get(i))
            .ok_or_else(|| format!("expected a value in column {name}, found none"))
    }

    /// Whether the input has a column.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.headers.iter().any(|header| header == name)
    }

    /// A finite number.
    pub(crate) fn number(&self, name: &str) -> Result<f64, String> {
        let text = self.text(name)?;
        match text.trim().parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(format!("expected a finite number in column {name}, found {text:?}")),
        }
    }

    /// A finite number, or nothing where the column is absent or empty.
    pub(crate) fn optional(&self, name: &str) -> Result<Option<f64>, String> {
        match self.text(name) {
            Err(_) => Ok(None),
            Ok(text) if text.trim().is_empty() => Ok(None),
            Ok(_) => self.number(name).map(Some),
        }
    }

    /// A point and a radius that is not negative, from the columns x, y and radius.
    pub(crate) fn circle(&self) -> Result<(DVec2, f64), String> {
        let point = DVec2::new(self.number("x")?, self.number("y")?);
        Ok((point, self.not_negative("radius")?))
    }

    /// A finite number that is not negative.
    pub(crate) fn not_negative(&self, name: &str) -> Result<f64, String> {
        match self.number(name)? {
            number if number < 0.0 => Err(format!("{name} must not be negative, found {number:?}")),
            number => Ok(number),
        }
    }

    /// A lane number.
    pub(crate) fn lane_number(&self, name: &str) -> Result<i32, String> {
        let text = self.text(name)?;
        text.trim()
            .parse()
            .map_err(|_| format!("expected a lane number in column {name}, found {text:?}"))
    }
}
