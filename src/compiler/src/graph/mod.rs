//! The lane graph (docs/graph.md): first its shape, from what the file says, then its measures, from sampled lanes.

mod attach;
mod components;
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
mod walk;

pub(crate) use permissions::Permissions;

use crate::TooLarge;
use crate::lower::Lowering;
use crate::options::{CompileOptions, MOST_LANDMARKS};
use mapd_archive::Rows;
use mapd_xodr::source::Places;
use mapd_xodr::{Finding, Span};

/// Fills nodes and edges; says where each edge's link stands. What is wrong with a link is a finding, and the link is left out.
pub(crate) fn build(
    lowering: &mut Lowering,
    places: &Places,
    findings: &mut Vec<Finding>,
) -> Result<Vec<Span>, TooLarge> {
    let cuts = cuts::Cuts::new(lowering);
    nodes::build(lowering, &cuts)?;
    let mut problems = findings::Problems::default();
    let attachments = attach::Attachments::new(lowering, &cuts, &mut problems);
    let edges = walk::edges(lowering, &attachments, &mut problems);
    problems.report(lowering, findings);
    csr::store(lowering, edges, places)
}

/// Completes the graph from sampled lanes: lengths and times, components, and what is wrong with its cycles and joints.
pub(crate) fn complete(rows: &mut Rows, spans: &[Span], options: &CompileOptions) -> Vec<Finding> {
    measure::measure(rows);
    components::condense(rows);
    landmarks::build(rows, options.landmarks.min(MOST_LANDMARKS).into());
    let mut report = report::Report::new(rows, spans);
    gaps::check(rows, &mut report);
    cycles::check(rows, options.cycles, &mut report);
    report.finish()
}
