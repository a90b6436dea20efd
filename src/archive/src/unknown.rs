//! What an archive of another release has that this one does not know: no error, but worth a warning.

use crate::directory::directory;
use crate::error::OpenError;
use crate::generated::known_tables::TABLES;
use crate::open::open;
use std::fmt;

/// Something that this release does not know.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unknown {
    /// A table.
    Table {
        /// Its number.
        number: u32,
        /// Bytes of a row.
        row_bytes: u32,
        /// Number of rows.
        count: u64,
    },
    /// Codes of a field; they are read as `Unknown`.
    Code {
        /// Name of the table.
        table: &'static str,
        /// Field of the rows.
        field: &'static str,
        /// The first such code.
        code: u8,
        /// The row that has it, from 0.
        row: usize,
        /// How many rows have such codes.
        rows: usize,
    },
}

impl fmt::Display for Unknown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Table { number, row_bytes, count } => write!(
                f,
                "table {number} with {count} rows of {row_bytes} bytes is not known to this release; it is left alone"
            ),
            Self::Code { table, field, code, row, rows } => write!(
                f,
                "table `{table}`, row {row}: {field} has code {code}, which this release does not know; {rows} rows have such codes"
            ),
        }
    }
}

/// Codes that are not known, one entry for each field.
#[derive(Default)]
pub(crate) struct UnknownCodes(Vec<Unknown>);

impl UnknownCodes {
    /// Notes a code if it is none of so many.
    #[inline]
    pub(crate) fn note(
        &mut self,
        table: &'static str,
        field: &'static str,
        row: usize,
        code: u8,
        codes: u8,
    ) {
        if code >= codes {
            self.note_unknown(table, field, row, code);
        }
    }

    #[cold]
    fn note_unknown(&mut self, table: &'static str, field: &'static str, row: usize, code: u8) {
        let same = |known: &&mut Unknown| matches!(known, Unknown::Code { table: t, field: f, .. } if (*t, *f) == (table, field));
        match self.0.iter_mut().find(same) {
            Some(Unknown::Code { rows, .. }) => *rows += 1,
            _ => self.0.push(Unknown::Code { table, field, code, row, rows: 1 }),
        }
    }
}

/// What an archive has that this release does not know: tables by number, then codes. Linear in its size.
///
/// Errors: as [`open`].
pub fn unknown(bytes: &[u8]) -> Result<Vec<Unknown>, OpenError> {
    let archive = open(bytes)?;
    let is_known = |number| TABLES.iter().any(|kind| kind.number == number);
    let tables = directory(bytes)?.into_iter().filter(|entry| !is_known(entry.number));
    let tables = tables.map(|entry| Unknown::Table {
        number: entry.number,
        row_bytes: entry.row_bytes,
        count: entry.count,
    });
    let mut codes = UnknownCodes::default();
    archive.tables.note_unknown_codes(&mut codes);
    Ok(tables.chain(codes.0).collect())
}
