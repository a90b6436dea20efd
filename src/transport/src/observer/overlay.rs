//! The reader's side of overlays: which one the record names with a generation, and where its bytes are.

use super::memory::{Refusal, map_segment};
use super::reader::{LOOK, Observer, READINGS, read, refused, sleep_on};
use super::slot::{OverlayLocation, SlotContent};
use crate::domain::Domain;
use crate::error::AttachError;
use crate::mapping::Mapping;
use std::fmt;
use std::io;
use std::path::PathBuf;
use std::sync::PoisonError;
use std::sync::atomic::Ordering;
use std::time::Instant;

/// Suffix of the files of a map's overlays; their revisions follow.
const SUFFIX: &str = ".overlay-";

/// The file of a revision of a map's overlay.
pub fn overlay_file(domain: &Domain, map: &str, revision: u64) -> PathBuf {
    domain.map_file(map, &format!("{SUFFIX}{revision}"))
}

/// What is laid over a generation.
#[derive(Debug)]
pub enum OverlayState {
    /// What was known already.
    Known,
    /// Nothing.
    Nothing,
    /// Something else than was known.
    New(PinnedOverlay),
    /// The record is about another generation, or names an overlay that is gone: its daemon was killed, and the next one has not published yet.
    Other,
}

/// An overlay's bytes, mapped read-only.
pub struct PinnedOverlay {
    mapping: Mapping,
    place: OverlayLocation,
}

impl PinnedOverlay {
    /// The bytes as published.
    pub fn bytes(&self) -> &[u8] {
        self.mapping.bytes()
    }

    /// Its revision.
    pub fn revision(&self) -> u64 {
        self.place.revision
    }

    /// Hash of its content, as announced.
    pub fn content_hash(&self) -> [u8; 32] {
        self.place.content_hash
    }
}

impl Observer {
    /// Whether the record has not changed since [`Observer::laid_over`] was last asked: one atomic load.
    pub fn is_unchanged(&self) -> bool {
        let looked = self.looked.load(Ordering::Relaxed);
        let mapped = self.record.lock().unwrap_or_else(PoisonError::into_inner);
        let sequence = |record: &std::sync::Arc<super::memory::Record>| {
            record.page().sequence.load(Ordering::Acquire)
        };
        looked != 0 && mapped.as_ref().is_some_and(|record| sequence(record) == looked)
    }

    /// What is laid over a generation now; `known` is the revision that is known, 0 for none.
    ///
    /// Errors: files of the domain cannot be used.
    pub fn laid_over(&self, generation: u64, known: u64) -> Result<OverlayState, AttachError> {
        let mut gone = 0;
        for _ in 0..READINGS {
            let record = match self.record() {
                Err(AttachError::Io { source, .. }) if source.kind() == io::ErrorKind::NotFound => {
                    // No daemon serves the map any more: the last known state remains.
                    return Ok(OverlayState::Known);
                }
                record => record?,
            };
            let (sequence, said) = read(&record, &self.domain, &self.map, &self.path)?;
            let SlotContent::Served(info, place) = &*said else { return Ok(OverlayState::Known) };
            if info.generation != generation {
                return Ok(OverlayState::Other);
            }
            let laid = match place.overlay {
                None if known == 0 => OverlayState::Known,
                None => OverlayState::Nothing,
                Some(overlay) if overlay.revision == known => OverlayState::Known,
                Some(overlay) => match self.open_overlay(overlay)? {
                    Some(pinned) => OverlayState::New(pinned),
                    None if gone == sequence => OverlayState::Other,
                    // Another has taken its place, or none.
                    None => {
                        gone = sequence;
                        continue;
                    }
                },
            };
            self.looked.store(sequence, Ordering::Relaxed);
            return Ok(laid);
        }
        let why = "names overlays that are gone".to_owned();
        Err(AttachError::Record { path: self.path.clone(), why })
    }

    fn open_overlay(&self, place: OverlayLocation) -> Result<Option<PinnedOverlay>, AttachError> {
        let path = overlay_file(&self.domain, &self.map, place.revision);
        match map_segment(&path, place.inode, place.length, self.owner) {
            Ok(mapping) => Ok(Some(PinnedOverlay { mapping, place })),
            Err(Refusal::Io(error)) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(refusal) => Err(refused(&path, refusal, self.owner)),
        }
    }

    /// Sleeps until the record changes, or for a moment, or until the deadline.
    pub fn sleep(&self, deadline: Instant) {
        let left = deadline.saturating_duration_since(Instant::now()).min(LOOK);
        match self.record() {
            Ok(record) => sleep_on(record.page(), self.looked.load(Ordering::Relaxed), left),
            Err(_) => std::thread::sleep(left),
        }
    }
}

impl fmt::Debug for PinnedOverlay {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PinnedOverlay").field("place", &self.place).finish_non_exhaustive()
    }
}
