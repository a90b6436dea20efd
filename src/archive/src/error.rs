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
        "the archive has format {found}, this program reads format {expected}; compile the map again with this version"
    )]
    Format {
        /// Format of this program.
        expected: u32,
        /// Format of the archive.
        found: u32,
    },
    /// Another layout of tables.
    #[error("the archive has layout {}, this program reads layout {}; use one mapd version for compiler, daemon and clients, or compile the map again", Hex(.found), Hex(.expected))]
    Layout {
        /// Layout of this program.
        expected: [u8; 16],
        /// Layout of the archive.
        found: [u8; 16],
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
    /// rkyv refuses the root: a table reaches outside the body.
    #[error(
        "the body's root is not valid: a table lies outside the archive; the archive is damaged, compile it again"
    )]
    Root,
    /// One table reaches outside the body.
    #[error(
        "table `{table}` with {length} elements does not lie inside the archive; it is damaged, compile it again"
    )]
    Table {
        /// Name of the table.
        table: &'static str,
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
