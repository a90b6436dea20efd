//! Compiling one file in this process.

use super::up_to_date::{Record, WithRecord};
use crate::archive_file;
use crate::child::{ArchiveFacts, ChildReport};
use crate::same_file::is_same_file;
use crate::source::Compiling;
use crate::{draft, report, source};
use anyhow::{Context, Result, bail};
use mapd_archive::{HEADER_LENGTH, Rows};
use mapd_compiler::{Progress, Verdict};
use std::path::{Path, PathBuf};

/// Where archive and report go.
pub(super) struct Target {
    pub(super) archive: PathBuf,
    pub(super) report: Option<PathBuf>,
    /// Whether the archive goes into a file that is there and that nobody reads yet.
    pub(super) is_there: bool,
}

/// The map is compiled; the place for its archive is what failed.
#[derive(Debug, thiserror::Error)]
#[error("the archive cannot be written")]
pub(super) struct Unwritten;

/// Compiles a file, prints what was found, and writes the report, then the archive. Of a rejected map there is none; what was
/// there stays.
///
/// Errors: files that cannot be read or written.
pub(super) fn compile(
    file: &Path,
    target: &Target,
    compiling: Compiling<'_>,
    progress: &mut dyn FnMut(Progress),
) -> Result<(Verdict, ChildReport)> {
    let mut compiled = source::compile_file_with(file, compiling, progress)?;
    let name = file.display().to_string();
    report::print(&name, &compiled);
    let included: Vec<PathBuf> = compiled.included.iter().map(|file| absolute(file)).collect();
    let targets = [Some(&target.archive), target.report.as_ref()];
    for target in targets.into_iter().flatten() {
        if included.iter().any(|file| is_same_file(file, target)) {
            bail!("{} would overwrite a file that the map includes", target.display());
        }
    }
    let missing = compiled.missing.iter().map(|file| absolute(file)).collect();
    let counts = report::counts(&compiled);
    let mut told = ChildReport { included, missing, counts, archive: None, is_unwritten: false };
    let mut unnamed = None;
    let mut record = None;
    if let Some(rows) = compiled.rows.take() {
        let provenance = &compiled.provenance;
        let (roads, lanes) = (rows.roads.len(), numbered_lanes(&rows));
        let header = if target.is_there {
            archive_file::write_into(&target.archive, &rows, provenance).context(Unwritten)?
        } else {
            let written = archive_file::prepare(&target.archive, rows, provenance)?;
            let header = written.header;
            unnamed = Some(written);
            header
        };
        let bytes = header.body_length + HEADER_LENGTH as u64;
        let content_hash = report::hex(&header.content_hash);
        let facts = ArchiveFacts { bytes, roads, lanes, content_hash };
        record = Some(Record::new(&facts, provenance, &told.included));
        told.archive = Some(facts);
    }
    if let Some(path) = &target.report {
        let report = report::report(&name, &compiled);
        let mut json = serde_json::to_vec_pretty(&WithRecord { report, archive: record })?;
        json.push(b'\n');
        draft::write(path, &json)?;
    }
    // Last: a process that sees the archive finds its report, too.
    if let Some(written) = unnamed {
        written.publish()?;
    }
    Ok((compiled.verdict, told))
}

/// Number of lanes but for the centre lanes.
fn numbered_lanes(rows: &Rows) -> usize {
    rows.lanes.iter().filter(|lane| lane.number != 0).count()
}

fn absolute(file: &Path) -> PathBuf {
    std::path::absolute(file).unwrap_or_else(|_| file.to_owned())
}
