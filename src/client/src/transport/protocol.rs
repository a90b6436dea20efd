//! What daemon and clients agree on: types, names and limits of the services.
//!
//! Limits are frozen while any process has a service open; whoever changes one raises [`TRANSPORT_REVISION`].

use crate::transport::error::AttachError;
use iceoryx2::prelude::*;

/// Part of every service's name: other limits or types get other services.
pub const TRANSPORT_REVISION: u32 = 1;
/// Clients that one map serves at a time. Each costs the daemon some kilobytes.
pub const MAX_SUBSCRIBERS: usize = 64;
/// Processes that may have one service open: clients, daemons, `mapd status`.
pub const MAX_NODES: usize = 96;
/// Publishers of one map: the served generation, the next one, and one of a daemon that was killed.
pub const MAX_PUBLISHERS: usize = 3;
/// Processes that may wait for events of one map.
pub const MAX_LISTENERS: usize = MAX_SUBSCRIBERS;
/// Longest map name in bytes.
pub const MAX_NAME: usize = 64;

/// iceoryx2's service flavour: ports may move between threads.
pub type Ipc = ipc_threadsafe::Service;

/// Sixty-four bytes of an archive. Archives are published as slices of these, so that they start at a multiple of 64.
#[derive(Clone, Copy, Debug, ZeroCopySend)]
#[repr(C)]
#[repr(align(64))]
#[type_name("mapd::Chunk64")]
pub struct Chunk64(pub [u8; 64]);

/// What is known of a generation without reading it: the sample's user header.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ZeroCopySend)]
#[repr(C)]
#[type_name("mapd::GenerationInfo")]
pub struct GenerationInfo {
    /// Rises with every publication of the map, across restarts of the daemon too.
    pub generation: u64,
    /// Exact length of the archive in bytes.
    pub length: u64,
    /// When it was published: nanoseconds since 1970, UTC.
    pub published_unix_ns: u64,
    /// Process id of the daemon.
    pub daemon_pid: u64,
    /// Layout id of the archive, padded with zeros.
    pub layout_id: [u8; 32],
    /// BLAKE3 of the archive's body.
    pub content_hash: [u8; 32],
    /// BLAKE3 of the OpenDRIVE input.
    pub input_hash: [u8; 32],
}

/// One of a map's services.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// Publish-subscribe: the archive.
    Archive,
    /// Event to the daemon: a client has arrived.
    Wake,
    /// Event to clients: a generation was published.
    Changed,
}

/// Name of a map's service.
///
/// Errors: the map's name is empty, too long, or has characters other than letters, digits, `.`, `_`, `-`.
pub fn service_name(map: &str, channel: Channel) -> Result<ServiceName, AttachError> {
    let fits = |c: char| c.is_alphanumeric() || matches!(c, '.' | '_' | '-');
    if map.is_empty() || map.len() > MAX_NAME || map.starts_with('.') || !map.chars().all(fits) {
        return Err(AttachError::MapName { name: map.to_owned() });
    }
    let channel = match channel {
        Channel::Archive => "archive",
        Channel::Wake => "wake",
        Channel::Changed => "changed",
    };
    let name = format!("mapd/{TRANSPORT_REVISION}/{map}/{channel}");
    ServiceName::new(&name).map_err(|_| AttachError::MapName { name: map.to_owned() })
}
