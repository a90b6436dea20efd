//! The best of the lanes that hold a point.

use crate::area;
use crate::fetch;
use crate::held::Held;
use crate::index::{self, LaneSegment};
use crate::lane::Lane;
use crate::map::Map;
use crate::nearest::{Best, Candidate, NearestOptions};
use crate::types::Point;
use glam::DVec2;

impl<'a> Map<'a> {
    /// Considers the lanes that hold a point.
    #[inline]
    pub(crate) fn lane_around(
        &self,
        best: &mut Best<'a>,
        point: Point,
        local: DVec2,
        options: &NearestOptions,
    ) {
        let heights = options.heights(point);
        let is_by_offset = options.is_by_offset(point);
        let mut held = Held::new(is_by_offset.then(|| self.index_tolerance()));
        index::visit_around(self.tables(), local, heights, |leaf, qx, qy| {
            let (lanes, segments) = (leaf.lane(), leaf.segment());
            let around = index::places_around(leaf, qx, qy, heights);
            let mut places = around.places;
            while places != 0 {
                let k = places.trailing_zeros() as usize;
                places &= places - 1;
                if held.is_full() {
                    self.decide(&held, best, point, local, options);
                    held.clear();
                }
                let stretch = LaneSegment { lane: lanes[k], segment: segments[k] };
                if held.add(stretch, around.beside_squared[k], leaf.step()) {
                    fetch::rows(self.tables(), lanes[k]);
                }
            }
        });
        self.decide(&held, best, point, local, options);
    }

    /// Decides on the exact curves which of the lanes that hold a point is the best.
    fn decide(
        &self,
        held: &Held,
        best: &mut Best<'a>,
        point: Point,
        local: DVec2,
        options: &NearestOptions,
    ) {
        for held in held.promising() {
            fetch::records(self.tables(), held.stretch);
        }
        for held in held.stretches() {
            if !best.is_nearer_than(held.off_center) {
                let found = self.candidate_around(held.stretch, point, local, options);
                best.consider(found.as_ref(), *self, options);
            }
        }
    }

    /// A stretch that holds the point as a candidate; `None` where the options exclude it.
    #[inline]
    fn candidate_around(
        &self,
        stretch: LaneSegment,
        point: Point,
        local: DVec2,
        options: &NearestOptions,
    ) -> Option<Candidate<'a>> {
        let lane = Lane::new(*self, stretch.lane);
        let lane = lane.filter(|lane| options.types.contains(lane.kind()))?;
        let slab = area::slab(&lane, usize::from(stretch.segment))?;
        Candidate::around(&lane, &lane, &slab, point, local, options)
    }
}
