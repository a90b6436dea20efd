//! Whether two names are one file's.

use std::ffi::OsStr;
use std::os::unix::fs::MetadataExt;
use std::path::Path;

/// Whether two paths name the same file, also by links or other spellings. Files that are not there yet are the same if they have the same
/// name in the same folder.
pub(crate) fn is_same_file(a: &Path, b: &Path) -> bool {
    let there = |path: &Path| std::fs::metadata(path).ok().map(|file| (file.dev(), file.ino()));
    match (there(a), there(b)) {
        (Some(a), Some(b)) => a == b,
        (None, None) => a == b || new_place(a).is_some_and(|place| new_place(b) == Some(place)),
        _ => false,
    }
}

/// Where a file would be: its folder and its name.
fn new_place(path: &Path) -> Option<((u64, u64), &OsStr)> {
    let folder = std::fs::metadata(crate::source::folder(path)?).ok()?;
    Some(((folder.dev(), folder.ino()), path.file_name()?))
}
