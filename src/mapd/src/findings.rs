//! What was found in a file, as the page has it.

use crate::report::severity_name;
use mapd_client::Snapshot;
use mapd_compiler::{Compilation, Diagnostic};
use mapd_web::page::{Findings, ReportedFinding};

/// The findings of a map; not known where it was not compiled just now.
pub(crate) fn of(snapshot: &Snapshot, compiled: Option<&Compilation>) -> Findings {
    let Some(compiled) = compiled else { return Findings::UNKNOWN };
    let reported =
        compiled.diagnostics.iter().map(|Diagnostic { finding, file, line, column, .. }| {
            ReportedFinding {
                severity: severity_name(finding.severity),
                rule: finding.rule,
                message: &finding.message,
                hint: &finding.hint,
                path: &finding.path,
                file,
                line: *line,
                column: *column,
            }
        });
    Findings::of(snapshot.map(), reported, compiled.dropped.iter().sum())
}
