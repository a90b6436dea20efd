//! Writing `.mapd` files: exact size, straight into the file's pages, visible under its name only when whole.
#![allow(unsafe_code)]

use crate::draft::Draft;
use anyhow::{Context, Result};
use mapd_archive::{Header, Provenance, Rows, encode_into, encoded_length};
use memmap2::MmapMut;
use rustix::fs::FallocateFlags;
use std::fs::{File, OpenOptions};
use std::path::Path;

/// An archive that is written but for its name.
pub(crate) struct Written {
    draft: Draft,
    /// Its header.
    pub(crate) header: Header,
}

impl Written {
    /// Gives it its name, so that a reader sees the old file or the new one.
    ///
    /// Errors: what the system says; nothing is left behind.
    pub(crate) fn publish(self) -> Result<()> {
        Ok(self.draft.publish()?)
    }
}

/// Writes an archive beside `path` and renames it there, so that a reader sees the old file or the new one.
///
/// Errors: the folder cannot be written, or the disk is full; nothing is left behind.
pub fn write(path: &Path, rows: &Rows, provenance: &Provenance) -> Result<Header> {
    let written = prepare(path, rows, provenance)?;
    let header = written.header;
    written.publish().with_context(|| format!("writing {}", path.display()))?;
    Ok(header)
}

/// Writes an archive to the disk that will be at `path`.
///
/// Errors: the folder cannot be written, or the disk is full; nothing is left behind.
pub(crate) fn prepare(path: &Path, rows: &Rows, provenance: &Provenance) -> Result<Written> {
    let context = || format!("writing {}", path.display());
    let draft = Draft::begin(path).with_context(context)?;
    let (header, map) = fill(draft.file(), rows, provenance).with_context(context)?;
    map.flush().with_context(context)?;
    Ok(Written { draft, header })
}

/// Writes an archive into a file that is there already and that nobody reads yet: a temporary file, or one without a name
/// under `/proc`. It is not forced to the disk.
///
/// Errors: the file cannot be written, or the disk is full.
pub fn write_into(path: &Path, rows: &Rows, provenance: &Provenance) -> Result<Header> {
    let context = || format!("writing {}", path.display());
    let file = OpenOptions::new().read(true).write(true).open(path).with_context(context)?;
    Ok(fill(&file, rows, provenance).with_context(context)?.0)
}

fn fill(file: &File, rows: &Rows, provenance: &Provenance) -> Result<(Header, MmapMut)> {
    let length = encoded_length(rows)?;
    // Reserves the blocks: a full disk is an error here instead of a signal while filling.
    rustix::fs::fallocate(file, FallocateFlags::empty(), 0, length as u64).or_else(|error| {
        if error == rustix::io::Errno::OPNOTSUPP {
            file.set_len(length as u64).map_err(|_| error)
        } else {
            Err(error)
        }
    })?;
    // SAFETY: the file is this process's own (locked or with the process's id in its name, or its parent made it for this
    // process), with no reader before it is whole; its blocks are reserved, so that writing cannot fault.
    let mut map = unsafe { MmapMut::map_mut(file)? };
    let header = encode_into(rows, provenance, &mut map)?;
    Ok((header, map))
}
