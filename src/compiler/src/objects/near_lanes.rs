//! Lanes near a place, of whatever road: an R*-tree that the compiler alone needs, and only for objects and signals.

use crate::sample::distance_to_segment;
use glam::DVec2;
use mapd_query::compiling::{ByRow as _, SectionCutter, position_along};
use mapd_query::vocabulary::LaneType;
use mapd_query::{Lane, LaneEdges, LanePosition, Map};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

/// Segments of a centre line that share a box.
const SEGMENTS: usize = 8;
/// Farthest that a lane's centre line leaves its polyline `[m]`, for any tolerance that is allowed.
const MARGIN: f64 = 1.0;

/// A stretch of a lane's centre line.
#[derive(Clone, Copy, PartialEq)]
struct Stretch {
    lane: u32,
    /// Segments from the first on, this one left out.
    segments: [u32; 2],
    /// Largest distance of the lane's area from its centre line `[m]`.
    reach: f64,
}

/// Boxes around lanes' areas.
pub(crate) struct NearLanes {
    tree: RTree<GeomWithData<Rectangle<[f64; 2]>, Stretch>>,
}

impl NearLanes {
    /// Over all lanes that something may belong to: not the ones without a use.
    pub(crate) fn new(map: Map<'_>) -> Self {
        let mut boxes = Vec::new();
        let mut reaches = Reaches::default();
        for lane in map.lanes().filter(|lane| lane.kind() != LaneType::None) {
            let reach = reaches.of(&lane);
            let center: Vec<DVec2> = lane.center_line().positions().map(|p| p.truncate()).collect();
            let mut from = 0;
            while from + 1 < center.len() {
                let to = (from + SEGMENTS).min(center.len() - 1);
                let part = &center[from..=to];
                let low = part.iter().copied().fold(DVec2::INFINITY, DVec2::min) - reach;
                let high = part.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max) + reach;
                let area = Rectangle::from_corners(low.to_array(), high.to_array());
                let segments = [from as u32, to as u32];
                let stretch = Stretch { lane: lane.lane_id().row(), segments, reach };
                boxes.push(GeomWithData::new(area, stretch));
                from = to;
            }
        }
        Self { tree: RTree::bulk_load(boxes) }
    }

    /// Whether a lane which the condition holds for may come into a rectangle.
    pub(crate) fn any_within<'a>(
        &self,
        map: Map<'a>,
        [low, high]: [DVec2; 2],
        fits: impl Fn(&Lane<'a>) -> bool,
    ) -> bool {
        let area = AABB::from_corners(low.to_array(), high.to_array());
        let mut found = self.tree.locate_in_envelope_intersecting(area);
        found.any(|found| map.lane_by_row(found.data.lane).is_some_and(|lane| fits(&lane)))
    }

    /// Lanes whose areas come as near to a point as `reach` `[m]` and which the condition holds for, each with the place
    /// on it that is nearest to the point, by row of the lane.
    pub(crate) fn around<'a>(
        &self,
        map: Map<'a>,
        point: DVec2,
        reach: f64,
        mut fits: impl FnMut(&Lane<'a>) -> bool,
    ) -> Vec<(Lane<'a>, LanePosition)> {
        let area = AABB::from_corners((point - reach).to_array(), (point + reach).to_array());
        let found = self.tree.locate_in_envelope_intersecting(area);
        let mut stretches: Vec<Stretch> = found.map(|found| found.data).collect();
        stretches.sort_unstable_by_key(|stretch| (stretch.lane, stretch.segments));
        let mut places = Vec::new();
        for of_lane in stretches.chunk_by(|a, b| a.lane == b.lane) {
            let Some(lane) = of_lane.first().and_then(|one| map.lane_by_row(one.lane)) else {
                continue;
            };
            if !fits(&lane) {
                continue;
            }
            let mut best: Option<LanePosition> = None;
            for stretch in of_lane {
                for segment in stretch.segments[0] as usize..stretch.segments[1] as usize {
                    let limit = best.map_or(reach, |best| best.distance);
                    if away(&lane, segment, point) > limit + stretch.reach + MARGIN {
                        continue;
                    }
                    let place = position_along(&lane, segment, point, limit);
                    let key = |p: &LanePosition| (p.distance, p.offset.abs());
                    if let Some(place) = place.filter(|place| place.distance <= reach)
                        && best.is_none_or(|best| key(&place) < key(&best))
                    {
                        best = Some(place);
                    }
                }
            }
            places.extend(best.map(|best| (lane, best)));
        }
        places
    }
}

/// Distance of a point from a segment of a centre line `[m]`.
fn away(lane: &Lane<'_>, segment: usize, point: DVec2) -> f64 {
    let line = lane.center_line();
    let (Some(a), Some(b)) = (line.position(segment), line.position(segment + 1)) else {
        return f64::INFINITY;
    };
    distance_to_segment(point.extend(0.0), a.with_z(0.0), b.with_z(0.0))
}

/// Largest distances of lanes' borders from their centre lines, section by section.
#[derive(Default)]
struct Reaches {
    /// The section, by the row of its first lane, and the distances of its lanes.
    section: Option<(u32, Vec<f64>)>,
    stations: Vec<(f64, usize)>,
}

impl Reaches {
    /// Half its greatest width, doubled for what lies between the points of its borders `[m]`.
    fn of(&mut self, lane: &Lane<'_>) -> f64 {
        let section = lane.section();
        let Some(first) = section.lanes().next().map(|first| first.lane_id().row()) else {
            return 0.0;
        };
        let known = self.section.take().filter(|(of, _)| *of == first);
        let (_, reaches) = self.section.insert(known.unwrap_or_else(|| (first, Vec::new())));
        if reaches.is_empty() {
            // Place after place, not lane after lane: the section's records change once for all lanes.
            self.stations.clear();
            for (at, lane) in section.lanes().enumerate() {
                let own = lane.left_bound().stations().chain(lane.right_bound().stations());
                self.stations.extend(own.map(|s| (s, at)));
                reaches.push(0.0);
            }
            self.stations.sort_by(|a, b| a.0.total_cmp(&b.0));
            let mut cutter = SectionCutter::new(section);
            for (s, at) in &self.stations {
                let edges = cutter.as_mut().and_then(|cutter| cutter.lane_edges(*at, *s));
                if let Some(reach) = reaches.get_mut(*at) {
                    *reach = reach.max(edges.map_or(0.0, LaneEdges::width));
                }
            }
        }
        let own = (lane.lane_id().row() - first) as usize;
        reaches.get(own).copied().unwrap_or(0.0)
    }
}
