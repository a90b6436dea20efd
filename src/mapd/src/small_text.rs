//! Texts that a user names: configuration, rules, tables.

use crate::similar::did_you_mean_of;
use anyhow::{Context, Result};
use mapd_transport::read_regular;
use serde::de::DeserializeOwned;
use std::path::Path;

/// Longest such text \[bytes\]; those that people write have some thousands.
const LONGEST: u64 = 16 << 20;

/// Reads one. Neither a pipe nor a device is waited for.
///
/// Errors: it cannot be read, is no regular file, no text, or too long; with its name.
pub(crate) fn read(path: &Path) -> Result<String> {
    read_regular(path, LONGEST).with_context(|| format!("reading {}", path.display()))
}

/// What TOML says, read.
///
/// Errors: with line and column, what is wrong with it.
pub(crate) fn toml<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    toml::from_str(text).map_err(|error| {
        let meant = did_you_mean_of(error.message());
        let said = error.message().replace('\n', ", ");
        at(text, error.span().map_or(0, |span| span.start), &format!("{said}{meant}"))
    })
}

/// An error with its line and column.
pub(crate) fn at(text: &str, offset: usize, error: &str) -> String {
    let before = text.get(..offset).unwrap_or_default();
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
    format!("at line {line}, column {column}: {error}")
}
