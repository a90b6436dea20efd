//! Shows a document to the rules, element by element.

use crate::examiner::{Examined, ExaminedItem, Examiner, RuleOutcome, Rules};
use crate::line::ReferenceLine;
use crate::network::Network;
use crate::rule::{Minor, NEWEST};
use crate::settings::Settings;
use crate::whole::Whole;
use mapd_xodr::{Finding, Item, Severity, Span};
use std::sync::Arc;

/// Oldest version that the rules know.
const OLDEST: Minor = 4;

/// Findings of a rule that are not kept, information and warnings by themselves: the place of the first, how many.
type LeftOut = [Option<(Span, u32)>; 2];

/// Their severities.
const LEFT_OUT: [Severity; 2] = [Severity::Info, Severity::Warning];

/// Checks a document while it streams by.
pub struct Checker {
    settings: Settings,
    examiner: Examiner,
    /// By rule.
    left_out: Vec<LeftOut>,
    findings: Vec<Finding>,
}

impl Checker {
    /// A checker with nothing seen yet. Until a header says otherwise, documents are of the newest version.
    pub fn new(settings: &Settings) -> Self {
        let examiner = Examiner::new(Rules::new(settings, NEWEST));
        let left_out = vec![LeftOut::default(); examiner.counts.len()];
        Self { settings: settings.clone(), examiner, left_out, findings: Vec::new() }
    }

    /// Looks at a top-level element, and keeps what the rules on the network need of it; yields its reference line, if it has
    /// one. Once the rules have looked at their order, a road's records are sorted.
    pub fn item(&mut self, item: &mut Item) -> ReferenceLine {
        self.select(item);
        let ExaminedItem { found, line } = self.examiner.item(item);
        self.keep(found);
        line
    }

    /// Looks at a top-level element by itself: to the rules on the network it is not there. Of a road the network keeps its id.
    pub fn item_apart(&mut self, item: &mut Item) -> ReferenceLine {
        self.select(item);
        let line = self.examiner.examine(item);
        if let Item::Road(road) = item {
            self.examiner.network.add_apart(road);
        }
        let examined = Examined(std::mem::take(&mut self.examiner.found));
        self.keep(examined);
        line
    }

    /// Looks at elements behind the header, on any thread; what it finds comes back with [`Checker::examined`].
    pub fn examiner(&self) -> Examiner {
        self.examiner.another()
    }

    /// Takes what was found in the next top-level element.
    pub fn examined(&mut self, examined: Examined) {
        let limit = self.examiner.rules.limit;
        let decided = examined.0.into_iter().map(|(rank, found)| {
            let more = if let RuleOutcome::LeftOut(_, _, count) = found { count } else { 1 };
            let count = self.examiner.counts.get_mut(rank).map_or(0, |count| {
                *count = count.saturating_add(more);
                *count
            });
            match found {
                RuleOutcome::Finding(finding) if is_left_out(count, limit, finding.severity) => {
                    (rank, RuleOutcome::LeftOut(finding.span, finding.severity, 1))
                }
                found => (rank, found),
            }
        });
        let decided = Examined(decided.collect());
        self.keep(decided);
    }

    /// What the rules on the network need of the elements so far. Whoever puts parts of it together elsewhere takes it away, and brings it back
    /// before the next element is shown.
    pub fn network_mut(&mut self) -> &mut Network {
        &mut self.examiner.network
    }

    /// Chooses the rules for the version that a header states.
    fn select(&mut self, item: &Item) {
        let Item::Header(header) = item else { return };
        let minor = header.rev_minor.map_or(i32::from(NEWEST), |minor| minor.value);
        let version = Minor::try_from(minor.clamp(i32::from(OLDEST), i32::from(NEWEST)));
        let rules = Rules::new(&self.settings, version.unwrap_or(NEWEST));
        self.examiner.counts = vec![0; rules.applied.len()];
        self.left_out = vec![LeftOut::default(); rules.applied.len()];
        self.examiner.rules = Arc::new(rules);
    }

    /// Keeps findings that are counted already.
    fn keep(&mut self, examined: Examined) {
        let before = self.findings.len();
        for (rank, found) in examined.0 {
            match found {
                RuleOutcome::Finding(finding) => self.findings.push(finding),
                RuleOutcome::LeftOut(span, severity, count) => {
                    let Some(left_out) = self.left_out.get_mut(rank) else { continue };
                    let of = left_out.iter_mut().zip(LEFT_OUT).find(|(_, of)| *of == severity);
                    let Some((left_out, _)) = of else { continue };
                    let (_, all) = left_out.get_or_insert((span, 0));
                    *all = all.saturating_add(count);
                }
            }
        }
        // Each element is walked once per kind of check; findings come in file order all the same.
        self.findings[before..].sort_by_key(|finding| finding.span.start);
    }

    /// Looks at the document as a whole, which has ended.
    pub fn finish(&mut self) {
        let whole = self.whole();
        let examined = (0..whole.checks()).map(|check| whole.examine(check)).collect::<Vec<_>>();
        self.end(whole, examined);
    }

    /// The document as a whole, which has ended, to be examined on any thread; [`Checker::end`] takes what was found.
    pub fn whole(&mut self) -> Whole {
        let mut network = std::mem::take(&mut self.examiner.network);
        network.finish();
        Whole { rules: Arc::clone(&self.examiner.rules), network }
    }

    /// Takes what all checks of the document as a whole found; yields the network for who builds from its links.
    pub fn end(&mut self, whole: Whole, examined: impl IntoIterator<Item = Examined>) -> Network {
        let Whole { rules, network } = whole;
        let mut found: Vec<_> = examined.into_iter().flat_map(|examined| examined.0).collect();
        // By rule, whatever check found it: findings at one place stay in this order.
        found.sort_by_key(|(rank, _)| *rank);
        self.keep(Examined(found));
        for (applied, left_out) in rules.applied.iter().zip(&self.left_out) {
            for (left_out, severity) in left_out.iter().zip(LEFT_OUT) {
                let Some((span, count)) = *left_out else { continue };
                let message = format!("{count} more findings of this rule, the first of them here");
                self.findings.push(Finding {
                    rule: applied.rule.id,
                    severity,
                    span,
                    path: "OpenDRIVE".to_owned(),
                    subject: "".into(),
                    message,
                    hint: String::new(),
                    count,
                });
            }
        }
        network
    }

    /// Takes the findings since the last call.
    pub fn take_findings(&mut self) -> Vec<Finding> {
        std::mem::take(&mut self.findings)
    }
}

/// Whether a finding is only counted because its rule has reported `limit` of them. Errors are all kept: each takes a part out of use. They use
/// up the others' places all the same.
pub(crate) fn is_left_out(count: u32, limit: u32, severity: Severity) -> bool {
    count > limit && severity < Severity::Error
}
