//! Filling a loaned sample.
#![allow(unsafe_code)]

use mapd_client::transport::protocol::Chunk64;
use rustix::mm::{Advice, madvise};
use std::io;
use std::mem::MaybeUninit;

/// The loan as bytes, all zero, with its pages reserved: where memory is short this is an error instead of a signal.
///
/// Errors: the system cannot give the pages.
pub(super) fn bytes(payload: &mut [MaybeUninit<Chunk64>]) -> io::Result<&mut [u8]> {
    let length = size_of_val(payload);
    let start = payload.as_mut_ptr().cast::<u8>();
    let page = rustix::param::page_size();
    let before = start as usize % page;
    // SAFETY: the range covers the pages of the loan, which are mapped writable; populating them changes no content.
    let reserved =
        unsafe { madvise(start.sub(before).cast(), length + before, Advice::LinuxPopulateWrite) };
    match reserved {
        Ok(()) => {}
        // Kernels before 5.14 do not know the advice; the check of free space has to do there.
        Err(rustix::io::Errno::INVAL) => {}
        Err(error) => return Err(error.into()),
    }
    // SAFETY: the payload is exclusively borrowed, `length` bytes long and mapped; zero is a valid byte, and after
    // writing it every byte is initialised.
    unsafe {
        std::ptr::write_bytes(start, 0, length);
        Ok(std::slice::from_raw_parts_mut(start, length))
    }
}

/// A sample that may be sent.
pub(super) type Filled = iceoryx2::sample_mut::SampleMut<
    mapd_client::transport::protocol::Ipc,
    [Chunk64],
    mapd_client::transport::GenerationInfo,
>;

/// A sample that is to be filled.
pub(super) type Empty = iceoryx2::sample_mut_uninit::SampleMutUninit<
    mapd_client::transport::protocol::Ipc,
    [MaybeUninit<Chunk64>],
    mapd_client::transport::GenerationInfo,
>;

/// Declares a loan filled.
pub(super) fn filled(sample: Empty) -> Filled {
    // SAFETY: callers obtain the payload through `bytes`, which writes every byte of it.
    unsafe { sample.assume_init() }
}
