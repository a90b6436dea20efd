//! The nearest place of a stretch that the options let pass, where the nearest of all does not.
//!
//! Where the index cuts a lane must not show in answers: a stretch is not left out for its nearest place alone.

use crate::area::{self, Slab};
use crate::index::LaneSegment;
use crate::lane::Lane;
use crate::map::Map;
use crate::nearest::{Candidate, NearestOptions, heading_difference, is_closed};
use crate::types::Point;
use glam::DVec2;
use mapd_geometry::normalize_angle;

/// Parts of what is left of a stretch on either side, at whose ends a look is taken. In most bends a stretch of the index turns by less than 0.3 rad.
const PARTS: usize = 16;
/// Halvings of a part on the way to where the options begin to let the lane pass: from metres to a nanometre.
const HALVINGS: usize = 40;

/// A stretch of a lane, and what is asked of it.
struct Asked<'q, 'a> {
    lane: &'q Lane<'a>,
    slab: &'q Slab<'a>,
    point: Point,
    local: DVec2,
    options: &'q NearestOptions,
}

impl<'a> Asked<'_, 'a> {
    /// The place nearest to the point between two s, unless it is excluded. Generated once: all of this is rarely asked.
    #[inline(never)]
    fn between(&self, s_lo: f64, s_hi: f64) -> Option<Candidate<'a>> {
        let part = self.slab.part(s_lo, s_hi);
        Candidate::nearest_in(self.lane, &part, self.point, self.local, self.options)
    }

    #[inline(never)]
    fn passes(&self, s: f64) -> bool {
        // Headings and who may drive are cheaper to tell than places.
        if let (Some(heading), Some(tolerance)) =
            (self.options.heading, self.options.heading_tolerance)
        {
            let piece = &self.slab.piece;
            let line = normalize_angle(piece.curve.heading(s - piece.s));
            if heading_difference(self.lane, line, heading) > tolerance {
                return false;
            }
        }
        let closed = |vehicle| is_closed(self.lane, s, vehicle);
        !self.options.vehicle.is_some_and(closed) && self.between(s, s).is_some()
    }

    /// The nearest place that passes on the side of this end.
    #[inline(never)]
    fn towards(&self, end: f64, foot: f64) -> Option<Candidate<'a>> {
        let part = (end - foot) / PARTS as f64;
        let first = (1..=PARTS).find(|i| part != 0.0 && self.passes(foot + part * *i as f64))?;
        let last = foot + part * first as f64;
        let (mut excluded, mut found) = (last - part, last);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (excluded + found);
            *if self.passes(middle) { &mut found } else { &mut excluded } = middle;
        }
        self.between(found.min(last), found.max(last))
    }
}

impl<'a> Candidate<'a> {
    /// As [`Candidate::on`], where the place nearest to the point is excluded. Lane and slab are made again, so that who finds
    /// nothing excluded need not keep them in memory.
    #[cold]
    #[inline(never)]
    pub(crate) fn passing(
        map: Map<'a>,
        stretch: LaneSegment,
        point: Point,
        local: DVec2,
        options: &NearestOptions,
    ) -> Option<Self> {
        let lane = &Lane::new(map, stretch.lane)?;
        let closed = |vehicle| !lane.nodes().any(|node| node.allows(vehicle));
        if options.vehicle.is_some_and(closed) {
            return None;
        }
        let slab = &area::slab(lane, usize::from(stretch.segment))?;
        let foot = area::place(lane, slab, local).s();
        let asked = Asked { lane, slab, point, local, options };
        match (asked.towards(slab.s_lo, foot), asked.towards(slab.s_hi, foot)) {
            (Some(low), Some(high)) if high.distance() < low.distance() => Some(high),
            (low, high) => low.or(high),
        }
    }
}
