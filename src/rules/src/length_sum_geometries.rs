//! A road is as long as its geometries together.

use crate::finding;
use mapd_xodr::{Finding, Road, Severity};

const RULE: &str = "asam.net:xodr:1.9.0:road.length_sum_geometries";
/// Differences up to this size `[m]` come from rounding in the file.
const TOLERANCE: f64 = 0.01;

pub(crate) fn check(road: &Road, findings: &mut Vec<Finding>) {
    let Some(last) = road.plan_view.last() else { return };
    let end = last.s + last.length;
    if (road.length - end).abs() > TOLERANCE {
        let message = format!(
            "expected a length of {end} m, where the last geometry ends, found {} m; the reference line is used up to the smaller one",
            road.length
        );
        findings.push(finding(RULE, Severity::Warning, road.span, road, "@length", message));
    }
}
