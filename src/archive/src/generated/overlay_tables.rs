//! An overlay's tables.
// Written by `cargo run -p mapd-schemas` from schemas/overlay.toml; change that file instead.

use super::overlay_rows::*;
use crate::directory::{Reader, TableKind};
use crate::error::{OpenError, VerifyError};
use crate::table::Table;
use crate::verify::Check;

/// The tables of an overlay, by number.
pub(crate) const OVERLAY_TABLES: [TableKind; 12] = [
    TableKind::new(1, "string_bytes", 1, 0xb6f9a5667163132f, true),
    TableKind::new(2, "string_offsets", 4, 0x67743eeea1e68648, true),
    TableKind::new(3, "overlay", 24, 0x304c3bba2686a319, true),
    TableKind::new(4, "entries", 56, 0x3468e5c4c3e8eb7f, false),
    TableKind::new(5, "weekly", 8, 0x6a6dc4a3bb967c69, false),
    TableKind::new(6, "touched", 16, 0xfc1163529f5ca44a, false),
    TableKind::new(7, "nodes", 12, 0x254268759576a746, false),
    TableKind::new(8, "pieces", 40, 0x1238b9e07efd0c1c, false),
    TableKind::new(9, "piece_entries", 4, 0x70c7e01b146476bd, false),
    TableKind::new(10, "signal_entries", 8, 0x687ebc0d11f42f17, false),
    TableKind::new(11, "node_vehicles", 2, 0x56a52e21323ae6fc, false),
    TableKind::new(12, "cuts", 32, 0x9eedf0c3881482ab, false),
];

/// All tables of an opened overlay; those that it does not have are empty.
#[derive(Clone, Copy)]
pub struct OverlayTables<'a> {
    /// UTF-8 text of all strings, one after the other, each once. String 0 is empty.
    pub string_bytes: &'a [u8],
    /// Start of each string in `string_bytes`; one more entry than strings.
    pub string_offsets: &'a [u32],
    /// Exactly one row: facts about the whole overlay.
    pub overlay: &'a [ArchivedOverlayRow],
    /// Entries, in the order of the document.
    pub entries: &'a [ArchivedOverlayEntryRow],
    /// Times of the week, by entry.
    pub weekly: &'a [ArchivedWeeklyRow],
    /// For each 64 nodes of the map's lane graph, the nodes that have pieces here. Empty if none has.
    pub touched: &'a [ArchivedTouchedRow],
    /// Nodes of the map's lane graph that have pieces, ascending.
    pub nodes: &'a [ArchivedOverlayNodeRow],
    /// Pieces of nodes. The same entries hold over the whole of a piece.
    pub pieces: &'a [ArchivedPieceRow],
    /// Entries that hold on pieces, by piece, ascending.
    pub piece_entries: &'a [u32],
    /// Entries about signals, by signal.
    pub signal_entries: &'a [ArchivedSignalEntryRow],
    /// By node of `nodes`: bit i says that an entry closes, opens or slows it, or a node that is cut with it, for vehicle class i. For other classes searches may take the map's own node. Empty if that is not said.
    pub node_vehicles: &'a [u16],
    /// At most one row: what cutting nodes does to bounds of the map. A change of lane in the middle of a node leaves a longer one beside it to be driven in part only. Without it there are no bounds if a node is cut.
    pub cuts: &'a [ArchivedCutsRow],
}

impl<'a> OverlayTables<'a> {
    pub(crate) fn read(directory: &mut Reader<'a>) -> Result<Self, OpenError> {
        Ok(Self {
            string_bytes: directory.take(&OVERLAY_TABLES[0])?,
            string_offsets: directory.take(&OVERLAY_TABLES[1])?,
            overlay: directory.take(&OVERLAY_TABLES[2])?,
            entries: directory.take(&OVERLAY_TABLES[3])?,
            weekly: directory.take(&OVERLAY_TABLES[4])?,
            touched: directory.take(&OVERLAY_TABLES[5])?,
            nodes: directory.take(&OVERLAY_TABLES[6])?,
            pieces: directory.take(&OVERLAY_TABLES[7])?,
            piece_entries: directory.take(&OVERLAY_TABLES[8])?,
            signal_entries: directory.take(&OVERLAY_TABLES[9])?,
            node_vehicles: directory.take(&OVERLAY_TABLES[10])?,
            cuts: directory.take(&OVERLAY_TABLES[11])?,
        })
    }
}

/// All tables of an overlay as they are filled.
#[derive(Default)]
pub struct OverlayRows {
    /// UTF-8 text of all strings, one after the other, each once. String 0 is empty.
    pub string_bytes: Table<u8>,
    /// Start of each string in `string_bytes`; one more entry than strings.
    pub string_offsets: Table<u32>,
    /// Exactly one row: facts about the whole overlay.
    pub overlay: Table<OverlayRow>,
    /// Entries, in the order of the document.
    pub entries: Table<OverlayEntryRow>,
    /// Times of the week, by entry.
    pub weekly: Table<WeeklyRow>,
    /// For each 64 nodes of the map's lane graph, the nodes that have pieces here. Empty if none has.
    pub touched: Table<TouchedRow>,
    /// Nodes of the map's lane graph that have pieces, ascending.
    pub nodes: Table<OverlayNodeRow>,
    /// Pieces of nodes. The same entries hold over the whole of a piece.
    pub pieces: Table<PieceRow>,
    /// Entries that hold on pieces, by piece, ascending.
    pub piece_entries: Table<u32>,
    /// Entries about signals, by signal.
    pub signal_entries: Table<SignalEntryRow>,
    /// By node of `nodes`: bit i says that an entry closes, opens or slows it, or a node that is cut with it, for vehicle class i. For other classes searches may take the map's own node. Empty if that is not said.
    pub node_vehicles: Table<u16>,
    /// At most one row: what cutting nodes does to bounds of the map. A change of lane in the middle of a node leaves a longer one beside it to be driven in part only. Without it there are no bounds if a node is cut.
    pub cuts: Table<CutsRow>,
}

impl OverlayRows {
    /// The bytes of all tables, in the order of `OVERLAY_TABLES`.
    pub(crate) fn bytes(&self) -> [&[u8]; 12] {
        [
            bytemuck::cast_slice(self.string_bytes.as_slice()),
            bytemuck::cast_slice(self.string_offsets.as_slice()),
            bytemuck::cast_slice(self.overlay.as_slice()),
            bytemuck::cast_slice(self.entries.as_slice()),
            bytemuck::cast_slice(self.weekly.as_slice()),
            bytemuck::cast_slice(self.touched.as_slice()),
            bytemuck::cast_slice(self.nodes.as_slice()),
            bytemuck::cast_slice(self.pieces.as_slice()),
            bytemuck::cast_slice(self.piece_entries.as_slice()),
            bytemuck::cast_slice(self.signal_entries.as_slice()),
            bytemuck::cast_slice(self.node_vehicles.as_slice()),
            bytemuck::cast_slice(self.cuts.as_slice()),
        ]
    }
}

impl OverlayTables<'_> {
    /// Proves every row: finite numbers, known codes, references and ranges inside their tables.
    pub(crate) fn verify_rows(&self) -> Result<(), VerifyError> {
        let strings = self.string_offsets.len().saturating_sub(1);
        for (i, row) in self.overlay.iter().enumerate() {
            let check = Check { table: "overlay", row: i };
            check.finite("time_saved", row.time_saved())?;
            check.finite("time_factor", row.time_factor())?;
        }
        for (i, row) in self.entries.iter().enumerate() {
            let check = Check { table: "entries", row: i };
            check.finite("from", row.from())?;
            check.finite("until", row.until())?;
            check.finite("value", row.value())?;
            check.range("weekly", row.weekly(), self.weekly.len())?;
            check.reference("id", row.id(), strings, false)?;
            check.reference("source", row.source(), strings, false)?;
            check.reference("text", row.text(), strings, false)?;
            check.finite("confidence", f64::from(row.confidence()))?;
        }
        for (i, row) in self.nodes.iter().enumerate() {
            let check = Check { table: "nodes", row: i };
            check.range("pieces", row.pieces(), self.pieces.len())?;
        }
        for (i, row) in self.pieces.iter().enumerate() {
            let check = Check { table: "pieces", row: i };
            check.finite("s_from", row.s_from())?;
            check.finite("s_to", row.s_to())?;
            check.reference("node", row.node(), self.nodes.len(), false)?;
            check.range("entries", row.entries(), self.piece_entries.len())?;
            check.finite("before", f64::from(row.before()))?;
            check.finite("length", f64::from(row.length()))?;
            check.finite("time", f64::from(row.time()))?;
        }
        for (i, row) in self.piece_entries.iter().enumerate() {
            let check = Check { table: "piece_entries", row: i };
            check.reference("", *row, self.entries.len(), false)?;
        }
        for (i, row) in self.signal_entries.iter().enumerate() {
            let check = Check { table: "signal_entries", row: i };
            check.reference("entry", row.entry(), self.entries.len(), false)?;
        }
        for (i, row) in self.cuts.iter().enumerate() {
            let check = Check { table: "cuts", row: i };
            check.finite("length_saved", row.length_saved())?;
            check.finite("length_factor", row.length_factor())?;
            check.finite("time_saved", row.time_saved())?;
            check.finite("time_factor", row.time_factor())?;
        }
        Ok(())
    }
}
