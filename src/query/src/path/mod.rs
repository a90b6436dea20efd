//! A route as one line that can be asked: Frenet coordinates over many roads.
//!
//! **S** is the sum of the lengths that are driven along the lanes' centre lines `[m]`, from 0 at the path's start. Left and right
//! are as seen by the driver. Lanes of real maps do not always meet: a gap or an overlap between two adds nothing to S and is
//! listed ([`Path::joints`]), as is a change of lane, which is a jump to the side at its place or a curve over a length ([`LaneChange`]).
//!
//! A span lies between two stations of the stored centre line; where the line bends more it is halved, and again. On it S grows with s as a
//! parabola that is exact at both ends and in the middle, so that S and s follow from each other in closed form. Positions and headings are the
//! file's own polynomials at that s.

mod along;
mod approaches;
mod arc;
mod boxes;
mod build;
mod change;
mod conflicts;
mod corridor;
mod crossings;
mod edge;
mod error;
mod facts;
mod kept;
mod meets;
mod outline;
mod overlaps;
mod positions;
mod project;
mod rebase;
mod room;
mod segments;
mod settle;
mod speed;

pub use along::PathPoint;
pub use approaches::ConflictApproach;
pub use build::steps_of_lanes;
pub use change::LaneChange;
pub use conflicts::{ConflictLane, PathConflict, Yields, YieldsBy};
pub use corridor::{Corridor, CorridorSurface};
pub use crossings::PathCrossing;
pub use edge::{EdgeKind, EdgeMark};
pub use error::PathError;
pub use facts::{PathFact, PathFactKind};
pub use outline::CorridorEdges;
pub use positions::PathPositions;
pub use project::PathPosition;
pub use rebase::{PathChange, PathChangeKind};
pub use segments::PathSegment;
pub use speed::{PathSpeed, PathTime};

use crate::error::QueryError;
use crate::ids::{LaneId, ONLY_TILE};
use crate::lane::Lane;
use crate::map::Map;
use crate::route::{Enter, RouteStep};
use glam::DVec2;
use mapd_archive::VehicleClass;

/// A gap of this size breaks a path `[m]`.
const BROKEN_GAP: f64 = 0.1;
/// A kink of this size breaks a path `[rad]`.
const BROKEN_KINK: f64 = 0.3;

/// How a path is built.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct PathOptions {
    /// A joint with a larger gap is `broken` `[m]`; not negative, infinite for never. Default 0.1.
    pub broken_gap: f64,
    /// A joint with a larger kink is `broken` `[rad]`; as above. Default 0.3.
    pub broken_kink: f64,
    /// How the line changes lanes. Default: by a jump.
    pub change: LaneChange,
    /// How short a change may be that is a curve, where less than its length is allowed `[m]`, for each lane that is changed to; positive. What has even less room jumps,
    /// and its joint is `short` and `broken`. Default none: a change has its length, or its joint is `short`.
    pub shortest_change: Option<f64>,
    /// How far behind the first place where it can be a change begins that is a curve `[m]`, as far as it has room there, and those that follow; not negative,
    /// infinite for as late as can be. Default 0.
    pub change_delay: f64,
    /// The class of the vehicle: a change does not go on over lanes that it may not use. Default: passenger car.
    pub vehicle: VehicleClass,
}

impl Default for PathOptions {
    fn default() -> Self {
        Self {
            broken_gap: BROKEN_GAP,
            broken_kink: BROKEN_KINK,
            change: LaneChange::Jump,
            shortest_change: None,
            change_delay: 0.0,
            vehicle: VehicleClass::PassengerCar,
        }
    }
}

impl PathOptions {
    /// Errors: by name, an option out of its domain.
    fn check(&self) -> Result<(), PathError> {
        let length = match self.change {
            LaneChange::Jump => 1.0,
            LaneChange::Lateral(length) => length,
        };
        let rules = [
            ("broken_gap", self.broken_gap >= 0.0),
            ("broken_kink", self.broken_kink >= 0.0),
            ("change", length > 0.0 && length.is_finite()),
            ("shortest_change", self.shortest_change.is_none_or(|own| own > 0.0)),
            ("change_delay", self.change_delay >= 0.0),
        ];
        match rules.iter().find(|(_, holds)| !holds) {
            Some((name, _)) => Err(PathError::Option(name)),
            None => Ok(()),
        }
    }
}

/// Memory of a path, to be used again: it grows to the longest path that it has held.
#[derive(Clone, Default)]
pub struct PathBuffer {
    /// What it was built on.
    steps: Vec<RouteStep>,
    pieces: Vec<Piece>,
    spans: Vec<Span>,
    joints: Vec<PathJoint>,
    shifts: Vec<change::Shift>,
    /// Those that are not done, while it is built.
    open: Vec<change::Shift>,
    boxes: boxes::Boxes,
    /// The largest slack of a span `[m]`.
    slack: f64,
    content: u64,
}

/// A place where the driven line is not continuous, or changes lanes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathJoint {
    /// S `[m]`.
    pub along: f64,
    /// How far apart the line's two sides lie in plan view `[m]`.
    pub gap: f64,
    /// By how much the line turns there `[rad]`, positive to the left, in (−π, π].
    pub kink: f64,
    /// How the lane behind it is entered; [`Enter::Ahead`] also for a jump within a lane.
    pub enter: Enter,
    /// Whether it is a change of lane that jumps because there is no room for the curve that the options ask for.
    pub short: bool,
    /// Whether gap or kink are larger than the options allow. A change of lane that jumps breaks nothing by its gap, unless the options say how short
    /// it may be.
    pub broken: bool,
}

/// A lane that is driven on.
#[derive(Clone, Copy)]
struct Piece {
    lane: u32,
    forward: bool,
    /// Number of the route's step.
    step: u32,
    /// First span, and the one after the last.
    spans: [u32; 2],
    /// Where its speed limit comes from.
    way: speed::Way,
}

/// A stretch of a piece on which the line is smooth.
#[derive(Clone, Copy)]
struct Span {
    /// S at its start `[m]`.
    along: f64,
    length: f64,
    /// s on the road at its start and end `[m]`, in driving direction.
    s: [f64; 2],
    /// How much more S grows towards the end: S = length·((1 − bend)·v + bend·v²) at the share v of s.
    bend: f64,
    /// Both ends, relative to the local origin `[m]`.
    ends: [DVec2; 2],
    /// Heading at the start, and how much it has turned at the end `[rad]`.
    heading: f64,
    turn: f64,
    /// How far the line may lie from the chord between its ends `[m]`.
    slack: f64,
    /// The circle or line through both ends.
    arc: arc::Arc,
    piece: u32,
    /// The first of the curves of changes of lane that it is part of, or none.
    shift: u32,
}

/// A route as one line, in the caller's [`PathBuffer`]. Made by [`Map::path`].
#[derive(Clone, Copy)]
pub struct Path<'a, 'b> {
    map: Map<'a>,
    buffer: &'b PathBuffer,
}

/// A lane of a path and what of it is driven.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathLane {
    /// The lane.
    pub lane: LaneId,
    /// Whether it is travelled towards +s.
    pub forward: bool,
    /// Number of the route's step.
    pub step: usize,
    /// S where it is entered and left `[m]`.
    pub along: [f64; 2],
    /// s on its road there `[m]`.
    pub s: [f64; 2],
}

impl<'a, 'b> Path<'a, 'b> {
    /// The path that a buffer holds.
    ///
    /// Errors: it was built on a map of other content.
    pub fn of(map: Map<'a>, buffer: &'b PathBuffer) -> Result<Self, QueryError> {
        map.known(buffer.content, ONLY_TILE)?;
        Ok(Self { map, buffer })
    }

    /// Errors: it is on a map of other content.
    pub(crate) fn check(&self, map: Map<'_>) -> Result<(), QueryError> {
        map.known(self.buffer.content, ONLY_TILE)
    }

    /// Length: the largest S `[m]`.
    pub fn length(&self) -> f64 {
        self.buffer.spans.last().map_or(0.0, |span| span.along + span.length)
    }

    /// Gaps, overlaps and kinks of more than rounding, and changes of lane, in ascending S.
    pub fn joints(&self) -> &'b [PathJoint] {
        &self.buffer.joints
    }

    /// Whether some joint is broken.
    pub fn is_broken(&self) -> bool {
        self.buffer.joints.iter().any(|joint| joint.broken)
    }

    /// The lanes that are driven on, in ascending S; one that is only changed from is not among them.
    pub fn lanes(&self) -> impl ExactSizeIterator<Item = PathLane> + use<'a, 'b> {
        let path = *self;
        path.buffer.pieces.iter().map(move |piece| {
            let spans = path.spans_of(piece);
            let (first, last) = (spans.first(), spans.last());
            let end = |span: &Span| span.along + span.length;
            PathLane {
                lane: LaneId::new(piece.lane, path.map.content()),
                forward: piece.forward,
                step: piece.step as usize,
                along: [first.map_or(0.0, |span| span.along), last.map_or(0.0, end)],
                s: [first.map_or(0.0, |span| span.s[0]), last.map_or(0.0, |span| span.s[1])],
            }
        })
    }

    /// S of a place on one of the path's lanes `[m]`: the first where it is driven over several times. None for one that the path
    /// does not pass.
    pub fn along_of(&self, lane: LaneId, s: f64) -> Option<f64> {
        let known = (lane.content, lane.tile) == (self.buffer.content, ONLY_TILE);
        let own = self.buffer.pieces.iter().filter(|piece| known && piece.lane == lane.row);
        own.filter_map(|piece| self.spans_of(piece).iter().find_map(|span| span.along_at(s))).next()
    }

    /// S of a place on the lane of this number among [`Path::lanes`], or of the nearer end of what is driven of it.
    pub(crate) fn along_lane(&self, number: usize, s: f64) -> Option<f64> {
        self.buffer.pieces.get(number).map(|piece| self.along_in(piece, s))
    }

    /// The lane of this number among [`Path::lanes`], and whether it is travelled towards +s.
    pub(crate) fn driven(&self, number: usize) -> Option<(Lane<'a>, bool)> {
        let piece = self.buffer.pieces.get(number)?;
        Some((Lane::new(self.map, piece.lane)?, piece.forward))
    }

    fn spans_of(&self, piece: &Piece) -> &'b [Span] {
        let [first, end] = piece.spans;
        self.buffer.spans.get(first as usize..end as usize).unwrap_or(&[])
    }

    fn piece(&self, span: &Span) -> Option<(&'b Piece, Lane<'a>)> {
        let piece = self.buffer.pieces.get(span.piece as usize)?;
        Some((piece, Lane::new(self.map, piece.lane)?))
    }

    /// The span that holds S: at a joint the later one.
    fn span_at(&self, along: f64) -> Option<&'b Span> {
        let spans = &self.buffer.spans;
        let after = spans.partition_point(|span| span.along <= along);
        spans.get(after.saturating_sub(1))
    }
}

impl Span {
    fn end(&self) -> f64 {
        self.along + self.length
    }

    /// s at a distance from the span's start.
    fn s_at(&self, distance: f64) -> f64 {
        let share = mapd_geometry::clamp(distance / self.length, 0.0, 1.0);
        if share >= 1.0 {
            return self.s[1];
        }
        // The root of bend·v² + (1 − bend)·v = share that loses no digits.
        let linear = 1.0 - self.bend;
        let v = 2.0 * share / (linear + (linear * linear + 4.0 * self.bend * share).sqrt());
        self.s[0] + (self.s[1] - self.s[0]) * v
    }

    /// S at an s of the span; none outside.
    fn along_at(&self, s: f64) -> Option<f64> {
        let [from, to] = self.s;
        let inside = s >= from.min(to) && s <= from.max(to);
        if s == to && from != to {
            return Some(self.end());
        }
        let v = if to == from { 0.0 } else { (s - from) / (to - from) };
        inside.then_some(self.along + self.length * ((1.0 - self.bend) * v + self.bend * v * v))
    }
}
