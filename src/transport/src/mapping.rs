//! Files that are mapped.
#![allow(unsafe_code)]

use rustix::fd::AsFd;
use rustix::mm::{Advice, MapFlags, ProtFlags};
use std::ffi::c_void;
use std::io;
use std::ptr::NonNull;

/// A shared mapping of the first bytes of a file, unmapped when it is dropped.
#[derive(Debug)]
pub struct Mapping {
    start: NonNull<u8>,
    length: usize,
}

// SAFETY: a mapping belongs to the process, not to a thread; `Mapping` hands out its address and shared slices of it, and no way to change it.
unsafe impl Send for Mapping {}
// SAFETY: as above.
unsafe impl Sync for Mapping {}

impl Mapping {
    /// Maps the first `length` bytes of a file read-only.
    ///
    /// Errors: what the system says.
    ///
    /// # Safety
    ///
    /// Readers of [`Mapping::bytes`] rely on a file that does not change and does not become shorter as long as the mapping exists.
    pub unsafe fn read_only(file: impl AsFd, length: usize) -> io::Result<Self> {
        Self::new(file, length, ProtFlags::READ)
    }

    /// Maps the first `length` bytes of a file, to be looked at through [`Mapping::address`] alone.
    ///
    /// Errors: what the system says.
    pub(crate) fn new(file: impl AsFd, length: usize, access: ProtFlags) -> io::Result<Self> {
        // The kernel maps no empty range; of an empty file nobody may look at the one byte that this asks for.
        let mapped = length.max(1);
        // SAFETY: without an address of ours the kernel chooses one where nothing is mapped.
        let start = unsafe {
            rustix::mm::mmap(std::ptr::null_mut(), mapped, access, MapFlags::SHARED, file, 0)?
        };
        let start = NonNull::new(start.cast()).ok_or(io::ErrorKind::AddrNotAvailable)?;
        Ok(Self { start, length })
    }

    /// Where it begins: on a page.
    pub(crate) fn address(&self) -> NonNull<u8> {
        self.start
    }

    /// The bytes.
    pub fn bytes(&self) -> &[u8] {
        // SAFETY: `length` bytes from `start` on are mapped as long as `self` lives, and every bit pattern is a byte. That they do not change is promised by
        // the caller that made the mapping with `read_only`; inside this crate nobody asks for the bytes of another one.
        unsafe { std::slice::from_raw_parts(self.start.as_ptr(), self.length) }
    }

    fn raw(&self) -> *mut c_void {
        self.start.as_ptr().cast()
    }
}

/// Has core dumps leave out the pages of these bytes: an unlinked map would be among them. A system that cannot is no reason to have no map.
pub(crate) fn leave_out_of_core_dumps(bytes: &[u8]) {
    let before = bytes.as_ptr().addr() % rustix::param::page_size();
    let start = bytes.as_ptr().wrapping_sub(before).cast_mut().cast();
    // SAFETY: the pages hold these bytes, so they are mapped; the advice changes nothing that anybody sees in them.
    let _ = unsafe { rustix::mm::madvise(start, bytes.len() + before, Advice::LinuxDontDump) };
}

impl Drop for Mapping {
    fn drop(&mut self) {
        // SAFETY: the range was mapped by `new`, and is borrowed by nobody any more. It fails for no range that is mapped.
        let _ = unsafe { rustix::mm::munmap(self.raw(), self.length.max(1)) };
    }
}
