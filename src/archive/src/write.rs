//! Writing: the exact size first, then straight into the destination.

use crate::Rows;
use crate::directory::{ENTRY_LENGTH, TableEntry, TableKind, feature_bit};
use crate::error::WriteError;
use crate::generated::known_tables::TABLES;
use crate::header::{HEADER_LENGTH, Header, Provenance};
use crate::open::ALIGNMENT;
use rkyv::rancor::{Failure, Fallible};
use rkyv::ser::writer::Buffer;
use rkyv::ser::{Positional, Writer, WriterExt};
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

/// What an archive of some rows will be.
struct Plan {
    directory: Vec<TableEntry>,
    /// Exact length in bytes.
    length: usize,
}

/// The tables that an archive gets: those that every archive has, and those that have rows.
fn tables(rows: &Rows) -> impl Iterator<Item = (&'static TableKind, &[u8])> {
    let tables = TABLES.iter().zip(rows.bytes());
    tables.filter(|(kind, bytes)| kind.required || !bytes.is_empty())
}

impl Plan {
    fn of(rows: &Rows) -> Result<Self, Failure> {
        let mut counter = Counter(HEADER_LENGTH + tables(rows).count() * ENTRY_LENGTH);
        let mut directory = Vec::with_capacity(TABLES.len());
        for (kind, bytes) in tables(rows) {
            directory.push(TableEntry {
                number: kind.number,
                row_bytes: kind.row_bytes,
                row_id: kind.row_id,
                offset: counter.align(ALIGNMENT)? as u64,
                count: (bytes.len() / kind.row_bytes as usize) as u64,
            });
            counter.write(bytes)?;
        }
        Ok(Self { directory, length: counter.0 })
    }

    /// Writes directory and tables behind a header. Rows have no padding and the machine is little-endian: their bytes are
    /// the archived bytes.
    fn write(&self, rows: &Rows, out: &mut impl Writer<Failure>) -> Result<(), Failure> {
        out.write(bytemuck::cast_slice(&self.directory))?;
        for (_, bytes) in tables(rows) {
            out.align(ALIGNMENT)?;
            out.write(bytes)?;
        }
        Ok(())
    }

    fn header(&self, rows: &Rows, provenance: &Provenance, content: &blake3::Hasher) -> Header {
        let bits = rows.features.iter().map(|feature| feature_bit(feature.bit));
        Header {
            must_understand: bits.fold(0, |all, bit| all | bit),
            tables: self.directory.len() as u32,
            body_length: (self.length - HEADER_LENGTH) as u64,
            content_hash: *content.finalize().as_bytes(),
            provenance: *provenance,
        }
    }
}

fn failed(error: Failure) -> WriteError {
    WriteError::Serialize(error.to_string())
}

/// Exact length in bytes of the archive that [`encode_into`] will write.
pub fn encoded_length(rows: &Rows) -> Result<usize, WriteError> {
    Ok(Plan::of(rows).map_err(failed)?.length)
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
    let plan = Plan::of(rows).map_err(failed)?;
    if out.len() != plan.length {
        return Err(WriteError::Length { expected: plan.length, found: out.len() });
    }
    if !(out.as_ptr() as usize).is_multiple_of(ALIGNMENT) {
        return Err(WriteError::Alignment { expected: ALIGNMENT });
    }
    // Gaps between tables are written as zeros: with the right length, nothing is left of what was there.
    let mut writer = Buffer::from(&mut *out);
    Writer::<Failure>::write(&mut writer, &[0; HEADER_LENGTH]).map_err(failed)?;
    plan.write(rows, &mut writer).map_err(failed)?;
    let found = writer.len();
    if found != plan.length {
        return Err(WriteError::Length { expected: plan.length, found });
    }
    let (head, body) = out.split_at_mut(HEADER_LENGTH);
    let header = plan.header(rows, provenance, blake3::Hasher::new().update(body));
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
    let plan = Plan::of(rows).map_err(|error| io::Error::other(error.to_string()))?;
    out.seek(SeekFrom::Start(HEADER_LENGTH as u64))?;
    let (hasher, position) = (blake3::Hasher::new(), HEADER_LENGTH);
    let mut stream = Streamed { out, position, hasher, failed: None };
    let done = plan.write(rows, &mut stream);
    if let Some(error) = stream.failed {
        return Err(error);
    }
    done.map_err(|error| io::Error::other(error.to_string()))?;
    let header = plan.header(rows, provenance, &stream.hasher);
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
