//! A road cut across: what all lanes at one s have in common.

use crate::line_stretch::{LineStretch, ValidRange};
use crate::parallel::Parallel;
use crate::profile::{self, At, Record};
use crate::road::Road;
use crate::section::LaneSection;
use crate::types::LaneEdges;
use glam::DVec3;
use mapd_archive::{ArchivedCubicRow, ArchivedLaneRow, lane_flags};
use mapd_geometry::clamp;

/// The plane h = 0 of a road at one s: places beside each other differ by t alone (OpenDRIVE 1.8.1, 8.3).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CrossSection {
    x: f64,
    y: f64,
    z: f64,
    cos: f64,
    sin: f64,
    roll_cos: f64,
    roll_sin: f64,
}

impl CrossSection {
    /// The place at t `[m]`, relative to the map's local origin.
    #[inline]
    pub fn place(&self, t: f64) -> DVec3 {
        let lateral = t * self.roll_cos;
        DVec3::new(
            self.x - self.sin * lateral,
            self.y + self.cos * lateral,
            self.z + t * self.roll_sin,
        )
    }
}

impl Road<'_> {
    /// The road cut across at s `[m]`, which is moved to the reference line's end where it lies beyond. None for an s that is
    /// not finite and for a damaged archive.
    pub fn cross_section(&self, s: f64) -> Option<CrossSection> {
        if !s.is_finite() {
            return None;
        }
        let at = At::new(clamp(s, 0.0, self.reference_end().max(0.0)));
        let piece = self.piece_at(at)?;
        let point = piece.curve.tangent(at.s - piece.s);
        let (roll_cos, roll_sin) = self.roll(at);
        let (x, y, z) = (point.x, point.y, self.elevation(at));
        Some(CrossSection { x, y, z, cos: point.cos, sin: point.sin, roll_cos, roll_sin })
    }
}

/// Cuts the road across within one lane section, at many places: it looks up the records that hold once for all places
/// where they do. Allocates for each section, not for each place.
pub struct SectionCutter<'a> {
    road: Road<'a>,
    section: LaneSection<'a>,
    /// Where the reference line ends.
    end: f64,
    frame: Option<LineStretch<'a>>,
    lanes: Option<Widths>,
}

/// What the lanes are made of for a while.
struct Widths {
    held: ValidRange,
    /// Where the widths alone hold.
    widths_held: ValidRange,
    offset: Record,
    /// A place where all of it holds.
    hold: f64,
    left: Side,
    right: Side,
}

/// The lanes on one side.
struct Side {
    /// From the centre lane outwards.
    widths: Vec<Width>,
    /// That of t.
    sign: f64,
    steady: Steady,
}

/// A lane of which neither its edges nor those of lanes further in change while the records hold: the last one that was asked for.
#[derive(Clone, Copy)]
struct Steady {
    /// How many lanes lie from the centre lane outwards up to it; 0 where none was asked for.
    count: usize,
    edges: LaneEdges,
    /// Whether neither it nor a lane further in has a width below 0.
    are_open: bool,
}

impl Steady {
    const NONE: Self = Self { count: 0, edges: LaneEdges::NOWHERE, are_open: false };
}

/// Width or border of one lane.
#[derive(Clone, Copy)]
struct Width {
    record: Record,
    /// Where the record holds.
    held: ValidRange,
    is_border: bool,
    /// What the record says all along; none where it changes.
    constant: Option<f64>,
}

impl Width {
    fn at(lane: &ArchivedLaneRow, cubics: &[ArchivedCubicRow], hold: f64) -> Self {
        let mut held = ValidRange::ALWAYS;
        let record = Record::of(held.record(lane.widths().of(cubics), hold));
        let is_border = lane.flags() & lane_flags::BORDER != 0;
        let constant = record.is_constant().then(|| record.value(hold));
        Self { record, held, is_border, constant }
    }

    /// The lane's edges; the next one's inner edge is its outer one.
    #[inline]
    fn step(&self, edge: &mut f64, s: f64, sign: f64) -> LaneEdges {
        let (inner, record) = (*edge, self.record.value(s));
        // As with a single lane: whatever is no positive number counts as no width.
        let width = if record > 0.0 { record } else { 0.0 };
        *edge = if self.is_border { record } else { inner + sign * width };
        LaneEdges { inner, outer: *edge }
    }
}

impl<'a> SectionCutter<'a> {
    /// None for a damaged archive.
    pub fn new(section: LaneSection<'a>) -> Option<Self> {
        let road = section.road()?;
        let end = road.reference_end().max(0.0);
        Some(Self { road, section, end, frame: None, lanes: None })
    }

    /// As [`Road::cross_section`].
    // Always: what it yields is written where the caller keeps it.
    #[inline(always)]
    pub fn cut(&mut self, s: f64) -> Option<CrossSection> {
        let s = self.stretch_at(s)?;
        let frame = self.frame.as_ref()?;
        let point = frame.piece.curve.tangent(s - frame.piece.s);
        let (roll_cos, roll_sin) = profile::roll(frame.superelevation.value(s));
        let (x, y, z) = (point.x, point.y, frame.elevation.value(s));
        Some(CrossSection { x, y, z, cos: point.cos, sin: point.sin, roll_cos, roll_sin })
    }

    /// Looks up what the reference line is made of at s, which is moved as [`Road::cross_section`] does.
    #[inline]
    fn stretch_at(&mut self, s: f64) -> Option<f64> {
        if !s.is_finite() {
            return None;
        }
        let s = clamp(s, 0.0, self.end);
        if !self.frame.as_ref().is_some_and(|frame| frame.held.contains(s)) {
            self.find_stretch(s)?;
        }
        Some(s)
    }

    // Apart, so that the many places where the same holds save no registers for it.
    #[inline(never)]
    fn find_stretch(&mut self, s: f64) -> Option<()> {
        self.frame = Some(LineStretch::at(&self.road, s)?);
        Some(())
    }

    /// Edges at s of all lanes, from left to right, as [`crate::Lane::edges_at`] has them one by one. `edges` has a place
    /// for each lane. None for a damaged archive, and for a section without a centre lane.
    pub fn edges(&mut self, s: f64, edges: &mut [LaneEdges]) -> Option<()> {
        let on_line = self.on_line(s);
        let widths = self.widths(s)?;
        let s = on_line;
        let offset = widths.offset.value(s);
        let (left, right) = edges.split_at_mut_checked(widths.left.widths.len())?;
        let (center, right) = right.split_first_mut()?;
        *center = LaneEdges { inner: offset, outer: offset };
        let mut edge = offset;
        for (width, edges) in widths.left.widths.iter().zip(left.iter_mut().rev()) {
            *edges = width.step(&mut edge, s, 1.0);
        }
        edge = offset;
        for (width, edges) in widths.right.widths.iter().zip(right) {
            *edges = width.step(&mut edge, s, -1.0);
        }
        Some(())
    }

    /// Edges at s of one lane, counted from the left, the same as [`Self::edges`] gives. None for a damaged archive, for a
    /// section without a centre lane, and for a lane that it does not have.
    // Always: of both edges, most callers need one number.
    #[inline(always)]
    pub fn lane_edges(&mut self, lane: usize, s: f64) -> Option<LaneEdges> {
        let on_line = self.on_line(s);
        let widths = self.widths(s)?;
        let (offset, hold, side, count) = widths.outwards_to(lane);
        if let Some(steady) = side.steady(offset, count, hold) {
            return Some(steady.edges);
        }
        let (s, inward) = (on_line, side.widths.get(..count)?);
        let offset = offset.value(s);
        let none = LaneEdges { inner: offset, outer: offset };
        let mut edge = offset;
        Some(inward.iter().fold(none, |_, width| width.step(&mut edge, s, side.sign)))
    }

    /// A section may end a rounding beyond the reference line: edges are those of the line's end, as with a single lane.
    #[inline]
    fn on_line(&self, s: f64) -> f64 {
        if s > self.end { self.end } else { s }
    }

    /// What the lanes are made of at s.
    #[inline]
    fn widths(&mut self, s: f64) -> Option<&mut Widths> {
        let at = At::within(s, self.section.s_start(), self.section.s_end());
        self.widths_held(at.hold)
    }

    /// What the lanes are made of where this holds.
    #[inline]
    fn widths_held(&mut self, hold: f64) -> Option<&mut Widths> {
        if !self.lanes.as_ref().is_some_and(|lanes| lanes.held.contains(hold)) {
            self.find_widths(hold)?;
        }
        self.lanes.as_mut()
    }

    // Apart, as with the reference line.
    #[inline(never)]
    fn find_widths(&mut self, hold: f64) -> Option<()> {
        match &mut self.lanes {
            Some(widths) => widths.move_to(&self.road, &self.section, hold)?,
            none => *none = Some(Widths::at(&self.road, &self.section, hold)?),
        }
        Some(())
    }
}

impl<'a> SectionCutter<'a> {
    /// Whether the edges of a lane, counted from the left, are known to be segments from one s up to another: the reference
    /// line is a line, heights and widths grow evenly, and no width falls below 0 in between. False where that is not plain.
    pub fn is_straight(&mut self, lane: usize, from: f64, to: f64) -> bool {
        self.frame_is_straight(from, to) && self.lane_is_straight(lane, from, to).unwrap_or(false)
    }

    /// The curvature `[1/m]` of the reference line where the edges of a lane, counted from the left, are known to be arcs beside
    /// it, or helices, from one s up to another: the reference line is a line or an arc, its height grows evenly, and
    /// superelevation and widths do not change. None where that is not plain.
    pub fn arc(&mut self, lane: usize, from: f64, to: f64) -> Option<f64> {
        let piece = self.even(lane, from, to)?.piece;
        piece.curve.even_curvature_up_to(to - piece.s)
    }

    /// The line at one t beside the reference line, which `t` chooses between the edges of a lane, counted from the left, where that is known to
    /// be even from one s up to another: heights grow evenly, superelevation and widths do not change. None where that is not plain.
    pub fn parallel(
        &mut self,
        lane: usize,
        [from, to]: [f64; 2],
        t: impl Fn(LaneEdges) -> f64,
    ) -> Option<Parallel<'a>> {
        let frame = self.even(lane, from, to)?;
        let (piece, is_level) = (frame.piece, frame.elevation.is_constant());
        let (cos, _) = profile::roll(frame.superelevation.value(from));
        Some(Parallel::new(piece, t(self.lane_edges(lane, from)?) * cos, is_level))
    }

    /// What the reference line is made of from one s up to another, where heights grow evenly and neither superelevation nor the edges of a
    /// lane change.
    fn even(&mut self, lane: usize, from: f64, to: f64) -> Option<&LineStretch<'a>> {
        self.stretch_at(from).filter(|_| to <= self.end)?;
        let widths = self.widths(from)?;
        let held = widths.held.covers(from, to);
        let (offset, hold, side, count) = widths.outwards_to(lane);
        let is_steady = match count {
            0 => offset.is_constant(),
            _ => side.steady(offset, count, hold).is_some(),
        };
        let is_constant = is_steady && held;
        self.frame.as_ref().filter(|frame| {
            is_constant
                && frame.held.covers(from, to)
                && frame.elevation.is_even()
                && frame.superelevation.is_constant()
        })
    }

    fn frame_is_straight(&mut self, from: f64, to: f64) -> bool {
        if to > self.end || self.stretch_at(from).is_none() {
            return false;
        }
        self.frame.as_ref().is_some_and(|frame| {
            frame.held.covers(from, to)
                && frame.piece.curve.is_line_up_to(to - frame.piece.s)
                && frame.elevation.is_even()
                && frame.superelevation.is_zero()
        })
    }

    fn lane_is_straight(&mut self, lane: usize, from: f64, to: f64) -> Option<bool> {
        let widths = self.widths_held(from)?;
        let held = widths.held.covers(from, to);
        let (offset, hold, side, count) = widths.outwards_to(lane);
        if let Some(steady) = side.steady(offset, count, hold) {
            return Some(held && steady.are_open);
        }
        let inner = side.widths.get(..count)?;
        let is_even = |width: &Width| {
            let is_open = |s: f64| width.is_border || width.record.value(s) >= 0.0;
            width.record.is_even() && is_open(from) && is_open(to)
        };
        Some(held && offset.is_even() && inner.iter().all(is_even))
    }
}

impl Side {
    /// The lane that is the `count`-th from the centre lane, if neither its edges nor those further in change while the records hold, as at `hold`.
    #[inline]
    fn steady(&mut self, offset: &Record, count: usize, hold: f64) -> Option<&Steady> {
        if count != self.steady.count {
            self.find_steady(offset, count, hold)?;
        }
        Some(&self.steady).filter(|steady| steady.count > 0)
    }

    // Apart, as with the reference line.
    #[inline(never)]
    fn find_steady(&mut self, offset: &Record, count: usize, hold: f64) -> Option<()> {
        if !offset.is_constant() {
            return None;
        }
        let mut outer = offset.value(hold);
        let (mut inner, mut are_open) = (outer, true);
        for lane in self.widths.get(..count)? {
            let own = lane.constant?;
            inner = outer;
            // As in `Width::step`.
            outer = if lane.is_border {
                own
            } else {
                inner + self.sign * if own > 0.0 { own } else { 0.0 }
            };
            are_open &= lane.is_border || own >= 0.0;
        }
        self.steady = Steady { count, edges: LaneEdges { inner, outer }, are_open };
        Some(())
    }
}

impl Widths {
    /// The record of lane 0 and where all records hold, the side of a lane, counted from the left, and how many lanes lie from the centre lane outwards up to it.
    #[inline]
    fn outwards_to(&mut self, lane: usize) -> (&Record, f64, &mut Side, usize) {
        let (offset, hold, center) = (&self.offset, self.hold, self.left.widths.len());
        match center.checked_sub(lane) {
            Some(count @ 1..) => (offset, hold, &mut self.left, count),
            _ => (offset, hold, &mut self.right, lane - center),
        }
    }

    /// None for a section without a centre lane.
    fn at(road: &Road<'_>, section: &LaneSection<'_>, hold: f64) -> Option<Self> {
        let lanes = section.rows();
        let center = lanes.binary_search_by(|lane| 0.cmp(&lane.number())).ok()?;
        let cubics = section.map.tables().cubics;
        let width = |lane: &ArchivedLaneRow| Width::at(lane, cubics, hold);
        let left = lanes.get(..center)?.iter().rev().map(width).collect();
        let right = lanes.get(center + 1..)?.iter().map(width).collect();
        let [left, right] = [(left, 1.0), (right, -1.0)].map(|(widths, sign)| Side {
            widths,
            sign,
            steady: Steady::NONE,
        });
        let (held, offset) = (ValidRange::ALWAYS, Record::NONE);
        let mut widths = Self { held, widths_held: held, offset, hold, left, right };
        widths.unite();
        widths.settle(road, section, hold)?;
        Some(widths)
    }

    /// What holds at another place: mostly the next record of one lane, so that those of the others need not be looked for.
    fn move_to(&mut self, road: &Road<'_>, section: &LaneSection<'_>, hold: f64) -> Option<()> {
        // Where only another record of lane 0 holds, there may be as many of them as lanes.
        if !self.widths_held.contains(hold) {
            let (lanes, cubics) = (section.rows(), section.map.tables().cubics);
            let (left, right) = lanes.split_at_checked(self.left.widths.len())?;
            let left = self.left.widths.iter_mut().rev().zip(left);
            for (width, lane) in left.chain(self.right.widths.iter_mut().zip(right.get(1..)?)) {
                if !width.held.contains(hold) {
                    *width = Width::at(lane, cubics, hold);
                }
            }
            self.unite();
        }
        self.settle(road, section, hold)
    }

    /// Where all widths hold.
    fn unite(&mut self) {
        let widths = self.left.widths.iter().chain(&self.right.widths);
        self.widths_held = widths.fold(ValidRange::ALWAYS, |held, width| held.and(width.held));
    }

    /// What follows from the widths that hold at a place.
    fn settle(&mut self, road: &Road<'_>, section: &LaneSection<'_>, hold: f64) -> Option<()> {
        let is_temporary = section.rows().first()?.flags() & lane_flags::TEMPORARY != 0;
        let offsets =
            if is_temporary { road.temporary_lane_offsets() } else { road.lane_offsets() };
        let mut held = ValidRange::ALWAYS;
        self.offset = Record::of(held.record(offsets, hold));
        self.held = held.and(self.widths_held);
        self.hold = hold;
        (self.left.steady, self.right.steady) = (Steady::NONE, Steady::NONE);
        Some(())
    }
}
