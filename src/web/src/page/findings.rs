//! What was found in a map's OpenDRIVE file, for the page: each finding with the thing of the map that it is about.
//!
//! An archive has only the parts that are left out; who compiles a file knows the rest, and hands it over here.

use crate::{Kind, Link, Words};
use mapd_query::{Lane, Map, Road};
use serde::Serialize;
use std::collections::HashMap;

/// A finding as the compiler reports it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ReportedFinding<'a> {
    /// `error`, `warning` or `info`.
    pub severity: &'static str,
    /// Id of the rule.
    pub rule: &'a str,
    /// What was expected and what was found.
    pub message: &'a str,
    /// The way out; may be empty.
    pub hint: &'a str,
    /// Path of elements, such as `OpenDRIVE/road[@id=12]/planView/geometry`.
    pub path: &'a str,
    /// Name of the included file that it stands in; empty for the document itself.
    pub file: &'a str,
    /// Line, from 1.
    pub line: u32,
    /// Column in bytes, from 1.
    pub column: u32,
}

/// All findings of a map as the page has them: JSON. Without any text they are not known.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Findings(String);

#[derive(Serialize)]
struct Listed<'a> {
    findings: Vec<Finding<'a>>,
    /// Findings beyond those listed.
    not_kept: usize,
}

#[derive(Serialize)]
struct Finding<'a> {
    severity: &'static str,
    rule: &'a str,
    message: &'a str,
    #[serde(skip_serializing_if = "str::is_empty")]
    hint: &'a str,
    path: &'a str,
    /// What it is about, if the map has it.
    #[serde(skip_serializing_if = "Option::is_none")]
    about: Option<Words>,
    #[serde(skip_serializing_if = "str::is_empty")]
    file: &'a str,
    line: u32,
    column: u32,
}

impl Findings {
    /// Of a map that nobody compiled just now.
    pub const UNKNOWN: Self = Self(String::new());

    /// Those of a map's file, and how many there are besides.
    pub fn of<'a>(
        map: Map<'_>,
        found: impl IntoIterator<Item = ReportedFinding<'a>>,
        not_kept: usize,
    ) -> Self {
        let mut left_out = HashMap::new();
        for (row, part) in (0..).zip(map.quarantined()) {
            let at = part.source_position();
            let words = Words {
                text: format!("{} {}", part.kind().name(), part.id()),
                link: Some(Link { kind: Kind::Quarantine, row }),
            };
            left_out.entry((at.line, at.column, part.rule().to_owned())).or_insert(words);
        }
        let finding = |one: ReportedFinding<'a>| Finding {
            severity: one.severity,
            rule: one.rule,
            message: one.message,
            hint: one.hint,
            path: one.path,
            about: left_out
                .get(&(one.line, one.column, one.rule.to_owned()))
                .cloned()
                .or_else(|| about(map, one.path)),
            file: one.file,
            line: one.line,
            column: one.column,
        };
        let findings = found.into_iter().map(finding).collect();
        Self(serde_json::to_string(&Listed { findings, not_kept }).unwrap_or_default())
    }

    /// The JSON; empty where they are not known.
    pub fn json(&self) -> &str {
        &self.0
    }
}

/// The lane, signal, object, road or junction that a path leads to, or leads through.
fn about(map: Map<'_>, path: &str) -> Option<Words> {
    if let Some((junction, _)) = named(path, "OpenDRIVE/junction[@id=", |id| map.junction_by_id(id))
    {
        return Some(prefixed("junction", Words::from(&junction)));
    }
    let (road, rest) = named(path, "OpenDRIVE/road[@id=", |id| map.road_by_id(id))?;
    let within = lane(&road, rest)
        .map(|lane| prefixed("lane", Words::from(&lane)))
        .or_else(|| {
            let is_own = |one: &Road<'_>| one.road_id() == road.road_id();
            let signal = |id: &str| {
                map.signal_by_id(id).filter(|one| one.road().as_ref().is_some_and(is_own))
            };
            let (signal, _) = named(rest, "/signals/signal[@id=", signal)?;
            Some(prefixed("signal", Words::from(&signal)))
        })
        .or_else(|| {
            let object = |id: &str| road.objects().find(|one| one.id() == id);
            let (object, _) = named(rest, "/objects/object[@id=", object)?;
            Some(prefixed("object", Words::from(&object)))
        });
    Some(within.unwrap_or_else(|| prefixed("road", Words::from(&road))))
}

fn lane<'a>(road: &Road<'a>, rest: &str) -> Option<Lane<'a>> {
    let section = |s: &str| road.sections().find(|one| one.s_start().to_string() == s);
    let (section, rest) = named(rest, "/lanes/laneSection[@s=", section)?;
    let number = |number: &str| section.lane(number.parse().ok()?);
    named(rest, "/lane[@id=", number).map(|(lane, _)| lane)
}

/// What is named behind a prefix, and the rest of the path. An id may itself have what ends one: the longest that is known counts.
fn named<'p, T>(
    path: &'p str,
    prefix: &str,
    find: impl Fn(&str) -> Option<T>,
) -> Option<(T, &'p str)> {
    let rest = path.strip_prefix(prefix)?;
    let ends = rest.rmatch_indices(']').map(|(at, _)| (&rest[..at], &rest[at + 1..]));
    ends.filter(|(_, rest)| rest.is_empty() || rest.starts_with('/'))
        .find_map(|(id, rest)| find(id).map(|found| (found, rest)))
}

fn prefixed(kind: &str, words: Words) -> Words {
    Words { text: format!("{kind} {}", words.text), ..words }
}
