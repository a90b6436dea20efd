//! What can be wrong with an archive: expected, found, and the way out.

use std::fmt;
use thiserror::Error;

/// Bytes shown as hexadecimal digits.
struct Hex<'a>(&'a [u8]);

impl fmt::Display for Hex<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

/// What to do about another format.
fn remedy(expected: u32, found: u32) -> &'static str {
    match found < expected {
        true => "compile the map again with this release",
        false => "read it with the release that wrote it, or compile the map again with this one",
    }
}

fn named(bit: u32, name: &str) -> String {
    match name {
        "" => format!("feature {bit}"),
        name => format!("`{name}`"),
    }
}

fn newer(release: [u16; 3]) -> String {
    match release {
        [0, 0, 0] => "read it with the release that wrote it".to_owned(),
        [major, minor, patch] => format!("mapd {major}.{minor}.{patch} and later read it"),
    }
}

/// Why bytes cannot be opened as an archive.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum OpenError {
    /// Not even a header.
    #[error(
        "an archive has at least 128 bytes, found {found}; the file is cut off or not an archive"
    )]
    TooShort {
        /// Bytes there are.
        found: u64,
    },
    /// Another kind of file.
    #[error("not a mapd archive: it starts with {}, not with the archive mark; compile OpenDRIVE files with `mapd compile`", Hex(.found))]
    NotAnArchive {
        /// The first eight bytes.
        found: [u8; 8],
    },
    /// An overlay where a map is wanted.
    #[error("an overlay, not a map: it lies over a map that a daemon serves (`mapd overlay`)")]
    Overlay,
    /// A map where an overlay is wanted.
    #[error("a map, not an overlay")]
    NotAnOverlay,
    /// Written on a machine of the other byte order.
    #[error("the archive's byte order is not little-endian; compile the map again on this machine")]
    Endianness,
    /// The header was altered.
    #[error(
        "the header's checksum does not fit its bytes: the archive is damaged; compile or copy it again"
    )]
    HeaderChecksum,
    /// Another format.
    #[error(
        "the archive has format {found}, this program reads format {expected}; {}",
        remedy(*.expected, *.found)
    )]
    Format {
        /// Format of this program.
        expected: u32,
        /// Format of the archive.
        found: u32,
    },
    /// It uses something without which its tables would be misread.
    #[error("the map uses {}, which this release does not know; {}", named(*.bit, .name), newer(*.release))]
    NotUnderstood {
        /// Bit of the header's `must_understand`.
        bit: u32,
        /// What the archive calls it; empty if it does not say.
        name: String,
        /// First release that reads it, as the archive says: major, minor, patch; zeros if it does not.
        release: [u16; 3],
    },
    /// A table that every archive has.
    #[error(
        "the archive has no table `{table}`, which every map needs; read it with the release that wrote it, or compile the map again"
    )]
    NoTable {
        /// Name of the table.
        table: &'static str,
    },
    /// Rows of another meaning.
    #[error(
        "table `{table}` has rows of kind {found:016x}, this release reads {expected:016x}; read the archive with the release that wrote it, or compile the map again"
    )]
    Row {
        /// Name of the table.
        table: &'static str,
        /// Row id that this release knows.
        expected: u64,
        /// Row id in the archive.
        found: u64,
    },
    /// Cut off, or with something behind it.
    #[error(
        "the header announces {expected} bytes in all, found {found}; the archive is cut off or has something appended"
    )]
    Length {
        /// Bytes that the header announces, itself included.
        expected: u64,
        /// Bytes there are.
        found: u64,
    },
    /// The bytes do not start at a multiple of eight.
    #[error(
        "an archive must lie at an address that is a multiple of {expected}, found one off by {found}; map the file or copy it into an aligned buffer"
    )]
    Alignment {
        /// Needed alignment in bytes.
        expected: usize,
        /// Remainder of the address.
        found: usize,
    },
    /// The directory reaches outside the archive.
    #[error(
        "the directory of {tables} tables does not lie inside the archive; it is damaged, compile it again"
    )]
    Directory {
        /// Number of tables that the header announces.
        tables: u32,
    },
    /// One table reaches outside the archive or into another, is not aligned or out of order.
    #[error(
        "table `{table}` with {length} rows does not lie inside the archive, aligned and behind the table before it; the archive is damaged, compile it again"
    )]
    Table {
        /// Name of the table; its number if this release does not know it.
        table: String,
        /// Its length as read.
        length: u64,
    },
}

/// What `verify` found wrong in an archive that could be opened.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum VerifyError {
    /// It cannot even be opened.
    #[error(transparent)]
    Open(#[from] OpenError),
    /// The bytes are not those that were written.
    #[error("the content hash is {}, the header says {}; the archive is damaged, compile or copy it again", Hex(.found), Hex(.expected))]
    ContentHash {
        /// Hash in the header.
        expected: [u8; 32],
        /// Hash of the bytes.
        found: [u8; 32],
    },
    /// A row says something that cannot be.
    #[error("table `{table}`, row {row}: {field} is {found}, expected {expected}")]
    Row {
        /// Name of the table.
        table: &'static str,
        /// Row from 0.
        row: usize,
        /// Field, or empty for tables of plain numbers.
        field: &'static str,
        /// What was expected.
        expected: String,
        /// What was found.
        found: String,
    },
}

/// Why rows cannot be written as an archive.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum WriteError {
    /// The destination does not have the archive's exact size.
    #[error("the archive needs exactly {expected} bytes, the destination has {found}")]
    Length {
        /// Bytes needed.
        expected: usize,
        /// Bytes there are.
        found: usize,
    },
    /// The destination is not aligned.
    #[error("the destination must start at a multiple of {expected} bytes")]
    Alignment {
        /// Needed alignment.
        expected: usize,
    },
    /// rkyv could not write.
    #[error("the archive could not be written: {0}")]
    Serialize(String),
}
