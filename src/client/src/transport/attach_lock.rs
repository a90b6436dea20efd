//! The attach lock: nobody sees a segment that is being created, and nobody cleans up while someone creates.

use super::domain::Domain;
use super::error::AttachError;
use std::fs::{File, OpenOptions, TryLockError};
use std::io;
use std::os::unix::fs::{MetadataExt, OpenOptionsExt};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Name in the root folder; no map's file can have it, for map names do not begin with a dot.
const FILE_NAME: &str = ".attach";

/// Pause between two attempts to lock. Holders keep the lock for a millisecond or less; waiting in the kernel instead
/// could not be given a deadline without a signal.
const PAUSE: Duration = Duration::from_micros(200);

/// A file whose `flock` clients hold shared while they attach, and daemons exclusively while they create or clean up.
/// The kernel releases it when its holder dies.
#[derive(Debug)]
pub struct AttachLock {
    file: Arc<File>,
    path: PathBuf,
}

/// Releases the lock when dropped.
#[derive(Debug)]
pub struct AttachGuard(Arc<File>);

impl Drop for AttachGuard {
    fn drop(&mut self) {
        // Fails only for a closed file, which would be unlocked.
        let _ = self.0.unlock();
    }
}

impl AttachLock {
    /// Opens the lock of a domain where a daemon has been.
    ///
    /// Errors: [`io::ErrorKind::NotFound`] if there was none; whatever else the system says.
    pub fn open(domain: &Domain) -> io::Result<Self> {
        let path = domain.root().join(FILE_NAME);
        Ok(Self { file: Arc::new(OpenOptions::new().read(true).open(&path)?), path })
    }

    /// Opens or creates the lock. For daemons.
    ///
    /// Errors: what the system says.
    pub fn create(domain: &Domain) -> io::Result<Self> {
        let path = domain.root().join(FILE_NAME);
        let file = OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .mode(0o600)
            .open(&path)?;
        Ok(Self { file: Arc::new(file), path })
    }

    /// Locks shared, trying until the deadline, at least once. `None`: a daemon held it all the time.
    ///
    /// Errors: what the system says.
    pub fn shared(&self, deadline: Instant) -> Result<Option<AttachGuard>, AttachError> {
        self.lock(deadline, File::try_lock_shared)
    }

    /// Locks exclusively, trying until the deadline, at least once. `None`: someone held it all the time.
    ///
    /// Errors: what the system says.
    pub fn exclusive(&self, deadline: Instant) -> Result<Option<AttachGuard>, AttachError> {
        self.lock(deadline, File::try_lock)
    }

    /// Whether the file is still the one under its name. A daemon that leaves an empty domain removes it; a lock on a
    /// removed file excludes nobody. Ask after locking.
    pub fn is_current(&self) -> bool {
        let identity = |m: std::fs::Metadata| (m.dev(), m.ino());
        match (self.file.metadata(), std::fs::metadata(&self.path)) {
            (Ok(ours), Ok(named)) => identity(ours) == identity(named),
            _ => false,
        }
    }

    /// Its path.
    pub fn path(&self) -> &std::path::Path {
        &self.path
    }

    fn lock(
        &self,
        deadline: Instant,
        attempt: fn(&File) -> Result<(), TryLockError>,
    ) -> Result<Option<AttachGuard>, AttachError> {
        loop {
            match attempt(&self.file) {
                Ok(()) => return Ok(Some(AttachGuard(self.file.clone()))),
                Err(TryLockError::WouldBlock) => {}
                Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(TryLockError::Error(error)) => return Err(AttachError::io(&self.path, error)),
            }
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Ok(None);
            }
            std::thread::sleep(PAUSE.min(left));
        }
    }
}
