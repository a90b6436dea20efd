//! Findings about edges of the finished graph.

use crate::finding;
use mapd_archive::{Rows, string};
use mapd_xodr::{Finding, Severity, Span};
use std::collections::BTreeMap;

/// Findings of one rule that are named one by one; more are counted.
const NAMED: usize = 100;

/// Collects findings, bounded per rule.
pub(crate) struct Report<'a> {
    rows: &'a Rows,
    /// Place of each edge's link.
    spans: &'a [Span],
    findings: Vec<Finding>,
    counts: BTreeMap<(&'static str, Severity), usize>,
}

impl<'a> Report<'a> {
    pub(crate) fn new(rows: &'a Rows, spans: &'a [Span]) -> Self {
        Self { rows, spans, findings: Vec::new(), counts: BTreeMap::new() }
    }

    /// Adds a finding at an edge's link.
    pub(crate) fn at_edge(
        &mut self,
        rule: &'static str,
        severity: Severity,
        edge: u32,
        message: String,
    ) {
        let count = self.counts.entry((rule, severity)).or_default();
        *count += 1;
        if *count <= NAMED {
            let span = self.spans.get(edge as usize).copied().unwrap_or_default();
            let path = "OpenDRIVE/road/lanes/laneSection/lane/link".to_owned();
            self.findings.push(finding(rule, severity, span, path, message, ""));
        }
    }

    pub(crate) fn finish(mut self) -> Vec<Finding> {
        let mut more: Vec<_> =
            self.counts.into_iter().filter(|(_, count)| *count > NAMED).collect();
        more.sort();
        for ((rule, severity), count) in more {
            let message = format!("{} more findings of this rule", count - NAMED);
            let path = "OpenDRIVE".to_owned();
            self.findings.push(finding(rule, severity, Span::default(), path, message, ""));
        }
        self.findings
    }

    /// Key of a node's lane.
    pub(crate) fn node_text(&self, node: u32) -> String {
        let tables = self.rows.as_tables();
        let text = || {
            let lane =
                self.rows.lanes.get(self.rows.lane_nodes.get(node as usize)?.lane as usize)?;
            let section = self.rows.sections.get(lane.section as usize)?;
            let road = self.rows.roads.get(section.road as usize)?;
            Some(format!("{}:{}:{}", string(&tables, road.id), section.number, lane.number))
        };
        text().unwrap_or_default()
    }

    /// Keys of both lanes of an edge.
    pub(crate) fn edge_text(&self, edge: u32) -> String {
        let after = self.rows.successor_offsets.partition_point(|first| *first <= edge);
        let from = after.saturating_sub(1) as u32;
        let to = self.rows.successors.get(edge as usize).copied().unwrap_or(u32::MAX);
        format!("{} and {}", self.node_text(from), self.node_text(to))
    }

    /// Line and column of an edge's link.
    pub(crate) fn place_text(&self, edge: u32) -> String {
        match self.rows.edges.get(edge as usize) {
            Some(row) if row.line > 0 => format!("{}:{}", row.line, row.column),
            _ => "within the lane".to_owned(),
        }
    }
}
