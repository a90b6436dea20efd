//! Findings as they are made: the first of each kind are kept, more are counted.

use crate::finding::{Finding, Severity, Span};
use std::collections::HashMap;

/// What findings have in common: the rule, the type of element, and what of it is concerned.
type Kind = (&'static str, &'static str, Box<str>);

/// Kinds that are told apart; all others of a rule are one kind.
const KINDS: usize = 1024;
/// Bytes of a message or a path that are kept.
const SHOWN_BYTES: usize = 1024;
/// Bytes of what a kind is about that are looked at.
const DETAIL_BYTES: usize = 64;

/// Findings beyond those kept, of one kind.
struct More {
    severity: Severity,
    /// The first that was not kept.
    span: Span,
    path: String,
    count: usize,
}

/// Collects findings.
pub(crate) struct Findings {
    kept: Vec<Finding>,
    counts: HashMap<Kind, (u32, Option<usize>)>,
    more: Vec<(Kind, More)>,
    limit: u32,
    /// Errors so far, kept or not.
    pub(crate) errors: usize,
}

impl Findings {
    pub(crate) fn new(limit: u32) -> Self {
        Self { kept: Vec::new(), counts: HashMap::new(), more: Vec::new(), limit, errors: 0 }
    }

    /// Adds a finding; `make` yields its path and message, and is asked only where it is kept.
    pub(crate) fn add(
        &mut self,
        rule: &'static str,
        severity: Severity,
        span: Span,
        (element, detail): (&'static str, &str),
        make: impl FnOnce() -> (String, String),
    ) {
        self.errors += usize::from(severity == Severity::Error);
        let mut kind = (rule, element, Box::from(shorten(detail, DETAIL_BYTES)));
        if self.counts.len() >= KINDS && !self.counts.contains_key(&kind) {
            kind = (rule, "", Box::default());
        }
        let (count, more) = match self.counts.get_mut(&kind) {
            Some(known) => known,
            None => self.counts.entry(kind.clone()).or_default(),
        };
        *count = count.saturating_add(1);
        if *count <= self.limit {
            let (path, message) = make();
            let (path, message) = (shown(path), shown(message));
            let subject = shorten(detail, DETAIL_BYTES).into();
            self.kept.push(Finding {
                rule,
                severity,
                span,
                path,
                subject,
                message,
                hint: String::new(),
            });
            return;
        }
        match more.and_then(|at| self.more.get_mut(at)) {
            Some((_, more)) => {
                more.count += 1;
                more.severity = more.severity.max(severity);
            }
            None => {
                *more = Some(self.more.len());
                let path = shown(make().0);
                self.more.push((kind, More { severity, span, path, count: 1 }));
            }
        }
    }

    /// The document has ended: one finding for each kind that had more than are kept.
    pub(crate) fn finish(&mut self) {
        for ((rule, element, detail), more) in self.more.drain(..) {
            let what = match (element, &*detail) {
                ("", "") => "whatever they are about".to_owned(),
                (what, "") | ("", what) => what.to_owned(),
                (element, detail) => format!("{element}, {detail}"),
            };
            let message =
                format!("{} more findings like this ({what}), the first of them here", more.count);
            let (severity, span, path) = (more.severity, more.span, more.path);
            let subject = detail;
            self.kept.push(Finding {
                rule,
                severity,
                span,
                path,
                subject,
                message,
                hint: String::new(),
            });
        }
    }

    /// Takes the findings since the last call.
    pub(crate) fn take(&mut self) -> Vec<Finding> {
        std::mem::take(&mut self.kept)
    }
}

/// The beginning of a text, of at most so many bytes.
pub(crate) fn shorten(text: &str, bytes: usize) -> &str {
    let end = (0..=bytes.min(text.len())).rev().find(|end| text.is_char_boundary(*end));
    text.get(..end.unwrap_or_default()).unwrap_or(text)
}

/// A text as findings keep it.
fn shown(text: String) -> String {
    match shorten(&text, SHOWN_BYTES) {
        short if short.len() < text.len() => format!("{short}…"),
        _ => text,
    }
}
