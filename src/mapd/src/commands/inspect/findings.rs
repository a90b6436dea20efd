//! What `mapd inspect` says of what is wrong with a file.

use crate::report::{self, severity_name};
use mapd_compiler::Compilation;
use mapd_xodr::Severity;
use serde::Serialize;
use std::io::{Result, Write};

/// Rules that are told one by one to people.
const MOST_RULES: usize = 10;

/// How many findings a file has.
#[derive(Serialize)]
pub(super) struct FindingFacts {
    #[serde(flatten)]
    counts: report::Counts,
    /// Errors first, then those with most findings.
    by_rule: Vec<RuleFacts>,
    /// How many more there are than a report of the file lists.
    not_kept: usize,
}

#[derive(Serialize)]
struct RuleFacts {
    rule: &'static str,
    severity: &'static str,
    count: usize,
}

impl FindingFacts {
    pub(super) fn of(compiled: &Compilation) -> Self {
        let mut rules: Vec<_> = compiled.counts.iter().collect();
        rules
            .sort_by_key(|(severity, rule, count)| (std::cmp::Reverse((*severity, *count)), *rule));
        let facts =
            |(severity, rule, count)| RuleFacts { rule, severity: severity_name(severity), count };
        Self {
            counts: report::counts(compiled),
            by_rule: rules.into_iter().map(facts).collect(),
            not_kept: compiled.dropped.iter().sum(),
        }
    }

    /// Tells people: errors and warnings by their rules, information as a number.
    ///
    /// Errors: writing fails.
    pub(super) fn print(&self, source: &str, out: &mut dyn Write) -> Result<()> {
        let report::Counts { errors, warnings, information } = self.counts;
        if errors + warnings + information == 0 {
            return writeln!(out, "findings      none");
        }
        let [errors, warnings] = [(errors, "error"), (warnings, "warning")]
            .map(|(count, name)| format!("{count} {name}{}", if count == 1 { "" } else { "s" }));
        writeln!(
            out,
            "findings      {errors}, {warnings}, {information} of information; `mapd check {source}` says where"
        )?;
        let info = severity_name(Severity::Info);
        let told: Vec<_> = self.by_rule.iter().filter(|rule| rule.severity != info).collect();
        for RuleFacts { rule, severity, count } in told.iter().take(MOST_RULES) {
            writeln!(out, "  {severity:<9} {count:>6}: {rule}")?;
        }
        if told.len() > MOST_RULES {
            writeln!(out, "  and {} more rules; --json lists all", told.len() - MOST_RULES)?;
        }
        Ok(())
    }
}
