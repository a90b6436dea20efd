//! Who may read what is served.

use super::error::ServeError;
use super::server::Server;
use mapd_transport::{AttachError, Domain, Share};
use rustix::fs::{Mode, OFlags};
use std::io;

/// Rights of a group.
const OF_GROUP: Mode = Mode::RWXG;

impl Server {
    /// Lets a group read what is published from now on; without a group, only the daemon's user may, which is the default. Call it before the first map is claimed.
    ///
    /// Errors: this user is not in the group; the domain is shared with another group already; what the system says.
    pub fn share(&mut self, share: Share) -> Result<(), ServeError> {
        share_root(&self.domain, share, self.alone)?;
        self.share = share;
        Ok(())
    }
}

/// A daemon serves as its own user, whatever users its environment trusts.
///
/// Errors: another user is named as the owner.
pub(super) fn check_owner_is_us(domain: &Domain) -> Result<(), ServeError> {
    let us = rustix::process::geteuid().as_raw();
    if domain.owner() == us {
        return Ok(());
    }
    let path = domain.root().to_owned();
    Err(AttachError::PermissionDenied { path, owner: us, trusted: domain.owner() }.into())
}

/// Opens the root folder to a group, or closes it; `alone` says whether the domain was deserted. Another daemon that shares it with its group keeps that: what a private daemon serves
/// there is its user's alone all the same.
///
/// Errors: this user is not in the group; the domain is shared with another group already; what the system says.
fn share_root(domain: &Domain, share: Share, alone: bool) -> Result<(), ServeError> {
    let failed = |error: rustix::io::Errno| ServeError::io(domain.root())(error.into());
    let flags = OFlags::RDONLY | OFlags::DIRECTORY | OFlags::NOFOLLOW | OFlags::CLOEXEC;
    let folder = rustix::fs::open(domain.root(), flags, Mode::empty()).map_err(failed)?;
    let found = rustix::fs::fstat(&folder).map_err(failed)?;
    let is_shared = Mode::from_raw_mode(found.st_mode).intersects(OF_GROUP);
    // What this daemon found in a deserted domain was a dead one's.
    let by_others = is_shared && !alone;
    match share {
        Share::Private if by_others => Ok(()),
        Share::Group(group) if by_others && group != found.st_gid => {
            Err(ServeError::SharedAlready { group: found.st_gid, wanted: group })
        }
        Share::Private | Share::Group(_) => share.folder(&folder).map_err(|error| match share {
            Share::Group(group) if error.kind() == io::ErrorKind::PermissionDenied => {
                ServeError::NotInGroup { group }
            }
            _ => ServeError::io(domain.root())(error),
        }),
    }
}
