//! Where daemon and clients meet.

use std::path::{Path, PathBuf};
use thiserror::Error;

/// Prefix of every file when nothing else is said.
pub const DEFAULT_PREFIX: &str = "mapd_";

/// Environment variable that replaces [`DEFAULT_PREFIX`] in [`Domain::from_env`].
pub const PREFIX_VARIABLE: &str = "MAPD_PREFIX";

/// Longest prefix in bytes: the path of an event socket holds it twice and is limited to 107 bytes by the kernel.
pub const MAX_PREFIX_LENGTH: usize = 20;

/// The file system that holds everything of a domain. POSIX shared memory lives here on Linux.
pub const SHARED_MEMORY_FOLDER: &str = "/dev/shm";

/// The prefix cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "expected a prefix of ASCII letters, digits and '-' that ends with its only '_', at most {MAX_PREFIX_LENGTH} bytes, \
     such as {DEFAULT_PREFIX:?}; found {prefix:?}; change it or {PREFIX_VARIABLE}"
)]
pub struct DomainError {
    /// What was given.
    pub prefix: String,
}

/// Where daemon and clients meet: the prefix of all files in [`SHARED_MEMORY_FOLDER`], and the root folder
/// `/dev/shm/{prefix}root`. Domains with different prefixes know nothing of each other.
///
/// The only `_` of a prefix is its last character, so that no prefix begins another: a daemon removes unfinished files
/// of its own domain, and must never meet those of a neighbour.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Domain {
    prefix: String,
    root: PathBuf,
}

impl Domain {
    /// A domain of its own.
    ///
    /// Errors: the prefix cannot be used.
    pub fn new(prefix: &str) -> Result<Self, DomainError> {
        let stem = prefix.strip_suffix('_').unwrap_or_default();
        let allowed = |c: char| c.is_ascii_alphanumeric() || c == '-';
        let starts_well = stem.starts_with(|c: char| c.is_ascii_alphanumeric());
        if !starts_well || prefix.len() > MAX_PREFIX_LENGTH || !stem.chars().all(allowed) {
            return Err(DomainError { prefix: prefix.to_owned() });
        }
        let root = Path::new(SHARED_MEMORY_FOLDER).join(format!("{prefix}root"));
        Ok(Self { prefix: prefix.to_owned(), root })
    }

    /// The domain that the environment variable [`PREFIX_VARIABLE`] names, else the default one.
    ///
    /// Errors: the variable's prefix cannot be used.
    pub fn from_env() -> Result<Self, DomainError> {
        match std::env::var_os(PREFIX_VARIABLE) {
            Some(prefix) => Self::new(&prefix.to_string_lossy()),
            None => Self::new(DEFAULT_PREFIX),
        }
    }

    /// Prefix of all files.
    pub fn prefix(&self) -> &str {
        &self.prefix
    }

    /// The root folder.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// A file of this map in the root folder.
    pub(crate) fn map_file(&self, map: &str, suffix: &str) -> PathBuf {
        self.root.join(format!("{map}{suffix}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prefixes() {
        for good in ["mapd_", "t42_", "a-b_"] {
            let domain = Domain::new(good);
            let root = domain.map(|d| d.root().to_owned());
            assert_eq!(root, Ok(PathBuf::from(format!("/dev/shm/{good}root"))));
        }
        for bad in
            ["", "_", "mapd", "mapd_x_", "-a_", "a/b_", "a b_", "\u{e4}_", "abcdefghijklmnopqrst_"]
        {
            assert_eq!(Domain::new(bad), Err(DomainError { prefix: bad.to_owned() }));
        }
    }
}
