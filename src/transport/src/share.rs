//! Who may read what a daemon serves.

use rustix::fd::AsFd;
use rustix::fs::{Gid, Mode};
use std::io;

/// Who may read what a daemon serves, besides its own user. Nobody else may write anything, and files that are locked are the daemon's
/// user's alone: a lock needs no more than the right to read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Share {
    /// Nobody.
    #[default]
    Private,
    /// Members of the group of this id.
    Group(u32),
}

impl Share {
    /// Gives the root folder its group and rights: 0750, or 0700.
    ///
    /// Errors: what the system says, as not-permitted for a group that the daemon's user is not in.
    pub fn folder(self, folder: impl AsFd) -> io::Result<()> {
        self.apply(folder, Mode::RWXU, Mode::RGRP | Mode::XGRP)
    }

    /// The same for a file that its owner writes on: 0640, or 0600.
    ///
    /// Errors: as [`Share::folder`].
    pub fn written(self, file: impl AsFd) -> io::Result<()> {
        self.apply(file, Mode::RUSR | Mode::WUSR, Mode::RGRP)
    }

    /// The same for a file that nobody changes any more: 0440, or 0400.
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
