//! Files that a killed process left half made.

use crate::domain::{Domain, SHARED_MEMORY_FOLDER};
use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

/// Owner's read permission: iceoryx2 grants it when a file is complete.
const OWNER_READ: u32 = 0o400;

/// Suffix of the files that describe a service.
const SERVICE_SUFFIX: &str = ".service";

/// Files of a domain that are not complete: of size zero, or not readable by their owner. While the attach lock is held,
/// by the caller, nobody else is creating any (shared: other clients may be, of files that nobody opens; exclusively:
/// really nobody), so that a daemon may remove them.
///
/// A zero-sized segment is what iceoryx2 0.10 waits for without end.
pub fn unfinished_segments(domain: &Domain) -> Vec<PathBuf> {
    unfinished_among(domain, |_| true)
}

/// Those of these names. Only they are looked at: with many maps a domain has thousands of files.
pub(super) fn unfinished_among(domain: &Domain, wanted: impl Fn(&str) -> bool) -> Vec<PathBuf> {
    let of_domain = |name: &str| name.starts_with(domain.prefix()) && wanted(name);
    let services = |name: &str| name.ends_with(SERVICE_SUFFIX);
    let mut found = unfinished_in(Path::new(SHARED_MEMORY_FOLDER), of_domain);
    found.extend(unfinished_in(&domain.root().join("services"), services));
    found
}

fn unfinished_in(folder: &Path, wanted: impl Fn(&str) -> bool) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let named = entries
        .filter_map(Result::ok)
        .filter(|entry| entry.file_name().to_str().is_some_and(&wanted));
    let unfinished = named.filter(|entry| {
        // A file that is gone meanwhile is no obstacle.
        entry.metadata().is_ok_and(|m| m.is_file() && (m.len() == 0 || m.mode() & OWNER_READ == 0))
    });
    unfinished.map(|entry| entry.path()).collect()
}
