//! The nearest place of a stretch that the options let pass, where the nearest of all does not.
//!
//! Where the index cuts a lane must not show in answers: a stretch is not left out for its nearest place alone.

use crate::SRange;
use crate::area::{self, Slab, SlabPosition};
use crate::index::LaneSegment;
use crate::lane::Lane;
use crate::map::Map;
use crate::nearest::{Candidate, NearestOptions, driving_direction, heading_difference};
use crate::types::Point;
use glam::DVec2;

/// Parts of a stretch, each of which is cut in halves as long as a place of it may pass, or may not.
const PARTS: usize = 4;
/// How much more a difference may grow per metre within a part than it does over one of its halves: so much more does a parabola. A stretch of the index is
/// a line but for the tolerance of polylines.
const GROWTH: f64 = 2.0;
/// A part this short is one place `[m]`.
const SHORTEST: f64 = 1e-9;
/// Places that are looked at, forty halvings for each of some at which it is close; beyond them only ends of parts count.
const MOST_PLACES: u32 = 1024;

/// A stretch of a lane, and what is asked of it.
struct Asked<'q, 'a> {
    lane: &'q Lane<'a>,
    slab: &'q Slab<'a>,
    point: Point,
    local: DVec2,
    options: &'q NearestOptions,
}

/// A place along the stretch, and by how much the lane is off what is asked for there: signed differences of heading `[rad]` and height `[m]`,
/// 0 where nothing is asked for.
#[derive(Clone, Copy)]
struct Place {
    s: f64,
    off: [f64; 2],
}

impl<'a> Asked<'_, 'a> {
    /// The place nearest to the point between two s, unless it is excluded. Generated once: all of this is rarely asked.
    #[inline(never)]
    fn between(&self, s_lo: f64, s_hi: f64) -> Option<Candidate<'a>> {
        let part = self.slab.part(s_lo, s_hi);
        let place = area::place_by_call(self.lane, &part, self.local);
        Candidate::new(self.lane, place, self.point, self.options)
    }

    #[inline(never)]
    fn place(&self, s: f64) -> Place {
        let (across, _) = area::across(self.lane, self.slab, self.local, s);
        let place = SlabPosition::new(self.slab.geometry, &across, 0.0, false);
        let heading = self.options.heading;
        let heading = heading.map_or(0.0, |heading| {
            heading_difference(self.lane, driving_direction(self.lane, &place), heading)
        });
        let height = self.point.z.map_or(0.0, |z| z - place.level(self.lane));
        Place { s, off: [heading, height] }
    }

    /// How far off a place may be.
    fn limits(&self) -> [f64; 2] {
        let limit =
            |known: bool, limit: Option<f64>| limit.filter(|_| known).unwrap_or(f64::INFINITY);
        [
            limit(self.options.heading.is_some(), self.options.heading_tolerance),
            limit(self.point.z.is_some(), self.options.z_tolerance),
        ]
    }

    fn passes(&self, place: &Place) -> bool {
        self.limits().iter().zip(place.off).all(|(limit, off)| off.abs() <= *limit)
    }

    /// Whether places between two with this one in their middle may pass, or may not.
    fn may_be(&self, passing: bool, [from, middle, to]: [&Place; 3], in_first: bool) -> bool {
        let (a, b) = if in_first { (from, middle) } else { (middle, to) };
        let mut limits = self.limits().into_iter().enumerate();
        let off = |(at, limit): (usize, f64)| {
            let steps = [from, to].map(|end| (middle.off[at] - end.off[at]).abs());
            let (sum, grown) = ((a.off[at] + b.off[at]).abs(), GROWTH * steps[0].max(steps[1]));
            // What is no number excludes nothing.
            let (least, most) = (sum - grown, sum + grown);
            if passing {
                least <= 2.0 * limit || least.is_nan()
            } else {
                most > 2.0 * limit || most.is_nan()
            }
        };
        if passing { limits.all(off) } else { limits.any(off) }
    }

    /// The first place behind one, up to another, that passes, or that does not.
    fn first(&self, passing: bool, from: &Place, to: &Place, looks: &mut u32) -> Option<Place> {
        let middle = &self.place(0.5 * (from.s + to.s));
        *looks = looks.saturating_sub(1);
        // Between large numbers there may be none.
        let is_short = to.s - from.s <= SHORTEST || middle.s <= from.s || middle.s >= to.s;
        if is_short || *looks == 0 {
            return (self.passes(to) == passing).then_some(*to);
        }
        let may_be = |in_first: bool| self.may_be(passing, [from, middle, to], in_first);
        let first = may_be(true).then(|| self.first(passing, from, middle, looks)).flatten();
        first.or_else(|| may_be(false).then(|| self.first(passing, middle, to, looks)).flatten())
    }

    /// The nearest place that passes: of each part all of whose places do, the nearest.
    fn nearest(&self) -> Option<Candidate<'a>> {
        let Slab { s_lo, s_hi, .. } = *self.slab;
        let (mut best, mut looks) = (None, MOST_PLACES);
        let mut from = self.place(s_lo);
        for i in 1..=PARTS {
            let share = i as f64 / PARTS as f64;
            let to = self.place(if i == PARTS { s_hi } else { s_lo + (s_hi - s_lo) * share });
            while from.s <= to.s {
                let passes = self.passes(&from);
                let first =
                    if passes { Some(from) } else { self.first(true, &from, &to, &mut looks) };
                let Some(first) = first else { break };
                // Up to the last place before one that does not.
                let excluded = self.first(false, &first, &to, &mut looks);
                let last = excluded.map_or(to.s, |place| (place.s - SHORTEST).max(first.s));
                best = nearer(best, self.between(first.s, last));
                let Some(excluded) = excluded.filter(|place| place.s < to.s) else { break };
                from = excluded;
            }
            from = to;
        }
        best
    }
}

#[inline(never)]
fn nearer<'a>(a: Option<Candidate<'a>>, b: Option<Candidate<'a>>) -> Option<Candidate<'a>> {
    match (a, b) {
        (Some(a), Some(b)) if b.distance() < a.distance() => Some(b),
        (a, b) => a.or(b),
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
        let slab = &area::slab(lane, usize::from(stretch.segment))?;
        let Some(vehicle) = options.vehicle else {
            return Asked { lane, slab, point, local, options }.nearest();
        };
        // Who may drive is the nodes' to say, each once.
        let options = &NearestOptions { vehicle: None, ..*options };
        let (start, end) = (lane.section().s_start(), lane.section().s_end());
        let mut best = None;
        for node in lane.nodes().filter(|node| node.allows(vehicle)) {
            let SRange { low, high } = node.s_range();
            // A cut is of the later node in driving direction.
            let low = if node.is_forward() || low <= start { low } else { low.next_up() };
            let high = if node.is_forward() && high < end { high.next_down() } else { high };
            let (low, high) = (slab.s_lo.max(low), slab.s_hi.min(high));
            if low <= high {
                let slab = &slab.part(low, high);
                let asked = Asked { lane, slab, point, local, options };
                best = nearer(best, asked.between(low, high).or_else(|| asked.nearest()));
            }
        }
        best
    }
}
