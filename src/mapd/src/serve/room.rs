//! Whether there is room for a map, asked before anything is created.

use super::error::ServeError;
use mapd_client::Domain;
use std::fs;
use std::path::PathBuf;

/// Kept free beside the archive: iceoryx2's own segments and other users of shared memory.
const HEADROOM: u64 = 8 << 20;

/// Refuses a map that does not fit.
pub(super) fn check(domain: &Domain, map: &str, length: usize) -> Result<(), ServeError> {
    let needed = length as u64 + HEADROOM;
    let refuse = |available: u64, limit| {
        Err(ServeError::NoRoom { name: map.to_owned(), needed, available, limit })
    };
    let folder = domain.shared_memory();
    let file_system = rustix::fs::statvfs(folder)
        .map_err(|error| ServeError::File { path: folder.to_owned(), error: error.into() })?;
    let free = file_system.f_bavail.saturating_mul(file_system.f_frsize);
    if free < needed {
        return refuse(free, "size of /dev/shm");
    }
    match cgroup_room() {
        Some(free) if free < needed => refuse(free, "memory limit of the control group"),
        _ => Ok(()),
    }
}

/// Bytes that the process's control group still allows, if it has a limit (cgroup v2).
fn cgroup_room() -> Option<u64> {
    let groups = fs::read_to_string("/proc/self/cgroup").ok()?;
    let own = groups.lines().find_map(|line| line.strip_prefix("0::/"))?;
    let mut folder = PathBuf::from("/sys/fs/cgroup").join(own);
    let mut room: Option<u64> = None;
    // Limits of all groups above hold too.
    loop {
        let read =
            |name: &str| fs::read_to_string(folder.join(name)).ok()?.trim().parse::<u64>().ok();
        if let (Some(limit), Some(used)) = (read("memory.max"), read("memory.current")) {
            let free = limit.saturating_sub(used);
            room = Some(room.map_or(free, |room| room.min(free)));
        }
        if !folder.starts_with("/sys/fs/cgroup/") || !folder.pop() {
            return room;
        }
    }
}
