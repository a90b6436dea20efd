//! The bytes of a sample, readable by many threads.
#![allow(unsafe_code)]

use super::config::TransportService;
use crate::error::AttachError;
use crate::limits::TRANSPORT_REVISION;
use crate::mapping::leave_out_of_core_dumps;
use crate::payload::{Chunk64, GenerationInfo};
use crate::presence::Presence;
use iceoryx2::sample::Sample;
use std::sync::{Arc, Mutex};

/// What iceoryx2 hands out: may move between threads, but every look at its payload takes a lock.
pub(crate) type MapSample = Sample<TransportService, [Chunk64], GenerationInfo>;

/// A sample, and its bytes, which many threads read without a lock.
pub(crate) struct PinnedSample {
    /// Points into the payload of `sample`; never leaves this module with a longer life than a borrow of `PinnedSample`.
    bytes: &'static [u8],
    /// Keeps the mapping. Never looked at again: the lock is only there because a sample may not be shared.
    _sample: Mutex<MapSample>,
    /// Left last, when nothing of the domain is used any more.
    _presence: Arc<Presence>,
}

impl PinnedSample {
    /// Takes the payload's address once.
    ///
    /// Errors: the header promises more bytes than were sent.
    pub(crate) fn new(
        sample: MapSample,
        map: &str,
        presence: &Arc<Presence>,
    ) -> Result<(GenerationInfo, Self), AttachError> {
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
        //   into the same value and is dropped with it; the slice leaves only through `bytes(&self)`.
        // - No writer: iceoryx2 maps the segment read-only here; the publisher owns one sample, gave it away by sending it
        //   and sends no other, and the daemon makes the file read-only afterwards.
        let bytes: &'static [u8] =
            unsafe { std::slice::from_raw_parts(chunks.as_ptr().cast::<u8>(), length) };
        leave_out_of_core_dumps(bytes);
        let pinned = Self { bytes, _sample: Mutex::new(sample), _presence: presence.clone() };
        Ok((info, pinned))
    }

    pub(crate) fn bytes(&self) -> &[u8] {
        self.bytes
    }
}
