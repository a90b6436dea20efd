//! Which rules apply, and how bad their findings are.

use crate::catalog;
use crate::rule::Rule;
use mapd_xodr::{Finding, Severity};
use std::collections::BTreeMap;

/// Findings of one rule that are kept where they are no errors; more are counted.
const FINDINGS_OF_A_RULE: u32 = 100;

/// A choice of rules and severities.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Profile {
    /// Only what makes a part useless is an error; what the standard forbids beyond that is a warning.
    #[default]
    Default,
    /// Whatever the standard forbids is an error; what it allows is none.
    Strict,
    /// ASAM's rules alone, each from the version in its id on; whatever they forbid is an error, recommendations are
    /// warnings. What ASAM's checker looks at has the severity that it has there.
    Asam,
}

impl Profile {
    /// All profiles with their names.
    pub const ALL: [(&'static str, Self); 3] =
        [("default", Self::Default), ("strict", Self::Strict), ("asam", Self::Asam)];

    /// The profile of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(own, _)| *own == name).map(|(_, profile)| *profile)
    }
}

/// What a configuration says about one rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grade {
    /// The rule is not applied.
    Off,
    /// Its findings have this severity.
    Severity(Severity),
}

/// How a document is checked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Settings {
    /// The profile.
    pub profile: Profile,
    /// Rules graded otherwise, by id.
    pub grades: BTreeMap<Box<str>, Grade>,
    /// Findings of one rule that are kept where they are no errors; more are counted. Default 100.
    pub findings_of_a_rule: u32,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            profile: Profile::default(),
            grades: BTreeMap::new(),
            findings_of_a_rule: FINDINGS_OF_A_RULE,
        }
    }
}

impl Settings {
    /// The severity of a rule's findings; none where it is not applied.
    pub fn severity(&self, rule: &Rule) -> Option<Severity> {
        match self.grades.get(rule.id) {
            _ if rule.fixed => return Some(rule.severity),
            Some(Grade::Off) => return None,
            Some(Grade::Severity(severity)) => return Some(*severity),
            None => {}
        }
        match self.profile {
            Profile::Default => Some(rule.severity),
            // What was read and built is the same for whoever forbids something.
            _ if !rule.check.looks() => Some(rule.strict),
            Profile::Strict => Some(rule.strict),
            Profile::Asam if !rule.is_asam() => None,
            Profile::Asam if rule.asam.is_some() => rule.asam,
            Profile::Asam if rule.severity == Severity::Info => Some(Severity::Info),
            Profile::Asam if rule.advisory => Some(Severity::Warning),
            Profile::Asam => Some(Severity::Error),
        }
    }

    /// The severity of a finding about something that is mended: in the default profile a warning at most, unless the configuration grades the rule.
    pub(crate) fn severity_of_mended(&self, rule: &Rule) -> Option<Severity> {
        let severity = self.severity(rule)?;
        let is_plain = self.profile == Profile::Default && !self.grades.contains_key(rule.id);
        Some(if is_plain { severity.min(Severity::Warning) } else { severity })
    }

    /// Whether a rule applies to documents of a version.
    pub fn applies(&self, rule: &Rule, minor: u8) -> bool {
        let since = match self.profile {
            Profile::Asam => rule.since.max(rule.id_version()),
            _ => rule.since,
        };
        (since..=rule.until).contains(&minor)
    }

    /// A finding of reading or building as it is graded; none where it is switched off. Findings of other rules are graded where they are made.
    pub fn graded(&self, finding: Finding) -> Option<Finding> {
        match catalog::of(finding.rule).filter(|rule| !rule.check.looks()) {
            None => Some(finding),
            Some(rule) => {
                let severity = self.severity_of(rule, finding.severity)?;
                Some(Finding { severity, ..finding })
            }
        }
    }

    /// How bad a finding of reading or building is, by how bad it is for whoever finds it; none where it is switched off. One that is milder than
    /// usual for its rule stays so. Grading twice yields what grading once does.
    pub fn severity_of(&self, rule: &Rule, own: Severity) -> Option<Severity> {
        let graded = self.severity(rule)?;
        // The reader takes each finding as the standard does.
        Some(if own < rule.strict { own.min(graded) } else { graded })
    }

    /// Whether an error of reading takes its part out even if the part can be built without what the error is about. In the default profile it is a
    /// warning then, unless the configuration says of the rule that it is an error.
    pub fn is_error_by_itself(&self, rule: &str) -> bool {
        let is_error = |grade: &Grade| *grade == Grade::Severity(Severity::Error);
        self.profile != Profile::Default || self.grades.get(rule).is_some_and(is_error)
    }

    /// Whether some rule's errors of reading do so.
    pub fn has_errors_by_themselves(&self) -> bool {
        self.profile != Profile::Default || self.grades.keys().any(|id| self.is_error_by_itself(id))
    }

    /// Rules among the grades that no configuration grades, in the order of their ids.
    pub fn fixed(&self) -> Vec<&'static Rule> {
        self.grades.keys().filter_map(|id| catalog::of(id)).filter(|rule| rule.fixed).collect()
    }

    /// Ids among the grades that no rule has, in order.
    pub fn unknown(&self) -> Vec<&str> {
        self.grades.keys().map(|id| &**id).filter(|id| catalog::of(id).is_none()).collect()
    }
}
