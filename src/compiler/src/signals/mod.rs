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
use right_of_way::RightOfWay;

/// Fills positions, lanes and right of way of a map whose lane graph is complete. What belongs to no lane, and a zone without
/// an end, is a finding.
pub(crate) fn complete(
    rows: &mut Rows,
    resolved: &Resolved,
    options: &CompileOptions,
) -> Vec<Finding> {
    objects::resolve(rows);
    let mut findings = attach::attach(rows, resolved, options.lane_reach);
    findings.extend(place::place(rows, resolved));
    // Neither needs what the other finds.
    let seen = &*rows;
    let (right_of_way, (speed_signs, endless)) =
        rayon::join(|| RightOfWay::find(seen), || speed_signs::find(seen, resolved));
    right_of_way.store(rows);
    rows.speed_signs_at_entry = speed_signs.into();
    findings.extend(endless);
    findings
}
