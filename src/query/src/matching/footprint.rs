//! The density of a place on a vehicle: that of the pose's position spread over the vehicle's outline, and its integral over a
//! stretch of a lane.
//!
//! Across a lane, both the outline's slice and the lane are intervals: the integral over both of a normal density is exact. Along
//! it there are two more: over the outline, whose edges are straight, by Gauss's rule of two points for the normal density between
//! two corners; and over s, by the rule of Gauss and Kronrod, on parts that begin and end where the density does, halved until
//! [`SHARE_ERROR`] is kept.

use super::MatchError;
use super::cuts::Cuts;
use super::density::{CrossLine, MAP_DEVIATION, PoseDensity, REACH, share_between};
use super::stretch::{MIN_STRETCH, cross_line};
use crate::area::Slab;
use crate::lane::Lane;
use glam::{DMat2, DVec2};
use mapd_geometry::{clamp, cos_sin};
use std::f64::consts::{FRAC_1_SQRT_2, TAU};

/// What the error of a stretch's share is aimed at, where all hypotheses have 1. What is compared with it is the sum of the parts' estimates: each
/// is that of the rule of seven points, far above that of fifteen.
const SHARE_ERROR: f64 = 1e-4;
/// Largest size of an outline to each side `[m]`.
const MOST_SIZE: f64 = 100.0;
/// A part is no longer than the outline along s and so many deviations, for its fifteen places to meet the density.
const LONGEST_PART: f64 = 6.0;
/// Into how many such parts what lies between two cuts is divided at most.
const MOST_PARTS: f64 = 64.0;
/// Parts of a stretch that are halved at most, and that wait for it.
const MOST_HALVED: usize = 512;
const MOST_WAITING: usize = 256;
/// From so many times the least deviation on, the greatest makes a density that needs cuts of its own.
const THIN: f64 = 4.0;
/// Radians that the line turns between two places at which such cuts are sought, and how many places there are.
const TURN_STEP: f64 = 0.2;
const PLACES: [f64; 2] = [4.0, 64.0];
/// Steps to the place of such a cut, which ends them when it is so near, in deviations.
const CROSSING_STEPS: usize = 6;
const NEAR_CROSSING: f64 = 0.2;
/// Steps of Newton's method for a corner's s.
const CORNER_STEPS: usize = 4;
/// By how many deviations across an edge may move over a part of the outline to which the rule of two points is applied.
const SLANT: f64 = 0.3;
const MOST_SLANTED: f64 = 32.0;
/// As [`SLANT`], where an edge passes the lane's border within a small part of a slice, and deviations to each side which that takes.
const STEEP_SLANT: f64 = 0.4;
const PASSAGE: f64 = 5.0;
/// Deviations across between which most of a normal density lies, for that.
const BROAD: f64 = 4.0;
/// Below this a part's moments lose their digits, in deviations.
const NARROW: f64 = 0.1;
/// From so many deviations on, what lies beyond is less than rounding.
const CERTAIN: f64 = 8.0;

/// Places and weights of the rule of fifteen points on [−1, 1] (Kronrod), from the middle outwards, and the weights of every second
/// of them (Gauss).
const KRONROD: [(f64, f64); 8] = [
    (0.0, 0.209_482_141_084_727_83),
    (0.207_784_955_007_898_47, 0.204_432_940_075_298_9),
    (0.405_845_151_377_397_2, 0.190_350_578_064_785_4),
    (0.586_087_235_467_691_1, 0.169_004_726_639_267_9),
    (0.741_531_185_599_394_4, 0.140_653_259_715_525_9),
    (0.864_864_423_359_769_1, 0.104_790_010_322_250_18),
    (0.949_107_912_342_758_5, 0.063_092_092_629_978_55),
    (0.991_455_371_120_812_6, 0.022_935_322_010_529_224),
];
const GAUSS: [f64; 4] = [
    0.417_959_183_673_469_4,
    0.381_830_050_505_118_9,
    0.279_705_391_489_276_64,
    0.129_484_966_168_869_7,
];

/// Plan view of a vehicle: a rectangle around the place of its pose, along its heading.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct VehicleOutline {
    /// How far it reaches from the pose's place ahead `[m]`, in [0, 100]; so have the other three.
    pub front: f64,
    /// How far behind it `[m]`.
    pub back: f64,
    /// How far to the left `[m]`.
    pub left: f64,
    /// How far to the right `[m]`.
    pub right: f64,
}

impl VehicleOutline {
    /// Errors: by name, a size out of its domain.
    pub(super) fn check(&self) -> Result<(), MatchError> {
        let sizes = [
            ("outline.front", self.front),
            ("outline.back", self.back),
            ("outline.left", self.left),
            ("outline.right", self.right),
        ];
        match sizes.iter().find(|(_, size)| !(0.0..=MOST_SIZE).contains(size)) {
            Some((name, _)) => Err(MatchError::Option(name)),
            None => Ok(()),
        }
    }
}

/// The density of a place on a vehicle with a heading.
#[derive(Clone, Copy, Debug)]
pub(super) struct Footprint {
    /// Corners of the outline, one after another, from the pose's place `[m]`.
    corners: [DVec2; 4],
    /// `[m²]`.
    area: f64,
    /// Of the position, given the heading, and its inverse.
    covariance: DMat2,
    precision: DMat2,
    /// By how much the mean position moves with a direction that differs from the pose's heading `[m/rad]`.
    gain: DVec2,
    /// Weight that is compared with the lanes'.
    none: f64,
}

impl Footprint {
    /// `none` is the weight of the hypothesis of that name. `None` for an outline without any size.
    ///
    /// Errors: deviations so unlike that the position's, given the heading, are lost in rounding.
    pub(super) fn new(
        outline: &VehicleOutline,
        heading: f64,
        density: &PoseDensity,
        none: f64,
    ) -> Result<Option<Self>, MatchError> {
        let VehicleOutline { front, back, left, right } = *outline;
        if front + back == 0.0 && left + right == 0.0 {
            return Ok(None);
        }
        // A vehicle without a width is as wide as the map is exact.
        let widened = |size: f64| 0.5 * (MAP_DEVIATION - size).max(0.0);
        let (more, wider) = (widened(front + back), widened(left + right));
        let (front, back, left, right) = (front + more, back + more, left + wider, right + wider);
        let (cos, sin) = cos_sin(heading);
        let corners = [(front, left), (-back, left), (-back, -right), (front, -right)]
            .map(|(ahead, aside)| DVec2::new(cos, sin).rotate(DVec2::new(ahead, aside)));
        let (precision, gain) = density.given_heading();
        let covariance = precision.inverse();
        let is_sound = precision.determinant() > 0.0 && precision.x_axis.x > 0.0;
        if !(is_sound && covariance.is_finite() && gain.is_finite()) {
            return Err(MatchError::Determinant);
        }
        let area = (front + back) * (left + right);
        Ok(Some(Self { corners, area, covariance, precision, gain, none }))
    }

    /// How far the outline reaches from the pose's place `[m]`.
    pub(super) fn radius(&self) -> f64 {
        self.corners.iter().map(|corner| corner.length()).fold(0.0, f64::max)
    }

    /// The integral over a stretch, of which `foot` is the s nearest to the pose's place `local`.
    pub(super) fn weight(
        &self,
        (lane, slab): (&Lane<'_>, &Slab<'_>),
        foot: f64,
        local: DVec2,
        density: &PoseDensity,
        forward: bool,
    ) -> f64 {
        // Once, not in each of its uses: the line across is long code.
        let cut: &dyn Fn(f64) -> CrossLine = &|s| cross_line(lane, slab, s, local, forward);
        let at_foot = cut(foot);
        let stretch = |l: f64| 1.0 - at_foot.curvature * l;
        let least = stretch(at_foot.low).min(stretch(at_foot.high)).max(MIN_STRETCH);
        let window = (density.reach + self.radius()) / least;
        let from = clamp(foot - window, slab.s_lo, slab.s_hi);
        let to = clamp(foot + window, slab.s_lo, slab.s_hi);
        let has_area = from < to;
        if !has_area {
            return 0.0;
        }
        let mut cuts = Cuts::new(from, to);
        self.cut_at_corners(foot, cut, density, &mut cuts);
        self.cut_at_borders(foot, cut, density, &mut cuts);
        let longest = self.longest_part(&at_foot) / least;
        let value = |s: f64| self.integral(&cut(s), density);
        let mut waiting = Waiting::new();
        cuts.each_part(|begin, end| {
            let parts = clamp(((end - begin) / longest).ceil(), 1.0, MOST_PARTS);
            let step = (end - begin) / parts;
            for i in 0..parts as usize {
                let start = begin + step * i as f64;
                waiting.push(Part::new(start, start + step, value));
            }
        });
        for _ in 0..MOST_HALVED {
            let is_rough = waiting.error > SHARE_ERROR * (waiting.sum + self.none);
            if !is_rough {
                break;
            }
            let Some(part) = waiting.worst() else { break };
            let middle = 0.5 * (part.from + part.to);
            for (from, to) in [(part.from, middle), (middle, part.to)] {
                waiting.push(Part::new(from, to, value));
            }
        }
        waiting.sum.max(0.0)
    }

    /// Length of a part that cannot lie around all of the density without a place on it.
    fn longest_part(&self, line: &CrossLine) -> f64 {
        let tangent = line.tangent();
        let places = self.corners.map(|corner| tangent.dot(corner));
        let (low, high) = places
            .iter()
            .fold((0.0f64, 0.0f64), |(low, high), place| (low.min(*place), high.max(*place)));
        high - low + LONGEST_PART / tangent.dot(self.precision * tangent).sqrt()
    }

    /// Where the mean position is, for a line's direction.
    fn mean(&self, line: &CrossLine, density: &PoseDensity) -> DVec2 {
        self.gain * density.turn_to(line.direction)
    }

    /// Cuts at the corners' s, where each begins or ends the outline along the line.
    fn cut_at_corners(
        &self,
        foot: f64,
        cut: &dyn Fn(f64) -> CrossLine,
        density: &PoseDensity,
        cuts: &mut Cuts,
    ) {
        for corner in self.corners {
            let (mut s, mut deviation) = (foot, 0.0);
            for _ in 0..=CORNER_STEPS {
                let line = cut(s);
                let tangent = line.tangent();
                let away = corner + self.mean(&line, density) - line.foot;
                let stretch = 1.0 - line.curvature * line.normal.dot(away);
                let stretch = stretch.max(MIN_STRETCH);
                s += tangent.dot(away) / stretch;
                deviation = tangent.dot(self.covariance * tangent).sqrt() / stretch;
            }
            cuts.add(s, deviation);
        }
    }

    /// Cuts where the lane's borders lead into what is left of a corner when its place is known far better in one direction than in the other, and
    /// where the lane turns through the pose's heading within a small part of the stretch.
    fn cut_at_borders(
        &self,
        foot: f64,
        cut: &dyn Fn(f64) -> CrossLine,
        density: &PoseDensity,
        cuts: &mut Cuts,
    ) {
        let (from, to) = (cuts.from, cuts.to);
        let [least, greatest] = axes(&self.covariance);
        let is_thin = greatest.length() > THIN * least.length();
        let bend = [from, foot, to].map(|s| cut(s).curvature.abs()).into_iter().fold(0.0, f64::max);
        let turn = bend * (to - from);
        let heading = density.known_deviation().filter(|known| turn > 2.0 * REACH * known);
        if !is_thin && heading.is_none() {
            return;
        }
        let corners = if is_thin { &self.corners[..] } else { &[] };
        // Along both axes, in deviations.
        let (thin, long) = (least / least.length_squared(), greatest / greatest.length_squared());
        let borders = |s: f64| {
            let line = cut(s);
            let foot = line.foot - self.mean(&line, density);
            [foot + line.normal * line.low, foot + line.normal * line.high]
        };
        let steps = clamp((turn / TURN_STEP).ceil(), PLACES[0], PLACES[1]);
        let place = |i: usize| from + (to - from) / steps * i as f64;
        let mut before = (from, borders(from));
        for i in 1..=steps as usize {
            let after = (place(i), borders(place(i)));
            for border in 0..2 {
                let ends = [(before.0, before.1[border]), (after.0, after.1[border])];
                for corner in corners {
                    let away = |s: f64| thin.dot(borders(s)[border] - *corner);
                    let at = |(s, place): (f64, DVec2)| (s, thin.dot(place - *corner));
                    let Some((s, deviation)) = crossing(ends.map(at), away) else { continue };
                    if long.dot(borders(s)[border] - *corner).abs() <= CERTAIN {
                        cuts.add(s, deviation);
                    }
                }
            }
            if let Some(known) = heading {
                let turn = |s: f64| density.turn_to(cut(s).direction) / known;
                let ends = [before.0, after.0].map(|s| (s, turn(s)));
                let leaps = (ends[0].1 - ends[1].1).abs() * known > 0.5 * TAU;
                if let Some((s, deviation)) = crossing(ends, turn).filter(|_| !leaps) {
                    cuts.add(s, deviation);
                }
            }
            before = after;
        }
    }

    /// Integral along a line across a lane, of the density times 1 − κ·l.
    fn integral(&self, line: &CrossLine, density: &PoseDensity) -> f64 {
        let line = line.within_curvature();
        let has_area = line.low < line.high;
        if !has_area {
            return 0.0;
        }
        let mut sum = 0.0;
        density.each_turn(line.direction, |share, turn| {
            sum += share * self.overlap(&line, self.gain * turn);
        });
        sum
    }

    /// The density of the place of a vehicle whose position has this mean, along a line across.
    fn overlap(&self, line: &CrossLine, mean: DVec2) -> f64 {
        let (normal, tangent) = (line.normal, line.tangent());
        let along = tangent.dot(self.covariance * tangent).sqrt();
        let across = 1.0 / normal.dot(self.precision * normal).sqrt();
        let lean = normal.dot(self.covariance * tangent) / (along * along);
        let foot = line.foot - mean;
        // Corners along, in deviations from the line, and across, at which the line's own places have 0.
        let mut corners = self.corners.map(|corner| {
            let away = corner - foot;
            let x = tangent.dot(away);
            DVec2::new(x / along, normal.dot(away) - lean * x)
        });
        let first = (0..4).min_by(|a, b| corners[*a].x.total_cmp(&corners[*b].x)).unwrap_or(0);
        corners.rotate_left(first);
        // The last is opposite to the first; the nearer of the other two is the second.
        let [a, mut b, d, mut c] = corners;
        if b.x > c.x {
            (b, c) = (c, b);
        }
        let mut sum = 0.0;
        for (from, to, one, other) in
            [(a.x, b.x, [a, b], [a, c]), (b.x, c.x, [a, c], [b, d]), (c.x, d.x, [c, d], [b, d])]
        {
            let (from, to) = (from.max(-REACH), to.min(REACH));
            if from < to {
                sum += slices([from, to], [one, other], line, across);
            }
        }
        sum / self.area
    }
}

/// The axes of a covariance, each as long as its deviation: the least first.
fn axes(covariance: &DMat2) -> [DVec2; 2] {
    let (a, b, d) = (covariance.x_axis.x, covariance.x_axis.y, covariance.y_axis.y);
    let great = 0.5 * (a + d) + libm::hypot(0.5 * (a - d), b);
    let small = covariance.determinant() / great;
    let (cos, sin) = cos_sin(0.5 * libm::atan2(2.0 * b, a - d));
    let long = DVec2::new(cos, sin);
    [long.perp() * small.max(0.0).sqrt(), long * great.sqrt()]
}

/// Where a value passes 0 between two places, at which it is known, and over what length it changes by 1 there.
fn crossing(ends: [(f64, f64); 2], value: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
    let [(mut a, mut low), (mut b, mut high)] = ends;
    if low * high > 0.0 || low == high {
        return None;
    }
    let mut s = a;
    for _ in 0..CROSSING_STEPS {
        s = a + (b - a) * low / (low - high);
        let here = value(s);
        if here.abs() <= NEAR_CROSSING || low == high {
            break;
        }
        if here * low > 0.0 {
            (a, low) = (s, here);
        } else {
            (b, high) = (s, here);
        }
    }
    Some((s, ((b - a) / (high - low)).abs()))
}

/// Integral over the slices between two edges of an outline, from one place along to another, in deviations.
fn slices([from, to]: [f64; 2], edges: [[DVec2; 2]; 2], line: &CrossLine, across: f64) -> f64 {
    let slope = |[a, b]: [DVec2; 2]| if b.x > a.x { (b.y - a.y) / (b.x - a.x) } else { 0.0 };
    let [one, other] = edges.map(|edge| (edge[0], slope(edge)));
    let at = |(a, slope): (DVec2, f64), x: f64| a.y + slope * (x - a.x);
    let steep = one.1.abs().max(other.1.abs()) / across;
    let parts = (steep * (to - from).min(BROAD) / SLANT).ceil();
    let between = |begin: f64, end: f64, parts: f64| {
        let step = (end - begin) / parts;
        let mut sum = 0.0;
        for i in 0..parts as usize {
            let begin = begin + step * i as f64;
            for (x, share) in normal_rule(begin, begin + step) {
                let (y, z) = (at(one, x), at(other, x));
                sum += share * interval_overlap(y.min(z), y.max(z), line, across);
            }
        }
        sum
    };
    if parts <= MOST_SLANTED {
        return between(from, to, parts.max(1.0));
    }
    // Places where an edge passes a border, and how far from them it has passed: elsewhere the rule is exact.
    let mut passages = [(0.0, -1.0); 4];
    let mut ends = [to; 9];
    for (i, (edge, slope)) in [one, one, other, other].into_iter().enumerate() {
        let border = if i % 2 == 0 { line.low } else { line.high };
        if slope != 0.0 {
            let place = edge.x + (border - edge.y) / slope;
            let half = PASSAGE * across / slope.abs();
            passages[i] = (place, half);
            ends[2 * i] = clamp(place - half, from, to);
            ends[2 * i + 1] = clamp(place + half, from, to);
        }
    }
    ends.sort_unstable_by(f64::total_cmp);
    let (mut sum, mut begin) = (0.0, from);
    for end in ends {
        if begin < end {
            let middle = 0.5 * (begin + end);
            let passed = passages.iter().filter(|(place, half)| (middle - place).abs() < *half);
            let steepest = passed.map(|(_, half)| PASSAGE / half).fold(0.0, f64::max);
            let parts = (steepest * (end - begin) / STEEP_SLANT).ceil();
            sum += between(begin, end, clamp(parts, 1.0, MOST_SLANTED));
            begin = end;
        }
    }
    sum
}

/// Gauss's rule of two points for the standard normal density between two values: places and shares.
fn normal_rule(from: f64, to: f64) -> [(f64, f64); 2] {
    let whole = share_between(from, to);
    let (middle, width) = (0.5 * (from + to), to - from);
    let even = 0.5 * width / 3.0f64.sqrt();
    let equal = [(middle - even, 0.5 * whole), (middle + even, 0.5 * whole)];
    if width < NARROW || whole < f64::EPSILON {
        return equal;
    }
    // Moments, from the derivatives of the density at both ends.
    let (p, q) = (bell(from), bell(to));
    let mean = (p - q) / whole;
    let second = 1.0 + (from * p - to * q) / whole;
    let third = 2.0 * mean + (from * from * p - to * to * q) / whole;
    let variance = second - mean * mean;
    let skew = third - mean * (3.0 * second - 2.0 * mean * mean);
    let sound = from < mean && mean < to && variance > 0.01 * even * even;
    if !sound {
        return equal;
    }
    let half = 0.5 * skew / variance;
    let root = (half * half + variance).sqrt();
    let (low, high) = (half - root, half + root);
    let place = |x: f64| clamp(mean + x, from, to);
    [(place(low), whole * high / (high - low)), (place(high), -whole * low / (high - low))]
}

/// Integral over l between the line's ends, and over places between `low` and `high`, of the normal density of their difference, times
/// 1 − κ·l.
fn interval_overlap(low: f64, high: f64, line: &CrossLine, deviation: f64) -> f64 {
    let mut sum = 0.0;
    for (l, sign) in [(line.high, 1.0), (line.low, -1.0)] {
        let [a, b] = [l - low, l - high].map(|x| antiderivatives(x, deviation));
        let second = a[0] - b[0];
        sum += sign * second;
        if line.curvature != 0.0 {
            sum -= sign * line.curvature * (l * second - (a[1] - b[1]));
        }
    }
    sum
}

/// The second and the third antiderivative of the normal density of a deviation.
fn antiderivatives(x: f64, deviation: f64) -> [f64; 2] {
    let z = x / deviation;
    let square = deviation * deviation;
    if z >= CERTAIN {
        return [x, 0.5 * (x * x + square)];
    }
    if z <= -CERTAIN {
        return [0.0; 2];
    }
    let below = 0.5 * libm::erfc(-z * FRAC_1_SQRT_2);
    let height = deviation * bell(z);
    [x * below + height, 0.5 * ((x * x + square) * below + x * height)]
}

fn bell(x: f64) -> f64 {
    libm::exp(-0.5 * x * x) / TAU.sqrt()
}

/// A part of a stretch.
#[derive(Clone, Copy, Debug, Default)]
struct Part {
    from: f64,
    to: f64,
    sum: f64,
    error: f64,
}

impl Part {
    fn new(from: f64, to: f64, value: impl Fn(f64) -> f64) -> Self {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let (mut fine, mut coarse) = (0.0, 0.0);
        for (i, (place, share)) in KRONROD.into_iter().enumerate() {
            let both = match i {
                0 => value(middle),
                _ => value(middle - half * place) + value(middle + half * place),
            };
            fine += share * both;
            if i % 2 == 0 {
                coarse += GAUSS[i / 2] * both;
            }
        }
        Self { from, to, sum: half * fine, error: half * (fine - coarse).abs() }
    }
}

/// The parts of a stretch whose errors are the greatest, and the sums of all.
struct Waiting {
    parts: [Part; MOST_WAITING],
    count: usize,
    sum: f64,
    error: f64,
}

impl Waiting {
    fn new() -> Self {
        Self { parts: [Part::default(); MOST_WAITING], count: 0, sum: 0.0, error: 0.0 }
    }

    /// Into a list that is full, in place of the one with the least error.
    fn push(&mut self, part: Part) {
        self.sum += part.sum;
        self.error += part.error;
        if let Some(free) = self.parts.get_mut(self.count) {
            *free = part;
            self.count += 1;
            return;
        }
        let least = self.parts.iter_mut().min_by(|a, b| a.error.total_cmp(&b.error));
        if let Some(least) = least.filter(|least| least.error < part.error) {
            *least = part;
        }
    }

    /// Takes the part with the greatest error.
    fn worst(&mut self) -> Option<Part> {
        let each = self.parts.get(..self.count)?.iter().enumerate();
        let (number, part) = each.max_by(|(_, a), (_, b)| a.error.total_cmp(&b.error))?;
        let part = *part;
        self.count -= 1;
        self.parts.swap(number, self.count);
        self.sum -= part.sum;
        self.error -= part.error;
        Some(part)
    }
}
