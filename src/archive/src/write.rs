//! Writing: the exact size first, then straight into the destination.

use crate::Rows;
use crate::error::WriteError;
use crate::header::{HEADER_LENGTH, Header, Provenance};
use crate::open::ALIGNMENT;
use rkyv::rancor::{Failure, Fallible};
use rkyv::ser::allocator::SubAllocator;
use rkyv::ser::writer::Buffer;
use rkyv::ser::{Positional, Serializer, Writer};
use std::io::{self, Seek, SeekFrom, Write};

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

/// Bytes that are hashed and written at a time: they are in the processor's cache for both.
const CHUNK: usize = 256 << 10;

/// A writer that hashes what it passes on.
struct Streamed<'a, W> {
    out: &'a mut W,
    position: usize,
    hasher: blake3::Hasher,
    /// Why writing failed; rkyv's error in release builds says nothing.
    failed: Option<io::Error>,
}

impl<W> Fallible for Streamed<'_, W> {
    type Error = Failure;
}

impl<W> Positional for Streamed<'_, W> {
    fn pos(&self) -> usize {
        self.position
    }
}

impl<W: Write> Writer<Failure> for Streamed<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        for chunk in bytes.chunks(CHUNK) {
            self.hasher.update(chunk);
            self.out.write_all(chunk).map_err(|error| {
                self.failed = Some(error);
                Failure
            })?;
        }
        self.position += bytes.len();
        Ok(())
    }
}

/// Writes the bytes of [`encode_into`] to a file, from its start. The file's pages are not this process's memory: nothing is
/// held but the rows.
///
/// Errors: what the system says.
pub fn encode_to(
    rows: &Rows,
    provenance: &Provenance,
    out: &mut (impl Write + Seek),
) -> io::Result<Header> {
    out.seek(SeekFrom::Start(HEADER_LENGTH as u64))?;
    let stream = Streamed { out, position: 0, hasher: blake3::Hasher::new(), failed: None };
    let mut writer = Serializer::new(stream, SubAllocator::empty(), ());
    let done = rkyv::api::serialize_using::<_, Failure>(rows, &mut writer);
    let stream = writer.into_writer();
    if let Some(error) = stream.failed {
        return Err(error);
    }
    done.map_err(|error| io::Error::other(error.to_string()))?;
    let header = Header {
        body_length: stream.position as u64,
        content_hash: *stream.hasher.finalize().as_bytes(),
        provenance: *provenance,
    };
    stream.out.seek(SeekFrom::Start(0))?;
    stream.out.write_all(&header.encode())?;
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;

    /// A stream of so many bytes.
    struct Short(Cursor<Vec<u8>>, usize);

    impl Write for Short {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            let left = self.1.saturating_sub(self.0.position() as usize);
            match bytes.len().min(left) {
                0 => Err(io::ErrorKind::StorageFull.into()),
                count => self.0.write(&bytes[..count]),
            }
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    impl Seek for Short {
        fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
            self.0.seek(to)
        }
    }

    fn rows() -> Rows {
        let mut rows = Rows::default();
        rows.string_bytes.extend_from_slice(b"odd");
        rows.string_offsets.extend([0, 3]);
        rows.coefficients.extend((0..CHUNK).map(|n| n as f64));
        rows
    }

    #[test]
    fn memory_and_stream_have_the_same_bytes() {
        for rows in [Rows::default(), rows()] {
            let provenance = Provenance::default();
            let memory = encode(&rows, &provenance).expect("encodes");
            let mut stream = Cursor::new(Vec::new());
            let header = encode_to(&rows, &provenance, &mut stream).expect("encodes");
            assert!(stream.into_inner() == memory[..]);
            assert_eq!(header, Header::decode(&memory[..HEADER_LENGTH]).expect("a header"));
        }
    }

    #[test]
    fn a_stream_that_ends_says_why() {
        let length = encoded_length(&rows()).expect("a length");
        for room in [0, HEADER_LENGTH, length / 2, length - 1] {
            let mut stream = Short(Cursor::new(Vec::new()), room);
            let error = encode_to(&rows(), &Provenance::default(), &mut stream).err();
            assert_eq!(error.map(|e| e.kind()), Some(io::ErrorKind::StorageFull), "{room}");
        }
        let mut stream = Short(Cursor::new(Vec::new()), length);
        assert!(encode_to(&rows(), &Provenance::default(), &mut stream).is_ok());
    }
}
