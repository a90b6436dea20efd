//! Findings as SARIF 2.1.0, which code review tools read.

use crate::report::verdict_name;
use anyhow::Result;
use mapd_compiler::{Compilation, Diagnostic};
use mapd_rules::catalog;
use mapd_xodr::Severity;
use mapd_xodr::source::Places;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;

const SCHEMA: &str =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

/// SARIF's word for a severity.
fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Info => "note",
        Severity::Warning => "warning",
        Severity::Error => "error",
    }
}

/// A path as a URI reference.
fn uri(path: &str) -> String {
    use std::fmt::Write as _;
    path.bytes().fold(String::new(), |mut out, byte| {
        if byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte) {
            out.push(char::from(byte));
        } else {
            // Writing to a string cannot fail.
            let _ = write!(out, "%{byte:02X}");
        }
        out
    })
}

/// Writes one log with one run.
pub(super) fn write(file: &Path, checked: &Compilation, out: &mut dyn Write) -> Result<()> {
    let name = file.display().to_string();
    let mut found: BTreeMap<&str, usize> =
        checked.diagnostics.iter().map(|d| (d.finding.rule, 0)).collect();
    for (index, value) in found.values_mut().enumerate() {
        *value = index;
    }
    let meanings: BTreeMap<&str, &mapd_rules::Rule> =
        catalog::all().map(|rule| (rule.id, rule)).collect();
    let rules: Vec<Value> = found
        .keys()
        .map(|id| match meanings.get(id) {
            Some(rule) => json!({
                "id": id,
                "shortDescription": { "text": rule.meaning },
                "defaultConfiguration": { "level": level(rule.severity) },
            }),
            None => json!({ "id": id }),
        })
        .collect();
    let result = |d: &Diagnostic| {
        let index = found.get(d.finding.rule).copied().unwrap_or(0);
        result(&name, d, index)
    };
    let results: Vec<Value> = checked.diagnostics.iter().map(result).collect();
    let log = json!({
        "$schema": SCHEMA,
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "mapd",
                "version": env!("CARGO_PKG_VERSION"),
                "rules": rules,
            }},
            "artifacts": [{ "location": { "uri": uri(&name) } }],
            "results": results,
            "properties": {
                "verdict": verdict_name(checked.verdict),
                "statedVersion": checked.version.stated,
                "checkedVersion": checked.version.checked,
                "quarantined": checked.quarantined.len(),
                "notKept": checked.dropped.iter().sum::<usize>(),
            },
        }],
    });
    serde_json::to_writer_pretty(&mut *out, &log)?;
    writeln!(out)?;
    Ok(())
}

fn result(main: &str, d: &Diagnostic, index: usize) -> Value {
    let finding = &d.finding;
    let file = if d.file.is_empty() { main } else { &d.file };
    // Columns of SARIF count characters, ours bytes: the offset is the exact place.
    json!({
        "ruleId": finding.rule,
        "ruleIndex": index,
        "level": level(finding.severity),
        "message": { "text": finding.message },
        "locations": [{
            "physicalLocation": {
                "artifactLocation": { "uri": uri(file) },
                "region": {
                    "startLine": d.line.max(1),
                    "byteOffset": Places::offset_of(finding.span.start),
                    "byteLength": finding.span.len,
                },
            },
            "logicalLocations": [{ "fullyQualifiedName": finding.path, "kind": "element" }],
        }],
        "properties": { "column": d.column, "takesOut": d.rejects },
    })
}
