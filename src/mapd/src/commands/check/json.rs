//! Findings for programs; docs/checks.md describes the fields.

use crate::report::{self, ReportedFinding, verdict_name};
use anyhow::Result;
use mapd_compiler::Compilation;
use serde::Serialize;
use std::io::Write;
use std::path::Path;

#[derive(Serialize)]
struct Document<'a> {
    file: &'a str,
    verdict: &'static str,
    stated_version: &'a str,
    checked_version: &'a str,
    findings: Vec<ReportedFinding<'a>>,
    quarantined: Vec<report::ReportedPart<'a>>,
    rules: Vec<Rule>,
    counts: report::Counts,
    not_kept: usize,
}

#[derive(Serialize)]
struct Rule {
    rule: &'static str,
    count: usize,
}

/// Writes one document.
pub(super) fn write(file: &Path, checked: &Compilation, out: &mut dyn Write) -> Result<()> {
    let name = file.display().to_string();
    let rules = super::by_rule(checked);
    let document = Document {
        file: &name,
        verdict: verdict_name(checked.verdict),
        stated_version: &checked.version.stated,
        checked_version: checked.version.checked,
        findings: checked.diagnostics.iter().map(|d| report::reported(&name, d)).collect(),
        quarantined: checked.quarantined.iter().map(report::part).collect(),
        rules: rules.into_iter().map(|(rule, count)| Rule { rule, count }).collect(),
        counts: report::counts(checked),
        not_kept: checked.dropped.iter().sum(),
    };
    serde_json::to_writer_pretty(&mut *out, &document)?;
    writeln!(out)?;
    Ok(())
}
