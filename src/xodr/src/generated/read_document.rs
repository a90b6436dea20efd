//! Reads the elements of `document`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/document.toml; change that file instead.

use super::*;
use crate::cursor::Cursor;

/// Reads the top-level element of a slot.
pub(crate) fn item(slot: usize, cursor: &mut Cursor<'_>) -> Option<Item> {
    Some(match slot {
        0 => Item::Header(cursor.boxed()),
        1 => Item::Road(cursor.boxed()),
        2 => Item::Controller(cursor.boxed()),
        3 => Item::Junction(cursor.boxed()),
        4 => Item::JunctionGroup(cursor.boxed()),
        5 => Item::Station(cursor.boxed()),
        6 => Item::VmsGroup(cursor.boxed()),
        _ => return None,
    })
}
