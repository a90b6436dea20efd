//! Cross-sections of a lane section, kept for a while.

use glam::DVec3;
use mapd_query::{CrossSection, LaneEdges, LaneSection, SectionCutter};

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
    cuts: Vec<Cut>,
    /// Edges of all lanes of the section, cut by cut.
    edges: Vec<LaneEdges>,
    /// Sections so far.
    sections: u64,
}

impl Memory {
    pub(crate) fn new() -> Self {
        Self { cuts: vec![Cut::default(); KEPT], edges: Vec::new(), sections: 0 }
    }
}

/// Cuts one section; a place that was asked for lately is not computed again.
pub(crate) struct Cuts<'m, 'a> {
    memory: &'m mut Memory,
    cutter: SectionCutter<'a>,
    lanes: usize,
}

impl<'m, 'a> Cuts<'m, 'a> {
    /// None where the section cannot be cut.
    pub(crate) fn new(section: LaneSection<'a>, memory: &'m mut Memory) -> Option<Self> {
        let lanes = section.lanes().count();
        memory.sections += 1;
        let room = KEPT * lanes;
        if memory.edges.len() < room {
            memory.edges.resize(room, LaneEdges { inner: 0.0, outer: 0.0 });
        }
        Some(Self { memory, cutter: SectionCutter::new(section)?, lanes })
    }

    /// A place of a lane, counted from the left, at s, relative to the local origin; `t` chooses between its edges.
    #[inline]
    pub(crate) fn place(
        &mut self,
        lane: usize,
        s: f64,
        t: impl Fn(LaneEdges) -> f64,
    ) -> Option<DVec3> {
        let bits = s.to_bits();
        let slot = (bits.wrapping_mul(SPREAD) >> (64 - KEPT.trailing_zeros())) as usize;
        let cut = self.memory.cuts.get_mut(slot)?;
        let edges = self.memory.edges.get_mut(slot * self.lanes..(slot + 1) * self.lanes)?;
        if (cut.s, cut.section) != (bits, self.memory.sections) {
            // Marked first: what fails is not found again.
            cut.section = 0;
            cut.frame = self.cutter.cut(s)?;
            self.cutter.edges(s, edges)?;
            (cut.s, cut.section) = (bits, self.memory.sections);
        }
        Some(cut.frame.place(t(*edges.get(lane)?)))
    }

    /// Whether a lane's edges are straight from one s up to another.
    pub(crate) fn is_straight(&mut self, lane: usize, from: f64, to: f64) -> bool {
        self.cutter.is_straight(lane, from, to)
    }
}
