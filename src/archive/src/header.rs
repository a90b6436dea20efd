//! The 128 bytes in front of every archive.

use crate::FORMAT;
use crate::error::OpenError;

/// Length of the header in bytes.
pub const HEADER_LENGTH: usize = 128;

/// First bytes of an archive. A byte above 127, CR LF and 0x1A show transfers that mangle text.
pub const MAGIC: [u8; 8] = *b"\x89MAPD\r\n\x1a";

/// Written as a little-endian number; reads as another number where byte order was swapped.
const ENDIANNESS_MARK: u32 = 0x0102_0304;

/// Where an archive comes from: what the cache and a user need to tell two apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Provenance {
    /// BLAKE3 over the decoded bytes of every file read, in the order of reading.
    pub input_hash: [u8; 32],
    /// First 8 bytes of the BLAKE3 of the compile options that shape the output.
    pub options_hash: [u8; 8],
    /// Major, minor and patch of the compiler's version.
    pub compiler_version: [u16; 3],
}

/// The decoded header.
///
/// ```text
///   0 magic 8 │ 8 endianness mark 4 │ 12 format 4 │ 16 must understand 8 │ 24 tables 4 │ 28 zero 4 │ 32 body length 8
///  40 content hash 32
///  72 input hash 32 │ 104 options hash 8 │ 112 compiler version 3×2 │ 118 zero 2 │ 120 header checksum 8
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Header {
    /// One bit for each feature that a reader has to know of: see the table `features`.
    pub must_understand: u64,
    /// Entries of the directory.
    pub tables: u32,
    /// Bytes of the body that follows: the directory and the tables.
    pub body_length: u64,
    /// BLAKE3 of the body.
    pub content_hash: [u8; 32],
    /// Where the archive comes from.
    pub provenance: Provenance,
}

impl Header {
    /// The header's bytes.
    pub fn encode(&self) -> [u8; HEADER_LENGTH] {
        let mut out = [0; HEADER_LENGTH];
        let version = self.provenance.compiler_version;
        let fields: [(usize, &[u8]); 12] = [
            (0, &MAGIC),
            (8, &ENDIANNESS_MARK.to_le_bytes()),
            (12, &FORMAT.to_le_bytes()),
            (16, &self.must_understand.to_le_bytes()),
            (24, &self.tables.to_le_bytes()),
            (32, &self.body_length.to_le_bytes()),
            (40, &self.content_hash),
            (72, &self.provenance.input_hash),
            (104, &self.provenance.options_hash),
            (112, &version[0].to_le_bytes()),
            (114, &version[1].to_le_bytes()),
            (116, &version[2].to_le_bytes()),
        ];
        for (at, bytes) in fields {
            out[at..at + bytes.len()].copy_from_slice(bytes);
        }
        let sum = checksum(&out);
        out[120..].copy_from_slice(&sum);
        out
    }

    /// Reads and checks a header: everything in it, but not the body, nor whether this release knows what it must.
    ///
    /// Errors: each names what was expected, what was found and the way out.
    pub fn decode(bytes: &[u8]) -> Result<Self, OpenError> {
        let Some(head) = bytes.first_chunk::<HEADER_LENGTH>() else {
            return Err(OpenError::TooShort { found: bytes.len() as u64 });
        };
        if head[..8] != MAGIC {
            return Err(OpenError::NotAnArchive { found: array(head, 0) });
        }
        let mark = u32::from_le_bytes(array(head, 8));
        if mark == ENDIANNESS_MARK.swap_bytes() {
            return Err(OpenError::Endianness);
        }
        if head[120..] != checksum(head) {
            return Err(OpenError::HeaderChecksum);
        }
        if mark != ENDIANNESS_MARK {
            return Err(OpenError::Endianness);
        }
        let format = u32::from_le_bytes(array(head, 12));
        if format != FORMAT {
            return Err(OpenError::Format { expected: FORMAT, found: format });
        }
        let number = |at| u16::from_le_bytes(array(head, at));
        Ok(Self {
            must_understand: u64::from_le_bytes(array(head, 16)),
            tables: u32::from_le_bytes(array(head, 24)),
            body_length: u64::from_le_bytes(array(head, 32)),
            content_hash: array(head, 40),
            provenance: Provenance {
                input_hash: array(head, 72),
                options_hash: array(head, 104),
                compiler_version: [number(112), number(114), number(116)],
            },
        })
    }
}

fn array<const N: usize>(head: &[u8; HEADER_LENGTH], at: usize) -> [u8; N] {
    let mut out = [0; N];
    out.copy_from_slice(&head[at..at + N]);
    out
}

fn checksum(head: &[u8; HEADER_LENGTH]) -> [u8; 8] {
    let mut out = [0; 8];
    out.copy_from_slice(&blake3::hash(&head[..120]).as_bytes()[..8]);
    out
}
