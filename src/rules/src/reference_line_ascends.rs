//! Geometries ascend in s.

use crate::finding;
use mapd_xodr::{Finding, Road, Severity};

const RULE: &str = "asam.net:xodr:1.4.0:road.geometry.elem_asc_order";

pub(crate) fn check(road: &Road, findings: &mut Vec<Finding>) {
    for pair in road.plan_view.windows(2) {
        if pair[1].s < pair[0].s {
            let message = format!(
                "expected s of at least {}, that of the geometry before, found {}",
                pair[0].s, pair[1].s
            );
            findings.push(finding(
                RULE,
                Severity::Error,
                pair[1].span,
                road,
                "planView/geometry",
                message,
            ));
        }
    }
}
