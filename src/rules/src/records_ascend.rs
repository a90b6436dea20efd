//! Records along s ascend within their list.

use crate::finding;
use mapd_xodr::{CubicRecord, Finding, Road, Severity};

/// Falls up to this size `[m]` come from rounding in the file.
const TOLERANCE: f64 = 1e-6;

const RULE: &str = "mapd:xodr:1.4.0:road.records_ascend";

pub(crate) fn check(road: &Road, findings: &mut Vec<Finding>) {
    let mut lists: Vec<(&[CubicRecord], &str)> = vec![
        (&road.elevations, "elevationProfile/elevation"),
        (&road.superelevations, "lateralProfile/superelevation"),
        (&road.lane_offsets, "lanes/laneOffset"),
    ];
    for lane in road.sections.iter().flat_map(|section| &section.lanes) {
        lists.push((&lane.widths, "lanes/laneSection/lane/width"));
        lists.push((&lane.borders, "lanes/laneSection/lane/border"));
    }
    for (records, part) in lists {
        for pair in records.windows(2).filter(|pair| pair[1].s < pair[0].s) {
            let message = format!(
                "expected s of at least {}, that of the record before, found {}",
                pair[0].s, pair[1].s
            );
            let rounding = pair[0].s - pair[1].s <= TOLERANCE;
            let severity = if rounding { Severity::Warning } else { Severity::Error };
            findings.push(finding(RULE, severity, pair[1].span, road, part, message));
        }
    }
}
