//! Anchors: nodes that have a place in the landmarks' tables, and how far behind its anchor each of the others lies.
//!
//! A node that is entered from one other alone, which leads to it alone, needs no place of its own: with the way w from its
//! anchor a to it and any landmark L, d(L, v) ≤ d(L, a) + w and d(v, L) ≥ d(a, L) − w, both equal but for changes of lane.

use super::csr::in_order;
use mapd_archive::{NONE, Rows, VehicleClass};

/// Largest distance from an anchor, in steps.
const MOST_STEPS: f64 = 65_535.0;

/// Where the distances of a node are taken from.
#[derive(Clone, Copy)]
pub(super) struct Anchored {
    /// The anchor; itself for an anchor; [`NONE`] for a node that no motor vehicle may use.
    pub(super) anchor: u32,
    /// Length and time from the anchor's beginning to the node's, in steps, rounded up.
    pub(super) steps: [u16; 2],
}

const NOT_YET: Anchored = Anchored { anchor: NONE, steps: [0; 2] };

/// The nodes' anchors, of the steps for length and time; some nodes, as landmarks, are anchors in any case. What is an anchor depends on names
/// only, not on the order of the file.
pub(super) fn find(rows: &Rows, fixed: &[u32], steps: [f64; 2]) -> Vec<Anchored> {
    let mut anchors = vec![NOT_YET; rows.lane_nodes.len()];
    for node in fixed {
        if let Some(own) = anchors.get_mut(*node as usize) {
            own.anchor = *node;
        }
    }
    let (mut way, mut on_way) = (Vec::new(), vec![false; rows.lane_nodes.len()]);
    for node in in_order(rows).filter(|node| is_open(rows, *node)) {
        // Back to a node whose anchor is known, that is one itself, or that closes a loop.
        let mut at = node;
        let known = |anchors: &[Anchored], node: u32| {
            anchors.get(node as usize).copied().filter(|a| a.anchor != NONE)
        };
        while known(&anchors, at).is_none() {
            way.push(at);
            on_way[at as usize] = true;
            match parent(rows, at).filter(|before| !on_way[*before as usize]) {
                Some(before) => at = before,
                None => {
                    anchors[at as usize] = Anchored { anchor: at, ..NOT_YET };
                    break;
                }
            }
        }
        while let Some(own) = way.pop() {
            on_way[own as usize] = false;
            if known(&anchors, own).is_none() {
                let before = parent(rows, own).unwrap_or(own);
                anchors[own as usize] = behind(rows, before, anchors[before as usize], steps)
                    .unwrap_or(Anchored { anchor: own, ..NOT_YET });
            }
        }
    }
    anchors
}

fn is_open(rows: &Rows, node: u32) -> bool {
    rows.lane_nodes.get(node as usize).is_some_and(|row| row.access & VehicleClass::MOTOR != 0)
}

fn open_ends<'a>(
    rows: &'a Rows,
    offsets: &'a [u32],
    ends: &'a [u32],
    node: u32,
) -> impl Iterator<Item = u32> + 'a {
    let at = |i: usize| offsets.get(i).copied().unwrap_or(0) as usize;
    let own = ends.get(at(node as usize)..at(node as usize + 1)).unwrap_or(&[]);
    own.iter().copied().filter(|end| is_open(rows, *end))
}

/// The one node from which a node is entered; none for one that may be a route's last anchor, because nothing follows.
fn parent(rows: &Rows, node: u32) -> Option<u32> {
    let mut before = open_ends(rows, &rows.predecessor_offsets, &rows.predecessors, node);
    let first = before.next().filter(|_| before.next().is_none());
    let goes_on = open_ends(rows, &rows.successor_offsets, &rows.successors, node).next().is_some();
    first.filter(|_| goes_on)
}

/// The anchor of what follows a node.
fn behind(rows: &Rows, node: u32, own: Anchored, [length, time]: [f64; 2]) -> Option<Anchored> {
    let row = rows.lane_nodes.get(node as usize)?;
    let mut ahead = open_ends(rows, &rows.successor_offsets, &rows.successors, node);
    // Behind a fork, distances to landmarks on another branch say nothing of this one.
    let is_fork = ahead.nth(1).is_some();
    let add = |before: u16, more: f32, step: f64| {
        // At least one: 0 stands for the anchor itself.
        let sum = f64::from(before) + (f64::from(more) / step).ceil().max(1.0);
        (sum <= MOST_STEPS).then_some(sum as u16)
    };
    let steps = [add(own.steps[0], row.length, length)?, add(own.steps[1], row.time, time)?];
    (!is_fork).then_some(Anchored { anchor: own.anchor, steps })
}
