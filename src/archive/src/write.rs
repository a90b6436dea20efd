//! Writing: the exact size first, then straight into the destination.

use crate::directory::{ENTRY_LENGTH, TableEntry, TableKind, feature_bit};
use crate::error::WriteError;
use crate::generated::known_tables::TABLES;
use crate::generated::overlay_tables::OVERLAY_TABLES;
use crate::header::{HEADER_LENGTH, Header, Provenance};
use crate::open::ALIGNMENT;
use crate::overlay::OVERLAY_BIT;
use crate::{OverlayRows, Rows};
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

/// The tables that an archive gets, those that every archive has and those that have rows, and what a reader must understand.
struct Content<'a> {
    tables: Vec<(&'static TableKind, &'a [u8])>,
    must_understand: u64,
}

impl<'a> Content<'a> {
    fn new(
        kinds: &'static [TableKind],
        bytes: impl IntoIterator<Item = &'a [u8]>,
        must_understand: u64,
    ) -> Self {
        let tables = kinds.iter().zip(bytes);
        let tables = tables.filter(|(kind, bytes)| kind.required || !bytes.is_empty()).collect();
        Self { tables, must_understand }
    }

    fn of_map(rows: &'a Rows) -> Self {
        let bits = rows.features.iter().map(|feature| feature_bit(feature.bit));
        Self::new(&TABLES, rows.bytes(), bits.fold(0, |all, bit| all | bit))
    }
}

impl Plan {
    fn of(content: &Content<'_>) -> Result<Self, Failure> {
        let mut counter = Counter(HEADER_LENGTH + content.tables.len() * ENTRY_LENGTH);
        let mut directory = Vec::with_capacity(content.tables.len());
        for (kind, bytes) in &content.tables {
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
    fn write(&self, content: &Content<'_>, out: &mut impl Writer<Failure>) -> Result<(), Failure> {
        out.write(bytemuck::cast_slice(&self.directory))?;
        for (_, bytes) in &content.tables {
            out.align(ALIGNMENT)?;
            out.write(bytes)?;
        }
        Ok(())
    }

    fn header(
        &self,
        content: &Content<'_>,
        provenance: &Provenance,
        hasher: &blake3::Hasher,
    ) -> Header {
        Header {
            must_understand: content.must_understand,
            tables: self.directory.len() as u32,
            body_length: (self.length - HEADER_LENGTH) as u64,
            content_hash: *hasher.finalize().as_bytes(),
            provenance: *provenance,
        }
    }
}

fn failed(error: Failure) -> WriteError {
    WriteError::Serialize(error.to_string())
}

/// Exact length in bytes of the archive that [`encode_into`] will write.
pub fn encoded_length(rows: &Rows) -> Result<usize, WriteError> {
    Ok(Plan::of(&Content::of_map(rows)).map_err(failed)?.length)
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
    let content = Content::of_map(rows);
    let plan = Plan::of(&content).map_err(failed)?;
    plan.fill(&content, provenance, out)
}

impl Plan {
    fn fill(
        &self,
        content: &Content<'_>,
        provenance: &Provenance,
        out: &mut [u8],
    ) -> Result<Header, WriteError> {
        if out.len() != self.length {
            return Err(WriteError::Length { expected: self.length, found: out.len() });
        }
        if !(out.as_ptr() as usize).is_multiple_of(ALIGNMENT) {
            return Err(WriteError::Alignment { expected: ALIGNMENT });
        }
        // Gaps between tables are written as zeros: with the right length, nothing is left of what was there.
        let mut writer = Buffer::from(&mut *out);
        Writer::<Failure>::write(&mut writer, &[0; HEADER_LENGTH]).map_err(failed)?;
        self.write(content, &mut writer).map_err(failed)?;
        let found = writer.len();
        if found != self.length {
            return Err(WriteError::Length { expected: self.length, found });
        }
        let (head, body) = out.split_at_mut(HEADER_LENGTH);
        let header = self.header(content, provenance, blake3::Hasher::new().update(body));
        head.copy_from_slice(&header.encode());
        Ok(header)
    }

    fn in_memory(
        &self,
        content: &Content<'_>,
        provenance: &Provenance,
    ) -> Result<AlignedBytes, WriteError> {
        let mut bytes = AlignedBytes::with_capacity(self.length);
        bytes.resize(self.length, 0);
        self.fill(content, provenance, &mut bytes)?;
        Ok(bytes)
    }
}

/// Bytes that are hashed and written at a time: they are in the processor's cache for both.
const CHUNK: usize = 256 << 10;

/// A writer that hashes what it passes on: `pass` does both with a chunk.
struct Streamed<'a, W, P> {
    out: &'a mut W,
    pass: P,
    position: usize,
    hasher: blake3::Hasher,
    /// Why writing failed; rkyv's error in release builds says nothing.
    failed: Option<io::Error>,
}

impl<W, P> Fallible for Streamed<'_, W, P> {
    type Error = Failure;
}

impl<W, P> Positional for Streamed<'_, W, P> {
    fn pos(&self) -> usize {
        self.position
    }
}

impl<W, P> Writer<Failure> for Streamed<'_, W, P>
where
    P: FnMut(&mut blake3::Hasher, &mut W, &[u8]) -> io::Result<()>,
{
    fn write(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        for chunk in bytes.chunks(CHUNK) {
            (self.pass)(&mut self.hasher, self.out, chunk).map_err(|error| {
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
    stream(rows, provenance, out, |hasher, out, chunk| {
        hasher.update(chunk);
        out.write_all(chunk)
    })
}

/// Two tasks that may be done at once; returns when both are done.
pub type Both<'a> = &'a dyn Fn(&mut (dyn FnMut() + Send), &mut (dyn FnMut() + Send));

/// As [`encode_to`]; `both` hashes each chunk while it is written, as `rayon::join` does.
///
/// Errors: as there.
pub fn encode_to_with(
    rows: &Rows,
    provenance: &Provenance,
    out: &mut (impl Write + Seek + Send),
    both: Both<'_>,
) -> io::Result<Header> {
    stream(rows, provenance, out, |hasher, out, chunk| {
        let mut written = Ok(());
        let mut hash = || {
            hasher.update(chunk);
        };
        let mut write = || written = out.write_all(chunk);
        // Not worth another thread.
        if chunk.len() < CHUNK {
            hash();
            write();
        } else {
            both(&mut hash, &mut write);
        }
        written
    })
}

fn stream<W: Write + Seek>(
    rows: &Rows,
    provenance: &Provenance,
    out: &mut W,
    pass: impl FnMut(&mut blake3::Hasher, &mut W, &[u8]) -> io::Result<()>,
) -> io::Result<Header> {
    let content = Content::of_map(rows);
    let plan = Plan::of(&content).map_err(|error| io::Error::other(error.to_string()))?;
    out.seek(SeekFrom::Start(HEADER_LENGTH as u64))?;
    let (hasher, position) = (blake3::Hasher::new(), HEADER_LENGTH);
    let mut stream = Streamed { out, pass, position, hasher, failed: None };
    let done = plan.write(&content, &mut stream);
    if let Some(error) = stream.failed {
        return Err(error);
    }
    done.map_err(|error| io::Error::other(error.to_string()))?;
    let header = plan.header(&content, provenance, &stream.hasher);
    stream.out.seek(SeekFrom::Start(0))?;
    stream.out.write_all(&header.encode())?;
    Ok(header)
}

/// An archive in memory.
pub fn encode(rows: &Rows, provenance: &Provenance) -> Result<AlignedBytes, WriteError> {
    let content = Content::of_map(rows);
    Plan::of(&content).map_err(failed)?.in_memory(&content, provenance)
}

/// An overlay in memory, for the map of this content hash.
pub fn encode_overlay(rows: &OverlayRows, map: [u8; 32]) -> Result<AlignedBytes, WriteError> {
    let content = Content::new(&OVERLAY_TABLES, rows.bytes(), OVERLAY_BIT);
    let provenance = Provenance { input_hash: map, ..Provenance::default() };
    Plan::of(&content).map_err(failed)?.in_memory(&content, &provenance)
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

    fn at_once(a: &mut (dyn FnMut() + Send), b: &mut (dyn FnMut() + Send)) {
        std::thread::scope(|scope| {
            scope.spawn(a);
            b();
        });
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
            let expected = Header::decode(&memory[..HEADER_LENGTH]).expect("a header");
            let mut stream = Cursor::new(Vec::new());
            let header = encode_to(&rows, &provenance, &mut stream).expect("encodes");
            assert!(stream.into_inner() == memory[..]);
            assert_eq!(header, expected);
            let mut stream = Cursor::new(Vec::new());
            let header = encode_to_with(&rows, &provenance, &mut stream, &at_once);
            assert!(stream.into_inner() == memory[..]);
            assert_eq!(header.expect("encodes"), expected);
        }
    }

    #[test]
    fn a_stream_that_ends_says_why() {
        let length = encoded_length(&rows()).expect("a length");
        for room in [0, HEADER_LENGTH, length / 2, length - 1] {
            let mut stream = Short(Cursor::new(Vec::new()), room);
            let error = encode_to(&rows(), &Provenance::default(), &mut stream).err();
            assert_eq!(error.map(|e| e.kind()), Some(io::ErrorKind::StorageFull), "{room}");
            let mut stream = Short(Cursor::new(Vec::new()), room);
            let error =
                encode_to_with(&rows(), &Provenance::default(), &mut stream, &at_once).err();
            assert_eq!(error.map(|e| e.kind()), Some(io::ErrorKind::StorageFull), "{room}");
        }
        let mut stream = Short(Cursor::new(Vec::new()), length);
        assert!(encode_to(&rows(), &Provenance::default(), &mut stream).is_ok());
    }
}
