//! Where entries of overlays hold, worked out before the main thread needs it: by the threads that take requests and that prepare maps. What did
//! not change is not worked out again.

use super::ByName;
use super::prepare::Prepared;
use crate::serve::ServeError;
use mapd_archive::AlignedBytes;
use mapd_client::{Attach, Client, Map};
use mapd_overlay::{Document, EntryLocation, Placements, Policy, Resolved};
use mapd_transport::Domain;
use std::io;
use std::os::unix::fs::FileExt;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Contents of a map for which it is kept where entries hold: the one that is served, and the one that comes next or was before.
const CONTENTS: usize = 2;

/// How long the daemon waits for its own map: it is there.
pub(super) const OWN_MAP: Duration = Duration::from_secs(2);

/// Why an archive is not served whose file was written over.
pub(super) const CHANGED: &str = "the file has changed since it was prepared";

/// Shared by the daemon's threads.
pub(crate) struct Desk {
    policy: Policy,
    domain: Domain,
    maps: Mutex<ByName<OfMap>>,
}

/// Of one map.
#[derive(Default)]
struct OfMap {
    /// What is laid over it.
    document: Arc<Document>,
    /// Where that holds, by content, the newest last.
    placements: Vec<Placements>,
}

impl Desk {
    pub(super) fn new(policy: Policy, domain: Domain) -> Self {
        Self { policy, domain, maps: Mutex::default() }
    }

    fn maps(&self) -> MutexGuard<'_, ByName<OfMap>> {
        self.maps.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Notes what is laid over a map from now on.
    pub(super) fn note(&self, name: &str, document: &Document) {
        self.maps().entry(name.to_owned()).or_default().document = Arc::new(document.clone());
    }

    /// Places a document on the map that is served, for what is asked next. Whatever goes wrong here goes wrong again, with better words.
    pub(super) fn place_on_served(&self, name: &str, document: &Document) {
        if !self.maps().contains_key(name) {
            return;
        }
        if let Ok(served) = Client::connect_as(Attach::Observer, &self.domain, name, OWN_MAP) {
            self.place(name, served.snapshot().map(), document);
        }
    }

    /// Places what is laid over a map on an archive that may be served next.
    pub(super) fn place_on_next(&self, name: &str, archive: &Prepared) {
        let document = self.maps().get(name).map(|own| own.document.clone()).unwrap_or_default();
        if !document.entries.is_empty() {
            // What cannot be read is told when it is published.
            let read = |bytes: &mut [u8]| read_file(archive, bytes);
            let _ = on_archive(name, archive, read, |map| self.place(name, map, &document));
        }
    }

    /// Places without holding up the others.
    fn place(&self, name: &str, map: Map<'_>, document: &Document) {
        let missing = self.with(name, map, |own| own.missing(document));
        if missing.entries.is_empty() {
            return;
        }
        let mut placed = Placements::new(map, self.policy);
        placed.place(map, &missing);
        self.with(name, map, |own| own.absorb(placed));
    }

    /// Where a document's first entry holds on the map that is served.
    ///
    /// Errors: it does not; why.
    pub(super) fn location(
        &self,
        name: &str,
        document: &Document,
    ) -> Result<EntryLocation, String> {
        let served = Client::connect_as(Attach::Observer, &self.domain, name, OWN_MAP);
        let snapshot = served.map_err(|error| error.to_string())?.snapshot();
        let mut placed = Placements::new(snapshot.map(), self.policy);
        placed.place(snapshot.map(), document);
        let first = document.entries.first().and_then(|entry| placed.location(&entry.id));
        match first {
            Some(Ok(location)) => Ok(location.clone()),
            Some(Err(error)) => Err(error.to_string()),
            None => Err("places: too long".to_owned()),
        }
    }

    /// How many entries there are whose names begin so, but for one.
    pub(super) fn count(&self, name: &str, prefix: &str, but: &str) -> usize {
        let document = self.maps().get(name).map(|own| own.document.clone()).unwrap_or_default();
        let counts = |id: &&str| id.starts_with(prefix) && *id != but;
        document.entries.iter().map(|entry| entry.id.as_str()).filter(counts).count()
    }

    /// Resolves a document against a map.
    pub(super) fn resolve(&self, name: &str, map: Map<'_>, document: &Document) -> Resolved {
        self.with(name, map, |own| own.resolve(map, document))
    }

    fn with<T>(&self, name: &str, map: Map<'_>, work: impl FnOnce(&mut Placements) -> T) -> T {
        let mut maps = self.maps();
        let placements = &mut maps.entry(name.to_owned()).or_default().placements;
        let known = placements.iter().position(|one| one.is_of(map));
        let mut own = match known {
            Some(at) => placements.remove(at),
            None => Placements::new(map, self.policy),
        };
        let found = work(&mut own);
        placements.push(own);
        if placements.len() > CONTENTS {
            placements.remove(0);
        }
        found
    }
}

/// Reads an archive that is not served yet from its file.
///
/// Errors: what the system says.
pub(super) fn read_file(archive: &Prepared, bytes: &mut [u8]) -> io::Result<()> {
    archive.file.read_exact_at(bytes, 0)
}

/// Does something with the map of an archive that is not served yet, whose bytes `read` gives.
///
/// Errors: they cannot be read, or are not those that were prepared.
pub(super) fn on_archive<T>(
    name: &str,
    archive: &Prepared,
    read: impl FnOnce(&mut [u8]) -> io::Result<()>,
    work: impl FnOnce(Map<'_>) -> T,
) -> Result<T, ServeError> {
    let fail = |source| ServeError::Fill { map: name.to_owned(), source };
    let length = usize::try_from(archive.length).unwrap_or(usize::MAX);
    let mut bytes = AlignedBytes::with_capacity(length);
    bytes.resize(length, 0);
    read(&mut bytes).map_err(|error| fail(error.into()))?;
    let opened = mapd_archive::open(&bytes).map_err(|error| fail(error.into()))?;
    if opened.header != archive.header {
        return Err(fail(CHANGED.into()));
    }
    Ok(work(Map::new(&opened, 0)))
}
