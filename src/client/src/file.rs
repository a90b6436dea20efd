//! A `.mapd` file, mapped read-only.
#![allow(unsafe_code)]

use mapd_transport::{Mapping, open_regular};
use std::io;
use std::path::Path;

/// Maps a file read-only.
///
/// The file must not be truncated or overwritten while it is mapped; mapd itself replaces archives by renaming a new file
/// over the old one, which leaves mappings of the old one as they are.
pub(crate) fn map(path: &Path) -> io::Result<Mapping> {
    let file = open_regular(path)?;
    let length = usize::try_from(file.metadata()?.len()).map_err(|_| io::ErrorKind::OutOfMemory)?;
    // SAFETY: undefined behaviour would need the file to change under us; the documented way of replacing archives is renaming, and
    // lengths are read once when opening, so that a changed byte gives a wrong answer, not an access outside.
    unsafe { Mapping::read_only(&file, length) }
}
