//! One generation, kept alive.
#![allow(unsafe_code)]

use super::config::TransportService;
use super::error::AttachError;
use super::limits::TRANSPORT_REVISION;
use super::payload::{Chunk64, GenerationInfo};
use super::presence::Presence;
use iceoryx2::sample::Sample;
use memmap2::Mmap;
use std::fmt;
use std::ops::Range;
use std::sync::{Arc, Mutex};

/// What iceoryx2 hands out: may move between threads, but every look at its payload takes a lock.
pub(crate) type MapSample = Sample<TransportService, [Chunk64], GenerationInfo>;

/// A generation that stays mapped and readable for as long as any clone lives, whatever becomes of the daemon and of the
/// subscription it came from. Cheap to clone; many threads read it without a lock.
#[derive(Clone)]
pub struct Pinned(Arc<Held>);

struct Held {
    info: GenerationInfo,
    memory: Memory,
}

enum Memory {
    Sample {
        /// Points into the payload of `sample`; never leaves this module with a longer life than a borrow of `Pinned`.
        bytes: &'static [u8],
        /// Keeps the mapping. Never looked at again: the lock is only there because a sample may not be shared.
        _sample: Mutex<MapSample>,
        /// Left last, when nothing of the domain is used any more.
        _presence: Arc<Presence>,
    },
    /// A mapping of one's own, which nobody knows of, and the bytes' place in it.
    Segment(Mmap, Range<usize>),
}

impl Pinned {
    /// Takes the payload's address once.
    ///
    /// Errors: the header promises more bytes than were sent.
    pub(crate) fn new(
        sample: MapSample,
        map: &str,
        presence: &Arc<Presence>,
    ) -> Result<Self, AttachError> {
        let info = *sample.user_header();
        let chunks = sample.payload();
        let sent = size_of_val(chunks);
        let length = usize::try_from(info.length).unwrap_or(usize::MAX);
        if length > sent {
            let found = format!(
                "revision {TRANSPORT_REVISION} with {length} bytes announced and {sent} sent"
            );
            return Err(AttachError::WrongTransport { map: map.to_owned(), found });
        }
        // SAFETY:
        // - Address and length: `chunks` is a valid slice of `sent` initialised bytes, `length <= sent`, and `u8` has no
        //   alignment. `Chunk64` is `repr(C)` over `[u8; 64]`, so that it has no padding.
        // - Life: a sample's payload lies in the publisher's data segment, which this process has mapped and keeps mapped
        //   until the sample is dropped; neither moving the sample nor the publisher's death unmaps it. The sample moves
        //   into the same `Held` and is dropped with it; the slice leaves only through `bytes(&self)`.
        // - No writer: iceoryx2 maps the segment read-only here; the publisher owns one sample, gave it away by sending it
        //   and sends no other, and the daemon makes the file read-only afterwards.
        let bytes: &'static [u8] =
            unsafe { std::slice::from_raw_parts(chunks.as_ptr().cast::<u8>(), length) };
        let memory =
            Memory::Sample { bytes, _sample: Mutex::new(sample), _presence: presence.clone() };
        Ok(Self(Arc::new(Held { info, memory })))
    }

    /// The bytes from `offset` on in a mapping that ends with them.
    pub(crate) fn of_segment(mapping: Mmap, offset: u64, info: GenerationInfo) -> Self {
        let end = mapping.len();
        let start = usize::try_from(offset).unwrap_or(end).min(end);
        Self(Arc::new(Held { info, memory: Memory::Segment(mapping, start..end) }))
    }

    /// The bytes as published, exactly as long, starting on a 64-byte boundary. Takes no lock.
    pub fn bytes(&self) -> &[u8] {
        match &self.0.memory {
            Memory::Sample { bytes, .. } => bytes,
            Memory::Segment(mapping, place) => &mapping[place.clone()],
        }
    }

    /// What is said about them.
    pub fn info(&self) -> &GenerationInfo {
        &self.0.info
    }

    /// Counts the generations that are still held, in the bookkeeping of a subscription.
    pub(crate) fn watch(&self) -> Watch {
        let held: Arc<dyn Send + Sync> = self.0.clone();
        Watch(Arc::downgrade(&held))
    }
}

/// Tells whether a generation is still held, without holding it.
pub(crate) struct Watch(std::sync::Weak<dyn Send + Sync>);

impl Watch {
    pub(crate) fn is_held(&self) -> bool {
        self.0.strong_count() > 0
    }
}

impl fmt::Debug for Pinned {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Pinned").field("info", self.info()).finish_non_exhaustive()
    }
}
