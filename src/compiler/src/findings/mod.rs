//! Findings of the compiler's own.

pub(crate) mod reading;
mod too_large;

pub(crate) use too_large::{
    TooLarge, too_large, too_large_in, too_many_ids, too_many_overlaps, too_much_behind, unfit,
};

use mapd_rules::Rule;
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity, Span, shorten_message};

/// An entry of the catalog, and how grave a finding of it is.
#[derive(Clone, Copy)]
pub(crate) struct Graded {
    pub(crate) rule: &'static Rule,
    pub(crate) severity: Severity,
}

/// The document has no roads.
pub(crate) fn no_roads() -> Finding {
    let (path, message) = ("OpenDRIVE".to_owned(), "the map has no roads".to_owned());
    finding(&building::NO_ROADS, Severity::Warning, Span::default(), path, message, "")
}

/// A finding of the compiler's own: as bad as its rule's usual ones, or milder.
pub(crate) fn finding(
    rule: &'static Rule,
    severity: Severity,
    span: Span,
    path: String,
    message: String,
    hint: &str,
) -> Finding {
    let severity = severity.min(rule.severity);
    let (path, message) = (shorten_message(path), shorten_message(message));
    let (rule, subject, hint) = (rule.id, "".into(), hint.to_owned());
    Finding { rule, severity, span, path, subject, message, hint, count: 1 }
}
