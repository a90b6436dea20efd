//! What became of each tile.

use super::inputs::Tile;
use crate::child::ArchiveFacts;
use crate::exit::Exit;
use crate::printable::printable;
use crate::report::Counts;
use crate::rounded;
use anyhow::Result;
use serde::Serialize;
use std::io::Write;
use std::time::Duration;

/// What became of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Outcome {
    /// There is an archive of all of it.
    Accepted,
    /// There is an archive without some parts.
    Quarantined,
    /// There is none; one that was there stays.
    Rejected,
    /// Something else failed; what was there stays.
    Failed,
}

impl Outcome {
    fn name(self) -> &'static str {
        match self {
            Self::Accepted => "accepted",
            Self::Quarantined => "quarantined",
            Self::Rejected => "rejected",
            Self::Failed => "failed",
        }
    }
}

/// A row of the table.
#[derive(Debug, Serialize)]
pub(super) struct Row {
    /// The source's path.
    pub(super) tile: String,
    outcome: Outcome,
    #[serde(rename = "up_to_date")]
    pub(super) is_up_to_date: bool,
    findings: Option<Counts>,
    pub(super) seconds: f64,
    /// Where the archive is.
    path: String,
    archive: Option<ArchiveFacts>,
    reason: Option<String>,
    #[serde(skip)]
    pub(super) exit: Exit,
}

impl Row {
    /// Of a tile with which nothing was done yet.
    pub(super) fn new(tile: &Tile) -> Self {
        Self {
            tile: tile.source.display().to_string(),
            outcome: Outcome::Failed,
            is_up_to_date: false,
            findings: None,
            seconds: 0.0,
            path: tile.archive.display().to_string(),
            archive: None,
            reason: None,
            exit: Exit::Environment,
        }
    }

    /// Its compiler came to a verdict.
    pub(super) fn finish(&mut self, exit: Exit, counts: Counts, archive: Option<ArchiveFacts>) {
        self.outcome = match exit {
            Exit::Done => Outcome::Accepted,
            Exit::Quarantined => Outcome::Quarantined,
            Exit::Rejected => Outcome::Rejected,
            Exit::Usage | Exit::Environment => Outcome::Failed,
        };
        (self.exit, self.findings, self.archive) = (exit, Some(counts), archive);
    }

    /// It came to none.
    pub(super) fn fail(&mut self, reason: String) {
        self.outcome = Outcome::Failed;
        self.exit = Exit::Environment;
        self.reason = Some(reason);
    }

    /// Roads of its archive.
    pub(super) fn roads(&self) -> usize {
        self.archive.as_ref().map_or(0, |archive| archive.roads)
    }
}

/// How many tiles came to what.
#[derive(Serialize)]
struct Sums {
    tiles: usize,
    accepted: usize,
    quarantined: usize,
    rejected: usize,
    failed: usize,
    up_to_date: usize,
    seconds: f64,
}

impl Sums {
    fn of(rows: &[Row], took: Duration) -> Self {
        let count = |outcome| rows.iter().filter(|row| row.outcome == outcome).count();
        Self {
            tiles: rows.len(),
            accepted: count(Outcome::Accepted),
            quarantined: count(Outcome::Quarantined),
            rejected: count(Outcome::Rejected),
            failed: count(Outcome::Failed),
            up_to_date: rows.iter().filter(|row| row.is_up_to_date).count(),
            seconds: took.as_secs_f64(),
        }
    }
}

#[derive(Serialize)]
struct Document<'a> {
    tiles: &'a [Row],
    sums: Sums,
}

/// Writes the table for programs.
pub(super) fn write_json(rows: &[Row], took: Duration, out: &mut dyn Write) -> Result<()> {
    serde_json::to_writer_pretty(&mut *out, &Document { tiles: rows, sums: Sums::of(rows, took) })?;
    writeln!(out)?;
    Ok(())
}

/// Writes the table for people.
pub(super) fn write(rows: &[Row], took: Duration, out: &mut dyn Write) -> Result<()> {
    let head = ["tile", "outcome", "roads", "errors", "warnings", "seconds", "size"];
    let mut cells = vec![head.map(str::to_owned)];
    for row in rows {
        let known = |number: Option<String>| number.unwrap_or_else(|| "-".to_owned());
        let archive = row.archive.as_ref();
        let suffix = if row.is_up_to_date { ", up to date" } else { "" };
        cells.push([
            printable(&row.tile).into_owned(),
            format!("{}{suffix}", row.outcome.name()),
            known(archive.map(|archive| archive.roads.to_string())),
            known(row.findings.map(|findings| findings.errors.to_string())),
            known(row.findings.map(|findings| findings.warnings.to_string())),
            format!("{:.2}", row.seconds),
            known(archive.map(|archive| rounded::bytes(archive.bytes as f64))),
        ]);
    }
    let width = |column: usize| {
        cells.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max()
    };
    let widths: Vec<usize> = (0..head.len()).map(|column| width(column).unwrap_or(0)).collect();
    let reasons = std::iter::once(None).chain(rows.iter().map(|row| row.reason.as_ref()));
    for (row, reason) in cells.iter().zip(reasons) {
        let mut line = String::new();
        for (column, (cell, width)) in row.iter().zip(&widths).enumerate() {
            // Words to the left, numbers to the right.
            line += &match column {
                0 => format!("{cell:<width$}"),
                1 => format!("  {cell:<width$}"),
                _ => format!("  {cell:>width$}"),
            };
        }
        if let Some(reason) = reason {
            line += &format!("  {}", printable(reason));
        }
        writeln!(out, "{line}")?;
    }
    let sums = Sums::of(rows, took);
    writeln!(
        out,
        "{} tiles: {} accepted, {} quarantined, {} rejected, {} failed; {} were up to date; {:.1} s",
        sums.tiles,
        sums.accepted,
        sums.quarantined,
        sums.rejected,
        sums.failed,
        sums.up_to_date,
        sums.seconds
    )?;
    Ok(())
}
