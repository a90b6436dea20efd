//! A map that is shown: a file, or a live one that is followed.

use crate::args::{OpenedSource, Opening};
use crate::commands::status;
use crate::findings;
use crate::progress::Manner;
use crate::source::Source;
use anyhow::Result;
use mapd_client::{Client, Domain, Snapshot};
use mapd_web::page::Findings;
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
    source: Source,
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
    pub(super) fn open(source: &Source, opening: &Opening) -> Result<Option<Self>> {
        let (client, opened) = match source {
            Source::Live(name) => {
                let client = opening.connect(name)?;
                let snapshot = client.snapshot();
                (Some(client), Some(OpenedSource::compiled_before(snapshot)))
            }
            Source::File(_) => (None, opening.open_with_findings(source, Manner::Bar)?),
        };
        let domain = client.as_ref().map(|_| opening.domain()).transpose()?;
        let source = source.clone();
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
    pub(super) fn source(&self) -> &Source {
        &self.source
    }

    /// What was found in a file; not known of a live map.
    pub(super) fn findings(&self) -> &Findings {
        &self.findings
    }

    /// What it is called: a file without its folder and kind, a live map by its name.
    pub(super) fn name(&self) -> String {
        self.source.title()
    }

    /// What `mapd status --json` says of a live map, `null` for a file.
    ///
    /// Errors: the domain cannot be read.
    pub(super) fn status(&self) -> Result<String> {
        match (&self.source, &self.domain) {
            (Source::Live(name), Some(domain)) => status::of_map(domain, name),
            _ => Ok("null".to_owned()),
        }
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

    /// Waits until another generation or overlay than this is served, so long at most, and while `is_wanted`; what is.
    pub(super) fn other_than(
        &self,
        known: ShownVersion,
        longest: Duration,
        is_wanted: impl Fn() -> bool,
    ) -> ShownVersion {
        let is_same = |now: &mut Snapshot| version(now) == known && is_wanted();
        let waited = self.changed.wait_timeout_while(self.lock(), longest, is_same);
        version(&waited.unwrap_or_else(PoisonError::into_inner).0)
    }

    /// Has those who wait look again whether they still want to.
    pub(super) fn wake(&self) {
        // Under the lock: who has just looked and found no reason to stop sleeps by then.
        let _now = self.lock();
        self.changed.notify_all();
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
