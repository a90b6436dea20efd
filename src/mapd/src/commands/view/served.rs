//! A map that is shown: a file, or a live one that is followed.

use crate::args::{OpenedSource, Opening};
use crate::commands::status;
use crate::findings;
use crate::progress::Manner;
use crate::source::SHARED;
use anyhow::Result;
use mapd_client::{Client, Domain, Snapshot};
use mapd_web::page::Findings;
use std::path::Path;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// What is shown of a map.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct ShownVersion {
    /// The map's generation.
    pub(super) generation: u64,
    /// The revision of what is laid over it.
    pub(super) overlay: u64,
}

fn version(snapshot: &Snapshot) -> ShownVersion {
    ShownVersion { generation: snapshot.generation(), overlay: snapshot.overlay_revision() }
}

/// Longest wait for the next generation or overlay, after which it is waited for anew.
const WAIT: Duration = Duration::from_secs(5);
/// Pause after the daemon could not be asked.
const PAUSE: Duration = Duration::from_secs(1);

/// A map that is shown.
pub(super) struct Served {
    source: String,
    client: Option<Client>,
    /// Where a live map is.
    domain: Option<Domain>,
    findings: Findings,
    now: Mutex<Snapshot>,
    changed: Condvar,
}

impl Served {
    /// Opens a source; none where it is rejected, which has been said.
    ///
    /// Errors: as [`Opening::open`].
    pub(super) fn open(source: &str, opening: &Opening) -> Result<Option<Self>> {
        let (client, opened) = match source.strip_prefix(SHARED) {
            Some(name) => {
                let client = opening.connect(name)?;
                let snapshot = client.snapshot();
                (Some(client), Some(OpenedSource::compiled_before(snapshot)))
            }
            None => (None, opening.open_with_findings(source, Manner::Bar)?),
        };
        let domain = client.as_ref().map(|_| opening.domain()).transpose()?;
        let source = source.to_owned();
        Ok(opened.map(|OpenedSource { snapshot, compilation }| Self {
            source,
            client,
            domain,
            findings: findings::of(&snapshot, compilation.as_deref()),
            now: snapshot.into(),
            changed: Condvar::new(),
        }))
    }

    /// As it was named.
    pub(super) fn source(&self) -> &str {
        &self.source
    }

    /// What was found in a file; not known of a live map.
    pub(super) fn findings(&self) -> &Findings {
        &self.findings
    }

    /// What it is called: a file without its folder and kind, a live map by its name.
    pub(super) fn name(&self) -> String {
        let name = self.source.strip_prefix(SHARED).unwrap_or(&self.source);
        Path::new(name).file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// What `mapd status --json` says of a live map, `null` for a file.
    ///
    /// Errors: the domain cannot be read.
    pub(super) fn status(&self) -> Result<String> {
        let name = self.source.strip_prefix(SHARED).unwrap_or_default();
        self.domain.as_ref().map_or(Ok("null".to_owned()), |domain| status::of_map(domain, name))
    }

    fn lock(&self) -> MutexGuard<'_, Snapshot> {
        self.now.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What is served now.
    pub(super) fn snapshot(&self) -> Snapshot {
        self.lock().clone()
    }

    /// Generation and revision of the overlay that are served now.
    pub(super) fn version(&self) -> ShownVersion {
        version(&self.lock())
    }

    /// Waits until another generation or overlay than this is served, so long at most; what is.
    pub(super) fn other_than(&self, known: ShownVersion, longest: Duration) -> ShownVersion {
        let is_same = |now: &mut Snapshot| version(now) == known;
        let waited = self.changed.wait_timeout_while(self.lock(), longest, is_same);
        version(&waited.unwrap_or_else(PoisonError::into_inner).0)
    }

    /// Follows a live map for ever; returns at once for a file.
    pub(super) fn follow(&self) {
        let Some(client) = &self.client else { return };
        loop {
            match client.wait_change(WAIT) {
                Ok(true) => {
                    *self.lock() = client.snapshot();
                    self.changed.notify_all();
                }
                Ok(false) => {}
                // The daemon has gone, and another one may come.
                Err(_) => std::thread::sleep(PAUSE),
            }
        }
    }
}
