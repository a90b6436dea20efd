//! What lanes say that nothing is built from: how far one sees, and rules in words.

use super::Lowering;
use super::need::Part;
use crate::annotations::Extra;
use mapd_archive::{LaneRuleRow, LaneVisibilityRow};
use mapd_xodr::{self as xodr, Attribute, Finding, Severity, Span, Text as _, Value as _};

/// A record that has no place is left out.
const NO_PLACE: &str = "mapd:compile.record_place";

impl Lowering {
    /// Appends the records of the lane whose row comes next.
    pub(super) fn lane_words(
        &mut self,
        visibility: &[xodr::LaneVisibility],
        rule: &[xodr::LaneRule],
        section_s: f64,
        road: &str,
        findings: &mut Vec<Finding>,
    ) {
        let lane = self.rows.lanes.len() as u32;
        let mut place = |s: &Option<Attribute<f64>>, span: Span, name: &str| {
            let tail = format!("lanes/laneSection/lane/{name}");
            if s.is_none() {
                let message =
                    "expected @sOffset, found none that can be used; the record is left out";
                Part { span, path: (road, &tail), findings }.add(
                    NO_PLACE,
                    Severity::Warning,
                    message.to_owned(),
                );
            }
            s.value().map(|s| section_s + s)
        };
        if !self.without.has(Extra::Visibility) {
            let given = |distance: &Option<Attribute<f64>>| distance.value().unwrap_or(-1.0);
            let before = self.rows.lane_visibilities.len();
            for record in visibility {
                let Some(s) = place(&record.s_offset, record.span, "visibility") else { continue };
                self.rows.lane_visibilities.push(LaneVisibilityRow {
                    s,
                    forward: given(&record.forward),
                    back: given(&record.back),
                    left: given(&record.left),
                    right: given(&record.right),
                    lane,
                    reserved: 0,
                });
            }
            if let Some(own) = self.rows.lane_visibilities.get_mut(before..) {
                own.sort_by(|a, b| a.s.total_cmp(&b.s));
            }
        }
        if !self.without.has(Extra::LaneRules) {
            let before = self.rows.lane_rules.len();
            for record in rule {
                let Some(s) = place(&record.s_offset, record.span, "rule") else { continue };
                let value = self.strings.add(record.value.text());
                self.rows.lane_rules.push(LaneRuleRow { s, lane, value });
            }
            if let Some(own) = self.rows.lane_rules.get_mut(before..) {
                own.sort_by(|a, b| a.s.total_cmp(&b.s));
            }
        }
    }
}
