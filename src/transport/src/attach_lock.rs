//! The attach lock: no process sees a segment that is being created, and no process cleans up while another one creates.

use crate::domain::Domain;
use crate::error::AttachError;
use crate::regular::{create_guarded, open_owned};
use std::fs::{File, TryLockError};
use std::io;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Name in the root folder; no map's file can have it, for map names do not begin with a dot.
const FILE_NAME: &str = ".attach";

/// Name of the turnstile, through which everyone passes on the way to the lock. Who wants the lock exclusively stands in
/// it meanwhile: holders leave, and no other process enters. Clients that attach without pause would else keep a daemon from
/// ever cleaning up.
const TURNSTILE: &str = ".turn";

/// Pause between two attempts to lock. Holders keep the lock for a millisecond or less; waiting in the kernel instead
/// could not be given a deadline without a signal.
const PAUSE: Duration = Duration::from_micros(200);

/// A file whose `flock` clients hold shared while they attach, and daemons exclusively while they create or clean up.
/// The kernel releases it when its holder dies.
#[derive(Debug)]
pub struct AttachLock {
    file: Arc<File>,
    turnstile: Arc<File>,
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
        Self::with(domain, |path| open_owned(path, domain.owner()))
    }

    /// Opens or creates the lock. For daemons.
    ///
    /// Errors: what the system says.
    pub fn create(domain: &Domain) -> io::Result<Self> {
        Self::with(domain, create_guarded)
    }

    fn with(domain: &Domain, open: impl Fn(&Path) -> io::Result<File>) -> io::Result<Self> {
        let path = domain.root().join(FILE_NAME);
        let file = Arc::new(open(&path)?);
        let turnstile = Arc::new(open(&domain.root().join(TURNSTILE))?);
        Ok(Self { file, turnstile, path })
    }

    /// Locks shared, trying until the deadline, at least once. `None`: a daemon held it, or waited for it, all the time.
    ///
    /// Errors: what the system says.
    pub fn shared(&self, deadline: Instant) -> Result<Option<AttachGuard>, AttachError> {
        self.try_until(deadline, || {
            self.turnstile.try_lock_shared()?;
            let _through = AttachGuard(self.turnstile.clone());
            self.file.try_lock_shared()?;
            Ok(AttachGuard(self.file.clone()))
        })
    }

    /// Locks exclusively, trying until the deadline, at least once; meanwhile no other process gets the lock. `None`: someone
    /// held it all the time.
    ///
    /// Errors: what the system says.
    pub fn exclusive(&self, deadline: Instant) -> Result<Option<AttachGuard>, AttachError> {
        let standing = self.try_until(deadline, || {
            self.turnstile.try_lock()?;
            Ok(AttachGuard(self.turnstile.clone()))
        })?;
        if standing.is_none() {
            return Ok(None);
        }
        self.try_until(deadline, || {
            self.file.try_lock()?;
            Ok(AttachGuard(self.file.clone()))
        })
    }

    /// Whether the file is still the one under its name. A daemon that leaves an empty domain removes it; a lock on a
    /// removed file excludes no process. Ask after locking.
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

    fn try_until(
        &self,
        deadline: Instant,
        attempt: impl Fn() -> Result<AttachGuard, TryLockError>,
    ) -> Result<Option<AttachGuard>, AttachError> {
        loop {
            match attempt() {
                Ok(guard) => return Ok(Some(guard)),
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Barrier;
    use std::sync::atomic::{AtomicBool, Ordering};

    /// A domain with a root folder, which is removed at the end.
    struct DomainFolder(Domain);

    impl DomainFolder {
        fn new(name: &str) -> Self {
            let domain = Domain::new(&format!("{name}{}_", std::process::id())).expect("a prefix");
            std::fs::create_dir_all(domain.root()).expect("a root folder");
            Self(domain)
        }
    }

    impl Drop for DomainFolder {
        fn drop(&mut self) {
            let _ = std::fs::remove_dir_all(self.0.root());
        }
    }

    #[test]
    fn attaching_without_pause_does_not_keep_the_daemon_out() {
        const CLIENTS: usize = 4;
        /// Each holds the lock so long, and has it again at once: some hold it at any moment.
        const HOLD: Duration = Duration::from_millis(4);
        let place = DomainFolder::new("lockfair");
        let lock = AttachLock::create(&place.0).expect("a lock");
        let (end, begun) = (AtomicBool::new(false), Barrier::new(CLIENTS + 1));
        // Without the turnstile the daemon waits for ever.
        let far = || Instant::now() + Duration::from_secs(20);
        std::thread::scope(|scope| {
            for _ in 0..CLIENTS {
                scope.spawn(|| {
                    let lock = AttachLock::open(&place.0).expect("a lock");
                    begun.wait();
                    while !end.load(Ordering::Relaxed) {
                        let guard = lock.shared(far()).expect("locks").expect("in time");
                        std::thread::sleep(HOLD);
                        drop(guard);
                    }
                });
            }
            begun.wait();
            for _ in 0..20 {
                let guard = lock.exclusive(far()).expect("locks");
                assert!(guard.is_some(), "the daemon gets the lock");
                drop(guard);
                std::thread::sleep(HOLD);
            }
            end.store(true, Ordering::Relaxed);
        });
    }

    #[test]
    fn a_wait_in_vain_leaves_the_turnstile_free() {
        let place = DomainFolder::new("lockvain");
        let daemon = AttachLock::create(&place.0).expect("a lock");
        let stopped = AttachLock::open(&place.0).expect("a lock");
        let other = AttachLock::open(&place.0).expect("a lock");
        let _held = stopped.shared(Instant::now()).expect("locks").expect("free");
        assert!(daemon.exclusive(Instant::now()).expect("locks").is_none());
        assert!(other.shared(Instant::now()).expect("locks").is_some());
    }
}
