//! What lies on and beyond the edges of a path's lanes.

use crate::extents::SRange;
use crate::lane::Lane;
use crate::lane_edges::EdgeSlopes;
use crate::profile::{self, At};
use mapd_archive::{LaneType, RoadMarkColor, RoadMarkKind, lane_flags};

/// A step in height from one lane to the next from which it is a kerb `[m]`: lower ones are driven over without noticing.
const KERB: f64 = 0.03;
/// A lane narrower than this is not there `[m]`.
const NO_WIDTH: f64 = 0.01;

/// What bounds a lane beside its road mark.
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
#[non_exhaustive]
pub enum EdgeKind {
    /// Another lane of the road, of whatever type, on the same level.
    Lane,
    /// A kerb: a mark of the kind `curb`, a lane of the type `curb`, or a lane that lies higher or lower by 3 cm or more.
    Kerb,
    /// The road has no lane beyond. In a junction, that of another road may lie there.
    RoadEnd,
}

impl EdgeKind {
    /// `lane`, `kerb` or `end`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Lane => "lane",
            Self::Kerb => "kerb",
            Self::RoadEnd => "end",
        }
    }
}

/// What lies on an edge of a lane.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct EdgeMark {
    /// Kind of the road mark; `None` where there is none.
    pub kind: RoadMarkKind,
    /// Its colour.
    pub color: RoadMarkColor,
    /// Whether a change of lane over this edge is allowed from the lane, into one of its direction that the vehicle may use.
    pub may_cross: bool,
    /// What lies beyond.
    pub edge: EdgeKind,
}

/// An edge of a lane, followed along it: what holds for a while is looked up once.
#[derive(Clone, Copy)]
pub(super) struct Edge<'a> {
    lane: Lane<'a>,
    /// Whether it is the edge away from lane 0.
    is_outer: bool,
    may_cross: bool,
    /// The lane whose outer border lies there: marks are its.
    owner: Option<Lane<'a>>,
    beyond: Option<Lane<'a>>,
    mark: Option<Mark>,
}

/// A road mark and between which s it holds.
#[derive(Clone, Copy)]
struct Mark {
    kind: RoadMarkKind,
    color: RoadMarkColor,
    s: SRange,
}

impl<'a> Edge<'a> {
    pub(super) fn new(lane: Lane<'a>, is_outer: bool, may_cross: bool) -> Self {
        // A border's mark belongs to the lane on its inner side.
        let owner = if is_outer { Some(lane) } else { lane.inner() };
        let beyond = if is_outer { lane.outer_ones().next() } else { lane.inner_ones().next() };
        Self { lane, is_outer, may_cross, owner, beyond, mark: None }
    }

    /// t of the edge.
    pub(super) fn t(&self, own: &EdgeSlopes) -> f64 {
        if self.is_outer { own.outer.value } else { own.inner.value }
    }

    /// t of the edge at a place.
    pub(super) fn t_at(&self, at: At) -> f64 {
        self.t(&self.lane.edge_slopes(at))
    }

    /// What lies on the edge at s, which the place stands for.
    pub(super) fn mark_at(&mut self, at: At, s: f64) -> EdgeMark {
        let holds = |mark: &Mark| mark.s.low <= s && s < mark.s.high;
        if !self.mark.as_ref().is_some_and(holds) {
            let found = self.owner.and_then(|owner| owner.road_mark_at(s));
            self.mark = found.map(|mark| Mark {
                kind: mark.kind(),
                color: mark.color(),
                s: SRange { low: mark.s(), high: mark.s_end() },
            });
        }
        let (kind, color) = self
            .mark
            .map_or((RoadMarkKind::None, RoadMarkColor::Unknown), |mark| (mark.kind, mark.color));
        let edge = if kind == RoadMarkKind::Curb { EdgeKind::Kerb } else { self.kind_at(at) };
        EdgeMark { kind, color, may_cross: self.may_cross, edge }
    }

    fn kind_at(&self, at: At) -> EdgeKind {
        let wide = |lane: &Lane<'a>| width(lane, at) > NO_WIDTH;
        let beyond = self.beyond.filter(wide).or_else(|| {
            // What has no width here lies between.
            if self.is_outer {
                self.lane.outer_ones().find(wide)
            } else {
                self.lane.inner_ones().find(wide)
            }
        });
        match beyond {
            None => EdgeKind::RoadEnd,
            Some(lane) if lane.kind() == LaneType::Curb || self.is_step(&lane, at) => {
                EdgeKind::Kerb
            }
            Some(_) => EdgeKind::Lane,
        }
    }

    /// Whether another lane begins higher or lower.
    fn is_step(&self, beyond: &Lane<'a>, at: At) -> bool {
        if self.lane.map.tables().lane_heights.is_empty() {
            return false;
        }
        let (own, other) = (self.lane.height_at(at.hold), beyond.height_at(at.hold));
        let across = self.lane.number().signum() != beyond.number().signum();
        let own = if self.is_outer { own.outer } else { own.inner };
        let other = if self.is_outer || across { other.inner } else { other.outer };
        (own - other).abs() >= KERB
    }
}

/// Width of a lane; a border needs those of the lanes within.
fn width(lane: &Lane<'_>, at: At) -> f64 {
    if lane.row.flags() & lane_flags::BORDER != 0 {
        let edges = lane.edge_slopes(at);
        return (edges.outer.value - edges.inner.value).abs();
    }
    profile::value(lane.row.widths().of(lane.map.tables().cubics), at)
}
