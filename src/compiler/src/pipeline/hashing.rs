//! Hashing what is read while it is read.

use std::fs::File;
use std::io::{self, Read};
use std::path::PathBuf;

/// Passes bytes on and hashes them.
pub(crate) struct HashingReader<R> {
    inner: R,
    hasher: blake3::Hasher,
}

impl<R: Read> HashingReader<R> {
    pub(crate) fn new(inner: R) -> Self {
        Self { inner, hasher: blake3::Hasher::new() }
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
            let mut file = HashingReader { inner: File::open(path)?, hasher: self.hasher };
            if !is_read(&mut file, most)? {
                return Ok(None);
            }
            self.hasher = file.hasher;
        }
        Ok(Some(*self.hasher.finalize().as_bytes()))
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
        if let Some(bytes) = buffer.get(..count) {
            self.hasher.update(bytes);
        }
        Ok(count)
    }
}
