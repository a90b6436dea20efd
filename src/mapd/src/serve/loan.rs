//! Filling a loan: from unwritten shared memory to a slice that safe code may write.
#![allow(unsafe_code)]

use super::error::ServeError;
use iceoryx2::sample_mut::SampleMut;
use iceoryx2::sample_mut_uninit::SampleMutUninit;
use mapd_transport::{Chunk64, GenerationInfo, SHARED_MEMORY_FOLDER, TransportService};
use memmap2::MmapOptions;
use std::error::Error;
use std::fs::File;
use std::hash::{BuildHasher, Hasher, RandomState};
use std::mem::MaybeUninit;

/// What the writer of a generation says about it. Opaque here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PublishMeta {
    /// Identifies the tables that the publisher's release writes. No reader is refused because of it.
    pub layout_id: [u8; 32],
    /// Hash of the archive's content.
    pub content_hash: [u8; 32],
    /// Hash of what the archive was compiled from.
    pub input_hash: [u8; 32],
}

/// A sample that may be written.
pub(crate) type Loan = SampleMutUninit<TransportService, [MaybeUninit<Chunk64>], GenerationInfo>;

/// A sample that may be sent.
pub(crate) type Filled = SampleMut<TransportService, [Chunk64], GenerationInfo>;

/// Bytes that are written to find out where a loan lies in its segment.
pub(crate) type Mark = [u8; size_of::<Chunk64>()];

/// Words that nobody can foresee: hashers of the standard library are seeded at random, each has another seed.
pub(crate) fn random_words<const N: usize>() -> [u64; N] {
    std::array::from_fn(|_| RandomState::new().build_hasher().finish())
}

/// Writes a mark, unlike anything that the segment holds, at the loan's beginning, and has `find` look for it through the file: iceoryx2 does not
/// tell where in a segment a sample lies. [`fill_loan`] overwrites it.
///
/// Errors: those of `find`.
pub(crate) fn locate_loan<T>(loan: &mut Loan, find: impl FnOnce(&Mark) -> T) -> Option<T> {
    let words: [u64; size_of::<Mark>() / size_of::<u64>()] = random_words();
    let mut mark = [0; size_of::<Mark>()];
    for (bytes, word) in mark.chunks_exact_mut(size_of::<u64>()).zip(words) {
        bytes.copy_from_slice(&word.to_ne_bytes());
    }
    let first = loan.payload_mut().first_mut()?.as_mut_ptr().cast::<Mark>();
    // SAFETY: the first chunk is as long as a mark, mapped, writable and borrowed mutably. Volatile, so that the kernel finds it when it is asked
    // for the file's bytes: to the compiler, they are never read.
    unsafe { first.write_volatile(mark) };
    Some(find(&mark))
}

/// Has `fill` write the loan's first `length` bytes, and writes the header that `header` makes. Bytes that `fill` leaves
/// alone, and those after `length`, are zero. The segment's pages have been reserved before.
///
/// Errors: `fill` fails; `header` fails.
pub(crate) fn fill_loan(
    map: &str,
    mut loan: Loan,
    length: usize,
    fill: impl FnOnce(&mut [u8]) -> Result<PublishMeta, Box<dyn Error + Send + Sync>>,
    header: impl FnOnce(PublishMeta) -> Result<GenerationInfo, ServeError>,
) -> Result<Filled, ServeError> {
    let chunks: &mut [MaybeUninit<Chunk64>] = loan.payload_mut();
    let size = size_of_val(chunks);
    let start = chunks.as_mut_ptr().cast::<u8>();
    // SAFETY: `start` and `size` are those of `chunks`, mapped, writable and borrowed mutably up to the end of `bytes`;
    // every byte is written before the slice exists. `u8` has no alignment, `Chunk64` no padding. Nobody reads the
    // segment before the sample is sent.
    let bytes = unsafe {
        start.write_bytes(0, size);
        std::slice::from_raw_parts_mut(start, size)
    };
    let Some(wanted) = bytes.get_mut(..length) else {
        return Err(ServeError::iceoryx("loaning")(format!("{size} bytes instead of {length}")));
    };
    let meta = fill(wanted).map_err(|source| ServeError::Fill { map: map.to_owned(), source })?;
    *loan.user_header_mut() = header(meta)?;
    // SAFETY: all of the payload was written above, and any bytes are a valid `Chunk64`.
    Ok(unsafe { loan.assume_init() })
}

/// Has `fill` write a new file of `length` bytes, all of them zero and all pages there; what `header` makes of it. Nobody knows the file's name yet.
///
/// Errors: the file cannot be mapped; `fill` fails; `header` fails.
pub(crate) fn fill_file(
    map: &str,
    file: &File,
    length: usize,
    fill: impl FnOnce(&mut [u8]) -> Result<PublishMeta, Box<dyn Error + Send + Sync>>,
    header: impl FnOnce(PublishMeta) -> Result<GenerationInfo, ServeError>,
) -> Result<GenerationInfo, ServeError> {
    // SAFETY: the file was made by this process, under a name that was not there, for its user alone, and is not in any record yet: nobody else opens it, and it keeps
    // its length. The mapping ends with this function.
    let mut mapping = unsafe { MmapOptions::new().len(length).map_mut(file) }
        .map_err(ServeError::io(SHARED_MEMORY_FOLDER))?;
    let meta =
        fill(&mut mapping).map_err(|source| ServeError::Fill { map: map.to_owned(), source })?;
    header(meta)
}
