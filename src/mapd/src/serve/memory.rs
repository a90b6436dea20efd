//! Whether a map fits, asked before anything is created: shared memory that is written without being there kills the
//! writer with a signal, or makes the kernel kill another process.

use super::control_group;
use super::error::ServeError;
use super::held::HeldGenerations;
use mapd_transport::{
    ATTACH_DESCRIPTORS, ATTACH_ROOM, AttachError, ClaimError, Descriptors, SHARED_MEMORY_FOLDER,
    descriptors, free_bytes,
};
use std::fs;

/// What a publisher needs besides the payload: header, allocator state, queues to all subscribers, rounding to pages.
pub(crate) const OVERHEAD: u64 = 1 << 20;

/// Bytes that something leaves us.
struct Room {
    available: u64,
    limit: &'static str,
    hint: &'static str,
}

/// Checks that `length` bytes can be published.
///
/// Errors: [`ServeError::NotEnoughMemory`], naming the tightest limit. A limit that cannot be read is none.
pub(crate) fn check(map: &str, length: u64) -> Result<(), ServeError> {
    let needed = length.saturating_add(OVERHEAD);
    match tightest() {
        Some(Room { available, limit, hint }) if available < needed => {
            Err(ServeError::NotEnoughMemory {
                map: map.to_owned(),
                needed,
                available,
                limit,
                hint,
                held: HeldGenerations::default(),
            })
        }
        _ => Ok(()),
    }
}

/// Checks that nodes, services and queues can be made. Directly before they are: iceoryx2 reserves no pages for them.
///
/// Errors: [`ServeError::NoRoom`].
pub(crate) fn check_overhead() -> Result<(), ServeError> {
    match tightest() {
        Some(Room { available, limit, hint }) if available < OVERHEAD => {
            Err(ServeError::NoRoom { needed: OVERHEAD, available, limit, hint })
        }
        _ => Ok(()),
    }
}

/// Checks that `/dev/shm` has room for the queue of a newcomer. Only that: newcomers wait meanwhile, and control groups
/// take longer to ask than to greet.
///
/// Errors: [`ServeError::NoRoom`].
pub(crate) fn check_queue() -> Result<(), ServeError> {
    match file_system() {
        Some(Room { available, limit, hint }) if available < ATTACH_ROOM => {
            Err(ServeError::NoRoom { needed: ATTACH_ROOM, available, limit, hint })
        }
        _ => Ok(()),
    }
}

/// The same error, or what there is too little of, if there is: whatever failed, failed for that.
pub(crate) fn or_shortage(error: ServeError) -> ServeError {
    use ServeError as E;
    match error {
        E::Iceoryx { .. }
        | E::Io { .. }
        | E::Claim(ClaimError::Io { .. })
        | E::Domain(AttachError::Io { .. } | AttachError::Iceoryx(_)) => {
            check_overhead().and_then(|()| check_descriptors()).err().unwrap_or(error)
        }
        other => other,
    }
}

/// Checks that descriptors are left. Looks at each of them, so it is for callers that have failed already.
fn check_descriptors() -> Result<(), ServeError> {
    match descriptors() {
        Some(Descriptors { left, limit }) if left < ATTACH_DESCRIPTORS => {
            Err(ServeError::NoDescriptors { left, limit })
        }
        _ => Ok(()),
    }
}

/// Bytes of memory that the machine and the control groups leave; `None` if they do not say.
pub(crate) fn available() -> Option<u64> {
    [control_group(), machine()].into_iter().flatten().map(|room| room.available).min()
}

fn tightest() -> Option<Room> {
    let rooms = [file_system(), control_group(), machine()];
    rooms.into_iter().flatten().min_by_key(|room| room.available)
}

/// The kernel refused to provide the pages although [`check`] saw room: another process took it in between.
pub(crate) fn refused(map: &str, length: u64, error: &std::io::Error) -> ServeError {
    let limit = "the kernel";
    let available = file_system().map_or(0, |room| room.available);
    match error.kind() {
        std::io::ErrorKind::StorageFull | std::io::ErrorKind::OutOfMemory => {
            ServeError::NotEnoughMemory {
                map: map.to_owned(),
                needed: length.saturating_add(OVERHEAD),
                available,
                limit,
                hint: "free memory, or enlarge /dev/shm",
                held: HeldGenerations::default(),
            }
        }
        _ => ServeError::io(SHARED_MEMORY_FOLDER)(std::io::Error::new(
            error.kind(),
            error.to_string(),
        )),
    }
}

/// The kernel refused to lock pages.
pub(crate) fn not_locked(map: &str, length: u64, error: &std::io::Error) -> ServeError {
    let limit = rustix::process::getrlimit(rustix::process::Resource::Memlock).current;
    ServeError::NotLocked {
        map: map.to_owned(),
        needed: length,
        limit: limit.map_or_else(|| "none".to_owned(), |bytes| format!("{bytes} bytes")),
        source: std::io::Error::new(error.kind(), error.to_string()),
    }
}

fn file_system() -> Option<Room> {
    let hint = "enlarge it (`mount -o remount,size=…`, for containers `--shm-size`)";
    Some(Room { available: free_bytes()?, limit: SHARED_MEMORY_FOLDER, hint })
}

/// What the machine leaves, swap included; `None` if the system does not say \[bytes\].
pub(crate) fn machine_available() -> Option<u64> {
    let text = fs::read_to_string("/proc/meminfo").ok()?;
    let available = [field(&text, "MemAvailable:"), field(&text, "SwapFree:")];
    let kilobytes = available[0]?.saturating_add(available[1].unwrap_or(0));
    Some(kilobytes.saturating_mul(1024))
}

fn machine() -> Option<Room> {
    Some(Room { available: machine_available()?, limit: "the machine's memory", hint: "free some" })
}

/// What the control groups leave.
fn control_group() -> Option<Room> {
    Some(Room {
        available: control_group::available()?,
        limit: "the control group's memory limit",
        hint: "raise the limit of the container or service",
    })
}

/// The number after a name at the beginning of a line.
pub(crate) fn field(text: &str, name: &str) -> Option<u64> {
    text.lines().find_map(|line| line.strip_prefix(name)?.split_whitespace().next()?.parse().ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_byte_fits_and_the_largest_number_does_not() {
        assert!(check("m", 1).is_ok());
        assert!(matches!(check("m", u64::MAX), Err(ServeError::NotEnoughMemory { .. })));
    }
}
