//! Proving the lane graph: rows that fit together, mirrored edges, an order of components, loops that are closed where
//! the flags say so.

use crate::error::VerifyError;
use crate::graph_codes::edge_flags;
use crate::verify::Check;
use crate::{NONE, Tables, beside_row};

pub(crate) fn graph(tables: &Tables<'_>) -> Result<(), VerifyError> {
    let nodes = tables.lane_nodes.len();
    let at = |table| Check { table, row: 0 };
    let Some(graph) = tables.graph.first().filter(|_| tables.graph.len() == 1) else {
        return at("graph").fail("", "exactly one row", tables.graph.len());
    };
    if tables.edges.len() != tables.successors.len() {
        return at("edges").fail("", tables.successors.len().to_string(), tables.edges.len());
    }
    offsets("successor_offsets", tables.successor_offsets, nodes, tables.successors.len())?;
    offsets("predecessor_offsets", tables.predecessor_offsets, nodes, tables.predecessors.len())?;
    owners(tables)?;
    mirror(tables)?;
    for (row, node) in tables.lane_nodes.iter().enumerate() {
        let check = Check { table: "lane_nodes", row };
        if node.component() >= graph.components() {
            return check.fail(
                "component",
                format!("below {}", graph.components()),
                node.component(),
            );
        }
        for (field, beside) in [("left", node.left()), ("right", node.right())] {
            let beside = beside_row(row as u32, beside);
            if beside != NONE && beside as usize >= nodes {
                return check.fail(field, format!("a node below {nodes}"), beside);
            }
        }
        if node.bound() != NONE && node.bound() >= graph.bounds() {
            return check.fail("bound", format!("below {}", graph.bounds()), node.bound());
        }
    }
    let expected = u64::from(graph.bounds()) * u64::from(graph.landmarks()) * 2;
    for (table, found) in [
        ("landmark_lengths", tables.landmark_lengths.len()),
        ("landmark_times", tables.landmark_times.len()),
    ] {
        if found as u64 != expected {
            return at(table).fail("", expected.to_string(), found);
        }
    }
    for (row, pair) in tables.conflicts.windows(2).enumerate() {
        if pair[1].lane() < pair[0].lane() {
            let check = Check { table: "conflicts", row: row + 1 };
            return check.fail("lane", format!("at least {}", pair[0].lane()), pair[1].lane());
        }
    }
    for (row, pair) in tables.speed_signs_at_entry.windows(2).enumerate() {
        if pair[1].lane() <= pair[0].lane() {
            let check = Check { table: "speed_signs_at_entry", row: row + 1 };
            return check.fail("lane", format!("above {}", pair[0].lane()), pair[1].lane());
        }
    }
    components(tables)?;
    loops(tables)
}

/// Compressed sparse rows: ascending from 0 to the number of entries.
fn offsets(
    table: &'static str,
    offsets: &[u32],
    nodes: usize,
    entries: usize,
) -> Result<(), VerifyError> {
    let check = |row| Check { table, row };
    if offsets.len() != nodes + 1 {
        return check(0).fail("", (nodes + 1).to_string(), offsets.len());
    }
    if offsets.first() != Some(&0) || offsets.last().map(|l| *l as usize) != Some(entries) {
        return check(0).fail("", format!("offsets from 0 to {entries}"), offsets.len());
    }
    match offsets.windows(2).position(|pair| pair[1] < pair[0]) {
        Some(row) => check(row + 1).fail("", "ascending offsets", offsets[row + 1]),
        None => Ok(()),
    }
}

/// Nodes know their lane, lane by lane.
fn owners(tables: &Tables<'_>) -> Result<(), VerifyError> {
    let mut next = 0;
    for (row, lane) in tables.lanes.iter().enumerate() {
        let nodes = lane.nodes();
        let check = Check { table: "lanes", row };
        if nodes.count > 0 && nodes.first != next {
            return check.fail("nodes", format!("a range from {next}"), nodes.first);
        }
        next += nodes.count;
        if let Some(node) = nodes.of(tables.lane_nodes).iter().find(|n| n.lane() as usize != row) {
            return check.fail("nodes", "nodes of this lane", node.lane());
        }
    }
    if next as usize != tables.lane_nodes.len() {
        return Check { table: "lane_nodes", row: next as usize }.fail("lane", "a lane", "none");
    }
    Ok(())
}

/// Entries of a node.
fn entries<'a>(offsets: &[u32], targets: &'a [u32], node: usize) -> &'a [u32] {
    match offsets.get(node..node + 2) {
        Some(&[from, to]) => targets.get(from as usize..to as usize).unwrap_or(&[]),
        _ => &[],
    }
}

/// Backward rows are the forward ones turned round.
fn mirror(tables: &Tables<'_>) -> Result<(), VerifyError> {
    if is_mirrored(tables) {
        return Ok(());
    }
    // Only what is wrong is worth sorting all edges, to name the first one.
    let all = |offsets: &[u32], targets: &[u32], turned: bool| {
        let mut edges: Vec<(u32, u32)> = Vec::with_capacity(targets.len());
        for node in 0..tables.lane_nodes.len() {
            let of_node = entries(offsets, targets, node).iter();
            let node = node as u32;
            edges.extend(of_node.map(|to| if turned { (*to, node) } else { (node, *to) }));
        }
        edges.sort_unstable();
        edges
    };
    let forward = all(tables.successor_offsets, tables.successors, false);
    let backward = all(tables.predecessor_offsets, tables.predecessors, true);
    match forward.iter().zip(&backward).position(|(a, b)| a != b) {
        None if forward.len() == backward.len() => Ok(()),
        at => {
            let row = at.unwrap_or(forward.len().min(backward.len()));
            let text = |edge: Option<&(u32, u32)>| format!("{edge:?}");
            Check { table: "predecessors", row }.fail(
                "",
                text(forward.get(row)),
                text(backward.get(row)),
            )
        }
    }
}

/// Whether each node's predecessors are the nodes that it succeeds.
fn is_mirrored(tables: &Tables<'_>) -> bool {
    let nodes = tables.lane_nodes.len();
    let (offsets, backward) = (tables.predecessor_offsets, tables.predecessors);
    if backward.len() != tables.successors.len() {
        return false;
    }
    // Forward edges put where backward ones are: those of one node come in ascending order.
    let (mut turned, mut next) = (vec![NONE; backward.len()], offsets.to_vec());
    for from in 0..nodes {
        for to in entries(tables.successor_offsets, tables.successors, from) {
            let to = *to as usize;
            let (Some(place), Some(end)) = (next.get_mut(to), offsets.get(to + 1)) else {
                return false;
            };
            if *place >= *end {
                return false;
            }
            let Some(own) = turned.get_mut(*place as usize) else { return false };
            *own = from as u32;
            *place += 1;
        }
    }
    let mut own = Vec::new();
    (0..nodes).all(|node| {
        own.clear();
        own.extend_from_slice(entries(offsets, backward, node));
        own.sort_unstable();
        own == entries(offsets, &turned, node)
    })
}

/// No edge leads to a component with a lower number.
fn components(tables: &Tables<'_>) -> Result<(), VerifyError> {
    for (row, node) in tables.lane_nodes.iter().enumerate() {
        for to in entries(tables.successor_offsets, tables.successors, row) {
            let target = tables.lane_nodes.get(*to as usize).map_or(0, |node| node.component());
            if target < node.component() {
                let check = Check { table: "lane_nodes", row };
                return check.fail("component", format!("at most {target}"), node.component());
            }
        }
    }
    Ok(())
}

/// Without the edges that close loops the graph sorts topologically (Kahn).
fn loops(tables: &Tables<'_>) -> Result<(), VerifyError> {
    let edges = |node: usize| {
        let first = tables.successor_offsets.get(node).copied().unwrap_or(0) as usize;
        entries(tables.successor_offsets, tables.successors, node)
            .iter()
            .zip(tables.edges.get(first..).unwrap_or(&[]))
            .filter(|(_, edge)| edge.flags() & edge_flags::CLOSES_LOOP == 0)
            .map(|(to, _)| *to as usize)
    };
    let nodes = tables.lane_nodes.len();
    let mut before = vec![0u32; nodes];
    for to in (0..nodes).flat_map(edges) {
        if let Some(count) = before.get_mut(to) {
            *count += 1;
        }
    }
    let mut open: Vec<usize> = (0..nodes).filter(|node| before[*node] == 0).collect();
    let mut sorted = 0;
    while let Some(node) = open.pop() {
        sorted += 1;
        for to in edges(node) {
            if let Some(count) = before.get_mut(to) {
                *count -= 1;
                if *count == 0 {
                    open.push(to);
                }
            }
        }
    }
    if sorted == nodes {
        return Ok(());
    }
    let row = before.iter().position(|count| *count > 0).unwrap_or(0);
    Check { table: "edges", row }.fail("flags", "a graph without loops", "one that has them")
}
