//! The right to serve a map's name, and the counter of its generations.

use super::error::ServeError;
use mapd_client::Domain;
use mapd_client::transport::map_lock;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read, Seek, Write};
use std::os::unix::fs::OpenOptionsExt;
use std::path::PathBuf;

/// Held while a map is served. Its file says who serves it and which generation was the last; it stays when the daemon
/// ends, so that numbers never repeat, and is a few bytes long.
pub(super) struct Lease {
    path: PathBuf,
    file: File,
    last: u64,
}

impl Lease {
    /// Takes the right to serve a name.
    ///
    /// Errors: another daemon has it.
    pub(super) fn take(domain: &Domain, map: &str) -> Result<Self, ServeError> {
        let path = map_lock(domain, map);
        let failed = |error| ServeError::File { path: path.clone(), error };
        let mut file = OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .mode(0o600)
            .open(&path)
            .map_err(failed)?;
        let mut text = String::new();
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                let _ = file.read_to_string(&mut text);
                let pid = text.split_whitespace().next().unwrap_or("unknown").to_owned();
                return Err(ServeError::AlreadyServed { name: map.to_owned(), pid });
            }
            Err(TryLockError::Error(error)) => return Err(failed(error)),
        }
        file.read_to_string(&mut text).map_err(failed)?;
        let last = text.split_whitespace().nth(1).and_then(|n| n.parse().ok()).unwrap_or(0);
        Ok(Self { path, file, last })
    }

    /// The next generation's number, written down before it is used.
    pub(super) fn next(&mut self) -> Result<u64, ServeError> {
        self.last += 1;
        // Fixed width: a longer text is never left behind a shorter one.
        let text = format!("{:>10} {:>20}\n", std::process::id(), self.last);
        self.file
            .rewind()
            .and_then(|()| self.file.write_all(text.as_bytes()))
            .map_err(|error| ServeError::File { path: self.path.clone(), error })?;
        Ok(self.last)
    }
}
