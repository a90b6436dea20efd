//! Row types of an overlay.
// Written by `cargo run -p mapd-schemas` from schemas/overlay.toml; change that file instead.

use crate::table::Range;
use bytemuck::{Pod, Zeroable};
use rkyv::Archive;

/// Exactly one row: facts about the whole overlay.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct OverlayRow {
    /// `[s]` By how much raised speeds shorten all nodes together: no way is faster by more.
    pub time_saved: f64,
    /// Smallest quotient of a piece's time with a raised speed and without; 1 where none is raised.
    pub time_factor: f64,
    /// 1 if a lane is opened that no motor vehicle may use otherwise: bounds from landmarks do not hold.
    pub opens: u32,
    /// 0.
    pub reserved: u32,
}
const _: () = assert!(size_of::<OverlayRow>() == 24 && size_of::<ArchivedOverlayRow>() == 24);

/// Entries, in the order of the document.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct OverlayEntryRow {
    /// `[s]` From when on it holds, since the Unix epoch, UTC; the lowest number where it always has.
    pub from: f64,
    /// `[s]` Until when it holds, this moment not included; the highest number where it does until it is removed.
    pub until: f64,
    /// `[m/s]` Of a speed, the limit; else 0.
    pub value: f64,
    /// Times of the week at which it holds; empty: at all.
    pub weekly: Range,
    /// Its name, which no other entry has.
    pub id: u32,
    /// Who says so.
    pub source: u32,
    /// What is said, for people.
    pub text: u32,
    /// How sure the source is, from 0 to 1.
    pub confidence: f32,
    /// Bit i: vehicle class i is concerned.
    pub vehicles: u16,
    /// 0 closed, 1 open, 2 speed, 3 no overtaking, 4 wet, 5 icy, 6 signal out of service, 7 warning, 8 snow, 9 rough.
    pub kind: u8,
    /// 0.
    pub reserved: [u8; 5],
}
const _: () =
    assert!(size_of::<OverlayEntryRow>() == 56 && size_of::<ArchivedOverlayEntryRow>() == 56);

/// Times of the week, by entry.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct WeeklyRow {
    /// `[s]` Begin, since Monday 00:00 UTC.
    pub from: u32,
    /// `[s]` End, not included; at most 604800.
    pub until: u32,
}
const _: () = assert!(size_of::<WeeklyRow>() == 8 && size_of::<ArchivedWeeklyRow>() == 8);

/// For each 64 nodes of the map's lane graph, the nodes that have pieces here. Empty if none has.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct TouchedRow {
    /// Bit i: node 64·row + i.
    pub bits: u64,
    /// Number of bits in the rows before: where in `nodes` the first of them lies.
    pub rank: u32,
    /// 0.
    pub reserved: u32,
}
const _: () = assert!(size_of::<TouchedRow>() == 16 && size_of::<ArchivedTouchedRow>() == 16);

/// Nodes of the map's lane graph that have pieces, ascending.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct OverlayNodeRow {
    /// Row of the map's `lane_nodes`.
    pub node: u32,
    /// Its pieces in driving order, at least one. Nodes beside each other are cut at the same places.
    pub pieces: Range,
}
const _: () =
    assert!(size_of::<OverlayNodeRow>() == 12 && size_of::<ArchivedOverlayNodeRow>() == 12);

/// Pieces of nodes. The same entries hold over the whole of a piece.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct PieceRow {
    /// `[m]` Smaller end on the road.
    pub s_from: f64,
    /// `[m]` Larger end on the road.
    pub s_to: f64,
    /// Whose piece it is.
    pub node: u32,
    /// What holds.
    pub entries: Range,
    /// Share of the node's length that lies before it.
    pub before: f32,
    /// `[m]` Length of the centre line in plan view.
    pub length: f32,
    /// `[s]` What a route by time counts for it without the entries.
    pub time: f32,
}
const _: () = assert!(size_of::<PieceRow>() == 40 && size_of::<ArchivedPieceRow>() == 40);

/// Entries about signals, by signal.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SignalEntryRow {
    /// Row of the map's `signals`.
    pub signal: u32,
    /// What holds.
    pub entry: u32,
}
const _: () = assert!(size_of::<SignalEntryRow>() == 8 && size_of::<ArchivedSignalEntryRow>() == 8);

/// At most one row: what cutting nodes does to bounds of the map. A change of lane in the middle of a node leaves a longer one beside it to be driven in part only. Without it there are no bounds if a node is cut.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct CutsRow {
    /// `[m]` By how much such changes shorten all ways together: no way is shorter by more.
    pub length_saved: f64,
    /// Of nodes that are cut and joined by changes of lane, the smallest quotient of what is left at least, the shortest of each piece, and the longest node; at most 1.
    pub length_factor: f64,
    /// `[s]` As `length_saved`, of the times that the map's graph counts.
    pub time_saved: f64,
    /// As `length_factor`, of times.
    pub time_factor: f64,
}
const _: () = assert!(size_of::<CutsRow>() == 32 && size_of::<ArchivedCutsRow>() == 32);
