//! Findings as they are made: the first of each kind are kept, more are counted.

use crate::counted::CountedFindings;
use crate::finding::{Finding, Severity, Span, shorten, shorten_message};
use crate::limits::Limits;
use std::collections::HashMap;
use std::sync::Arc;

/// What findings have in common: the rule, how bad they are, the type of element, and what of it is concerned.
type Kind = (&'static str, Severity, &'static str, Arc<str>);

/// Kinds that are told apart; all others of a rule are one kind.
const KINDS: usize = 1024;
/// Bytes of what a kind is about that are looked at.
const DETAIL_BYTES: usize = 64;

/// Findings so far by kind, and the place of those beyond the kept ones.
pub(crate) type Counts = HashMap<Kind, (u32, Option<usize>)>;

/// Findings beyond those kept, of one kind.
struct More {
    /// The first that was not kept.
    span: Span,
    path: String,
    count: u32,
}

/// A finding that is kept.
pub(crate) struct KeptFinding {
    finding: Finding,
    /// Type of the element that it is about, which is part of its kind.
    element: &'static str,
    /// Name of that element's tag, and of the top-level element that it is in.
    tag: &'static str,
    top: &'static str,
}

/// What a finding is about.
#[derive(Clone, Copy)]
pub(crate) struct About<'a> {
    /// Type of the element; empty where it is about none.
    pub(crate) element: &'static str,
    /// Name of the element's tag; empty where it is about none of the schema.
    pub(crate) tag: &'static str,
    /// Name of the tag of the top-level element that it is in; empty where it is in none of the schema.
    pub(crate) top: &'static str,
    /// Tells findings of one rule about such elements apart.
    pub(crate) detail: &'a str,
}

impl<'a> About<'a> {
    /// About the text as such.
    pub(crate) fn text(detail: &'a str) -> Self {
        Self { element: "", tag: "", top: "", detail }
    }
}

/// What becomes of a finding, by its number among those of its kind.
enum FindingFate {
    KeptFinding,
    /// The first that is not.
    First,
    /// One more of those, by their place.
    Later(usize),
}

/// Collects findings.
pub(crate) struct Findings {
    kept: Vec<KeptFinding>,
    counts: Counts,
    more: Vec<(Kind, More)>,
    /// Places of those of `more` that building may run into as well, or of all.
    counted: CountedFindings,
    limit: u32,
    /// Whether `counted` takes all of them.
    places_of_all: bool,
    /// Errors so far, kept or not.
    pub(crate) errors: usize,
}

impl Findings {
    pub(crate) fn new(limits: &Limits) -> Self {
        Self::behind(limits, Counts::new())
    }

    /// A collector for a part of a document, with what [`Findings::used_up`] says of what stands before it.
    pub(crate) fn behind(limits: &Limits, counts: Counts) -> Self {
        Self {
            kept: Vec::new(),
            counts,
            more: Vec::new(),
            counted: CountedFindings::default(),
            limit: limits.findings_of_a_kind,
            places_of_all: limits.places_of_all,
            errors: 0,
        }
    }

    /// Kinds of which no more are kept, so that a collector for what comes later need not keep any: half as many as are told apart,
    /// so that it has room for others.
    pub(crate) fn used_up(&self) -> Counts {
        let kinds = self.more.iter().take(KINDS / 2);
        kinds.map(|(kind, _)| (kind.clone(), (self.limit, None))).collect()
    }

    /// Adds a finding; `make` yields its path and message, and is asked only where it is kept.
    pub(crate) fn add(
        &mut self,
        rule: &'static str,
        severity: Severity,
        span: Span,
        about: About<'_>,
        make: impl FnOnce() -> (String, String),
    ) {
        self.errors += usize::from(severity == Severity::Error);
        let About { element, tag, top, detail } = about;
        let (kind, fate) = self.fate(rule, severity, element, detail, 1);
        if !matches!(fate, FindingFate::KeptFinding) {
            self.remember(rule, severity, span, about);
        }
        match fate {
            FindingFate::KeptFinding => {
                let (path, message) = make();
                let (path, message) = (shorten_message(path), shorten_message(message));
                let subject = shorten(detail, DETAIL_BYTES).into();
                let hint = String::new();
                let finding =
                    Finding { rule, severity, span, path, subject, message, hint, count: 1 };
                self.kept.push(KeptFinding { finding, element, tag, top });
            }
            FindingFate::First => {
                let path = shorten_message(make().0);
                self.more.push((kind, More { span, path, count: 1 }));
            }
            FindingFate::Later(at) => self.more_of(at, 1),
        }
    }

    /// Keeps the place of a finding that is only counted, where it says that a value is not there or the caller wants all.
    fn remember(
        &mut self,
        rule: &'static str,
        severity: Severity,
        span: Span,
        About { tag, top, detail, .. }: About<'_>,
    ) {
        if self.places_of_all || CountedFindings::takes(rule) {
            let subject = Arc::from(shorten(detail, DETAIL_BYTES));
            self.counted.push((rule, severity, tag, top, subject), span.start);
        }
    }

    /// Counts findings of a kind; what becomes of the first of them.
    fn fate(
        &mut self,
        rule: &'static str,
        severity: Severity,
        element: &'static str,
        detail: &str,
        count: u32,
    ) -> (Kind, FindingFate) {
        let mut kind = (rule, severity, element, Arc::from(shorten(detail, DETAIL_BYTES)));
        if self.counts.len() >= KINDS && !self.counts.contains_key(&kind) {
            kind = (rule, severity, "", Arc::from(""));
        }
        let (counted, more) = match self.counts.get_mut(&kind) {
            Some(known) => known,
            None => self.counts.entry(kind.clone()).or_default(),
        };
        *counted = counted.saturating_add(count);
        let fate = match *more {
            _ if *counted <= self.limit => FindingFate::KeptFinding,
            Some(at) => FindingFate::Later(at),
            None => {
                *more = Some(self.more.len());
                FindingFate::First
            }
        };
        (kind, fate)
    }

    fn more_of(&mut self, at: usize, count: u32) {
        if let Some((_, more)) = self.more.get_mut(at) {
            more.count = more.count.saturating_add(count);
        }
    }

    /// Number of those kept that were not taken yet.
    pub(crate) fn kept(&self) -> usize {
        self.kept.len()
    }

    /// Takes what is kept since the last call, for [`Findings::add_again`].
    pub(crate) fn take_kept(&mut self) -> Vec<KeptFinding> {
        std::mem::take(&mut self.kept)
    }

    /// Adds a finding that another collector has kept.
    pub(crate) fn add_again(&mut self, kept: KeptFinding) {
        let KeptFinding { finding, element, tag, top } = &kept;
        let (rule, severity, span) = (finding.rule, finding.severity, finding.span);
        let (kind, fate) = self.fate(rule, severity, element, &finding.subject, 1);
        if !matches!(fate, FindingFate::KeptFinding) {
            let about = About { element, tag, top, detail: &finding.subject };
            self.remember(rule, severity, span, about);
        }
        match fate {
            FindingFate::KeptFinding => self.kept.push(kept),
            FindingFate::First => {
                self.more.push((kind, More { span, path: kept.finding.path, count: 1 }));
            }
            FindingFate::Later(at) => self.more_of(at, 1),
        }
    }

    /// Adds what another collector has only counted, after all that it kept.
    pub(crate) fn add_counts(&mut self, other: Self) {
        self.errors += other.errors;
        for ((rule, severity, element, detail), more) in other.more {
            let (kind, fate) = self.fate(rule, severity, element, &detail, more.count);
            match fate {
                // There are as many before it as are kept, for the other collector has the same limit.
                FindingFate::KeptFinding | FindingFate::First => self.more.push((kind, more)),
                FindingFate::Later(at) => self.more_of(at, more.count),
            }
        }
    }

    /// Whether kinds are no longer told apart: then it matters in which order findings came.
    pub(crate) fn is_full(&self) -> bool {
        self.counts.len() >= KINDS
    }

    /// The document has ended: one finding for each kind that had more than are kept.
    pub(crate) fn finish(&mut self) {
        for ((rule, severity, element, detail), more) in self.more.drain(..) {
            let what = match (element, &*detail) {
                ("", "") => "whatever they are about".to_owned(),
                (what, "") | ("", what) => what.to_owned(),
                (element, detail) => format!("{element}, {detail}"),
            };
            let more_than_none = if self.limit == 0 { "" } else { " more" };
            let message = match more.count {
                1 => format!("one{more_than_none} finding like this ({what})"),
                count => format!(
                    "{count}{more_than_none} findings like this ({what}), the first of them here"
                ),
            };
            let More { span, path, count } = more;
            let (subject, hint) = ((&*detail).into(), String::new());
            let finding = Finding { rule, severity, span, path, subject, message, hint, count };
            self.kept.push(KeptFinding { finding, element, tag: "", top: "" });
        }
    }

    /// Takes the places of what was only counted.
    pub(crate) fn take_counted(&mut self) -> CountedFindings {
        std::mem::take(&mut self.counted)
    }

    /// What [`Findings::take_counted`] takes is from here on what another collector had for it, and what is found then.
    pub(crate) fn set_counted(&mut self, counted: CountedFindings) {
        self.counted = counted;
    }

    /// Takes the findings since the last call.
    pub(crate) fn take(&mut self) -> Vec<Finding> {
        std::mem::take(&mut self.kept).into_iter().map(|kept| kept.finding).collect()
    }
}
