//! Records along s ascend within their list.

use crate::finding;
use mapd_xodr::{CubicRecord, Finding, Road, Severity};

/// Falls up to this size `[m]` come from rounding in the file.
const TOLERANCE: f64 = 1e-6;

const RULE: &str = "mapd:xodr:1.4.0:road.records_ascend";

pub(crate) fn check(road: &Road, findings: &mut Vec<Finding>) {
    if let Some(profile) = &road.elevation_profile {
        list(&profile.elevation, "elevationProfile/elevation", road, findings);
    }
    if let Some(profile) = &road.lateral_profile {
        list(&profile.superelevation, "lateralProfile/superelevation", road, findings);
    }
    let Some(lanes) = road.permanent_lanes() else { return };
    list(&lanes.lane_offset, "lanes/laneOffset", road, findings);
    for lane in lanes.lane_section.iter().flat_map(|section| section.side_lanes()) {
        list(&lane.width, "lanes/laneSection/lane/width", road, findings);
        list(&lane.border, "lanes/laneSection/lane/border", road, findings);
    }
}

fn list<R: CubicRecord>(records: &[R], part: &str, road: &Road, findings: &mut Vec<Finding>) {
    for pair in records.windows(2) {
        let (Some(before), Some(s)) = (pair[0].start(), pair[1].start()) else { continue };
        if s < before {
            let message =
                format!("expected s of at least {before}, that of the record before, found {s}");
            let rounding = before - s <= TOLERANCE;
            let severity = if rounding { Severity::Warning } else { Severity::Error };
            findings.push(finding(RULE, severity, pair[1].span(), road, part, message));
        }
    }
}
