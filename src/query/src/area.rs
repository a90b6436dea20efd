//! The exact distance of a point from a lane's area.
//!
//! The index proposes a slab: a lane between two values of s within one plan-view geometry. Here the curve itself
//! decides: foot on the reference line, edges from the file's polynomials.

use crate::beside::Beside;
use crate::folds;
use crate::lane::Lane;
use crate::polyline::segment_ends;
use crate::profile::{self, At, Slope};
use crate::road::{GeometryPiece, geometry_at};
use crate::types::{Clamped, LaneEdges, LanePosition};
use glam::DVec2;
use mapd_archive::{ArchivedGeometryRow, lane_flags};
use mapd_geometry::{CurveKind, clamp, normalize_angle};

/// Iterations for the foot on a border; each gains several digits, the last ones are for points far outside.
const BORDER_ITERATIONS: usize = 12;
/// Step along a border `[m]` below which its foot counts as found.
const BORDER_STEP: f64 = 1e-10;
/// Nearness to the border's centre of curvature, as a share of the radius, below which Newton's method is not trusted.
const MIN_CONTRACTION: f64 = 0.5;
/// Beside an edge by more than this `[m]` is not on it.
pub(crate) const EDGE: f64 = 1e-9;
/// Bend of a border's t, times the point's distance, up to which the border counts as convex.
const MAX_SWING: f64 = 0.25;
/// Parts of a stretch that are looked at where it is not.
const SEARCH_PARTS: usize = 8;
/// Halvings of a part in which there is a foot: from metres to a picometre.
const HALVINGS: usize = 40;

/// Corners of a border that a stretch is looked at between: of each width that closes and opens there are three at most.
const MOST_CORNERS: usize = 16;

/// A stretch of a lane.
#[derive(Clone, Copy)]
pub(crate) struct Slab<'a> {
    /// First s `[m]`.
    pub(crate) s_lo: f64,
    /// Last s `[m]`.
    pub(crate) s_hi: f64,
    /// The geometry that holds there.
    pub(crate) geometry: &'a ArchivedGeometryRow,
    pub(crate) piece: GeometryPiece<'a>,
}

impl Slab<'_> {
    /// A part of it.
    #[inline]
    pub(crate) fn part(&self, s_lo: f64, s_hi: f64) -> Self {
        Self { s_lo, s_hi, ..*self }
    }

    #[inline]
    pub(crate) fn middle(&self) -> f64 {
        0.5 * (self.s_lo + self.s_hi)
    }

    /// A place in the slab, with what holds within: records and geometries begin where slabs do, but stored s are rounded.
    #[inline]
    pub(crate) fn at(&self, s: f64) -> At {
        At { s, hold: self.middle() }
    }
}

/// The slab of a segment of the lane's centre line, by its number within the line; none where it has no area.
#[inline(always)]
pub(crate) fn slab<'a>(lane: &Lane<'a>, segment: usize) -> Option<Slab<'a>> {
    let (start, end) = (lane.section.s_start(), lane.section.s_end());
    let count = usize::from(lane.row.center_count());
    let (lo, hi) = if segment == 0 && count == 2 {
        // All of the section, without a look at the points.
        (start, end)
    } else {
        let [a, b] = segment_ends(lane.map.tables(), lane.section.row, lane.row, segment)?;
        if a == b && count > 2 {
            // Both sides of a jump, or records that hold for less than single precision tells apart: no area, as in the index.
            return None;
        }
        // Stored s has 24 bits; the ends and, below, the joints of geometries are exact values, put back here.
        let lo = if segment == 0 { start } else { (start + f64::from(a)).min(end) };
        (lo, if segment + 2 == count { end } else { (start + f64::from(b)).min(end) })
    };
    let rows = lane.road.geometries();
    let at = geometry_at(rows, 0.5 * (lo + hi));
    let geometry = rows.get(at)?;
    let piece = lane.road.piece(geometry)?;
    let geometry_start = if at == 0 { f64::NEG_INFINITY } else { geometry.s() };
    let geometry_end = lane.road.geometry_end(at, geometry);
    let slack = (end - start) * f64::from(f32::EPSILON);
    let s_lo = if (lo - geometry_start).abs() <= slack { geometry_start } else { lo };
    let s_hi = if (hi - geometry_end).abs() <= slack { geometry_end } else { hi };
    (s_lo <= s_hi).then_some(Slab { s_lo, s_hi, geometry, piece })
}

/// The segment of the lane's centre line that s lies in; the first or last beyond the ends. `None` for lane 0.
pub(crate) fn segment_at(lane: &Lane<'_>, s: f64) -> Option<usize> {
    let points = lane.center_points();
    let ds = (s - lane.section.s_start()) as f32;
    let after = points.partition_point(|station| station <= ds);
    let last = points.len().checked_sub(2)?;
    Some(after.saturating_sub(1).min(last))
}

/// What a lane looks like across, at a place along it.
pub(crate) trait Cross {
    /// Cosine and sine of the superelevation.
    fn roll(&self, at: At) -> (f64, f64);

    /// Both edges, and whether they keep their t along s.
    fn edges(&self, at: At) -> (LaneEdges, bool);
}

impl Cross for Lane<'_> {
    #[inline]
    fn roll(&self, at: At) -> (f64, f64) {
        self.road.roll(at)
    }

    #[inline]
    fn edges(&self, at: At) -> (LaneEdges, bool) {
        self.edges_and_steady(at)
    }
}

/// A place across a lane, at a foot on the reference line.
pub(crate) struct LateralPlace {
    pub(crate) at: At,
    /// Cosine and sine of the superelevation.
    roll: (f64, f64),
    /// t of the point `[m]`.
    pub(crate) t: f64,
    edges: LaneEdges,
    /// Whether the edges keep their t along s.
    is_steady: bool,
}

impl LateralPlace {
    #[inline(always)]
    pub(crate) fn new(cross: &impl Cross, slab: &Slab<'_>, u: f64, lateral: f64) -> Self {
        let at = slab.at(clamp(slab.piece.s + u, slab.s_lo, slab.s_hi));
        let roll = cross.roll(at);
        let (edges, is_steady) = cross.edges(at);
        Self { at, roll, t: lateral / roll.0, edges, is_steady }
    }

    /// t of the lane's edges, the lower one first `[m]`.
    #[inline]
    pub(crate) fn sides(&self) -> [f64; 2] {
        let LaneEdges { inner, outer } = self.edges;
        [inner.min(outer), inner.max(outer)]
    }

    /// How far the point lies to the left of the lane's left edge or, negative, to the right of its right one, in plan view `[m]`; 0 between them.
    pub(crate) fn past(&self) -> f64 {
        let [low, high] = self.sides();
        (self.t - clamp(self.t, low, high)) * self.roll.0
    }

    #[inline]
    fn is_beside(&self) -> bool {
        let [low, high] = self.sides();
        // What is no number lies nowhere.
        !(low <= self.t && self.t <= high)
    }

    /// Distance of a point beside the lane from the border on its side `[m]`.
    fn border_distance(&self, lane: &Lane<'_>, slab: &Slab<'_>, local: DVec2) -> f64 {
        // Where the lane has no width at the foot, its number says on which side its outer border is.
        let outwards = match self.edges.outer - self.edges.inner {
            0.0 => lane.number() > 0,
            width => width > 0.0,
        };
        let outer = (self.t > self.sides()[1]) == outwards;
        Border { lane, slab, local, outer }.distance(self.at.s)
    }
}

/// How a point lies at an s, and how far ahead of its cross-section `[m]`. Generated once: only what is rarely asked looks at many places.
#[inline(never)]
pub(crate) fn across(
    lane: &Lane<'_>,
    slab: &Slab<'_>,
    local: DVec2,
    s: f64,
) -> (LateralPlace, f64) {
    let u = s - slab.piece.s;
    let point = slab.piece.curve.tangent(u);
    let away = local - DVec2::new(point.x, point.y);
    let lateral = DVec2::new(-point.sin, point.cos).dot(away);
    (LateralPlace::new(lane, slab, u, lateral), DVec2::new(point.cos, point.sin).dot(away))
}

/// A place found in a stretch of a lane. What nothing is decided by, it tells when asked.
#[derive(Clone, Copy)]
pub(crate) struct SlabPosition<'a> {
    geometry: &'a ArchivedGeometryRow,
    at: At,
    roll_sin: f64,
    /// Lateral coordinate `[m]`.
    pub(crate) t: f64,
    /// How far beside the lane's nearer edge `[m]`, 0 between them.
    beside: f64,
    /// Distance from the lane's centre, positive to the left of the reference line `[m]`.
    pub(crate) offset: f64,
    /// Whether the lane's edges keep their t along s.
    is_steady: bool,
    /// Whether the foot is an end of the slab, and the point lies beyond it.
    is_beyond: bool,
    /// Distance from the lane's area in plan view `[m]`.
    pub(crate) distance: f64,
}

impl<'a> SlabPosition<'a> {
    #[inline]
    pub(crate) fn new(
        geometry: &'a ArchivedGeometryRow,
        across: &LateralPlace,
        distance: f64,
        is_beyond: bool,
    ) -> Self {
        Self {
            geometry,
            at: across.at,
            roll_sin: across.roll.1,
            t: across.t,
            beside: across.t - clamp(across.t, across.sides()[0], across.sides()[1]),
            offset: across.t - across.edges.center(),
            is_steady: across.is_steady,
            is_beyond,
            distance,
        }
    }

    /// Distance along the reference line `[m]`.
    #[inline]
    pub(crate) fn s(&self) -> f64 {
        self.at.s
    }

    /// Height of the lane where it is nearest, between its edges `[m]`: what tells levels apart, beside a banked lane as well.
    #[inline]
    pub(crate) fn level(&self, lane: &Lane<'_>) -> f64 {
        lane.road.elevation(self.at) + (self.t - self.beside) * self.roll_sin
    }

    /// Heading of the lane's traffic at this offset from its centre `[rad]`, where that of the reference line is known.
    #[inline]
    pub(crate) fn driven_heading(&self, lane: &Lane<'_>, line: f64) -> f64 {
        // Beside a level road at one t it runs as the reference line does.
        let is_parallel = self.is_steady && self.roll_sin == 0.0;
        lane.heading_along(line, if is_parallel { 0.0 } else { self.turn(lane) })
    }

    /// By how much the line at this offset from the lane's centre turns off the reference line `[rad]`.
    #[inline(never)]
    fn turn(&self, lane: &Lane<'_>) -> f64 {
        let Some(piece) = lane.road.piece(self.geometry) else { return 0.0 };
        let derivative = lane.edge_slopes(self.at).center().derivative;
        let t = Slope { value: self.t, derivative };
        let beside = Beside::new(&lane.road, self.at, lane.road.roll(self.at), t);
        beside.turn(piece.speed_and_curvature(self.at.s))
    }

    /// Heading of the reference line `[rad]`.
    #[inline]
    pub(crate) fn heading_of_reference_line(&self, lane: &Lane<'_>) -> f64 {
        let heading =
            |piece: &GeometryPiece<'_>| normalize_angle(piece.curve.heading(self.at.s - piece.s));
        if CurveKind::from_code(self.geometry.kind()) == Some(CurveKind::Line) {
            // As a curve adds what it has turned: −0 becomes 0.
            return normalize_angle(self.geometry.hdg() + 0.0);
        }
        // Most others are arcs, of which it is told for less.
        match lane.road.simple_piece(self.geometry) {
            Some(piece) => heading(&piece),
            None => lane.road.piece(self.geometry).map_or(0.0, |piece| heading(&piece)),
        }
    }

    #[inline]
    pub(crate) fn position(&self, lane: &Lane<'_>) -> LanePosition {
        let (line, elevation) =
            (self.heading_of_reference_line(lane), lane.road.elevation(self.at));
        self.position_with(lane, line, elevation)
    }

    /// As [`Self::position`], where the heading and height of the reference line are known.
    #[inline]
    pub(crate) fn position_with(&self, lane: &Lane<'_>, line: f64, elevation: f64) -> LanePosition {
        let (s, start, end) = (self.at.s, lane.section.s_start(), lane.section.s_end());
        let clamped = match self.is_beyond {
            true if s <= start => Clamped::Before,
            true if s >= end => Clamped::After,
            _ => Clamped::No,
        };
        let forward = lane.is_forward();
        LanePosition {
            s,
            t: self.t,
            offset: if forward { self.offset } else { -self.offset },
            offset_of_reference_line: self.offset,
            distance: self.distance,
            z: elevation + self.t * self.roll_sin,
            heading: self.driven_heading(lane, line),
            heading_of_reference_line: line,
            clamped,
        }
    }
}

/// The place of a point that a slab holds, or misses by no more than rounding; `local` is relative to the map's origin, `cross`
/// is the lane or what was made ready of it.
#[inline(always)]
pub(crate) fn place_inside<'a>(
    lane: &Lane<'a>,
    cross: &impl Cross,
    slab: &Slab<'a>,
    local: DVec2,
) -> Option<SlabPosition<'a>> {
    let piece = &slab.piece;
    let [u, lateral] = piece.curve.beside(
        local.x,
        local.y,
        slab.middle() - piece.s,
        slab.s_lo - piece.s,
        slab.s_hi - piece.s,
    )?;
    let across = LateralPlace::new(cross, slab, u, lateral);
    let [low, high] = across.sides();
    if !(across.t - high <= EDGE && low - across.t <= EDGE) {
        return None;
    }
    let beside = across.is_beside();
    let distance = if beside { across.border_distance(lane, slab, local) } else { 0.0 };
    Some(SlabPosition::new(slab.geometry, &across, distance, false))
}

/// The place of a point whose only foot on the reference line along a lane is known by its geometry, s and lateral offset: `Some(None)` if
/// the lane does not hold it. None where rounding decides, or a record begins within `margin` `[m]` of the foot.
#[inline]
pub(crate) fn place_at_foot<'a>(
    lane: &Lane<'a>,
    geometry: &'a ArchivedGeometryRow,
    [s, lateral]: [f64; 2],
    margin: f64,
) -> Option<Option<SlabPosition<'a>>> {
    let roll = profile::roll(profile::apart(lane.road.superelevations(), s, margin)?);
    let (edges, is_steady) = lane.edges_apart(s, margin)?;
    let across = LateralPlace { at: At::new(s), roll, t: lateral / roll.0, edges, is_steady };
    if !across.is_beside() {
        return Some(Some(SlabPosition::new(geometry, &across, 0.0, false)));
    }
    let [low, high] = across.sides();
    (across.t - high > EDGE || low - across.t > EDGE).then_some(None)
}

/// The place of a point with respect to one slab, wherever the point is; `local` is relative to the map's origin.
// Without a call, since `lanes_near` asks for every lane within its radius.
#[inline(always)]
pub(crate) fn place<'a>(lane: &Lane<'a>, slab: &Slab<'a>, local: DVec2) -> SlabPosition<'a> {
    let (curve, s) = (&slab.piece.curve, slab.piece.s);
    let (first, last) = (slab.s_lo - s, slab.s_hi - s);
    // Most points lie beside the slab. Of a line or an arc that is told for less.
    let (u, lateral, beyond) = match curve.closed_foot(local.x, local.y, first, last) {
        Some([u, lateral]) => (u, lateral, None),
        None => {
            let foot = curve.project_from(local.x, local.y, slab.middle() - s, first, last);
            (foot.u, foot.lateral, foot.clamped.then_some(foot))
        }
    };
    let across = LateralPlace::new(lane, slab, u, lateral);
    let beside = across.is_beside();
    let mut distance = f64::INFINITY;
    if let Some(foot) = &beyond {
        let [low, high] = across.sides().map(|t| t * across.roll.0);
        let (tangent, normal) = (DVec2::new(foot.cos, foot.sin), DVec2::new(-foot.sin, foot.cos));
        let away = local - DVec2::new(foot.x, foot.y);
        let sideways = away.dot(normal);
        let past = sideways - clamp(sideways, low, high);
        distance = mapd_geometry::hypot(away.dot(tangent), past);
    } else if !beside {
        distance = 0.0;
    }
    if beside {
        distance = distance.min(across.border_distance(lane, slab, local));
    }
    let place = SlabPosition::new(slab.geometry, &across, distance, beyond.is_some());
    // Of a line or an arc it is told for less that none of its cross-sections cross.
    let may_fold = |curvature: f64| folds::may_reach(curvature, across.sides());
    if curve.even_curvature_up_to(last).is_none_or(may_fold) && distance > 0.0 {
        return folds::place(lane, slab, local, place);
    }
    place
}

/// As [`place`], by a call: only the search for the nearest lanes, which asks of most slabs, does without.
#[inline(never)]
pub(crate) fn place_by_call<'a>(
    lane: &Lane<'a>,
    slab: &Slab<'a>,
    local: DVec2,
) -> SlabPosition<'a> {
    place(lane, slab, local)
}

/// One border of a lane within a slab, as seen from a point.
struct Border<'a, 'm> {
    lane: &'a Lane<'m>,
    slab: &'a Slab<'m>,
    local: DVec2,
    outer: bool,
}

/// A place on a border: distance, step towards the point's foot, and how much nearer than its centre of curvature the
/// point lies (1 on the border, 0 at the centre, negative beyond).
struct Approach {
    distance: f64,
    step: f64,
    contraction: f64,
}

impl Border<'_, '_> {
    #[inline(never)]
    fn at(&self, s: f64) -> Approach {
        let (at, piece) = (self.slab.at(s), &self.slab.piece);
        let point = piece.curve.tangent(s - piece.s);
        let [speed, curvature] = piece.curve.speed_and_curvature(s - piece.s);
        let slopes = self.lane.edge_slopes(at);
        let edge = if self.outer { slopes.outer } else { slopes.inner };
        let roll = self.lane.road.roll(at);
        let [ahead, left] = Beside::new(&self.lane.road, at, roll, edge).run([speed, curvature]);
        let lateral = edge.value * roll.0;
        let (tangent, normal) =
            (DVec2::new(point.cos, point.sin), DVec2::new(-point.sin, point.cos));
        let away = self.local - (DVec2::new(point.x, point.y) + normal * lateral);
        let stretch = 1.0 - curvature * lateral;
        let derivative = tangent * ahead + normal * left;
        // Curvature of the border, its own change of t left out: it only shapes the step.
        let curvature = if stretch.abs() > f64::EPSILON { curvature / stretch } else { 0.0 };
        let contraction = 1.0 - curvature * away.dot(normal);
        let squared = derivative.length_squared() * contraction.max(MIN_CONTRACTION);
        let step = if squared == 0.0 { 0.0 } else { away.dot(derivative) / squared };
        Approach { distance: away.length(), step, contraction }
    }

    /// Distance by Newton's method, with the growth of the step where one before tells it; every step is a point of the border, so the smallest
    /// distance seen is an upper bound whatever happens.
    fn distance(&self, seed: f64) -> f64 {
        let (mut s, mut best) = (seed, f64::INFINITY);
        let mut before: Option<(f64, f64)> = None;
        let mut is_foot = false;
        for _ in 0..BORDER_ITERATIONS {
            let found = self.at(s);
            best = best.min(found.distance);
            if found.contraction < MIN_CONTRACTION {
                // Near or beyond the centre of curvature the nearest place may be anywhere, the ends included.
                break;
            }
            // Newton's step knows no change of the border's t: by it the foot may be nearer or farther.
            let growth =
                before.map_or(-1.0, |(s_before, step)| (found.step - step) / (s - s_before));
            let step = if growth < -MIN_CONTRACTION { found.step / -growth } else { found.step };
            let next = clamp(s + step, self.slab.s_lo, self.slab.s_hi);
            let moved = (next - s).abs();
            if moved <= BORDER_STEP || !moved.is_finite() {
                is_foot = true;
                break;
            }
            before = Some((s, found.step));
            s = next;
        }
        if is_foot && !self.swings(best) { best } else { best.min(self.search()) }
    }

    /// Whether the border's t bends so much within the slab that from so far away there may be several nearest places.
    fn swings(&self, distance: f64) -> bool {
        // Mostly it does not bend at all, which is cheaper to tell.
        if self.lane.even_outer(self.slab.at(self.slab.s_lo), self.slab.s_hi).is_some() {
            return false;
        }
        if self.corner(self.slab.s_lo) < self.slab.s_hi {
            return true;
        }
        let slopes = [self.slab.s_lo, self.slab.middle(), self.slab.s_hi].map(|s| {
            let slopes = self.lane.edge_slopes(self.slab.at(s));
            if self.outer { slopes.outer.derivative } else { slopes.inner.derivative }
        });
        let swing = slopes.iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b))
            - slopes.iter().fold(f64::INFINITY, |a, b| a.min(*b));
        swing * distance > MAX_SWING * (self.slab.s_hi - self.slab.s_lo)
    }

    /// The first place behind an s where a width closes or opens between records, so that the border has a corner; else the slab's end.
    // There once: two ask.
    #[inline(never)]
    fn corner(&self, from: f64) -> f64 {
        let (at, cubics) = (self.slab.at(from), self.lane.map.tables().cubics);
        let mut to = self.slab.s_hi;
        self.lane.walk_outwards(|lane| {
            if lane.flags() & lane_flags::BORDER == 0 {
                to = profile::corner(lane.widths().of(cubics), at, from, to).unwrap_or(to);
            }
        });
        to
    }

    /// Distance by looking everywhere between corners.
    #[inline(never)]
    fn search(&self) -> f64 {
        let (mut best, mut from, end) = (f64::INFINITY, self.slab.s_lo, self.slab.s_hi);
        for corners in 0..=MOST_CORNERS {
            let to = if corners < MOST_CORNERS { self.corner(from) } else { end };
            best = best.min(self.search_between(from, to));
            if to >= end {
                break;
            }
            from = to;
        }
        best
    }

    /// Distance by looking everywhere between two places, then more closely wherever it falls and rises again. At a corner it may do either.
    fn search_between(&self, from: f64, to: f64) -> f64 {
        let part = (to - from) / SEARCH_PARTS as f64;
        let mut best = f64::INFINITY;
        let mut before: Option<(f64, bool)> = None;
        for i in 0..=SEARCH_PARTS {
            let s = if i == SEARCH_PARTS { to } else { from + part * i as f64 };
            let found = self.at(s);
            best = best.min(found.distance);
            let rises = found.step < 0.0 || (i == SEARCH_PARTS && to < self.slab.s_hi);
            if let Some((low, true)) = before
                && rises
            {
                best = best.min(self.between(low, s));
            }
            before = Some((s, found.step > 0.0 || (i == 0 && from > self.slab.s_lo)));
        }
        best
    }

    /// Distance from the foot between two places of which the first lies before it and the second behind.
    fn between(&self, mut low: f64, mut high: f64) -> f64 {
        let mut best = f64::INFINITY;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let found = self.at(middle);
            best = best.min(found.distance);
            *if found.step > 0.0 { &mut low } else { &mut high } = middle;
        }
        best
    }
}
