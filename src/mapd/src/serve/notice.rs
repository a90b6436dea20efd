//! What an operator may want to know while the server runs.

use mapd_transport::ForeignFile;
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
    /// Another user has put something there as if it were the domain's. It is no part of the domain. Told once.
    Foreign {
        /// What, and whose it is.
        file: ForeignFile,
    },
    /// There is more of that than is told of. Told once.
    MoreForeign {
        /// How much there is in all.
        count: usize,
    },
    /// Another user holds a name that subscribers need: the server serves observers alone.
    WithoutSubscribers {
        /// What has the name, and whose it is.
        file: ForeignFile,
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
            Self::Foreign { file } => write!(f, "{file}: not of this domain, ignored"),
            Self::MoreForeign { count } => {
                write!(
                    f,
                    "{count} files of other users are named as if they were of this domain: ignored"
                )
            }
            Self::WithoutSubscribers { file } => write!(
                f,
                "without subscribers, who need that name: {file}; observers are served; for subscribers, have it removed and start the daemon again"
            ),
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
