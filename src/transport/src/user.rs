//! Whose files these are.

use crate::domain::Domain;
use crate::error::AttachError;
use std::fs;
use std::io;
use std::os::unix::fs::MetadataExt;

/// Checks that the root folder is a real folder of this process's user. Files of two users in one domain could not be
/// cleaned up by either, even if one of them may read everything.
///
/// Errors: [`AttachError::PermissionDenied`]; [`AttachError::Io`], of kind not-found if there is no root folder.
pub fn check_owner(domain: &Domain) -> Result<(), AttachError> {
    check_owned_by(domain, rustix::process::geteuid().as_raw())
}

/// The same of the user whose id is known already.
pub(super) fn check_owned_by(domain: &Domain, us: u32) -> Result<(), AttachError> {
    let root = domain.root();
    let metadata = fs::symlink_metadata(root).map_err(|error| AttachError::io(root, error))?;
    if !metadata.is_dir() {
        return Err(AttachError::io(root, io::ErrorKind::NotADirectory.into()));
    }
    if us != metadata.uid() {
        let owner = metadata.uid();
        return Err(AttachError::PermissionDenied { path: root.to_owned(), owner, us });
    }
    Ok(())
}
