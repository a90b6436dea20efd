//! A `.mapd` file, mapped read-only.
#![allow(unsafe_code)]

use crate::transport::open_regular;
use memmap2::Mmap;
use std::io;
use std::path::Path;

/// Maps a file read-only.
///
/// The file must not be truncated or overwritten while it is mapped; mapd itself replaces archives by renaming a new file
/// over the old one, which leaves mappings of the old one as they are.
pub(crate) fn map(path: &Path) -> io::Result<Mmap> {
    let file = open_regular(path)?;
    // SAFETY: the mapping is read-only and private to this value. Undefined behaviour would need the file to change
    // under us; the documented way of replacing archives is renaming, and lengths are read once when opening, so that a
    // changed byte gives a wrong answer, not an access outside.
    unsafe { Mmap::map(&file) }
}
