//! What a compilation found: as text for people, as JSON for programs.

use crate::colour::Colours;
use crate::printable::printable;
use mapd_compiler::{Compilation, Diagnostic, QuarantinedPart, Treatment, Verdict};
pub use mapd_transport::hex;
use mapd_xodr::source::Places;
use mapd_xodr::{Severity, rule_ids};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::io::Write as _;

/// Findings of each severity that are printed; the JSON report has all that were kept.
const PRINTED: usize = 20;

/// Findings of a rule that are told to people one by one; those that take something out of the map always are.
const TOLD_OF_A_RULE: usize = 3;

/// Which findings are told one by one: the first few of each rule.
#[derive(Default)]
pub(crate) struct Folding {
    told: HashMap<&'static str, usize>,
}

impl Folding {
    /// Whether the next finding is told.
    pub(crate) fn tells(&mut self, diagnostic: &Diagnostic) -> bool {
        let told = self.told.entry(diagnostic.finding.rule).or_default();
        *told += 1;
        diagnostic.rejects || *told <= TOLD_OF_A_RULE
    }
}

/// The JSON report.
#[derive(Serialize)]
pub struct Report<'a> {
    verdict: &'static str,
    file: &'a str,
    input_hash: String,
    findings: Vec<ReportedFinding<'a>>,
    quarantined: Vec<ReportedPart<'a>>,
    counts: Counts,
    not_kept: usize,
}

/// A finding as JSON.
#[derive(Serialize)]
pub(crate) struct ReportedFinding<'a> {
    rule: &'a str,
    /// The id of the same rule in ASAM's checkers, where they have it.
    asam_rule: Option<&'static str>,
    severity: &'static str,
    /// Whether the map is rejected, or a part of it left out, because of it.
    rejects: bool,
    file: &'a str,
    line: u32,
    column: u32,
    /// Byte of the file's decoded text, and how many it is about.
    offset: u64,
    length: u32,
    path: &'a str,
    subject: &'a str,
    message: &'a str,
    /// The halves of the message, where it has two.
    expected: Option<&'a str>,
    found: Option<&'a str>,
    hint: &'a str,
}

/// A part in quarantine as JSON.
#[derive(Serialize)]
pub(crate) struct ReportedPart<'a> {
    kind: &'static str,
    id: &'a str,
    owner: &'a str,
    owner_kind: &'static str,
    treatment: &'static str,
    extent: Option<[f64; 4]>,
    rule: &'a str,
    line: u32,
    column: u32,
    message: &'a str,
}

/// A part in quarantine.
pub(crate) fn part(part: &QuarantinedPart) -> ReportedPart<'_> {
    ReportedPart {
        kind: part.kind.name(),
        id: &part.id,
        owner: &part.owner,
        owner_kind: part.owner_kind.name(),
        treatment: match part.treatment {
            Treatment::Dropped => "dropped",
            Treatment::ReferenceLine => "reference-line",
        },
        extent: part.extent,
        rule: part.rule,
        line: part.line,
        column: part.column,
        message: &part.message,
    }
}

/// What became of a part, for people.
pub(crate) fn treated(treatment: Treatment) -> &'static str {
    match treatment {
        Treatment::Dropped => "left out",
        Treatment::ReferenceLine => "kept as its reference line",
    }
}

pub(crate) fn verdict_name(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Accepted => "accepted",
        Verdict::Quarantined => "quarantined",
        Verdict::Rejected => "rejected",
    }
}

/// How many findings there are, those not kept among them.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Counts {
    pub(crate) errors: usize,
    pub(crate) warnings: usize,
    pub(crate) information: usize,
}

pub(crate) fn severity_name(severity: Severity) -> &'static str {
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

/// A finding with its place.
pub(crate) fn reported<'a>(file: &'a str, d: &'a Diagnostic) -> ReportedFinding<'a> {
    let finding = &d.finding;
    let halves = finding.message.strip_prefix("expected ").and_then(|m| m.split_once(", found "));
    ReportedFinding {
        rule: finding.rule,
        asam_rule: rule_ids::asam(finding.rule),
        severity: severity_name(finding.severity),
        rejects: d.rejects,
        file: place(file, d),
        line: d.line,
        column: d.column,
        offset: Places::offset_of(finding.span.start),
        length: finding.span.len,
        path: &finding.path,
        subject: &finding.subject,
        message: &finding.message,
        expected: halves.map(|(expected, _)| expected),
        found: halves.map(|(_, found)| found),
        hint: &finding.hint,
    }
}

/// How many findings there are.
pub(crate) fn counts(compiled: &Compilation) -> Counts {
    Counts {
        errors: compiled.counts.of(Severity::Error),
        warnings: compiled.counts.of(Severity::Warning),
        information: compiled.counts.of(Severity::Info),
    }
}

/// The report of a compilation.
pub fn report<'a>(file: &'a str, compiled: &'a Compilation) -> Report<'a> {
    Report {
        verdict: verdict_name(compiled.verdict),
        file,
        input_hash: hex(&compiled.provenance.input_hash),
        findings: compiled.diagnostics.iter().map(|d| reported(file, d)).collect(),
        quarantined: compiled.quarantined.iter().map(part).collect(),
        counts: counts(compiled),
        not_kept: compiled.dropped.iter().sum(),
    }
}

/// Prints findings to stderr: errors, then warnings, the first of each and of each rule;
/// information is not printed.
pub fn print(file: &str, compiled: &Compilation) {
    let mut err = std::io::stderr().lock();
    let file = &*printable(file);
    let colours = Colours::of(&err);
    let counts = counts(compiled);
    for (severity, count) in
        [(Severity::Error, counts.errors), (Severity::Warning, counts.warnings)]
    {
        let mut folding = Folding::default();
        let told: Vec<&Diagnostic> =
            of(compiled, severity).filter(|d| folding.tells(d)).take(PRINTED).collect();
        for d in &told {
            let f = &d.finding;
            let name = colours.severity(severity, severity_name(severity));
            let (file, line, column) = (place(file, d), d.line, d.column);
            let (file, message) = (printable(file), printable(&f.message));
            let _ = writeln!(err, "{file}:{line}:{column}: {name}[{}]: {message}", f.rule);
            if !f.path.is_empty() {
                let _ = writeln!(err, "    at {}", printable(&f.path));
            }
            if !f.hint.is_empty() {
                let _ = writeln!(err, "    hint: {}", printable(&f.hint));
            }
        }
        let more = count.saturating_sub(told.iter().map(|d| d.finding.count as usize).sum());
        if more > 0 {
            let name = severity_name(severity);
            let each = |all: &[&Diagnostic]| all.iter().filter(|d| d.finding.count == 1).count();
            let kept = each(&of(compiled, severity).collect::<Vec<_>>()) - each(&told);
            let written = match kept == more {
                true => "`--report` writes all".to_owned(),
                false => format!("`--report` writes {kept} of them, the others are only counted"),
            };
            let _ = writeln!(err, "{file}: {more} more {name}s; {written}");
        }
    }
    match compiled.verdict {
        Verdict::Rejected => {
            let _ = writeln!(err, "{file}: rejected, {} errors", counts.errors);
        }
        Verdict::Quarantined => {
            for part in compiled.quarantined.iter().take(PRINTED) {
                let _ = writeln!(
                    err,
                    "{file}:{}:{}: {} is {}: {}",
                    part.line,
                    part.column,
                    printable(&part.name()),
                    treated(part.treatment),
                    part.rule
                );
            }
            let _ = writeln!(err, "{file}: accepted without {} parts", compiled.quarantined.len());
        }
        Verdict::Accepted => {}
    }
}
