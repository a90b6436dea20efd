//! iceoryx2, configured without any file and without side effects on the process.

use crate::domain::Domain;
use crate::error::AttachError;
use crate::limits::MAX_PINNED;
use iceoryx2::prelude::{
    Config, FileName, LogLevel, Path, SemanticString, ipc_threadsafe, set_log_level,
};
use std::sync::Once;
use std::time::Duration;

/// The variant of iceoryx2 that both sides use: ports may be shared between threads.
pub type TransportService = ipc_threadsafe::Service;

/// How long iceoryx2 itself waits for an entity that another process is creating. Creation happens under the attach lock,
/// so that a living process is never met halfway; this only bounds the wait for a dead one.
const CREATION_TIMEOUT: Duration = Duration::from_millis(100);

/// The configuration of both sides: the domain's prefix and root, and no clean-up of dead nodes by iceoryx2 itself. A
/// client that cleaned up while the daemon is dead would remove the archive; the daemon cleans up under the attach lock.
///
/// Errors: the domain's names are refused by iceoryx2.
pub fn iceoryx2_config(domain: &Domain) -> Result<Config, AttachError> {
    let root = domain.root().as_os_str().as_encoded_bytes();
    let mut config = Config::default();
    config.global.prefix =
        FileName::new(domain.prefix().as_bytes()).map_err(AttachError::iceoryx)?;
    config.global.set_root_path(&Path::new(root).map_err(AttachError::iceoryx)?);
    config.global.creation_timeout = CREATION_TIMEOUT;
    config.global.node.cleanup_dead_nodes_on_creation = false;
    config.global.node.cleanup_dead_nodes_on_destruction = false;
    config.global.service.cleanup_dead_nodes_on_open = false;
    config.defaults.publish_subscribe.subscriber_expired_connection_buffer = MAX_PINNED;
    Ok(config)
}

/// Silences iceoryx2's own output, once per process.
pub fn silence_iceoryx2() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| set_log_level(LogLevel::Fatal));
}
