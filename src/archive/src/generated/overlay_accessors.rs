//! Reading the rows of an overlay.
// Written by `cargo run -p mapd-schemas` from schemas/overlay.toml; change that file instead.

use super::overlay_rows::*;
use crate::table::Range;

impl ArchivedOverlayRow {
    /// `[s]` By how much raised speeds shorten all nodes together: no way is faster by more.
    #[inline]
    pub fn time_saved(&self) -> f64 {
        self.time_saved.to_native()
    }
    /// Smallest quotient of a piece's time with a raised speed and without; 1 where none is raised.
    #[inline]
    pub fn time_factor(&self) -> f64 {
        self.time_factor.to_native()
    }
    /// 1 if a lane is opened that no motor vehicle may use otherwise: bounds from landmarks do not hold.
    #[inline]
    pub fn opens(&self) -> u32 {
        self.opens.to_native()
    }
}

impl ArchivedOverlayEntryRow {
    /// `[s]` From when on it holds, since the Unix epoch, UTC; the lowest number where it always has.
    #[inline]
    pub fn from(&self) -> f64 {
        self.from.to_native()
    }
    /// `[s]` Until when it holds, this moment not included; the highest number where it does until it is removed.
    #[inline]
    pub fn until(&self) -> f64 {
        self.until.to_native()
    }
    /// `[m/s]` Of a speed, the limit; else 0.
    #[inline]
    pub fn value(&self) -> f64 {
        self.value.to_native()
    }
    /// Times of the week at which it holds; empty: at all.
    #[inline]
    pub fn weekly(&self) -> Range {
        self.weekly.to_native()
    }
    /// Its name, which no other entry has.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// Who says so.
    #[inline]
    pub fn source(&self) -> u32 {
        self.source.to_native()
    }
    /// What is said, for people.
    #[inline]
    pub fn text(&self) -> u32 {
        self.text.to_native()
    }
    /// How sure the source is, from 0 to 1.
    #[inline]
    pub fn confidence(&self) -> f32 {
        self.confidence.to_native()
    }
    /// Bit i: vehicle class i is concerned.
    #[inline]
    pub fn vehicles(&self) -> u16 {
        self.vehicles.to_native()
    }
    /// 0 closed, 1 open, 2 speed, 3 no overtaking, 4 wet, 5 icy, 6 signal out of service, 7 warning, 8 snow, 9 rough.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
}

impl ArchivedWeeklyRow {
    /// `[s]` Begin, since Monday 00:00 UTC.
    #[inline]
    pub fn from(&self) -> u32 {
        self.from.to_native()
    }
    /// `[s]` End, not included; at most 604800.
    #[inline]
    pub fn until(&self) -> u32 {
        self.until.to_native()
    }
}

impl ArchivedTouchedRow {
    /// Bit i: node 64·row + i.
    #[inline]
    pub fn bits(&self) -> u64 {
        self.bits.to_native()
    }
    /// Number of bits in the rows before: where in `nodes` the first of them lies.
    #[inline]
    pub fn rank(&self) -> u32 {
        self.rank.to_native()
    }
}

impl ArchivedOverlayNodeRow {
    /// Row of the map's `lane_nodes`.
    #[inline]
    pub fn node(&self) -> u32 {
        self.node.to_native()
    }
    /// Its pieces in driving order, at least one. Nodes beside each other are cut at the same places.
    #[inline]
    pub fn pieces(&self) -> Range {
        self.pieces.to_native()
    }
}

impl ArchivedPieceRow {
    /// `[m]` Smaller end on the road.
    #[inline]
    pub fn s_from(&self) -> f64 {
        self.s_from.to_native()
    }
    /// `[m]` Larger end on the road.
    #[inline]
    pub fn s_to(&self) -> f64 {
        self.s_to.to_native()
    }
    /// Whose piece it is.
    #[inline]
    pub fn node(&self) -> u32 {
        self.node.to_native()
    }
    /// What holds.
    #[inline]
    pub fn entries(&self) -> Range {
        self.entries.to_native()
    }
    /// Share of the node's length that lies before it.
    #[inline]
    pub fn before(&self) -> f32 {
        self.before.to_native()
    }
    /// `[m]` Length of the centre line in plan view.
    #[inline]
    pub fn length(&self) -> f32 {
        self.length.to_native()
    }
    /// `[s]` What a route by time counts for it without the entries.
    #[inline]
    pub fn time(&self) -> f32 {
        self.time.to_native()
    }
}

impl ArchivedSignalEntryRow {
    /// Row of the map's `signals`.
    #[inline]
    pub fn signal(&self) -> u32 {
        self.signal.to_native()
    }
    /// What holds.
    #[inline]
    pub fn entry(&self) -> u32 {
        self.entry.to_native()
    }
}

impl ArchivedCutsRow {
    /// `[m]` By how much such changes shorten all ways together: no way is shorter by more.
    #[inline]
    pub fn length_saved(&self) -> f64 {
        self.length_saved.to_native()
    }
    /// Of nodes that are cut and joined by changes of lane, the smallest quotient of what is left at least, the shortest of each piece, and the longest node; at most 1.
    #[inline]
    pub fn length_factor(&self) -> f64 {
        self.length_factor.to_native()
    }
    /// `[s]` As `length_saved`, of the times that the map's graph counts.
    #[inline]
    pub fn time_saved(&self) -> f64 {
        self.time_saved.to_native()
    }
    /// As `length_factor`, of times.
    #[inline]
    pub fn time_factor(&self) -> f64 {
        self.time_factor.to_native()
    }
}
