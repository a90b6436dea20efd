//! A map that is shown: a file, or a live one that is followed.

use crate::args::Opening;
use crate::source::SHARED;
use anyhow::Result;
use mapd_client::{Client, Snapshot};
use std::path::Path;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Longest wait for the next generation, after which it is waited for anew.
const WAIT: Duration = Duration::from_secs(5);
/// Pause after the daemon could not be asked.
const PAUSE: Duration = Duration::from_secs(1);

/// A map that is shown.
pub(super) struct Served {
    source: String,
    client: Option<Client>,
    now: Mutex<Snapshot>,
    changed: Condvar,
}

impl Served {
    /// Opens a source; none where it is rejected, which has been said.
    ///
    /// Errors: as [`Opening::open`].
    pub(super) fn open(source: &str, opening: &Opening) -> Result<Option<Self>> {
        let (client, snapshot) = match source.strip_prefix(SHARED) {
            Some(name) => {
                let client = opening.connect(name)?;
                let snapshot = client.snapshot();
                (Some(client), Some(snapshot))
            }
            None => (None, opening.open(source)?),
        };
        let source = source.to_owned();
        Ok(snapshot.map(|now| Self { source, client, now: now.into(), changed: Condvar::new() }))
    }

    /// As it was named.
    pub(super) fn source(&self) -> &str {
        &self.source
    }

    /// What it is called: a file without its folder and kind, a live map by its name.
    pub(super) fn name(&self) -> String {
        let name = self.source.strip_prefix(SHARED).unwrap_or(&self.source);
        Path::new(name).file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }

    fn lock(&self) -> MutexGuard<'_, Snapshot> {
        self.now.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What is served now.
    pub(super) fn snapshot(&self) -> Snapshot {
        self.lock().clone()
    }

    /// Waits until another generation than this is served, so long at most; the one that is.
    pub(super) fn other_than(&self, generation: u64, longest: Duration) -> u64 {
        let is_same = |now: &mut Snapshot| now.generation() == generation;
        let waited = self.changed.wait_timeout_while(self.lock(), longest, is_same);
        waited.unwrap_or_else(PoisonError::into_inner).0.generation()
    }

    /// Follows a live map for ever; returns at once for a file.
    pub(super) fn follow(&self) {
        let Some(client) = &self.client else { return };
        loop {
            match client.wait_next(WAIT) {
                Ok(next) => {
                    *self.lock() = next;
                    self.changed.notify_all();
                }
                // None came; or the daemon has gone, and another one may come.
                Err(_) => std::thread::sleep(PAUSE),
            }
        }
    }
}
