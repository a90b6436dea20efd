//! Lanes near a place, of whatever road: an R*-tree that the compiler alone needs, and only for objects and signals.

use crate::sample::distance_to_segment;
use glam::DVec2;
use mapd_query::compiling::{ByRow as _, position_along};
use mapd_query::vocabulary::LaneType;
use mapd_query::{Lane, LanePosition, Map};
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
        for lane in map.lanes().filter(|lane| lane.kind() != LaneType::None) {
            let reach = reach(&lane);
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

/// Largest distance of a lane's borders from its centre line `[m]`: half its greatest width, doubled for what lies between
/// the points of its borders.
fn reach(lane: &Lane<'_>) -> f64 {
    let stations = lane.left_bound().stations().chain(lane.right_bound().stations());
    stations.map(|s| lane.width_at(s)).fold(0.0, f64::max)
}
