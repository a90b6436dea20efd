//! What rows are built from: it is there, or a finding says that the map cannot be built without it.

use mapd_xodr::{Finding, Severity, Span};

/// Something that the map is built from is absent or cannot be used. Where the reader has a finding about the same, that
/// one stands for this one; see `Collector`.
pub(crate) const UNUSABLE: &str = "mapd:compile.unusable";

/// An element that rows are built from, and where findings about it go.
pub(crate) struct Part<'a> {
    /// The element's start tag.
    pub(crate) span: Span,
    /// Path of the road or junction, and of the element inside.
    pub(crate) path: (&'a str, &'a str),
    pub(crate) findings: &'a mut Vec<Finding>,
}

impl Part<'_> {
    /// The value of an attribute without which nothing can be built.
    pub(crate) fn need<T>(&mut self, value: Option<T>, name: &str) -> Option<T> {
        if value.is_none() {
            let message = format!("expected @{name}, found none that can be used");
            self.unusable(name, message);
        }
        value
    }

    /// Adds the finding that something cannot be used: an attribute or child by its name, or with no name the element.
    pub(crate) fn unusable(&mut self, subject: &str, message: String) {
        let finding = self.finding(UNUSABLE, Severity::Error, message);
        self.findings.push(Finding { subject: subject.into(), ..finding });
    }

    /// Adds a finding about the element.
    pub(crate) fn add(&mut self, rule: &'static str, severity: Severity, message: String) {
        let finding = self.finding(rule, severity, message);
        self.findings.push(finding);
    }

    fn finding(&self, rule: &'static str, severity: Severity, message: String) -> Finding {
        let (base, tail) = self.path;
        let path = if tail.is_empty() { base.to_owned() } else { format!("{base}/{tail}") };
        crate::finding(rule, severity, self.span, path, message, "")
    }
}
