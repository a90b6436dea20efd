//! What an operator may want to know while the server runs.

use std::fmt;
use std::path::PathBuf;

/// Something that happened and did not stop the server.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Notice {
    /// A process that attaches, or another daemon, holds the attach lock for longer than any that runs would. The server
    /// goes on without cleaning up.
    LockHeld {
        /// The lock file.
        lock: PathBuf,
    },
    /// A file that a killed process left unfinished was removed.
    Removed {
        /// The file.
        file: PathBuf,
    },
    /// Killed processes were cleaned up after.
    CleanedUp {
        /// How many.
        nodes: u64,
    },
    /// Killed processes could not be cleaned up after; it is tried again.
    CleanUpFailed {
        /// How many.
        nodes: u64,
    },
    /// A client could not be connected; it is tried again.
    Unconnected {
        /// The map.
        map: String,
        /// What iceoryx2 says.
        error: String,
    },
    /// Something of no consequence for readers failed.
    Failed {
        /// What was tried.
        what: String,
        /// Why it failed.
        error: String,
    },
}

impl fmt::Display for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LockHeld { lock } => {
                write!(
                    f,
                    "{} stays locked; is a process of the domain stopped? Going on without cleaning up",
                    lock.display()
                )
            }
            Self::Removed { file } => {
                write!(f, "removed {}, left unfinished by a killed process", file.display())
            }
            Self::CleanedUp { nodes } => write!(f, "cleaned up after {nodes} killed process(es)"),
            Self::CleanUpFailed { nodes } => {
                write!(f, "could not clean up after {nodes} killed process(es) yet")
            }
            Self::Unconnected { map, error } => {
                write!(f, "map {map:?}: a client could not be connected yet: {error}")
            }
            Self::Failed { what, error } => write!(f, "{what}: {error}"),
        }
    }
}
