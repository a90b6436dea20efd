//! Who may read what is served.

use super::error::ServeError;
use super::server::Server;
use mapd_transport::{AttachGuard, Domain, Share, Sharing};
use rustix::fs::{Mode, OFlags};
use std::io;

/// Rights of a group.
const OF_GROUP: Mode = Mode::RWXG;

impl Server {
    /// Lets a group read what is published from now on; without a group, only the daemon's user may, which is the default. Call it before the first map is claimed.
    ///
    /// Errors: this user is not in the group; the domain is shared with another group already; what the system says.
    pub fn share(&mut self, share: Share) -> Result<(), ServeError> {
        let exclusive = self.exclusive();
        self.sharing = None;
        share_root(&self.domain, share)?;
        if share != Share::Private {
            let sharing = Sharing::enter(&self.domain);
            self.sharing = Some(sharing.map_err(ServeError::io(self.domain.root()))?);
        }
        drop(exclusive);
        self.share = share;
        Ok(())
    }

    /// Shares no more. The last daemon that does closes the root folder.
    pub(super) fn end_sharing(&mut self, _exclusive: Option<&AttachGuard>) {
        if self.sharing.take().is_some() {
            let closed = share_root(&self.domain, Share::Private);
            self.tell_if_failed("closing the root folder to the group", closed);
        }
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
    Err(ServeError::NotItsOwner { us, named: domain.owner() })
}

/// Opens the root folder to a group, or closes it. Another daemon that shares it with its group keeps that: what a private daemon serves
/// there is its user's alone all the same.
///
/// Errors: this user is not in the group; the domain is shared with another group already; what the system says.
fn share_root(domain: &Domain, share: Share) -> Result<(), ServeError> {
    let failed = |error: rustix::io::Errno| ServeError::io(domain.root())(error.into());
    let flags = OFlags::RDONLY | OFlags::DIRECTORY | OFlags::NOFOLLOW | OFlags::CLOEXEC;
    let folder = rustix::fs::open(domain.root(), flags, Mode::empty()).map_err(failed)?;
    let found = rustix::fs::fstat(&folder).map_err(failed)?;
    let is_shared = Mode::from_raw_mode(found.st_mode).intersects(OF_GROUP);
    // Rights that nobody needs are those of a daemon that was killed.
    let by_others = is_shared && !Sharing::is_over(domain);
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
