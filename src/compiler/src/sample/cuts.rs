//! Cross-sections of a lane section, kept for a while.

use glam::DVec3;
use mapd_query::compiling::{Parallel, SectionCutter};
use mapd_query::roads::CrossSection;
use mapd_query::{LaneEdges, LaneSection};

/// Cross-sections that are kept. Lanes of a section are sampled at the same places, a stretch of one at a few dozen; a long
/// one in a curve at some hundred.
const KEPT: usize = 512;
/// Multiplier that spreads the bits of a number over the upper ones (2⁶⁴ divided by the golden ratio).
const SPREAD: u64 = 0x9e37_79b9_7f4a_7c15;

/// A cross-section with the s that it is at, and the section that it is of, by number; 0 stands for none.
#[derive(Clone, Copy, Default)]
struct Cut {
    s: u64,
    section: u64,
    frame: CrossSection,
}

/// Memory of cross-sections, for one section after the other.
pub(crate) struct Memory {
    cuts: Box<[Cut; KEPT]>,
    /// Sections so far.
    sections: u64,
}

impl Memory {
    pub(crate) fn new() -> Self {
        Self { cuts: Box::new([Cut::default(); KEPT]), sections: 0 }
    }
}

/// Cuts one section; the frame at a place that was asked for lately is not computed again. Edges are: a few cubics take less
/// than keeping those of all lanes, most of which nobody asks for at the same place.
pub(crate) struct Cuts<'m, 'a> {
    memory: &'m mut Memory,
    cutter: SectionCutter<'a>,
}

impl<'m, 'a> Cuts<'m, 'a> {
    /// None where the section cannot be cut.
    pub(crate) fn new(section: LaneSection<'a>, memory: &'m mut Memory) -> Option<Self> {
        memory.sections += 1;
        Some(Self { memory, cutter: SectionCutter::new(section)? })
    }

    /// A place of a lane, counted from the left, at s, relative to the local origin; `t` chooses between its edges.
    // There once for all that sample: it is long.
    #[inline(never)]
    pub(crate) fn place(
        &mut self,
        lane: usize,
        s: f64,
        t: impl Fn(LaneEdges) -> f64,
    ) -> Option<DVec3> {
        let bits = s.to_bits();
        let slot = (bits.wrapping_mul(SPREAD) >> (u64::BITS - KEPT.trailing_zeros())) as usize;
        let cut = &self.memory.cuts[slot];
        if (cut.s, cut.section) != (bits, self.memory.sections) {
            self.cut(slot, s)?;
        }
        let t = t(self.cutter.lane_edges(lane, s)?);
        Some(self.memory.cuts[slot].frame.place(t))
    }

    /// Keeps the cross-section at s.
    #[inline(never)]
    fn cut(&mut self, slot: usize, s: f64) -> Option<()> {
        let frame = self.cutter.cut(s)?;
        self.memory.cuts[slot] = Cut { s: s.to_bits(), section: self.memory.sections, frame };
        Some(())
    }

    /// Whether a lane's edges are straight from one s up to another.
    pub(crate) fn is_straight(&mut self, lane: usize, from: f64, to: f64) -> bool {
        self.cutter.is_straight(lane, from, to)
    }

    /// A line that runs beside the reference line at an even distance, as far as that is known; `t` chooses between the lane's edges.
    pub(crate) fn parallel(
        &mut self,
        lane: usize,
        ends: [f64; 2],
        t: impl Fn(LaneEdges) -> f64,
    ) -> Option<Parallel<'a>> {
        self.cutter.parallel(lane, ends, t)
    }

    /// Curvature of the reference line where a lane's edges are known to be arcs from one s up to another.
    pub(crate) fn arc(&mut self, lane: usize, from: f64, to: f64) -> Option<f64> {
        self.cutter.arc(lane, from, to)
    }
}
