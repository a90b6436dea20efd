//! Limits of processes, which daemon and clients inherit from their parent process.

use super::finding::{Finding, size};
use rustix::process::{Resource, getrlimit};

/// Least address space that is no trouble \[bytes\]: a client maps the archive and some MiB.
const ADDRESS_SPACE: u64 = 4 << 30;

/// Least number of open files: a daemon has about ten, three for each map, and three for each client.
const OPEN_FILES: u64 = 512;

/// Examines the limits of this process, for an archive of so many bytes.
pub(super) fn examine(archive: u64, out: &mut Vec<Finding>) {
    let limit = |resource| getrlimit(resource).current;
    out.push(match limit(Resource::As) {
        Some(bytes) if bytes < ADDRESS_SPACE.saturating_add(archive.saturating_mul(2)) => {
            Finding::problem(
                "address space",
                format!("limited to {}", size(bytes)),
                "raise it (ulimit -v, LimitAS=): a process maps each generation that it holds",
            )
        }
        other => Finding::ok("address space", described(other)),
    });
    out.push(match limit(Resource::Fsize) {
        Some(bytes) if bytes < archive.max(1 << 20) => Finding::problem(
            "file size",
            format!("limited to {}", size(bytes)),
            "raise it (ulimit -f, LimitFSIZE=): shared memory is files, and a file too large ends the daemon by SIGXFSZ",
        ),
        other => Finding::ok("file size", described(other)),
    });
    out.push(match limit(Resource::Nofile) {
        Some(files) if files < OPEN_FILES => Finding::note(
            "open files",
            format!("limited to {files}"),
            format!("raise it to {OPEN_FILES} (ulimit -n, LimitNOFILE=) where many clients attach"),
        ),
        Some(files) => Finding::ok("open files", format!("at most {files}")),
        None => Finding::ok("open files", "no limit"),
    });
    out.push(match limit(Resource::Memlock) {
        _ if may_lock_all() => Finding::ok("locked memory", "no limit with CAP_IPC_LOCK"),
        Some(bytes) if bytes < archive.max(LEAST_LOCKED) => Finding::note(
            "locked memory",
            format!("limited to {}", size(bytes)),
            "raise it for --lock-memory (ulimit -l, LimitMEMLOCK=): two generations are locked while a map is replaced",
        ),
        other => Finding::ok("locked memory", described(other)),
    });
}

/// Below this, hardly any map can be locked \[bytes\]; it is the limit that most systems set.
const LEAST_LOCKED: u64 = (8 << 20) + 1;

/// Number of the right to lock memory without limit (capabilities(7), CAP_IPC_LOCK).
const IPC_LOCK: u32 = 14;

/// Whether this process has that right.
fn may_lock_all() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let rights = status.lines().find_map(|line| line.strip_prefix("CapEff:"));
    let rights = rights.and_then(|text| u64::from_str_radix(text.trim(), 16).ok());
    rights.is_some_and(|rights| rights & (1 << IPC_LOCK) != 0)
}

fn described(limit: Option<u64>) -> String {
    limit.map_or_else(|| "no limit".to_owned(), |bytes| format!("limited to {}", size(bytes)))
}
