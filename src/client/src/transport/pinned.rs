//! A sample that stays where it is.
#![allow(unsafe_code)]

use super::error::AttachError;
use super::protocol::{Chunk64, GenerationInfo, Ipc};
use iceoryx2::sample::Sample;
use std::sync::Mutex;

/// A generation's bytes, kept by holding its sample. Reading takes no lock.
pub struct Pinned {
    /// Never touched before it is dropped; the mutex only makes it shareable.
    _sample: Mutex<Sample<Ipc, [Chunk64], GenerationInfo>>,
    info: GenerationInfo,
    start: *const u8,
    length: usize,
}

// SAFETY: `start` points into the sample's payload, which is mapped read-only into this process and stays mapped until
// the sample is dropped with this value. The bytes are only read, through `&[u8]`. The sample itself is `Send` in the
// thread-safe service flavour and is never accessed through a shared reference.
unsafe impl Send for Pinned {}
// SAFETY: as above.
unsafe impl Sync for Pinned {}

impl Pinned {
    /// Pins a sample. Its payload is asked for once.
    pub(crate) fn new(
        sample: Sample<Ipc, [Chunk64], GenerationInfo>,
        map: &str,
    ) -> Result<Self, AttachError> {
        let info = *sample.user_header();
        let payload = sample.payload();
        let found = size_of_val(payload) as u64;
        // The archive fills the last chunk, give or take its end.
        if info.length > found || found - info.length >= size_of::<Chunk64>() as u64 {
            return Err(AttachError::Sample {
                name: map.to_owned(),
                announced: info.length,
                found,
            });
        }
        let start = payload.as_ptr().cast::<u8>();
        Ok(Self { info, start, length: info.length as usize, _sample: Mutex::new(sample) })
    }

    /// The archive's bytes, 64-byte aligned.
    pub fn bytes(&self) -> &[u8] {
        // SAFETY: `start` and `length` were taken from the payload in `new` and lie inside it; it stays mapped as long
        // as `self` lives (see above). `Chunk64` is plain bytes without padding.
        unsafe { std::slice::from_raw_parts(self.start, self.length) }
    }

    /// What was published with it.
    pub fn info(&self) -> &GenerationInfo {
        &self.info
    }
}
