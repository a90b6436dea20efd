//! Opening: validated, in the same time for every size.

use crate::error::OpenError;
use crate::header::{HEADER_LENGTH, Header};
use crate::{ArchivedRows, Tables};

/// Alignment of an archive's first byte.
pub(crate) const ALIGNMENT: usize = 8;

/// An opened archive.
#[derive(Clone, Copy)]
pub struct Archive<'a> {
    /// The decoded header.
    pub header: Header,
    /// All tables.
    pub tables: Tables<'a>,
}

/// Opens an archive in place: checks the header, the exact length, and that every table lies inside the body.
///
/// Takes constant time and reads nothing but the header and the root. What the rows say is not examined: accessors
/// stay checked, and [`crate::verify`] proves the rest.
///
/// Errors: [`OpenError`], each with what was expected, what was found and the way out.
pub fn open(bytes: &[u8]) -> Result<Archive<'_>, OpenError> {
    let off = bytes.as_ptr() as usize % ALIGNMENT;
    if off != 0 && bytes.len() >= HEADER_LENGTH {
        return Err(OpenError::Alignment { expected: ALIGNMENT, found: off });
    }
    let header = Header::decode(bytes)?;
    let expected = header.body_length.saturating_add(HEADER_LENGTH as u64);
    if expected != bytes.len() as u64 {
        return Err(OpenError::Length { expected, found: bytes.len() as u64 });
    }
    let body = &bytes[HEADER_LENGTH..];
    let root =
        rkyv::access::<ArchivedRows, rkyv::rancor::Failure>(body).map_err(|_| OpenError::Root)?;
    Ok(Archive { header, tables: Tables::new(root, body)? })
}

/// The string of a number; empty if there is none or it is not UTF-8 (a corrupt archive).
#[inline]
pub fn string<'a>(tables: &Tables<'a>, number: u32) -> &'a str {
    let offset = |i: usize| tables.string_offsets.get(i).map(|o| *o as usize);
    let number = number as usize;
    let (Some(start), Some(end)) = (offset(number), offset(number.saturating_add(1))) else {
        return "";
    };
    tables
        .string_bytes
        .get(start..end)
        .and_then(|bytes| std::str::from_utf8(bytes).ok())
        .unwrap_or("")
}
