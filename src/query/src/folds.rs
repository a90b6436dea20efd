//! The nearest place of a lane where its cross-sections may cross: near the centre of the road's curvature and beyond it a point has several feet
//! on the reference line, or a nearest place that is no foot.

use crate::area::{EDGE, Slab, SlabPosition, across};
use crate::lane::Lane;
use glam::DVec2;
use mapd_geometry::hypot;

/// How near a point may come to the centre of curvature, as a share of the radius, for it to have one foot: elsewhere the curvature may be larger.
const ONE_FOOT: f64 = 0.6;
/// How near a lane's edge may come to it where the point is, for its cross-sections nowhere to cross: elsewhere the lane may be wider, too.
const NO_FOLD: f64 = 0.5;
/// Parts of a stretch at whose ends a look is taken.
const PARTS: usize = 16;
/// Cuts of two parts by the golden section: from metres to a picometre.
const CUTS: usize = 60;
/// Distances that differ by less `[m]` differ by rounding: what searching the flat ground around the least one finds is not better.
const ROUNDING: f64 = 1e-12;
/// A step from an end inwards, as a share of a part: what it tells of the slope is far above rounding.
const STEP: f64 = 1e-6;
/// What is left of a stretch that is cut by the golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Whether a lane with these edges may reach the centre of this curvature.
#[inline]
pub(crate) fn may_reach(curvature: f64, [low, high]: [f64; 2]) -> bool {
    curvature * low > NO_FOLD || curvature * high > NO_FOLD
}

/// Whether a point that lies so far ahead of a place of the slab and to the left of it may have several feet there, or a nearest place between the
/// edges that is none: where the lane has these edges. What lies beyond the centre of a lane that does not reach it is nearest to its border or to an end.
fn may_be(slab: &Slab<'_>, edges: [f64; 2], [ahead, lateral]: [f64; 2]) -> bool {
    let length = slab.s_hi - slab.s_lo;
    let [_, curvature] = slab.piece.curve.speed_and_curvature(slab.middle() - slab.piece.s);
    // On the way along the slab the offset changes by what the road turns.
    let along = curvature * curvature * (ahead.abs() + length) * length;
    may_reach(curvature, edges) && curvature * lateral + along > ONE_FOOT
}

/// A place along a slab, as seen from a point.
#[derive(Clone, Copy)]
struct Look {
    s: f64,
    /// How far the point lies ahead of its cross-section `[m]`.
    ahead: f64,
    /// Distance from the lane's cross-section `[m]`.
    distance: f64,
}

#[inline(never)]
fn look(lane: &Lane<'_>, slab: &Slab<'_>, local: DVec2, s: f64) -> Look {
    let (place, ahead) = across(lane, slab, local, s);
    Look { s, ahead, distance: hypot(ahead, place.past()) }
}

/// The place of a point with respect to a slab, wherever it is nearest; `fast` is what one foot says.
#[inline(never)]
pub(crate) fn place<'a>(
    lane: &Lane<'a>,
    slab: &Slab<'a>,
    local: DVec2,
    fast: SlabPosition<'a>,
) -> SlabPosition<'a> {
    // A single cross-section crosses none.
    if slab.s_lo >= slab.s_hi {
        return fast;
    }
    let (there, ahead) = across(lane, slab, local, fast.s());
    if may_be(slab, there.sides(), [ahead, there.t]) {
        nearest(lane, slab, local, fast)
    } else {
        fast
    }
}

#[cold]
#[inline(never)]
fn nearest<'a>(
    lane: &Lane<'a>,
    slab: &Slab<'a>,
    local: DVec2,
    fast: SlabPosition<'a>,
) -> SlabPosition<'a> {
    let (low, high) = (slab.s_lo, slab.s_hi);
    let look = |s: f64| look(lane, slab, local, s);
    let mut here = look(low);
    let mut best = Look { distance: fast.distance, ..here };
    let mut is_better = false;
    let mut before = here;
    for i in 1..=PARTS + 1 {
        let s = low + (high - low) * (i as f64 / PARTS as f64);
        let behind = if i > PARTS { here } else { look(s.min(high)) };
        let is_least = here.distance <= before.distance && here.distance <= behind.distance;
        let is_foot = (here.ahead > 0.0) != (behind.ahead > 0.0);
        let from = if is_least { before } else { here };
        if is_least || is_foot {
            let lowest = from.distance.min(here.distance).min(behind.distance);
            // The foot that is known tells the least distance around it better than a search does.
            let is_inside = low < fast.s() && fast.s() < high;
            let is_around = from.s <= fast.s() && fast.s() <= behind.s;
            let is_known = is_inside && is_around && fast.distance <= lowest;
            // At an end, of which one side alone counts, a step inwards tells whether it is the least.
            let inwards = if from.s < here.s { from.s } else { behind.s };
            let is_end = is_least && !is_foot && (from.s == here.s || here.s == behind.s);
            let is_settled = is_known
                || is_end && look(here.s + (inwards - here.s) * STEP).distance >= here.distance;
            let found =
                if is_settled { here } else { least(lane, slab, local, [from.s, behind.s]) };
            let found = if found.distance < here.distance { found } else { here };
            if found.distance < best.distance - ROUNDING {
                (best, is_better) = (found, true);
            }
        }
        (before, here) = (here, behind);
    }
    if !is_better {
        return fast;
    }
    let (place, ahead) = across(lane, slab, local, best.s);
    let is_beyond = (best.s == high && ahead > 0.0) || (best.s == low && ahead < 0.0);
    let distance = if best.distance <= EDGE { 0.0 } else { best.distance };
    SlabPosition::new(slab.geometry, &place, distance, is_beyond)
}

/// The nearest place between two.
#[inline(never)]
fn least(lane: &Lane<'_>, slab: &Slab<'_>, local: DVec2, [mut low, mut high]: [f64; 2]) -> Look {
    let first = |low: f64, high: f64| high - GOLDEN * (high - low);
    let mut a = look(lane, slab, local, first(low, high));
    let mut b = look(lane, slab, local, first(high, low));
    for _ in 0..CUTS {
        if a.distance < b.distance {
            (high, b) = (b.s, a);
            a = look(lane, slab, local, first(low, high));
        } else {
            (low, a) = (a.s, b);
            b = look(lane, slab, local, first(high, low));
        }
    }
    if a.distance < b.distance { a } else { b }
}
