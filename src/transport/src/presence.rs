//! Which processes use a domain. Each holds a lock, which the kernel releases if the process dies.

use crate::domain::Domain;
use crate::regular::{create_guarded, open_owned};
use std::fs::File;
use std::io;

/// Name in the root folder.
const FILE_NAME: &str = ".present";

/// Held by everyone who uses shared memory of a domain: daemons, subscriptions, and pinned generations that outlive their
/// subscription. A shared `flock`; entered under the attach lock, left at any time.
#[derive(Debug)]
pub struct Presence {
    /// Unlocked when closed.
    _file: File,
}

impl Presence {
    /// Enters a domain where a daemon has been. Under the attach lock.
    ///
    /// Errors: the system's; would-block only while another process tests, without the attach lock, which processes are present.
    pub fn enter(domain: &Domain) -> io::Result<Self> {
        let file = open_owned(&domain.root().join(FILE_NAME), domain.owner())?;
        file.try_lock_shared()?;
        Ok(Self { _file: file })
    }

    /// Makes the lock file. For daemons.
    ///
    /// Errors: what the system says.
    pub fn prepare(domain: &Domain) -> io::Result<()> {
        create_guarded(&domain.root().join(FILE_NAME)).map(|_| ())
    }

    /// Whether no process is present: then all files of the domain were left by processes that have ended. Under the exclusive
    /// attach lock this stays so, because no process can enter.
    pub fn is_deserted(domain: &Domain) -> bool {
        let file = open_owned(&domain.root().join(FILE_NAME), domain.owner());
        file.is_ok_and(|file| file.try_lock().is_ok())
    }
}

/// Name in the root folder.
const SHARING: &str = ".sharing";

/// Held by every daemon that shares the domain with its group, until it ends: the root folder is open to the group as long as there is one. A shared `flock`; entered
/// and examined under the attach lock.
#[derive(Debug)]
pub struct Sharing {
    /// Unlocked when closed.
    _file: File,
}

impl Sharing {
    /// Says that this daemon shares.
    ///
    /// Errors: the system's; would-block only while another process tests, without the attach lock, whether anybody shares.
    pub fn enter(domain: &Domain) -> io::Result<Self> {
        let file = create_guarded(&domain.root().join(SHARING))?;
        file.try_lock_shared()?;
        Ok(Self { _file: file })
    }

    /// Whether no daemon shares the domain.
    pub fn is_over(domain: &Domain) -> bool {
        match open_owned(&domain.root().join(SHARING), domain.owner()) {
            Ok(file) => file.try_lock().is_ok(),
            Err(error) => error.kind() == io::ErrorKind::NotFound,
        }
    }
}
