//! Writing `.mapd` files: exact size, straight from the tables, visible under their name only when whole.

use crate::draft::Draft;
use crate::early_sync;
use anyhow::{Context, Result};
use mapd_archive::side_by_side::{encode_to_with, verify_hash, verify_tables};
use mapd_archive::{Header, Provenance, Rows, encoded_length};
use mapd_client::Snapshot;
use rustix::fs::FallocateFlags;
use std::borrow::Borrow;
use std::fs::{File, OpenOptions};
use std::io::{Seek, Write};
use std::path::Path;

/// An archive that is written but for its name.
pub(crate) struct UnnamedArchive {
    draft: Draft,
    /// Its header.
    pub(crate) header: Header,
}

impl UnnamedArchive {
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

/// Writes an archive to the disk that will be at `path`, and verifies it as the daemon that serves it will.
///
/// Errors: the folder cannot be written, or the disk is full; the archive is not sound, which is this program's fault; nothing
/// is left behind.
pub(crate) fn prepare(
    path: &Path,
    rows: impl Borrow<Rows>,
    provenance: &Provenance,
) -> Result<UnnamedArchive> {
    let context = || format!("writing {}", path.display());
    let draft = Draft::begin(path).with_context(context)?;
    let header: Result<Header> = std::thread::scope(|scope| {
        // The disk takes its time; the file has no name yet that anybody would open.
        let (mut writing, syncing) = early_sync::begin(draft.file(), scope);
        let header = fill(draft.file(), &mut writing, rows.borrow(), provenance)?;
        drop(writing);
        let mut proven = Ok(());
        rayon::in_place_scope(|scope| {
            scope.spawn(|_| proven = prove(draft.path()));
            // If they are this function's, they go while the archive is proven: it is as large as they are, but mapped more slowly than
            // they are freed.
            drop(rows);
        });
        proven?;
        syncing.finish()?;
        Ok(header)
    });
    Ok(UnnamedArchive { header: header.with_context(context)?, draft })
}

/// Proves an archive that has been written, in place.
///
/// Errors: the first thing that is wrong.
fn prove(path: &Path) -> Result<()> {
    let proof = || -> Result<()> {
        let archive = Snapshot::open(path)?;
        let bytes = archive.bytes();
        let (hash, tables) = rayon::join(|| verify_hash(bytes), || verify_tables(bytes));
        hash?;
        tables?;
        Ok(())
    };
    proof().context("the archive compiled from this map fails verification: a bug in mapd")
}

/// Writes an archive into an existing file that has no readers yet: a temporary file, or one without a name
/// under `/proc`. It is not forced to the disk, and not verified: the daemon does so before it serves the file.
///
/// Errors: the file cannot be written, or the disk is full.
pub fn write_into(path: &Path, rows: &Rows, provenance: &Provenance) -> Result<Header> {
    let context = || format!("writing {}", path.display());
    let file = OpenOptions::new().read(true).write(true).open(path).with_context(context)?;
    fill(&file, &mut &file, rows, provenance).with_context(context)
}

/// Writes an archive to an empty file, through a writer of that file.
fn fill(
    file: &File,
    writer: &mut (impl Write + Seek + Send),
    rows: &Rows,
    provenance: &Provenance,
) -> Result<Header> {
    let length = encoded_length(rows)? as u64;
    file.set_len(length)?;
    // Reserves the blocks: a full disk shows at once. Not every file system can.
    match rustix::fs::fallocate(file, FallocateFlags::empty(), 0, length) {
        Err(rustix::io::Errno::OPNOTSUPP) | Ok(()) => {}
        Err(error) => return Err(error.into()),
    }
    // All of it in the pool: who is outside waits for each join.
    let written = rayon::scope(|_| {
        encode_to_with(rows, provenance, writer, &|hash, write| {
            rayon::join(hash, write);
        })
    });
    Ok(written?)
}
