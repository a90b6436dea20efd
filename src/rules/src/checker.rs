//! Shows a document to the rules, element by element.

use crate::catalog;
use crate::line::ReferenceLine;
use crate::network::Network;
use crate::rule::{Check, Minor, NEWEST, Rule};
use crate::settings::Settings;
use crate::sink::{Sink, Step};
use mapd_xodr::{Finding, Item, Severity, Span};

/// Oldest version that the rules know.
const OLDEST: Minor = 4;

/// A rule as it is applied.
pub(crate) struct Applied {
    pub(crate) rule: &'static Rule,
    pub(crate) severity: Severity,
    pub(crate) count: u32,
    /// The first finding that was not kept, and the severity of the worst.
    left_out: Option<(Span, Severity)>,
    left_out_count: u32,
}

/// Rules by what they look at.
#[derive(Default)]
pub(crate) struct Lists {
    pub(crate) header: Vec<usize>,
    pub(crate) road: Vec<usize>,
    pub(crate) section: Vec<usize>,
    pub(crate) lane: Vec<usize>,
    pub(crate) center_lane: Vec<usize>,
    pub(crate) object: Vec<usize>,
    pub(crate) signal: Vec<usize>,
    pub(crate) junction: Vec<usize>,
    pub(crate) controller: Vec<usize>,
    pub(crate) junction_group: Vec<usize>,
    pub(crate) station: Vec<usize>,
    pub(crate) vms_group: Vec<usize>,
    pub(crate) network: Vec<usize>,
}

impl Lists {
    fn new(applied: &[Applied]) -> Self {
        let mut lists = Self::default();
        for (rank, applied) in applied.iter().enumerate() {
            let list = match applied.rule.check {
                Check::Header(_) => &mut lists.header,
                Check::Road(_) => &mut lists.road,
                Check::Section(_) => &mut lists.section,
                Check::Lane(_) => &mut lists.lane,
                Check::CenterLane(_) => &mut lists.center_lane,
                Check::Object(_) => &mut lists.object,
                Check::Signal(_) => &mut lists.signal,
                Check::Junction(_) => &mut lists.junction,
                Check::Controller(_) => &mut lists.controller,
                Check::JunctionGroup(_) => &mut lists.junction_group,
                Check::Station(_) => &mut lists.station,
                Check::VmsGroup(_) => &mut lists.vms_group,
                Check::Network(_) => &mut lists.network,
            };
            list.push(rank);
        }
        lists
    }
}

/// Checks a document while it streams by.
pub struct Checker {
    settings: Settings,
    pub(crate) version: Minor,
    pub(crate) applied: Vec<Applied>,
    pub(crate) lists: Lists,
    network: Network,
    findings: Vec<Finding>,
}

impl Checker {
    /// A checker with nothing seen yet. Until a header says otherwise, documents are of the newest version.
    pub fn new(settings: &Settings) -> Self {
        let mut checker = Self {
            settings: settings.clone(),
            version: NEWEST,
            applied: Vec::new(),
            lists: Lists::default(),
            network: Network::default(),
            findings: Vec::new(),
        };
        checker.select();
        checker
    }

    /// Chooses the rules for the version.
    fn select(&mut self) {
        let applied = catalog::all()
            .filter(|rule| self.settings.applies(rule, self.version))
            .filter_map(|rule| Some((rule, self.settings.severity(rule)?)));
        self.applied = applied
            .map(|(rule, severity)| Applied {
                rule,
                severity,
                count: 0,
                left_out: None,
                left_out_count: 0,
            })
            .collect();
        self.lists = Lists::new(&self.applied);
    }

    /// Looks at a top-level element, and keeps what the rules on the network need of it.
    pub fn item(&mut self, item: &Item) {
        let line = self.look(item);
        self.network.add(item, &line);
    }

    /// Looks at a top-level element by itself: to the rules on the network it is not there.
    pub fn item_apart(&mut self, item: &Item) {
        self.look(item);
    }

    /// Applies the rules on elements; yields a road's reference line.
    fn look(&mut self, item: &Item) -> ReferenceLine {
        if let Item::Header(header) = item {
            let minor = header.rev_minor.map_or(i32::from(NEWEST), |minor| minor.value);
            self.version = Minor::try_from(minor.clamp(i32::from(OLDEST), i32::from(NEWEST)))
                .unwrap_or(NEWEST);
            self.select();
        }
        let before = self.findings.len();
        let line = match item {
            Item::Road(road) => ReferenceLine::new(road.plan_view.as_deref()),
            _ => ReferenceLine::default(),
        };
        self.walk(item, &line);
        // Each element is walked once per kind of check; findings come in file order all the same.
        self.findings[before..].sort_by_key(|finding| finding.span.start);
        line
    }

    /// Looks at the document as a whole, which has ended.
    pub fn finish(&mut self) {
        let mut network = std::mem::take(&mut self.network);
        network.finish();
        let before = self.findings.len();
        let ranks = self.lists.network.clone();
        for rank in ranks {
            if let Check::Network(check) = self.applied[rank].rule.check {
                self.apply(rank, &[], |sink| check(&network, sink));
            }
        }
        self.findings[before..].sort_by_key(|finding| finding.span.start);
        self.network = network;
        for applied in &self.applied {
            if let Some((span, severity)) = applied.left_out {
                let count = applied.left_out_count;
                let message = format!("{count} more findings of this rule, the first of them here");
                self.findings.push(Finding {
                    rule: applied.rule.id,
                    severity,
                    span,
                    path: "OpenDRIVE".to_owned(),
                    subject: "".into(),
                    message,
                    hint: String::new(),
                });
            }
        }
    }

    /// Takes the findings since the last call.
    pub fn take_findings(&mut self) -> Vec<Finding> {
        std::mem::take(&mut self.findings)
    }

    /// What is kept of the document.
    pub fn network(&self) -> &Network {
        &self.network
    }

    /// Lets a rule look at something.
    pub(crate) fn apply(
        &mut self,
        rank: usize,
        path: &[Step<'_>],
        look: impl FnOnce(&mut Sink<'_>),
    ) {
        let Some(applied) = self.applied.get_mut(rank) else { return };
        let mut sink = Sink {
            rule: applied.rule,
            severity: applied.severity,
            version: self.version,
            path,
            out: &mut self.findings,
            count: &mut applied.count,
            left_out: &mut applied.left_out,
            left_out_count: &mut applied.left_out_count,
            limit: self.settings.findings_of_a_rule,
        };
        look(&mut sink);
    }
}
