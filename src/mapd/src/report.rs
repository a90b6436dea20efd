//! What a compilation found: as text for people, as JSON for programs.

use mapd_compiler::{Compilation, Diagnostic, Verdict};
use mapd_xodr::Severity;
use serde::Serialize;
use std::fmt::Write as _;
use std::io::Write as _;

/// Findings of each severity that are printed; the JSON report has all that were kept.
const PRINTED: usize = 20;

/// The JSON report.
#[derive(Serialize)]
pub struct Report<'a> {
    verdict: &'static str,
    file: &'a str,
    input_hash: String,
    findings: Vec<ReportedFinding<'a>>,
    quarantined: Vec<()>,
    counts: Counts,
    not_kept: usize,
}

#[derive(Serialize)]
struct ReportedFinding<'a> {
    rule: &'a str,
    severity: &'static str,
    file: &'a str,
    line: u32,
    column: u32,
    rejects: bool,
    path: &'a str,
    message: &'a str,
    hint: &'a str,
}

#[derive(Serialize)]
struct Counts {
    errors: usize,
    warnings: usize,
    information: usize,
}

/// Bytes as hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut out, byte| {
        let _ = write!(out, "{byte:02x}");
        out
    })
}

fn severity_name(severity: Severity) -> &'static str {
    match severity {
        Severity::Info => "info",
        Severity::Warning => "warning",
        Severity::Error => "error",
    }
}

fn of(compiled: &Compilation, severity: Severity) -> impl Iterator<Item = &Diagnostic> {
    compiled.diagnostics.iter().filter(move |d| d.finding.severity == severity)
}

/// The file that a finding stands in.
fn place<'a>(file: &'a str, diagnostic: &'a Diagnostic) -> &'a str {
    if diagnostic.file.is_empty() { file } else { &diagnostic.file }
}

/// The report of a compilation.
pub fn report<'a>(file: &'a str, compiled: &'a Compilation) -> Report<'a> {
    let finding = |d: &'a Diagnostic| ReportedFinding {
        rule: d.finding.rule,
        severity: severity_name(d.finding.severity),
        file: place(file, d),
        rejects: d.rejects,
        line: d.line,
        column: d.column,
        path: &d.finding.path,
        message: &d.finding.message,
        hint: &d.finding.hint,
    };
    let [information, warnings, errors] = compiled.dropped;
    Report {
        verdict: match compiled.verdict {
            Verdict::Accepted => "accepted",
            Verdict::Rejected => "rejected",
        },
        file,
        input_hash: hex(&compiled.provenance.input_hash),
        findings: compiled.diagnostics.iter().map(finding).collect(),
        quarantined: Vec::new(),
        counts: Counts {
            errors: of(compiled, Severity::Error).count() + errors,
            warnings: of(compiled, Severity::Warning).count() + warnings,
            information: of(compiled, Severity::Info).count() + information,
        },
        not_kept: information + warnings + errors,
    }
}

/// Prints findings to stderr: what the map is rejected for, other errors, warnings, the first of each; information only as a
/// count.
pub fn print(file: &str, compiled: &Compilation) {
    let mut err = std::io::stderr().lock();
    let counts = report(file, compiled).counts;
    let errors =
        |rejects: bool| of(compiled, Severity::Error).filter(move |d| d.rejects == rejects);
    for (severity, count, printed) in [
        (Severity::Error, counts.errors, errors(true).chain(errors(false)).collect::<Vec<_>>()),
        (Severity::Warning, counts.warnings, of(compiled, Severity::Warning).collect()),
    ] {
        for d in printed.into_iter().take(PRINTED) {
            let f = &d.finding;
            let name = severity_name(severity);
            let (file, line, column) = (place(file, d), d.line, d.column);
            let _ = writeln!(err, "{file}:{line}:{column}: {name}[{}]: {}", f.rule, f.message);
            let _ = writeln!(err, "    at {}", f.path);
            if !f.hint.is_empty() {
                let _ = writeln!(err, "    hint: {}", f.hint);
            }
        }
        if count > PRINTED {
            let _ = writeln!(
                err,
                "{file}: {} more {}s; `--report` writes all",
                count - PRINTED,
                severity_name(severity)
            );
        }
    }
    match compiled.verdict {
        Verdict::Rejected => {
            let _ = writeln!(err, "{file}: rejected, {} errors", counts.errors);
        }
        Verdict::Accepted if counts.errors > 0 => {
            let _ = writeln!(
                err,
                "{file}: accepted; errors against the standard: {}",
                counts.errors
            );
        }
        Verdict::Accepted => {}
    }
}
