//! Keeping a generation's pages in memory.
#![allow(unsafe_code)]

use memmap2::Mmap;
use std::fs::File;
use std::io;

/// Pages of a file in memory that are not moved to swap as long as this lives (mlock(2)): they are locked for every process
/// that maps them, because the file has no others. Counts against the limit of locked memory (RLIMIT_MEMLOCK) of this
/// process, unless it has CAP_IPC_LOCK.
pub(crate) struct LockedPages {
    _mapping: Mmap,
}

impl LockedPages {
    /// Locks all pages of a file; those that are not there yet are provided first.
    ///
    /// Errors: what the system says; out-of-memory and not-permitted mean the limit.
    pub(crate) fn of(file: &File) -> io::Result<Self> {
        // SAFETY: the mapping's bytes are never read, so it does not matter which process changes them, or whether the file
        // gets shorter; it exists to be locked, and unlocks when it is dropped.
        let mapping = unsafe { Mmap::map(file)? };
        mapping.lock()?;
        Ok(Self { _mapping: mapping })
    }
}
