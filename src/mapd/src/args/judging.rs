//! Which rules apply, and what becomes of a map with errors: arguments and configuration file.

use crate::args::finite;
use crate::exit::UsageError;
use crate::small_text;
use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use mapd_compiler::{OnError, Policy, ReadOptions};
use mapd_rules::{Grade, Profile, Settings};
use mapd_xodr::Severity;
use serde::de::Error;
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Which rules apply, and how bad their findings are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum ProfileName {
    /// Only what makes a part of the map unusable is an error
    Default,
    /// Everything that the standard forbids is an error
    Strict,
    /// Only ASAM's rules
    Asam,
}

/// What is done about an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum OnErrorName {
    /// Leave out the smallest part that contains it
    Quarantine,
    /// Reject the map
    Reject,
    /// Leave out the smallest part, but keep a road as its reference line
    ReferenceLine,
}

/// Arguments; each stands above what the configuration file says.
#[derive(Args, Default)]
pub(crate) struct JudgingArgs {
    /// Which rules apply, and the severity of their findings [default: default]
    #[arg(long, value_enum)]
    profile: Option<ProfileName>,

    /// Configuration: profile, on_error, limits, and severities of single rules
    #[arg(long, value_name = "RULES.toml")]
    rules: Option<PathBuf>,

    /// Reaction to an error [default: quarantine]
    #[arg(long, value_enum)]
    on_error: Option<OnErrorName>,

    /// Reject a map with more parts in quarantine
    #[arg(long, value_name = "N")]
    max_quarantined: Option<usize>,

    /// Reject a map with a larger share of its roads' length in quarantine, from 0 to 1
    #[arg(long, value_name = "SHARE", value_parser = part_of_length)]
    max_quarantined_share: Option<f64>,
}

/// The configuration file.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Configuration {
    profile: Option<ProfileName>,
    on_error: Option<OnErrorName>,
    max_quarantined: Option<usize>,
    #[serde(default, deserialize_with = "part_of_length_in_file")]
    max_quarantined_share: Option<f64>,
    /// Findings of one rule that are told one by one where they are no errors.
    max_findings: Option<u32>,
    #[serde(default)]
    rules: BTreeMap<String, GradeName>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum GradeName {
    Off,
    Information,
    Warning,
    Error,
}

impl JudgingArgs {
    /// Reading options with these rules and this policy.
    ///
    /// Errors: the configuration file cannot be read, or names a rule that there is not, or one that is not graded.
    pub(crate) fn apply(&self, reading: ReadOptions) -> Result<ReadOptions> {
        let file = self.configuration()?;
        let profile = match self.profile.or(file.profile) {
            None | Some(ProfileName::Default) => Profile::Default,
            Some(ProfileName::Strict) => Profile::Strict,
            Some(ProfileName::Asam) => Profile::Asam,
        };
        let grade = |grade| match grade {
            GradeName::Off => Grade::Off,
            GradeName::Information => Grade::Severity(Severity::Info),
            GradeName::Warning => Grade::Severity(Severity::Warning),
            GradeName::Error => Grade::Severity(Severity::Error),
        };
        let defaults = Settings::default();
        let rules = Settings {
            profile,
            grades: file
                .rules
                .iter()
                .map(|(id, name)| (id.as_str().into(), grade(*name)))
                .collect(),
            findings_of_a_rule: file.max_findings.unwrap_or(defaults.findings_of_a_rule),
        };
        let wrong = |said: String| {
            let file = self.rules.as_deref().unwrap_or_else(|| Path::new("--rules"));
            UsageError(format!("{}: {said}", file.display()))
        };
        if let Some(id) = rules.unknown().first() {
            bail!(wrong(format!("there is no rule {id}; docs/rules.md lists them")));
        }
        if let Some(rule) = rules.fixed().first() {
            bail!(wrong(format!("rule {} has one severity: {}", rule.id, rule.because)));
        }
        let on_error = match self.on_error.or(file.on_error) {
            None | Some(OnErrorName::Quarantine) => OnError::Quarantine,
            Some(OnErrorName::Reject) => OnError::Reject,
            Some(OnErrorName::ReferenceLine) => OnError::ReferenceLine,
        };
        let max_share = self.max_quarantined_share.or(file.max_quarantined_share);
        let max_parts = self.max_quarantined.or(file.max_quarantined);
        Ok(ReadOptions { rules, policy: Policy { on_error, max_parts, max_share }, ..reading })
    }

    fn configuration(&self) -> Result<Configuration> {
        let Some(path) = &self.rules else { return Ok(Configuration::default()) };
        let text = small_text::read(path)?;
        let wrong = |error| UsageError(format!("reading {}: {error}", path.display()));
        Ok(small_text::toml(&text).map_err(wrong)?)
    }
}

/// A share of the roads' length.
///
/// Errors: anything but a number from 0 to 1.
fn part_of_length(text: &str) -> Result<f64, String> {
    share(finite(text)?)
}

/// As [`part_of_length`], in the configuration file, whose place the error then names.
fn part_of_length_in_file<'de, D: Deserializer<'de>>(file: D) -> Result<Option<f64>, D::Error> {
    share(f64::deserialize(file)?).map(Some).map_err(D::Error::custom)
}

fn share(number: f64) -> Result<f64, String> {
    match (0.0..=1.0).contains(&number) {
        true => Ok(number),
        false => Err(format!("expected a share from 0 to 1, found {number}")),
    }
}
