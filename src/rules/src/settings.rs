//! Which rules apply, and how bad their findings are.

use crate::catalog;
use crate::rule::Rule;
use mapd_xodr::Severity;
use std::collections::BTreeMap;

/// Findings of one rule that are kept where they are no errors; more are counted.
const FINDINGS_OF_A_RULE: u32 = 100;

/// A choice of rules and severities.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Profile {
    /// Errors are what makes a part useless; what the standard forbids beyond that is a warning.
    #[default]
    Default,
    /// Whatever the standard forbids is an error.
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
            Some(Grade::Off) => return None,
            Some(Grade::Severity(severity)) => return Some(*severity),
            None => {}
        }
        match self.profile {
            Profile::Default => Some(rule.severity),
            Profile::Strict => Some(rule.strict),
            Profile::Asam if !rule.is_asam() => None,
            Profile::Asam if rule.asam.is_some() => rule.asam,
            Profile::Asam if rule.severity == Severity::Info => Some(Severity::Info),
            Profile::Asam if rule.advisory => Some(Severity::Warning),
            Profile::Asam => Some(Severity::Error),
        }
    }

    /// Whether a rule applies to documents of a version.
    pub fn applies(&self, rule: &Rule, minor: u8) -> bool {
        let since = match self.profile {
            Profile::Asam => rule.since.max(rule.id_version()),
            _ => rule.since,
        };
        (since..=rule.until).contains(&minor)
    }

    /// Ids among the grades that no rule has, in order.
    pub fn unknown(&self) -> Vec<&str> {
        let is_known = |id: &str| catalog::all().any(|rule| rule.id == id);
        self.grades.keys().map(|id| &**id).filter(|id| !is_known(id)).collect()
    }
}
