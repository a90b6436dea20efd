//! What a search travels on: a map's lane graph, or the same under an overlay ([`View`](crate::view::View)), where nodes may be cut into pieces.

use super::bound::Bounds;
use crate::graph::LaneNode;
use crate::lane::{Lane, edges_of};
use crate::map::Map;
use crate::rules::SpeedRule;
use mapd_archive::{NONE, beside_row, node_flags};

/// Numbers stand for nodes of the map or, from its number of nodes on, for pieces of them.
pub(crate) trait Ways<'a>: Copy {
    /// The map below.
    fn map(&self) -> Map<'a>;

    /// How many numbers there are.
    fn count(&self) -> usize;

    /// The node of a number, or the piece as a node.
    fn node(&self, number: u32) -> Option<LaneNode<'a>>;

    /// The numbers that stand for a node of the map, in driving order: its own, or those of its pieces.
    fn pieces(&self, node: u32) -> std::ops::Range<u32>;

    /// What holds s of a lane, in one direction of travel.
    fn at(&self, lane: &Lane<'a>, s: f64, forward: bool) -> Option<u32>;

    /// What is entered from a node's end, in the order of the archive.
    fn ahead(&self, number: u32, enter: impl FnMut(u32));

    /// From whose end it is entered, in the order of the archive.
    fn behind(&self, number: u32, enter: impl FnMut(u32));

    /// What lies beside it to the left or right and travels the same way.
    fn beside(&self, number: u32, node: &LaneNode<'a>, left: bool) -> Option<u32>;

    /// Whether the second is the next piece of the first one's lane.
    fn follows(&self, before: u32, number: u32) -> bool;

    /// Least cost from its beginning to the target.
    fn least(&self, bounds: &Bounds<'a>, node: &LaneNode<'a>) -> f64;

    /// Whether landmarks give bounds.
    fn has_bounds(&self) -> bool;

    /// The speed limit on a node or piece where the map has this one.
    #[inline]
    fn limit(&self, _number: u32, map: SpeedRule) -> SpeedRule {
        map
    }

    /// Where a change of lane to the left or right leads, if the road marks allow one.
    #[inline]
    fn change(&self, number: u32, node: &LaneNode<'a>, left: bool) -> Option<u32> {
        let flag = if left { node_flags::CHANGE_LEFT } else { node_flags::CHANGE_RIGHT };
        if node.row.flags() & flag == 0 {
            return None;
        }
        self.beside(number, node, left)
    }

    /// What lies beside it to the left or right, if a change of lane leads from there.
    fn changes_from(&self, number: u32, node: &LaneNode<'a>, left: bool) -> Option<u32> {
        let beside = self.beside(number, node, left)?;
        let other = self.node(beside)?;
        (self.change(beside, &other, !left) == Some(number)).then_some(beside)
    }
}

impl<'a> Ways<'a> for Map<'a> {
    #[inline]
    fn map(&self) -> Map<'a> {
        *self
    }

    #[inline]
    fn count(&self) -> usize {
        self.tables().lane_nodes.len()
    }

    #[inline]
    fn node(&self, number: u32) -> Option<LaneNode<'a>> {
        LaneNode::new(*self, number)
    }

    fn pieces(&self, node: u32) -> std::ops::Range<u32> {
        node..node.saturating_add(1)
    }

    fn at(&self, lane: &Lane<'a>, s: f64, forward: bool) -> Option<u32> {
        lane.node_at(s, forward).map(|node| node.number)
    }

    #[inline]
    fn ahead(&self, number: u32, mut enter: impl FnMut(u32)) {
        let tables = self.tables();
        for next in edges_of(tables.successor_offsets, tables.successors, number) {
            enter(*next);
        }
    }

    #[inline]
    fn behind(&self, number: u32, mut enter: impl FnMut(u32)) {
        let tables = self.tables();
        for before in edges_of(tables.predecessor_offsets, tables.predecessors, number) {
            enter(*before);
        }
    }

    #[inline]
    fn beside(&self, number: u32, node: &LaneNode<'a>, left: bool) -> Option<u32> {
        let beside = if left { node.row.left() } else { node.row.right() };
        Some(beside_row(number, beside)).filter(|row| *row != NONE)
    }

    #[inline]
    fn follows(&self, before: u32, number: u32) -> bool {
        before.checked_add(1) == Some(number)
    }

    #[inline]
    fn least(&self, bounds: &Bounds<'a>, node: &LaneNode<'a>) -> f64 {
        bounds.least(node.row)
    }

    #[inline]
    fn has_bounds(&self) -> bool {
        true
    }
}
