//! Findings about edges of the finished graph.

use crate::findings::finding;
use mapd_archive::{EdgeKind, LaneRow, NONE, RoadRow, Rows, SectionRow, string};
use mapd_rules::{Rule, Settings};
use mapd_xodr::{Finding, Severity, Span};
use std::collections::BTreeMap;

/// Findings of one rule that are named one by one where they are no errors; more are counted. Errors are all named: each says
/// which part to leave out, and a number would be in no part.
const NAMED: usize = 100;

/// Collects findings, bounded per rule.
pub(crate) struct Report<'a> {
    rows: &'a Rows,
    /// Place of each edge's link.
    spans: &'a [Span],
    settings: &'a Settings,
    findings: Vec<Finding>,
    counts: BTreeMap<(&'static str, Severity), (&'static Rule, usize)>,
}

impl<'a> Report<'a> {
    pub(crate) fn new(rows: &'a Rows, spans: &'a [Span], settings: &'a Settings) -> Self {
        Self { rows, spans, settings, findings: Vec::new(), counts: BTreeMap::new() }
    }

    /// Whether a finding is an error as it is graded.
    fn is_error(&self, rule: &Rule, severity: Severity) -> bool {
        self.settings.severity_of(rule, severity) == Some(Severity::Error)
    }

    /// Adds a finding at an edge's link.
    pub(crate) fn at_edge(
        &mut self,
        rule: &'static Rule,
        severity: Severity,
        edge: u32,
        message: String,
    ) {
        let (_, count) = self.counts.entry((rule.id, severity)).or_insert((rule, 0));
        *count += 1;
        let count = *count;
        if count <= NAMED || self.is_error(rule, severity) {
            let span = self.spans.get(edge as usize).copied().unwrap_or_default();
            let path = self.edge_path(edge);
            self.findings.push(finding(rule, severity, span, path, message, ""));
        }
    }

    /// The element that an edge's link stands in.
    fn edge_path(&self, edge: u32) -> String {
        let tables = self.rows.as_tables();
        let to = self.rows.successors.get(edge as usize).copied().unwrap_or(NONE);
        let kind = self.rows.edges.get(edge as usize).map(|row| EdgeKind::from_code(row.kind));
        if matches!(kind, Some(EdgeKind::Connection | EdgeKind::Implied)) {
            let entered = self.place_of(to).map_or(NONE, |(road, ..)| road.junction);
            return match self.rows.junctions.get(entered as usize) {
                Some(row) => {
                    format!("OpenDRIVE/junction[@id={}]/connection", string(&tables, row.id))
                }
                // A direct junction's connections have no road of its own.
                None => "OpenDRIVE/junction/connection".to_owned(),
            };
        }
        let after = self.rows.successor_offsets.partition_point(|first| *first <= edge);
        match self.place_of(after.saturating_sub(1) as u32) {
            Some((road, section, lane)) => format!(
                "OpenDRIVE/road[@id={}]/lanes/laneSection[@s={}]/lane[@id={}]/link",
                string(&tables, road.id),
                section.s_start,
                lane.number
            ),
            None => "OpenDRIVE/road/lanes/laneSection/lane/link".to_owned(),
        }
    }

    /// Road, section and lane of a node.
    fn place_of(&self, node: u32) -> Option<(&'a RoadRow, &'a SectionRow, &'a LaneRow)> {
        let lane = self.rows.lanes.get(self.rows.lane_nodes.get(node as usize)?.lane as usize)?;
        let section = self.rows.sections.get(lane.section as usize)?;
        Some((self.rows.roads.get(section.road as usize)?, section, lane))
    }

    pub(crate) fn finish(mut self) -> Vec<Finding> {
        for ((_, severity), (rule, count)) in std::mem::take(&mut self.counts) {
            if count <= NAMED || self.is_error(rule, severity) {
                continue;
            }
            let more = count - NAMED;
            let message = format!("{more} more findings of this rule");
            let path = "OpenDRIVE".to_owned();
            let all = finding(rule, severity, Span::default(), path, message, "");
            self.findings.push(Finding { count: u32::try_from(more).unwrap_or(u32::MAX), ..all });
        }
        self.findings
    }

    /// Key of a node's lane.
    pub(crate) fn node_text(&self, node: u32) -> String {
        let tables = self.rows.as_tables();
        let text = |(road, section, lane): (&RoadRow, &SectionRow, &LaneRow)| {
            format!("{}:{}:{}", string(&tables, road.id), section.number, lane.number)
        };
        self.place_of(node).map(text).unwrap_or_default()
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
