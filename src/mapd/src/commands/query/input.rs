//! How questions are read: CSV whose rows are bounded, and whose quotes are closed.
//!
//! The crate takes a file's end for the end of a quote, and a row of any length. Both are looked at on the way to it.

use std::io::{self, Read};
use thiserror::Error;

/// Longest row of an input \[bytes\]; those that people and programs write have some hundreds.
const LONGEST_ROW: usize = 1 << 20;

/// What is wrong with an input.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub(in crate::commands) enum InputError {
    /// A quote that nothing closes.
    #[error("line {line}: a quote opens that is not closed")]
    Quote {
        /// Where it opens, from 1.
        line: u64,
    },
    /// A row that is too long.
    #[error("line {line}: the row is longer than {LONGEST_ROW} bytes")]
    TooLong {
        /// Where it begins, from 1.
        line: u64,
    },
}

impl InputError {
    /// Whether an error of the crate is about what the input says: one of these, or bytes that are not UTF-8; not about reading or writing.
    pub(in crate::commands) fn is_about_input(error: &csv::Error) -> bool {
        match error.kind() {
            csv::ErrorKind::Io(io) => io.get_ref().is_some_and(|inner| inner.is::<Self>()),
            _ => true,
        }
    }
}

/// Reads rows with a header.
pub(in crate::commands) fn reader<R: Read>(input: R) -> csv::Reader<Bounded<R>> {
    let input = Bounded { input, at: At::default(), wrong: None };
    csv::ReaderBuilder::new().trim(csv::Trim::Headers).flexible(true).from_reader(input)
}

/// An input that ends with an error before the row that is wrong.
pub(in crate::commands) struct Bounded<R> {
    input: R,
    at: At,
    wrong: Option<InputError>,
}

impl<R: Read> Read for Bounded<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if let Some(wrong) = self.wrong {
            return Err(io::Error::other(wrong));
        }
        let read = self.input.read(buffer)?;
        if read == 0 && !buffer.is_empty() {
            return self.at.end().map(|()| 0).map_err(io::Error::other);
        }
        let (good, wrong) = self.at.pass(buffer.get(..read).unwrap_or_default());
        self.wrong = wrong;
        match wrong {
            // Nothing would be taken for the end.
            Some(wrong) if good == 0 => Err(io::Error::other(wrong)),
            _ => Ok(good),
        }
    }
}

/// Where in a field.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
enum Field {
    /// Before its first byte.
    #[default]
    Start,
    /// In one that has no quotes, or behind them.
    Plain,
    /// Between quotes.
    Quoted,
    /// Behind a quote that closes, or is the first of two that stand for one.
    Closed,
}

/// Where in the input, as the crate reads it.
#[derive(Default)]
struct At {
    field: Field,
    /// Line ends until here.
    lines: u64,
    /// Bytes of this row until here.
    row: usize,
    /// Line ends before this row.
    row_line: u64,
    /// Line ends before the last quote that opened.
    quote_line: u64,
    /// Bytes until here, as far as they may be a mark of UTF-8.
    mark: usize,
}

/// The bytes by which some programs begin UTF-8.
const MARK: &[u8] = "\u{feff}".as_bytes();

impl At {
    /// Goes over bytes; how many of them are good, and what is wrong behind.
    fn pass(&mut self, bytes: &[u8]) -> (usize, Option<InputError>) {
        for (i, byte) in bytes.iter().enumerate() {
            self.step(*byte);
            if self.row > LONGEST_ROW {
                return (i, Some(InputError::TooLong { line: self.row_line + 1 }));
            }
        }
        (bytes.len(), None)
    }

    fn step(&mut self, byte: u8) {
        if self.mark < MARK.len() {
            if MARK.get(self.mark) == Some(&byte) {
                self.mark += 1;
                return;
            }
            self.mark = MARK.len();
        }
        self.row += 1;
        self.field = match (self.field, byte) {
            (Field::Start, b'"') => {
                self.quote_line = self.lines;
                Field::Quoted
            }
            (Field::Quoted, b'"') => Field::Closed,
            (Field::Quoted, _) | (Field::Closed, b'"') => Field::Quoted,
            (_, b',') => Field::Start,
            (_, b'\n' | b'\r') => {
                self.row = 0;
                Field::Start
            }
            _ => Field::Plain,
        };
        self.lines += u64::from(byte == b'\n');
        if self.row == 0 {
            self.row_line = self.lines;
        }
    }

    /// Errors: the input ends in a quote.
    fn end(&self) -> Result<(), InputError> {
        match self.field {
            Field::Quoted => Err(InputError::Quote { line: self.quote_line + 1 }),
            _ => Ok(()),
        }
    }
}
