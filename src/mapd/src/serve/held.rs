//! Generations that are not served any more, and whose memory readers still hold.

use super::error::ServeError;
use super::lease::is_held;
use super::served_map::MapPorts;
use super::server::Server;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::fs::File;
use std::os::unix::fs::MetadataExt;

/// Unit of [`MetadataExt::blocks`] \[bytes\].
const BLOCK: u64 = 512;

/// Generations of one map that are looked after at a time: each costs a descriptor.
pub(super) const MOST: usize = 64;

/// A generation that is not served any more, and that readers hold.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct HeldGeneration {
    /// Its map.
    pub map: String,
    /// Its number.
    pub generation: u64,
    /// Shared memory that it takes \[bytes\].
    pub bytes: u64,
}

impl fmt::Display for HeldGeneration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "generation {} of map {} ({} bytes)", self.generation, self.map, self.bytes)
    }
}

/// Such generations, as the end of a message.
#[derive(Debug, Default)]
pub struct HeldGenerations(pub Vec<HeldGeneration>);

impl fmt::Display for HeldGenerations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, held) in self.0.iter().enumerate() {
            write!(f, "{} {held}", if i == 0 { "; readers still hold" } else { "," })?;
        }
        Ok(())
    }
}

/// A segment whose publisher is gone, kept open to learn whether a process maps it. Its memory is freed when this is dropped and
/// no process maps it any more.
pub(super) struct Dropped {
    file: File,
    pub(super) generation: u64,
}

impl Dropped {
    /// `file` is opened read-only.
    pub(super) fn new(file: File, generation: u64) -> Self {
        Self { file, generation }
    }

    /// Whether a process maps it.
    pub(super) fn is_held(&self) -> bool {
        is_held(&self.file)
    }

    /// Memory that it takes \[bytes\].
    pub(super) fn bytes(&self) -> u64 {
        self.file.metadata().map_or(0, |metadata| metadata.blocks().saturating_mul(BLOCK))
    }
}

impl Server {
    /// Releases the memory of generations that have no readers any more.
    pub(super) fn let_go(&self) {
        self.maps.values().for_each(MapPorts::let_go);
    }

    /// As [`Server::held`], as of now.
    pub fn look_who_holds(&self) -> Vec<HeldGeneration> {
        self.let_go();
        self.held()
    }

    /// Generations that are not served any more, and that readers hold: as when last looked, about a second ago at most.
    pub fn held(&self) -> Vec<HeldGeneration> {
        self.maps.iter().flat_map(|(name, ports)| ports.held(name)).collect()
    }

    /// The same error; one for too little memory with what readers hold of it.
    pub(super) fn naming_held(&self, mut error: ServeError) -> ServeError {
        if let ServeError::NotEnoughMemory { held, .. } = &mut error {
            held.0 = self.held();
        }
        error
    }
}
