//! All lanes near a point.

use crate::error::QueryError;
use crate::index::{self, LaneSegment};
use crate::lane::Lane;
use crate::map::Map;
use crate::nearest::{Candidate, Nearest, NearestOptions, round_up};
use crate::types::Point;
use std::cmp::Ordering;

impl<'a> Map<'a> {
    /// Every lane whose area lies within the options' radius of a point, nearest first, each once and in the order that
    /// [`Map::nearest_lane`] prefers. `out` is emptied first; it grows only if its capacity is too small.
    ///
    /// Errors: as [`Map::nearest_lane`].
    pub fn lanes_near(
        &self,
        point: impl Into<Point>,
        options: &NearestOptions,
        out: &mut Vec<Nearest>,
    ) -> Result<(), QueryError> {
        self.lanes_near_to(point.into(), options, out)
    }

    /// As [`Map::lanes_near`]: generated once, here.
    fn lanes_near_to(
        &self,
        point: Point,
        options: &NearestOptions,
        out: &mut Vec<Nearest>,
    ) -> Result<(), QueryError> {
        out.clear();
        options.check(point)?;
        let local = point.xy - self.origin();
        let radius = round_up(options.radius);
        let heights = options.heights(point);
        index::visit(self.tables(), local, heights, radius, |leaf, qx, qy, bound| {
            let (lanes, segments) = (leaf.lane(), leaf.segment());
            let lower = index::lower_bounds(leaf, qx, qy, heights);
            let mut open = index::places_within(&lower, bound);
            // The most promising comes first: what is farther of its lane costs nothing then.
            while let Some(k) = index::least(&lower, open) {
                open &= !(1 << k);
                let known = out.iter().position(|known| known.lane.row() == lanes[k]);
                let most = known
                    .and_then(|at| out.get(at))
                    .map_or(options.radius, |known| known.position.distance);
                // A stretch that is farther than one already found of its lane changes nothing.
                if f64::from(lower[k]) > most {
                    continue;
                }
                let lane = Lane::new(*self, lanes[k]);
                let lane = lane.filter(|lane| options.types.contains(lane.kind()));
                let Some(lane) = lane else { continue };
                let found = Candidate::on(&lane, segments[k], point, local, options);
                let Some(found) = found.filter(|found| found.distance() <= most) else { continue };
                match known.and_then(|at| out.get_mut(at)) {
                    None => out.push(found.nearest_on(&lane)),
                    Some(known) if self.is_better(&found, known, point, options) => {
                        *known = found.nearest_on(&lane);
                    }
                    Some(_) => {}
                }
            }
            bound
        });
        // Sorting in place allocates nothing.
        out.sort_unstable_by(|a, b| self.compare(a, b, point, options));
        Ok(())
    }

    /// Every lane that counts and whose area holds a point, and s there; in no order, some more than once. With a z and a tolerance only those on
    /// its level.
    pub(crate) fn each_lane_at(
        &self,
        point: Point,
        options: &NearestOptions,
        counts: impl Fn(&Lane<'a>) -> bool,
        mut each: impl FnMut(&Lane<'a>, f64),
    ) {
        let local = point.xy - self.origin();
        let heights = options.heights(point);
        index::visit(self.tables(), local, heights, 0.0, |leaf, qx, qy, bound| {
            let (lanes, segments) = (leaf.lane(), leaf.segment());
            let lower = index::lower_bounds(leaf, qx, qy, heights);
            for k in (0..lower.len()).filter(|k| lower[*k] <= bound) {
                let lane = Lane::new(*self, lanes[k]).filter(&counts);
                let Some(lane) = lane else { continue };
                let stretch = LaneSegment { lane: lanes[k], segment: segments[k] };
                let found = self.candidate(stretch, point, local, options);
                if let Some(found) = found.filter(|found| found.distance() <= 0.0) {
                    each(&lane, found.place.s());
                }
            }
            bound
        });
    }

    /// Whether a point lies on a lane, edges included, in plan view; a point with z only on one within `z_tolerance`.
    ///
    /// Errors: coordinates that are not finite.
    pub fn covers(
        &self,
        point: impl Into<Point>,
        z_tolerance: Option<f64>,
    ) -> Result<bool, QueryError> {
        let options = NearestOptions { radius: 0.0, z_tolerance, ..NearestOptions::default() };
        Ok(self.nearest_lane(point, &options)?.is_some())
    }

    /// As [`Map::nearest_lane`] prefers. What ties go by is made again.
    fn compare(
        &self,
        a: &Nearest,
        b: &Nearest,
        point: Point,
        options: &NearestOptions,
    ) -> Ordering {
        let tied = || match [a, b].map(|nearest| self.rank_of(nearest, point, options)) {
            [Some(a), Some(b)] => a.order(&b, *self),
            _ => Ordering::Equal,
        };
        a.position.distance.total_cmp(&b.position.distance).then_with(tied)
    }

    #[inline]
    fn is_better(
        &self,
        found: &Candidate<'a>,
        known: &Nearest,
        point: Point,
        options: &NearestOptions,
    ) -> bool {
        let tied =
            || self.rank_of(known, point, options).map(|known| found.rank().order(&known, *self));
        let order = found.distance().total_cmp(&known.position.distance);
        order.then_with(|| tied().unwrap_or(Ordering::Equal)).is_lt()
    }
}
