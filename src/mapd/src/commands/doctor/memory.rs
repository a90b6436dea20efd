//! Room for maps, and what may take it away.

use super::finding::{Finding, size};
use crate::serve::{OVERHEAD, control_group_available, machine_available};
use mapd_transport::SHARED_MEMORY_FOLDER;

/// What the kernel calls a tmpfs (`linux/magic.h`, TMPFS_MAGIC).
const TMPFS: u64 = 0x0102_1994;

/// What container engines give `/dev/shm` unless told otherwise.
const CONTAINER_DEFAULT: u64 = 64 << 20;

/// Control groups of version 1 without a limit say a number near the largest one.
const NO_LIMIT: u64 = 1 << 60;

/// Everybody may make files in a folder.
const OTHERS_WRITE: u32 = 0o002;

/// Only their owners may remove them.
const STICKY: u32 = 0o1000;

/// Generations that are in memory while a map is replaced.
const LIVE_GENERATIONS: u64 = 2;

/// Examines room for an archive of so many bytes; 0 if none is named.
pub(super) fn examine(archive: u64, out: &mut Vec<Finding>) {
    let needed = archive.saturating_mul(LIVE_GENERATIONS).saturating_add(OVERHEAD);
    shared_memory(needed, out);
    for (check, room, advice) in [
        ("machine memory", machine_available(), "free some: pages of maps are memory"),
        (
            "control group",
            control_group_available(),
            "raise the limit of the container or service (memory.max, MemoryMax=, --memory)",
        ),
    ] {
        out.push(match room {
            None | Some(NO_LIMIT..) => Finding::ok(check, "no limit"),
            Some(room) if room < needed => Finding::problem(
                check,
                format!("{} left, {} needed", size(room), size(needed)),
                advice,
            ),
            Some(room) => Finding::ok(check, format!("{} left", size(room))),
        });
    }
    swap(out);
}

fn shared_memory(needed: u64, out: &mut Vec<Finding>) {
    let check = "shared memory";
    let (kind, room) =
        match (rustix::fs::statfs(SHARED_MEMORY_FOLDER), rustix::fs::statvfs(SHARED_MEMORY_FOLDER))
        {
            (Ok(kind), Ok(room)) => (kind, room),
            (Err(error), _) | (_, Err(error)) => {
                out.push(Finding::problem(
                check,
                format!("{SHARED_MEMORY_FOLDER}: {error}"),
                format!(
                    "mount a tmpfs there: mount -t tmpfs -o mode=1777 none {SHARED_MEMORY_FOLDER}"
                ),
            ));
                return;
            }
        };
    let (all, free) =
        (room.f_blocks.saturating_mul(room.f_frsize), room.f_bavail.saturating_mul(room.f_frsize));
    let found = format!("{SHARED_MEMORY_FOLDER}: {} free of {}", size(free), size(all));
    let enlarge = format!(
        "enlarge it: mount -o remount,size=… {SHARED_MEMORY_FOLDER}, for containers --shm-size"
    );
    if kind.f_type as u64 != TMPFS {
        out.push(Finding::problem(
            check,
            format!("{found}; not a tmpfs"),
            format!(
                "mount a tmpfs at {SHARED_MEMORY_FOLDER}: on a disk, attaching waits for writes"
            ),
        ));
    } else if free < needed {
        let found = format!("{found}, {} needed", size(needed));
        out.push(Finding::problem(check, found, enlarge));
    } else if all <= CONTAINER_DEFAULT {
        out.push(Finding::note(check, format!("{found}: a container's default"), enlarge));
    } else {
        out.push(Finding::ok(check, found));
    }
    // Names of the domain's files are its user's for as long as he likes only where no other user can remove them.
    if let Ok(folder) = rustix::fs::stat(SHARED_MEMORY_FOLDER)
        && folder.st_mode & (OTHERS_WRITE | STICKY) == OTHERS_WRITE
    {
        out.push(Finding::problem(
            check,
            format!("every user can remove files of others in {SHARED_MEMORY_FOLDER}"),
            format!("make it sticky: chmod 1777 {SHARED_MEMORY_FOLDER}"),
        ));
    }
    if rustix::fs::access(SHARED_MEMORY_FOLDER, rustix::fs::Access::WRITE_OK).is_err() {
        out.push(Finding::problem(
            check,
            format!("{SHARED_MEMORY_FOLDER} cannot be written by this user"),
            "mount it writable, mode 1777",
        ));
    }
}

/// Pages of a tmpfs may go to swap.
fn swap(out: &mut Vec<Finding>) {
    let Ok(text) = std::fs::read_to_string("/proc/swaps") else { return };
    let devices = text.lines().count().saturating_sub(1);
    out.push(match devices {
        0 => Finding::ok("swap", "none: pages of maps stay in memory"),
        _ => Finding::note(
            "swap",
            format!("{devices} device(s): pages of maps may go there"),
            "serve with --lock-memory, or switch swap off, where a query must never wait for a disk",
        ),
    });
}
