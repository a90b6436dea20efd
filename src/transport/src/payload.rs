//! What is sent.

#[cfg(feature = "iceoryx2")]
use iceoryx2::prelude::ZeroCopySend;

/// Unit of the payload: 64 bytes on a 64-byte boundary, so that the archive's tables are aligned in place.
///
/// (A byte slice with a raised alignment would not do: iceoryx2 0.10 multiplies the element size by it.)
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "iceoryx2", derive(ZeroCopySend), type_name("mapd_chunk64"))]
#[repr(C)]
#[repr(align(64))]
pub struct Chunk64(pub [u8; 64]);

/// Chunks that hold `length` bytes.
pub fn chunks_for(length: usize) -> usize {
    length.div_ceil(size_of::<Chunk64>())
}

/// What is said about a generation: the sample's user header.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "iceoryx2", derive(ZeroCopySend), type_name("mapd_generation_info"))]
#[repr(C)]
pub struct GenerationInfo {
    /// Rises with every publication of a map, across restarts of the daemon. At least 1.
    pub generation: u64,
    /// Exact length of the payload \[bytes\].
    pub length: u64,
    /// When it was published \[ns since the Unix epoch\].
    pub published_unix_ns: u64,
    /// Process id of the daemon that published it, in the daemon's own process namespace.
    pub daemon_pid: u64,
    /// Identifies the tables that the publisher's release writes; opaque here.
    pub layout_id: [u8; 32],
    /// Hash of the archive's content; opaque here.
    pub content_hash: [u8; 32],
    /// Hash of what the archive was compiled from; opaque here.
    pub input_hash: [u8; 32],
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_part_of_the_revision() {
        assert_eq!((size_of::<Chunk64>(), align_of::<Chunk64>()), (64, 64));
        assert_eq!((size_of::<GenerationInfo>(), align_of::<GenerationInfo>()), (128, 8));
        assert_eq!([0, 1, 64, 65].map(chunks_for), [0, 1, 1, 2]);
    }
}
