//! Why something is left out.

use mapd_xodr::rule_ids;
use std::sync::Arc;

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
}

impl Cause {
    /// Whether leaving something out would help: not where the document cannot be read on.
    pub(crate) fn can_be_left_out(&self) -> bool {
        !matches!(
            self.rule,
            rule_ids::XML
                | rule_ids::LIMIT
                | rule_ids::ENCODING
                | rule_ids::COMPRESSION
                | rule_ids::ROOT
        )
    }
}
