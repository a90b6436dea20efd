//! Memory of a search, owned by the caller.

use super::ends::ChainNode;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Memory of a search. It grows to 16 bytes per node of the largest map that it has seen, and what is open at once;
/// then searches allocate nothing.
#[derive(Clone, Default)]
pub struct RouteScratch {
    labels: Vec<Label>,
    /// Tells labels of this search from those of earlier ones.
    round: u32,
    pub(super) heap: BinaryHeap<Open>,
    pub(super) start: Vec<ChainNode>,
    pub(super) target: Vec<ChainNode>,
    pub(super) path: Vec<PathNode>,
}

/// Best known way to a node.
#[derive(Clone, Copy, Default)]
pub(super) struct Label {
    /// Cost up to the node's beginning.
    pub(super) cost: f64,
    /// The node before, with [`FROM_SIDE`] set after a change of lane; or a place of the start's chain, with
    /// [`FROM_START`] set.
    pub(super) parent: u32,
    round: u32,
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
    /// Scratch that needs not grow for a map of so many nodes (`map.lane_nodes().len()`), as long as fewer are open at once.
    pub fn with_capacity(nodes: usize) -> Self {
        Self {
            labels: vec![Label::default(); nodes],
            round: 0,
            heap: BinaryHeap::with_capacity(nodes),
            start: Vec::with_capacity(CHAIN),
            target: Vec::with_capacity(CHAIN),
            path: Vec::with_capacity(nodes),
        }
    }

    /// Forgets the last search.
    pub(super) fn begin(&mut self, nodes: usize) {
        if self.labels.len() < nodes {
            self.labels.resize(nodes, Label::default());
        }
        self.round = self.round.wrapping_add(1);
        if self.round == 0 {
            // After 2³² searches old labels would look new.
            self.labels.fill(Label::default());
            self.round = 1;
        }
        self.heap.clear();
        self.start.clear();
        self.target.clear();
        self.path.clear();
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
        self.labels.get(node as usize).filter(|l| l.round == self.round).map(|l| l.parent)
    }

    /// Takes a way to a node if it is better than the best known one.
    #[inline]
    pub(super) fn improve(&mut self, node: u32, cost: f64, parent: u32) -> bool {
        let round = self.round;
        let Some(label) = self.labels.get_mut(node as usize) else { return false };
        if label.round == round && label.cost <= cost {
            return false;
        }
        *label = Label { cost, parent, round };
        true
    }
}
