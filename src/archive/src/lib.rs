//! The mapd archive: an HD map as flat tables of numbers, the same bytes in a file and in shared memory.
//!
//! An archive is a header of 128 bytes, a directory and tables that hold nothing but fixed-width little-endian numbers,
//! laid out and validated by rkyv. Releases that know other tables read each other's archives. Opening one is cheap and always validated ([`open`]: the same few hundred nanoseconds for 1 MB and
//! 1 GB); proving every row and the content hash is explicit and linear ([`verify`]).
//!
//! Invariants: nothing here does I/O or holds global state; no table holds a bool, an enum, an option or a nested
//! list, so that a check of bounds and alignment is a whole validation; every reference read from an archive goes
//! through a checked accessor. Deliberately absent: XML, iceoryx2, file handling.
//!
//! ```
//! use mapd_archive::{Rows, Provenance, encode, open, verify};
//!
//! let mut rows = Rows::default();
//! rows.string_offsets.push(0);
//! rows.string_offsets.push(0);
//! rows.map.push(bytemuck::Zeroable::zeroed());
//! rows.graph.push(bytemuck::Zeroable::zeroed());
//! rows.successor_offsets.push(0);
//! rows.predecessor_offsets.push(0);
//! let bytes = encode(&rows, &Provenance::default()).unwrap();
//! let archive = open(&bytes).unwrap();
//! assert_eq!(archive.tables.roads.len(), 0);
//! verify(&bytes).unwrap();
//! ```

#[cfg(not(target_endian = "little"))]
compile_error!(
    "mapd archives are little-endian and read in place: big-endian machines are not supported"
);

mod annotation_codes;
mod annotations;
mod classes;
mod codes;
mod directory;
mod error;
mod generated;
mod graph_codes;
mod hashed;
mod header;
mod lane_row;
mod mark_codes;
mod moves;
mod object_codes;
mod open;
mod overlay;
mod overlay_codes;
pub mod packed_index;
mod points;
mod prefetch;
mod road_rules;
mod signal_codes;
mod strings;
mod table;
mod unknown;
mod verify;
mod verify_annotations;
mod verify_graph;
mod verify_lines;
mod verify_objects;
mod write;

pub use annotation_codes::{AnnotationKind, AnnotationOwner, JunctionGroupKind};
pub use annotations::{AnnotationEntries, AnnotationEntry};
pub use codes::{
    ContactPoint, GeoReferenceForm, LaneType, LinkKind, NONE, QuarantinedKind, RoadType, SpeedKind,
    lane_flags,
};
pub use directory::{Feature, MOST_TABLES, TableEntry, directory};
pub use error::{OpenError, VerifyError, WriteError};
pub use generated::{
    annotation_rows::*,
    append::RowMappings,
    beside_rows::*,
    classes::{Class, ClassGroup},
    index_rows::*,
    known_tables::{FEATURES, FORMAT, LAYOUT_ID},
    network_rows::*,
    object_rows::*,
    overlay_rows::*,
    overlay_tables::{OverlayRows, OverlayTables},
    rows::Rows,
    signal_rows::*,
    tables::Tables,
};
pub use graph_codes::{ConflictKind, EdgeKind, VehicleClass, edge_flags, node_flags};
// For the compiler, which keeps sequences of rows as this crate keeps strings.
#[doc(hidden)]
pub use hashed::{ByHash, Hashed, KeyedHash};
pub use header::{HEADER_LENGTH, Header, MAGIC, Provenance};
pub use lane_row::{MOST_OF_LANE, NOT_BESIDE, beside_of, beside_row, section_step};
pub use mark_codes::{MarkLaneChange, RoadMarkColor, RoadMarkKind, RoadMarkRule, RoadMarkWeight};
pub use moves::RowMapping;
pub use object_codes::{
    ObjectShape, ObjectSide, OutlineFill, PlatformSide, StructureKind, SwitchPosition, copy_flags,
    object_flags, outline_flags,
};
pub use open::{Archive, open, string};
pub use overlay::{
    Overlay, open_overlay, overlay_changes_ways, overlay_string, verify_overlay, verify_overlay_on,
};
pub use overlay_codes::OverlayKind;
pub use points::{PackedPoint, PointCode, PointReader};
pub use prefetch::prefetch;
pub use road_rules::{FromSide, RoadRules};
pub use signal_codes::{
    LaneMethod, NO_RELATION, Orientation, Relation, RelationReason, SignalPosition, signal_flags,
    signal_values,
};
pub use strings::{StringTable, StringTables};
pub use table::{ArchivedRange, Range, Table, TableInfo};
pub use unknown::{Unknown, unknown};
pub use verify::verify;
pub use write::{AlignedBytes, encode, encode_into, encode_overlay, encode_to, encoded_length};

/// Writing, and both parts of [`verify`], for this project's programs, which run them side by side. No part of the public
/// interface.
#[doc(hidden)]
pub mod side_by_side {
    pub use crate::verify::{verify_hash, verify_tables};
    pub use crate::write::{Both, encode_to_with};
}
