//! Which cycles a map may have.
//!
//! Lawful networks are full of cycles: blocks, roundabouts, ring roads. What no network may have is a cycle within one
//! junction's connecting roads, and one without any length. `CyclePolicy` says what else counts.

use super::components::strong_components;
use super::report::Report;
use crate::findings::Graded;
use crate::options::CyclePolicy;
use mapd_archive::{EdgeKind, LaneNodeRow, NONE, Rows, VehicleClass};
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity};
use std::collections::VecDeque;

/// Cycles of at most this length `[m]` make no progress.
const LEAST_CYCLE: f64 = 1.0;
/// Cycles of one kind that are looked for, and edges that are followed for them at most: a hostile file may have more
/// cycles than anybody reads.
const MOST_CYCLES: usize = 1000;
const MOST_STEPS: usize = 100_000_000;
/// Steps of a cycle's path that are named.
const NAMED_STEPS: usize = 50;

/// Finds cycles and reports them by policy.
pub(crate) fn check(rows: &Rows, policy: CyclePolicy, mut report: Report<'_>) -> Vec<Finding> {
    report_all(rows, policy, &mut report);
    report.finish()
}

fn report_all(rows: &Rows, policy: CyclePolicy, report: &mut Report<'_>) {
    let severity = match policy {
        CyclePolicy::Illegal | CyclePolicy::All => Severity::Error,
        CyclePolicy::Report => Severity::Warning,
    };
    let junction = junctions(rows);
    let within_junction = |from: usize, to: usize| {
        let own = junction.get(from).copied().unwrap_or(NONE);
        own != NONE && junction.get(to) == Some(&own)
    };
    cycles(rows, false, within_junction, |path| {
        let what = "a way through the junction that leaves it";
        report_path(rows, report, Graded { rule: &building::JUNCTION_CYCLE, severity }, what, path);
    });
    let short = |node: usize| {
        rows.lane_nodes.get(node).is_some_and(|row| f64::from(row.length) <= LEAST_CYCLE)
    };
    cycles(
        rows,
        false,
        |from, to| short(from) && short(to),
        |path| {
            let length: f64 = path.iter().map(|edge| edge_length(rows, *edge)).sum();
            if length <= LEAST_CYCLE {
                let what = "a loop longer than 1 m";
                report_path(
                    rows,
                    report,
                    Graded { rule: &building::NO_PROGRESS, severity },
                    what,
                    path,
                );
            }
        },
    );
    let others = match policy {
        CyclePolicy::Illegal => return,
        CyclePolicy::All => Severity::Error,
        CyclePolicy::Report => Severity::Info,
    };
    // Where they are errors, each is one that something has to be left out for.
    let once = policy == CyclePolicy::Report;
    cycles(
        rows,
        once,
        |_, _| true,
        |path| {
            report_path(
                rows,
                report,
                Graded { rule: &building::CYCLE, severity: others },
                "no loop",
                path,
            );
        },
    );
}

/// Per node the junction whose connecting road it lies on; none where nobody drives: who walks may go round as they like.
fn junctions(rows: &Rows) -> Vec<u32> {
    let on_foot = VehicleClass::Pedestrian.bit() | VehicleClass::Bicycle.bit();
    let of = |lane: u32| {
        let section = rows.sections.get(rows.lanes.get(lane as usize)?.section as usize)?;
        Some(rows.roads.get(section.road as usize)?.junction)
    };
    let of_node = |node: &LaneNodeRow| {
        let walked = node.access != 0 && node.access & !on_foot == 0;
        of(node.lane).filter(|_| !walked).unwrap_or(NONE)
    };
    rows.lane_nodes.iter().map(of_node).collect()
}

fn edge_length(rows: &Rows, edge: u32) -> f64 {
    rows.lane_nodes.get(left_by(rows, edge) as usize).map_or(0.0, |node| f64::from(node.length))
}

/// Finds cycles of kept edges, each the shortest (by number of edges) through its first node, none sharing a node with an
/// earlier one, and hands over their edges; only the first of each component if `once`.
fn cycles(
    rows: &Rows,
    once: bool,
    keep: impl Fn(usize, usize) -> bool,
    mut found: impl FnMut(&[u32]),
) {
    let order: Vec<u32> = super::csr::in_order(rows).collect();
    let kept = |from: u32| {
        let at = |i: usize| rows.successor_offsets.get(i).copied().unwrap_or(0);
        let keep = &keep;
        (at(from as usize)..at(from as usize + 1)).filter_map(move |edge| {
            let to = rows.successors.get(edge as usize).copied()?;
            keep(from as usize, to as usize).then_some((edge, to))
        })
    };
    // A cycle of kept edges lies in one component of the graph that they make.
    let (components, count) =
        strong_components(rows, &order, |from, to| keep(from as usize, to as usize));
    let mut sizes = vec![0u32; count as usize];
    for component in &components {
        sizes[*component as usize] += 1;
    }
    let mut seen = vec![false; count as usize];
    let nodes = rows.lane_nodes.len();
    let (mut round, mut state, mut parent) = (0, vec![0u32; nodes], vec![NONE; nodes]);
    let (mut done, mut steps, mut named) = (vec![false; nodes], 0usize, 0usize);
    for root in order {
        let component = components[root as usize] as usize;
        let may = sizes[component] > 1 || kept(root).any(|(_, to)| to == root);
        if !may || seen[component] || done[root as usize] {
            continue;
        }
        if named >= MOST_CYCLES || steps > MOST_STEPS {
            break;
        }
        round += 1;
        let mut queue = VecDeque::from([root]);
        let mut last = None;
        'search: while let Some(node) = queue.pop_front() {
            for (edge, to) in kept(node) {
                steps += 1;
                if components[to as usize] as usize != component {
                    continue;
                }
                if to == root {
                    last = Some((node, edge));
                    break 'search;
                }
                if state[to as usize] != round && !done[to as usize] {
                    state[to as usize] = round;
                    parent[to as usize] = edge;
                    queue.push_back(to);
                }
            }
        }
        // A node on no cycle need not be looked at again.
        done[root as usize] = true;
        let Some((mut node, edge)) = last else { continue };
        let mut path = vec![edge];
        while node != root {
            let edge = parent[node as usize];
            path.push(edge);
            node = left_by(rows, edge);
        }
        path.reverse();
        seen[component] = once;
        for edge in &path {
            done[left_by(rows, *edge) as usize] = true;
        }
        named += 1;
        found(&path);
    }
}

/// The node that an edge leaves.
fn left_by(rows: &Rows, edge: u32) -> u32 {
    rows.successor_offsets.partition_point(|first| *first <= edge).saturating_sub(1) as u32
}

/// Turns a cycle so that it begins with a link of a junction's connection, if it has one: that is the smallest part that can be
/// left out to break it. Yields the edge that it begins with.
fn start(rows: &Rows, path: &mut [u32]) -> Option<u32> {
    let of_connection = [EdgeKind::Connection.code(), EdgeKind::Implied.code()];
    let is_small = |edge: &u32| {
        rows.edges.get(*edge as usize).is_some_and(|row| of_connection.contains(&row.kind))
    };
    path.rotate_left(path.iter().position(is_small).unwrap_or(0));
    path.first().copied()
}

fn report_path(rows: &Rows, report: &mut Report<'_>, graded: Graded, expected: &str, path: &[u32]) {
    // Steps between pieces of one lane are none that the file could name.
    let within = EdgeKind::Within.code();
    let mut named: Vec<u32> = path
        .iter()
        .copied()
        .filter(|edge| rows.edges.get(*edge as usize).is_some_and(|row| row.kind != within))
        .collect();
    let Some(first) = start(rows, &mut named).or(path.first().copied()) else { return };
    let mut steps: Vec<String> = named
        .iter()
        .take(NAMED_STEPS)
        .map(|edge| {
            let from = report.node_text(left_by(rows, *edge));
            format!("{from} (link at {})", report.place_text(*edge))
        })
        .collect();
    if named.len() > NAMED_STEPS {
        steps.push(format!("… {} more", named.len() - NAMED_STEPS));
    }
    steps.push(report.node_text(left_by(rows, first)));
    let message = format!("expected {expected}, found the cycle {}", steps.join(" → "));
    report.at_edge(graded.rule, graded.severity, first, message);
}
