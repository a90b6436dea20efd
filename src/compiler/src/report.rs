//! What a compilation yields besides rows.

use mapd_archive::{Provenance, Rows};
use mapd_xodr::{Finding, LineIndex, Severity};

/// What becomes of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Every part of the map can be used.
    Accepted,
    /// The map has errors; there is no archive.
    Rejected,
}

/// How far a compilation is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// Reading and lowering.
    Reading {
        /// Bytes of input read.
        bytes: u64,
        /// Roads so far.
        roads: usize,
    },
    /// Sampling lanes.
    Sampling {
        /// Lanes in all.
        lanes: usize,
    },
    /// Building the index.
    Indexing {
        /// Points in all.
        segments: usize,
    },
}

/// A finding with its place in the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// The finding.
    pub finding: Finding,
    /// Line, from 1.
    pub line: u32,
    /// Column in bytes, from 1.
    pub column: u32,
}

/// Everything a compilation yields.
pub struct Compilation {
    /// The tables; `None` for a rejected map.
    pub rows: Option<Rows>,
    /// Where they come from.
    pub provenance: Provenance,
    /// Findings in file order.
    pub diagnostics: Vec<Diagnostic>,
    /// Findings beyond those kept, by severity: information, warnings, errors.
    pub dropped: [usize; 3],
    /// What becomes of the map.
    pub verdict: Verdict,
}

/// Findings of one severity that are kept; a file with an error in every line must not fill the memory.
const KEPT: usize = 10_000;

/// Collects findings and places them.
#[derive(Default)]
pub(crate) struct Collector {
    diagnostics: Vec<Diagnostic>,
    counts: [usize; 3],
}

fn rank(severity: Severity) -> usize {
    match severity {
        Severity::Info => 0,
        Severity::Warning => 1,
        Severity::Error => 2,
    }
}

impl Collector {
    pub(crate) fn add(&mut self, findings: Vec<Finding>, lines: &LineIndex) {
        for finding in findings {
            let count = &mut self.counts[rank(finding.severity)];
            *count += 1;
            if *count <= KEPT {
                let position = lines.position(finding.span.start);
                self.diagnostics.push(Diagnostic {
                    finding,
                    line: position.line,
                    column: position.column,
                });
            }
        }
    }

    pub(crate) fn has_errors(&self) -> bool {
        self.counts[rank(Severity::Error)] > 0
    }

    pub(crate) fn finish(mut self, rows: Option<Rows>, provenance: Provenance) -> Compilation {
        self.diagnostics.sort_by_key(|d| d.finding.span.start);
        let verdict = if self.has_errors() { Verdict::Rejected } else { Verdict::Accepted };
        let dropped = self.counts.map(|count| count.saturating_sub(KEPT));
        Compilation { rows, provenance, diagnostics: self.diagnostics, dropped, verdict }
    }
}
