//! Pages for what iceoryx2 creates.
//!
//! iceoryx2 sizes a segment with `ftruncate`, which reserves no pages on a file system in memory: if `/dev/shm` is filled up
//! before the segment is written for the first time, the writer dies by SIGBUS. Within [`reserving`] the pages are reserved
//! at once, so that iceoryx2 sees an error instead, hands it on, and removes what it had begun. That needs a program whose
//! `ftruncate` is the one of this module: [`program`](crate::program) says so; the library replaces nothing by itself.
#![allow(unsafe_code)]

use rustix::fs::FallocateFlags;
use rustix::io::Errno;
use std::cell::Cell;
use std::ffi::c_int;
use std::os::fd::BorrowedFd;

thread_local! {
    static RESERVING: Cell<bool> = const { Cell::new(false) };
}

/// Does something; all files that iceoryx2 sizes meanwhile, in this thread, get their pages at once.
pub(crate) fn reserving<T>(work: impl FnOnce() -> T) -> T {
    /// Ends it even if the work panics.
    struct Before(bool);
    impl Drop for Before {
        fn drop(&mut self) {
            RESERVING.set(self.0);
        }
    }
    let _before = Before(RESERVING.replace(true));
    work()
}

/// What `ftruncate` does in a program that serves maps: the same as the C library's, and within `reserving` it reserves the
/// pages. Rust's own `File::set_len` calls another function.
///
/// # Safety
///
/// The same as of the C library's: `fd` is not closed meanwhile.
pub unsafe fn ftruncate(fd: c_int, length: i64) -> c_int {
    let sized = (|| {
        let length = u64::try_from(length).map_err(|_| Errno::INVAL)?;
        if fd < 0 {
            return Err(Errno::BADF);
        }
        // SAFETY: the caller's duty.
        let file = unsafe { BorrowedFd::borrow_raw(fd) };
        rustix::fs::ftruncate(file, length)?;
        if RESERVING.get() && length > 0 {
            rustix::fs::fallocate(file, FallocateFlags::empty(), 0, length)?;
        }
        Ok(())
    })();
    match sized {
        Ok(()) => 0,
        Err(error) => {
            errno::set_errno(errno::Errno(error.raw_os_error()));
            -1
        }
    }
}
