//! What a rule is.

use crate::example::Example;
use crate::network::{LaneJoint, Network};
use crate::place::{LaneIn, ObjectIn, RoadIn, SectionIn, SignalIn};
use crate::sink::Sink;
use mapd_xodr::{
    CenterLane, Controller, Header, Junction, JunctionGroup, Road, Severity, Station, VmsGroup,
};

/// A version of OpenDRIVE 1: its minor number, such as 7 for 1.7.
pub type Minor = u8;

/// The newest version that the rules know.
pub const NEWEST: Minor = 9;

/// A bound that decides whether something is a finding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// What is bounded.
    pub name: &'static str,
    /// The bound.
    pub value: f64,
    /// Its unit.
    pub unit: &'static str,
}

/// Functions that look at where lanes go on as others.
#[derive(Clone, Copy)]
pub struct JointCheck {
    /// Looks at one link of a lane. All rules do so in one walk over the network.
    pub lane: fn(&Network, &LaneJoint<'_>, &mut Sink<'_>),
    /// Looks at what else the rule is about, such as the links of connections, once all links of lanes were looked at.
    pub rest: fn(&Network, &mut Sink<'_>),
}

/// A function that looks at one element, or at the network of all of them.
#[derive(Clone, Copy)]
pub enum Check {
    /// The header.
    Header(fn(&Header, &mut Sink<'_>)),
    /// A road as written, before its records are sorted.
    Order(fn(&Road, &mut Sink<'_>)),
    /// As `Order`, of records that are sorted: a road in which all stand in order is not looked at.
    Records(fn(&Road, &mut Sink<'_>)),
    /// A road.
    Road(fn(&RoadIn<'_>, &mut Sink<'_>)),
    /// A lane section.
    Section(fn(&SectionIn<'_>, &mut Sink<'_>)),
    /// A lane to the left or right.
    Lane(fn(&LaneIn<'_>, &mut Sink<'_>)),
    /// A center lane.
    CenterLane(fn(&CenterLane, &mut Sink<'_>)),
    /// An object of a road or junction.
    Object(fn(&ObjectIn<'_>, &mut Sink<'_>)),
    /// A signal of a road.
    Signal(fn(&SignalIn<'_>, &mut Sink<'_>)),
    /// A junction.
    Junction(fn(&Junction, &mut Sink<'_>)),
    /// A controller.
    Controller(fn(&Controller, &mut Sink<'_>)),
    /// A junction group.
    JunctionGroup(fn(&JunctionGroup, &mut Sink<'_>)),
    /// A station.
    Station(fn(&Station, &mut Sink<'_>)),
    /// A group of variable message boards.
    VmsGroup(fn(&VmsGroup, &mut Sink<'_>)),
    /// All of the document in compact form, once it has ended.
    Network(fn(&Network, &mut Sink<'_>)),
    /// As `Network`, by a look at each link of a lane.
    Joints(JointCheck),
    /// As `Network`, by a look at all overlaps of roads.
    Overlaps(fn(&Network, &mut Sink<'_>)),
    /// None: reading finds it.
    Reading,
    /// None: building finds it.
    Building,
}

impl Check {
    /// A look at each link of a lane, and at nothing else.
    pub(crate) const fn joints(lane: fn(&Network, &LaneJoint<'_>, &mut Sink<'_>)) -> Self {
        Self::Joints(JointCheck { lane, rest: |_, _| {} })
    }

    /// Whether a function looks; not where reading or building finds it.
    pub fn looks(&self) -> bool {
        !matches!(self, Self::Reading | Self::Building)
    }
}

/// A rule of the catalog.
///
/// Its id is ASAM's where ASAM has such a rule (annex of the rules in OpenDRIVE 1.9), else one that begins with `mapd:`.
#[derive(Clone, Copy)]
pub struct Rule {
    /// Id; findings bear it.
    pub id: &'static str,
    /// Further ids of ASAM's for the same.
    pub aliases: &'static [&'static str],
    /// How bad a finding is in the default profile. An error takes the part that it concerns out of use.
    pub severity: Severity,
    /// How bad it is in the strict profile.
    pub strict: Severity,
    /// How bad it is in the profile of ASAM's rules, where ASAM's checker grades it otherwise than that profile does.
    pub asam: Option<Severity>,
    /// What must hold, in one sentence.
    pub meaning: &'static str,
    /// Why the part cannot be used where an error is found; empty for rules that take no part out in the default profile.
    pub because: &'static str,
    /// First version that it is applied to.
    pub since: Minor,
    /// Last version that it is applied to.
    pub until: Minor,
    /// The standard recommends rather than demands it.
    pub advisory: bool,
    /// No configuration grades it, as there is nothing to go on with where it is broken; `because` says why.
    pub fixed: bool,
    /// Bounds that decide.
    pub tolerances: &'static [Tolerance],
    /// What keeps it.
    pub valid: Example,
    /// What breaks it, and is otherwise the same.
    pub invalid: Example,
    /// Looks.
    pub check: Check,
}

impl Rule {
    const fn new(
        id: &'static str,
        severity: Severity,
        strict: Severity,
        meaning: &'static str,
        check: Check,
        [valid, invalid]: [Example; 2],
    ) -> Self {
        Self {
            id,
            aliases: &[],
            severity,
            strict,
            asam: None,
            meaning,
            because: "",
            since: 4,
            until: NEWEST,
            advisory: false,
            fixed: false,
            tolerances: &[],
            valid,
            invalid,
            check,
        }
    }

    /// A rule without which a part cannot be used, and why. The examples are the valid and the invalid one.
    pub(crate) const fn error(
        id: &'static str,
        [meaning, because]: [&'static str; 2],
        check: Check,
        examples: [Example; 2],
    ) -> Self {
        let rule = Self::new(id, Severity::Error, Severity::Error, meaning, check, examples);
        Self { because, ..rule }
    }

    /// A rule that may be broken without making a part useless.
    pub(crate) const fn warning(
        id: &'static str,
        meaning: &'static str,
        check: Check,
        examples: [Example; 2],
    ) -> Self {
        Self::new(id, Severity::Warning, Severity::Error, meaning, check, examples)
    }

    /// A rule that tells something worth knowing.
    pub(crate) const fn info(
        id: &'static str,
        meaning: &'static str,
        check: Check,
        examples: [Example; 2],
    ) -> Self {
        Self::new(id, Severity::Info, Severity::Info, meaning, check, examples)
    }

    /// The rule, of versions from this one on.
    pub(crate) const fn since(mut self, minor: Minor) -> Self {
        self.since = minor;
        self
    }

    /// The rule, of versions up to this one.
    pub(crate) const fn until(mut self, minor: Minor) -> Self {
        self.until = minor;
        self
    }

    /// The rule, under further ids of ASAM's.
    pub(crate) const fn also(mut self, aliases: &'static [&'static str]) -> Self {
        self.aliases = aliases;
        self
    }

    /// The rule, as a recommendation.
    pub(crate) const fn advisory(mut self) -> Self {
        self.advisory = true;
        self.strict = self.severity;
        self
    }

    /// The rule, with a severity that no configuration changes.
    pub(crate) const fn fixed(mut self) -> Self {
        self.fixed = true;
        self
    }

    /// The rule, with this severity in the strict profile.
    pub(crate) const fn strict(mut self, severity: Severity) -> Self {
        self.strict = severity;
        self
    }

    /// The rule, with the severity that ASAM's checker gives it.
    pub(crate) const fn asam(mut self, severity: Severity) -> Self {
        self.asam = Some(severity);
        self
    }

    /// The rule, with the bounds that decide.
    pub(crate) const fn within(mut self, tolerances: &'static [Tolerance]) -> Self {
        self.tolerances = tolerances;
        self
    }

    /// Whether ASAM has the rule.
    pub fn is_asam(&self) -> bool {
        self.id.starts_with("asam.net:")
    }

    /// The first version in the ids that ASAM has for the rule: `asam.net:xodr:1.7.0:…` is of 1.7. 1.4 where there is none.
    pub fn id_version(&self) -> Minor {
        let version = |id: &&str| {
            let version = id.split(':').nth(2).unwrap_or_default();
            version.split('.').nth(1).and_then(|minor| minor.parse().ok()).unwrap_or(4).max(4)
        };
        let own = std::iter::once(&self.id).chain(self.aliases);
        own.filter(|id| id.starts_with("asam.net:")).map(version).min().unwrap_or(4)
    }

    /// The version that the examples are written in.
    pub fn example_version(&self) -> Minor {
        self.id_version().max(self.since).max(8).min(self.until)
    }
}
