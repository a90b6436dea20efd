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
mod direct;
mod findings;
mod gaps;
mod incoming;
mod landmarks;
mod measure;
mod motor_edges;
mod motor_ways;
mod nodes;
mod report;
mod rings;
mod virtual_connections;
mod walk;
mod widths;
mod zones;

pub(crate) use cuts::Cuts;
pub(crate) use rings::rings;

use crate::draft::{Draft, Links, Permissions};
use crate::findings::TooLarge;
use crate::options::{CompileOptions, MOST_LANDMARKS};
use mapd_archive::Rows;
use mapd_rules::Settings;
use mapd_xodr::source::Places;
use mapd_xodr::{Finding, Span};

/// What the file says about the finished graph, kept until lanes are sampled.
#[derive(Default)]
pub(crate) struct WrittenLinks {
    /// Where each edge's link stands.
    links: Vec<Span>,
    zones: Vec<zones::Zone>,
}

/// What the graph's shape follows from: the rows so far, and the links as written.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    pub(crate) draft: &'a Draft,
    pub(crate) links: &'a Links<'a>,
}

/// Fills nodes: where sections are cut into pieces is told for [`edges`].
pub(crate) fn nodes(draft: &mut Draft, links: &Links<'_>) -> Result<Cuts, TooLarge> {
    let cuts = Cuts::new(Source { draft, links });
    nodes::build(draft, &cuts)?;
    // Nodes now have what the permissions said.
    draft.permissions = Permissions::default();
    Ok(cuts)
}

/// Fills edges. What is wrong with a link is a finding, and the link is left out.
pub(crate) fn edges(
    draft: &mut Draft,
    links: &Links<'_>,
    cuts: &Cuts,
    places: &Places,
    settings: &Settings,
    findings: &mut Vec<Finding>,
) -> Result<WrittenLinks, TooLarge> {
    let mut problems = findings::Problems::default();
    let source = Source { draft, links };
    let attachments = attach::Attachments::new(source, cuts, &mut problems);
    let edges = walk::edges(source, &attachments, &mut problems);
    let zones = zones::zones(source);
    problems.report(draft, settings, findings);
    Ok(WrittenLinks { links: csr::store(draft, edges, places)?, zones })
}

/// Completes the graph from sampled lanes: lengths and times, components, conflicts, landmarks, and what is wrong with its cycles and joints.
pub(crate) fn complete(
    rows: &mut Rows,
    written: &WrittenLinks,
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
