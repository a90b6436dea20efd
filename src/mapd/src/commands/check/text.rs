//! Findings for people.

use super::excerpt::excerpts;
use crate::colour::Colours;
use crate::printable::{printable, shown};
use crate::report::{Folding, counts, severity_name, verdict_name};
use anyhow::Result;
use mapd_compiler::{Compilation, Verdict};
use std::io::Write;
use std::path::Path;

/// Writes the findings in file order, of each rule the first few or `all`, then how many there are of each rule, then the verdict.
pub(super) fn write(
    file: &Path,
    checked: &Compilation,
    all: bool,
    out: &mut dyn Write,
) -> Result<()> {
    let name = shown(file);
    let excerpts = excerpts(file, &checked.diagnostics);
    let colours = Colours::of(&std::io::stdout());
    let (mut folding, mut folded, mut folded_kept) = (Folding::default(), 0, 0);
    for (d, excerpt) in checked.diagnostics.iter().zip(excerpts) {
        if !folding.tells(d) && !all {
            folded += d.finding.count as usize;
            folded_kept += 1;
            continue;
        }
        let f = &d.finding;
        let place = if d.file.is_empty() { name.as_str() } else { &d.file };
        let severity = colours.severity(f.severity, severity_name(f.severity));
        let rejects = match checked.verdict {
            _ if !d.rejects => "",
            Verdict::Quarantined => ", takes out the part",
            _ => ", rejects the map",
        };
        writeln!(
            out,
            "{}:{}:{}: {severity}[{}]{rejects}: {}",
            printable(place),
            d.line,
            d.column,
            f.rule,
            printable(&f.message)
        )?;
        if !f.path.is_empty() {
            writeln!(out, "    at {}", printable(&f.path))?;
        }
        if let Some(excerpt) = excerpt {
            let number = d.line.to_string();
            writeln!(out, " {number} | {}", excerpt.text)?;
            writeln!(
                out,
                " {:number$} | {:before$}^",
                "",
                "",
                number = number.len(),
                before = excerpt.before
            )?;
        }
        if !f.hint.is_empty() {
            writeln!(out, "    hint: {}", printable(&f.hint))?;
        }
    }
    if folded_kept > 0 && folded <= folded_kept {
        writeln!(out, "{folded_kept} more findings of these rules; --all tells each")?;
    } else if folded_kept > 0 {
        writeln!(
            out,
            "{folded} more findings of these rules; --all tells the first of them, the others are only counted"
        )?;
    }
    for (rule, count) in super::by_rule(checked) {
        writeln!(out, "{count:7} {rule}")?;
    }
    for part in &checked.quarantined {
        writeln!(
            out,
            "{name}:{}:{}: {} is {}: {}",
            part.line,
            part.column,
            printable(&part.name()),
            crate::report::treated(part.treatment),
            part.rule
        )?;
    }
    let counts = counts(checked);
    let version = &checked.version;
    let stated = if version.stated.is_empty() { "no revision" } else { &version.stated };
    let stated = printable(stated);
    let verdict = verdict_name(checked.verdict);
    writeln!(
        out,
        "{name}: {verdict}; states {stated}, checked as {}; errors {}, warnings {}, information {}",
        version.checked, counts.errors, counts.warnings, counts.information
    )?;
    Ok(())
}
