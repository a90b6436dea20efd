//! Writing `.mapd` files: exact size, straight into the file's pages, visible under its name only when whole.
#![allow(unsafe_code)]

use anyhow::{Context, Result};
use mapd_archive::{Header, Provenance, Rows, encode_into, encoded_length};
use memmap2::MmapMut;
use rustix::fs::FallocateFlags;
use std::fs::{self, File, OpenOptions};
use std::path::{Path, PathBuf};

/// Removes an unfinished file.
struct Unfinished(Option<PathBuf>);

impl Drop for Unfinished {
    fn drop(&mut self) {
        if let Some(path) = &self.0 {
            // Nothing more can be done about a file that cannot be removed.
            let _ = fs::remove_file(path);
        }
    }
}

/// Writes an archive beside `path` and renames it there, so that a reader sees the old file or the new one.
///
/// Errors: the folder cannot be written, or the disk is full; nothing is left behind.
pub fn write(path: &Path, rows: &Rows, provenance: &Provenance) -> Result<Header> {
    let name = path.file_name().with_context(|| format!("{} names no file", path.display()))?;
    let mut temporary = std::ffi::OsString::from(".");
    temporary.push(name);
    temporary.push(format!(".{}.tmp", std::process::id()));
    let temporary = path.with_file_name(temporary);
    let mut unfinished = Unfinished(Some(temporary.clone()));
    let context = || format!("writing {}", path.display());
    let header = fill(&temporary, rows, provenance).with_context(context)?;
    fs::rename(&temporary, path).with_context(context)?;
    unfinished.0 = None;
    Ok(header)
}

/// Writes an archive into a file that is there already and that nobody reads yet: a temporary file, or one without a name
/// under `/proc`. It is not forced to the disk.
///
/// Errors: the file cannot be written, or the disk is full.
pub fn write_into(path: &Path, rows: &Rows, provenance: &Provenance) -> Result<Header> {
    let context = || format!("writing {}", path.display());
    let file = OpenOptions::new().read(true).write(true).open(path).with_context(context)?;
    Ok(fill_file(&file, rows, provenance).with_context(context)?.0)
}

fn fill(path: &Path, rows: &Rows, provenance: &Provenance) -> Result<Header> {
    let file = OpenOptions::new().read(true).write(true).create(true).truncate(true).open(path)?;
    let (header, map) = fill_file(&file, rows, provenance)?;
    map.flush()?;
    Ok(header)
}

fn fill_file(file: &File, rows: &Rows, provenance: &Provenance) -> Result<(Header, MmapMut)> {
    let length = encoded_length(rows)?;
    // Reserves the blocks: a full disk is an error here instead of a signal while filling.
    rustix::fs::fallocate(file, FallocateFlags::empty(), 0, length as u64).or_else(|error| {
        if error == rustix::io::Errno::OPNOTSUPP {
            file.set_len(length as u64).map_err(|_| error)
        } else {
            Err(error)
        }
    })?;
    // SAFETY: the file is new and this process's own (its id is in the name, or its parent made it for this process), with
    // no reader before it is whole; its blocks are reserved, so that writing cannot fault.
    let mut map = unsafe { MmapMut::map_mut(file)? };
    let header = encode_into(rows, provenance, &mut map)?;
    Ok((header, map))
}
