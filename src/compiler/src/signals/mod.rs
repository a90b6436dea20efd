//! Signals and right of way (docs/signals.md), once ids are rows and lanes are sampled: places become coordinates and lanes.

mod attach;
mod objects;
mod place;
mod right_of_way;
mod speed_signs;

use crate::options::CompileOptions;
use crate::resolve::Resolved;
use mapd_archive::Rows;
use mapd_xodr::Finding;

/// Fills positions, lanes and right of way of a map whose lane graph is complete. What belongs to no lane, and a zone without
/// an end, is a finding.
pub(crate) fn complete(
    rows: &mut Rows,
    resolved: &Resolved,
    options: &CompileOptions,
) -> Vec<Finding> {
    objects::resolve(rows);
    place::place(rows, resolved);
    let mut findings = attach::attach(rows, resolved, options.lane_reach);
    right_of_way::build(rows);
    findings.extend(speed_signs::build(rows, resolved));
    findings
}
