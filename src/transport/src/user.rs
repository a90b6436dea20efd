//! Whose files these are.

use crate::domain::Domain;
use crate::error::AttachError;
use std::fs;
use std::io;
use std::os::unix::fs::MetadataExt;
use std::path::Path;

/// What the kernel shows for an owner whose id is not mapped into this user namespace: its default.
const UNMAPPED: u32 = 65_534;

/// Ids of a namespace that maps all of them.
const ALL: &str = "4294967295";

/// Whether a file of user `found` is one of `owner`'s. A file with an unknown owner belongs to no user: in a user namespace all such files
/// seem to be of one user, which this process may seem to be, too.
pub(crate) fn trusts(owner: u32, found: u32) -> bool {
    found == owner && (found != UNMAPPED || all_are_mapped())
}

/// Whether a file of user `found` is this process's own user's.
pub fn is_ours(found: u32) -> bool {
    trusts(rustix::process::geteuid().as_raw(), found)
}

fn all_are_mapped() -> bool {
    let map = std::fs::read_to_string("/proc/self/uid_map").unwrap_or_default();
    map.split_whitespace().eq(["0", "0", ALL])
}

/// Checks that the root folder is a real folder of the domain's owner.
///
/// Errors: [`AttachError::PermissionDenied`], [`AttachError::UnknownOwner`]; [`AttachError::Io`], of kind not-found if there is no root folder.
pub fn check_owner(domain: &Domain) -> Result<(), AttachError> {
    check_owned_by(domain, domain.owner())
}

/// The same of an owner whose id is known already.
pub(super) fn check_owned_by(domain: &Domain, owner: u32) -> Result<(), AttachError> {
    let root = domain.root();
    let metadata = fs::symlink_metadata(root).map_err(|error| AttachError::io(root, error))?;
    if !trusts(owner, metadata.uid()) {
        return Err(not_owned(root, metadata.uid(), owner));
    }
    match metadata.is_dir() {
        true => Ok(()),
        false => Err(AttachError::io(root, io::ErrorKind::NotADirectory.into())),
    }
}

/// Checks that the domain is this process's own user's: to write in it, as daemons and subscribers do.
///
/// Errors: as [`check_owner`]; [`AttachError::OnlyObservers`] for a folder of another user that the domain names as its owner.
pub fn check_own(domain: &Domain) -> Result<(), AttachError> {
    match check_owned_by(domain, rustix::process::geteuid().as_raw()) {
        Err(AttachError::PermissionDenied { path, owner, .. }) if owner == domain.owner() => {
            Err(AttachError::OnlyObservers { path, owner })
        }
        other => other,
    }
}

/// The error for what belongs to user `found`.
pub(crate) fn not_owned(path: &Path, found: u32, trusted: u32) -> AttachError {
    let path = path.to_owned();
    match found {
        UNMAPPED if !all_are_mapped() => AttachError::UnknownOwner { path },
        owner => AttachError::PermissionDenied { path, owner, trusted },
    }
}
