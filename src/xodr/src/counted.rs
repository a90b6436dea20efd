//! Findings that are only counted: those that say of an attribute that its value is not there, or all.

use crate::finding::Severity;
use crate::rule_ids;
use std::collections::HashMap;
use std::sync::Arc;

/// A finding that was only counted: it may be an error that takes out what it belongs to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CountedFinding {
    /// Id of the rule that found it.
    pub rule: &'static str,
    /// How bad it is.
    pub severity: Severity,
    /// Name of the element's tag.
    pub tag: &'static str,
    /// Name of the tag of the top-level element that it is in; empty where it is in none of the schema.
    pub top: &'static str,
    /// Name of the attribute or child that it is about.
    pub subject: Arc<str>,
    /// First byte of where it stands, as of a [`Span`](crate::Span).
    pub start: u64,
}

/// What findings of one kind have in common.
pub(crate) type CountedKind = (&'static str, Severity, &'static str, &'static str, Arc<str>);

/// Such findings about one top-level element. A hostile one has millions, so that each is no more than its place and its kind.
#[derive(Clone, Debug, Default)]
pub struct CountedFindings {
    kinds: Vec<CountedKind>,
    ranks: HashMap<CountedKind, u32>,
    starts: Vec<u64>,
    kind_of: Vec<u32>,
}

impl CountedFindings {
    /// Whether building may be about what such a rule finds.
    pub(crate) fn takes(rule: &'static str) -> bool {
        matches!(rule, rule_ids::MISSING | rule_ids::EMPTY | rule_ids::VALUE | rule_ids::FINITE)
    }

    pub(crate) fn push(&mut self, kind: CountedKind, start: u64) {
        let Self { kinds, ranks, starts, kind_of } = self;
        let rank = *ranks.entry(kind).or_insert_with_key(|kind| {
            kinds.push(kind.clone());
            kinds.len() as u32 - 1
        });
        starts.push(start);
        kind_of.push(rank);
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.starts.is_empty()
    }

    /// Each of them, in no order.
    pub fn iter(&self) -> impl Iterator<Item = CountedFinding> {
        self.starts.iter().zip(&self.kind_of).filter_map(|(start, rank)| {
            let (rule, severity, tag, top, subject) = self.kinds.get(*rank as usize)?.clone();
            Some(CountedFinding { rule, severity, tag, top, subject, start: *start })
        })
    }
}
