//! Why something is left out.

use mapd_xodr::source::SourceLocation;
use mapd_xodr::{Finding, rule_ids};
use std::sync::Arc;

/// Top-level elements that are parts, or have parts within.
const PARTS: [&str; 6] = ["road", "junction", "controller", "junctionGroup", "station", "vmsGroup"];

/// A finding because of which something is left out.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cause {
    pub(crate) rule: &'static str,
    /// Where the finding stands.
    pub(crate) start: u64,
    pub(crate) message: String,
    /// Name of the included file that it stands in; empty for the document itself.
    pub(crate) file: Arc<str>,
    pub(crate) line: u32,
    pub(crate) column: u32,
    /// Whether it stands in no part, whichever part begins before it.
    pub(crate) is_outside: bool,
    /// Whether nothing can be built with the part.
    pub(crate) stops: bool,
}

/// Whether a finding stands in no part: in the header, or at the root, as of a file that was to be included there. No part may be left out for it.
pub(crate) fn is_outside(finding: &Finding) -> bool {
    let below = finding.path.split('/').nth(1).unwrap_or_default();
    let element = below.split('[').next().unwrap_or_default();
    !PARTS.contains(&element)
}

impl Cause {
    /// As a finding tells it, which stands at a place; whether nothing can be built with the part.
    pub(crate) fn new(finding: &Finding, place: &SourceLocation, stops: bool) -> Self {
        let (rule, start, message) = (finding.rule, finding.span.start, finding.message.clone());
        let (line, column) = (place.position.line, place.position.column);
        let (file, is_outside) = (place.file.clone(), is_outside(finding));
        Self { rule, start, message, file, line, column, is_outside, stops }
    }

    /// Whether leaving something out would help: not where the document cannot be read on, or nobody knows what is missing.
    pub(crate) fn can_be_left_out(&self) -> bool {
        !self.is_outside && !self.ends_reading()
    }

    /// Whether nobody knows what else the document has: it cannot be read on, or lacks a file.
    pub(crate) fn hides_parts(&self) -> bool {
        self.ends_reading() || self.rule == rule_ids::INCLUDE
    }

    fn ends_reading(&self) -> bool {
        matches!(
            self.rule,
            rule_ids::XML
                | rule_ids::LIMIT
                | rule_ids::ENCODING
                | rule_ids::COMPRESSION
                | rule_ids::ROOT
        )
    }
}
