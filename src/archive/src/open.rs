//! Opening: validated, in the same time for every size.

use crate::Tables;
use crate::directory::{Reader, understood};
use crate::error::OpenError;
use crate::header::{HEADER_LENGTH, Header};
use crate::overlay::OVERLAY_BIT;

/// Alignment of an archive's first byte, and of each table in it.
pub(crate) const ALIGNMENT: usize = 8;

/// An opened archive.
#[derive(Clone, Copy)]
pub struct Archive<'a> {
    /// The decoded header.
    pub header: Header,
    /// All tables.
    pub tables: Tables<'a>,
}

/// Opens an archive in place: checks the header, the exact length, and that every table lies inside the archive, apart from all others.
///
/// Takes constant time and reads nothing but the header and the directory. Tables that this release does not know are left
/// alone; optional ones that the archive does not have are empty. What the rows say is not examined: accessors
/// stay checked, and [`crate::verify`] proves the rest.
///
/// Errors: [`OpenError`], each with what was expected, what was found and the way out.
pub fn open(bytes: &[u8]) -> Result<Archive<'_>, OpenError> {
    let header = whole(bytes)?;
    if header.must_understand & OVERLAY_BIT != 0 {
        return Err(OpenError::Overlay);
    }
    understood(bytes, &header)?;
    let mut directory = Reader::new(bytes, &header)?;
    let tables = Tables::read(&mut directory)?;
    directory.finish()?;
    Ok(Archive { header, tables })
}

/// The header of an archive that lies as it must and is as long as it says.
pub(crate) fn whole(bytes: &[u8]) -> Result<Header, OpenError> {
    let off = bytes.as_ptr() as usize % ALIGNMENT;
    if off != 0 && bytes.len() >= HEADER_LENGTH {
        return Err(OpenError::Alignment { expected: ALIGNMENT, found: off });
    }
    let header = Header::decode(bytes)?;
    let expected = header.body_length.saturating_add(HEADER_LENGTH as u64);
    if expected != bytes.len() as u64 {
        return Err(OpenError::Length { expected, found: bytes.len() as u64 });
    }
    Ok(header)
}

/// The string of a number; empty if there is none or it is not UTF-8 (a corrupt archive).
#[inline]
pub fn string<'a>(tables: &Tables<'a>, number: u32) -> &'a str {
    string_of(tables.string_bytes, tables.string_offsets, number)
}

pub(crate) fn string_of<'a>(
    string_bytes: &'a [u8],
    string_offsets: &[u32],
    number: u32,
) -> &'a str {
    let offset = |i: usize| string_offsets.get(i).map(|o| *o as usize);
    let number = number as usize;
    let (Some(start), Some(end)) = (offset(number), offset(number.saturating_add(1))) else {
        return "";
    };
    string_bytes.get(start..end).and_then(|bytes| std::str::from_utf8(bytes).ok()).unwrap_or("")
}
