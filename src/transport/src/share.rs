//! Which users may read the files of a daemon.

use rustix::fd::AsFd;
use rustix::fs::{Gid, Mode};
use std::io;

/// Which users may read the files of a daemon, besides its own user. No other user may write to them. Lock files are readable only by the daemon's
/// user, because read permission is enough to take a lock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Share {
    /// No other user.
    #[default]
    Private,
    /// Members of the group of this id.
    Group(u32),
}

impl Share {
    /// Gives the root folder its group and rights: 0750, or 0700.
    ///
    /// Errors: the system's; not-permitted for a group that does not contain the daemon's user.
    pub fn folder(self, folder: impl AsFd) -> io::Result<()> {
        self.apply(folder, Mode::RWXU, Mode::RGRP | Mode::XGRP)
    }

    /// The same for a file that its owner writes on: 0640, or 0600.
    ///
    /// Errors: as [`Share::folder`].
    pub fn written(self, file: impl AsFd) -> io::Result<()> {
        self.apply(file, Mode::RUSR | Mode::WUSR, Mode::RGRP)
    }

    /// The same for a file that is no longer changed: 0440, or 0400.
    ///
    /// Errors: as [`Share::folder`].
    pub fn finished(self, file: impl AsFd) -> io::Result<()> {
        self.apply(file, Mode::RUSR, Mode::RGRP)
    }

    fn apply(self, file: impl AsFd, own: Mode, of_group: Mode) -> io::Result<()> {
        let mode = match self {
            Self::Private => own,
            Self::Group(group) => {
                // The group first: no moment at which another one has the rights.
                rustix::fs::fchown(&file, None, Some(Gid::from_raw(group)))?;
                own | of_group
            }
        };
        Ok(rustix::fs::fchmod(&file, mode)?)
    }
}
