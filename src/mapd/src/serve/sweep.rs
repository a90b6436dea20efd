//! Segments that a killed process left half-made.
//!
//! iceoryx2 waits for them to be finished, for ever. They show by their size (0) or by their mode (not yet readable).
//! Only whoever holds the attach lock alone may sweep: then nobody is in the middle of making one.

use mapd_client::Domain;
use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::PathBuf;

/// Owner may read.
const OWNER_READ: u32 = 0o400;

/// Removes half-made segments of the domain.
pub(super) fn sweep(domain: &Domain) {
    for (path, metadata) in segments(domain) {
        if metadata.len() == 0 || metadata.mode() & OWNER_READ == 0 {
            // Gone already is as good.
            let _ = fs::remove_file(path);
        }
    }
}

/// The domain's files in shared memory.
pub(super) fn segments(domain: &Domain) -> Vec<(PathBuf, fs::Metadata)> {
    let Ok(entries) = fs::read_dir(domain.shared_memory()) else { return Vec::new() };
    entries
        .flatten()
        .filter(|entry| entry.file_name().to_string_lossy().starts_with(domain.prefix()))
        .filter_map(|entry| Some((entry.path(), entry.metadata().ok()?)))
        .filter(|(_, metadata)| metadata.is_file())
        .collect()
}
