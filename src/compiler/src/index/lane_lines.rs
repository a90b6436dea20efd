//! Lines of a lane, whose points are decoded as the index asks for them: of long lines a leaf needs a few.

use glam::DVec3;
use mapd_query::Map;
use mapd_query::compiling::{ByRow as _, LineReader};
use mapd_query::roads::Polyline;

/// A point of a line.
#[derive(Clone, Copy, Default)]
pub(super) struct Point {
    /// s on the road `[m]`.
    pub(super) s: f64,
    /// Relative to the local origin `[m]`.
    pub(super) place: DVec3,
}

/// Points of a line, in ascending s.
pub(super) struct Line<'a> {
    points: LineReader<'a>,
    /// Inertial position that places count from `[m]`.
    origin: DVec3,
    /// How many points the last search passed: the next one mostly ends beside them.
    passed: usize,
}

/// Points beside a place.
pub(super) struct Around {
    /// The last one whose s is less.
    pub(super) before: Option<Point>,
    /// Number of the one behind it, and that one.
    pub(super) next: usize,
    pub(super) here: Option<Point>,
}

/// Lines of one lane.
pub(super) struct LaneLines<'a> {
    /// The lane's row.
    pub(super) lane: u32,
    pub(super) center: Line<'a>,
    /// The left one first.
    pub(super) borders: [Line<'a>; 2],
}

impl<'a> LaneLines<'a> {
    /// Lines of a lane by its row; none where there is no such lane.
    pub(super) fn of(map: Map<'a>, lane: u32) -> Option<Self> {
        let of_map = map.lane_by_row(lane)?;
        // A border is stored once, with the lane on its inner side; rows run from left to right.
        let [left, right] = match of_map.number() {
            ..0 => [lane.saturating_sub(1), lane],
            0 => [lane; 2],
            1.. => [lane, lane.saturating_add(1)],
        };
        let border = |lane: u32| Some(Line::new(map, map.lane_by_row(lane)?.border()));
        let borders = [border(left)?, border(right)?];
        Some(Self { lane, center: Line::new(map, of_map.center_line()), borders })
    }
}

impl<'a> Line<'a> {
    fn new(map: Map<'a>, points: Polyline<'a>) -> Self {
        Self { points: points.reader(), origin: map.local_origin().extend(0.0), passed: 0 }
    }

    /// The point of this number, from 0.
    #[inline]
    pub(super) fn point(&self, i: usize) -> Option<Point> {
        let point = self.points.point(i)?;
        Some(Point { s: point.s, place: point.position - self.origin })
    }

    /// Where s on the road `[m]` lies among the points.
    #[inline]
    pub(super) fn around(&self, s: f64) -> Around {
        let around = |next: usize| {
            let before = next.checked_sub(1).and_then(|i| self.point(i));
            Around { before, next, here: self.point(next) }
        };
        let is_there = |around: &Around| {
            around.before.is_none_or(|p| p.s < s) && around.here.is_none_or(|p| p.s >= s)
        };
        let near = [Some(self.passed), self.passed.checked_sub(1)].into_iter().flatten();
        let found = near.map(around).find(is_there);
        found.unwrap_or_else(|| around(self.points.line.points_before(s)))
    }

    /// Remembers where a search ended.
    pub(super) fn pass(&mut self, points: usize) {
        self.passed = points;
    }
}
