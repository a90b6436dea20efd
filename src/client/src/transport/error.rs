//! Why a map cannot be attached to.

use super::domain::DomainError;
use std::path::PathBuf;
use thiserror::Error;

/// Why a map cannot be attached to.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum AttachError {
    /// The prefix cannot be used.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The name cannot be one of a map.
    #[error("a map's name has 1 to 64 letters, digits, '.', '_' or '-', found {name:?}")]
    MapName {
        /// The name.
        name: String,
    },
    /// No daemon has ever served in this domain.
    #[error("no daemon serves under {}; start `mapd --load FILE`, or check MAPD_PREFIX on both sides", root.display())]
    NoDaemon {
        /// The domain's root folder.
        root: PathBuf,
    },
    /// There is a domain, but not this map.
    #[error("no map named {name:?} is served; `mapd status` lists those that are")]
    NoSuchMap {
        /// Name that was asked for.
        name: String,
    },
    /// The map's service is there, but nothing newer came before the deadline.
    #[error(
        "map {name:?} has no generation newer than {than} before the deadline; is its daemon running? `mapd status` tells"
    )]
    NoGeneration {
        /// Name of the map.
        name: String,
        /// What the caller has.
        than: u64,
    },
    /// Someone else owns the domain.
    #[error("{} belongs to user {owner}, this process runs as user {user}; run daemon and clients as one user", root.display())]
    OtherUser {
        /// The domain's root folder.
        root: PathBuf,
        /// Its owner.
        owner: u32,
        /// This process's user.
        user: u32,
    },
    /// The map has as many clients as it may have.
    #[error("map {name:?} has its {limit} clients already; end one")]
    TooManyClients {
        /// Name of the map.
        name: String,
        /// How many it may have.
        limit: usize,
    },
    /// The lock that guards attaching is held by a daemon for too long.
    #[error("attaching waits for {}, which another process holds; is a daemon stopped?", lock.display())]
    Locked {
        /// The lock file.
        lock: PathBuf,
    },
    /// The sample is not what its header says.
    #[error("map {name:?} announces {announced} bytes, its sample has {found}; restart its daemon")]
    Sample {
        /// Name of the map.
        name: String,
        /// Length in the header.
        announced: u64,
        /// Bytes there are.
        found: u64,
    },
    /// iceoryx2 refuses; daemon and clients need the identical version of it.
    #[error("iceoryx2 0.10.0 refuses to {action}: {reason}")]
    Iceoryx2 {
        /// What was tried.
        action: &'static str,
        /// What it says.
        reason: String,
    },
}
