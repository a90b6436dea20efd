//! Edges as compressed sparse rows, forward and backward.

use super::walk::Edge;
use crate::draft::Draft;
use crate::findings::TooLarge;
use mapd_archive::{EdgeRow, NONE, Rows};
use mapd_xodr::Span;
use mapd_xodr::source::{NearPlaces, Places};
use rayon::prelude::*;

/// Stores edges, which come by the node that is left; gives each edge's place in the file. Those of one node are ordered by road id, section and lane of the
/// node that is entered, so that the order of elements in the file does not show.
pub(crate) fn store(
    draft: &mut Draft,
    mut edges: Vec<Edge>,
    places: &Places,
) -> Result<Vec<Span>, TooLarge> {
    if edges.len() >= NONE as usize {
        return Err(TooLarge::new("successors"));
    }
    let rank = ranks(&draft.rows);
    let key = |node: u32| rank.get(node as usize).copied().unwrap_or(NONE);
    for of_node in edges.chunk_by_mut(|a, b| a.from == b.from) {
        of_node.sort_by_key(|edge| (key(edge.to), edge.kind.code(), edge.span.start));
    }
    // A file may state a link twice.
    edges.dedup_by_key(|edge| (edge.from, edge.to));
    let rows = &mut draft.rows;
    let nodes = rows.lane_nodes.len();
    rows.successor_offsets = offsets(nodes, edges.iter().map(|edge| edge.from)).into();
    rows.successors = edges.iter().map(|edge| edge.to).collect::<Vec<_>>().into();
    rows.predecessor_offsets = offsets(nodes, edges.iter().map(|edge| edge.to)).into();
    let (told, backward) = rayon::join(
        || {
            let places = places.main_file();
            edges.par_iter().map(|edge| row(edge, &places)).collect::<Vec<_>>()
        },
        || backward(&edges, &rows.predecessor_offsets, key),
    );
    rows.edges = told.into();
    rows.predecessors = backward.into();
    rows.graph.push(bytemuck::Zeroable::zeroed());
    Ok(edges.iter().map(|edge| edge.span).collect())
}

/// The nodes before each node, in the order of their keys.
fn backward(edges: &[Edge], offsets: &[u32], key: impl Fn(u32) -> u32) -> Vec<u32> {
    let mut nodes = vec![NONE; edges.len()];
    let mut next = offsets.to_vec();
    for edge in edges {
        let Some(place) = next.get_mut(edge.to as usize) else { continue };
        if let Some(node) = nodes.get_mut(*place as usize) {
            *node = edge.from;
        }
        *place += 1;
    }
    let mut rest = nodes.as_mut_slice();
    for (from, to) in offsets.iter().zip(offsets.iter().skip(1)) {
        let Some((own, behind)) = rest.split_at_mut_checked((to - from) as usize) else { break };
        own.sort_unstable_by_key(|node| key(*node));
        rest = behind;
    }
    nodes
}

fn row(edge: &Edge, places: &NearPlaces) -> EdgeRow {
    let nowhere = edge.span == Span::default();
    let start = edge.span.start;
    let position = if nowhere { Default::default() } else { places.position(start) };
    EdgeRow {
        line: position.line,
        column: position.column,
        file: places.all.file_at(start),
        kind: edge.kind.code(),
        flags: 0,
    }
}

/// First entry of each node and their number, from the node of each entry.
pub(crate) fn offsets(nodes: usize, entries: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut offsets = vec![0; nodes + 1];
    for node in entries {
        if let Some(count) = offsets.get_mut(node as usize + 1) {
            *count += 1;
        }
    }
    let mut sum = 0;
    for offset in &mut offsets {
        sum += *offset;
        *offset = sum;
    }
    offsets
}

/// Per node its place in the order of road ids, sections, lanes from left to right, directions and pieces.
pub(crate) fn ranks(rows: &Rows) -> Vec<u32> {
    let mut ranks = vec![NONE; rows.lane_nodes.len()];
    for (place, node) in in_order(rows).enumerate() {
        if let Some(rank) = ranks.get_mut(node as usize) {
            *rank = place as u32;
        }
    }
    ranks
}

/// All nodes in the order of [`ranks`]: it depends on names only, not on the order of elements in the file.
pub(crate) fn in_order(rows: &Rows) -> impl Iterator<Item = u32> + '_ {
    let roads = rows.roads_by_id.iter().filter_map(|road| rows.roads.get(*road as usize));
    roads
        .flat_map(|road| road.sections.of(&rows.sections))
        .flat_map(|section| section.lanes.of(&rows.lanes))
        .flat_map(|lane| lane.nodes().first..lane.nodes().end() as u32)
}
