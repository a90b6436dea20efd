//! Mapping records and segments. The only unsafe code of observers.
#![allow(unsafe_code)]

use super::page::{PAGE_BYTES, Page};
use super::slot::SlotContent;
use crate::mapping::{Mapping, leave_out_of_core_dumps};
use crate::regular::{Untrusted, open_guarded};
use crate::share::Share;
use rustix::fd::OwnedFd;
use rustix::fs::{Mode, OFlags, Stat};
use rustix::io::Errno;
use rustix::mm::ProtFlags;
use std::io;
use std::path::Path;
use std::sync::{Arc, Mutex};

const _: () = assert!(size_of::<Page>() <= PAGE_BYTES && align_of::<Page>() <= 8);

/// Unit of [`Stat::st_blocks`] \[bytes\].
const BLOCK: u64 = 512;

/// Why a file is not mapped.
#[derive(Debug)]
pub(super) enum Refusal {
    /// It belongs to this user.
    OtherOwner(u32),
    /// So many bytes may not be locked, and this process locks what it maps.
    LockLimit(u64),
    /// The system refuses; or, of kind invalid-data, it is not what it should be.
    Io(io::Error),
}

impl From<Untrusted> for Refusal {
    fn from(untrusted: Untrusted) -> Self {
        match untrusted {
            Untrusted::OtherOwner(owner) => Self::OtherOwner(owner),
            Untrusted::Io(error) if error.kind() == io::ErrorKind::InvalidInput => {
                bad("is no file".to_owned())
            }
            Untrusted::Io(error) => Self::Io(error),
        }
    }
}

impl From<io::Error> for Refusal {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

impl From<Errno> for Refusal {
    fn from(error: Errno) -> Self {
        Self::Io(error.into())
    }
}

fn bad(why: String) -> Refusal {
    Refusal::Io(io::Error::new(io::ErrorKind::InvalidData, why))
}

/// Opens a file that somebody else may have put there.
///
/// Errors: it is not `owner`'s; what the system says; invalid-data, if it is no file, or its pages are not all there.
fn open(path: &Path, access: OFlags, owner: u32) -> Result<(OwnedFd, Stat), Refusal> {
    let (file, stat) = open_guarded(path, access, Mode::empty(), owner)?;
    if (stat.st_blocks as u64).saturating_mul(BLOCK) < stat.st_size as u64 {
        // The kernel would have to provide the missing pages when they are read, and ends the reader if it cannot.
        return Err(bad("has holes".to_owned()));
    }
    Ok((file, stat))
}

/// Which file: device and inode.
pub(super) type Identity = (u64, u64);

/// Which file it is.
pub(super) fn identity(stat: &Stat) -> Identity {
    (stat.st_dev, stat.st_ino)
}

/// A record that is mapped.
pub(super) struct Record {
    map: Mapping,
    pub(super) identity: Identity,
    /// What it said when it was last read, and its sequence then.
    pub(super) last: Mutex<Option<(u32, Arc<SlotContent>)>>,
}

/// Opens one of the daemon's records for writing; the group that the daemon shares with may read it.
///
/// Errors: those of opening a file; the group cannot have it.
pub(super) fn open_own(path: &Path, owner: u32, share: Share) -> Result<Record, Refusal> {
    let (file, stat) = open(path, OFlags::RDWR, owner)?;
    share.written(&file)?;
    Record::of(&file, &stat, ProtFlags::READ | ProtFlags::WRITE)
}

impl Record {
    /// Maps a record of `owner` read-only.
    ///
    /// Errors: those of opening a file; invalid-data, if it is not as long as a record.
    pub(super) fn open(path: &Path, owner: u32) -> Result<Self, Refusal> {
        let (file, stat) = open(path, OFlags::RDONLY, owner)?;
        Self::of(&file, &stat, ProtFlags::READ)
    }

    fn of(file: &OwnedFd, stat: &Stat, access: ProtFlags) -> Result<Self, Refusal> {
        if stat.st_size as u64 != PAGE_BYTES as u64 {
            return Err(bad(format!("expected {PAGE_BYTES} bytes, found {}", stat.st_size)));
        }
        let map = Mapping::new(file, PAGE_BYTES, access)?;
        Ok(Self { map, identity: identity(stat), last: Mutex::default() })
    }

    pub(super) fn page(&self) -> &Page {
        // SAFETY:
        // - Address and length: the mapping has `PAGE_BYTES`, begins on a page and lives as long as `self`; a `Page` is no longer, and needs an
        //   alignment of 8. The file was that long when it was opened and all its pages were there; nobody but its owner, who never does, can shorten it.
        // - Value: a `Page` is atomic integers, for which every bit pattern is one.
        // - Races: all processes touch the page by atomic operations alone.
        // - Read-only mappings: readers only load, at most eight bytes at once, which the processor does without writing.
        unsafe { self.map.address().cast::<Page>().as_ref() }
    }
}

/// Maps the first `length` bytes of a segment of `owner` read-only; core dumps leave them out.
///
/// Errors: those of opening a file; not-found, if it is not the file `inode`, for that one is gone; invalid-data, if it is too short.
pub(super) fn map_segment(
    path: &Path,
    inode: u64,
    length: u64,
    owner: u32,
) -> Result<Mapping, Refusal> {
    let (file, stat) = open(path, OFlags::RDONLY, owner)?;
    if stat.st_ino != inode {
        return Err(Errno::NOENT.into());
    }
    if (stat.st_size as u64) < length {
        return Err(bad(format!("expected {length} bytes, found {}", stat.st_size)));
    }
    let length = usize::try_from(length).map_err(|_| Errno::NOMEM)?;
    // SAFETY: the mapping is read-only and private to the value returned. Undefined behaviour would need the file to change under us: the record that names
    // it is written after the last byte of it was, its writer has made it read-only, and a file of another inode was refused above. Its owner could still change it, and
    // is trusted not to; lengths are read once when an archive is opened, so that a changed byte gives a wrong answer, not an access outside. It is not
    // shortened: iceoryx2 sizes a segment once, before it is sent, and unlinks it afterwards. It has no holes, so that reading never needs a new page.
    let map = unsafe { Mapping::read_only(&file, length) };
    let map = map.map_err(|error| match error.kind() {
        // A mapping is refused so for no other reason.
        io::ErrorKind::WouldBlock => Refusal::LockLimit(length as u64),
        _ => error.into(),
    })?;
    leave_out_of_core_dumps(map.bytes());
    Ok(map)
}
