//! Memory of a search, owned by the caller.

use super::ends::ChainNode;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Memory of a search. It grows to 16 bytes and two bits per node of the largest map that it has seen, and what is open at once; then
/// searches allocate nothing. Those for alternatives need as much again, and the ways that they compare.
#[derive(Clone, Default)]
pub struct RouteScratch {
    labels: Vec<Label>,
    /// Tells labels of this search from those of earlier ones.
    round: u32,
    pub(super) heap: BinaryHeap<Open>,
    pub(super) start: Vec<ChainNode>,
    pub(super) target: Vec<ChainNode>,
    pub(super) path: Vec<PathNode>,
    /// The way that was found, or several of them.
    pub(super) hops: Vec<Hop>,
    /// Nodes of the goals' chains, as bits.
    goals: Vec<u64>,
    /// Lanes to be avoided, as bits; empty between searches.
    pub(super) closed: Vec<u64>,
    pub(super) others: Others,
}

/// Memory of a search for alternatives.
#[derive(Clone, Default)]
pub(super) struct Others {
    /// Best ways from nodes to the goal: the parent is the node that comes next.
    pub(super) back: Vec<Label>,
    pub(super) found: Vec<super::alternatives::KnownRoute>,
    /// Hops that are not taken from the node at which a way leaves another one.
    pub(super) banned: Vec<Hop>,
    /// Nodes that need not be looked at again, and those of the way that is looked at, as bits.
    pub(super) done: Vec<u64>,
    pub(super) seen: Vec<u64>,
    /// For each section, in each direction, which of the ways that are taken drive over it, as bits.
    pub(super) sections: Vec<u32>,
    /// What the way that is looked at drives on: place in `sections`, and length `[m]`.
    pub(super) driven: Vec<(usize, f64)>,
}

/// A part of a way: from one node into the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Hop {
    /// As a label's parent: where it comes from.
    pub(super) from: u32,
    /// The node that is entered; or a place of the goals' chain, with [`GOAL`] set; with [`DIRECT`] the goal lies ahead on the start's piece.
    pub(super) to: u32,
}

/// Marks the end of a way that enters the goals' chain from behind.
pub(super) const GOAL: u32 = 1 << 31;
/// Marks the end of a way whose goal lies on the start's own piece.
pub(super) const DIRECT: u32 = GOAL | 1 << 30;

/// Best known way to a node.
#[derive(Clone, Copy, Default)]
pub(super) struct Label {
    /// Cost up to the node's beginning.
    pub(super) cost: f64,
    /// The node before, with [`FROM_SIDE`] set after a change of lane; or a place of the start's chain, with
    /// [`FROM_START`] set.
    pub(super) parent: u32,
    pub(super) round: u32,
}

/// Marks a parent that is a place of the start's chain.
pub(super) const FROM_START: u32 = 1 << 31;
/// Marks a parent from which one has changed lanes. Maps that are searched have fewer nodes than this.
pub(super) const FROM_SIDE: u32 = 1 << 30;

/// A node on the found way, with how it is entered.
#[derive(Clone, Copy)]
pub(super) struct PathNode {
    pub(super) node: u32,
    pub(super) enter: super::Enter,
}

/// A node to be looked at; smallest key first, then smallest node.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Open {
    /// Bits of a cost that is not negative: they order as the numbers do.
    key: u64,
    pub(super) cost: u64,
    pub(super) node: u32,
}

impl Open {
    #[inline]
    pub(super) fn new(key: f64, cost: f64, node: u32) -> Self {
        Self { key: key.to_bits(), cost: cost.to_bits(), node }
    }

    #[inline]
    pub(super) fn key(&self) -> f64 {
        f64::from_bits(self.key)
    }
}

impl Ord for Open {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        (other.key, other.node).cmp(&(self.key, self.node))
    }
}

impl PartialOrd for Open {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Nodes beside start or target for which there is room at once.
const CHAIN: usize = 64;

impl RouteScratch {
    /// Scratch that need not grow for a map with this many nodes (`map.lane_nodes().len()`), as long as fewer are open at once.
    pub fn with_capacity(nodes: usize) -> Self {
        Self {
            labels: vec![Label::default(); nodes],
            round: 0,
            heap: BinaryHeap::with_capacity(nodes),
            start: Vec::with_capacity(CHAIN),
            target: Vec::with_capacity(CHAIN),
            path: Vec::with_capacity(nodes),
            hops: Vec::with_capacity(nodes),
            goals: vec![0; nodes.div_ceil(64)],
            closed: Vec::new(),
            others: Others::default(),
        }
    }

    /// Forgets the last search.
    pub(super) fn begin(&mut self, nodes: usize) {
        if self.labels.len() < nodes {
            self.labels.resize(nodes, Label::default());
            self.goals.resize(nodes.div_ceil(64), 0);
        }
        for own in self.target.drain(..) {
            if let Some(word) = self.goals.get_mut(own.node as usize / 64) {
                *word = 0;
            }
        }
        self.start.clear();
        self.path.clear();
        self.hops.clear();
        self.restart();
    }

    /// Forgets the labels, not the ends.
    pub(super) fn restart(&mut self) {
        self.round = self.round.wrapping_add(1);
        if self.round == 0 {
            // After 2³² searches old labels would look new.
            self.labels.fill(Label::default());
            self.others.back.fill(Label::default());
            self.round = 1;
        }
        self.heap.clear();
    }

    /// Notes the nodes of the goals' chain.
    pub(super) fn note_goals(&mut self) {
        for own in &self.target {
            if let Some(word) = self.goals.get_mut(own.node as usize / 64) {
                *word |= 1 << (own.node % 64);
            }
        }
    }

    /// Whether a node is one of the goals' chain.
    #[inline]
    pub(super) fn is_goal(&self, node: u32) -> bool {
        is_set(&self.goals, node)
    }

    /// Keeps ways from a node: nothing is better than what is known of it.
    pub(super) fn ban(&mut self, node: u32) {
        let round = self.round;
        if let Some(label) = self.labels.get_mut(node as usize) {
            *label = Label { cost: f64::NEG_INFINITY, parent: FROM_START, round };
        }
    }

    /// The label of a node that this search has come to.
    #[inline]
    pub(super) fn label(&self, node: u32) -> Option<Label> {
        self.labels.get(node as usize).copied().filter(|label| label.round == self.round)
    }

    /// The label of a node from which this search has come to the goal.
    #[inline]
    pub(super) fn back(&self, node: u32) -> Option<Label> {
        self.others.back.get(node as usize).copied().filter(|label| label.round == self.round)
    }

    /// As [`Self::improve`], of the way from a node on.
    pub(super) fn improve_back(&mut self, node: u32, cost: f64, next: u32) -> bool {
        improve(&mut self.others.back, self.round, node, Label { cost, parent: next, round: 0 })
    }

    /// Replaces the parent of a node that this search has come to.
    pub(super) fn set_parent(&mut self, node: u32, parent: u32) {
        let round = self.round;
        if let Some(label) = self.labels.get_mut(node as usize).filter(|l| l.round == round) {
            label.parent = parent;
        }
    }

    /// Cost of the best known way to a node; infinite if there is none.
    #[inline]
    pub(super) fn cost(&self, node: u32) -> f64 {
        match self.labels.get(node as usize) {
            Some(label) if label.round == self.round => label.cost,
            _ => f64::INFINITY,
        }
    }

    #[inline]
    pub(super) fn parent(&self, node: u32) -> Option<u32> {
        self.label(node).map(|label| label.parent)
    }

    /// Takes a way to a node if it is better than the best known one.
    #[inline]
    pub(super) fn improve(&mut self, node: u32, cost: f64, parent: u32) -> bool {
        improve(&mut self.labels, self.round, node, Label { cost, parent, round: 0 })
    }
}

#[inline]
fn improve(labels: &mut [Label], round: u32, node: u32, new: Label) -> bool {
    let Some(label) = labels.get_mut(node as usize) else { return false };
    if label.round == round && label.cost <= new.cost {
        return false;
    }
    *label = Label { round, ..new };
    true
}

/// Whether the bit of a row is set.
#[inline]
pub(super) fn is_set(bits: &[u64], row: u32) -> bool {
    bits.get(row as usize / 64).is_some_and(|word| word >> (row % 64) & 1 != 0)
}

/// Sets the bit of a row; whether it was not set before.
#[inline]
pub(super) fn set(bits: &mut [u64], row: u32) -> bool {
    let Some(word) = bits.get_mut(row as usize / 64) else { return false };
    let before = *word;
    *word |= 1 << (row % 64);
    before != *word
}
