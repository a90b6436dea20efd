//! What lanes say that nothing is built from: how far one sees, and rules in words.

use super::need::{ElementContext, ElementPath};
use crate::draft::Draft;
use crate::without::Extra;
use mapd_archive::{LaneRuleRow, LaneVisibilityRow};
use mapd_xodr::{self as xodr, Attribute, Finding, Span, Text as _, Value as _};

impl Draft {
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
            let mut part = ElementContext { span, path: ElementPath::new(road, &tail), findings };
            super::surface::place(s.value(), "sOffset", &mut part).map(|s| section_s + s)
        };
        if !self.without.has(Extra::Visibility) {
            let given = |distance: &Option<Attribute<f64>>| distance.value().unwrap_or(-1.0);
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
        }
        if !self.without.has(Extra::LaneRules) {
            for record in rule {
                let Some(s) = place(&record.s_offset, record.span, "rule") else { continue };
                let value = self.strings.add(record.value.text());
                self.rows.lane_rules.push(LaneRuleRow { s, lane, value });
            }
        }
    }
}
