//! The lane graph (docs/graph.md): first its shape, from what the file says, then its measures, from sampled lanes.

mod anchors;
mod attach;
mod cells;
mod components;
mod conflicts;
mod cross_paths;
mod csr;
mod cuts;
mod cycles;
mod findings;
mod gaps;
mod incoming;
mod landmarks;
mod measure;
mod nodes;
mod permissions;
mod report;
mod virtual_connections;
mod walk;
mod zones;

pub(crate) use components::strong_components;
pub(crate) use permissions::Permissions;

use crate::TooLarge;
use crate::lower::Lowering;
use crate::options::{CompileOptions, MOST_LANDMARKS};
use mapd_archive::Rows;
use mapd_rules::Settings;
use mapd_xodr::source::Places;
use mapd_xodr::{Finding, Span};

/// What the file says about the finished graph, kept until lanes are sampled.
#[derive(Default)]
pub(crate) struct Written {
    /// Where each edge's link stands.
    links: Vec<Span>,
    zones: Vec<zones::Zone>,
}

/// Fills nodes and edges. What is wrong with a link is a finding, and the link is left out.
pub(crate) fn build(
    lowering: &mut Lowering,
    places: &Places,
    settings: &Settings,
    findings: &mut Vec<Finding>,
) -> Result<Written, TooLarge> {
    let cuts = cuts::Cuts::new(lowering);
    nodes::build(lowering, &cuts)?;
    let mut problems = findings::Problems::default();
    let attachments = attach::Attachments::new(lowering, &cuts, &mut problems);
    let edges = walk::edges(lowering, &attachments, &mut problems);
    problems.report(lowering, settings, findings);
    Ok(Written { links: csr::store(lowering, edges, places)?, zones: zones::zones(lowering) })
}

/// Completes the graph from sampled lanes: lengths and times, components, conflicts, landmarks, and what is wrong with its cycles and joints.
pub(crate) fn complete(
    rows: &mut Rows,
    written: &Written,
    options: &CompileOptions,
    settings: &Settings,
) -> Vec<Finding> {
    measure::measure(rows);
    // None of these needs what another finds.
    let seen = &*rows;
    let in_file = || report::Report::new(seen, &written.links, settings);
    let ((components, cycles), (landmarks, ((conflicts, mut findings), gaps))) = rayon::join(
        || {
            let components = components::find(seen);
            (components, cycles::check(seen, options.cycles, in_file()))
        },
        || {
            let landmarks = options.landmarks.min(MOST_LANDMARKS);
            rayon::join(
                || landmarks::find(seen, landmarks.into()),
                || (conflicts::find(seen, &written.zones), gaps::check(seen, in_file())),
            )
        },
    );
    components.store(rows);
    landmarks.store(rows);
    rows.conflicts = conflicts.into();
    findings.extend(gaps);
    findings.extend(cycles);
    findings
}
