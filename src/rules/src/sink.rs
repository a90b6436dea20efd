//! Where rules put what they find.

use crate::checker::is_left_out;
use crate::examiner::RuleOutcome;
use crate::rule::{Minor, Rule};
use mapd_xodr::{Finding, Severity, Span, shorten_id, shorten_message};
use std::fmt::{self, Write as _};

/// What tells an element from others of its name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Key<'a> {
    /// It stands alone.
    None,
    /// `@id`.
    Id(&'a str),
    /// `@id` of a lane.
    Lane(i32),
    /// `@s` `[m]`.
    S(f64),
}

/// A step of the path to an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PathSegment<'a>(pub(crate) &'static str, pub(crate) Key<'a>);

/// Writes `OpenDRIVE/road[@id=7]/…`, and below it the path of a part, if there is one.
fn write_path(steps: &[PathSegment<'_>], part: &str) -> String {
    let mut path = String::from("OpenDRIVE");
    for PathSegment(name, key) in steps {
        // Writing to a string cannot fail.
        let _ = match key {
            Key::None => write!(path, "/{name}"),
            Key::Id(id) => write!(path, "/{name}[@id={}]", shorten_id(id)),
            Key::Lane(id) => write!(path, "/{name}[@id={id}]"),
            Key::S(s) => write!(path, "/{name}[@s={s}]"),
        };
    }
    if !part.is_empty() {
        path.push('/');
        path.push_str(part);
    }
    path
}

/// A part of a top-level element, for findings of rules on the network.
#[derive(Clone, Copy)]
pub struct PartOf<'a> {
    /// Tag of the top-level element.
    pub element: &'static str,
    /// Its id.
    pub id: &'a str,
    /// Path of the part from there; empty for the whole element.
    pub path: &'a str,
}

impl<'a> PartOf<'a> {
    /// A part of a road.
    pub fn road(id: &'a str, path: &'a str) -> Self {
        Self { element: "road", id, path }
    }

    /// A part of a junction.
    pub fn junction(id: &'a str, path: &'a str) -> Self {
        Self { element: "junction", id, path }
    }
}

/// Takes the findings of one rule about one element.
pub struct Sink<'a> {
    pub(crate) rule: &'static Rule,
    pub(crate) rank: usize,
    pub(crate) severity: Severity,
    pub(crate) mended: Severity,
    pub(crate) version: Minor,
    pub(crate) path: &'a [PathSegment<'a>],
    pub(crate) out: &'a mut Vec<(usize, RuleOutcome)>,
    /// Findings of the rule so far.
    pub(crate) count: &'a mut u32,
    pub(crate) limit: u32,
}

impl Sink<'_> {
    /// Version of the document.
    pub fn version(&self) -> Minor {
        self.version
    }

    /// A finding about the element, or something in it. `expected` and `found` say what.
    pub fn add(&mut self, span: Span, expected: impl fmt::Display, found: impl fmt::Display) {
        self.add_within("", span, expected, found);
    }

    /// A finding about a child of the element, named with its path from there.
    pub fn add_within(
        &mut self,
        part: &str,
        span: Span,
        expected: impl fmt::Display,
        found: impl fmt::Display,
    ) {
        let path = self.path;
        self.add_at(|| write_path(path, part), self.severity, span, expected, found);
    }

    /// A finding less bad than the rule's usual ones.
    pub fn add_milder(
        &mut self,
        severity: Severity,
        part: &str,
        span: Span,
        expected: impl fmt::Display,
        found: impl fmt::Display,
    ) {
        self.at_most(severity, |sink| sink.add_within(part, span, expected, found));
    }

    /// What is added within is about what is mended: in the default profile, that is a warning.
    pub(crate) fn as_mended(&mut self, add: impl FnOnce(&mut Self)) {
        self.at_most(self.mended, add);
    }

    /// What is added within is no worse than this.
    pub fn at_most(&mut self, severity: Severity, add: impl FnOnce(&mut Self)) {
        let before = self.severity;
        self.severity = severity.min(before);
        add(self);
        self.severity = before;
    }

    /// A finding about a part of a top-level element, for rules on the network.
    pub fn add_in(
        &mut self,
        part: PartOf<'_>,
        span: Span,
        expected: impl fmt::Display,
        found: impl fmt::Display,
    ) {
        let path = || write_path(&[PathSegment(part.element, Key::Id(part.id))], part.path);
        self.add_at(path, self.severity, span, expected, found);
    }

    /// A finding with its own path.
    pub(crate) fn add_at(
        &mut self,
        path: impl FnOnce() -> String,
        severity: Severity,
        span: Span,
        expected: impl fmt::Display,
        found: impl fmt::Display,
    ) {
        *self.count = self.count.saturating_add(1);
        if is_left_out(*self.count, self.limit, severity) {
            match self.out.last_mut() {
                Some((rank, RuleOutcome::LeftOut(_, of, count)))
                    if *rank == self.rank && *of == severity =>
                {
                    *count = count.saturating_add(1);
                }
                _ => self.out.push((self.rank, RuleOutcome::LeftOut(span, severity, 1))),
            }
            return;
        }
        let message = shorten_message(format!("expected {expected}, found {found}"));
        let rule = self.rule.id;
        let (path, subject, hint) = (shorten_message(path()), "".into(), String::new());
        let finding = Finding { rule, severity, span, path, subject, message, hint, count: 1 };
        self.out.push((self.rank, RuleOutcome::Finding(finding)));
    }
}
