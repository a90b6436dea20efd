//! Strongly connected components, their topological order, and the edges that close loops.
//!
//! Lawful road networks have cycles (blocks, roundabouts, ring roads). They are condensed: components are numbered in a
//! topological order of the condensation, and a set of edges is marked without which the graph has no cycle. Both depend
//! on names only: nodes are visited in the order of [`super::csr::in_order`].

use super::csr::in_order;
use mapd_archive::{NONE, Rows, edge_flags};

/// What is found about components.
pub(crate) struct Components {
    /// Per node its component, in the order in which they are finished.
    of_node: Vec<u32>,
    count: u32,
    /// Edges that close loops.
    closing: Vec<usize>,
}

/// Finds components and the edges that close loops.
pub(crate) fn find(rows: &Rows) -> Components {
    let order: Vec<u32> = in_order(rows).collect();
    let (of_node, count) = strong_components(rows, &order, |_, _| true);
    Components { of_node, count, closing: back_edges(rows, &order) }
}

impl Components {
    /// Fills `component` of all nodes, `closes_loop` of all edges, and the number of components.
    pub(crate) fn store(self, rows: &mut Rows) {
        // Tarjan finishes a component after all that it leads to: turned round, the numbers ascend along edges.
        for (node, component) in rows.lane_nodes.iter_mut().zip(&self.of_node) {
            node.component = self.count - 1 - component;
        }
        if let Some(graph) = rows.graph.first_mut() {
            graph.components = self.count;
        }
        for edge in self.closing {
            rows.edges[edge].flags |= edge_flags::CLOSES_LOOP;
        }
    }
}

/// Entries of a node in `successors`.
fn entries(rows: &Rows, node: u32) -> std::ops::Range<usize> {
    let at = |i: usize| rows.successor_offsets.get(i).copied().unwrap_or(0) as usize;
    at(node as usize)..at(node as usize + 1)
}

/// Tarjan's algorithm over the kept edges, with a stack of its own: per node its component, in the order in which they are
/// finished.
pub(crate) fn strong_components(
    rows: &Rows,
    order: &[u32],
    keep: impl Fn(u32, u32) -> bool,
) -> (Vec<u32>, u32) {
    let nodes = rows.lane_nodes.len();
    let (mut index, mut low) = (vec![NONE; nodes], vec![NONE; nodes]);
    let (mut component, mut count) = (vec![NONE; nodes], 0);
    let (mut open, mut calls): (Vec<u32>, Vec<(u32, usize)>) = (Vec::new(), Vec::new());
    let mut next = 0;
    for root in order {
        if index[*root as usize] != NONE {
            continue;
        }
        calls.push((*root, entries(rows, *root).start));
        index[*root as usize] = next;
        low[*root as usize] = next;
        next += 1;
        open.push(*root);
        while let Some((node, edge)) = calls.last_mut() {
            let own = *node as usize;
            if *edge < entries(rows, *node).end {
                let to = rows.successors[*edge];
                *edge += 1;
                let target = to as usize;
                if !keep(*node, to) {
                    continue;
                }
                if index[target] == NONE {
                    index[target] = next;
                    low[target] = next;
                    next += 1;
                    open.push(to);
                    calls.push((to, entries(rows, to).start));
                } else if component[target] == NONE {
                    low[own] = low[own].min(index[target]);
                }
                continue;
            }
            calls.pop();
            if let Some((parent, _)) = calls.last() {
                let parent = *parent as usize;
                low[parent] = low[parent].min(low[own]);
            }
            if low[own] == index[own] {
                while let Some(member) = open.pop() {
                    component[member as usize] = count;
                    if member as usize == own {
                        break;
                    }
                }
                count += 1;
            }
        }
    }
    (component, count)
}

/// Edges that lead back into the path of a depth-first search: from nodes that nothing enters first, then from the rest.
fn back_edges(rows: &Rows, order: &[u32]) -> Vec<usize> {
    const OPEN: u8 = 1;
    const DONE: u8 = 2;
    let mut state = vec![0u8; rows.lane_nodes.len()];
    let mut closing = Vec::new();
    let mut calls: Vec<(u32, usize)> = Vec::new();
    let entered = |node: &u32| {
        let at = *node as usize;
        rows.predecessor_offsets.get(at) != rows.predecessor_offsets.get(at + 1)
    };
    let (rest, roots): (Vec<u32>, Vec<u32>) = order.iter().partition(|node| entered(node));
    for root in roots.into_iter().chain(rest) {
        if state[root as usize] != 0 {
            continue;
        }
        state[root as usize] = OPEN;
        calls.push((root, entries(rows, root).start));
        while let Some((node, edge)) = calls.last_mut() {
            if *edge >= entries(rows, *node).end {
                state[*node as usize] = DONE;
                calls.pop();
                continue;
            }
            let to = rows.successors[*edge];
            match state[to as usize] {
                OPEN => closing.push(*edge),
                0 => {
                    *edge += 1;
                    state[to as usize] = OPEN;
                    calls.push((to, entries(rows, to).start));
                    continue;
                }
                _ => {}
            }
            *edge += 1;
        }
    }
    closing
}
