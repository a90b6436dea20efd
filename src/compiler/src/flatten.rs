//! Polylines of bounded error.

use glam::DVec3;
use mapd_geometry::clamp;

/// Halvings of one stretch. 2²⁰ pieces of a stretch that is not smooth at all are enough to stop at.
const MAX_DEPTH: u32 = 20;
/// Places between two points where the curve is compared with its chord. Odd eighths and quarters, because curves that
/// bend both ways cross their chord in the middle.
const PROBES: [f64; 5] = [0.125, 0.25, 0.5, 0.75, 0.875];
/// Share of the tolerance that probes may use up; the rest covers what lies between them and single precision.
const SHARE: f64 = 0.8;

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
    let mut flat = true;
    if depth > 0 {
        for probe in PROBES {
            if distance_to_segment(curve(at(probe))?, a.position, b.position) > tolerance {
                flat = false;
                break;
            }
        }
    }
    if flat {
        out.push(b);
        return Some(());
    }
    let middle = Sample { s: at(0.5), position: curve(at(0.5))? };
    refine(a, middle, tolerance, depth - 1, curve, out)?;
    refine(middle, b, tolerance, depth - 1, curve, out)
}

/// Distance of a point from a segment.
pub(crate) fn distance_to_segment(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    let d = b - a;
    let squared = d.length_squared();
    let along = if squared > 0.0 { clamp((p - a).dot(d) / squared, 0.0, 1.0) } else { 0.0 };
    p.distance(a + d * along)
}
