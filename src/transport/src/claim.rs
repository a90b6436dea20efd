//! Which daemon serves a map: one at a time. It holds a lock, which the kernel releases if the daemon dies.

use crate::domain::Domain;
use crate::observer::daemon_heard;
use crate::regular::{create_guarded, open_owned};
use std::fs::{File, TryLockError};
use std::io::{self, Read, Write};
use std::os::unix::fs::MetadataExt;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use thiserror::Error;

/// Suffix of the lock file of a map.
pub(crate) const SUFFIX: &str = ".lock";

/// How long a daemon tries to claim a map: longer than a client needs to look whether the map is served, which takes the
/// lock for some microseconds, on a busy machine until it has its next turn.
const PATIENCE: Duration = Duration::from_secs(2);

/// Longest text of a process id that is read \[bytes\].
const LONGEST_PID: u64 = 32;

/// Pause between two attempts.
const PAUSE: Duration = Duration::from_millis(2);

/// Why a map cannot be claimed.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ClaimError {
    /// Another daemon serves it.
    #[error("map {map:?} is served by process {} already; stop that daemon, or serve under another name with --name",
        pid.map_or_else(|| "(unknown)".to_owned(), |pid| pid.to_string()))]
    Served {
        /// The map.
        map: String,
        /// The process id in the lock file.
        pid: Option<u32>,
    },
    /// The lock file cannot be used.
    #[error("{}: {source}", path.display())]
    Io {
        /// The lock file.
        path: PathBuf,
        /// The system's error.
        source: io::Error,
    },
}

/// The right to serve a map. Held by an exclusive `flock`, so that it ends with the process at the latest.
#[derive(Debug)]
pub struct Claim {
    file: File,
    path: PathBuf,
}

impl Claim {
    /// Claims a map for this process.
    ///
    /// Errors: another daemon serves the map; the lock file cannot be used.
    pub fn acquire(domain: &Domain, map: &str) -> Result<Self, ClaimError> {
        let path = domain.map_file(map, SUFFIX);
        let io = |source| ClaimError::Io { path: path.clone(), source };
        let until = Instant::now() + PATIENCE;
        loop {
            let mut file = create_guarded(&path).map_err(io)?;
            match file.try_lock() {
                // A daemon that ends removes the file before it unlocks: then the lock is on a file without a name.
                Ok(()) if is_named(&file, &path) => {
                    let written =
                        file.set_len(0).and_then(|()| write!(file, "{}", std::process::id()));
                    let claim = Self { file, path: path.clone() };
                    return match written {
                        Ok(()) => Ok(claim),
                        Err(error) => {
                            claim.release();
                            Err(io(error))
                        }
                    };
                }
                Ok(()) => {}
                Err(TryLockError::WouldBlock) if Instant::now() >= until => {
                    return Err(ClaimError::Served {
                        map: map.to_owned(),
                        pid: read_pid(&mut file),
                    });
                }
                Err(TryLockError::WouldBlock) => std::thread::sleep(PAUSE),
                Err(TryLockError::Error(error)) => return Err(io(error)),
            }
        }
    }

    /// Gives the map up and removes the lock file.
    pub fn release(self) {
        // A file that cannot be removed is unlocked all the same, and then says that nobody serves the map.
        let _ = std::fs::remove_file(&self.path);
        drop(self.file);
    }
}

fn is_named(file: &File, path: &std::path::Path) -> bool {
    match (file.metadata(), std::fs::metadata(path)) {
        (Ok(ours), Ok(named)) => (ours.dev(), ours.ino()) == (named.dev(), named.ino()),
        _ => false,
    }
}

fn read_pid(file: &mut File) -> Option<u32> {
    let mut text = String::new();
    file.take(LONGEST_PID).read_to_string(&mut text).ok()?;
    text.trim().parse().ok()
}

/// Process id of the daemon that serves a map; 0 if a daemon serves it but its id is not known; `None` if no daemon serves it or this
/// cannot be determined.
pub fn served_by(domain: &Domain, map: &str) -> Option<u32> {
    who_serves(domain, map).ok().flatten()
}

/// As [`served_by`].
///
/// Errors: the lock file cannot be examined.
pub(crate) fn who_serves(domain: &Domain, map: &str) -> io::Result<Option<u32>> {
    let mut file = match open_owned(&domain.map_file(map, SUFFIX), domain.owner()) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        // Locks are their user's alone.
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => {
            return Ok(daemon_heard(domain, map));
        }
        other => other?,
    };
    Ok(match file.try_lock_shared() {
        // Closing the file releases the lock.
        Ok(()) => None,
        Err(_) => Some(read_pid(&mut file).unwrap_or(0)),
    })
}
