//! Whether shared memory has room for what a client or a daemon makes besides the maps. iceoryx2 reserves no pages for its
//! own segments: where there is no room, whoever writes into a new one is killed by a signal.

use super::domain::SHARED_MEMORY_FOLDER;
use super::error::AttachError;

/// Room that a client must find before it makes anything \[bytes\]. It takes about 16 KiB; the rest is for others who
/// attach at the same moment.
pub const ATTACH_ROOM: u64 = 256 << 10;

/// Bytes that are free in shared memory; `None` if the system does not say.
pub fn free_bytes() -> Option<u64> {
    let fs = rustix::fs::statvfs(SHARED_MEMORY_FOLDER).ok()?;
    Some(fs.f_bavail.saturating_mul(fs.f_frsize))
}

/// Checks that there is [`ATTACH_ROOM`].
///
/// Errors: [`AttachError::NoRoom`].
pub(crate) fn check_room() -> Result<(), AttachError> {
    match free_bytes() {
        Some(available) if available < ATTACH_ROOM => Err(AttachError::NoRoom { available }),
        _ => Ok(()),
    }
}
