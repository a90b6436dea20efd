//! The room along a path, station by station.

use super::Path;
use crate::error::QueryError;
use crate::extents::SRange;
use crate::graph::LaneNode;
use crate::ids::LaneId;
use crate::lane::Lane;
use glam::DVec3;
use mapd_archive::{RoadMarkColor, RoadMarkKind, VehicleClass};

/// Stations of one answer at most: a step that is too small for its length must not fill the memory.
const MOST_STATIONS: f64 = 1e6;
/// Lanes beside the driven one that are looked at on either side at most; a damaged archive might lead round in a circle.
const MOST_BESIDE: usize = 64;

/// What lies on an edge of the driven lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeMark {
    /// Kind of the road mark; `None` where there is none.
    pub kind: RoadMarkKind,
    /// Its colour.
    pub color: RoadMarkColor,
    /// Whether a change of lane over this edge is allowed from the driven lane, into one of its direction that the vehicle may use.
    pub may_cross: bool,
}

/// The room along a path, a column for each fact and an entry for each station. Left and right are those of who drives.
#[derive(Clone, Debug, Default)]
pub struct Corridor {
    /// S `[m]`.
    pub along: Vec<f64>,
    /// The driven lane.
    pub lane: Vec<LaneId>,
    /// Left edge of the driven lane, inertial on the plane h = 0 `[m]`.
    pub left: Vec<DVec3>,
    /// Right edge of the driven lane `[m]`.
    pub right: Vec<DVec3>,
    /// Left edge of the leftmost lane beside it that has its direction and is open to the vehicle `[m]`.
    pub outer_left: Vec<DVec3>,
    /// Right edge of the rightmost such lane `[m]`.
    pub outer_right: Vec<DVec3>,
    /// What lies on the left edge of the driven lane.
    pub left_mark: Vec<EdgeMark>,
    /// What lies on its right edge.
    pub right_mark: Vec<EdgeMark>,
}

impl Corridor {
    fn clear(&mut self) {
        self.along.clear();
        self.lane.clear();
        self.left.clear();
        self.right.clear();
        self.outer_left.clear();
        self.outer_right.clear();
        self.left_mark.clear();
        self.right_mark.clear();
    }

    /// Number of stations.
    pub fn len(&self) -> usize {
        self.along.len()
    }

    /// Whether there are no stations.
    pub fn is_empty(&self) -> bool {
        self.along.is_empty()
    }
}

/// The node that is driven on, and between which s it holds.
struct Driven<'a> {
    span_piece: u32,
    node: Option<LaneNode<'a>>,
    s: SRange,
}

impl<'a> Path<'a, '_> {
    /// The room along the path from S on, a station every `step` metres and one at the end, `length` metres on or where the path ends. `out` is
    /// emptied first; it grows only if its capacity is too small.
    ///
    /// Errors: numbers that are not finite, a step that is not positive or gives more than a million stations; a damaged archive.
    pub fn corridor(
        &self,
        from: f64,
        length: f64,
        step: f64,
        vehicle: VehicleClass,
        out: &mut Corridor,
    ) -> Result<(), QueryError> {
        out.clear();
        let finite = from.is_finite() && length.is_finite() && step.is_finite();
        if !(finite && step > 0.0 && length / step <= MOST_STATIONS) {
            return Err(QueryError::NotFinite);
        }
        let from = mapd_geometry::clamp(from, 0.0, self.length());
        let end = mapd_geometry::clamp(from + length, from, self.length());
        let mut driven: Option<Driven<'a>> = None;
        let mut number = 0u64;
        loop {
            let next = from + number as f64 * step;
            number += 1;
            let along = if next < end { next } else { end };
            self.station(along, vehicle, &mut driven, out)?;
            if along >= end {
                return Ok(());
            }
        }
    }

    fn station(
        &self,
        along: f64,
        vehicle: VehicleClass,
        driven: &mut Option<Driven<'a>>,
        out: &mut Corridor,
    ) -> Result<(), QueryError> {
        let span = self.span_at(along).ok_or(QueryError::Corrupt)?;
        let (piece, lane) = self.piece(span).ok_or(QueryError::Corrupt)?;
        let s = span.s_at(along - span.along);
        let holds =
            |own: &Driven<'_>| own.span_piece == span.piece && own.s.low <= s && s < own.s.high;
        if !driven.as_ref().is_some_and(holds) {
            let node = lane.node_at(s, piece.forward);
            let s = node.as_ref().map_or(SRange { low: s, high: s }, LaneNode::s_range);
            *driven = Some(Driven { span_piece: span.piece, node, s });
        }
        let node = driven.as_ref().and_then(|own| own.node);
        let [left, right] = bounds(&lane, piece.forward, s).ok_or(QueryError::Corrupt)?;
        let outer_is_left = (lane.number() > 0) == piece.forward;
        let mark = |is_left: bool| {
            // A border's mark belongs to the lane on its inner side.
            let owner = if is_left == outer_is_left { Some(lane) } else { lane.inner() };
            let mark = owner.and_then(|owner| owner.road_mark_at(s));
            let beside =
                node.and_then(|n| if is_left { n.change_left() } else { n.change_right() });
            EdgeMark {
                kind: mark.as_ref().map_or(RoadMarkKind::None, |mark| mark.kind()),
                color: mark.as_ref().map_or(RoadMarkColor::Unknown, |mark| mark.color()),
                may_cross: beside.is_some_and(|beside| beside.allows(vehicle)),
            }
        };
        let outermost = |is_left: bool| {
            let next = |n: &LaneNode<'a>| if is_left { n.left() } else { n.right() };
            let open = |n: &LaneNode<'a>| next(n).filter(|next| next.allows(vehicle));
            let last = std::iter::successors(node.as_ref().and_then(open), open).take(MOST_BESIDE);
            let lane = last.last().and_then(|node| node.lane())?;
            Some(bounds(&lane, piece.forward, s)?[usize::from(!is_left)])
        };
        out.along.push(along);
        out.lane.push(lane.lane_id());
        out.left.push(left);
        out.right.push(right);
        out.outer_left.push(outermost(true).unwrap_or(left));
        out.outer_right.push(outermost(false).unwrap_or(right));
        out.left_mark.push(mark(true));
        out.right_mark.push(mark(false));
        Ok(())
    }
}

/// Both edges of a lane, the left one of who drives first.
pub(super) fn bounds(lane: &Lane<'_>, forward: bool, s: f64) -> Option<[DVec3; 2]> {
    let [left, right] = lane.bounds_at(s)?;
    Some(if lane.is_forward() == forward { [left, right] } else { [right, left] })
}
