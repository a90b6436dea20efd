//! Gzip, recognised by its first bytes, with a bound on how far it may expand.

use super::limits::SourceLimits;
use super::note::RefusalKind;
use flate2::read::MultiGzDecoder;
use std::io::{self, Cursor, ErrorKind, Read};

/// First bytes of a gzip member. (RFC 1952, 2.3.1)
pub(super) const MAGIC: [u8; 2] = [0x1f, 0x8b];

/// An input whose first bytes have been looked at.
type Raw<'a> = io::Chain<Cursor<Vec<u8>>, Box<dyn Read + Send + 'a>>;

/// Counts what is read.
pub(super) struct Counted<'a> {
    inner: Raw<'a>,
    count: u64,
}

impl Read for Counted<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.inner.read(buffer)?;
        self.count += count as u64;
        Ok(count)
    }
}

/// The bytes of an input, decompressed where they were compressed.
pub(super) enum Input<'a> {
    Plain(Raw<'a>),
    Gzip { decoder: Box<MultiGzDecoder<Counted<'a>>>, decoded: u64 },
}

impl<'a> Input<'a> {
    /// Looks at the first bytes. Errors: reading failed.
    pub(super) fn open(mut inner: Box<dyn Read + Send + 'a>) -> io::Result<Self> {
        let mut head = vec![0; MAGIC.len()];
        let count = read_full(&mut inner, &mut head)?;
        head.truncate(count);
        let is_gzip = head == MAGIC;
        let raw = Cursor::new(head).chain(inner);
        if !is_gzip {
            return Ok(Self::Plain(raw));
        }
        let decoder = Box::new(MultiGzDecoder::new(Counted { inner: raw, count: 0 }));
        Ok(Self::Gzip { decoder, decoded: 0 })
    }

    /// Whether the bytes come out of gzip.
    pub(super) fn is_gzip(&self) -> bool {
        matches!(self, Self::Gzip { .. })
    }

    /// Bytes taken from the input itself.
    pub(super) fn raw_bytes(&self) -> Option<u64> {
        match self {
            Self::Plain(_) => None,
            Self::Gzip { decoder, .. } => Some(decoder.get_ref().count),
        }
    }

    /// Reads some bytes; none at the end. The inner error is about the compressed data, the outer about the environment.
    pub(super) fn read(
        &mut self,
        buffer: &mut [u8],
        limits: &SourceLimits,
    ) -> io::Result<Result<usize, RefusalKind>> {
        loop {
            let result = match self {
                Self::Plain(inner) => inner.read(buffer),
                Self::Gzip { decoder, .. } => decoder.read(buffer),
            };
            let count = match result {
                Ok(count) => count,
                Err(error) if error.kind() == ErrorKind::Interrupted => continue,
                // flate2's kinds for damaged and for truncated data.
                Err(error)
                    if self.is_gzip()
                        && matches!(
                            error.kind(),
                            ErrorKind::InvalidInput
                                | ErrorKind::InvalidData
                                | ErrorKind::UnexpectedEof
                        ) =>
                {
                    return Ok(Err(RefusalKind::Gzip(error.to_string())));
                }
                Err(error) => return Err(error),
            };
            if let Self::Gzip { decoder, decoded } = self {
                *decoded += count as u64;
                let allowed = decoder.get_ref().count.saturating_mul(limits.gzip_ratio);
                if *decoded > limits.gzip_grace && *decoded > allowed {
                    return Ok(Err(RefusalKind::GzipRatio(limits.gzip_ratio)));
                }
            }
            return Ok(Ok(count));
        }
    }
}

/// Reads until the buffer is full or the input ends.
fn read_full(inner: &mut dyn Read, buffer: &mut [u8]) -> io::Result<usize> {
    let mut filled = 0;
    while filled < buffer.len() {
        match inner.read(&mut buffer[filled..]) {
            Ok(0) => break,
            Ok(count) => filled += count,
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(filled)
}
