//! What a program has that runs [`cli::run`](crate::cli::run).
#![allow(unsafe_code)]

/// Makes a program one that compiles and serves maps: its allocator ends it in plain words where there is no memory. Two of its functions take the place of the C
/// library's for callers in Rust and C: `ftruncate` reserves pages for what iceoryx2 creates, and `shm_open` keeps it from what other users have made.
/// To be written once, beside `main`; a library that did this would do it to every program that links it.
#[macro_export]
macro_rules! program {
    () => {
        #[global_allocator]
        static ALLOCATOR: $crate::Allocator = $crate::Allocator;

        // SAFETY: the symbol has the C library's signature and contract (POSIX.1-2017, ftruncate).
        #[allow(unsafe_code)]
        #[unsafe(no_mangle)]
        unsafe extern "C" fn ftruncate(fd: ::std::ffi::c_int, length: i64) -> ::std::ffi::c_int {
            // SAFETY: the caller's duty.
            unsafe { $crate::serve::ftruncate(fd, length) }
        }

        // SAFETY: the symbol has the C library's signature and contract (POSIX.1-2017, shm_open).
        #[allow(unsafe_code)]
        #[unsafe(no_mangle)]
        unsafe extern "C" fn shm_open(
            name: *const ::std::ffi::c_char,
            flags: ::std::ffi::c_int,
            mode: u32,
        ) -> ::std::ffi::c_int {
            // SAFETY: the caller's duty.
            unsafe { $crate::serve::shm_open(name, flags, mode) }
        }
    };
}
