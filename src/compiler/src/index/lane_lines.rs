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
    /// Where the last search ended, at first at the start: the next one mostly ends there or a point before.
    last: Around,
}

/// Points beside a place.
#[derive(Clone, Copy)]
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
        let line = |points| Line::new(map, points);
        let left = line(of_map.left_bound_of_reference_line());
        let right = line(of_map.right_bound_of_reference_line());
        Some(Self { lane, center: line(of_map.center_line()), borders: [left, right] })
    }
}

impl<'a> Line<'a> {
    fn new(map: Map<'a>, points: Polyline<'a>) -> Self {
        let last = Around { before: None, next: 0, here: None };
        let mut line =
            Self { points: points.reader(), origin: map.local_origin().extend(0.0), last };
        line.last.here = line.point(0);
        line
    }

    /// The point of this number, from 0.
    #[inline]
    pub(super) fn point(&self, i: usize) -> Option<Point> {
        let point = self.points.point(i)?;
        Some(Point { s: point.s, place: point.position - self.origin })
    }

    /// The point before that of a number.
    #[inline]
    fn point_before(&self, next: usize) -> Option<Point> {
        next.checked_sub(1).and_then(|i| self.point(i))
    }

    /// Where s on the road `[m]` lies among the points.
    #[inline]
    pub(super) fn around(&self, s: f64) -> Around {
        let mut around = self.last;
        if around.before.is_some_and(|p| p.s >= s) {
            let next = around.next - 1;
            around = Around { before: self.point_before(next), next, here: around.before };
        }
        if around.before.is_none_or(|p| p.s < s) && around.here.is_none_or(|p| p.s >= s) {
            return around;
        }
        let next = self.points.line.points_before(s);
        Around { before: self.point_before(next), next, here: self.point(next) }
    }

    /// Remembers where a search ended.
    pub(super) fn pass(&mut self, last: Around) {
        self.last = last;
    }
}
