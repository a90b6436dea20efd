//! Who may propose what: a file in TOML.

use crate::small_text;
use anyhow::{Context, Result, anyhow};
use mapd_client::Domain;
use mapd_overlay::Kind;
use serde::Deserialize;
use std::path::Path;
use std::time::Duration;

/// Longest name of a source \[bytes\].
pub(super) const LONGEST_SOURCE: usize = 100;

/// Longest time for which a proposal may hold \[s\]: a week.
const LONGEST: f64 = 7.0 * 24.0 * 3600.0;

/// Which proposals a daemon accepts from which sources.
#[derive(Debug)]
pub(crate) struct ProposalPolicy {
    pub(super) rules: Vec<Rule>,
}

/// What one source may say.
#[derive(Debug)]
pub(super) struct Rule {
    /// What it calls itself.
    pub(super) source: String,
    /// The user that its process must have.
    pub(super) user: u32,
    pub(super) kinds: Vec<Kind>,
    /// For how long what it says holds at most.
    pub(super) longest: Duration,
    /// How many sources must say the same, with this one, and within which time.
    pub(super) agree: u32,
    pub(super) within: Duration,
    /// How sure it must be.
    pub(super) confidence: f64,
    /// Proposals that it may make in a minute.
    pub(super) rate: u32,
    /// Entries of it that may hold at a time.
    pub(super) most: usize,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    allow: Vec<Allow>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Allow {
    source: String,
    user: Option<User>,
    kinds: Vec<Kind>,
    longest: f64,
    #[serde(default = "one")]
    agree: u32,
    #[serde(default = "ten")]
    within: f64,
    #[serde(default)]
    confidence: f64,
    #[serde(default = "sixty")]
    rate: u32,
    #[serde(default = "hundred")]
    most: usize,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum User {
    Name(String),
    Number(u32),
}

fn one() -> u32 {
    1
}

fn ten() -> f64 {
    10.0
}

fn sixty() -> u32 {
    60
}

fn hundred() -> usize {
    100
}

impl ProposalPolicy {
    /// Reads a policy. Users are those of this system; without one the daemon's own.
    ///
    /// Errors: it cannot be read; what is wrong in it.
    pub(crate) fn read(path: &Path, domain: &Domain) -> Result<Self> {
        let text = small_text::read(path)?;
        Self::parse(&text, domain).with_context(|| format!("policy {}", path.display()))
    }

    fn parse(text: &str, domain: &Domain) -> Result<Self> {
        let file: File = small_text::toml(text).map_err(anyhow::Error::msg)?;
        let rules = file.allow.into_iter().enumerate();
        let rules = rules.map(|(i, allow)| {
            allow.rule(domain).with_context(|| format!("allow, number {}", i + 1))
        });
        Ok(Self { rules: rules.collect::<Result<_>>()? })
    }
}

impl Allow {
    fn rule(self, domain: &Domain) -> Result<Rule> {
        let seconds = |name: &str, value: f64| {
            let is_fit = value > 0.0 && value <= LONGEST;
            is_fit
                .then(|| Duration::from_secs_f64(value))
                .ok_or_else(|| anyhow!("{name}: expected seconds, at most {LONGEST}"))
        };
        let is_named = !self.source.is_empty() && self.source.len() <= LONGEST_SOURCE;
        if !is_named || self.source.chars().any(|c| c.is_control() || c == '/') {
            return Err(anyhow!(
                "source: expected a name of 1 to {LONGEST_SOURCE} bytes without `/`"
            ));
        }
        if self.agree == 0 {
            return Err(anyhow!("agree: expected 1 or more"));
        }
        if !(0.0..=1.0).contains(&self.confidence) {
            return Err(anyhow!("confidence: expected a number from 0 to 1"));
        }
        let user = match self.user {
            None => domain.owner(),
            Some(User::Number(user)) => user,
            Some(User::Name(name)) => domain.clone().owned_by(&name)?.owner(),
        };
        Ok(Rule {
            user,
            longest: seconds("longest", self.longest)?,
            within: seconds("within", self.within)?,
            source: self.source,
            kinds: self.kinds,
            agree: self.agree,
            confidence: self.confidence,
            rate: self.rate,
            most: self.most,
        })
    }
}
