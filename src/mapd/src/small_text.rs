//! Texts that a user names: configuration, rules, tables.

use anyhow::{Context, Result};
use mapd_transport::read_regular;
use std::path::Path;

/// Longest such text \[bytes\]; those that people write have some thousands.
const LONGEST: u64 = 16 << 20;

/// Reads one. Neither a pipe nor a device is waited for.
///
/// Errors: it cannot be read, is no regular file, no text, or too long; with its name.
pub(crate) fn read(path: &Path) -> Result<String> {
    read_regular(path, LONGEST).with_context(|| format!("reading {}", path.display()))
}
