//! Hashing what is read while it is read.

use std::collections::VecDeque;
use std::fs::File;
use std::io::{self, Read};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Bytes that one task of the pool hashes.
const CHUNK: usize = 256 << 10;
/// Chunks that wait at most; where there are as many, the thread that reads hashes them.
const WAITING: usize = 32;

/// Passes bytes on and hashes them: on the pool's threads, where it has several, for the one that reads is waited for by all others.
pub(crate) struct HashingReader<R> {
    inner: R,
    hashing: Arc<Hashing>,
    /// What was read and is not handed over yet.
    chunk: Vec<u8>,
    is_parallel: bool,
}

/// What is being hashed.
#[derive(Default)]
pub(crate) struct Hashing {
    /// Held by whoever takes chunks from those that wait, so that they are hashed in order.
    hasher: Mutex<blake3::Hasher>,
    waiting: Mutex<Chunks>,
}

#[derive(Default)]
struct Chunks {
    full: VecDeque<Vec<u8>>,
    /// Room of those that are hashed.
    spare: Vec<Vec<u8>>,
}

/// What a panic leaves behind is whole, chunks are moved and not changed; or nobody relies on it, for what follows is not read.
pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Hashing {
    /// Hashes all that waits, unless another thread does.
    pub(crate) fn help(&self) {
        if let Ok(hasher) = self.hasher.try_lock() {
            self.work(hasher);
        }
    }

    /// Hashes all that waits.
    fn work(&self, mut hasher: MutexGuard<'_, blake3::Hasher>) {
        loop {
            let next = lock(&self.waiting).full.pop_front();
            let Some(mut chunk) = next else { return };
            hasher.update(&chunk);
            chunk.clear();
            lock(&self.waiting).spare.push(chunk);
        }
    }
}

impl<R: Read> HashingReader<R> {
    pub(crate) fn new(inner: R) -> Self {
        let is_parallel = rayon::current_num_threads() > 1;
        Self { inner, hashing: Arc::default(), chunk: Vec::new(), is_parallel }
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
                chunk: std::mem::take(&mut self.chunk),
                is_parallel: self.is_parallel,
            };
            if !is_read(&mut file, most)? {
                return Ok(None);
            }
            self.chunk = file.chunk;
        }
        self.hashing.work(lock(&self.hashing.hasher));
        let mut hasher = lock(&self.hashing.hasher);
        hasher.update(&self.chunk);
        Ok(Some(*hasher.finalize().as_bytes()))
    }

    /// Hands the chunk over.
    fn hand_over(&mut self) {
        let waiting = {
            let mut chunks = lock(&self.hashing.waiting);
            let room = chunks.spare.pop().unwrap_or_default();
            chunks.full.push_back(std::mem::replace(&mut self.chunk, room));
            chunks.full.len()
        };
        if waiting >= WAITING {
            self.hashing.work(lock(&self.hashing.hasher));
            return;
        }
        let hashing = Arc::clone(&self.hashing);
        // Who holds it takes this chunk, too, or the next one does, or the end.
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
            lock(&self.hashing.hasher).update(bytes);
        }
        Ok(count)
    }
}
