//! Readers that write nothing: a map's record says which file holds the generation that is served and where in it the bytes lie;
//! an [`Observer`] maps that file read-only and is done. No lock, no node, no port, nothing created or written anywhere; any number of them.
//!
//! ```text
//! /dev/shm/mapd_root/{map}.published   one page, made before the map is served, never resized, removed after it was closed
//!
//!   header     magic, revision, sequence (of the slot that holds, and futex word), heartbeat
//!   slot 0     checksum, sequence, what is said of the generation, name and inode of its segment, offset, its overlay
//!   slot 1     the same; a slot's sequence is even or odd as its number is
//! ```
//!
//! | who | does, in this order |
//! |---|---|
//! | daemon, publishing | writes the slot that does not hold, with sequence + 1; sends; stores sequence + 1; wakes; drops the publisher before, whose segment goes |
//! | daemon, publishing where the page is damaged or has lost its name | before that: makes a page that says what the old one said, whole before it has the name; closes the old one, as withdrawing |
//! | daemon, withdrawing | the same with a slot that says that nothing is served; wakes; removes the page |
//! | reader | sequence; its slot; sequence again, and again if it changed; checksum; opens, fstat, maps; tells by inode and hash that it is that generation |
//!
//! What a kill leaves: before the sequence is stored, the slot that held still holds, and its segment is there, for the one publisher that owns it
//! goes last. Afterwards the new slot holds, and its segment was sent. Who sleeps on the word looks again at least every 100 ms
//! ([`LOOK`](self::reader)), so that a wake-up that is lost costs that much. The next daemon goes on with the page it finds.
//!
//! Whose word is taken: root folder, record and segment belong to the owner that the reader trusts, by `fstat` on what was opened and, for the folder, by its path;
//! names in a record are plain and lie in the domain. A process that can write these files is trusted with memory that never shrinks: a mapping of a file that
//! becomes shorter ends its reader by SIGBUS. Holes would do so where shared memory is full; files with holes are refused.

#[cfg(test)]
mod lives;
mod memory;
#[cfg(test)]
#[allow(clippy::duplicate_mod)]
mod model;
mod overlay;
#[allow(clippy::duplicate_mod)]
mod page;
mod reader;
mod slot;
mod writer;

pub use overlay::{OverlayState, PinnedOverlay, overlay_file};
pub use reader::Observer;
pub use slot::{OverlayLocation, SegmentLocation};
pub use writer::RecordWriter;

pub(crate) use reader::{daemon_heard, published};
pub use reader::{heartbeat_age, revision_of};

use std::sync::atomic;

/// Words of a slot, checksum and sequence among them.
const WORDS: usize = 55;
