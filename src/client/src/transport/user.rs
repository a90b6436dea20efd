//! Whose files these are.

use super::domain::Domain;
use super::error::AttachError;
use std::fs;
use std::io;
use std::os::unix::fs::MetadataExt;
use std::sync::OnceLock;

/// Effective user id of this process, as the kernel's status text has it; `None` without `/proc`.
fn effective_user() -> Option<u32> {
    static USER: OnceLock<Option<u32>> = OnceLock::new();
    *USER.get_or_init(|| {
        let status = fs::read_to_string("/proc/self/status").ok()?;
        let ids = status.lines().find_map(|line| line.strip_prefix("Uid:"))?;
        // Real, effective, saved, file system.
        ids.split_whitespace().nth(1)?.parse().ok()
    })
}

/// Checks that the root folder is a real folder of this process's user. Files of two users in one domain could not be
/// cleaned up by either, even if one of them may read everything.
///
/// Errors: [`AttachError::PermissionDenied`]; [`AttachError::Io`], of kind not-found if there is no root folder.
pub fn check_owner(domain: &Domain) -> Result<(), AttachError> {
    let root = domain.root();
    let metadata = fs::symlink_metadata(root).map_err(|error| AttachError::io(root, error))?;
    if !metadata.is_dir() {
        return Err(AttachError::io(root, io::ErrorKind::NotADirectory.into()));
    }
    match effective_user() {
        Some(us) if us != metadata.uid() => {
            Err(AttachError::PermissionDenied { path: root.to_owned(), owner: metadata.uid(), us })
        }
        _ => Ok(()),
    }
}
