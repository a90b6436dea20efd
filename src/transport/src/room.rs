//! Whether shared memory has room for the files that a client or a daemon creates besides the maps, and whether the process has
//! file descriptors left. iceoryx2 reserves no pages for its own segments: if shared memory is full, a process that writes to a new one is
//! killed by a signal.

use crate::domain::SHARED_MEMORY_FOLDER;

/// Room that a client must find before it makes anything \[bytes\]. It takes about 16 KiB; the rest is for others who
/// attach at the same moment.
pub const ATTACH_ROOM: u64 = 256 << 10;

/// Free bytes of shared memory; `None` if the system does not tell.
pub fn free_bytes() -> Option<u64> {
    let fs = rustix::fs::statvfs(SHARED_MEMORY_FOLDER).ok()?;
    Some(fs.f_bavail.saturating_mul(fs.f_frsize))
}

/// File descriptors that a process must have left to attach, or to make what serves one map.
pub const ATTACH_DESCRIPTORS: u64 = 24;

/// File descriptors of a process.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Descriptors {
    /// How many it may still open.
    pub left: u64,
    /// How many it may have open.
    pub limit: u64,
}

/// File descriptors of this process; `None` if there is no limit or the system does not tell.
pub fn descriptors() -> Option<Descriptors> {
    let limit = rustix::process::getrlimit(rustix::process::Resource::Nofile).current?;
    let used = match std::fs::read_dir("/proc/self/fd") {
        // One of them reads the folder.
        Ok(entries) => (entries.count() as u64).saturating_sub(1),
        Err(error) if error.raw_os_error() == Some(rustix::io::Errno::MFILE.raw_os_error()) => {
            limit
        }
        Err(_) => return None,
    };
    Some(Descriptors { left: limit.saturating_sub(used), limit })
}
