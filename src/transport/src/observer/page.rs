//! The page of a map's record, and the protocol on it: one writer, any number of readers, each of which may end at any moment.

// Both are the parent's, so that the same text is searched with other atomics and fewer words (`model.rs`).
use super::WORDS;
use super::atomic::{AtomicU32, AtomicU64, Ordering, fence};

/// Bytes of a record. Readers read no more.
pub(super) const PAGE_BYTES: usize = 4096;

/// What a slot holds; see `slot.rs`.
pub(super) type Words = [u64; WORDS];

/// First word of a page.
pub(super) const MAGIC: u64 = u64::from_le_bytes(*b"mapdpub\x01");

/// The page, as it lies in shared memory. Every bit pattern is a value of it.
#[repr(C)]
pub(super) struct Page {
    pub(super) magic: AtomicU64,
    /// [`crate::TRANSPORT_REVISION`] of who made the page.
    pub(super) revision: AtomicU32,
    /// Which slot holds, by its lowest bit; 0 while nothing was ever published. Rises by 1; after the highest number comes 2.
    pub(super) sequence: AtomicU32,
    /// When the daemon last said that it lives: nanoseconds of the monotonic clock; 0 for never.
    pub(super) heartbeat: AtomicU64,
    pub(super) slots: [[AtomicU64; WORDS]; 2],
}

impl Page {
    /// The sequence, and the slot that holds; `None` if another came to hold meanwhile, which may have been written over.
    ///
    /// Why a slot is whole if the sequence did not change: a slot is written only while the other one holds. A reader that sees a word of the
    /// next round in it has, by the two fences, also seen that the other one came to hold.
    pub(super) fn read(&self) -> Option<(u32, Words)> {
        let sequence = self.sequence.load(Ordering::Acquire);
        let slot = &self.slots[sequence as usize % 2];
        let words = std::array::from_fn(|i| slot[i].load(Ordering::Relaxed));
        fence(Ordering::Acquire);
        (self.sequence.load(Ordering::Relaxed) == sequence).then_some((sequence, words))
    }

    /// The sequence after this one, of the other slot.
    pub(super) fn next(sequence: u32) -> u32 {
        // 0 would be the same slot again, and means that nothing was ever published.
        sequence.checked_add(1).unwrap_or(2)
    }

    /// Writes the slot that does not hold. Only the daemon that has claimed the map does so; nobody sees it before [`Page::hold`].
    pub(super) fn write(&self, sequence: u32, words: &Words) {
        // A reader sees what is written from here on only after it has seen that the other slot is current.
        fence(Ordering::Release);
        for (word, value) in self.slots[sequence as usize % 2].iter().zip(words) {
            word.store(*value, Ordering::Relaxed);
        }
    }

    /// Has the slot hold that was written.
    pub(super) fn hold(&self, sequence: u32) {
        self.sequence.store(sequence, Ordering::Release);
    }
}
