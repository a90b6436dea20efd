//! The lock that keeps clean-up away from half-made attachments.
//!
//! A client that is killed in the middle of attaching can leave segments that make iceoryx2's clean-up wait for ever.
//! Clients hold this lock shared while they attach; the daemon takes it alone before it sweeps such segments away.
//! The system releases it when its holder dies.

use super::domain::Domain;
use std::fs::{File, OpenOptions, TryLockError};
use std::io;
use std::os::unix::fs::OpenOptionsExt;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Name of the lock file in the root folder.
const NAME: &str = "attach.lock";
/// Pause between two tries.
const PAUSE: Duration = Duration::from_millis(1);

/// How the lock is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LockMode {
    /// With other clients.
    Shared,
    /// Alone.
    Exclusive,
}

/// The lock, held until dropped.
#[derive(Debug)]
pub struct AttachLock(File);

impl AttachLock {
    /// Path of the lock file.
    pub fn path(domain: &Domain) -> PathBuf {
        domain.root().join(NAME)
    }

    /// Takes the lock if that is possible before the deadline; `None` if somebody held it all the time.
    ///
    /// Errors: the lock file cannot be opened; clients do not create it.
    pub fn take(domain: &Domain, mode: LockMode, deadline: Instant) -> io::Result<Option<Self>> {
        let path = Self::path(domain);
        let file = match mode {
            LockMode::Shared => File::open(path)?,
            LockMode::Exclusive => OpenOptions::new()
                .read(true)
                .write(true)
                .create(true)
                .truncate(false)
                .mode(0o600)
                .open(path)?,
        };
        loop {
            let tried = match mode {
                LockMode::Shared => file.try_lock_shared(),
                LockMode::Exclusive => file.try_lock(),
            };
            match tried {
                Ok(()) => return Ok(Some(Self(file))),
                Err(TryLockError::Error(error)) => return Err(error),
                Err(TryLockError::WouldBlock) if Instant::now() >= deadline => return Ok(None),
                Err(TryLockError::WouldBlock) => std::thread::sleep(PAUSE),
            }
        }
    }
}

impl Drop for AttachLock {
    fn drop(&mut self) {
        // Closing the file releases the lock too; this is only sooner.
        let _ = self.0.unlock();
    }
}
