//! Looks at elements by themselves, on any thread.
//!
//! What a rule finds does not depend on other elements, but how many of its findings are kept does. A [`Examiner`] keeps what
//! may be kept; a [`Checker`](crate::Checker) takes it in the order of the document and decides.

use crate::catalog;
use crate::line::ReferenceLine;
use crate::network::Network;
use crate::order::{are_records_sorted, sort_records};
use crate::place::{LaneIn, ObjectIn, RoadIn, SectionIn, SignalIn};
use crate::rule::{Check, JointCheck, Minor, Rule};
use crate::settings::Settings;
use crate::sink::{PathSegment, Sink};
use mapd_xodr::{
    CenterLane, Controller, Finding, Header, Item, Junction, JunctionGroup, Road, Severity, Span,
    Station, VmsGroup,
};
use std::sync::Arc;

/// A rule as it is applied.
#[derive(Clone, Copy)]
pub(crate) struct Applied {
    pub(crate) rule: &'static Rule,
    pub(crate) severity: Severity,
    /// That of findings about what is mended.
    pub(crate) mended: Severity,
}

/// A rule that is applied, its rank among those, and the function that looks.
pub(crate) struct Listed<F> {
    pub(crate) rank: usize,
    pub(crate) applied: Applied,
    pub(crate) check: F,
}

impl<F> Listed<F> {
    /// Where the rule puts what it finds.
    pub(crate) fn sink<'a>(
        &self,
        rules: &Rules,
        path: &'a [PathSegment<'a>],
        count: &'a mut u32,
        out: &'a mut Vec<(usize, RuleOutcome)>,
    ) -> Sink<'a> {
        let Self { rank, applied: Applied { rule, severity, mended }, .. } = *self;
        let (version, limit) = (rules.version, rules.limit);
        Sink { rule, rank, severity, mended, version, path, out, count, limit }
    }
}

/// Rules that look at something.
type List<F> = Vec<Listed<F>>;

/// Rules by what they look at.
#[derive(Default)]
pub(crate) struct Lists {
    pub(crate) header: List<fn(&Header, &mut Sink<'_>)>,
    pub(crate) order: List<fn(&Road, &mut Sink<'_>)>,
    pub(crate) records: List<fn(&Road, &mut Sink<'_>)>,
    pub(crate) road: List<fn(&RoadIn<'_>, &mut Sink<'_>)>,
    pub(crate) section: List<fn(&SectionIn<'_>, &mut Sink<'_>)>,
    pub(crate) lane: List<fn(&LaneIn<'_>, &mut Sink<'_>)>,
    pub(crate) center_lane: List<fn(&CenterLane, &mut Sink<'_>)>,
    pub(crate) object: List<fn(&ObjectIn<'_>, &mut Sink<'_>)>,
    pub(crate) signal: List<fn(&SignalIn<'_>, &mut Sink<'_>)>,
    pub(crate) junction: List<fn(&Junction, &mut Sink<'_>)>,
    pub(crate) controller: List<fn(&Controller, &mut Sink<'_>)>,
    pub(crate) junction_group: List<fn(&JunctionGroup, &mut Sink<'_>)>,
    pub(crate) station: List<fn(&Station, &mut Sink<'_>)>,
    pub(crate) vms_group: List<fn(&VmsGroup, &mut Sink<'_>)>,
    pub(crate) network: List<fn(&Network, &mut Sink<'_>)>,
    pub(crate) joints: List<JointCheck>,
}

impl Lists {
    fn new(all: &[Applied]) -> Self {
        let mut lists = Self::default();
        for (rank, applied) in all.iter().copied().enumerate() {
            macro_rules! list {
                ($($kind:ident => $list:ident,)*) => {
                    match applied.rule.check {
                        $(Check::$kind(check) => lists.$list.push(Listed { rank, applied, check }),)*
                        Check::Reading | Check::Building => {}
                    }
                };
            }
            list! {
                Header => header,
                Order => order,
                Records => records,
                Road => road,
                Section => section,
                Lane => lane,
                CenterLane => center_lane,
                Object => object,
                Signal => signal,
                Junction => junction,
                Controller => controller,
                JunctionGroup => junction_group,
                Station => station,
                VmsGroup => vms_group,
                Network => network,
                Joints => joints,
                Overlaps => network,
            }
        }
        lists
    }
}

/// The rules that apply to documents of one version.
pub(crate) struct Rules {
    pub(crate) version: Minor,
    pub(crate) applied: Vec<Applied>,
    pub(crate) lists: Lists,
    /// Findings of one rule that are kept where they are no errors.
    pub(crate) limit: u32,
}

impl Rules {
    pub(crate) fn new(settings: &Settings, version: Minor) -> Self {
        let applied = catalog::all()
            .filter(|rule| rule.check.looks() && settings.applies(rule, version))
            .filter_map(|rule| {
                let (severity, mended) =
                    (settings.severity(rule)?, settings.severity_of_mended(rule)?);
                Some(Applied { rule, severity, mended })
            })
            .collect::<Vec<_>>();
        let lists = Lists::new(&applied);
        Self { version, applied, lists, limit: settings.findings_of_a_rule }
    }
}

/// What a rule found.
pub(crate) enum RuleOutcome {
    Finding(Finding),
    /// Findings of one severity beyond those kept: the place of the first, their severity, how many.
    LeftOut(Span, Severity, u32),
}

/// What the rules on elements found in one of them, in the order in which they did.
#[derive(Default)]
pub struct Examined(pub(crate) Vec<(usize, RuleOutcome)>);

/// What came of examining a top-level element.
pub struct ExaminedItem {
    /// What was found.
    pub found: Examined,
    /// The element's reference line, empty if it has none.
    pub line: ReferenceLine,
}

/// Looks at top-level elements by themselves.
pub struct Examiner {
    pub(crate) rules: Arc<Rules>,
    /// Findings so far by rule: no more than the whole document has up to here.
    pub(crate) counts: Vec<u32>,
    pub(crate) found: Vec<(usize, RuleOutcome)>,
    pub(crate) network: Network,
}

impl Examiner {
    pub(crate) fn new(rules: Rules) -> Self {
        Self::with(&Arc::new(rules))
    }

    /// One with these rules that has seen nothing.
    pub(crate) fn with(rules: &Arc<Rules>) -> Self {
        let counts = vec![0; rules.applied.len()];
        let (rules, network) = (Arc::clone(rules), Network::default());
        Self { rules, counts, found: Vec::new(), network }
    }

    /// One with the same rules that knows how much was found so far.
    pub(crate) fn another(&self) -> Self {
        let (rules, counts) = (Arc::clone(&self.rules), self.counts.clone());
        Self { rules, counts, found: Vec::new(), network: self.network.another() }
    }

    /// Looks at a top-level element, and keeps what the rules on the network need of it; yields its reference line, too, if
    /// it has one. Once the rules on their order have examined, a road's records are sorted.
    pub fn item(&mut self, item: &mut Item) -> ExaminedItem {
        let line = self.examine(item);
        self.network.add(item, &line);
        ExaminedItem { found: Examined(std::mem::take(&mut self.found)), line }
    }

    /// What is kept of the elements that were examined at.
    pub fn into_network(self) -> Network {
        self.network
    }

    /// Applies the rules on elements; yields the reference line of a road or junction.
    pub(crate) fn examine(&mut self, item: &mut Item) -> ReferenceLine {
        let rules = Arc::clone(&self.rules);
        let line = match item {
            Item::Road(road) => {
                let are_sorted = are_records_sorted(road);
                self.order(&rules, road, are_sorted);
                if !are_sorted {
                    sort_records(road);
                }
                ReferenceLine::new(road.plan_view.as_deref())
            }
            Item::Junction(junction) => ReferenceLine::new(junction.plan_view.as_deref()),
            _ => ReferenceLine::default(),
        };
        self.walk(&rules, item, &line);
        line
    }

    /// Lets a rule look at something.
    pub(crate) fn apply<F>(
        &mut self,
        rules: &Rules,
        listed: &Listed<F>,
        path: &[PathSegment<'_>],
        look: impl FnOnce(&mut Sink<'_>),
    ) {
        let Some(count) = self.counts.get_mut(listed.rank) else { return };
        look(&mut listed.sink(rules, path, count, &mut self.found));
    }
}
