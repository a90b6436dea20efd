//! Lines of lanes, decoded once for who asks for their points again and again.

use glam::{DVec2, DVec3};
use mapd_query::{Map, Polyline};

/// Lines of each kind that are kept. What is computed leaf by leaf asks for some dozen lanes near each other, and comes back to
/// long ones.
const KEPT: usize = 256;

/// A point of a line.
#[derive(Clone, Copy)]
pub(crate) struct Point {
    /// s on the road `[m]`.
    pub(crate) s: f64,
    /// Relative to the local origin `[m]`.
    pub(crate) place: DVec3,
}

/// Points of a line, in ascending s.
#[derive(Default)]
pub(crate) struct Line(Vec<Point>);

/// Lines of one lane.
pub(crate) struct LaneLines<'l> {
    pub(crate) center: &'l Line,
    /// The left one first.
    pub(crate) borders: [&'l Line; 2],
}

/// Memory of lines: those of lanes that were asked for lately. Two lanes share the border between them.
pub(crate) struct Lines<'a> {
    map: Map<'a>,
    origin: DVec2,
    centers: Vec<Kept>,
    borders: Vec<Kept>,
}

#[derive(Default)]
struct Kept {
    lane: Option<u32>,
    line: Line,
    /// Of a centre line: the lanes that have the borders to the left and to the right.
    beside: [u32; 2],
}

impl Line {
    fn read(&mut self, line: Polyline<'_>, origin: DVec2) {
        let origin = origin.extend(0.0);
        self.0.clear();
        self.0.extend(line.points().map(|(s, position)| Point { s, place: position - origin }));
    }

    /// Number of points whose s on the road is less than this `[m]`.
    pub(crate) fn points_before(&self, s: f64) -> usize {
        self.0.partition_point(|point| point.s < s)
    }

    pub(crate) fn points(&self) -> &[Point] {
        &self.0
    }
}

impl<'a> Lines<'a> {
    pub(crate) fn new(map: Map<'a>) -> Self {
        Self { map, origin: map.local_origin(), centers: Vec::new(), borders: Vec::new() }
    }

    /// Lines of a lane by its row; none where there is no such lane.
    pub(crate) fn of(&mut self, lane: u32) -> Option<LaneLines<'_>> {
        if self.centers.is_empty() {
            self.centers.resize_with(KEPT, Kept::default);
            self.borders.resize_with(KEPT, Kept::default);
        }
        let center = self.centers.get_mut(slot(lane))?;
        if center.lane != Some(lane) {
            let of_map = self.map.lane_by_row(lane)?;
            center.lane = Some(lane);
            center.line.read(of_map.center_line(), self.origin);
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
                border.lane = Some(lane);
                border.line.read(of_map.border(), self.origin);
            }
        }
        let center = self.centers.get(slot(lane))?;
        let [left, right] = center.beside.map(|lane| self.borders.get(slot(lane)));
        Some(LaneLines { center: &center.line, borders: [&left?.line, &right?.line] })
    }
}

/// Where a lane's lines are kept: neighbours beside each other.
fn slot(lane: u32) -> usize {
    lane as usize % KEPT
}
