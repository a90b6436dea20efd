//! Lanes near a place, of whatever road: an R*-tree that the compiler alone needs, and only for objects and signals.

use glam::DVec2;
use mapd_query::{Lane, LaneType, Map};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

/// Segments of a centre line that share a box.
const SEGMENTS: usize = 8;

/// Boxes around lanes' areas.
pub(crate) struct NearLanes {
    tree: RTree<GeomWithData<Rectangle<[f64; 2]>, u32>>,
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
                boxes.push(GeomWithData::new(area, lane.lane_id().row()));
                from = to;
            }
        }
        Self { tree: RTree::bulk_load(boxes) }
    }

    /// Rows of lanes whose boxes meet a rectangle, each once, ascending.
    pub(crate) fn within(&self, low: DVec2, high: DVec2, out: &mut Vec<u32>) {
        out.clear();
        let area = AABB::from_corners(low.to_array(), high.to_array());
        out.extend(self.tree.locate_in_envelope_intersecting(area).map(|found| found.data));
        out.sort_unstable();
        out.dedup();
    }
}

/// Largest distance of a lane's borders from its centre line `[m]`: half its greatest width, seen at the points of its
/// borders, which lie where it bends.
fn reach(lane: &Lane<'_>) -> f64 {
    let stations = lane.left_bound().stations().chain(lane.right_bound().stations());
    stations.map(|s| lane.width_at(s)).fold(0.0, f64::max)
}
