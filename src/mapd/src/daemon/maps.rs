//! What the daemon serves: each map's generations, and those to go back to.

use super::ByName;
use super::desk::{CHANGED, read_file};
use super::left_out;
use super::overlays::{Next, Overlays};
use super::prepare::{Prepared, Preparer};
use super::settings::MapSettings;
use super::watch::WatchList;
use crate::clock::unix_ns;
use crate::control::{Board, GenerationStatus, MapCounts, ReloadReport, ReloadResult, Trigger};
use crate::report::hex;
use crate::serve::{PublishMeta, ServeError, Server};
use mapd_archive::{Archive, LAYOUT_ID, verify};
use mapd_client::Domain;
use std::collections::VecDeque;
use std::error::Error;
use std::os::unix::fs::FileExt;
use std::sync::Arc;
use std::sync::atomic::Ordering;

/// Generations of a map that can be gone back to.
pub(super) const ROLLBACKS: usize = 4;

/// Reloads of a map that nobody waits for, at a time: one that is under way and has read the file already, and one that will
/// read it.
pub(super) const UNASKED_RELOADS: usize = 2;

/// A generation, and the file that it was copied from.
#[derive(Clone, Debug)]
pub(super) struct Kept {
    pub(super) archive: Prepared,
    pub(super) status: GenerationStatus,
}

/// What waits to be activated.
pub(super) struct Staged {
    pub(super) kept: Kept,
    /// Whether it was served before.
    pub(super) is_back: bool,
}

/// A map.
pub(super) struct MapEntry {
    pub(super) served: Option<Kept>,
    pub(super) staged: Option<Staged>,
    /// Reloads that have been begun and have not ended.
    pub(super) reloads: usize,
    /// What was served before, the newest last.
    pub(super) before: VecDeque<Kept>,
}

/// What came of serving all maps for the first time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FirstServing {
    All,
    /// The daemon was told to end meanwhile.
    Stopped {
        /// Maps that were sent before.
        served: usize,
    },
}

/// All maps, and the server that serves them.
pub(super) struct Maps {
    pub(super) server: Server,
    pub(super) domain: Domain,
    pub(super) overlays: Overlays,
    pub(super) entries: ByName<MapEntry>,
    pub(super) board: Arc<Board>,
    pub(super) preparer: Preparer,
    pub(super) watched: WatchList,
}

impl Maps {
    pub(super) fn new(
        server: Server,
        overlays: Overlays,
        board: Arc<Board>,
        preparer: Preparer,
        watched: WatchList,
    ) -> Self {
        let domain = overlays.domain.clone();
        Self { server, domain, overlays, entries: ByName::new(), board, preparer, watched }
    }

    /// Serves all maps for the first time. Several are filled and proved before the first is sent: either all are served or
    /// none is, but for a stop while they are sent, after which the daemon ends.
    ///
    /// Errors: why one cannot be served; then none is.
    pub(super) fn begin_all(
        &mut self,
        maps: Vec<(MapSettings, Prepared)>,
    ) -> anyhow::Result<FirstServing> {
        let stage = maps.len() > 1;
        let cancelled = self.preparer.cancelled.clone();
        // Many maps take longer than service managers wait for the end: a stop is looked for before each.
        let is_stopped = || cancelled.load(Ordering::SeqCst);
        let names = maps.iter().map(|(map, _)| map.name.as_str());
        self.server.claim_all(names.take_while(|_| !is_stopped()))?;
        for (map, _) in &maps {
            self.overlays.load(&map.name)?;
        }
        let mut filled = Vec::new();
        for (map, prepared) in maps {
            if is_stopped() {
                return Ok(FirstServing::Stopped { served: 0 });
            }
            match self.begin(&map, prepared, stage) {
                Ok(kept) => filled.push((map, kept)),
                // The stop ends a compiler as well: that its map is not ready is no failure.
                Err(_) if is_stopped() => return Ok(FirstServing::Stopped { served: 0 }),
                Err(error) => return Err(error),
            }
        }
        for (served, (map, mut kept)) in filled.into_iter().enumerate() {
            if stage {
                if is_stopped() {
                    return Ok(FirstServing::Stopped { served });
                }
                self.activate_staged(&map.name, &kept.archive)?;
                kept.status.published_unix_ns = unix_ns();
            }
            self.began(map, kept);
        }
        self.look();
        Ok(FirstServing::All)
    }

    /// Fills a map's first generation. If the archive comes from the cache and does not prove, it is compiled after all.
    fn begin(
        &mut self,
        map: &MapSettings,
        prepared: Prepared,
        stage: bool,
    ) -> anyhow::Result<Kept> {
        let name = map.name.clone();
        let key = prepared.key.filter(|_| prepared.from_cache);
        let status = match (self.fill(&name, &prepared, stage), key, &self.preparer.cache) {
            (Err(ServeError::Fill { .. }), Some(key), Some(cache)) => {
                cache.remove(&key);
                let prepared = self
                    .preparer
                    .prepare(map, true)
                    .map_err(|refusal| anyhow::anyhow!("map {name}: {}", refusal.reason()))?;
                let status = self.fill(&name, &prepared, stage)?;
                return Ok(Kept { archive: prepared, status });
            }
            (status, ..) => status?,
        };
        Ok(Kept { archive: prepared, status })
    }

    fn began(&mut self, map: MapSettings, kept: Kept) {
        let name = map.name;
        self.board.map(&name, |state| {
            state.source = map.source;
            state.watched = map.watch;
        });
        let entry = MapEntry { served: None, staged: None, reloads: 0, before: VecDeque::new() };
        self.entries.insert(name.clone(), entry);
        self.now_served(&name, kept, false);
    }

    /// Says what is served of a map.
    pub(super) fn say_served(&self, map: &str) {
        let Some(kept) = self.entries.get(map).and_then(|entry| entry.served.as_ref()) else {
            return;
        };
        let GenerationStatus { generation, bytes, from_cache, .. } = kept.status;
        let from = if from_cache { ", from the cache" } else { "" };
        tracing::info!(
            map,
            generation,
            bytes,
            from_cache,
            content = %kept.status.content_hash,
            "serving {map}, generation {generation}, {bytes} bytes{from}"
        );
    }

    /// Notes that a map's file yields no map, and what was served last is served instead.
    pub(super) fn fell_back(&mut self, map: &str, reason: &str) {
        let generation = self.entries.get(map).and_then(|entry| entry.served.as_ref());
        let report = ReloadReport {
            trigger: Trigger::Start,
            result: ReloadResult::Failed,
            generation: generation.map(|kept| kept.status.generation),
            reason: reason.to_owned(),
            at_unix_ns: unix_ns(),
            seconds: 0.0,
        };
        self.board.map(map, |state| {
            state.failed += 1;
            state.last_reload = Some(report);
        });
    }

    /// Copies an archive into shared memory, proves it there, and sends or stages it.
    pub(super) fn fill(
        &mut self,
        map: &str,
        archive: &Prepared,
        stage: bool,
    ) -> Result<GenerationStatus, ServeError> {
        let length = usize::try_from(archive.length).unwrap_or(usize::MAX);
        let mut counts = MapCounts::default();
        let mut hashes = ([0; 32], [0; 32]);
        let fill = |loan: &mut [u8]| -> Result<PublishMeta, Box<dyn Error + Send + Sync>> {
            archive.file.read_exact_at(loan, 0)?;
            archive.prove_signature(self.preparer.trust.as_ref(), loan)?;
            let proved = verify(loan)?;
            if proved.header != archive.header {
                return Err(CHANGED.into());
            }
            if let Some(policy) = &archive.policy {
                left_out::judge(&proved, policy)?;
            }
            // Where it was compiled just now, the compiler has told.
            if archive.from_cache || archive.policy.is_some() {
                left_out::tell(map, &proved);
            }
            // It is served all the same: its tables may be of use to clients of other releases.
            for unknown in mapd_archive::unknown(loan)? {
                tracing::warn!(map, "{unknown}");
            }
            counts = counts_of(&proved);
            hashes = (proved.header.content_hash, proved.header.provenance.input_hash);
            let mut layout_id = [0; 32];
            layout_id[..LAYOUT_ID.len()].copy_from_slice(&LAYOUT_ID);
            Ok(PublishMeta { layout_id, content_hash: hashes.0, input_hash: hashes.1 })
        };
        let generation = match stage {
            true => self.server.stage(map, length, fill),
            false => {
                let read = |bytes: &mut [u8]| read_file(archive, bytes);
                let Next { bytes, unplaced } = self.overlays.for_next(map, archive, read)?;
                let published = self.server.publish_under(map, length, fill, bytes.as_ref());
                published.inspect(|_| self.overlays.took(map, unplaced))
            }
        }?;
        Ok(GenerationStatus {
            generation,
            bytes: archive.length,
            published_unix_ns: unix_ns(),
            content_hash: hex(&hashes.0),
            input_hash: hex(&hashes.1),
            from_cache: archive.from_cache,
            counts,
        })
    }

    /// Serves what is staged, with what is laid over it: resolved against the bytes that wait, whatever has become of their file. Its generation.
    ///
    /// Errors: as [`Server::activate_under`]; the bytes cannot be read.
    pub(super) fn activate_staged(
        &mut self,
        map: &str,
        archive: &Prepared,
    ) -> Result<u64, ServeError> {
        let read = |bytes: &mut [u8]| self.server.read_staged(map, bytes);
        let Next { bytes, unplaced } = self.overlays.for_next(map, archive, read)?;
        let activated = self.server.activate_under(map, bytes.as_ref());
        activated.inspect(|_| self.overlays.took(map, unplaced))
    }

    /// Notes that a generation is served now. `back`: it was served before, and what comes after it is forgotten.
    pub(super) fn now_served(&mut self, map: &str, kept: Kept, back: bool) {
        let Some(entry) = self.entries.get_mut(map) else { return };
        // A lower number can never be activated.
        entry.staged = None;
        let before = entry.served.replace(kept.clone());
        if back {
            entry.before.pop_back();
        } else if let Some(before) = before.filter(|before| before.archive.is_on_disk) {
            entry.before.push_back(before);
            if entry.before.len() > ROLLBACKS {
                entry.before.pop_front();
            }
        }
        let rollbacks = entry.before.len();
        self.preparer.note_served(&self.domain, map, &kept.archive);
        self.board.map(map, |state| {
            state.served = Some(kept.status);
            state.staged = None;
            // These bytes were proved when they were filled in; what a scrub has found is about others.
            state.scrubs.last_failed = None;
            state.rollbacks = rollbacks;
            state.published += 1;
        });
        self.tell_overlay(map);
    }

    /// Looks what readers hold.
    pub(super) fn look(&mut self) {
        let held = self.server.look_who_holds();
        for map in self.server.maps() {
            self.board.map(&map.name, |state| {
                state.held = held.iter().filter(|held| held.map == map.name).cloned().collect();
            });
        }
    }
}

fn counts_of(archive: &Archive<'_>) -> MapCounts {
    let tables = &archive.tables;
    let count = |length: usize| length as u64;
    MapCounts {
        roads: count(tables.roads.len()),
        junctions: count(tables.junctions.len()),
        lanes: count(tables.lanes.iter().filter(|lane| lane.number() != 0).count()),
        signals: count(tables.signals.len()),
        objects: count(tables.objects.len()),
        quarantined: count(tables.quarantined.len()),
    }
}
