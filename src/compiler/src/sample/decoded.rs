//! Lines of lanes, decoded once, for callers that read their points many times.

use glam::DVec3;
use mapd_query::Map;
use mapd_query::compiling::ByRow as _;
use mapd_query::roads::{LinePoint, Polyline};

/// Lines of each kind that are kept. What is computed leaf by leaf asks for some dozen lanes near each other, and comes back to
/// long ones.
const KEPT: usize = 256;

/// Points that a line has at most to be kept: what is forgotten is decoded again as a whole, and each place keeps the room of
/// the longest line it had. Of a longer line only the points that are asked for are decoded, each time.
const LONGEST_KEPT: usize = 256;

/// A point of a line.
#[derive(Clone, Copy)]
pub(crate) struct Point {
    /// s on the road `[m]`.
    pub(crate) s: f64,
    /// Relative to the local origin `[m]`.
    pub(crate) place: DVec3,
}

/// Points of a line, in ascending s.
pub(crate) struct Line<'l, 'a> {
    /// All of them, if they are kept.
    points: &'l [Point],
    /// The line as it lies in the archive, if it is too long for that.
    long: Option<Polyline<'a>>,
    /// Inertial position that places count from `[m]`.
    origin: DVec3,
}

/// Lines of one lane.
pub(crate) struct LaneLines<'l, 'a> {
    pub(crate) center: Line<'l, 'a>,
    /// The left one first.
    pub(crate) borders: [Line<'l, 'a>; 2],
}

/// Memory of lines: those of lanes that were asked for lately. Two lanes share the border between them.
pub(crate) struct Lines<'a> {
    map: Map<'a>,
    /// Inertial position that places count from `[m]`.
    origin: DVec3,
    centers: Vec<Kept<'a>>,
    borders: Vec<Kept<'a>>,
}

#[derive(Default)]
struct Kept<'a> {
    lane: Option<u32>,
    /// None of a line that is too long.
    points: Vec<Point>,
    long: Option<Polyline<'a>>,
    /// Of a centre line: the lanes that have the borders to the left and to the right.
    beside: [u32; 2],
}

impl Line<'_, '_> {
    /// The point of this number, from 0.
    pub(crate) fn point(&self, i: usize) -> Option<Point> {
        match self.long {
            Some(line) => {
                Some(Point { s: line.station(i)?, place: line.position(i)? - self.origin })
            }
            None => self.points.get(i).copied(),
        }
    }

    /// Number of points whose s on the road is less than this `[m]`.
    pub(crate) fn points_before(&self, s: f64) -> usize {
        match self.long {
            Some(line) => line.points_before(s),
            None => self.points.partition_point(|point| point.s < s),
        }
    }
}

impl<'a> Kept<'a> {
    fn read(&mut self, lane: u32, line: Polyline<'a>, origin: DVec3) {
        self.lane = Some(lane);
        self.points.clear();
        self.long = (line.len() > LONGEST_KEPT).then_some(line);
        if self.long.is_none() {
            let point = |at: LinePoint| Point { s: at.s, place: at.position - origin };
            self.points.extend(line.points().map(point));
        }
    }

    fn line(&self, origin: DVec3) -> Line<'_, 'a> {
        Line { points: &self.points, long: self.long, origin }
    }
}

impl<'a> Lines<'a> {
    pub(crate) fn new(map: Map<'a>) -> Self {
        let origin = map.local_origin().extend(0.0);
        Self { map, origin, centers: Vec::new(), borders: Vec::new() }
    }

    /// Lines of a lane by its row; none where there is no such lane.
    pub(crate) fn of(&mut self, lane: u32) -> Option<LaneLines<'_, 'a>> {
        if self.centers.is_empty() {
            self.centers.resize_with(KEPT, Kept::default);
            self.borders.resize_with(KEPT, Kept::default);
        }
        let center = self.centers.get_mut(slot(lane))?;
        if center.lane != Some(lane) {
            let of_map = self.map.lane_by_row(lane)?;
            center.read(lane, of_map.center_line(), self.origin);
            // A border is stored once, with the lane on its inner side; rows run from left to right.
            center.beside = match of_map.number() {
                ..0 => [lane.saturating_sub(1), lane],
                0 => [lane; 2],
                1.. => [lane, lane.saturating_add(1)],
            };
        }
        for lane in center.beside {
            let border = self.borders.get_mut(slot(lane))?;
            if border.lane != Some(lane) {
                let of_map = self.map.lane_by_row(lane)?;
                border.read(lane, of_map.border(), self.origin);
            }
        }
        let center = self.centers.get(slot(lane))?;
        let [left, right] = center.beside.map(|lane| self.borders.get(slot(lane)));
        let borders = [left?.line(self.origin), right?.line(self.origin)];
        Some(LaneLines { center: center.line(self.origin), borders })
    }
}

/// Where a lane's lines are kept: neighbours beside each other.
fn slot(lane: u32) -> usize {
    lane as usize % KEPT
}
