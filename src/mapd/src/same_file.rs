//! Whether two names are one file's.

use std::os::unix::fs::MetadataExt;
use std::path::Path;

/// Whether two paths name the same file now, also by links or other spellings.
pub(crate) fn is_same_file(a: &Path, b: &Path) -> bool {
    let place = |path: &Path| std::fs::metadata(path).ok().map(|file| (file.dev(), file.ino()));
    a == b || place(a).is_some_and(|there| place(b) == Some(there))
}
