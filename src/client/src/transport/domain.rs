//! Where daemon and clients meet.

use iceoryx2::prelude::{Config, FileName, Path as IoxPath, SemanticString};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Environment variable that replaces the default prefix.
const PREFIX_VARIABLE: &str = "MAPD_PREFIX";
/// Prefix of everything in shared memory.
const DEFAULT_PREFIX: &str = "mapd_";
/// Where POSIX shared memory lies on Linux; also where containers meet that share it.
const SHARED_MEMORY: &str = "/dev/shm";
/// Longest prefix in bytes.
const MAX_PREFIX: usize = 32;

/// A prefix in shared memory: daemons and clients see each other where it is equal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Domain {
    prefix: String,
    root: PathBuf,
}

/// A prefix that cannot be used.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("a prefix has 1 to 32 letters, digits and underscores, found {found:?}")]
pub struct DomainError {
    found: String,
}

impl Domain {
    /// The domain of a prefix. The root folder is derived from it and lies in shared memory.
    ///
    /// Errors: characters other than letters, digits and underscores, or too many.
    pub fn new(prefix: &str) -> Result<Self, DomainError> {
        let fits = |c: char| c.is_ascii_alphanumeric() || c == '_';
        if prefix.is_empty() || prefix.len() > MAX_PREFIX || !prefix.chars().all(fits) {
            return Err(DomainError { found: prefix.to_owned() });
        }
        Ok(Self {
            prefix: prefix.to_owned(),
            root: Path::new(SHARED_MEMORY).join(format!("{prefix}root")),
        })
    }

    /// The domain that `MAPD_PREFIX` names, else the default one (`mapd_`).
    ///
    /// Errors: as [`Domain::new`].
    pub fn from_env() -> Result<Self, DomainError> {
        match std::env::var(PREFIX_VARIABLE) {
            Ok(prefix) => Self::new(&prefix),
            Err(_) => Self::new(DEFAULT_PREFIX),
        }
    }

    /// Prefix of everything in shared memory.
    pub fn prefix(&self) -> &str {
        &self.prefix
    }

    /// Folder with iceoryx2's files and mapd's locks.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Folder of shared memory segments.
    pub fn shared_memory(&self) -> &Path {
        Path::new(SHARED_MEMORY)
    }

    /// iceoryx2's configuration, given whole: nothing is read from files. Dead nodes are never cleaned up by the way;
    /// the daemon does that where it is safe.
    pub fn config(&self) -> Option<Config> {
        let mut config = Config::default();
        config.global.prefix = FileName::new(self.prefix.as_bytes()).ok()?;
        config.global.set_root_path(&IoxPath::new(self.root.to_str()?.as_bytes()).ok()?);
        config.global.node.cleanup_dead_nodes_on_creation = false;
        config.global.node.cleanup_dead_nodes_on_destruction = false;
        config.global.service.cleanup_dead_nodes_on_open = false;
        Some(config)
    }
}
