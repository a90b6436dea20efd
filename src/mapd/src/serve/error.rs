//! Why a map cannot be served.

use super::held::HeldGenerations;
use mapd_transport::{ATTACH_DESCRIPTORS, AttachError, ClaimError};
use std::error::Error;
use std::path::PathBuf;
use thiserror::Error;

/// Why a map cannot be served.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ServeError {
    /// The domain, the map's name, or a file of the domain cannot be used.
    #[error(transparent)]
    Domain(#[from] AttachError),
    /// Another daemon serves a map of this name.
    #[error(transparent)]
    Claim(#[from] ClaimError),
    /// A daemon serves as its own user, and another one was named.
    #[error(
        "a daemon serves as its own user, which is {us}; --owner or MAPD_OWNER names user {named}: leave it out, or run the daemon as that user"
    )]
    NotItsOwner {
        /// Id of this process's user.
        us: u32,
        /// Id of the user that was named.
        named: u32,
    },
    /// The daemon's user cannot give files to the group it is to share with.
    #[error(
        "sharing with group {group}: this user is not in it; add the user to the group, or name one it is in (--share group:NAME)"
    )]
    NotInGroup {
        /// Id of the group.
        group: u32,
    },
    /// Another daemon shares the domain with another group.
    #[error(
        "the domain is shared with group {group} already, by another daemon; share with that group instead of {wanted}, or take another --prefix"
    )]
    SharedAlready {
        /// Id of its group.
        group: u32,
        /// Id of the group that was wanted.
        wanted: u32,
    },
    /// A map of no bytes cannot be published.
    #[error("map {map:?}: expected at least one byte, found none")]
    Empty {
        /// The map.
        map: String,
    },
    /// The map does not fit.
    #[error(
        "map {map:?} needs {needed} bytes of shared memory, {available} are left by {limit}; {hint}{held}"
    )]
    NotEnoughMemory {
        /// The map.
        map: String,
        /// Bytes that publishing needs.
        needed: u64,
        /// Bytes that are left.
        available: u64,
        /// What limits them.
        limit: &'static str,
        /// How to get more.
        hint: &'static str,
        /// What readers hold of it.
        held: HeldGenerations,
    },
    /// The map's pages cannot be locked.
    #[error(
        "map {map:?}: {needed} bytes cannot be locked in memory ({source}); the limit of locked memory is {limit}: raise it (ulimit -l, \
         LimitMEMLOCK=) to twice the largest map, or serve without --lock-memory"
    )]
    NotLocked {
        /// The map.
        map: String,
        /// Bytes to be locked.
        needed: u64,
        /// The limit of this process, in words.
        limit: String,
        /// What the system says.
        source: std::io::Error,
    },
    /// Shared memory has no room even for what serves a map.
    #[error(
        "serving needs {needed} bytes of shared memory besides the maps, {available} are left by {limit}; {hint}"
    )]
    NoRoom {
        /// Bytes that are needed.
        needed: u64,
        /// Bytes that are left.
        available: u64,
        /// What limits them.
        limit: &'static str,
        /// How to get more.
        hint: &'static str,
    },
    /// The daemon may open no more files.
    #[error(
        "serving a map needs {ATTACH_DESCRIPTORS} file descriptors at a time, {left} of {limit} are left to this process; raise the limit \
         (`ulimit -n`, LimitNOFILE=)"
    )]
    NoDescriptors {
        /// File descriptors that are left.
        left: u64,
        /// As many as the process may have.
        limit: u64,
    },
    /// There is nothing to activate.
    #[error(
        "map {map:?}: nothing is staged; stage a generation first with `mapd reload {map} --stage`"
    )]
    NothingStaged {
        /// The map.
        map: String,
    },
    /// Writing the bytes failed; nothing was published and the generation before, if any, is still served.
    #[error("map {map:?}: {source}")]
    Fill {
        /// The map.
        map: String,
        /// What the writer says.
        source: Box<dyn Error + Send + Sync>,
    },
    /// A killed process left files that cannot be removed while another process holds the attach lock.
    #[error(
        "{} was left unfinished by a killed process and cannot be removed while another process holds the attach lock; \
         continue or end the process that is stopped", file.display())]
    Wedged {
        /// The file.
        file: PathBuf,
    },
    /// A file of the domain cannot be used.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// Nothing keeps a generation's number from being handed out again.
    #[error(
        "generation {next} cannot be kept in {}: {error}; it is ahead of the clock, so nothing else keeps another map from getting the \
         same number: make room there, or set the clock", file.display())]
    NotKept {
        /// The number.
        next: u64,
        /// Where it is to be kept.
        file: PathBuf,
        /// What the system says.
        error: std::io::Error,
    },
    /// A process of another release has the map's service open, with limits that are too small for this one.
    #[error(
        "service {service:?} is open in a process that made it with other limits ({error}); end the clients of the other release, or serve \
         under another --prefix"
    )]
    OtherLimits {
        /// The service.
        service: String,
        /// Which limit, as iceoryx2 names it.
        error: String,
    },
    /// A process that uses another version of iceoryx2, or of the payload, has the map's service open.
    #[error(
        "service {service:?} is open in a process of another release ({error}); end the clients of the other release, or serve under \
         another --prefix"
    )]
    OtherRelease {
        /// The service.
        service: String,
        /// What differs, as iceoryx2 names it.
        error: String,
    },
    /// iceoryx2 refused something that should work.
    #[error(
        "shared memory: {what}: {error}; if it stays, stop every process of the domain and start the daemon again"
    )]
    Iceoryx {
        /// What was tried.
        what: &'static str,
        /// What iceoryx2 says.
        error: String,
    },
}

impl ServeError {
    pub(crate) fn iceoryx<E: std::fmt::Debug>(what: &'static str) -> impl FnOnce(E) -> Self {
        move |error| Self::Iceoryx { what, error: format!("{error:?}") }
    }

    pub(crate) fn io(path: impl Into<PathBuf>) -> impl FnOnce(std::io::Error) -> Self {
        let path = path.into();
        move |source| Self::Io { path, source }
    }
}
