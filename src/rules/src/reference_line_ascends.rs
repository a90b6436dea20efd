//! Geometries ascend in s.

use crate::finding;
use mapd_xodr::{Finding, Road, Severity, Value as _};

const RULE: &str = "asam.net:xodr:1.4.0:road.geometry.elem_asc_order";

pub(crate) fn check(road: &Road, findings: &mut Vec<Finding>) {
    let Some(plan_view) = &road.plan_view else { return };
    for pair in plan_view.geometry.windows(2) {
        let (Some(before), Some(s)) = (pair[0].s.value(), pair[1].s.value()) else { continue };
        if s < before {
            let message =
                format!("expected s of at least {before}, that of the geometry before, found {s}");
            let part = "planView/geometry";
            findings.push(finding(RULE, Severity::Error, pair[1].span, road, part, message));
        }
    }
}
