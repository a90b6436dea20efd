//! Edges whose lanes do not meet where they are linked.

use super::report::Report;
use crate::sample::view;
use glam::DVec3;
use mapd_archive::{EdgeKind, Rows};
use mapd_query::Map;
use mapd_query::SRange;
use mapd_query::compiling::ByRow as _;
use mapd_query::graph::LaneNode;
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity};
use rayon::prelude::*;

/// Nodes that one task looks at, at least.
const NODES_PER_TASK: usize = 256;

/// Names the edges that join ends farther apart than the tolerance. They stay: the file links them.
pub(crate) fn check(rows: &Rows, mut report: Report<'_>) -> Vec<Finding> {
    let archive = view(rows);
    let map = Map::new(&archive, 0);
    let numbers = (0..rows.lane_nodes.len() as u32).into_par_iter().with_min_len(NODES_PER_TASK);
    let nodes = numbers.filter_map(|number| map.lane_node_by_row(number));
    let gaps: Vec<(u32, f64)> = nodes.flat_map_iter(|node| of_node(rows, &node)).collect();
    for (edge, gap) in gaps {
        let message = format!(
            "expected lanes that meet, found {gap:.3} m between {}; linked as written",
            report.edge_text(edge)
        );
        report.at_edge(&building::GAP, Severity::Warning, edge, message);
    }
    report.finish()
}

fn of_node(rows: &Rows, node: &LaneNode<'_>) -> Vec<(u32, f64)> {
    let mut gaps = Vec::new();
    // Pedestrians against the direction of traffic meet the same joint as those with it.
    if node.lane().is_some_and(|l| !l.is_bidirectional() && l.is_forward() != node.is_forward()) {
        return gaps;
    }
    let first = rows.successor_offsets[node.node_id().row() as usize];
    let mut exit = None;
    for (i, edge) in node.edges().enumerate().filter(|(_, e)| is_joint(e.kind())) {
        let Some(target) = edge.target() else { continue };
        let exit = *exit.get_or_insert_with(|| end(node, true));
        let (Some(exit), Some(entry)) = (exit, end(&target, false)) else { continue };
        let gap = between(exit, entry);
        if gap > building::JOINT.value {
            gaps.push((first + i as u32, gap));
        }
    }
    gaps
}

/// Whether an edge leads over a joint. Paths across roads begin anywhere within the lane that they touch; rules on them look
/// at that.
fn is_joint(kind: EdgeKind) -> bool {
    !matches!(kind, EdgeKind::Within | EdgeKind::CrossPath)
}

/// Both corners of a node's end: where it is left (`exit`) or entered.
fn end(node: &LaneNode<'_>, exit: bool) -> Option<[DVec3; 2]> {
    let lane = node.lane()?;
    let SRange { low: from, high: to } = node.s_range();
    let s = if node.is_forward() == exit { to } else { from };
    lane.edge_points_at(s)
}

/// Distance between two short segments that should lie in one line: the least from an end of one to the other.
fn between(a: [DVec3; 2], b: [DVec3; 2]) -> f64 {
    let to_segment = |p: DVec3, [from, to]: [DVec3; 2]| {
        let along = to - from;
        let squared = along.length_squared();
        let share = if squared > 0.0 {
            mapd_geometry::clamp((p - from).dot(along) / squared, 0.0, 1.0)
        } else {
            0.0
        };
        (from + along * share - p).length()
    };
    let ends = [(a[0], b), (a[1], b), (b[0], a), (b[1], a)];
    ends.into_iter().map(|(p, segment)| to_segment(p, segment)).fold(f64::INFINITY, f64::min)
}
