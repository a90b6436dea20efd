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
    /// the files.
    pub(crate) fn finish(
        mut self,
        included: impl Iterator<Item = PathBuf>,
    ) -> io::Result<[u8; 32]> {
        io::copy(&mut self.by_ref(), &mut io::sink())?;
        for path in included {
            self.hasher.update_reader(File::open(path)?)?;
        }
        Ok(*self.hasher.finalize().as_bytes())
    }
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
