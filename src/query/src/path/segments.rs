//! From which lanes the goal is reached along a path's own roads, and until where a change of lane may wait.

use super::{Path, Piece};
use crate::extents::SRange;
use crate::graph::LaneNode;
use crate::ids::LaneId;
use crate::lane::Lane;
use crate::route::{Enter, Ways};
use mapd_archive::VehicleClass;

/// Lanes beside the driven one that are looked at on either side at most; a damaged archive might lead round in a circle.
const MOST_BESIDE: usize = 64;
/// No way to the goal.
const NEVER: u32 = u32::MAX;

/// A lane from which the goal of a path is reached along the path's own roads by allowed changes of lane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PathSegment {
    /// S of the stretch over which this holds `[m]`.
    pub along: [f64; 2],
    /// The lane.
    pub lane: LaneId,
    /// Whether it is travelled towards +s.
    pub forward: bool,
    /// Whether the path drives on it on this stretch.
    pub driven: bool,
    /// Changes of lane that are left to the goal, at least.
    pub changes: u32,
    /// The largest S at which one can still be on this lane, with the lanes that it leads on to, and come to the goal: the last place for
    /// its next change `[m]`. The path's end where no change is needed.
    pub last_change: f64,
    /// S at which it leads on along the path no more `[m]`; the path's end where it does to the end.
    pub lane_end: f64,
    /// Its number among the ways.
    node: u32,
    /// Number of the stretch.
    stretch: u32,
    /// Whether the vehicle may enter it: what is driven may be closed.
    open: bool,
    /// Whether the path leaves the stretch on this lane.
    exit: bool,
    /// Whether it enters the stretch on this lane, from behind.
    entry: bool,
}

impl<'a> Path<'a, '_> {
    /// On every stretch of the path the lanes from which its goal is reached along the same roads, from left to right as the driver sees
    /// them. Stretches are in ascending S and cover the path; on each it is the same who may go where. What is closed to the vehicle is only left, not
    /// entered: a path over a closed lane has no such lanes before it unless a way leads round it. `out` is emptied first; it grows only if its capacity is
    /// too small.
    pub fn segments(&self, vehicle: VehicleClass, out: &mut Vec<PathSegment>) {
        self.segments_on(self.map, vehicle, out);
    }

    /// As [`Path::segments`], on the path's map or under an overlay of it.
    pub(crate) fn segments_on(
        &self,
        ways: impl Ways<'a>,
        vehicle: VehicleClass,
        out: &mut Vec<PathSegment>,
    ) {
        out.clear();
        let mut stretch = 0;
        for piece in &self.buffer.pieces {
            let Some(lane) = Lane::new(self.map, piece.lane) else { continue };
            let nodes = lane.nodes().filter(|node| node.is_forward() == piece.forward);
            for number in nodes.flat_map(|node| ways.pieces(node.number)) {
                self.stretch(ways, piece, number, vehicle, &mut stretch, out);
            }
        }
        decide(ways, out);
        out.retain(|own| own.changes != NEVER);
    }

    /// Adds a stretch for a node that is driven on, or drives on the last one after a change of lane.
    fn stretch(
        &self,
        ways: impl Ways<'a>,
        piece: &Piece,
        driven_on: u32,
        vehicle: VehicleClass,
        number: &mut u32,
        out: &mut Vec<PathSegment>,
    ) {
        let spans = self.spans_of(piece);
        let (Some(first), Some(last)) = (spans.first(), spans.last()) else { return };
        let Some(node) = ways.node(driven_on) else { return };
        let driven = [first.s[0], last.s[1]];
        let SRange { low, high } = node.s_range();
        let (from, to) = (low.max(driven[0].min(driven[1])), high.min(driven[0].max(driven[1])));
        if from >= to {
            return;
        }
        let [begin, end] = if piece.forward { [from, to] } else { [to, from] };
        let along = [self.along_in(piece, begin), self.along_in(piece, end)];
        // After a change of lane the stretch goes on.
        let known = out.iter().rev().take_while(|own| own.stretch == *number);
        if known.into_iter().any(|own| own.node == driven_on && own.along[1] <= along[0]) {
            for own in out.iter_mut().rev().take_while(|own| own.stretch == *number) {
                own.along[1] = along[1];
                own.exit = own.node == driven_on;
                own.driven |= own.exit;
            }
            return;
        }
        *number += 1;
        let next = |(number, node): &(u32, LaneNode<'a>), is_left: bool| {
            let next = ways.beside(*number, node, is_left)?;
            let node = ways.node(next)?;
            (next == driven_on || node.allows(vehicle)).then_some((next, node))
        };
        // A change of lane may lie exactly where a stretch begins.
        let joints = &self.buffer.joints;
        let joints = joints.get(joints.partition_point(|own| own.along < along[0])..);
        let mut here = joints.unwrap_or(&[]).iter().take_while(|own| own.along == along[0]);
        let is_changed = here.any(|joint| matches!(joint.enter, Enter::Left | Enter::Right));
        let driven = (driven_on, node);
        let left = std::iter::successors(Some(driven), |own| next(own, true));
        let leftmost = left.take(MOST_BESIDE + 1).last().unwrap_or(driven);
        let right = std::iter::successors(Some(leftmost), |own| next(own, false));
        for (own, node) in right.take(2 * MOST_BESIDE + 1) {
            let is_driven = own == driven_on;
            out.push(PathSegment {
                along,
                lane: LaneId::new(node.row.lane(), self.map.content()),
                forward: node.is_forward(),
                driven: is_driven,
                changes: NEVER,
                last_change: 0.0,
                lane_end: 0.0,
                node: own,
                stretch: *number,
                open: node.allows(vehicle),
                exit: is_driven,
                entry: is_driven && !is_changed,
            });
        }
    }

    /// S of a place on a piece; of one between its lines, or outside, of the nearest behind.
    pub(super) fn along_in(&self, piece: &Piece, s: f64) -> f64 {
        let spans = self.spans_of(piece);
        let behind = |span: &&super::Span| {
            if piece.forward { span.s[1] >= s } else { span.s[1] <= s }
        };
        let Some(span) = spans.iter().find(behind).or(spans.last()) else { return 0.0 };
        let [a, b] = span.s;
        span.along_at(mapd_geometry::clamp(s, a.min(b), a.max(b))).unwrap_or(span.along)
    }
}

/// From the goal back: what follows ahead first, then changes of lane within a stretch.
fn decide<'a>(ways: impl Ways<'a>, all: &mut [PathSegment]) {
    let mut rest = all.len();
    let mut next = rest..rest;
    while let Some(last) = rest.checked_sub(1).and_then(|last| all.get(last)).copied() {
        let first = all.partition_point(|own| own.stretch < last.stretch);
        for i in first..rest {
            let (before, behind) = all.split_at_mut(rest);
            let following = behind.get(..next.len()).unwrap_or(&[]);
            if let Some(own) = before.get_mut(i) {
                ahead(ways, own, following);
            }
        }
        beside(ways, all.get_mut(first..rest).unwrap_or(&mut []));
        next = first..rest;
        rest = first;
    }
}

/// What a lane reaches without a change on its stretch.
fn ahead<'a>(ways: impl Ways<'a>, own: &mut PathSegment, next: &[PathSegment]) {
    own.lane_end = own.along[1];
    own.last_change = own.along[1];
    if next.is_empty() {
        own.changes = if own.exit { 0 } else { NEVER };
        return;
    }
    let leads_to = |to: &PathSegment| {
        let mut leads = false;
        ways.ahead(own.node, |target| leads |= target == to.node);
        leads
    };
    let (exit, mut lane_end, mut last_change, mut changes) =
        (own.exit, own.lane_end, own.last_change, own.changes);
    // The path is known to lead on, also over lanes too short to be driven.
    // A closed lane is left at its end, however it is cut.
    let stays = |to: &&PathSegment| {
        let is_next = || ways.follows(own.node, to.node);
        to.open || (!own.open && (to.lane, to.forward) == (own.lane, own.forward) && is_next())
    };
    for to in next.iter().filter(stays).filter(|to| (exit && to.entry) || leads_to(to)) {
        lane_end = lane_end.max(to.lane_end);
        if to.changes != NEVER {
            changes = changes.min(to.changes);
            last_change = last_change.max(to.last_change);
        }
    }
    (own.lane_end, own.last_change, own.changes) = (lane_end, last_change, changes);
}

/// Changes of lane within a stretch, whose lanes are given from left to right.
fn beside<'a>(ways: impl Ways<'a>, lanes: &mut [PathSegment]) {
    for i in (1..lanes.len()).rev() {
        change(ways, lanes, i - 1, i, true);
    }
    for i in 1..lanes.len() {
        change(ways, lanes, i, i - 1, false);
    }
}

fn change<'a>(ways: impl Ways<'a>, lanes: &mut [PathSegment], from: usize, to: usize, right: bool) {
    let (Some(own), Some(beside)) = (lanes.get(from), lanes.get(to)) else { return };
    let way = ways.node(own.node).and_then(|node| ways.change(own.node, &node, !right));
    let allowed = beside.open && way == Some(beside.node);
    let changes = beside.changes.saturating_add(1);
    if allowed && changes < own.changes {
        lanes[from].changes = changes;
    }
}
