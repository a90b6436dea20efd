//! Why a client cannot attach to a map.

use crate::domain::DomainError;
use crate::domain::SHARED_MEMORY_FOLDER;
use crate::limits::{MAX_MAP_NAME_LENGTH, MAX_PINNED, MAX_SUBSCRIBERS, TRANSPORT_REVISION};
use crate::room::{ATTACH_DESCRIPTORS, ATTACH_ROOM};
use std::path::PathBuf;
use thiserror::Error;

/// Why a client cannot attach to a map or get a generation.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum AttachError {
    /// The domain's prefix cannot be used.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The map's name cannot be used.
    #[error(
        "expected a map name of 1 to {MAX_MAP_NAME_LENGTH} ASCII letters, digits, '.', '_' or '-' that begins with a letter, \
         digit or '_'; found {map:?}; give the map another name with --name"
    )]
    MapName {
        /// The name.
        map: String,
    },
    /// No daemon serves anything in this domain.
    #[error("map {map:?}: no daemon is running in {}; start one with `mapd --load FILE`", root.display())]
    NoDaemon {
        /// The map.
        map: String,
        /// The domain's root folder.
        root: PathBuf,
    },
    /// Daemons are running, but none serves this map.
    #[error("map {map:?} is not served; served are {}; check the name or load the map", available.join(", "))]
    NoSuchMap {
        /// The map.
        map: String,
        /// Maps that are served now.
        available: Vec<String>,
    },
    /// The map exists, but no (newer) generation came before the deadline.
    #[error(
        "map {map:?}: no generation newer than {newer_than} came in time; {}",
        if *daemon_alive { "the daemon is running: wait longer" } else { "the daemon has ended: start it again" }
    )]
    NoGeneration {
        /// The map.
        map: String,
        /// The client waited for a generation newer than this; 0 for any.
        newer_than: u64,
        /// Whether a daemon serves the map now.
        daemon_alive: bool,
    },
    /// The generation with the requested number is no longer served.
    #[error(
        "map {map:?}: generation {wanted} was wanted, generation {newest} is served already; ask for that one, or for the newest"
    )]
    Superseded {
        /// The map.
        map: String,
        /// The requested generation.
        wanted: u64,
        /// The newest generation.
        newest: u64,
    },
    /// The daemon uses another revision of the transport or another version of iceoryx2.
    #[error(
        "map {map:?}: expected transport revision {TRANSPORT_REVISION}, found {found}; use daemon and client of one release"
    )]
    WrongTransport {
        /// The map.
        map: String,
        /// The daemon's revision.
        found: String,
    },
    /// The map has no free slot for a subscriber.
    #[error(
        "map {map:?} already has {MAX_SUBSCRIBERS} subscriptions; end one, or share a subscription within a process"
    )]
    TooManySubscribers {
        /// The map.
        map: String,
    },
    /// This subscription already holds the largest number of generations.
    #[error("map {map:?}: {MAX_PINNED} generations are already held; drop old ones")]
    TooManyPinned {
        /// The map.
        map: String,
    },
    /// The files belong to a user that is not trusted.
    #[error(
        "{} belongs to user {owner}, trusted is user {trusted}; run daemon and clients as one user, or name the daemon's with --owner or MAPD_OWNER; \
         if that user has nothing to do with mapd, remove it, or take another prefix",
        path.display()
    )]
    PermissionDenied {
        /// What cannot be used.
        path: PathBuf,
        /// User id of its owner.
        owner: u32,
        /// User id of the trusted user: this process's own unless another one was named.
        trusted: u32,
    },
    /// The daemon is another user's, which was named as the owner: subscribers write, and so must be its user's own.
    #[error(
        "{} belongs to user {owner}, who alone may subscribe; attach as an observer, which is the default, or run as that user",
        path.display()
    )]
    OnlyObservers {
        /// The root folder.
        path: PathBuf,
        /// User id of its owner.
        owner: u32,
    },
    /// The daemon that serves the map serves observers alone.
    #[error(
        "map {map:?}: its daemon has no subscribers, because another user holds a name that they need (`mapd status` says which); attach as an observer, \
         which is the default"
    )]
    NoSubscribers {
        /// The map.
        map: String,
    },
    /// The files belong to a user that is not mapped into this user namespace.
    #[error(
        "{} belongs to a user that has no id in this user namespace, so that it may be anybody's; map the daemon's user into it, or hand over a signed file",
        path.display()
    )]
    UnknownOwner {
        /// What cannot be used.
        path: PathBuf,
    },
    /// The daemon's user is trusted but does not share the map.
    #[error(
        "this process may not read {}: the daemon shares with nobody, or with a group that this process is not in; start it with --share group:NAME",
        path.display()
    )]
    NotShared {
        /// What cannot be read.
        path: PathBuf,
    },
    /// A file that a killed process left unfinished is in the way until a daemon removes it.
    #[error("{} was left unfinished by a process that was killed; a running daemon removes it within seconds, else start one", file.display())]
    Stuck {
        /// The file.
        file: PathBuf,
    },
    /// A daemon did not release the attach lock in time.
    #[error("{} stayed locked until the deadline; wait longer, or end the daemon that is stopped", lock.display())]
    Busy {
        /// The lock file.
        lock: PathBuf,
    },
    /// The process locks what it maps (`mlockall(MCL_FUTURE)`), and its limit on locked memory is too low.
    #[error(
        "{} needs {needed} bytes of locked memory, because this process locks all that it maps; raise the limit (`ulimit -l`, LimitMEMLOCK=), \
         or attach before mlockall",
        path.display()
    )]
    LockLimit {
        /// The file.
        path: PathBuf,
        /// Its bytes.
        needed: u64,
    },
    /// Shared memory is full.
    #[error(
        "attaching needs {ATTACH_ROOM} bytes of shared memory, {available} are left by {SHARED_MEMORY_FOLDER}; free some, or enlarge it \
         (`mount -o remount,size=…`, for containers `--shm-size`)"
    )]
    NoRoom {
        /// Bytes that are left.
        available: u64,
    },
    /// This process may open no more files.
    #[error(
        "attaching needs up to {ATTACH_DESCRIPTORS} file descriptors, {left} of {limit} are left to this process; close some, or raise the limit \
         (`ulimit -n`, LimitNOFILE=)"
    )]
    NoDescriptors {
        /// File descriptors that are left.
        left: u64,
        /// The process's limit.
        limit: u64,
    },
    /// The record of a map, or the segment that it names, is not one that a daemon writes.
    #[error("{}: {why}; start the daemon again, and find out who writes there", path.display())]
    Record {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        why: String,
    },
    /// The bytes are an archive, but not the one that was announced.
    #[error(
        "map {map:?}: the archive in shared memory has another content than its daemon announced; start the daemon again"
    )]
    OtherContent {
        /// The map.
        map: String,
    },
    /// A file of the domain cannot be used.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// The system's error.
        source: std::io::Error,
    },
    /// iceoryx2 refused something that should work.
    #[error(
        "shared memory: {0}; if it stays, stop every process of the domain and start the daemon again"
    )]
    Iceoryx(String),
}

impl AttachError {
    pub(crate) fn io(path: impl Into<PathBuf>, source: std::io::Error) -> Self {
        Self::Io { path: path.into(), source }
    }

    /// Whether trying again may help: not for wrong names, users and versions.
    pub(crate) fn may_pass(&self) -> bool {
        !matches!(
            self,
            Self::Domain(_)
                | Self::MapName { .. }
                | Self::WrongTransport { .. }
                | Self::PermissionDenied { .. }
                | Self::OnlyObservers { .. }
                | Self::UnknownOwner { .. }
                | Self::LockLimit { .. }
                | Self::TooManyPinned { .. }
                | Self::Superseded { .. }
                | Self::OtherContent { .. }
        )
    }
}
