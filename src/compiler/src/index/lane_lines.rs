//! Lines of a lane, whose points are decoded as the index asks for them: of long lines a leaf needs a few.

use glam::DVec3;
use mapd_query::Map;
use mapd_query::compiling::{ByRow as _, LineReader};

/// A point of a line.
#[derive(Clone, Copy, Default)]
pub(super) struct Point {
    /// s on the road `[m]`.
    pub(super) s: f64,
    /// Relative to the local origin `[m]`.
    pub(super) place: DVec3,
}

/// Points of a line, in ascending s.
#[derive(Clone, Copy)]
pub(super) struct Line<'a> {
    points: LineReader<'a>,
    /// Inertial position that places count from `[m]`.
    origin: DVec3,
}

/// A border of a lane.
pub(super) struct Border<'a> {
    line: Line<'a>,
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

/// The centre line of a lane by its row, and its borders, the left one first; none where there is no such lane.
pub(super) fn lines_of(map: Map<'_>, lane: u32) -> Option<(Line<'_>, [Border<'_>; 2])> {
    let lane = map.lane_by_row(lane)?;
    let (points, origin) = (lane.center_line().reader(), map.local_origin().extend(0.0));
    let center = Line { points, origin };
    let borders = [lane.left_bound_of_reference_line(), lane.right_bound_of_reference_line()];
    Some((
        center,
        borders.map(|border| Border::new(Line { points: points.beside(border), origin })),
    ))
}

impl Line<'_> {
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
}

impl<'a> Border<'a> {
    #[inline]
    fn new(line: Line<'a>) -> Self {
        Self { line, last: Around { before: None, next: 0, here: line.point(0) } }
    }

    /// The point of this number, from 0.
    #[inline]
    pub(super) fn point(&self, i: usize) -> Option<Point> {
        self.line.point(i)
    }

    /// Where s on the road `[m]` lies among the points.
    #[inline]
    pub(super) fn around(&self, s: f64) -> Around {
        let (line, mut around) = (&self.line, self.last);
        if around.before.is_some_and(|p| p.s >= s) {
            let next = around.next - 1;
            around = Around { before: line.point_before(next), next, here: around.before };
        }
        if around.before.is_none_or(|p| p.s < s) && around.here.is_none_or(|p| p.s >= s) {
            return around;
        }
        let next = line.points.line.points_before(s);
        Around { before: line.point_before(next), next, here: line.point(next) }
    }

    /// Remembers where a search ended.
    pub(super) fn pass(&mut self, last: Around) {
        self.last = last;
    }
}
