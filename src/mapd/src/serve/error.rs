//! Why a map cannot be served.

use mapd_client::AttachError;
use std::error::Error as StdError;
use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// Why a map cannot be served.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ServeError {
    /// Another daemon serves a map of this name.
    #[error(
        "a map named {name:?} is served already by process {pid}; stop that one or give another --name"
    )]
    AlreadyServed {
        /// Name of the map.
        name: String,
        /// Who serves it.
        pid: String,
    },
    /// Shared memory or the memory's limit leaves too little room.
    #[error(
        "map {name:?} needs {needed} bytes of shared memory, {available} are free ({limit}); free some or raise the limit"
    )]
    NoRoom {
        /// Name of the map.
        name: String,
        /// Bytes needed.
        needed: u64,
        /// Bytes free.
        available: u64,
        /// What limits them.
        limit: &'static str,
    },
    /// A file of the root folder fails.
    #[error("{}: {error}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// The archive could not be written into its place, or does not prove there.
    #[error("map {name:?} could not be published: {error}")]
    Fill {
        /// Name of the map.
        name: String,
        /// Why.
        error: Box<dyn StdError + Send + Sync>,
    },
    /// The name cannot be one of a map.
    #[error(transparent)]
    Name(#[from] AttachError),
    /// iceoryx2 refuses.
    #[error("iceoryx2 0.10.0 refuses to {action}: {reason}")]
    Iceoryx2 {
        /// What was tried.
        action: &'static str,
        /// What it says.
        reason: String,
    },
}

/// An iceoryx2 error with what was tried.
pub(super) fn refused(action: &'static str) -> impl Fn(&dyn std::fmt::Debug) -> ServeError {
    move |error| ServeError::Iceoryx2 { action, reason: format!("{error:?}") }
}
