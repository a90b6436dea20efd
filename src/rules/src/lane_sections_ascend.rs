//! Lane sections ascend in s, from 0, within the road.

use crate::finding;
use mapd_xodr::{Finding, Road, Severity, Span, Value as _};

const ORDER: &str = "asam.net:xodr:1.4.0:road.lane_section.elem_asc_order";
const BOUNDARIES: &str = "mapd:xodr:1.4.0:lane.section_boundaries";
/// Offsets of the first section and excesses of the last up to this size `[m]` come from rounding in the file.
const TOLERANCE: f64 = 0.01;

pub(crate) fn check(road: &Road, findings: &mut Vec<Finding>) {
    let part = "lanes/laneSection";
    let sections: Vec<(f64, Span)> = road
        .permanent_sections()
        .iter()
        .filter_map(|section| Some((section.s.value()?, section.span)))
        .collect();
    for pair in sections.windows(2) {
        let [(before, _), (s, span)] = *pair else { continue };
        if s < before {
            let message =
                format!("expected s of at least {before}, that of the section before, found {s}");
            findings.push(finding(ORDER, Severity::Error, span, road, part, message));
        }
    }
    if let Some((s, span)) = sections.first().filter(|(s, _)| s.abs() > TOLERANCE) {
        let message = format!("expected the first section at s = 0, found it at {s}");
        findings.push(finding(BOUNDARIES, Severity::Warning, *span, road, part, message));
    }
    let Some(length) = road.length.value() else { return };
    if let Some((s, span)) = sections.last().filter(|(s, _)| *s > length + TOLERANCE) {
        let message = format!("expected a section within the road's {length} m, found it at {s}");
        findings.push(finding(BOUNDARIES, Severity::Warning, *span, road, part, message));
    }
}
