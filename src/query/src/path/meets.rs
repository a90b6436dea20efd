//! Where other traffic meets a path outside the junctions' own lists: lanes that merge into it.

use super::conflicts::{ConflictLane, Yields};
use super::overlaps::STEP;
use super::{Path, Piece};
use crate::extents::SRange;
use crate::graph::LaneNode;
use crate::lane::Lane;
use mapd_archive::{ConflictKind, Relation, RelationReason};

/// Common places are too long by up to half a metre at either end: what is nearer to each other than both `[m]` touches.
pub(super) const TOUCHES: f64 = 1.0;

impl<'a> Path<'a, '_> {
    /// Whether a stretch of another lane that has a place in common with the piece of a number is the path's own way there. The path drives it just before,
    /// so that who is there comes along with it; or just behind, all of it.
    pub(super) fn is_own_way(
        &self,
        number: usize,
        along: [f64; 2],
        other: u32,
        [low, high]: [f64; 2],
    ) -> bool {
        self.is_near_way(number, along, other, [low, high], TOUCHES)
    }

    /// As [`Path::is_own_way`], where the path drives the stretch up to so far `[m]` before or behind the common place.
    pub(super) fn is_near_way(
        &self,
        number: usize,
        [from, to]: [f64; 2],
        other: u32,
        [low, high]: [f64; 2],
        reach: f64,
    ) -> bool {
        self.buffer.pieces.iter().enumerate().any(|(at, piece)| {
            if piece.lane != other || at == number {
                return false;
            }
            let Some([first, last]) = self.common(piece, SRange { low, high }) else {
                return false;
            };
            let is_near = first <= to + reach && last >= from - reach;
            is_near && (at < number || !self.begins_before(piece, [low, high]))
        })
    }

    /// Whether a stretch of a piece's lane begins before the path is on it.
    fn begins_before(&self, piece: &Piece, [low, high]: [f64; 2]) -> bool {
        let Some(entry) = self.spans_of(piece).first().map(|span| span.s[0]) else { return false };
        if piece.forward { low < entry - TOUCHES } else { high > entry + TOUCHES }
    }

    /// Adds lanes that lead into the path's own from elsewhere, and lanes beside it that end and have to be left for it.
    pub(super) fn merges(
        &self,
        number: usize,
        piece: &Piece,
        lane: &Lane<'a>,
        out: &mut Vec<ConflictLane>,
    ) {
        let [begin, _] = self.ends_of(piece);
        let first = self.spans_of(piece).first().map(|span| span.s[0]);
        let before = number.checked_sub(1).and_then(|last| self.buffer.pieces.get(last));
        let start = if piece.forward { lane.section().s_start() } else { lane.section().s_end() };
        // Other lanes may lead into the middle of one, and out of it.
        for node in lane.nodes().filter(|node| node.is_forward() == piece.forward) {
            let SRange { low, high } = node.s_range();
            let entry = if piece.forward { low } else { high };
            // Where the path begins or has changed onto the lane, what leads into it is behind.
            let is_behind = first == Some(entry) && (before.is_none() || entry != start);
            let Some(along) = self.along_on(piece, entry).filter(|_| !is_behind) else { continue };
            for from in node.predecessors() {
                let Some(other) = from.lane() else { continue };
                let comes_from = before
                    .is_some_and(|before| before.lane == other.row_number() && along == begin);
                let is_own = other.row_number() == lane.row_number();
                if is_own || comes_from || !from.is_open() {
                    continue;
                }
                let SRange { low, high } = from.s_range();
                let end = if from.is_forward() { high } else { low };
                self.add(lane, &other, [along; 2], [end; 2], ConflictKind::Merge, out);
            }
        }
        for node in lane.nodes().filter(|node| node.is_forward() == piece.forward) {
            let SRange { low, high } = node.s_range();
            let Some(along) = self.overlap(piece, [low, high]) else { continue };
            if node.edges().len() == 0 {
                continue;
            }
            let beside = |other: LaneNode<'a>, back: Option<LaneNode<'a>>| {
                let leads_here = back.is_some_and(|back| back.node_id() == node.node_id());
                let ends = other.edges().len() == 0 && other.is_open() && leads_here;
                other.lane().filter(|_| ends)
            };
            let left = node.left().and_then(|other| beside(other, other.change_right()));
            let right = node.right().and_then(|other| beside(other, other.change_left()));
            for other in left.into_iter().chain(right) {
                if !self.is_own_way(number, along, other.row_number(), [low, high]) {
                    self.add(lane, &other, along, [low, high], ConflictKind::Merge, out);
                }
            }
        }
    }

    /// Adds a place where another lane meets the path, unless the junction's own list tells it.
    pub(super) fn add(
        &self,
        lane: &Lane<'a>,
        other: &Lane<'a>,
        along: [f64; 2],
        other_s: [f64; 2],
        kind: ConflictKind,
        out: &mut Vec<ConflictLane>,
    ) {
        // What a junction's own list tells is told.
        let told = |known: &&mut ConflictLane| {
            known.other == other.lane_id() && known.along[1] + STEP >= along[0]
        };
        if let Some(known) = out.iter_mut().find(told) {
            // Roads that lie over each other before one leads into the other's successor merge.
            if (known.kind, kind) == (ConflictKind::Overlap, ConflictKind::Merge) {
                known.kind = kind;
                known.along[1] = known.along[1].max(along[1]);
                known.other_s =
                    [known.other_s[0].min(other_s[0]), known.other_s[1].max(other_s[1])];
            }
            return;
        }
        out.push(ConflictLane {
            along,
            other: other.lane_id(),
            other_s,
            kind,
            yields: Yields::Unknown,
            reason: RelationReason::None,
            relation: Relation::Unknown,
            equal_roads: lane.comes_by_equal_road(other),
            wait: along[0],
        });
    }
}
