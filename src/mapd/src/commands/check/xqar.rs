//! Findings as `.xqar`, the result file of ASAM's quality checker framework.

use anyhow::Result;
use mapd_compiler::{Compilation, Diagnostic};
use mapd_rules::catalog;
use mapd_xodr::{Severity, rule_ids};
use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;

/// The framework's levels: 1 error, 2 warning, 3 information.
fn level(severity: Severity) -> u8 {
    match severity {
        Severity::Error => 1,
        Severity::Warning => 2,
        Severity::Info => 3,
    }
}

/// A rule's id in the form that the framework demands: entity with a dot, standard, version, name of words.
fn uid(rule: &str) -> String {
    let rule = rule_ids::asam(rule).unwrap_or(rule);
    let parts: Vec<&str> = rule.split(':').collect();
    let (entity, version, name) = match parts[..] {
        [entity, "xodr", version, name] => (entity, version, name),
        [_, name] => ("mapd", "1.4.0", name),
        _ => ("mapd", "1.4.0", "other"),
    };
    let entity = if entity == "mapd" { "mapd.rules" } else { entity };
    // One id of ASAM's own annex has the version 1.x.0.
    let version = version.replace('x', "9");
    format!("{entity}:xodr:{version}:{}", name.replace('-', "_"))
}

/// Text for an attribute.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            // What XML cannot have, and line breaks, which it would not keep.
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// Writes one bundle with a checker for each rule.
pub(super) fn write(file: &Path, checked: &Compilation, out: &mut dyn Write) -> Result<()> {
    let mut rules: BTreeMap<String, (&str, Vec<&Diagnostic>)> =
        catalog::all().map(|rule| (uid(rule.id), (rule.meaning, Vec::new()))).collect();
    for d in &checked.diagnostics {
        rules.entry(uid(d.finding.rule)).or_default().1.push(d);
    }
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for (_, rule, count) in checked.counts.iter() {
        *counts.entry(uid(rule)).or_default() += count;
    }
    let count: usize = counts.values().sum();
    writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>")?;
    writeln!(out, "<CheckerResults version=\"1.0.0\">")?;
    writeln!(
        out,
        "  <CheckerBundle build_date=\"\" description=\"mapd check\" name=\"mapd\" summary=\"{count} findings\" version=\"{}\">",
        env!("CARGO_PKG_VERSION")
    )?;
    let name = escaped(&file.display().to_string());
    writeln!(out, "    <Param name=\"InputFile\" value=\"{name}\"/>")?;
    let mut id = 0;
    for (uid, (meaning, diagnostics)) in &rules {
        let checker = uid.replace([':', '.'], "_");
        writeln!(
            out,
            "    <Checker checkerId=\"{checker}\" description=\"{}\" status=\"completed\" summary=\"{} findings\">",
            escaped(meaning),
            counts.get(uid).copied().unwrap_or_default()
        )?;
        writeln!(out, "      <AddressedRule ruleUID=\"{uid}\"/>")?;
        for d in diagnostics {
            let finding = &d.finding;
            writeln!(
                out,
                "      <Issue description=\"{}\" issueId=\"{id}\" level=\"{}\" ruleUID=\"{uid}\">",
                escaped(&finding.message),
                level(finding.severity)
            )?;
            writeln!(out, "        <Locations description=\"{}\">", escaped(&finding.path))?;
            writeln!(out, "          <FileLocation column=\"{}\" row=\"{}\"/>", d.column, d.line)?;
            writeln!(out, "        </Locations>")?;
            writeln!(out, "      </Issue>")?;
            id += 1;
        }
        writeln!(out, "    </Checker>")?;
    }
    writeln!(out, "  </CheckerBundle>\n</CheckerResults>")?;
    Ok(())
}
