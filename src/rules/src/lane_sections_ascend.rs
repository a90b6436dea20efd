//! Lane sections ascend in s, from 0, within the road.

use crate::finding;
use mapd_xodr::{Finding, Road, Severity};

const ORDER: &str = "asam.net:xodr:1.4.0:road.lane_section.elem_asc_order";
const BOUNDARIES: &str = "mapd:xodr:1.4.0:lane.section_boundaries";
/// Offsets of the first section and excesses of the last up to this size `[m]` come from rounding in the file.
const TOLERANCE: f64 = 0.01;

pub(crate) fn check(road: &Road, findings: &mut Vec<Finding>) {
    let part = "lanes/laneSection";
    for pair in road.sections.windows(2) {
        if pair[1].s < pair[0].s {
            let message = format!(
                "expected s of at least {}, that of the section before, found {}",
                pair[0].s, pair[1].s
            );
            findings.push(finding(ORDER, Severity::Error, pair[1].span, road, part, message));
        }
    }
    if let Some(first) = road.sections.first().filter(|first| first.s.abs() > TOLERANCE) {
        let message = format!("expected the first section at s = 0, found it at {}", first.s);
        findings.push(finding(BOUNDARIES, Severity::Warning, first.span, road, part, message));
    }
    if let Some(last) = road.sections.last().filter(|last| last.s > road.length + TOLERANCE) {
        let message = format!(
            "expected a section within the road's {} m, found it at {}",
            road.length, last.s
        );
        findings.push(finding(BOUNDARIES, Severity::Warning, last.span, road, part, message));
    }
}
