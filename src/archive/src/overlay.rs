//! Overlays: what is said about a map's lanes today, as a small archive of its own.
//!
//! An overlay has the header and directory of an archive and tables of its own (`schemas/overlay.toml`). A bit of the header's `must_understand` tells
//! it from a map, and in the place of the input's hash it has the content hash of the map that it was resolved for: its
//! rows name rows of that map and mean nothing with another.

use crate::directory::Reader;
use crate::error::{OpenError, VerifyError};
use crate::header::{HEADER_LENGTH, Header};
use crate::open::{string_of, whole};
use crate::verify::{Check, strings};
use crate::{ArchivedPieceRow, NONE, OverlayKind, OverlayTables, Tables, beside_row};

/// Tells an overlay from a map, among the features that a reader must know of.
pub(crate) const OVERLAY_BIT: u64 = 1 << 63;

/// Seconds of a week.
const WEEK: u32 = 7 * 24 * 3600;

/// An opened overlay.
#[derive(Clone, Copy)]
pub struct Overlay<'a> {
    /// The decoded header; its input hash is the content hash of the map.
    pub header: Header,
    /// All tables.
    pub tables: OverlayTables<'a>,
}

/// Opens an overlay in place, as [`crate::open`] does a map.
///
/// Errors: as [`crate::open`]; [`OpenError::NotAnOverlay`].
pub fn open_overlay(bytes: &[u8]) -> Result<Overlay<'_>, OpenError> {
    let header = whole(bytes)?;
    match header.must_understand {
        OVERLAY_BIT => {}
        bits if bits & OVERLAY_BIT == 0 => return Err(OpenError::NotAnOverlay),
        bits => {
            let bit = (bits & !OVERLAY_BIT).trailing_zeros();
            return Err(OpenError::NotUnderstood { bit, name: String::new(), release: [0; 3] });
        }
    }
    let mut directory = Reader::new(bytes, &header)?;
    let tables = OverlayTables::read(&mut directory)?;
    directory.finish()?;
    Ok(Overlay { header, tables })
}

/// Opens an overlay and proves it: content hash, rows, and what its tables say of each other.
///
/// Errors: the first thing that is wrong, with table, row and field.
pub fn verify_overlay(bytes: &[u8]) -> Result<Overlay<'_>, VerifyError> {
    let overlay = open_overlay(bytes)?;
    let found = *blake3::hash(&bytes[HEADER_LENGTH..]).as_bytes();
    if found != overlay.header.content_hash {
        return Err(VerifyError::ContentHash { expected: overlay.header.content_hash, found });
    }
    let tables = &overlay.tables;
    strings(tables.string_bytes, tables.string_offsets)?;
    tables.verify_rows()?;
    let at = |table, row| Check { table, row };
    if tables.overlay.len() != 1 {
        at("overlay", 0).fail("", "exactly one row", tables.overlay.len())?;
    }
    if tables.cuts.len() > 1 {
        at("cuts", 1).fail("", "at most one row", tables.cuts.len())?;
    }
    for row in tables.cuts {
        let factors = [("length_factor", row.length_factor()), ("time_factor", row.time_factor())];
        for (field, factor) in factors {
            if !(0.0..=1.0).contains(&factor) {
                at("cuts", 0).fail(field, "from 0 to 1", factor)?;
            }
        }
        for (field, saved) in
            [("length_saved", row.length_saved()), ("time_saved", row.time_saved())]
        {
            if saved < 0.0 {
                at("cuts", 0).fail(field, "no less than 0", saved)?;
            }
        }
    }
    for (i, row) in tables.weekly.iter().enumerate() {
        if row.from() >= row.until() || row.until() > WEEK {
            at("weekly", i).fail("until", "a time of the week, after the begin", row.until())?;
        }
    }
    let mut rank = 0;
    for (i, row) in tables.touched.iter().enumerate() {
        if row.rank() != rank {
            at("touched", i).fail("rank", rank.to_string(), row.rank())?;
        }
        rank += row.bits().count_ones();
    }
    if rank as usize != tables.nodes.len() {
        at("touched", 0).fail("bits", format!("{} nodes", tables.nodes.len()), rank)?;
    }
    nodes(tables)?;
    Ok(overlay)
}

/// Proves of a proved overlay that it fits the map that it is for: its rows name rows of the map, and nodes beside each other are cut at the same places.
///
/// Errors: the first thing that is wrong, with table, row and field.
pub fn verify_overlay_on(overlay: &Overlay<'_>, map: &Tables<'_>) -> Result<(), VerifyError> {
    let tables = &overlay.tables;
    let at = |table, row| Check { table, row };
    for (i, row) in tables.signal_entries.iter().enumerate() {
        if row.signal() as usize >= map.signals.len() {
            at("signal_entries", i).fail("signal", "a signal of the map", row.signal())?;
        }
    }
    for (i, own) in tables.nodes.iter().enumerate() {
        let check = at("nodes", i);
        let Some(node) = map.lane_nodes.get(own.node() as usize) else {
            return check.fail("node", "a node of the map", own.node());
        };
        let pieces = own.pieces().of(tables.pieces);
        for beside in [node.left(), node.right()].map(|row| beside_row(own.node(), row)) {
            let known = tables.nodes.binary_search_by_key(&beside, |row| row.node()).ok();
            let known = known.and_then(|row| tables.nodes.get(row));
            // What is not cut need not stand there.
            let other = known.map_or(&[][..], |row| row.pieces().of(tables.pieces));
            let is_alike = || {
                let ends = |row: &ArchivedPieceRow| [row.s_from(), row.s_to()];
                other.len() == pieces.len() && other.iter().map(ends).eq(pieces.iter().map(ends))
            };
            if beside != NONE && pieces.len().max(other.len()) > 1 && !is_alike() {
                check.fail("pieces", format!("those of node {beside} beside it"), own.node())?;
            }
        }
    }
    Ok(())
}

/// Nodes stand where `touched` says, each piece is that of its node, and what changes ways on it is about vehicles that the node names.
fn nodes(tables: &OverlayTables<'_>) -> Result<(), VerifyError> {
    let bits = tables.touched.iter().enumerate().flat_map(|(word, row)| {
        (0..64).filter(|bit| row.bits() >> bit & 1 != 0).map(move |bit| 64 * word as u64 + bit)
    });
    let (named, all) = (tables.node_vehicles, tables.nodes.len());
    if !named.is_empty() && named.len() != all {
        Check { table: "node_vehicles", row: 0 }.fail("", format!("{all} or none"), named.len())?;
    }
    let mut first = 0;
    for (i, (row, node)) in tables.nodes.iter().zip(bits).enumerate() {
        let check = Check { table: "nodes", row: i };
        if u64::from(row.node()) != node {
            check.fail("node", node.to_string(), row.node())?;
        }
        let pieces = row.pieces();
        if pieces.first != first || pieces.count == 0 {
            check.fail(
                "pieces",
                format!("at least one, from {first} on"),
                format!("{pieces:?}"),
            )?;
        }
        for (k, piece) in pieces.of(tables.pieces).iter().enumerate() {
            let check = Check { table: "pieces", row: first as usize + k };
            if piece.node() as usize != i {
                check.fail("node", i.to_string(), piece.node())?;
            }
            if piece.s_from() > piece.s_to() {
                check.fail("s_to", "no less than s_from", piece.s_to())?;
            }
            let entries = piece.entries().of(tables.piece_entries).iter();
            let entries = entries.filter_map(|entry| tables.entries.get(*entry as usize));
            let changing = entries.filter(|e| overlay_changes_ways(e.kind()));
            let classes = changing.fold(0, |all, entry| all | entry.vehicles());
            let missing = named.get(i).map_or(0, |named| classes & !named);
            if missing != 0 {
                let check = Check { table: "node_vehicles", row: i };
                check.fail("", format!("the bits {missing:#x} as well"), named[i])?;
            }
        }
        first += pieces.count;
    }
    if first as usize != tables.pieces.len() {
        Check { table: "pieces", row: first as usize }.fail(
            "node",
            "a node's piece",
            "nobody's",
        )?;
    }
    Ok(())
}

/// Whether an entry of this kind opens, closes or slows the ways of the vehicles that it is about.
#[inline]
pub fn overlay_changes_ways(kind: u8) -> bool {
    use OverlayKind::{Closed, Open, Speed};
    matches!(OverlayKind::from_code(kind), Closed | Open | Speed)
}

/// The string of a number; empty if there is none or it is not UTF-8 (a corrupt overlay).
#[inline]
pub fn overlay_string<'a>(tables: &OverlayTables<'a>, number: u32) -> &'a str {
    string_of(tables.string_bytes, tables.string_offsets, number)
}
