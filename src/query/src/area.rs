//! The exact distance of a point from a lane's area.
//!
//! The index proposes a slab: a lane between two values of s within one plan-view geometry. Here the curve itself
//! decides: foot on the reference line, edges from the file's polynomials.

use crate::lane::Lane;
use crate::profile::At;
use crate::road::Piece;
use crate::types::{LaneEdges, LanePosition};
use glam::DVec2;
use mapd_geometry::{clamp, normalize_angle};

/// Iterations for the foot on a border; each gains several digits, the last ones are for points far outside.
const BORDER_ITERATIONS: usize = 12;
/// Step along a border `[m]` below which its foot counts as found.
const BORDER_STEP: f64 = 1e-10;
/// Smallest share of the Gauss–Newton slope that is kept where the point lies near the border's centre of curvature.
const MIN_CONTRACTION: f64 = 0.1;

/// A stretch of a lane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slab {
    /// First s `[m]`.
    pub(crate) s_lo: f64,
    /// Last s `[m]`.
    pub(crate) s_hi: f64,
}

impl Slab {
    fn middle(self) -> f64 {
        0.5 * (self.s_lo + self.s_hi)
    }

    /// A place in the slab, with what holds within: records and geometries begin where slabs do, but stored s are rounded.
    #[inline]
    fn at(self, s: f64) -> At {
        At { s, hold: self.middle() }
    }
}

/// The slab of a segment of the lane's centre line, by its number within the line.
pub(crate) fn slab(lane: &Lane<'_>, segment: usize) -> Option<Slab> {
    let points = lane.row.center().of(lane.map.tables().points);
    let (a, b) = (points.get(segment)?, points.get(segment + 1)?);
    let (start, end) = (lane.section.s_start(), lane.section.s_end());
    // Stored s has 24 bits; the ends and the joints of geometries are exact values, put back here.
    let lo = if segment == 0 { start } else { start + f64::from(a.s()) };
    let hi = if segment + 2 == points.len() { end } else { start + f64::from(b.s()) };
    let middle = 0.5 * (lo + hi);
    let rows = lane.road.geometries();
    let at = rows.partition_point(|g| g.s() <= middle).saturating_sub(1);
    let geometry_start = if at == 0 { f64::NEG_INFINITY } else { rows.get(at)?.s() };
    let geometry_end = rows.get(at + 1).map_or(lane.road.reference_end(), |g| g.s());
    let slack = (end - start) * f64::from(f32::EPSILON);
    let s_lo = if (lo - geometry_start).abs() <= slack { geometry_start } else { lo };
    let s_hi = if (hi - geometry_end).abs() <= slack { geometry_end } else { hi };
    (s_lo <= s_hi).then_some(Slab { s_lo, s_hi })
}

/// The segment of the lane's centre line that s lies in; the first or last beyond the ends. `None` for lane 0.
pub(crate) fn segment_at(lane: &Lane<'_>, s: f64) -> Option<usize> {
    let points = lane.row.center().of(lane.map.tables().points);
    let ds = (s - lane.section.s_start()) as f32;
    let after = points.partition_point(|point| point.s() <= ds);
    let last = points.len().checked_sub(2)?;
    Some(after.saturating_sub(1).min(last))
}

/// Position and distance with respect to one slab; `local` is relative to the map's origin.
pub(crate) fn position_in_slab(lane: &Lane<'_>, slab: Slab, local: DVec2) -> Option<LanePosition> {
    let seed = slab.middle();
    let piece = lane.road.piece_at(At::new(seed))?;
    let foot = piece.curve.project_from(
        local.x,
        local.y,
        seed - piece.s,
        slab.s_lo - piece.s,
        slab.s_hi - piece.s,
    );
    let s = clamp(piece.s + foot.u, slab.s_lo, slab.s_hi);
    let at = slab.at(s);
    let (roll_cos, roll_sin) = lane.road.roll(at);
    let t = foot.lateral / roll_cos;
    let slopes = lane.edge_slopes(at);
    let edges = LaneEdges { inner: slopes.inner.value, outer: slopes.outer.value };
    let (low, high) = (edges.inner.min(edges.outer), edges.inner.max(edges.outer));
    let beside = t < low || t > high;
    let distance = if !beside && !foot.clamped {
        0.0
    } else {
        let mut best = f64::INFINITY;
        if foot.clamped {
            let (tangent, normal) =
                (DVec2::new(foot.cos, foot.sin), DVec2::new(-foot.sin, foot.cos));
            let away = local - DVec2::new(foot.x, foot.y);
            let sideways = away.dot(normal);
            let past = sideways - clamp(sideways, low * roll_cos, high * roll_cos);
            best = away.dot(tangent).hypot(past);
        }
        if beside {
            best = best.min(border_distance(
                lane,
                slab,
                &piece,
                local,
                s,
                (t > high) == (edges.outer >= edges.inner),
            )?);
        }
        best
    };
    Some(LanePosition {
        s,
        t,
        offset: t - edges.center(),
        distance,
        z: lane.road.elevation(at) + t * roll_sin,
        heading: normalize_angle(piece.curve.heading(s - piece.s)),
    })
}

/// Distance from a border within the slab, by Newton's method from the reference line's foot; every step is a point of
/// the border, so the smallest distance seen is an upper bound whatever happens.
fn border_distance(
    lane: &Lane<'_>,
    slab: Slab,
    piece: &Piece<'_>,
    local: DVec2,
    seed: f64,
    outer: bool,
) -> Option<f64> {
    let mut s = seed;
    let mut best = f64::INFINITY;
    for _ in 0..BORDER_ITERATIONS {
        let at = slab.at(s);
        let point = piece.curve.evaluate(s - piece.s);
        let slopes = lane.edge_slopes(at);
        let edge = if outer { slopes.outer } else { slopes.inner };
        let (roll_cos, _) = lane.road.roll(at);
        let lateral = edge.value * roll_cos;
        let (tangent, normal) =
            (DVec2::new(point.cos, point.sin), DVec2::new(-point.sin, point.cos));
        let away = local - (DVec2::new(point.x, point.y) + normal * lateral);
        best = best.min(away.length());
        let stretch = 1.0 - point.curvature * lateral;
        let derivative = tangent * stretch + normal * (edge.derivative * roll_cos);
        let squared = derivative.length_squared();
        if squared == 0.0 {
            break;
        }
        // Curvature of the border, its own change of t left out: it only shapes the step.
        let curvature = if stretch.abs() > f64::EPSILON { point.curvature / stretch } else { 0.0 };
        let contraction = (1.0 - curvature * away.dot(normal)).max(MIN_CONTRACTION);
        let next = s + away.dot(derivative) / (squared * contraction);
        let next = clamp(next, slab.s_lo, slab.s_hi);
        let step = (next - s).abs();
        if step <= BORDER_STEP || !step.is_finite() {
            break;
        }
        s = next;
    }
    Some(best)
}

/// Position with respect to the whole lane: the nearest of its slabs.
pub(crate) fn position_in(lane: &Lane<'_>, local: DVec2) -> Option<LanePosition> {
    let points = lane.row.center().of(lane.map.tables().points);
    let mut best: Option<LanePosition> = None;
    for segment in 0..points.len().saturating_sub(1) {
        let Some(slab) = slab(lane, segment) else { continue };
        let Some(found) = position_in_slab(lane, slab, local) else { continue };
        let better = |b: &LanePosition| {
            (found.distance, found.offset.abs()).partial_cmp(&(b.distance, b.offset.abs()))
                == Some(std::cmp::Ordering::Less)
        };
        if best.as_ref().is_none_or(better) {
            best = Some(found);
        }
    }
    best
}
