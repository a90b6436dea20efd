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
use mapd_archive::ArchivedIndexLeafRow;

impl<'a> Map<'a> {
    /// The best of the lanes that hold a point.
    #[inline]
    pub(crate) fn lane_around(
        &self,
        point: Point,
        local: DVec2,
        options: &NearestOptions,
    ) -> Option<Candidate<'a>> {
        let heights = options.heights(point);
        let (mut best, mut held) = (Best::default(), self.held(point, options));
        index::leaves_around(self.tables(), local, heights, |leaf| {
            self.hold(leaf, local, heights, &mut held, |held| {
                self.decide(held, &mut best, point, local, options);
            });
        });
        self.decide(&held, &mut best, point, local, options);
        best.found()
    }

    /// No stretches yet that hold a point.
    #[inline]
    pub(crate) fn held(&self, point: Point, options: &NearestOptions) -> Held {
        Held::new(options.is_by_offset(point).then(|| self.index_tolerance()))
    }

    /// Adds those of a leaf's stretches that may hold a point. `full` gets them when there is no room for more; they are forgotten then.
    #[inline(always)]
    pub(crate) fn hold(
        &self,
        leaf: &ArchivedIndexLeafRow,
        local: DVec2,
        heights: Option<[f64; 2]>,
        held: &mut Held,
        mut full: impl FnMut(&Held),
    ) {
        let (x, y) = (local.x - f64::from(leaf.x()), local.y - f64::from(leaf.y()));
        let around = index::places_around(leaf, x as f32, y as f32, heights);
        let (lanes, segments) = (leaf.lane(), leaf.segment());
        let mut places = around.places;
        while places != 0 {
            let k = places.trailing_zeros() as usize;
            places &= places - 1;
            if held.is_full() {
                full(held);
                held.clear();
            }
            let stretch = LaneSegment { lane: lanes[k], segment: segments[k] };
            if held.add(stretch, around.beside_squared[k], leaf.step()) {
                fetch::rows(self.tables(), lanes[k]);
            }
        }
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
        self.decide_among(held, best, point, local, options);
    }

    /// As [`Self::decide`], where what it reads was asked for.
    #[inline(always)]
    pub(crate) fn decide_among(
        &self,
        held: &Held,
        best: &mut Best<'a>,
        point: Point,
        local: DVec2,
        options: &NearestOptions,
    ) {
        for held in held.stretches() {
            if !best.is_nearer_than(held.off_center) {
                let found = self.candidate_around(held.stretch, point, local, options);
                best.consider(found, *self, options);
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
