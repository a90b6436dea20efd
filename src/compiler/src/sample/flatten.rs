//! Polylines of bounded error.

use glam::DVec3;
use mapd_geometry::clamp;
use mapd_query::compiling::{MostBend, Parallel};
use std::f64::consts::FRAC_PI_2;

/// Depth of cutting one stretch into two or more parts, and these again.
const MAX_DEPTH: u32 = 20;
/// Parts between two points at whose joints the curve is compared with its chord.
const PARTS: usize = 4;
/// Share at which it is compared as well: a curve that comes back to the joints again and again is not there too, because
/// this is far from every simple fraction (1 − 1/φ).
const ODD_SHARE: f64 = 0.381_966_011_250_105_1;
/// Share of the tolerance that may be used up; the rest is for single precision.
const SHARE: f64 = 0.95;
/// Between two places the curve leaves the line through them by an eighth of the second difference there, if its second
/// derivative is constant; doubled, because it is not.
const BETWEEN: f64 = 2.0 / 8.0;

/// Second difference of an arc between the quarters of its chord, in units of the distance of its middle from it: so much for a
/// short one, four hundredths more for a quarter of a turn.
const BEND_OF_ARC: f64 = 0.5;
/// Arcs up to so long are nowhere as far from their chord as in the middle `[rad]`.
const LONGEST_ARC: f64 = FRAC_PI_2;

/// Share of the tolerance that says of all parts of an arc what it says of one: they are alike but for rounding.
const SURE: f64 = 0.999;

/// So much may places of a curve be displaced along it, counted several times `[m]`.
const DISPLACEMENT: f64 = 1e-6;

/// Factor on the distance from the chord when it is shared out: what may lie between the places comes to an eighth of it.
const ALLOWANCE: f64 = 1.15;
/// Parts that a stretch is cut into at once: what a few places say of a long stretch may be far off.
const MAX_PARTS: u32 = 64;

/// Points that one line may have: what the row of a lane can count.
const MOST_POINTS: usize = mapd_archive::MOST_OF_LANE;
/// Points that a line of any length may have besides two for each break.
const LEAST_POINTS: usize = 1024;
/// Points beyond these for each metre of s: one of a circle of 1 m within 1 mm has 11. A cubic of the file may be of any
/// length within a metre of s, so that neither the file nor the road says how many there are; and what looks for lines near a
/// point must not meet thousands.
const POINTS_OF_A_METRE: f64 = 64.0;

/// Why a line has no points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fault {
    /// A place of it is not finite.
    NotFinite,
    /// It bends more often than lines may.
    TooManyPoints,
}

/// A point of a polyline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sample {
    pub(crate) s: f64,
    pub(crate) position: DVec3,
}

/// A curve in space over s.
pub(crate) trait Curve<'a> {
    /// The place at s; none where it is not finite.
    fn at(&mut self, s: f64) -> Option<DVec3>;

    /// Whether the curve is known to be a segment from one s up to another: then it is not looked at in between.
    fn is_straight(&mut self, _from: f64, _to: f64) -> bool {
        false
    }

    /// Radians that it turns in plan view per metre of s, where the curve is known to be an arc or a helix from one s up to
    /// another: then its middle tells how far it is from its chord.
    fn arc(&mut self, _from: f64, _to: f64) -> Option<f64> {
        None
    }

    /// The line beside a road that the curve is known to be from one s up to another, rising evenly: that tells of its parts
    /// how far they bend at most, for less than looking at them.
    fn parallel(&mut self, _from: f64, _to: f64) -> Option<Parallel<'a>> {
        None
    }
}

/// How finely a stretch is cut.
#[derive(Clone, Copy)]
struct Fineness<'p> {
    tolerance: f64,
    /// Points that the line may have.
    most: usize,
    /// Longest part `[m]` that is an arc as far as [`LONGEST_ARC`]; 0 where there is none.
    arc: f64,
    parallel: Option<&'p Parallel<'p>>,
}

impl<F: FnMut(f64) -> Option<DVec3>> Curve<'_> for F {
    fn at(&mut self, s: f64) -> Option<DVec3> {
        self(s)
    }
}

/// Samples a curve that is smooth between consecutive `breaks` (ascending, at least two), so that no point of it lies
/// farther than `tolerance` from the polyline. Where the curve jumps at a break, both sides become points of equal s.
///
/// Errors: it is not finite, or would have more than [`MOST_POINTS`], or more than lines of its length may have.
pub(crate) fn flatten<'a>(
    breaks: &[f64],
    tolerance: f64,
    curve: &mut impl Curve<'a>,
    out: &mut Vec<Sample>,
) -> Result<(), Fault> {
    out.clear();
    let most = most(breaks);
    for pair in breaks.windows(2) {
        let (start, end) = (pair[0], pair[1]);
        // Just below the break, where the records of this stretch still hold.
        let last = if end > start { end.next_down() } else { end };
        let first = Sample { s: start, position: place(curve, start)? };
        match out.last() {
            Some(before) if before.position.distance(first.position) <= 0.1 * tolerance => {}
            _ => out.push(first),
        }
        if end > start {
            let last = Sample { s: end, position: place(curve, last)? };
            if curve.is_straight(start, end) {
                out.push(last);
            } else {
                let turn = curve.arc(start, end);
                let arc = turn.map_or(0.0, |turn| LONGEST_ARC / turn.abs());
                let parallel = if turn.is_none() { curve.parallel(start, end) } else { None };
                let parallel = parallel.as_ref();
                let fineness = Fineness { tolerance: tolerance * SHARE, most, arc, parallel };
                let bend = parallel.and_then(|line| line.from(start)?.up_to(end));
                refine((first, last), bend, fineness, MAX_DEPTH, curve, out)?;
            }
        }
        if out.len() > most {
            return Err(Fault::TooManyPoints);
        }
    }
    Ok(())
}

/// Points that a line with these breaks may have.
fn most(breaks: &[f64]) -> usize {
    let length = breaks.last().zip(breaks.first()).map_or(0.0, |(end, start)| end - start);
    // Casts saturate.
    let by_length = (length * POINTS_OF_A_METRE) as usize;
    LEAST_POINTS.saturating_add(2 * breaks.len()).saturating_add(by_length).min(MOST_POINTS)
}

fn place<'a>(curve: &mut impl Curve<'a>, s: f64) -> Result<DVec3, Fault> {
    curve.at(s).ok_or(Fault::NotFinite)
}

/// What a stretch needs.
#[derive(Clone, Copy)]
struct Need {
    /// Parts that it is cut into.
    parts: u32,
    /// Whether all stretches of its length on the same arc surely need one part.
    settles_alike: bool,
}

/// Appends the points behind the first one of a stretch, of which may be known how far it bends at most. Whether other stretches of its length surely need one segment as well.
// Part of the loop over the parts of a longer stretch, most of which need no more: both ends stay in registers.
#[inline(always)]
fn refine<'a>(
    (a, b): (Sample, Sample),
    bend: Option<MostBend>,
    fineness: Fineness<'_>,
    depth: u32,
    curve: &mut impl Curve<'a>,
    out: &mut Vec<Sample>,
) -> Result<bool, Fault> {
    if out.len() > fineness.most {
        return Err(Fault::TooManyPoints);
    }
    // Not settled, though it need not be looked at: others of its length may bend further.
    if bend.is_some_and(|bend| most_seen(bend) + DISPLACEMENT <= SURE * fineness.tolerance) {
        out.push(b);
        return Ok(false);
    }
    let one = Need { parts: 1, settles_alike: false };
    let Need { parts, settles_alike } =
        if depth == 0 { one } else { need(a, b, fineness, curve).ok_or(Fault::NotFinite)? };
    if parts == 1 {
        out.push(b);
        return Ok(settles_alike);
    }
    cut((a, b), parts, fineness, depth - 1, curve, out)?;
    Ok(false)
}

/// Cuts a stretch into so many parts, and these as they need.
fn cut<'a>(
    (a, b): (Sample, Sample),
    parts: u32,
    fineness: Fineness<'_>,
    depth: u32,
    curve: &mut impl Curve<'a>,
    out: &mut Vec<Sample>,
) -> Result<(), Fault> {
    let mut from = a;
    let mut is_settled = false;
    let mut bends = fineness.parallel.and_then(|line| line.from(a.s));
    for i in 1..=parts {
        let to = if i == parts {
            b
        } else {
            let s = a.s + (b.s - a.s) * (f64::from(i) / f64::from(parts));
            Sample { s, position: place(curve, s)? }
        };
        if is_settled {
            out.push(to);
        } else {
            let bend = bends.as_mut().and_then(|bends| bends.up_to(to.s));
            is_settled = refine((from, to), bend, fineness, depth, curve, out)?;
        }
        from = to;
    }
    Ok(())
}

/// What a stretch needs: one part where the curve stays near the chord between two of its points, at the places
/// that are looked at, and, as far as differences tell how it bends, between them.
fn need<'a>(
    a: Sample,
    b: Sample,
    fineness: Fineness<'_>,
    curve: &mut impl Curve<'a>,
) -> Option<Need> {
    let tolerance = fineness.tolerance;
    let mut at = |share: f64| curve.at(a.s + (b.s - a.s) * share);
    let mut place = |i: usize| at(i as f64 / PARTS as f64);
    let chord = Chord::new(a.position, b.position);
    // The middle first: most stretches that are not flat show it there.
    let middle = place(PARTS / 2)?;
    let off = chord.distance_squared(middle).sqrt();
    if off > tolerance {
        return Some(Need { parts: needed(off / tolerance), settles_alike: false });
    }
    let in_all = |off: f64, bend: f64| {
        let excess = (off + BETWEEN * bend) / tolerance;
        let parts = if excess <= 1.0 { 1 } else { needed(excess) };
        Need { parts, settles_alike: fineness.arc > 0.0 && excess <= SURE }
    };
    if b.s - a.s <= fineness.arc {
        return Some(in_all(off, BEND_OF_ARC * off));
    }
    let (mut before, mut here) = (a.position, place(1)?);
    let (mut off, mut bend) = (off * off, 0f64);
    for i in 1..PARTS {
        off = off.max(chord.distance_squared(here));
        let next = match i + 1 {
            PARTS => b.position,
            i if i == PARTS / 2 => middle,
            i => place(i)?,
        };
        bend = bend.max((before - 2.0 * here + next).length_squared());
        (before, here) = (here, next);
    }
    off = off.max(chord.distance_squared(at(ODD_SHARE)?));
    Some(in_all(off.sqrt(), bend.sqrt()))
}

/// The most that is found of a curve that bends by this at most: how far places of it are off its chord, and what the differences of places a
/// share of its length apart say of those in between.
fn most_seen(MostBend { any, across }: MostBend) -> f64 {
    across / 8.0 + BETWEEN * (any / (PARTS * PARTS) as f64)
}

/// Parts into which a stretch is cut whose curve leaves the chord by more than the tolerance, so many times: the distance
/// falls with the square of the length.
fn needed(excess: f64) -> u32 {
    // Not a number counts as the least. (Casts saturate.)
    let parts = (excess * ALLOWANCE).sqrt().ceil() as u32;
    // Not with `if` and `max`: rustc 1.95 forgets the upper bound then, in some builds.
    parts.clamp(2, MAX_PARTS)
}

/// A segment that distances are measured from.
struct Chord {
    start: DVec3,
    along: DVec3,
    /// Inverse of the squared length; 0 without one.
    inverse: f64,
}

impl Chord {
    fn new(a: DVec3, b: DVec3) -> Self {
        let along = b - a;
        let squared = along.length_squared();
        Self { start: a, along, inverse: if squared > 0.0 { 1.0 / squared } else { 0.0 } }
    }

    fn distance_squared(&self, p: DVec3) -> f64 {
        let away = p - self.start;
        let share = clamp(away.dot(self.along) * self.inverse, 0.0, 1.0);
        (away - self.along * share).length_squared()
    }
}

/// Distance of a point from a segment.
pub(crate) fn distance_to_segment(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    Chord::new(a, b).distance_squared(p).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOLERANCE: f64 = 0.01;

    /// A rising arc; how often it was asked for a place.
    struct Helix {
        radius: f64,
        asked: usize,
    }

    impl Curve<'_> for Helix {
        fn at(&mut self, s: f64) -> Option<DVec3> {
            self.asked += 1;
            let (cos, sin) = mapd_geometry::cos_sin(s / self.radius);
            Some(DVec3::new(1000.0 + self.radius * cos, self.radius * sin, 0.05 * s))
        }

        fn arc(&mut self, _from: f64, _to: f64) -> Option<f64> {
            Some(1.0 / self.radius)
        }
    }

    /// Parts of an arc are alike: each of them was compared with its chord. It still stays near them all over.
    #[test]
    fn of_an_arcs_parts_one_is_looked_at() {
        for (radius, length) in [(2.0, 3.0), (8.0, 12.0), (30.0, 20.0), (400.0, 300.0)] {
            let (mut helix, mut line) = (Helix { radius, asked: 0 }, Vec::new());
            flatten(&[0.0, length], TOLERANCE, &mut helix, &mut line).expect("it is sampled");
            assert!(line.len() > 4, "{radius}");
            assert!(helix.asked <= line.len() + 12, "{} for {}", helix.asked, line.len());
            for pair in line.windows(2) {
                let [a, b] = [pair[0], pair[1]];
                for part in 1..20 {
                    let s = a.s + (b.s - a.s) * f64::from(part) / 20.0;
                    let place = helix.at(s).expect("a place");
                    let off = distance_to_segment(place, a.position, b.position);
                    assert!(off <= TOLERANCE, "{radius}: {off} at {s}");
                }
            }
        }
    }

    #[test]
    fn a_stretch_is_cut_into_two_to_so_many_parts() {
        for (excess, parts) in
            [(f64::NAN, 2), (0.0, 2), (1.0, 2), (5000.0, MAX_PARTS), (f64::INFINITY, MAX_PARTS)]
        {
            assert_eq!(needed(std::hint::black_box(excess)), parts, "{excess}");
        }
    }
}
