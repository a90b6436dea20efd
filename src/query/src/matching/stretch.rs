//! The integral of a pose's density over a stretch of a lane: exact across, by Gauss and Legendre's rule along.

use super::density::{CrossLine, PoseDensity};
use crate::area::Slab;
use crate::lane::Lane;
use crate::types::turned;
use glam::DVec2;
use mapd_geometry::clamp;

/// Places and weights of the rule of five points on [−1, 1].
const RULE: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];
/// Length of a part to which the rule is applied, in deviations along the lane: leaves 1e-6 of a bell's area.
const PART: f64 = 2.0;
/// Most parts of a stretch: a pose known a hundred times better across than along is integrated more coarsely.
const MAX_PARTS: usize = 64;
/// Least share of s that counts as passed beside a bend's inner side, where a window of s is laid around a place.
pub(super) const MIN_STRETCH: f64 = 0.2;

/// The line across a lane at s, from the place `local`.
#[inline(always)]
pub(super) fn cross_line(
    lane: &Lane<'_>,
    slab: &Slab<'_>,
    s: f64,
    local: DVec2,
    forward: bool,
) -> CrossLine {
    let at = slab.at(s);
    let point = slab.piece.curve.evaluate(at.s - slab.piece.s);
    let edges = lane.edges(at);
    let roll = lane.road.roll(at).0;
    let (a, b) = (edges.inner * roll, edges.outer * roll);
    let heading = if forward { point.heading } else { turned(point.heading) };
    CrossLine {
        foot: DVec2::new(point.x, point.y) - local,
        normal: DVec2::new(-point.sin, point.cos),
        direction: heading,
        curvature: point.curvature,
        low: a.min(b),
        high: a.max(b),
    }
}

/// The integral over a stretch, of which `foot` is the s nearest to the pose's place `local`.
pub(super) fn weight(
    (lane, slab): (&Lane<'_>, &Slab<'_>),
    foot: f64,
    local: DVec2,
    density: &PoseDensity,
    forward: bool,
) -> f64 {
    let cut = |s: f64| cross_line(lane, slab, s, local, forward);
    let at_foot = cut(foot);
    let stretch = |l: f64| 1.0 - at_foot.curvature * l;
    let least = stretch(at_foot.low).min(stretch(at_foot.high)).max(MIN_STRETCH);
    let window = density.reach / least;
    let from = clamp(foot - window, slab.s_lo, slab.s_hi);
    let to = clamp(foot + window, slab.s_lo, slab.s_hi);
    let has_area = from < to;
    if !has_area {
        return 0.0;
    }
    let middle = stretch(0.5 * (at_foot.low + at_foot.high)).abs().max(MIN_STRETCH);
    let part = PART * density.deviation_along(at_foot.tangent(), middle, at_foot.curvature);
    let parts = ((to - from) / part).ceil().max(1.0).min(MAX_PARTS as f64) as usize;
    let half = 0.5 * (to - from) / parts as f64;
    let mut sum = 0.0;
    for i in 0..parts {
        let center = from + half * (2 * i + 1) as f64;
        for (place, share) in RULE {
            sum += share * density.integral(&cut(center + half * place));
        }
    }
    sum * half
}
