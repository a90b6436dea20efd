//! One generation, kept alive.

use crate::mapping::Mapping;
use crate::payload::GenerationInfo;
#[cfg(feature = "iceoryx2")]
use crate::subscriber::PinnedSample;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// A generation that stays mapped and readable for as long as any clone lives, whatever becomes of the daemon and of the
/// reader it came from. Cheap to clone; many threads read it without a lock.
#[derive(Clone)]
pub struct Pinned(Arc<PinnedGeneration>);

struct PinnedGeneration {
    info: GenerationInfo,
    memory: Memory,
}

pub(crate) enum Memory {
    /// What a subscription received.
    #[cfg(feature = "iceoryx2")]
    Sample(PinnedSample),
    /// A private mapping, unknown to other processes, and the offset of the bytes in it.
    Segment(Mapping, Range<usize>),
}

impl Pinned {
    pub(crate) fn new(info: GenerationInfo, memory: Memory) -> Self {
        Self(Arc::new(PinnedGeneration { info, memory }))
    }

    /// The bytes from `offset` on in a mapping that ends with them.
    pub(crate) fn of_segment(mapping: Mapping, offset: u64, info: GenerationInfo) -> Self {
        let end = mapping.bytes().len();
        let start = usize::try_from(offset).unwrap_or(end).min(end);
        Self::new(info, Memory::Segment(mapping, start..end))
    }

    /// The bytes as published, exactly as long, starting on a 64-byte boundary. Takes no lock.
    pub fn bytes(&self) -> &[u8] {
        match &self.0.memory {
            #[cfg(feature = "iceoryx2")]
            Memory::Sample(sample) => sample.bytes(),
            Memory::Segment(mapping, place) => &mapping.bytes()[place.clone()],
        }
    }

    /// What is said about them.
    pub fn info(&self) -> &GenerationInfo {
        &self.0.info
    }

    /// Counts the generations that are still held, in the bookkeeping of a subscription.
    #[cfg(feature = "iceoryx2")]
    pub(crate) fn watch(&self) -> Watch {
        let held: Arc<dyn Send + Sync> = self.0.clone();
        Watch(Arc::downgrade(&held))
    }
}

/// Tells whether a generation is still held, without holding it.
#[cfg(feature = "iceoryx2")]
pub(crate) struct Watch(std::sync::Weak<dyn Send + Sync>);

#[cfg(feature = "iceoryx2")]
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
