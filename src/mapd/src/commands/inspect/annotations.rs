//! What `mapd inspect` says about what files say besides.

use crate::printable::printable;
use mapd_client::Map;
use mapd_query::vocabulary::JunctionGroupKind;
use serde::Serialize;
use std::collections::BTreeMap;
use std::io::{self, Write};

/// Names of annotations that are listed at most.
const MOST_NAMES: usize = 20;

/// Counts of annotations, junction groups, and what lanes say that nothing is built from.
#[derive(Serialize)]
pub(crate) struct AnnotationFacts {
    annotations: usize,
    /// By what they are, then by name: codes of user data, tags of elements, names of attributes.
    by_kind: BTreeMap<&'static str, BTreeMap<String, usize>>,
    /// By what they belong to.
    by_owner: BTreeMap<&'static str, usize>,
    included_files: Vec<String>,
    lane_visibilities: usize,
    lane_rules: usize,
    junction_groups: Vec<GroupFacts>,
}

#[derive(Serialize)]
struct GroupFacts {
    id: String,
    name: String,
    kind: &'static str,
    junctions: usize,
    ring_lanes: usize,
}

impl AnnotationFacts {
    pub(crate) fn of(map: Map<'_>) -> Self {
        let (mut by_kind, mut by_owner) = (BTreeMap::new(), BTreeMap::new());
        for annotation in map.annotations() {
            let names: &mut BTreeMap<String, usize> =
                by_kind.entry(annotation.kind().name()).or_default();
            *names.entry(annotation.name().to_owned()).or_default() += 1;
            *by_owner.entry(annotation.owner_kind().name()).or_default() += 1;
        }
        let groups = map.junction_groups().map(|group| GroupFacts {
            id: group.id().to_owned(),
            name: group.name().to_owned(),
            kind: group.kind().name(),
            junctions: group.members().len(),
            ring_lanes: group.ring().len(),
        });
        Self {
            annotations: map.annotations().len(),
            by_kind,
            by_owner,
            included_files: map.included_files().map(|file| file.name().to_owned()).collect(),
            lane_visibilities: map.tables().lane_visibilities.len(),
            lane_rules: map.tables().lane_rules.len(),
            junction_groups: groups.collect(),
        }
    }

    /// Prints them; nothing for a map that says nothing of the kind.
    ///
    /// Errors: writing fails.
    pub(crate) fn print(&self, out: &mut dyn Write) -> io::Result<()> {
        if self.annotations > 0 {
            let owners = self.by_owner.iter().map(|(owner, count)| format!("{count} of {owner}"));
            let owners: Vec<String> = owners.collect();
            writeln!(out, "annotations   {}: {}", self.annotations, owners.join(", "))?;
        }
        for (kind, names) in &self.by_kind {
            let all: usize = names.values().sum();
            let listed = names.iter().take(MOST_NAMES);
            let listed: Vec<String> = listed.map(|(name, n)| format!("{n} {name:?}")).collect();
            let more = if names.len() > MOST_NAMES { ", …" } else { "" };
            writeln!(out, "  {kind:<16}{all:>6}: {}{more}", printable(&listed.join(", ")))?;
        }
        if !self.included_files.is_empty() {
            writeln!(out, "included      {}", printable(&self.included_files.join(", ")))?;
        }
        if self.lane_visibilities + self.lane_rules > 0 {
            let (seen, rules) = (self.lane_visibilities, self.lane_rules);
            writeln!(out, "lane records  {seen} of visibility, {rules} rules as text")?;
        }
        for group in &self.junction_groups {
            let GroupFacts { id, name, kind, junctions, ring_lanes } = group;
            let ring = match *kind == JunctionGroupKind::Roundabout.name() {
                true => format!(", {ring_lanes} lanes in the ring"),
                false => String::new(),
            };
            let id = printable(id);
            writeln!(out, "group         {id} {name:?}: {kind} of {junctions} junctions{ring}")?;
        }
        Ok(())
    }
}
