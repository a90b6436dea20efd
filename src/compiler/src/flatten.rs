//! Polylines of bounded error.

use glam::DVec3;
use mapd_geometry::clamp;

/// Halvings of one stretch. 2²⁰ pieces of a stretch that is not smooth at all are enough to stop at.
const MAX_DEPTH: u32 = 20;
/// Parts between two points at whose joints the curve is compared with its chord.
const PARTS: usize = 8;
/// Share of the tolerance that may be used up; the rest is for single precision.
const SHARE: f64 = 0.95;
/// Between two places the curve leaves the line through them by an eighth of the second difference there, if its second
/// derivative is constant; doubled, because it is not.
const BETWEEN: f64 = 2.0 / 8.0;

/// A point of a polyline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sample {
    pub(crate) s: f64,
    pub(crate) position: DVec3,
}

/// Samples a curve that is smooth between consecutive `breaks` (ascending, at least two), so that no point of it lies
/// farther than `tolerance` from the polyline. Where the curve jumps at a break, both sides become points of equal s.
pub(crate) fn flatten(
    breaks: &[f64],
    tolerance: f64,
    curve: &impl Fn(f64) -> Option<DVec3>,
    out: &mut Vec<Sample>,
) -> Option<()> {
    out.clear();
    for pair in breaks.windows(2) {
        let (start, end) = (pair[0], pair[1]);
        // Just below the break, where the records of this stretch still hold.
        let last = if end > start { end.next_down() } else { end };
        let first = Sample { s: start, position: curve(start)? };
        match out.last() {
            Some(before) if before.position.distance(first.position) <= 0.1 * tolerance => {}
            _ => out.push(first),
        }
        if end > start {
            let last = Sample { s: end, position: curve(last)? };
            refine(first, last, tolerance * SHARE, MAX_DEPTH, curve, out)?;
        }
    }
    Some(())
}

fn refine(
    a: Sample,
    b: Sample,
    tolerance: f64,
    depth: u32,
    curve: &impl Fn(f64) -> Option<DVec3>,
    out: &mut Vec<Sample>,
) -> Option<()> {
    let at = |share: f64| a.s + share * (b.s - a.s);
    let flat = depth == 0 || is_flat(a, b, tolerance, curve)?;
    if flat {
        out.push(b);
        return Some(());
    }
    let middle = Sample { s: at(0.5), position: curve(at(0.5))? };
    refine(a, middle, tolerance, depth - 1, curve, out)?;
    refine(middle, b, tolerance, depth - 1, curve, out)
}

/// Whether a curve stays near the chord between two of its points: at the places that are looked at, and, as far as
/// differences tell how it bends, between them.
fn is_flat(
    a: Sample,
    b: Sample,
    tolerance: f64,
    curve: &impl Fn(f64) -> Option<DVec3>,
) -> Option<bool> {
    let place = |i: usize| curve(a.s + (b.s - a.s) * (i as f64 / PARTS as f64));
    // The middle first: most stretches that are not flat show it there.
    let middle = place(PARTS / 2)?;
    if distance_to_segment(middle, a.position, b.position) > tolerance {
        return Some(false);
    }
    let (mut before, mut here) = (a.position, place(1)?);
    let (mut off, mut bend) = (0f64, 0f64);
    for i in 1..PARTS {
        off = off.max(distance_to_segment(here, a.position, b.position));
        let next = match i + 1 {
            PARTS => b.position,
            i if i == PARTS / 2 => middle,
            i => place(i)?,
        };
        bend = bend.max((before - 2.0 * here + next).length());
        (before, here) = (here, next);
    }
    Some(off + BETWEEN * bend <= tolerance)
}

/// Distance of a point from a segment.
pub(crate) fn distance_to_segment(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    let d = b - a;
    let squared = d.length_squared();
    let along = if squared > 0.0 { clamp((p - a).dot(d) / squared, 0.0, 1.0) } else { 0.0 };
    p.distance(a + d * along)
}
