//! The directory behind the header: which tables an archive has, what their rows are and where they lie.
//!
//! Entries stand in the order of their tables' numbers, and the tables lie in the same order. rkyv's validator proves that
//! each lies inside the archive, behind the one before and aligned, also those that this release does not know: what
//! they contain does not matter here.

use crate::error::OpenError;
use crate::generated::known_tables::{FEATURES, TABLES};
use crate::generated::network_rows::{ArchivedFeatureRow, FeatureRow};
use crate::header::{HEADER_LENGTH, Header};
use crate::open::ALIGNMENT;
use bytemuck::{AnyBitPattern, Pod, Zeroable};
use rkyv::Archive;
use rkyv::rancor::Failure;
use rkyv::validation::ArchiveContextExt;
use rkyv::validation::archive::ArchiveValidator;
use std::alloc::Layout;

/// Bytes of an entry.
pub(crate) const ENTRY_LENGTH: usize = 32;

/// Most tables of an archive, so that the time of opening has a bound.
pub const MOST_TABLES: u32 = 1024;

/// A table as the directory describes it.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq, Eq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct TableEntry {
    /// Its number, fixed for ever.
    pub number: u32,
    /// Bytes of a row.
    pub row_bytes: u32,
    /// What a row is: a hash of names, types, references and semantics.
    pub row_id: u64,
    /// Its first byte, from the archive's start; a multiple of eight.
    pub offset: u64,
    /// Number of rows.
    pub count: u64,
}

const _: () = assert!(
    size_of::<TableEntry>() == ENTRY_LENGTH && size_of::<ArchivedTableEntry>() == ENTRY_LENGTH
);

impl ArchivedTableEntry {
    fn to_native(self) -> TableEntry {
        TableEntry {
            number: self.number.to_native(),
            row_bytes: self.row_bytes.to_native(),
            row_id: self.row_id.to_native(),
            offset: self.offset.to_native(),
            count: self.count.to_native(),
        }
    }
}

/// A table that this release knows.
pub(crate) struct TableKind {
    pub(crate) number: u32,
    pub(crate) name: &'static str,
    pub(crate) row_bytes: u32,
    pub(crate) row_id: u64,
    /// Whether every archive has it.
    pub(crate) required: bool,
}

impl TableKind {
    pub(crate) const fn new(
        number: u32,
        name: &'static str,
        row_bytes: u32,
        row_id: u64,
        required: bool,
    ) -> Self {
        Self { number, name, row_bytes, row_id, required }
    }
}

/// Something that changes the meaning of tables which older readers know: a reader has to know of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Feature {
    /// Number of its bit in the header's `must_understand`.
    pub bit: u32,
    /// What it is called; at most 32 bytes.
    pub name: &'static str,
    /// First release of mapd that reads it: major, minor, patch.
    pub release: [u16; 3],
}

impl FeatureRow {
    /// The row that announces a feature. Bytes of the name that have no room are left out.
    pub fn of(feature: &Feature) -> Self {
        let mut row = Self { bit: feature.bit, release: feature.release, ..Self::zeroed() };
        row.name.iter_mut().zip(feature.name.bytes()).for_each(|(to, from)| *to = from);
        row
    }
}

impl ArchivedFeatureRow {
    /// The name without the zeros behind it; empty if it is not UTF-8 (a corrupt archive).
    pub fn name_text(&self) -> &str {
        std::str::from_utf8(self.name()).unwrap_or("").trim_end_matches('\0')
    }
}

/// The bit of a number; none beyond the last.
pub(crate) fn feature_bit(number: u32) -> u64 {
    1_u64.checked_shl(number).unwrap_or(0)
}

/// A table in an archive: its entry, read once, and its bytes.
#[derive(Clone, Copy)]
struct TableBytes<'a> {
    entry: TableEntry,
    bytes: &'a [u8],
}

/// Reads the directory from its first entry to its last.
pub(crate) struct Reader<'a> {
    bytes: &'a [u8],
    /// Entries that have not been read.
    entries: &'a [ArchivedTableEntry],
    /// An entry that has been read and not been taken.
    ahead: Option<TableBytes<'a>>,
    /// Number of the last table that was read.
    last: u32,
    /// What lies behind the last table that was read.
    validator: ArchiveValidator<'a>,
}

impl<'a> Reader<'a> {
    /// Of a whole archive and its header.
    pub(crate) fn new(bytes: &'a [u8], header: &Header) -> Result<Self, OpenError> {
        let bad = OpenError::Directory { tables: header.tables };
        if header.tables > MOST_TABLES {
            return Err(bad);
        }
        let length = HEADER_LENGTH + header.tables as usize * ENTRY_LENGTH;
        let mut validator = ArchiveValidator::new(bytes);
        let Some(entries) = bytes.get(HEADER_LENGTH..length) else { return Err(bad) };
        if !proves(&mut validator, bytes.as_ptr(), length) {
            return Err(bad);
        }
        let entries = bytemuck::try_cast_slice(entries).map_err(|_| bad)?;
        Ok(Self { bytes, entries, ahead: None, last: 0, validator })
    }

    /// The rows of a table; none if the archive does not have it and need not.
    pub(crate) fn take<T: AnyBitPattern>(
        &mut self,
        kind: &TableKind,
    ) -> Result<&'a [T], OpenError> {
        match self.find(kind)? {
            None => Ok(&[]),
            Some(bytes) => bytemuck::try_cast_slice(bytes).map_err(|_| OpenError::Table {
                table: kind.name.to_owned(),
                length: bytes.len() as u64,
            }),
        }
    }

    fn find(&mut self, kind: &TableKind) -> Result<Option<&'a [u8]>, OpenError> {
        loop {
            if self.ahead.is_none() {
                self.ahead = self.read()?;
            }
            match self.ahead {
                // Of another release.
                Some(TableBytes { entry, .. }) if entry.number < kind.number => self.ahead = None,
                Some(TableBytes { entry, bytes }) if entry.number == kind.number => {
                    if (entry.row_id, entry.row_bytes) != (kind.row_id, kind.row_bytes) {
                        return Err(OpenError::Row {
                            table: kind.name,
                            expected: kind.row_id,
                            found: entry.row_id,
                        });
                    }
                    self.ahead = None;
                    return Ok(Some(bytes));
                }
                _ if kind.required => return Err(OpenError::NoTable { table: kind.name }),
                _ => return Ok(None),
            }
        }
    }

    /// Proves the entries that nobody has taken.
    pub(crate) fn finish(&mut self) -> Result<(), OpenError> {
        self.ahead = None;
        while self.read()?.is_some() {}
        Ok(())
    }

    /// Reads the next entry, once: bytes that change afterwards lead nowhere else.
    fn read(&mut self) -> Result<Option<TableBytes<'a>>, OpenError> {
        let Some((entry, rest)) = self.entries.split_first() else { return Ok(None) };
        let entry = entry.to_native();
        let bytes = self.bytes_of(&entry).filter(|bytes| {
            entry.number > self.last && proves(&mut self.validator, bytes.as_ptr(), bytes.len())
        });
        let Some(bytes) = bytes else {
            let known = TABLES.iter().find(|kind| kind.number == entry.number);
            let table = known.map_or_else(|| format!("{}", entry.number), |k| k.name.to_owned());
            return Err(OpenError::Table { table, length: entry.count });
        };
        (self.entries, self.last) = (rest, entry.number);
        Ok(Some(TableBytes { entry, bytes }))
    }

    fn bytes_of(&self, entry: &TableEntry) -> Option<&'a [u8]> {
        let start = usize::try_from(entry.offset).ok()?;
        let size = entry.count.checked_mul(entry.row_bytes.into()).filter(|_| entry.row_bytes > 0);
        let end = start.checked_add(usize::try_from(size?).ok()?)?;
        self.bytes.get(start..end)
    }
}

/// Whether so many bytes lie behind all that was proved before, and are aligned; what comes next lies behind them.
fn proves(validator: &mut ArchiveValidator<'_>, start: *const u8, length: usize) -> bool {
    let Ok(layout) = Layout::from_size_align(length, ALIGNMENT) else { return false };
    ArchiveContextExt::<Failure>::in_subtree_raw(validator, start, layout, |_| Ok(())).is_ok()
}

/// Refuses an archive that uses what this release does not know of, by its name.
pub(crate) fn understood(bytes: &[u8], header: &Header) -> Result<(), OpenError> {
    let known = FEATURES.iter().fold(0, |bits, feature| bits | feature_bit(feature.bit));
    let unknown = header.must_understand & !known;
    if unknown == 0 {
        return Ok(());
    }
    let bit = unknown.trailing_zeros();
    let kind = TABLES.iter().find(|kind| kind.name == "features");
    let rows: &[ArchivedFeatureRow] = match (Reader::new(bytes, header), kind) {
        (Ok(mut reader), Some(kind)) => reader.take(kind).unwrap_or_default(),
        _ => &[],
    };
    let row = rows.iter().find(|row| row.bit() == bit);
    Err(OpenError::NotUnderstood {
        bit,
        name: row.map(|row| row.name_text().to_owned()).unwrap_or_default(),
        release: row.map(|row| *row.release()).unwrap_or_default(),
    })
}

/// What the directory says, entry by entry.
///
/// Errors: as [`crate::open`], but for what concerns single tables: whatever a release may write can be listed.
pub fn directory(bytes: &[u8]) -> Result<Vec<TableEntry>, OpenError> {
    let header = crate::open::whole(bytes)?;
    let mut reader = Reader::new(bytes, &header)?;
    let mut entries = Vec::new();
    while let Some(found) = reader.read()? {
        entries.push(found.entry);
    }
    Ok(entries)
}
