//! A road cut across: what all lanes at one s have in common.

use crate::line_stretch::{LineStretch, ValidRange};
use crate::parallel::Parallel;
use crate::profile::{self, At, Record};
use crate::road::Road;
use crate::section::LaneSection;
use crate::types::LaneEdges;
use glam::DVec3;
use mapd_archive::{ArchivedLaneRow, lane_flags};
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
    offset: Record,
    /// From the centre lane outwards.
    left: Vec<Width>,
    right: Vec<Width>,
}

/// Width or border of one lane.
#[derive(Clone, Copy)]
struct Width {
    record: Record,
    /// Where the record holds.
    held: ValidRange,
    is_border: bool,
    /// The lane's edges, where neither they nor those of the lanes further in change while the records hold.
    steady: Option<LaneEdges>,
}

impl Width {
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
        let (left, right) = edges.split_at_mut_checked(widths.left.len())?;
        let (center, right) = right.split_first_mut()?;
        *center = LaneEdges { inner: offset, outer: offset };
        let mut edge = offset;
        for (width, edges) in widths.left.iter().zip(left.iter_mut().rev()) {
            *edges = width.step(&mut edge, s, 1.0);
        }
        edge = offset;
        for (width, edges) in widths.right.iter().zip(right) {
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
        let (inward, sign) = widths.outwards_to(lane)?;
        if let Some(Width { steady: Some(edges), .. }) = inward.last() {
            return Some(*edges);
        }
        let s = on_line;
        let offset = widths.offset.value(s);
        let none = LaneEdges { inner: offset, outer: offset };
        let mut edge = offset;
        Some(inward.iter().fold(none, |_, width| width.step(&mut edge, s, sign)))
    }

    /// A section may end a rounding beyond the reference line: edges are those of the line's end, as with a single lane.
    #[inline]
    fn on_line(&self, s: f64) -> f64 {
        if s > self.end { self.end } else { s }
    }

    /// What the lanes are made of at s.
    #[inline]
    fn widths(&mut self, s: f64) -> Option<&Widths> {
        let at = At::within(s, self.section.s_start(), self.section.s_end());
        self.widths_held(at.hold)
    }

    /// What the lanes are made of where this holds.
    #[inline]
    fn widths_held(&mut self, hold: f64) -> Option<&Widths> {
        if !self.lanes.as_ref().is_some_and(|lanes| lanes.held.contains(hold)) {
            self.find_widths(hold)?;
        }
        self.lanes.as_ref()
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
        let (inner, _) = widths.outwards_to(lane)?;
        let is_constant = widths.held.covers(from, to)
            && widths.offset.is_constant()
            && inner.iter().all(|width| width.record.is_constant());
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
        let (inner, _) = widths.outwards_to(lane)?;
        let is_even = |width: &Width| {
            let is_open = |s: f64| width.is_border || width.record.value(s) >= 0.0;
            width.record.is_even() && is_open(from) && is_open(to)
        };
        let held = widths.held.covers(from, to);
        Some(held && widths.offset.is_even() && inner.iter().all(is_even))
    }
}

impl Widths {
    /// A lane, counted from the left, and those between it and the centre lane, from there outwards, with the sign of t on
    /// their side.
    #[inline]
    fn outwards_to(&self, lane: usize) -> Option<(&[Width], f64)> {
        let center = self.left.len();
        if lane < center {
            Some((self.left.get(..center - lane)?, 1.0))
        } else {
            Some((self.right.get(..lane - center)?, -1.0))
        }
    }

    /// None for a section without a centre lane.
    fn at(road: &Road<'_>, section: &LaneSection<'_>, hold: f64) -> Option<Self> {
        let lanes = section.rows();
        let center = lanes.binary_search_by(|lane| 0.cmp(&lane.number())).ok()?;
        let cubics = section.map.tables().cubics;
        let width = |lane: &ArchivedLaneRow| {
            let mut held = ValidRange::ALWAYS;
            let record = Record::of(held.record(lane.widths().of(cubics), hold));
            let is_border = lane.flags() & lane_flags::BORDER != 0;
            Width { record, held, is_border, steady: None }
        };
        let left = lanes.get(..center)?.iter().rev().map(width).collect();
        let right = lanes.get(center + 1..)?.iter().map(width).collect();
        let mut widths = Self { held: ValidRange::ALWAYS, offset: Record::NONE, left, right };
        widths.settle(road, section, hold)?;
        Some(widths)
    }

    /// What holds at another place: mostly the next record of one lane, so that those of the others need not be looked for.
    fn move_to(&mut self, road: &Road<'_>, section: &LaneSection<'_>, hold: f64) -> Option<()> {
        let (lanes, cubics) = (section.rows(), section.map.tables().cubics);
        let (left, right) = lanes.split_at_checked(self.left.len())?;
        let left = self.left.iter_mut().rev().zip(left);
        for (width, lane) in left.chain(self.right.iter_mut().zip(right.get(1..)?)) {
            width.steady = None;
            if !width.held.contains(hold) {
                width.held = ValidRange::ALWAYS;
                width.record = Record::of(width.held.record(lane.widths().of(cubics), hold));
            }
        }
        self.settle(road, section, hold)
    }

    /// What follows from the widths that hold at a place.
    fn settle(&mut self, road: &Road<'_>, section: &LaneSection<'_>, hold: f64) -> Option<()> {
        let is_temporary = section.rows().first()?.flags() & lane_flags::TEMPORARY != 0;
        let offsets =
            if is_temporary { road.temporary_lane_offsets() } else { road.lane_offsets() };
        let mut held = ValidRange::ALWAYS;
        self.offset = Record::of(held.record(offsets, hold));
        self.held =
            self.left.iter().chain(&self.right).fold(held, |held, width| held.and(width.held));
        find_steady(&self.offset, &mut self.left, hold, 1.0);
        find_steady(&self.offset, &mut self.right, hold, -1.0);
        Some(())
    }
}

/// Notes the edges of lanes, from the centre lane outwards, that do not change while their records hold, as at `hold`.
fn find_steady(offset: &Record, lanes: &mut [Width], hold: f64, sign: f64) {
    if !offset.is_constant() {
        return;
    }
    let mut edge = offset.value(hold);
    for lane in lanes.iter_mut().take_while(|lane| lane.record.is_constant()) {
        lane.steady = Some(lane.step(&mut edge, hold, sign));
    }
}
