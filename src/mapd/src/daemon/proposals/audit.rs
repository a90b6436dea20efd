//! The audit log: each proposal, its source and the decision as a line of JSON, in a file for each map next to its kept overlay.

use crate::clock::since_epoch;
use mapd_overlay::{Entry, Moment};
use mapd_transport::{OWN_FILE, open_guarded};
use rustix::fs::OFlags;
use serde::Serialize;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Suffix of the file.
const SUFFIX: &str = ".overlay.audit.jsonl";

/// Length at which the file is put aside, in the place of the one before \[bytes\].
const LONGEST: u64 = 16 << 20;

/// Writes what was decided.
#[derive(Debug)]
pub(crate) struct Audit {
    /// The folder, and what names begin with.
    folder: PathBuf,
    prefix: String,
    /// One line at a time.
    writing: Mutex<()>,
}

/// A line.
#[derive(Serialize)]
pub(crate) struct Line<'l> {
    /// When it was decided.
    pub(crate) time: Moment,
    /// Who said it: a source of the policy, or `operator` for `mapd overlay`.
    pub(crate) source: &'l str,
    /// The user of its process; none for the operator's commands, which are the daemon's user's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) user: Option<u32>,
    /// `accepted`, `waiting`, `refused`; `applied`, `removed`, `cleared` for the operator.
    pub(crate) decision: &'l str,
    /// Why.
    #[serde(skip_serializing_if = "str::is_empty")]
    pub(crate) reason: &'l str,
    /// What was said.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) entry: Option<&'l Entry>,
}

/// Now.
pub(crate) fn now() -> Moment {
    Moment { unix_seconds: since_epoch().as_secs_f64() }
}

impl Audit {
    pub(super) fn new(folder: &Path, prefix: &str) -> Self {
        Self { folder: folder.to_owned(), prefix: prefix.to_owned(), writing: Mutex::new(()) }
    }

    /// Writes a line.
    ///
    /// Errors: what the system says; then nothing may be accepted.
    pub(crate) fn write(&self, map: &str, line: &Line<'_>) -> io::Result<()> {
        let _one = self.writing.lock().unwrap_or_else(PoisonError::into_inner);
        let path = self.folder.join(format!("{}{map}{SUFFIX}", self.prefix));
        if fs::metadata(&path).is_ok_and(|metadata| metadata.len() > LONGEST) {
            fs::rename(&path, path.with_extension("jsonl.1"))?;
        }
        let mut text = serde_json::to_vec(line)?;
        text.push(b'\n');
        let access = OFlags::WRONLY | OFlags::APPEND | OFlags::CREATE;
        let us = rustix::process::geteuid().as_raw();
        let (file, _) = open_guarded(&path, access, OWN_FILE, us)?;
        File::from(file).write_all(&text)
    }
}
