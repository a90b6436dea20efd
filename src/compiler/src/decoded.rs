//! Lines of lanes, decoded once for who asks for their points again and again.

use glam::{DVec2, DVec3};
use mapd_query::{Map, Polyline};

/// Lanes that are kept. What is computed leaf by leaf asks for some dozen lanes near each other, and comes back to long ones.
const KEPT: usize = 256;

/// Points of a line.
#[derive(Default)]
pub(crate) struct Line {
    /// Relative to the local origin `[m]`.
    pub(crate) points: Vec<DVec3>,
    /// s on the road `[m]`, ascending.
    pub(crate) stations: Vec<f64>,
}

/// Lines of one lane.
#[derive(Default)]
pub(crate) struct LaneLines {
    lane: Option<u32>,
    pub(crate) center: Line,
    /// The left one first.
    pub(crate) borders: [Line; 2],
}

/// Memory of lines: those of lanes that were asked for lately.
pub(crate) struct Lines<'a> {
    map: Map<'a>,
    kept: Vec<LaneLines>,
}

impl Line {
    fn read(&mut self, line: Polyline<'_>, origin: DVec2) {
        let origin = origin.extend(0.0);
        self.points.clear();
        self.points.reserve(line.len());
        self.stations.clear();
        self.stations.reserve(line.len());
        line.for_each(|station, position| {
            self.points.push(position - origin);
            self.stations.push(station);
        });
    }

    /// Number of points whose s on the road is less than this `[m]`.
    pub(crate) fn points_before(&self, s: f64) -> usize {
        self.stations.partition_point(|station| *station < s)
    }

    /// A point with its s.
    pub(crate) fn point(&self, i: usize) -> Option<(DVec3, f64)> {
        Some((*self.points.get(i)?, *self.stations.get(i)?))
    }
}

impl<'a> Lines<'a> {
    pub(crate) fn new(map: Map<'a>) -> Self {
        Self { map, kept: Vec::new() }
    }

    /// Lines of a lane by its row; none where there is no such lane.
    pub(crate) fn of(&mut self, lane: u32) -> Option<&LaneLines> {
        if self.kept.is_empty() {
            self.kept.resize_with(KEPT, LaneLines::default);
        }
        let kept = self.kept.get_mut(lane as usize % KEPT)?;
        if kept.lane != Some(lane) {
            let of_map = self.map.lane_by_row(lane)?;
            let origin = self.map.local_origin();
            kept.lane = Some(lane);
            kept.center.read(of_map.center_line(), origin);
            let [left, right] = &mut kept.borders;
            left.read(of_map.left_bound(), origin);
            right.read(of_map.right_bound(), origin);
        }
        Some(kept)
    }
}
