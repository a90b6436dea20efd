//! A road is as long as its geometries together.

use crate::finding;
use mapd_xodr::{Finding, Road, Severity, Value as _};

const RULE: &str = "asam.net:xodr:1.9.0:road.length_sum_geometries";
/// Differences up to this size `[m]` come from rounding in the file.
const TOLERANCE: f64 = 0.01;

pub(crate) fn check(road: &Road, findings: &mut Vec<Finding>) {
    let Some(last) = road.plan_view.as_ref().and_then(|plan_view| plan_view.geometry.last()) else {
        return;
    };
    let (Some(length), Some(s), Some(last_length)) =
        (road.length.value(), last.s.value(), last.length.value())
    else {
        return;
    };
    let end = s + last_length;
    if (length - end).abs() > TOLERANCE {
        let message = format!(
            "expected a length of {end} m, where the last geometry ends, found {length} m; the reference line is used up to the smaller one"
        );
        findings.push(finding(RULE, Severity::Warning, road.span, road, "@length", message));
    }
}
