//! What stands in the domain's part of the folder of shared memory, where every user can put files: what a killed process left half made, and what belongs to
//! other users, which is no part of the domain.

use crate::domain::{Domain, SHARED_MEMORY_FOLDER};
use crate::user::trusts;
use std::fmt;
use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

/// Owner's read permission: iceoryx2 grants it when a file is complete.
const OWNER_READ: u32 = 0o400;

/// Suffix of the files that describe a service.
const SERVICE_SUFFIX: &str = ".service";

/// Files of other users that are named, at most: anybody can make any number.
pub const MOST_FOREIGN: usize = 16;

/// Something of another user that has a name as if it were the domain's.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ForeignFile {
    /// Where it is.
    pub path: PathBuf,
    /// User id of its owner.
    pub owner: u32,
}

impl fmt::Display for ForeignFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Its owner has chosen the name: it must not steer a terminal.
        write!(f, "{:?} belongs to user {}", self.path, self.owner)
    }
}

/// What a look at a domain's files has found.
#[derive(Debug, Default)]
pub struct DomainFiles {
    /// Files of the domain's user that are not complete: of size zero, or not readable by their owner. While the attach lock is held,
    /// by the caller, nobody else is creating any (shared: other clients may be, of files that nobody opens; exclusively:
    /// really nobody), so that a daemon may remove them.
    ///
    /// A zero-sized segment is what iceoryx2 0.10 waits for without end.
    pub unfinished: Vec<PathBuf>,
    /// What other users have put there, the first [`MOST_FOREIGN`].
    pub foreign: Vec<ForeignFile>,
    /// How many these are in all.
    pub foreign_count: usize,
}

/// Looks at a domain's files.
pub fn domain_files(domain: &Domain) -> DomainFiles {
    look(domain, |_| true)
}

/// As [`DomainFiles::unfinished`].
pub fn unfinished_segments(domain: &Domain) -> Vec<PathBuf> {
    domain_files(domain).unfinished
}

/// Looks at those of these names only: with many maps a domain has thousands of files.
pub(super) fn look(domain: &Domain, wanted: impl Fn(&str) -> bool) -> DomainFiles {
    let mut found = DomainFiles::default();
    let of_domain = |name: &str| name.starts_with(domain.prefix()) && wanted(name);
    found.look_in(Path::new(SHARED_MEMORY_FOLDER), domain.owner(), of_domain);
    let services = |name: &str| name.ends_with(SERVICE_SUFFIX);
    found.look_in(&domain.root().join("services"), domain.owner(), services);
    found
}

impl DomainFiles {
    fn look_in(&mut self, folder: &Path, owner: u32, wanted: impl Fn(&str) -> bool) {
        let entries = fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok);
        // A name that is no text is none of ours; one of a stranger's that only looks like ours has the prefix.
        for entry in entries.filter(|entry| wanted(&entry.file_name().to_string_lossy())) {
            // A file that is gone meanwhile is no obstacle. Links are not followed.
            let Ok(metadata) = entry.metadata() else { continue };
            if !trusts(owner, metadata.uid()) {
                self.foreign_count += 1;
                if self.foreign.len() < MOST_FOREIGN {
                    self.foreign.push(ForeignFile { path: entry.path(), owner: metadata.uid() });
                }
            } else if metadata.is_file()
                && (metadata.len() == 0 || metadata.mode() & OWNER_READ == 0)
            {
                self.unfinished.push(entry.path());
            }
        }
    }
}
