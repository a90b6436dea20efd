//! Bounds on what an input may cost before it is understood.

/// The largest maps known have 600 MB.
const DECODED_BYTES: u64 = 2 << 30;
/// Maps shrink 10 to 60 times; deflate itself ends at 1,032 times.
const GZIP_RATIO: u64 = 256;
/// Short inputs may shrink more: their cost is bounded anyway.
const GZIP_GRACE: u64 = 16 << 20;
/// Includes within includes; nobody was seen to need more than one.
const INCLUDE_DEPTH: usize = 8;
/// Files that one document is made of. File numbers have 16 bits.
const FILES: usize = 1024;

/// Bounds on sizes and includes; beyond them the input is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SourceLimits {
    /// Decoded bytes of a document with all its includes. Default 2 GiB.
    pub decoded_bytes: u64,
    /// Times that gzip may have shrunk the input. Default 256.
    pub gzip_ratio: u64,
    /// Decompressed bytes from which on `gzip_ratio` is applied. Default 16 MiB.
    pub gzip_grace: u64,
    /// Includes within includes. Default 8.
    pub include_depth: usize,
    /// Files of one document, the main one among them, each inclusion counted. Default 1,024, at most 65,536.
    pub files: usize,
}

impl Default for SourceLimits {
    fn default() -> Self {
        Self {
            decoded_bytes: DECODED_BYTES,
            gzip_ratio: GZIP_RATIO,
            gzip_grace: GZIP_GRACE,
            include_depth: INCLUDE_DEPTH,
            files: FILES,
        }
    }
}
