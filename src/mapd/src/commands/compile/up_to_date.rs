//! Whether an archive is what its source would be compiled into.
//!
//! The archive's header says what it was made from and by which options; the report beside it, which files were included, by
//! which program, and what was found. Where either is missing, unreadable or about something else, it is not.

use super::inputs::Tile;
use crate::cache::{InputHash, Key};
use crate::child::ArchiveFacts;
use crate::exit::Exit;
use crate::report::{self, Counts};
use mapd_archive::{HEADER_LENGTH, Header, Provenance};
use mapd_transport::open_regular;
use serde::{Deserialize, Serialize};
use std::fs;
use std::io::BufReader;
use std::os::unix::fs::FileExt;
use std::path::{Path, PathBuf};

/// What a report says of its archive.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Record {
    #[serde(flatten)]
    facts: ArchiveFacts,
    /// Files that the document includes.
    included: Vec<String>,
    /// The archive's [`Key`]. Nothing where a file's name is no text, which would be looked for under another.
    key: Option<String>,
}

impl Record {
    pub(super) fn new(facts: &ArchiveFacts, made: &Provenance, included: &[PathBuf]) -> Self {
        let key = Key::of_archive(&made.input_hash, &made.options_hash).to_string();
        Self {
            facts: facts.clone(),
            key: included.iter().all(|file| file.to_str().is_some()).then_some(key),
            included: included.iter().map(|file| file.display().to_string()).collect(),
        }
    }
}

/// A report, and what it says of its archive.
#[derive(Serialize)]
pub(super) struct WithRecord<'a> {
    #[serde(flatten)]
    pub(super) report: report::Report<'a>,
    pub(super) archive: Option<Record>,
}

/// What of a report is read again.
#[derive(Deserialize)]
struct Report {
    verdict: String,
    counts: Counts,
    archive: Option<Record>,
}

/// What is known of an archive that is up to date.
pub(super) struct UpToDate {
    pub(super) exit: Exit,
    pub(super) counts: Counts,
    pub(super) facts: ArchiveFacts,
}

/// What is known of a tile's archive, if it is up to date with options of this hash.
pub(super) fn known(tile: &Tile, options: &[u8; 8]) -> Option<UpToDate> {
    let header = header(&tile.archive)?;
    let report: Report =
        serde_json::from_reader(BufReader::new(open_regular(&tile.report).ok()?)).ok()?;
    let record = report.archive?;
    let exit = match report.verdict.as_str() {
        "accepted" => Exit::Done,
        "quarantined" => Exit::Quarantined,
        _ => return None,
    };
    let made = &header.provenance;
    if made.options_hash != *options
        || record.facts.content_hash != report::hex(&header.content_hash)
    {
        return None;
    }
    let wanted = Key::of_archive(&made.input_hash, options).to_string();
    if record.key.as_ref() != Some(&wanted) {
        return None;
    }
    // Others may give their bytes only once, or never.
    if !fs::metadata(&tile.source).ok()?.is_file() {
        return None;
    }
    let included = record.included.iter().map(PathBuf::from).collect();
    let input = InputHash::of(&tile.source, |_| included).ok()?.input;
    (input == made.input_hash).then_some(UpToDate {
        exit,
        counts: report.counts,
        facts: record.facts,
    })
}

/// The header of an archive that is as long as it says.
fn header(archive: &Path) -> Option<Header> {
    let file = open_regular(archive).ok()?;
    let mut bytes = [0; HEADER_LENGTH];
    file.read_exact_at(&mut bytes, 0).ok()?;
    let header = Header::decode(&bytes).ok()?;
    let length = header.body_length.checked_add(HEADER_LENGTH as u64)?;
    (file.metadata().ok()?.len() == length).then_some(header)
}
