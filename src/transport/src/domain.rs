//! Domains: where daemon and clients meet.

use crate::accounts::user_id;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Default prefix of every file.
pub const DEFAULT_PREFIX: &str = "mapd_";

/// Environment variable that replaces [`DEFAULT_PREFIX`] in [`Domain::from_env`].
pub const PREFIX_VARIABLE: &str = "MAPD_PREFIX";

/// Longest prefix in bytes: the path of an event socket holds it twice and is limited to 107 bytes by the kernel.
pub const MAX_PREFIX_LENGTH: usize = 20;

/// The file system that holds everything of a domain. POSIX shared memory lives here on Linux.
pub const SHARED_MEMORY_FOLDER: &str = "/dev/shm";

/// Environment variable with the user whose daemon is trusted, by name or number, in [`Domain::from_env`].
pub const OWNER_VARIABLE: &str = "MAPD_OWNER";

/// The prefix or the owner cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum DomainError {
    /// The prefix.
    #[error(
        "expected a prefix of ASCII letters, digits and '-' that ends with its only '_', at most {MAX_PREFIX_LENGTH} bytes, \
         such as {DEFAULT_PREFIX:?}; found {prefix:?}; change it or {PREFIX_VARIABLE}"
    )]
    Prefix {
        /// The text.
        prefix: String,
    },
    /// The owner.
    #[error("owner {owner:?}: {reason}; change it or {OWNER_VARIABLE}")]
    Owner {
        /// The text.
        owner: String,
        /// Why it is not a user.
        reason: String,
    },
}

/// Where daemon and clients meet: the prefix of all files in [`SHARED_MEMORY_FOLDER`], and the root folder
/// `/dev/shm/{prefix}root`. Domains with different prefixes are independent.
///
/// The only `_` of a prefix is its last character, so that no prefix begins another: a daemon removes unfinished files
/// of its own domain, and must never meet those of a neighbour.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Domain {
    prefix: String,
    root: PathBuf,
    /// Whose daemon is trusted; `None` for this process's own user.
    owner: Option<u32>,
}

impl Domain {
    /// A domain with this prefix.
    ///
    /// Errors: the prefix cannot be used.
    pub fn new(prefix: &str) -> Result<Self, DomainError> {
        let stem = prefix.strip_suffix('_').unwrap_or_default();
        let allowed = |c: char| c.is_ascii_alphanumeric() || c == '-';
        let starts_well = stem.starts_with(|c: char| c.is_ascii_alphanumeric());
        if !starts_well || prefix.len() > MAX_PREFIX_LENGTH || !stem.chars().all(allowed) {
            return Err(DomainError::Prefix { prefix: prefix.to_owned() });
        }
        let root = Path::new(SHARED_MEMORY_FOLDER).join(format!("{prefix}root"));
        Ok(Self { prefix: prefix.to_owned(), root, owner: None })
    }

    /// The domain that the environment variables [`PREFIX_VARIABLE`] and [`OWNER_VARIABLE`] name, else the default one of this process's own user.
    ///
    /// Errors: prefix or owner cannot be used.
    pub fn from_env() -> Result<Self, DomainError> {
        Self::from_env_or(None)
    }

    /// As [`Domain::from_env`], with this prefix in place of that of [`PREFIX_VARIABLE`], if there is one. [`OWNER_VARIABLE`] holds for either.
    ///
    /// Errors: prefix or owner cannot be used.
    pub fn from_env_or(prefix: Option<&str>) -> Result<Self, DomainError> {
        Self::of(prefix, |variable| std::env::var_os(variable))
    }

    fn of(
        prefix: Option<&str>,
        variable: impl Fn(&str) -> Option<OsString>,
    ) -> Result<Self, DomainError> {
        let domain = match (prefix, variable(PREFIX_VARIABLE)) {
            (Some(prefix), _) => Self::new(prefix),
            (None, Some(prefix)) => Self::new(&prefix.to_string_lossy()),
            (None, None) => Self::new(DEFAULT_PREFIX),
        }?;
        match variable(OWNER_VARIABLE) {
            Some(owner) => domain.owned_by(&owner.to_string_lossy()),
            None => Ok(domain),
        }
    }

    /// The same domain, with another trusted user, by name or number. Only files of this user are read: any user could create a folder with the domain's name first.
    ///
    /// Errors: there is no such user.
    pub fn owned_by(mut self, owner: &str) -> Result<Self, DomainError> {
        let failed = |error: std::io::Error| DomainError::Owner {
            owner: owner.to_owned(),
            reason: error.to_string(),
        };
        self.owner = Some(user_id(owner).map_err(failed)?);
        Ok(self)
    }

    /// Id of the user whose daemon is trusted.
    pub fn owner(&self) -> u32 {
        self.owner.unwrap_or_else(|| rustix::process::geteuid().as_raw())
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
            assert_eq!(Domain::new(bad), Err(DomainError::Prefix { prefix: bad.to_owned() }));
        }
    }

    /// Clients for C, C++ and Python that named a prefix trusted their own user, whatever owner the environment named.
    #[test]
    fn the_environment_names_the_owner_whoever_names_the_prefix() {
        let us = rustix::process::geteuid().as_raw();
        for (prefix, prefix_variable, owner_variable, expected) in [
            (None, None, None, (DEFAULT_PREFIX, us)),
            (None, Some("a_"), Some("61003"), ("a_", 61003)),
            (Some("b_"), None, Some("61003"), ("b_", 61003)),
            (Some("b_"), Some("a_"), Some("61003"), ("b_", 61003)),
            (Some("b_"), Some("a_"), None, ("b_", us)),
        ] {
            let variable = |name: &str| match name {
                PREFIX_VARIABLE => prefix_variable.map(OsString::from),
                _ => owner_variable.map(OsString::from),
            };
            let domain = Domain::of(prefix, variable).expect("a domain");
            assert_eq!((domain.prefix(), domain.owner()), expected, "{prefix:?}");
        }
    }
}
