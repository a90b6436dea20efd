//! Archives as releases of other ages write them: with tables that this one does not know, or without some that it does.

mod answers;
mod facts;
mod rows;

pub use answers::{answers, answers_today};
pub use facts::facts;
pub use rows::rows;

use crate::damage::seal;
use mapd_archive::{AlignedBytes, HEADER_LENGTH, TableEntry, directory};
use mapd_client::Map;
use std::fmt;
use std::path::PathBuf;
use std::time::Duration;

/// A table that no release knows.
pub const UNKNOWN_TABLE: u32 = 60_000;

/// The moment at which overlays are asked: a Monday, 07:00 UTC.
pub const MOMENT: Duration = Duration::from_secs(1_777_878_000);

/// Where the archives of released layouts lie, each beside what is asked of it and answered ([`texts`]).
pub fn golden() -> PathBuf {
    crate::workspace().join("tests/data/archives")
}

/// An archive taken apart, to be put together with other tables.
#[derive(Clone)]
pub struct Parts {
    header: Vec<u8>,
    tables: Vec<(TableEntry, Vec<u8>)>,
}

impl Parts {
    /// Of an archive of this release.
    pub fn of(bytes: &[u8]) -> Self {
        let bytes_of = |entry: &TableEntry| {
            let start = entry.offset as usize;
            bytes[start..start + entry.count as usize * entry.row_bytes as usize].to_vec()
        };
        let entries = directory(bytes).expect("a sound archive");
        let tables = entries.into_iter().map(|entry| (entry, bytes_of(&entry)));
        Self { header: bytes[..HEADER_LENGTH].to_vec(), tables: tables.collect() }
    }

    /// Numbers of its tables.
    pub fn numbers(&self) -> Vec<u32> {
        self.tables.iter().map(|(entry, _)| entry.number).collect()
    }

    /// Without a table.
    pub fn without(mut self, number: u32) -> Self {
        self.tables.retain(|(entry, _)| entry.number != number);
        self
    }

    /// With a table more, whose rows have so many bytes.
    pub fn with(mut self, number: u32, row_bytes: u32, rows: &[u8]) -> Self {
        let count = rows.len() as u64 / u64::from(row_bytes);
        let entry = TableEntry { number, row_bytes, row_id: 0x1234, offset: 0, count };
        self.tables.push((entry, rows.to_vec()));
        self.tables.sort_by_key(|(entry, _)| entry.number);
        self
    }

    /// With another description of a table; its bytes stay.
    pub fn edit(mut self, number: u32, edit: impl Fn(&mut TableEntry)) -> Self {
        for (entry, _) in self.tables.iter_mut().filter(|(entry, _)| entry.number == number) {
            edit(entry);
        }
        self
    }

    /// With other rows of a table, as many; none where the table has no rows.
    pub fn edit_rows(&self, number: u32, edit: impl FnOnce(&mut [u8])) -> Option<Self> {
        let mut edited = self.clone();
        let (_, rows) = edited.tables.iter_mut().find(|(entry, _)| entry.number == number)?;
        if rows.is_empty() {
            return None;
        }
        edit(rows);
        Some(edited)
    }

    /// The archive, with hashes that fit.
    pub fn to_archive(&self) -> AlignedBytes {
        let mut out = AlignedBytes::new();
        out.extend_from_slice(&self.header);
        let mut place = HEADER_LENGTH + self.tables.len() * size_of::<TableEntry>();
        for (entry, rows) in &self.tables {
            place = place.next_multiple_of(8);
            let TableEntry { number, row_bytes, row_id, count, .. } = entry;
            out.extend_from_slice(&number.to_le_bytes());
            out.extend_from_slice(&row_bytes.to_le_bytes());
            out.extend_from_slice(&row_id.to_le_bytes());
            out.extend_from_slice(&(place as u64).to_le_bytes());
            out.extend_from_slice(&count.to_le_bytes());
            place += rows.len();
        }
        for (_, rows) in &self.tables {
            out.resize(out.len().next_multiple_of(8), 0);
            out.extend_from_slice(rows);
        }
        let (tables, length) = (self.tables.len() as u32, (out.len() - HEADER_LENGTH) as u64);
        out[24..28].copy_from_slice(&tables.to_le_bytes());
        out[32..40].copy_from_slice(&length.to_le_bytes());
        seal(&mut out);
        out
    }
}

/// Archives of released layouts, all.
pub fn kept() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(golden()).expect("a folder").flatten();
    let archives = entries.map(|entry| entry.path());
    let mut kept: Vec<_> = archives.filter(|path| path.with_extension("txt").exists()).collect();
    kept.retain(|path| path.extension().is_some_and(|extension| extension == "mapd"));
    kept.sort();
    kept
}

/// What a map says, as the texts that are kept beside its archive, by what their names end in. A text that a release has kept stays comparable for
/// ever: what is to be compared besides is one more text.
///
/// Errors: what writing to a string gives, which is none.
pub fn texts(map: Map<'_>) -> Result<[(&'static str, String); 3], fmt::Error> {
    Ok([("txt", answers(map)?), ("facts.txt", facts(map)), ("rows.txt", rows(map))])
}
