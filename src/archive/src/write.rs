//! Writing: the exact size first, then straight into the destination.

use crate::Rows;
use crate::error::WriteError;
use crate::header::{HEADER_LENGTH, Header, Provenance};
use crate::open::ALIGNMENT;
use rkyv::rancor::{Failure, Fallible};
use rkyv::ser::allocator::SubAllocator;
use rkyv::ser::writer::Buffer;
use rkyv::ser::{Positional, Serializer, Writer};

/// A byte buffer at an aligned address.
pub type AlignedBytes = rkyv::util::AlignedVec<64>;

/// A writer that only counts.
struct Counter(usize);

impl Fallible for Counter {
    type Error = Failure;
}

impl Positional for Counter {
    fn pos(&self) -> usize {
        self.0
    }
}

impl Writer<Failure> for Counter {
    fn write(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        self.0 += bytes.len();
        Ok(())
    }
}

/// Exact length in bytes of the archive that [`encode_into`] will write.
pub fn encoded_length(rows: &Rows) -> Result<usize, WriteError> {
    let mut counter = Serializer::new(Counter(0), SubAllocator::empty(), ());
    rkyv::api::serialize_using::<_, Failure>(rows, &mut counter)
        .map_err(|e| WriteError::Serialize(e.to_string()))?;
    Ok(HEADER_LENGTH + counter.into_writer().0)
}

/// Writes an archive into a destination of exactly [`encoded_length`] bytes, aligned to 8. Whatever the destination
/// held before does not show in the result.
///
/// Errors: wrong length or alignment of the destination.
pub fn encode_into(
    rows: &Rows,
    provenance: &Provenance,
    out: &mut [u8],
) -> Result<Header, WriteError> {
    let expected = encoded_length(rows)?;
    if out.len() != expected {
        return Err(WriteError::Length { expected, found: out.len() });
    }
    if !(out.as_ptr() as usize).is_multiple_of(ALIGNMENT) {
        return Err(WriteError::Alignment { expected: ALIGNMENT });
    }
    let (head, body) = out.split_at_mut(HEADER_LENGTH);
    let mut writer = Serializer::new(Buffer::from(&mut *body), SubAllocator::empty(), ());
    rkyv::api::serialize_using::<_, Failure>(rows, &mut writer)
        .map_err(|e| WriteError::Serialize(e.to_string()))?;
    // Gaps between tables are written as zeros: with the right length, nothing is left of what was there.
    let found = HEADER_LENGTH + writer.into_writer().len();
    if found != expected {
        return Err(WriteError::Length { expected, found });
    }
    let header = Header {
        body_length: body.len() as u64,
        content_hash: *blake3::hash(body).as_bytes(),
        provenance: *provenance,
    };
    head.copy_from_slice(&header.encode());
    Ok(header)
}

/// An archive in memory.
pub fn encode(rows: &Rows, provenance: &Provenance) -> Result<AlignedBytes, WriteError> {
    let length = encoded_length(rows)?;
    let mut bytes = AlignedBytes::with_capacity(length);
    bytes.resize(length, 0);
    encode_into(rows, provenance, &mut bytes)?;
    Ok(bytes)
}
