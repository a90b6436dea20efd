//! Memory that is given back to the system.
//!
//! The C library raises its own limits when large blocks are freed: from then on tables of tens of megabytes come from the
//! heap, whose middle is never given back. On a map of 104 MB that holds 242 to 278 MB at the peak, without it 175.
#![allow(unsafe_code)]

/// Blocks from this size on are mapped one by one, and go back when freed `[bytes]`: the C library's own limit at its start.
const MAPPED_FROM: i32 = 128 << 10;
/// Free bytes at the end of a thread's heap from which on it shrinks: more than a road takes while it is read, so that its pages
/// are those of the next one.
const TRIMMED_FROM: i32 = 4 << 20;

/// Keeps the limits where they are. To be called before anything large is allocated; elsewhere than on Linux with glibc it
/// does nothing.
pub(crate) fn give_back() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    // SAFETY: both calls set a number inside the allocator, under its own lock; the parameters exist in every glibc.
    unsafe {
        libc::mallopt(libc::M_MMAP_THRESHOLD, MAPPED_FROM);
        libc::mallopt(libc::M_TRIM_THRESHOLD, TRIMMED_FROM);
    }
}
