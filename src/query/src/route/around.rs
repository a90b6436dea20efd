//! Anchors around a target: its distances from and to landmarks follow from theirs.
//!
//! Each way to the target passes an anchor or begins behind the last one, and landmarks are anchors. So the distance from a landmark is the
//! least over the anchors behind, each with the way from it; the distance to a landmark is at most that over any anchor ahead.

use crate::graph::LaneNode;
use crate::lane::edges_of;
use crate::map::Map;
use mapd_archive::{NONE, VehicleClass, node_flags};

/// Nodes behind a target that are looked at, anchors among them: the lanes beside it back to the last junction. Where there are more, no
/// bounds from landmarks are known.
const MOST_BEHIND: usize = 96;
/// Nodes ahead that are looked at.
const MOST_AHEAD: usize = 1024;
/// Anchors ahead that count: branches of one fork.
const MOST_EXITS: usize = 8;

/// Anchors before and after a target, with the way between, in metres or seconds.
pub(super) struct NearAnchors {
    behind: Nearest<MOST_BEHIND>,
    ahead: Nearest<MOST_EXITS>,
}

/// Nodes with the ways to or from the target.
struct Nearest<const MOST: usize> {
    nodes: [(NodeNumber, f64); MOST],
    count: usize,
}

/// Row of a node, and the place of its distances if it is an anchor.
type NodeNumber = (u32, Option<u32>);

impl<const MOST: usize> Nearest<MOST> {
    const NONE: Self = Self { nodes: [((NONE, None), 0.0); MOST], count: 0 };

    /// Notes a way to a node; whether it is the best so far, or none if there is no room.
    fn add(&mut self, node: &LaneNode<'_>, way: f64) -> Option<bool> {
        let known = self.nodes[..self.count].iter_mut().find(|own| own.0.0 == node.number);
        if let Some(known) = known {
            let better = way < known.1;
            known.1 = known.1.min(way);
            return Some(better);
        }
        let anchor = (node.row.anchor_length() == 0).then(|| node.row.bound());
        *self.nodes.get_mut(self.count)? = ((node.number, anchor), way);
        self.count += 1;
        Some(true)
    }

    fn anchors(&self) -> impl Iterator<Item = (u32, f64)> + '_ {
        self.nodes[..self.count].iter().filter_map(|((_, anchor), way)| Some(((*anchor)?, *way)))
    }
}

fn is_open(node: &LaneNode<'_>) -> bool {
    node.row.access() & VehicleClass::MOTOR != 0 && node.row.bound() != NONE
}

impl NearAnchors {
    /// The anchors around a node; with a change of lane at its price in the landmarks' tables.
    pub(super) fn new(map: Map<'_>, target: &LaneNode<'_>, times: bool, change: f64) -> Self {
        let pass = |node: &LaneNode<'_>| if times { node.travel_time() } else { node.length() };
        let mut behind = Nearest::NONE;
        if look_behind(map, target, &mut behind, pass, change).is_none() {
            behind = Nearest::NONE;
        }
        let mut ahead = Nearest::NONE;
        look_ahead(map, target, &mut ahead, pass);
        Self { behind, ahead }
    }

    /// Places of all anchors from which one comes to the target without passing another, with the shortest way.
    pub(super) fn behind(&self) -> impl Iterator<Item = (u32, f64)> + '_ {
        self.behind.anchors()
    }

    /// Places of anchors to which one comes from the target, with a way.
    pub(super) fn ahead(&self) -> impl Iterator<Item = (u32, f64)> + '_ {
        self.ahead.anchors()
    }
}

/// Follows all ways that end at a node back to anchors. None if there is no room for them.
fn look_behind(
    map: Map<'_>,
    target: &LaneNode<'_>,
    found: &mut Nearest<MOST_BEHIND>,
    pass: impl Fn(&LaneNode<'_>) -> f64,
    change: f64,
) -> Option<()> {
    found.add(target, 0.0)?;
    // Ways get shorter until none does: each round settles at least one node.
    for _ in 0..MOST_BEHIND {
        let mut shorter = false;
        let mut i = 0;
        while i < found.count {
            let ((number, anchor), way) = found.nodes[i];
            i += 1;
            let Some(node) = LaneNode::new(map, number).filter(|_| anchor.is_none()) else {
                continue;
            };
            for before in node.predecessors().filter(is_open) {
                shorter |= found.add(&before, way + pass(&before))?;
            }
            let sides =
                [(node.left(), node_flags::CHANGE_RIGHT), (node.right(), node_flags::CHANGE_LEFT)];
            for (beside, flag) in sides {
                let beside = beside.filter(|n| is_open(n) && n.row.flags() & flag != 0);
                if let Some(beside) = beside {
                    shorter |= found.add(&beside, way + change)?;
                }
            }
        }
        if !shorter {
            return Some(());
        }
    }
    None
}

/// Follows the way from a node to the next anchor, or to those behind the next fork.
fn look_ahead(
    map: Map<'_>,
    target: &LaneNode<'_>,
    found: &mut Nearest<MOST_EXITS>,
    pass: impl Fn(&LaneNode<'_>) -> f64,
) {
    let tables = map.tables();
    let (mut node, mut way) = (*target, 0.0);
    for _ in 0..MOST_AHEAD {
        if node.row.anchor_length() == 0 {
            found.add(&node, way);
            return;
        }
        way += pass(&node);
        let next = edges_of(tables.successor_offsets, tables.successors, node.number);
        let open = || next.iter().filter_map(|n| LaneNode::new(map, *n)).filter(is_open);
        let Some(first) = open().next() else { return };
        if open().nth(1).is_some() {
            for branch in open() {
                // Those for which there is no room make a bound weaker, never wrong.
                let _ = found.add(&branch, way);
            }
            return;
        }
        node = first;
    }
}
