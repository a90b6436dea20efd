//! Hashing what is read while it is read.

use super::in_order::{InOrder, lock};
use std::fs::File;
use std::io::{self, Read};
use std::path::PathBuf;
use std::sync::{Arc, Mutex};

/// Bytes that one task of the pool hashes.
const CHUNK: usize = 256 << 10;
/// Chunks that wait at most; where there are as many, the thread that reads hashes them.
const WAITING: usize = 32;

/// Passes bytes on and hashes them: on the pool's threads, where it has several, for the one that reads is waited for by all others.
pub(crate) struct HashingReader<R> {
    inner: R,
    hashing: Arc<Hashing>,
    spare: Spare,
    /// What was read and is not handed over yet.
    chunk: Vec<u8>,
    is_parallel: bool,
}

/// What is being hashed.
pub(super) type Hashing = InOrder<Hashed, Vec<u8>>;

/// Of the input so far.
#[derive(Default)]
pub(super) struct Hashed {
    hasher: blake3::Hasher,
    spare: Spare,
}

/// Room of chunks that are hashed.
type Spare = Arc<Mutex<Vec<Vec<u8>>>>;

fn hash(hashed: &mut Hashed, mut chunk: Vec<u8>) {
    hashed.hasher.update(&chunk);
    chunk.clear();
    lock(&hashed.spare).push(chunk);
}

impl<R: Read> HashingReader<R> {
    pub(crate) fn new(inner: R) -> Self {
        let is_parallel = rayon::current_num_threads() > 1;
        let spare = Spare::default();
        let hashed = Hashed { spare: Arc::clone(&spare), ..Hashed::default() };
        let hashing = Arc::new(InOrder::new(hashed, hash));
        Self { inner, hashing, spare, chunk: Vec::new(), is_parallel }
    }

    /// What waits to be hashed, for threads that have time.
    pub(crate) fn hashing(&self) -> Arc<Hashing> {
        Arc::clone(&self.hashing)
    }

    /// BLAKE3 of the whole input and of what it includes: what the parser left unread is read now, so that the hash names
    /// the files. None where one of them goes on for more than `most` bytes: it may have no end.
    pub(crate) fn finish(
        mut self,
        included: impl Iterator<Item = PathBuf>,
        most: u64,
    ) -> io::Result<Option<[u8; 32]>> {
        if !is_read(&mut self, most)? {
            return Ok(None);
        }
        for path in included {
            // The next file goes on where this one has ended.
            let mut file = HashingReader {
                inner: File::open(path)?,
                hashing: Arc::clone(&self.hashing),
                spare: Arc::clone(&self.spare),
                chunk: std::mem::take(&mut self.chunk),
                is_parallel: self.is_parallel,
            };
            if !is_read(&mut file, most)? {
                return Ok(None);
            }
            self.chunk = file.chunk;
        }
        let mut hashed = self.hashing.settled();
        hashed.hasher.update(&self.chunk);
        Ok(Some(*hashed.hasher.finalize().as_bytes()))
    }

    /// Hands the chunk over.
    fn hand_over(&mut self) {
        let room = lock(&self.spare).pop().unwrap_or_default();
        if self.hashing.push(std::mem::replace(&mut self.chunk, room)) >= WAITING {
            drop(self.hashing.settled());
            return;
        }
        let hashing = Arc::clone(&self.hashing);
        rayon::spawn_fifo(move || hashing.help());
    }
}

/// Reads on to the end. False where that does not come within so many bytes.
fn is_read(reader: &mut impl Read, most: u64) -> io::Result<bool> {
    io::copy(&mut reader.by_ref().take(most), &mut io::sink())?;
    Ok(reader.read(&mut [0])? == 0)
}

impl<R: Read> Read for HashingReader<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.inner.read(buffer)?;
        let bytes = buffer.get(..count).unwrap_or_default();
        if self.is_parallel {
            self.chunk.extend_from_slice(bytes);
            if self.chunk.len() >= CHUNK {
                self.hand_over();
            }
        } else {
            self.hashing.settled().hasher.update(bytes);
        }
        Ok(count)
    }
}
