//! What is held of shared memory, and that a forked process does not give it back.

use mapd_client::{Map, Snapshot};

/// A pinned generation. A process that was forked off inherits the mapping and may read it; the place in the daemon's queues is its
/// parent's, so that dropping it there does nothing.
pub(crate) struct Held {
    snapshot: Option<Snapshot>,
    process: u32,
}

impl Held {
    pub(crate) fn new(snapshot: Snapshot) -> Self {
        Self { snapshot: Some(snapshot), process: std::process::id() }
    }

    /// The snapshot; it is there until this is dropped.
    pub(crate) fn snapshot(&self) -> &Snapshot {
        self.snapshot.as_ref().expect("taken when dropped only")
    }

    pub(crate) fn map(&self) -> Map<'_> {
        self.snapshot().map()
    }
}

impl Drop for Held {
    fn drop(&mut self) {
        if std::process::id() != self.process {
            std::mem::forget(self.snapshot.take());
        }
    }
}

/// First four bytes of the content's hash: what ids in arrays are bound to. Beside the row, an id of 64 bits has room for no more.
pub(crate) fn content(map: Map<'_>) -> u32 {
    let hash = map.content_hash();
    u32::from_le_bytes([hash[0], hash[1], hash[2], hash[3]])
}

/// An id as Python has it: the content that it is bound to, then the row.
pub(crate) fn id(content: u32, row: u32) -> u64 {
    u64::from(content) << 32 | u64::from(row)
}
